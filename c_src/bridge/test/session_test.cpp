// Loading, resets, libraries that need libraries, signatures: session_test DIRECTORY with the
// libraries of CMakeLists.txt
#include "check.h"
#include "talk.hpp"

#include <cstring>
#include <string>

using cb::Talk;

namespace {

std::string directory;

std::string library(const char *name) {
    return directory + "/" + name;
}

bool contains(const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
}

std::string load(Talk &talk, const std::string &file, const std::string &options = "#{}") {
    return talk("{load,<<\"" + file + "\">>," + options + "}");
}

void what_cannot_be_loaded_is_named() {
    Talk talk;
    IS(talk, "{call,add,[1,2]}", "error: not_loaded");
    const std::string missing = library("missing.so");
    CHECK(load(talk, missing) ==
          "error: {load,<<\"" + missing + "\">>,{dlerror,<<\"No such file or directory\">>}}");
    const std::string bare = library("stripped.so");
    CHECK(load(talk, bare) == "error: {load,<<\"" + bare + "\">>,no_debug_info}");
    CHECK(contains(load(talk, library("torture.txt")), "error: {load,"));
    CHECK(contains(load(talk, library("torture_gcc_O0.so"), "#{nonsense=>1}"),
                   "error: {bad_request,"));
    CHECK(contains(load(talk, library("torture_gcc_O0.so")), "#{file=>"));
    CHECK(load(talk, library("torture_gcc_O0.so")) == "error: already_loaded");
}

void libraries_it_needs_are_under_test_too() {
    Talk talk(library("dependent.so"));
    IS(talk, "{call,add_twice,[5]}", "12");
    IS(talk, "{call,add,[5,5]}", "10");
    IS(talk, "{get,[corners,0,x]}", "1");
    Talk alone(library("dependent.so"), "#{no_index=>[<<\"libneeded.so\">>]}");
    CHECK(contains(alone("{call,add,[5,5]}"), "error: {unknown_function,add,"));
}

void a_snapshot_covers_all_libraries() {
    Talk talk(library("dependent.so"));
    IS(talk, "restore", "error: no_snapshot");
    IS(talk, "{set,[plain],50}", "ok");
    IS(talk, "snapshot", "ok");
    talk.keep("P", "{alloc,int,[1,2]}");
    IS(talk, "{batch,[{add_twice,[1]},{increment,[]},{count_calls,[]},{count_calls,[]}]}",
       "[4,51,1,2]");
    IS(talk, "{set,[letters],<<\"zz\">>}", "ok");
    IS(talk, "restore", "ok");
    IS(talk, "{get,[own]}", "1");
    IS(talk, "{get,[plain]}", "50");
    IS(talk, "{call,count_calls,[]}", "1");
    IS(talk, "{get,[letters,0]}", "97");
    CHECK(contains(talk("{read,$P,1}"), "error: {stale_pointer,"));
}

void reload_brings_back_the_first_state() {
    Talk talk(library("dependent.so"));
    const std::string handle = talk.keep("H", "{resolve,increment}");
    IS(talk, "{call,$H,[]}", "8");
    IS(talk, "{call,add_twice,[0]}", "2");
    IS(talk, "reload", "ok");
    IS(talk, "{get,[own]}", "1");
    IS(talk, "{call,$H,[]}", "8");
    IS(talk, "reload", "ok");
    IS(talk, "{get,[plain]}", "7");
}

// -z nodelete keeps a library in memory whatever dlclose() is told.
void a_pinned_library_is_loaded_under_a_new_name() {
    Talk talk(library("pinned.so"));
    IS(talk, "{call,increment,[]}", "8");
    IS(talk, "reload", "ok");
    IS(talk, "{call,increment,[]}", "8");
    IS(talk, "reload", "ok");
    IS(talk, "{call,increment,[]}", "8");
}

void two_sessions_of_one_library_share_nothing() {
    Talk one(library("torture_gcc_O0.so"));
    Talk two;
    CHECK(contains(load(two, library("torture_gcc_O0.so")), "was loaded already"));
    IS(one, "{set,[plain],1}", "ok");
    IS(two, "{get,[plain]}", "7");
    one.end();
    IS(two, "reload", "ok");
    IS(two, "{get,[plain]}", "7");
}

void pointers_become_stale_with_the_generation() {
    Talk talk(library("torture_gcc_O0.so"), "#{generation=>7}");
    CHECK(talk.keep("P", "{address_of,[plain]}") == "{ptr,int," + std::to_string(7ULL << 32) + "}");
    IS(talk, "{begin_test,[{increment,[]}]}", "[8]");
    CHECK(contains(talk("{read,$P,1}"), "error: {stale_pointer,"));
    IS(talk, "{read,{ptr,int,5},1}", "error: {stale_pointer,{ptr,int,5}}");
    IS(talk, "{read,{ptr,int},1}", "error: {bad_pointer,{ptr,int}}");
    talk.keep("Q", "{address_of,[corners]}");
    IS(talk, "{get,[$Q,0,1,x]}", "3");
    talk.keep("R", "{alloc,unsigned_char,[1,2,0,0]}");
    CHECK(talk.keep("R", "{alloc,unsigned_char,[1,2,0,0]}").rfind("{ptr,'unsigned char',", 0) == 0);
}

void the_reset_that_suits_is_named() {
    Talk heap;
    const std::string uses_heap = load(heap, library("torture_gcc_O0.so"));
    CHECK(contains(uses_heap, "reset=>reload"));
    CHECK(contains(uses_heap, "uses the heap (calloc, free)"));
    Talk plain;
    const std::string none = load(plain, library("simple.so"));
    CHECK(contains(none, "reset=>snapshot,warnings=>[]"));
    Talk constructing;
    CHECK(contains(load(constructing, library("constructed.so")), "has constructors"));
}

void signatures_from_headers_stand_in_for_debug_information() {
    Talk talk(library("stripped.so"), "#{signatures=><<\"" + library("signatures.o") + "\">>}");
    IS(talk, "{call,add,[2,3]}", "5");
    IS(talk, "{call,mirrored,[#{x=>1,y=>2}]}", "#{x=>2,y=>1}");
    IS(talk, "{call,add,[2]}", "error: {arity,add,2,1,<<\"int add(int arg1, int arg2)\">>}");
    IS(talk, "{get,[corners,1]}", "#{x=>3,y=>4}");
    IS(talk, "{set,[plain],9}", "ok");
    IS(talk, "{call,increment,[]}", "10");
    CHECK(contains(talk("{call,ad,[1,2]}"), "error: {unknown_function,ad,[add"));
    CHECK(contains(talk("functions"), "{add,[{arg1,int},{arg2,int}],int}"));
    IS(talk, "globals", "[{plain,int},{corners,'struct point[2]'}]");
}

void places_in_the_code_have_names() {
    Talk talk(library("simple.so"));
    const std::string reply = talk("{symbolise,[{<<\"" + library("simple.so") +
                                   "\">>,0,true},"
                                   "{<<\"/no/such/module\">>,16,false}]}");
    CHECK(contains(reply, "{<<\"??\">>,<<\"\">>,0}]"));
    IS(talk, "{symbolise,[oops]}", "error: {bad_request,{symbolise,[oops]}}");
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        return 2;
    }
    directory = argv[1];
    what_cannot_be_loaded_is_named();
    libraries_it_needs_are_under_test_too();
    a_snapshot_covers_all_libraries();
    reload_brings_back_the_first_state();
    a_pinned_library_is_loaded_under_a_new_name();
    two_sessions_of_one_library_share_nothing();
    pointers_become_stale_with_the_generation();
    the_reset_that_suits_is_named();
    signatures_from_headers_stand_in_for_debug_information();
    places_in_the_code_have_names();
    return check_failures != 0;
}

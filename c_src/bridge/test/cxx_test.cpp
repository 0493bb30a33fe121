// The C++ torture library: cxx_test LIBRARY
#include "check.h"
#include "talk.hpp"

using cb::Talk;

int main(int argc, char **argv) {
    if (argc != 2) {
        return 2;
    }
    Talk talk{argv[1]};
    IS(talk, "{call,'shop::price_of',[#{price=>5}]}", "5");
    IS(talk, "{call,'_ZN4shop8price_ofERKNS_4ItemE',[#{price=>6}]}", "6");
    IS(talk, "{call,'shop::next',['Small']}", "'Large'");
    IS(talk, "{call,'shop::next',[200]}", "'Small'");
    IS(talk, "{call,'shop::inner::deep',[1]}", "1001");
    IS(talk, "{call,twice,[1]}", "error: {unknown_function,twice,['_Z5twiced','_Z5twicei']}");
    IS(talk, "{call,'_Z5twicei',[4]}", "8");
    IS(talk, "{call,'_Z5twiced',[1.5]}", "3.0");
    IS(talk, "{get,['shop::stock']}", "12");
    IS(talk, "{get,['shop::Item::made']}", "4");
    IS(talk, "{get,[both]}", "#{below=>1,above=>2}");
    talk.keep("C", "{address_of,[counter]}");
    IS(talk, "{call,'Counter::up',[$C,3]}", "3");
    IS(talk, "{get,[counter,count]}", "3");
    IS(talk, "{call,length_of,[#{}]}",
       "error: {not_callable,length_of,{unsupported_type,1,'Owner'}}");
    talk.keep("A", "{alloc,int,[1]}");
    talk.keep("B", "{alloc,int,[2]}");
    IS(talk, "{call,swap_ints,[$A,$B]}", "ok");
    IS(talk, "{read,$A,1}", "[2]");
    IS(talk, "{call,checked,[1]}", "1");
    IS(talk, "{call,checked,[-1]}", "error: {cxx_exception,<<\"std::out_of_range: below zero\">>}");
    IS(talk, "{call,checked,[0]}", "error: {cxx_exception,<<\"int\">>}");
    return check_failures != 0;
}

// Calls and reads everything in torture.c, however it was compiled: torture_test LIBRARY (plain |
// optimised)
#include "check.h"
#include "talk.hpp"

#include <cstring>

using cb::Talk;

namespace {

void integers_are_checked_against_their_type(Talk &talk) {
    IS(talk, "{call,add,[2,3]}", "5");
    IS(talk, "{call,same_i8,[-128]}", "-128");
    IS(talk, "{call,same_i8,[128]}", "error: {arg,same_i8,1,v,{out_of_range,int8_t,128}}");
    IS(talk, "{call,same_u8,[255]}", "255");
    IS(talk, "{call,same_u8,[-1]}", "error: {arg,same_u8,1,v,{out_of_range,uint8_t,-1}}");
    IS(talk, "{call,same_i16,[-32768]}", "-32768");
    IS(talk, "{call,same_u16,[65535]}", "65535");
    IS(talk, "{call,same_i32,[-2147483648]}", "-2147483648");
    IS(talk, "{call,same_i32,[2147483648]}",
       "error: {arg,same_i32,1,v,{out_of_range,int32_t,2147483648}}");
    IS(talk, "{call,same_u32,[4294967295]}", "4294967295");
    IS(talk, "{call,same_i64,[-9223372036854775808]}", "-9223372036854775808");
    IS(talk, "{call,same_u64,[18446744073709551615]}", "18446744073709551615");
    IS(talk, "{call,same_u64,[18446744073709551616]}",
       "error: {arg,same_u64,1,v,{out_of_range,uint64_t,18446744073709551616}}");
    IS(talk, "{call,same_i64,[9223372036854775808]}",
       "error: {arg,same_i64,1,v,{out_of_range,int64_t,9223372036854775808}}");
    IS(talk, "{call,same_i32,[1.0]}", "error: {arg,same_i32,1,v,{bad_type,int32_t,1.0}}");
    IS(talk, "{call,same_distance,[4294967296]}",
       "error: {arg,same_distance,1,v,{out_of_range,distance_t,4294967296}}");
    IS(talk, "{call,same_char,[-1]}", "-1");
}

void other_scalars(Talk &talk) {
    IS(talk, "{call,same_bool,[true]}", "true");
    IS(talk, "{call,same_bool,[0]}", "false");
    IS(talk, "{call,same_bool,[2]}", "error: {arg,same_bool,1,v,{out_of_range,'_Bool',2}}");
    IS(talk, "{call,same_float,[0.25]}", "0.25");
    IS(talk, "{call,same_float,[1.0e300]}",
       "error: {arg,same_float,1,v,{out_of_range,float,1e+300}}");
    IS(talk, "{call,same_double,[3]}", "3.0");
    IS(talk, "{call,same_double,[nan]}", "nan");
    IS(talk, "{call,same_float,[neg_inf]}", "neg_inf");
    IS(talk, "{call,same_double,[much]}", "error: {arg,same_double,1,v,{bad_type,double,much}}");
    IS(talk, "{call,same_long_double,[2.5]}", "2.5");
    IS(talk, "{call,special,[0]}", "nan");
    IS(talk, "{call,special,[1]}", "inf");
    IS(talk, "{call,special,[-1]}", "neg_inf");
    IS(talk, "{call,same_level,['LOW']}", "'LOW'");
    IS(talk, "{call,same_level,[5]}", "'HIGH'");
    IS(talk, "{call,same_level,[3]}", "3");
    IS(talk, "{call,same_level,['TOP']}",
       "error: {arg,same_level,1,v,{bad_enumerator,'enum level','TOP'}}");
    IS(talk, "{call,same_depth,['DEEP']}", "'DEEP'");
    IS(talk, "{call,same_depth,[-1]}",
       "error: {arg,same_depth,1,v,{out_of_range,'enum depth',-1}}");
    IS(talk, "{call,nothing,[]}", "ok");
    IS(talk, "{call,many,[1,2.0,3,4.0,5,6,7,8,9.0,10]}", "55");
}

void buffers_and_pointers(Talk &talk) {
    IS(talk, "{call,sum_bytes,[[1,2,3],3]}", "6");
    IS(talk, "{call,sum_bytes,[<<\"ab\">>,2]}", "195");
    IS(talk, "{call,sum_bytes,[[1,256],2]}",
       "error: {arg,sum_bytes,1,bytes,{out_of_range,'const uint8_t',256}}");
    IS(talk, "{call,sum_ints,[[100000,-1],2]}", "99999");
    IS(talk, "{call,text_length,[<<\"four\">>]}", "4");
    IS(talk, "{call,text_length,[[102,111]]}", "2");
    IS(talk, "{call,text_length,[null]}", "999");
    IS(talk, "{call,text_length,[5]}",
       "error: {arg,text_length,1,text,{bad_type,'const char *',5}}");
    IS(talk, "{call,all_lengths,[[<<\"one\">>,<<\"three\">>]]}", "8");
    talk.keep("B", "{alloc,unsigned_char,[1,1,1]}");
    IS(talk, "{call,fill,[$B,2,9]}", "ok");
    IS(talk, "{read,$B,3}", "[9,9,1]");
    CHECK(talk("{read,$B,4}").rfind("error: {out_of_bounds,{ptr,'unsigned char',", 0) == 0);
    IS(talk, "{free,$B}", "ok");
    CHECK(talk("{read,$B,1}").rfind("error: {stale_pointer,", 0) == 0);
    IS(talk, "{read,null,1}", "error: {null_pointer,null}");
    IS(talk, "{cstring,null}", "error: {null_pointer,null}");
    IS(talk, "{alloc,'struct nothing',[]}", "error: {unknown_type,'struct nothing'}");
    IS(talk, "{alloc,uint8_t,[256]}", "error: {value,uint8_t,{out_of_range,uint8_t,256}}");
    talk.keep("W", "{call,wild,[]}");
    CHECK(talk("{read,$W,1}").rfind("error: {bad_pointer,{ptr,'struct node',", 0) == 0);
    CHECK(talk("{cstring,$W}").rfind("error: {bad_pointer,", 0) == 0);
    CHECK(talk("{read_bytes,$W,1}").rfind("error: {bad_pointer,", 0) == 0);
    CHECK(talk("{get,[$W,value]}").rfind("error: {bad_pointer,[", 0) == 0);
    CHECK(talk("{get,[$W,next,value]}").rfind("error: {bad_pointer,[", 0) == 0);
    CHECK(talk("{set,[$W,value],1}").rfind("error: {bad_pointer,[", 0) == 0);
    talk.keep("M", "{call,make_block,[8]}");
    IS(talk, "{read_bytes,$M,0}", "<<\"\">>");
    CHECK(talk("{free,$M}").rfind("error: {bad_pointer,{ptr,void,", 0) == 0);
    IS(talk, "{call,drop_block,[$M]}", "ok");
}

void functions_as_values(Talk &talk) {
    IS(talk, "{call,apply,[add,4,5]}", "9");
    talk.keep("F", "{call,choose,[1]}");
    IS(talk, "{call,apply,[$F,4,5]}", "9");
    IS(talk, "{call,choose,[0]}", "null");
    IS(talk, "{call,apply,[null,4,5]}", "-1");
    talk.keep("G", "{address_of,[add]}");
    IS(talk, "{call,apply,[$G,1,1]}", "2");
    IS(talk, "{call,apply,[ad,1,1]}", "error: {unknown_function,ad,[add]}");
}

void aggregates_by_value(Talk &talk) {
    IS(talk, "{call,mirrored,[#{x=>1,y=>2}]}", "#{x=>2,y=>1}");
    IS(talk, "{call,mirrored,[#{x=>1}]}", "#{x=>0,y=>1}");
    IS(talk, "{call,mirrored,[#{z=>1}]}",
       "error: {arg,mirrored,1,p,{unknown_member,'struct point',z,[]}}");
    IS(talk, "{call,mirrored,[#{x=>2147483648}]}",
       "error: {arg,mirrored,1,p,{out_of_range,int,2147483648}}");
    IS(talk, "{call,area,[#{from=>#{x=>1,y=>1},to=>#{x=>4,y=>3}}]}", "6");
    IS(talk, "{call,moved,[#{from=>#{x=>1},to=>#{y=>2}},10]}",
       "#{from=>#{x=>11,y=>0},to=>#{x=>10,y=>2}}");
    IS(talk, "{call,scaled,[#{x=>1.0,y=>2.0,z=>3.0},2.0]}", "#{x=>2.0,y=>4.0,z=>6.0}");
    IS(talk, "{call,swapped,[#{count=>21,weight=>5.0}]}", "#{count=>42,weight=>2.5}");
    IS(talk, "{call,grown,[#{bytes=>[1,2,3]}]}", "#{bytes=>[3,2,2]}");
    IS(talk, "{call,grown,[#{bytes=>[1,2,3,4]}]}",
       "error: {arg,grown,1,t,{out_of_range,'uint8_t[3]',[1,2,3,4]}}");
    IS(talk, "{call,turned,[#{a=>1.0,b=>2,d=>3.0}]}", "#{a=>3.0,b=>2,d=>1.0}");
    IS(talk, "{call,toggled,[#{on=>0,level=>5,wide=>1099511627774}]}",
       "#{on=>1,level=>-5,wide=>1099511627775}");
    IS(talk, "{call,toggled,[#{level=>8}]}", "error: {arg,toggled,1,f,{out_of_range,int,8}}");
    IS(talk, "{call,doubled,[#{as_float=>1.5}]}", "#{as_float=>3.0,as_int=>1077936128}");
}

void refusals(Talk &talk) {
    IS(talk, "{call,packed_sum,[#{a=>1,b=>2}]}",
       "error: {not_callable,packed_sum,{unsupported_type,1,'struct packed'}}");
    IS(talk, "{call,packed_sum_at,[#{a=>1,b=>2}]}", "3");
    IS(talk, "{call,huge,[1]}", "error: {not_callable,huge,{unsupported_type,0,'__int128'}}");
    const std::string spin = talk("{call,spin,[1]}");
    CHECK(spin.rfind("error: {not_callable,spin,{unsupported_type,0,", 0) == 0);
    IS(talk, "{call,add,[1]}", "error: {arity,add,2,1,<<\"int add(int a, int b)\">>}");
    IS(talk, "{call,sum_of,[]}",
       "error: {arity,sum_of,{at_least,1},0,<<\"int sum_of(int count, ...)\">>}");
    IS(talk, "{call,same_i32x,[1]}",
       "error: {unknown_function,same_i32x,[same_i32,same_u32,same_i16]}");
    IS(talk, "{call,999,[]}", "error: {unknown_handle,999}");
    IS(talk, "{call,add,{1,2}}", "error: {bad_request,{1,2}}");
    IS(talk, "{call,add,[1|2]}", "error: {bad_request,[1,2]}");
    IS(talk, "nonsense", "error: {bad_request,nonsense}");
}

void open_argument_lists(Talk &talk) {
    IS(talk, "{call,sum_of,[0]}", "0");
    IS(talk, "{call,sum_of,[3,1,2,3]}", "6");
    IS(talk, "{call,sum_of,[1,[]]}", "error: {arg,sum_of,2,'...',{bad_type,'...',[]}}");
    talk.keep("O", "{alloc,char,<<\"0123456789012345678901234567890123456789\">>}");
    IS(talk, "{call,formatted,[$O,30,<<\"%d %.1f %s\">>,-7,2.5,<<\"end\">>]}", "10");
    IS(talk, "{cstring,$O}", "<<\"-7 2.5 end\">>");
    IS(talk, "{call,old_any,[]}", "5");
    IS(talk, "{call,old_any,[1,2.0]}", "5");
    IS(talk, "{call,old_float,[1.5,2]}", "3.5");
}

// Optimised code may have changed these; then they must be refused, never called in a wrong way.
void internal_functions(Talk &talk, bool optimised) {
    const std::string hidden =
        talk("{call,hidden_function,[1]}"); // link time optimisation inlines it
    CHECK(hidden == "101" ||
          (optimised && hidden == "error: {not_callable,hidden_function,inlined}"));
    const std::string got = talk("{call,specialised,[2,0,[10]]}");
    CHECK(got == "23" || (optimised && got == "error: {not_callable,specialised,abi_changed}"));
    IS(talk, "{call,use_specialised,[2]}", "56");
    const std::string inlined = talk("{call,only_inlined,[2]}");
    CHECK(inlined == "6" ||
          (optimised && (inlined == "error: {not_callable,only_inlined,inlined}" ||
                         inlined.rfind("error: {unknown_function,only_inlined,", 0) == 0)));
    IS(talk, "{call,use_inlined,[2]}", "6");
}

void variables(Talk &talk, bool optimised) {
    IS(talk, "{get,[plain]}", "7");
    IS(talk, "{set,[plain],41}", "ok");
    IS(talk, "{call,increment,[]}", "42");
    IS(talk, "{get,[byte]}", "200");
    const std::string hidden = talk("{get,[hidden_in_file]}");
    CHECK(hidden == "3" ||
          (optimised && hidden == "error: {not_accessible,hidden_in_file,optimised_out}"));
    IS(talk, "{get,[constant_table]}", "[1,2,3,5]");
    IS(talk, "{set,[constant_table,1],9}", "error: {read_only,[constant_table,1]}");
    IS(talk, "{get,[grid]}", "[[1,2,3],[4,5,6]]");
    IS(talk, "{get,[grid,1,2]}", "6");
    IS(talk, "{get,[grid,2]}", "error: {bad_index,[grid,2],2,2}");
    IS(talk, "{set,[grid,0],[7,8]}", "ok");
    IS(talk, "{get,[grid]}", "[[7,8,0],[4,5,6]]");
    IS(talk, "{get,[corners,1,y]}", "4");
    IS(talk, "{get,[diagonal,to]}", "#{x=>10,y=>10}");
    IS(talk, "{get,[diagonal,too]}", "error: {unknown_member,[diagonal,too],too,[to]}");
    IS(talk, "{set,[switches,level],-8}", "ok");
    IS(talk, "{set,[switches,wide],1}", "ok");
    IS(talk, "{get,[switches]}", "#{on=>0,level=>-8,wide=>1}");
    IS(talk, "{set,[switches,level],8}", "error: {value,[switches,level],{out_of_range,int,8}}");
    IS(talk, "{get,[with_anonymous]}",
       "#{own=>1,left=>2,right=>" + talk("{get,[with_anonymous,right]}") + ",inner=>#{x=>3,y=>4}}");
    IS(talk, "{set,[with_anonymous,right],1.0}", "ok");
    IS(talk, "{get,[with_anonymous,left]}", "1065353216");
    IS(talk, "{get,[either,as_int]}", "1065353216");
    IS(talk, "{get,[severity]}", "'HIGH'");
    IS(talk, "{set,[severity],'LOW'}", "ok");
    IS(talk, "{get,[severity]}", "'LOW'");
    talk.keep("T", "{get,[greeting]}");
    IS(talk, "{cstring,$T}", "<<\"hello\">>");
    IS(talk, "{get,[greeting,1]}", "101");
    IS(talk, "{get,[names,1]}", "null");
    IS(talk, "{set,[letters],<<\"xy\">>}", "ok");
    IS(talk, "{get,[letters]}", "[120,121,0,0,0,0,0,0]");
    IS(talk, "{get,[ratio]}", "1.5");
    IS(talk, "{get,[small_ratio]}", "0.25");
    IS(talk, "{get,[precise]}", "2.5");
    IS(talk, "{get,[ready]}", "true");
    IS(talk, "{get,[first,next,value]}", "2");
    IS(talk, "{get,[first,next,next]}", "null");
    IS(talk, "{get,[first,next,next,value]}", "error: {null_pointer,[first,next,next,value]}");
    IS(talk, "{get,[nowhere,x]}", "error: {null_pointer,[nowhere,x]}");
    IS(talk, "{get,[per_thread]}", "11");
    IS(talk, "{get,[plian]}", "error: {unknown_variable,plian,[plain]}");
    IS(talk, "{get,[]}", "error: {bad_request,[]}");
    talk.keep("N", "{call,first_node,[]}");
    IS(talk, "{get,[$N,value]}", "1");
    IS(talk, "{get,[$N,next,value]}", "2");
    IS(talk, "{set,[$N,next,value],22}", "ok");
    IS(talk, "{get,[last,value]}", "22");
    talk.keep("S", "{address_of,[switches]}");
    IS(talk, "{set,[$S,level],3}", "ok");
    IS(talk, "{get,[switches]}", "#{on=>0,level=>3,wide=>1}");
    talk.keep("Y", "{alloc,int,[3,10,20,30]}");
    IS(talk, "{call,sum_tail,[$Y]}", "60");
    CHECK(std::strstr(talk("functions").c_str(),
                      "{mirrored,[{p,'struct point'}],'struct point'}") != nullptr);
    CHECK(std::strstr(talk("globals").c_str(), "{corners,'struct point[2]'}") != nullptr);
}

void batches(Talk &talk) {
    IS(talk, "{batch,[]}", "[]");
    IS(talk, "{batch,[{add,[1,2]},{mirrored,[#{x=>1}]}]}", "[3,#{x=>0,y=>1}]");
    IS(talk, "{batch,[{add,[1,2]},{add,[1]},{add,[3,4]}]}",
       "error: {batch,2,[3],{arity,add,2,1,<<\"int add(int a, int b)\">>}}");
    IS(talk, "{batch,[{add,[1]}]}",
       "error: {batch,1,[],{arity,add,2,1,<<\"int add(int a, int b)\">>}}");
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        return 2;
    }
    const bool optimised = std::strcmp(argv[2], "optimised") == 0;
    Talk talk{argv[1]};
    integers_are_checked_against_their_type(talk);
    other_scalars(talk);
    buffers_and_pointers(talk);
    functions_as_values(talk);
    aggregates_by_value(talk);
    refusals(talk);
    open_argument_lists(talk);
    internal_functions(talk, optimised);
    variables(talk, optimised);
    batches(talk);
    return check_failures != 0;
}

-module(cb_error_tests).

-include_lib("eunit/include/eunit.hrl").

line(Reason) -> unicode:characters_to_list(cb_error:format({cb, Reason})).

lines_test_() ->
    [
        ?_assertEqual(Line, line(Reason))
     || {Line, Reason} <- [
            {"no function sensr in the library; similar: sensor, sensor_e2e",
                {unknown_function, sensr, [sensor, sensor_e2e]}},
            {"no variable x in the library", {unknown_variable, x, []}},
            {"add takes 2 arguments, got 1: int add(int a, int b)",
                {arity, add, 2, 1, <<"int add(int a, int b)">>}},
            {"total takes at least 1 argument, got 0: int total(int count, ...)",
                {arity, total, {at_least, 1}, 0, <<"int total(int count, ...)">>}},
            {"low, argument 1 (v): 256 is out of range for unsigned char",
                {arg, low, 1, v, {out_of_range, 'unsigned char', 256}}},
            {"low, argument 2: foo is no value for int",
                {arg, low, 2, '', {bad_type, int, foo}}},
            {"raise, argument 1 (l): up is no enumerator of enum level",
                {arg, raise, 1, l, {bad_enumerator, 'enum level', up}}},
            {"value for g_box.size[7]: x is no value for double",
                {value, [g_box, size, 7], {bad_type, double, x}}},
            {"g_null_point is a null pointer: there is nothing to read or write",
                {null_pointer, g_null_point}},
            {"crash: SIGSEGV at address 0x10 in follow(16), at follow (faulty.c:9)",
                {crash, #{
                    signal => sigsegv,
                    addr => 16,
                    in => {follow, [16]},
                    frames => [{<<"follow">>, <<"/src/faulty.c">>, 9}],
                    log => <<>>,
                    coredump => none
                }}},
            {"the system under test has called exit(3) in leave(3)",
                {exited, 3, #{in => {leave, [3]}, log => <<>>}}},
            {"no answer within 200 ms from hang(), at spin (faulty.c:15)",
                {timeout, 200, #{
                    in => {hang, []}, frames => [{<<"spin">>, <<"faulty.c">>, 15}], log => <<>>
                }}},
            {"cannot load x.so: cannot open shared object file",
                {load, "x.so", {dlerror, "x.so: cannot open shared object file"}}},
            {"x.so has no debug information: build it with -g, or give its headers",
                {load, "x.so", no_debug_info}},
            {"call 2 of the batch, after 1 that returned: no function f in the library",
                {batch, 2, [1], {unknown_function, f, []}}}
        ]
    ].

every_reason_is_one_line_test() ->
    Text = <<"a.c:1: error: one\na.c:2: error: two\n">>,
    Line = line({compile, "a.c", {failed, Text}}),
    ?assertNot(lists:member($\n, Line)),
    ?assertNotEqual(nomatch, string:find(Line, "two")).

%% A term that is no reason of c_bridge still gives a line.
a_foreign_term_is_printed_test() ->
    ?assertEqual("{what,is,this}", line({what, is, this})).

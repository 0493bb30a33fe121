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

%% No reason of c_bridge is printed as a bare term.
all_reasons_have_words_test_() ->
    [
        {line(Reason), ?_assertNotEqual(bare(Reason), line(Reason))}
     || Reason <- reasons()
    ].

bare(Reason) -> lists:flatten(io_lib:format("~0tp", [Reason])).

reasons() ->
    In = #{in => {f, [1]}, log => <<>>, frames => []},
    [
        {not_callable, f, inlined},
        {not_callable, f, abi_changed},
        {not_callable, f, {unsupported_type, 0, '__int128'}},
        {not_callable, f, {unsupported_type, 2, '__int128'}},
        {unknown_handle, 3},
        {cxx_exception, <<"what">>},
        {unknown_member, [g, x], y, []},
        {bad_index, [g, 9], 9, 0},
        {bad_index, [g, 9], 9, 4},
        {not_accessible, v, optimised_out},
        {not_accessible, v, thread_local},
        {read_only, v},
        {unknown_type, 'struct none'},
        {stale_pointer, {ptr, int, 1}},
        {bad_pointer, x},
        {out_of_bounds, {ptr, int, 1}, 8},
        {arg, f, 1, p, {stale_pointer, {ptr, int, 1}}},
        {exited, unknown, In},
        {sanitizer, undefined, In#{summary => <<"line">>}},
        {timeout, 100, In},
        {not_running, stopped},
        {not_running, {exited, 3, In}},
        {callback, {f, no_such_stub}},
        {callback, {f, {error, broken, []}}},
        {callback, {f, {caller, killed}}},
        {callback, f, no_port},
        {callback, f, {bad_type, int, x}},
        {in_call, f},
        {other_process, self()},
        busy,
        {load, "x.so", {debug_info, "bad"}},
        {load, "c_bridge_port", {protocol, timeout}},
        {reset, fork, not_in_nif},
        {not_started, lib},
        {which_library, []},
        {which_library, [a, b]},
        {bad_option, {timeout, soon}, "milliseconds"},
        {missing_option, [so, c_src]},
        {needs_port, {sanitize, [address]}},
        {compile, "x.c", no_such_file},
        {compile, "x.c", {no_such_program, "gcc"}},
        {undefined, [<<"f">>, <<"g">>]},
        {stub, f, not_declared},
        {stub, f, {bad_value, {}}},
        {stub, f, {unsupported_declaration, <<"void (*f (int)) (int)">>}},
        {cache, "/x", eacces},
        {module_clash, lists, "lists.beam"},
        {journal, "j", not_a_journal},
        {journal, "j", truncated},
        {journal, "j", enoent},
        {keeper, killed},
        {bad_request, x},
        no_child,
        no_snapshot,
        no_memory,
        not_loaded,
        already_loaded
    ].

%% A term that is no reason of c_bridge still gives a line.
a_foreign_term_is_printed_test() ->
    ?assertEqual("{what,is,this}", line({what, is, this})).

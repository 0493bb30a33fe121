%% What different compilers make of the torture library of c_src/bridge is called alike, through
%% both transports.
-module(cb_compiler_tests).

-include_lib("eunit/include/eunit.hrl").

torture() ->
    Here = filename:dirname(cb_sut:source("x")),
    Bridge = filename:join([Here, "..", "..", "..", "..", "c_src", "bridge"]),
    filename:join([Bridge, "test", "torture", "torture.c"]).

%% gcc always, clang if it is there.
builds() ->
    Compilers = [{"gcc", "g++"} | [{"clang", "clang++"} || os:find_executable("clang") =/= false]],
    [{Compiler, Level} || Compiler <- Compilers, Level <- ["-O0", "-O2"]].

torture_test_() ->
    [
        {lists:concat([C, " ", Level, " ", Transport]),
            {timeout, 60, fun() -> torture(Compiler, Level, Transport) end}}
     || {{C, _} = Compiler, Level} <- builds(), Transport <- [nif, port]
    ].

torture(Compiler, Level, Transport) ->
    {ok, Lib} = cb:start(sut_torture, [
        {c_src, torture()},
        {cflags, [Level, "-w"]},
        {compiler, Compiler},
        {transport, Transport},
        {cache_dir, cb_sut:cache()}
    ]),
    try
        [
            ?assertEqual({Function, Args, Expected}, {Function, Args, cb:call(Lib, Function, Args)})
         || {Function, Args, Expected} <- calls()
        ],
        [?assertEqual({Path, Value}, {Path, cb:value_of(Lib, Path)}) || {Path, Value} <- values()],
        ok = cb:restart(Lib),
        not_callable(Level, Lib)
    after
        cb:stop(Lib)
    end.

%% By hand from torture.c.
calls() ->
    [
        {add, [2, 3], 5},
        {same_i8, [-128], -128},
        {same_u16, [65535], 65535},
        {same_i64, [-9223372036854775808], -9223372036854775808},
        {same_u64, [18446744073709551615], 18446744073709551615},
        {same_bool, [true], true},
        {same_float, [0.1], 0.10000000149011612},
        {same_double, [0.1], 0.1},
        {same_long_double, [2.5], 2.5},
        {same_level, ['HIGH'], 'HIGH'},
        {same_depth, ['DEEP'], 'DEEP'},
        {nothing, [], ok},
        {many, [1, 2.0, 3, 4.0, 5, 6, 7, 8, 9.0, 10], 55},
        {sum_bytes, [<<1, 2, 255>>, 3], 258},
        {sum_ints, [[-5, 6, 7], 3], 8},
        {text_length, [<<"four">>], 4},
        {text_length, [null], 999},
        {all_lengths, [[<<"ab">>, <<"cde">>, null]], 5},
        {mirrored, [#{x => 1, y => 2}], #{x => 2, y => 1}},
        {area, [#{from => #{x => 1, y => 1}, to => #{x => 4, y => 3}}], 6},
        {scaled, [#{x => 1, y => 2, z => 3}, 2], #{x => 2.0, y => 4.0, z => 6.0}},
        {swapped, [#{count => 4, weight => 3}], #{count => 8, weight => 1.5}},
        {grown, [#{bytes => [1, 2, 3]}], #{bytes => [3, 2, 2]}},
        {turned, [#{a => 1, b => 2, d => 3}], #{a => 3.0, b => 2, d => 1.0}},
        {toggled, [#{on => 0, level => 7, wide => 8}], #{on => 1, level => -7, wide => 9}},
        {packed_sum_at, [#{a => 1, b => 2}], 3},
        {sum_of, [3, 10, 20, 30], 60},
        {old_any, [], 5},
        {old_float, [1.5, 2], 3.5},
        {hidden_function, [1], 101},
        {use_specialised, [1], 36},
        {use_inlined, [4], 12},
        {special, [0], nan},
        {special, [1], inf},
        {special, [-1], neg_inf},
        {apply, [null, 1, 2], -1}
    ].

values() ->
    [
        {plain, 7},
        {byte, 200},
        {constant_table, [1, 2, 3, 5]},
        {[grid, 1, 2], 6},
        {[corners, 1], #{x => 3, y => 4}},
        {[with_anonymous, inner, y], 4},
        {severity, 'HIGH'},
        {ready, true},
        {precise, 2.5},
        {[first, next, value], 2},
        {nowhere, null}
    ].

%% Optimised static functions are refused rather than called wrongly.
not_callable("-O0", Lib) ->
    ?assertEqual(8, cb:call(Lib, specialised, [1, 0, [5]]));
not_callable("-O2", Lib) ->
    Inlined = cb_sut:reason(fun() -> cb:call(Lib, only_inlined, [1]) end),
    ?assert(refused(only_inlined, Inlined)),
    Changed = cb_sut:reason(fun() -> cb:call(Lib, specialised, [1, 0, [5]]) end),
    ?assert(refused(specialised, Changed)).

%% clang leaves nothing of a function that it has inlined everywhere.
refused(Function, {not_callable, Function, Why}) -> lists:member(Why, [inlined, abi_changed]);
refused(Function, {unknown_function, Function, _}) -> true;
refused(_, _) -> false.

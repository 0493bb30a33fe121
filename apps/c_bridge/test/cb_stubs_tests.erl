%% Functions of other files, answered by constants and by Erlang.
-module(cb_stubs_tests).

-include_lib("eunit/include/eunit.hrl").

constant_stubs_test() ->
    Lib = cb_sut:start("device.c", [{stubs, constants()}]),
    ?assertEqual(2.5, cb:call(Lib, scaled, [1])),
    ?assertEqual($l, cb:call(Lib, first_letter, [1])),
    ?assertEqual(0.0, cb:call(Lib, filled, [1])),
    ok = cb:stop(Lib).

constants() ->
    [
        {read_raw, 5},
        {scale_of, 0.5},
        {mode_of, 'ON'},
        {label_of, <<"label">>},
        {report, ok},
        {fill_reading, 1},
        {best_of, fun(A, _) -> A end}
    ].

a_fun_needs_a_port_test() ->
    ?assertEqual(
        {error, {needs_port, {stubs, [best_of]}}},
        cb:start(sut_device, [
            {c_src, cb_sut:source("device.c")}, {transport, nif}, {stubs, constants()}
        ])
    ).

%% Funs run in the process that called, so they see what it has.
with_funs(Funs, Test) ->
    [with_funs(Funs, Owner, Test) || Owner <- [self(), none]].

with_funs(Funs, Owner, Test) ->
    Stubs = lists:ukeymerge(1, lists:keysort(1, Funs), lists:keysort(1, constants())),
    Lib = cb_sut:start("device.c", [{stubs, Stubs}, {owner, Owner}]),
    try
        Test(Lib)
    after
        cb:stop(Lib)
    end.

a_fun_answers_for_a_function_test() ->
    Test = self(),
    Funs = [
        {read_raw, fun(Channel) -> Channel * 100 end},
        {report, fun(_Text, Value) -> Test ! {reported, self(), Value} end}
    ],
    with_funs(Funs, fun(Lib) ->
        ?assertEqual(150.0, cb:call(Lib, scaled, [3])),
        receive
            {reported, Test, 3} -> ok
        end
    end).

a_fun_takes_and_gives_structs_test() ->
    Best = fun(#{value := A} = X, #{value := B} = Y) ->
        case A > B of
            true -> X;
            false -> Y
        end
    end,
    with_funs([{best_of, Best}], fun(Lib) ->
        ?assertEqual(4.0, cb:call(Lib, better, [4, 2])),
        ?assertEqual(4.0, cb:call(Lib, better, [2, 4]))
    end).

a_fun_that_fails_fails_the_call_test() ->
    with_funs([{read_raw, fun(_) -> error(broken) end}], fun(Lib) ->
        ?assertMatch(
            {callback, {read_raw, {error, broken, _}}},
            cb_sut:reason(fun() -> cb:call(Lib, scaled, [3]) end)
        ),
        %% The C function cannot go on without its value: its process is gone.
        ?assertMatch({not_running, _}, cb_sut:reason(fun() -> cb:call(Lib, scaled, [3]) end)),
        ok = cb:restart(Lib),
        ?assertEqual($l, cb:call(Lib, first_letter, [1]))
    end).

text_is_given_to_a_fun_as_text_test() ->
    Test = self(),
    with_funs([{report, fun(Text, _) -> Test ! {reported, Text} end}], fun(Lib) ->
        2.5 = cb:call(Lib, scaled, [3]),
        receive
            {reported, Text} -> ?assertEqual(<<"scaled">>, Text)
        end
    end).

a_fun_cannot_use_the_library_that_waits_for_it_test() ->
    Stub = fun(_) -> cb:call(sut_device, first_letter, [1]) end,
    with_funs([{read_raw, Stub}], fun(Lib) ->
        ?assertMatch(
            {callback, {read_raw, {error, {cb, {in_call, read_raw}}, _}}},
            cb_sut:reason(fun() -> cb:call(Lib, scaled, [3]) end)
        )
    end).

a_fun_cannot_stop_the_library_that_waits_for_it_test() ->
    Stub = fun(_) -> cb:stop(sut_device) end,
    with_funs([{read_raw, Stub}], fun(Lib) ->
        ?assertMatch(
            {callback, {read_raw, {error, {cb, {in_call, read_raw}}, _}}},
            cb_sut:reason(fun() -> cb:call(Lib, scaled, [3]) end)
        )
    end).

the_time_of_a_fun_is_not_that_of_the_call_test() ->
    Slow = fun(Channel) ->
        receive
        after 200 -> Channel
        end
    end,
    Stubs = lists:keystore(read_raw, 1, constants(), {read_raw, Slow}),
    Lib = cb_sut:start("device.c", [{stubs, Stubs}, {timeout, 40}]),
    ?assertEqual(1.5, cb:call(Lib, scaled, [3])),
    ok = cb:stop(Lib).

a_wrong_value_of_a_fun_fails_the_call_test() ->
    with_funs([{read_raw, fun(_) -> not_a_number end}], fun(Lib) ->
        ?assertMatch(
            {callback, read_raw, _}, cb_sut:reason(fun() -> cb:call(Lib, scaled, [3]) end)
        )
    end).

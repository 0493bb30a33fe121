%% Which reset is chosen, and that each gives the state after start as far as it promises to.
-module(cb_reset_tests).

-include_lib("eunit/include/eunit.hrl").

loaded(Reset, Warnings) -> #{reset => Reset, warnings => Warnings}.

chosen(Transport, Asked, Loaded) ->
    {ok, #{method := Method}} = cb_reset:choose(Transport, Asked, none, Loaded),
    Method.

auto_is_fork_for_port_test() ->
    ?assertEqual(fork, chosen(port, auto, loaded(snapshot, []))).

auto_follows_the_core_for_nif_test() ->
    ?assertEqual(snapshot, chosen(nif, auto, loaded(snapshot, []))),
    ?assertEqual(reload, chosen(nif, auto, loaded(reload, [<<"imports malloc">>]))).

a_snapshot_that_does_not_cover_the_state_is_used_with_a_warning_test() ->
    {ok, Choice} = cb_reset:choose(port, snapshot, none, loaded(reload, [<<"imports malloc">>])),
    ?assertMatch(#{method := snapshot, warnings := [<<"imports malloc">>]}, Choice).

no_reset_is_warned_of_test() ->
    ?assertMatch(
        {ok, #{method := none, warnings := [_]}},
        cb_reset:choose(port, none, none, loaded(snapshot, []))
    ).

processes_cannot_be_reset_inside_the_vm_test() ->
    [
        ?assertEqual(
            {error, {reset, Method, not_in_nif}},
            cb_reset:choose(nif, Method, none, loaded(snapshot, []))
        )
     || Method <- [fork, respawn]
    ].

a_forced_method_keeps_the_calls_of_the_model_test() ->
    Calls = [{init, [1]}],
    {ok, Choice} = cb_reset:choose(port, {calls, Calls}, {force, fork}, loaded(snapshot, [])),
    ?assertMatch(#{method := fork, calls := Calls}, Choice),
    ?assertEqual([{begin_test, Calls}], cb_reset:requests(Choice)).

without_calls_there_is_nothing_to_request_test() ->
    {ok, Choice} = cb_reset:choose(port, fork, none, loaded(snapshot, [])),
    ?assertEqual([], cb_reset:requests(Choice)).

%% ---- what they reset -----------------------------------------------------------------------

state(L) -> {cb:value_of(L, in_data), cb:value_of(L, in_bss), cb:call(L, touch, [])}.

whole_process_test_() ->
    [
        {lists:concat([Transport, " ", Reset]), fun() -> covers_everything(Transport, Reset) end}
     || {Transport, Reset} <- [{port, fork}, {port, respawn}, {port, auto}]
    ].

%% Data, bss, heap, thread-local state, what constructors did.
covers_everything(Transport, Reset) ->
    Lib = cb_sut:start("state.c", [{transport, Transport}, {reset, Reset}]),
    ?assertEqual({1, 0, 1}, state(Lib)),
    ?assertEqual(2, cb:call(Lib, touch, [])),
    ?assertEqual(2, cb:call(Lib, thread_value, [])),
    ?assertEqual(9, cb:call(Lib, constructed_value, [])),
    ok = cb:restart(Lib),
    ?assertEqual(0, cb:call(Lib, thread_value, [])),
    ?assertEqual(7, cb:call(Lib, constructed_value, [])),
    ?assertEqual({1, 0, 1}, state(Lib)),
    ok = cb:stop(Lib).

data_test_() ->
    [
        {lists:concat([Transport, " ", Reset]), fun() -> covers_data(Transport, Reset) end}
     || Transport <- [nif, port], Reset <- [snapshot, reload, auto]
    ].

covers_data(Transport, Reset) ->
    Lib = cb_sut:start("plain_state.c", [{transport, Transport}, {reset, Reset}]),
    ?assertEqual([], maps:get(warnings, cb:info(Lib))),
    [
        begin
            ?assertEqual(1, cb:value_of(Lib, value)),
            ?assertEqual(1, cb:call(Lib, change, [])),
            ?assertEqual(2, cb:call(Lib, change, [])),
            ?assertEqual(4, cb:value_of(Lib, value)),
            ok = cb:restart(Lib)
        end
     || _ <- lists:seq(1, 20)
    ],
    ok = cb:stop(Lib).

calls_test_() ->
    [{atom_to_list(Transport), fun() -> by_calls(Transport) end} || Transport <- [nif, port]].

by_calls(Transport) ->
    Reset = {calls, [{set_up, [5]}]},
    Lib = cb_sut:start("plain_state.c", [{transport, Transport}, {reset, Reset}]),
    %% The calls are part of the state after start.
    ?assertEqual(5, cb:value_of(Lib, value)),
    ?assertEqual(1, cb:call(Lib, change, [])),
    Pointer = cb:create_array(Lib, int, [1]),
    ok = cb:restart(Lib),
    ?assertEqual(5, cb:value_of(Lib, value)),
    %% What the calls do not set stays.
    ?assertEqual(2, cb:call(Lib, change, [])),
    ?assertEqual({stale_pointer, Pointer}, cb_sut:reason(fun() -> cb:read(Lib, Pointer, 1) end)),
    ok = cb:stop(Lib).

a_failing_call_of_the_reset_is_an_error_of_start_test_() ->
    [
        {atom_to_list(Transport), fun() ->
            ?assertMatch(
                {error, {batch, 1, [], {unknown_function, set_upp, _}}},
                cb:start(resets, [
                    {c_src, cb_sut:source("plain_state.c")},
                    {cache_dir, cb_sut:cache()},
                    {transport, Transport},
                    {reset, {calls, [{set_upp, [5]}]}}
                ])
            )
        end}
     || Transport <- [nif, port]
    ].

none_test_() ->
    [{atom_to_list(Transport), fun() -> keeps_state(Transport) end} || Transport <- [nif, port]].

keeps_state(Transport) ->
    Lib = cb_sut:start("plain_state.c", [{transport, Transport}, {reset, none}]),
    ?assertMatch([_], maps:get(warnings, cb:info(Lib))),
    1 = cb:call(Lib, change, []),
    ok = cb:restart(Lib),
    ?assertEqual(2, cb:call(Lib, change, [])),
    ok = cb:stop(Lib).

a_snapshot_that_does_not_cover_the_state_is_warned_of_test_() ->
    [
        {atom_to_list(Transport), fun() ->
            Lib = cb_sut:start("state.c", [{transport, Transport}, {reset, snapshot}]),
            ?assertMatch(#{method := snapshot, warnings := [_ | _]}, cb:info(Lib)),
            ok = cb:stop(Lib)
        end}
     || Transport <- [nif, port]
    ].

auto_in_nif_takes_reload_when_a_snapshot_would_not_do_test() ->
    Lib = cb_sut:start("state.c", [{transport, nif}]),
    ?assertMatch(#{method := reload}, cb:info(Lib)),
    ok = cb:stop(Lib).

fork_and_respawn_need_a_port_test_() ->
    [
        ?_assertEqual(
            {error, {reset, Reset, not_in_nif}},
            cb:start(resets, [
                {c_src, cb_sut:source("state.c")},
                {cache_dir, cb_sut:cache()},
                {transport, nif},
                {reset, Reset}
            ])
        )
     || Reset <- [fork, respawn]
    ].

%% A pointer of a process that is gone does not point into the next one.
pointers_are_stale_after_any_reset_test_() ->
    [
        {lists:concat([Transport, " ", Reset]), fun() ->
            Lib = cb_sut:start("plain_state.c", [{transport, Transport}, {reset, Reset}]),
            Pointer = cb:create_array(Lib, int, [1]),
            ok = cb:restart(Lib),
            _ = cb:create_array(Lib, int, [2]),
            ?assertEqual(
                {stale_pointer, Pointer}, cb_sut:reason(fun() -> cb:read(Lib, Pointer, 1) end)
            ),
            ok = cb:stop(Lib)
        end}
     || {Transport, Reset} <- [
            {nif, snapshot},
            {nif, reload},
            {port, snapshot},
            {port, reload},
            {port, fork},
            {port, respawn}
        ]
    ].

forced_test_() ->
    {setup, fun() -> ok end,
        fun(_) -> [application:unset_env(c_bridge, K) || K <- [force_transport, force_reset]] end, [
            fun the_runner_confirms_under_port_and_fork/0
        ]}.

%% As a failure of a `nif' model is confirmed: another process for each test, the same state.
the_runner_confirms_under_port_and_fork() ->
    ok = application:set_env(c_bridge, force_transport, port),
    ok = application:set_env(c_bridge, force_reset, fork),
    Lib = cb_sut:start("plain_state.c", [{transport, nif}, {reset, {calls, [{set_up, [5]}]}}]),
    ?assertMatch(#{transport := port, method := fork}, cb:info(Lib)),
    ?assertEqual(5, cb:value_of(Lib, value)),
    1 = cb:call(Lib, change, []),
    ok = cb:restart(Lib),
    ?assertEqual(1, cb:call(Lib, change, [])),
    ok = cb:stop(Lib).

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

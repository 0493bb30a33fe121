%% @doc For tests: command sequences of the copters' model.
-module(copter_test_commands).

-export([of_calls/1]).

-spec of_calls([{atom(), [term()]}]) -> [faultcheck_generator:command()].
of_calls(Calls) ->
    Numbers = lists:seq(1, length(Calls)),
    [{set, {var, N}, {call, copter_eqc, F, Args}} || {N, {F, Args}} <- lists:zip(Numbers, Calls)].

-module(copter_stored_tests).
-include_lib("eunit/include/eunit.hrl").

%% Each still makes copters collide with the original's parameters, here and as a scenario.
every_counterexample_still_collides_test_() ->
    {setup, fun() -> {ok, _} = application:ensure_all_started(c_bridge) end,
        fun(_) -> copter_sut:stop() end,
        [{Name, fun() -> collides(Name, Options, Commands) end}
         || {Name, Options, Commands} <- copter_stored:all()]}.

collides(Name, Options, Commands) ->
    {collision, _} = Result = copter_trial:rerun(Options, Commands),
    Trace = copter_test_scenario:fly(Options, Commands),
    ?assertEqual(
        copter_test_scenario:compared({run, Result}), copter_test_scenario:compared({trace, Trace})
    ),
    %% The scenario beside it is that of the sequence.
    File = filename:join([code:priv_dir(copter_eqc), "counterexamples", Name ++ ".json"]),
    {ok, Stored} = file:read_file(File),
    Json = copter_scenario:from_commands(Commands, Options, [{name, list_to_binary(Name)}]),
    ?assertEqual(Stored, faultcheck_json:pretty(Json)).

there_are_counterexamples_test() ->
    ?assert(length(copter_stored:all()) >= 4).

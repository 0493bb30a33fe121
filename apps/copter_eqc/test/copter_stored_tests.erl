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

%% It is what is left of the test that its file names, up to the collision.
an_origin_is_the_test_that_is_named_test_() ->
    [{Name, fun() -> is_part_of_its_test(Options, Commands, copter_stored:origin(Name)) end}
     || {Name, Options, Commands} <- copter_stored:all(), copter_stored:origin(Name) =/= none].

is_part_of_its_test(Options, Commands, #{seed := Seed, test := Test, commands := Number}) ->
    Original = calls(copter_trial:commands(Options, Seed, Test)),
    ?assertEqual(Number, length(Original)),
    ?assertEqual([], calls(Commands) -- Original).

calls(Commands) -> [{F, Args} || {set, _, {call, copter_eqc, F, Args}} <- Commands].

the_example_has_an_origin_test() ->
    {ok, Example} = copter_view:open(example),
    ?assertMatch(
        #{case_id := <<"crowd_with_faults">>, ncmd_original := 48,
          seed := <<"20250401, test 1014">>},
        copter_view:info(Example)
    ).

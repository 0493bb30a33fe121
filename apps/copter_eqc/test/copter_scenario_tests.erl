-module(copter_scenario_tests).
-include_lib("eunit/include/eunit.hrl").

scenario(Changes, Calls) ->
    Commands = copter_test_commands:of_calls(Calls),
    Json = copter_scenario:from_commands(Commands, copter_options:new(Changes), [{name, test}]),
    {ok, Scenario} = faultcheck_json:decode(faultcheck_json:encode(Json)),
    Scenario.

times_and_commands_are_those_of_the_sequence_test() ->
    Scenario = scenario(#{}, [
        {add_copter, [3, 150, -200]}, {iterate, [1003]}, {steer, [3, 150, -75, 900]},
        {iterate, [500]}
    ]),
    #{
        <<"format">> := <<"coptersim-scenario/1">>,
        <<"dt_us">> := 5000,
        %% whole steps: 1003 ms are 200 of them
        <<"duration_us">> := 1500000,
        <<"its_div">> := 20,
        <<"copters">> := [#{<<"id">> := 3, <<"pos">> := [1.5, -2.0]}],
        <<"events">> := [Command]
    } = Scenario,
    ?assertEqual(
        #{<<"t_us">> => 1000000, <<"type">> => <<"command">>, <<"copter">> => 3,
          <<"roll">> => 0.609, <<"pitch">> => -0.3045, <<"yaw">> => 0.6},
        Command
    ).

windows_of_faults_are_durations_test() ->
    #{<<"events">> := Events} = scenario(#{}, [
        {add_copter, [0, 0, 0]},
        {iterate, [100]},
        {fault_jump, [0, x, 1500]},
        {fault_reflection, [0, 2, 2000, {scattered, 100}, 99]},
        {fault_loss, [0, {ms, 200}]},
        {fault_clear, []}
    ]),
    At = #{<<"t_us">> => 100000},
    ?assertEqual(
        [
            At#{<<"type">> => <<"fault">>, <<"probe">> => <<"PxId0">>, <<"model">> => <<"offset">>,
                <<"value">> => 1.5, <<"duration_us">> => 5000},
            At#{<<"type">> => <<"fault">>, <<"probe">> => <<"RangeId0Anch2">>,
                <<"model">> => <<"random_offset">>, <<"low">> => 0.5, <<"high">> => 2.0,
                <<"probability">> => 0.1, <<"seed">> => 99},
            At#{<<"type">> => <<"packet_fault">>, <<"channel">> => <<"ITS_DATA0">>,
                <<"model">> => <<"lose">>, <<"duration_us">> => 200000},
            At#{<<"type">> => <<"clear_faults">>}
        ],
        Events
    ).

gains_and_parameters_have_places_of_their_own_test() ->
    Scenario = scenario(#{set => #{pos_p => 0.3, base_radius => 1.5, gate => 2}}, []),
    ?assertEqual(#{<<"pos_p">> => 0.3}, maps:get(<<"gains">>, Scenario)),
    ?assertEqual(#{<<"base_radius">> => 1.5, <<"gate">> => 2}, maps:get(<<"params">>, Scenario)).

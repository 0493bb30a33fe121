-module(copter_fault_tests).
-include_lib("eunit/include/eunit.hrl").

%% Each fault, with any arguments, is one that the library would accept.
every_fault_is_valid_test_() ->
    [
        {atom_to_list(Kind) ++ " " ++ atom_to_list(Ranges), fun() ->
            [check(Kind, Args) || Args <- arguments(Kind, Ranges, 30)]
        end}
     || Kind <- copter_fault:kinds(), Ranges <- [default, mild]
    ].

arguments(Kind, Ranges, N) ->
    faultcheck_proper:with_state(10, {1, 2, 3}, fun() ->
        Types = copter_fault:args(Kind, Ranges, [0, 1, 2, 3]),
        On = [2 || Kind =/= anchor],
        [
            begin
                {ok, Args} = faultcheck_proper:generate(Types),
                On ++ faultcheck_proper:clean(Args)
            end
         || _ <- lists:seq(1, N)
        ]
    end).

check(Kind, Args) ->
    Armed = copter_fault:arming(Kind, Args, [0, 2]),
    ?assertNotEqual([], Armed),
    [?assertEqual(ok, faultcheck_fault:validate(Fault)) || {_, Fault, _} <- Armed].

names_are_those_of_the_simulator_test() ->
    Where = fun(Kind, Args) -> [W || {W, _, _} <- copter_fault:arming(Kind, Args, [0, 7])] end,
    ?assertEqual([{probe, <<"RollId3">>}], Where(misalignment, [3, roll, 1])),
    ?assertEqual([{probe, <<"YawId3">>}], Where(drift, [3, yaw, 1])),
    ?assertEqual([{probe, <<"PyId3">>}], Where(jump, [3, y, 1])),
    ?assertEqual([{channel, <<"ITS_DATA3">>}], Where(loss, [3, {packets, 2}])),
    ?assertEqual(
        [{probe, <<"RangeId3Anch1">>}], Where(reflection, [3, 1, 900, {scattered, 50}, 4711])
    ),
    %% for all copters alike
    ?assertEqual(
        [{probe, <<"AnchXId0Anch2">>}, {probe, <<"AnchXId7Anch2">>}], Where(anchor, [2, x, 100])
    ).

a_jump_lasts_one_step_test() ->
    ?assertEqual(
        [{{probe, <<"PxId0">>}, {{offset, 1.5}, [{for, 1}]}, none}],
        copter_fault:arming(jump, [0, x, 1500], [0])
    ).

a_reflection_only_adds_to_a_range_test() ->
    [{_, {{random_offset, Low, High}, Trigger}, Seed}] =
        copter_fault:arming(reflection, [0, 1, 8000, {lasting, 3000}, 77], [0]),
    ?assertEqual({0.5, 8.0, 77}, {Low, High, Seed}),
    ?assertEqual([{time, 0, 3000000000}], Trigger).

air_moves_in_gusts_for_the_window_test() ->
    [{{probe, <<"RollId0">>}, {Gusts, Trigger}, 5}] =
        copter_fault:arming(air, [0, roll, 4000, 300, 1000, 5], [0]),
    ?assertEqual({held_offset, -4.0, 4.0, 300000000}, Gusts),
    ?assertEqual([{time, 0, 1000000000}], Trigger).

the_same_fault_has_the_same_place_test() ->
    Same = fun(Kind, A, B) -> copter_fault:place(Kind, A) =:= copter_fault:place(Kind, B) end,
    ?assert(Same(misalignment, [1, roll, 5], [1, roll, 9])),
    ?assertNot(Same(misalignment, [1, roll, 5], [1, pitch, 5])),
    ?assertNot(Same(misalignment, [1, roll, 5], [2, roll, 5])),
    ?assert(Same(loss, [1, {ms, 100}], [1, {packets, 3}])),
    ?assertNot(Same(reflection, [1, 2, 0, 0, 0], [1, 3, 0, 0, 0])),
    ?assert(Same(anchor, [1, x, 5], [1, x, 9])).

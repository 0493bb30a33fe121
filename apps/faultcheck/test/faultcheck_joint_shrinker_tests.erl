%% A command goes while a value that depended on it moves by one bit.
-module(faultcheck_joint_shrinker_tests).

-include_lib("eunit/include/eunit.hrl").

%% 91 differs from 85 in three bits.
three_flips_shrink_to_one_test() ->
    Flips = [{bit_flip, [0, 1]}, {bit_flip, [0, 2]}, {bit_flip, [0, 3]}],
    Shrunk = minimise(Flips ++ [{sensor, [[91, 170]]}, {sensor, [[91, 170]]}]),
    ?assertMatch([{bit_flip, [0, _]}, {sensor, [[X, 170]]}, {sensor, [[X, 170]]}], Shrunk).

only_values_that_the_generators_give_are_tried_test() ->
    Commands = commands([{bit_flip, [0, 1]}, {repetition, [1]}, {sensor, [[91, 170]]}]),
    Tried = [{Name, Args} || Candidate <- faultcheck_joint_shrinker:candidates(bag_model, Commands),
                             {set, _, {call, _, Name, Args}} <- Candidate],
    ?assertEqual([], [Args || {sensor, [[_, B]] = Args} <- Tried, B =/= 170]),
    ?assertEqual([], [N || {repetition, [N]} <- Tried, N > 3]),
    ?assertEqual(8, length(lists:usort([X || {sensor, [[X, _]]} <- Tried, X =/= 91]))).

long_sequences_are_left_alone_test() ->
    Commands = commands(lists:duplicate(11, {sensor, [[1, 170]]})),
    ?assertEqual([], faultcheck_joint_shrinker:candidates(bag_model, Commands)).

commands(Calls) ->
    [{set, {var, N}, {call, bag_model, Name, Args}}
     || {N, {Name, Args}} <- lists:zip(lists:seq(1, length(Calls)), Calls)].

minimise(Calls) ->
    Failure = #{kind => unknown, at => unknown},
    Options = faultcheck_shrinker:options(#{}),
    #{shrunk := Shrunk, minimal := true} =
        model_lab:isolated(
          fun() ->
                  faultcheck_proper:with_state(
                    20, {1, 2, 3},
                    fun() ->
                            faultcheck_shrinker:minimise(bag_model, commands(Calls), #{}, fun run/1,
                                                         {Options, Failure})
                    end)
          end),
    [{Name, Args} || {set, _, {call, _, Name, Args}} <- Shrunk].

run(Commands) ->
    bag_model:reset(),
    case faultcheck_statem:run_commands(bag_model, Commands) of
        {_, _, ok} -> passes;
        _ -> {fails, unknown}
    end.

-module(faultcheck_perturb_tests).

-include_lib("eunit/include/eunit.hrl").

%% Arguments moved Count times from the same ones, with a fixed seed.
moved(Args, Types, Count) ->
    model_lab:isolated(fun() ->
        faultcheck_proper:with_state(10, {4, 5, 6}, fun() ->
            [faultcheck_perturb:arguments(Args, 0.3, Types) || _ <- lists:seq(1, Count)]
        end)
    end).

numbers_move_by_a_part_of_their_range_test() ->
    Moved = [V || [V] <- moved([0], [faultcheck_range:int(-1000, 1000)], 2000)],
    Inner = [V || V <- Moved, abs(V) < 1000],
    %% one of ten is a limit: 200 +- 5 standard deviations, and 0.1 % of the Gaussian steps
    ?assert(abs(2000 - length(Inner) - 202) < 70),
    Deviation = math:sqrt(lists:sum([V * V || V <- Inner]) / length(Inner)),
    %% 0.3 of 1000, cut at 1000
    ?assert(abs(Deviation - 300) < 20).

numbers_stay_in_their_range_and_move_test() ->
    Type = faultcheck_range:int(0, 3),
    ?assertEqual([0, 1, 3], lists:usort([V || [V] <- moved([2], [Type], 200)])),
    Reals = [V || [V] <- moved([0.5], [faultcheck_range:real(0, 1)], 200)],
    ?assert(lists:all(fun(V) -> V >= 0.0 andalso V =< 1.0 end, Reals)).

choices_stay_beside_numbers_and_are_redrawn_alone_test() ->
    Choice = proper_types:oneof([a, b, c]),
    Beside = moved([a, 5], [Choice, faultcheck_range:int(0, 9)], 100),
    ?assertEqual([a], lists:usort([C || [C, _] <- Beside])),
    Alone = moved([a], [Choice], 100),
    ?assertEqual([a, b, c], lists:usort([C || [C] <- Alone])).

indexes_are_redrawn_test() ->
    Index = faultcheck_range:index(0, 90, "byte"),
    ?assertEqual([40], lists:usort([I || [I, _] <-
        moved([40, 5], [Index, faultcheck_range:int(0, 9)], 50)])),
    Redrawn = [I || [I] <- moved([40], [Index], 300)],
    %% far as often as near, and a limit no more often than others: 2 of 91 are
    ?assert(length([I || I <- Redrawn, abs(I - 40) > 30]) > 50),
    ?assert(length([I || I <- Redrawn, I =:= 0 orelse I =:= 90]) < 25).

numbers_inside_lists_and_tuples_move_test() ->
    Types = [[proper_types:integer(0, 255), 170], {x, faultcheck_range:real(0, 1)}],
    Moved = moved([[85, 170], {x, 0.5}], Types, 50),
    ?assert(lists:all(fun([[A, 170], {x, R}]) -> A >= 0 andalso A =< 255 andalso is_float(R) end,
                      Moved)),
    ?assert(length(lists:usort([A || [[A, _], _] <- Moved])) > 10).

no_arguments_stay_none_test() ->
    ?assertEqual([[]], moved([], [], 1)).

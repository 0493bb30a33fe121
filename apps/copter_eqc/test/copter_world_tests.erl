-module(copter_world_tests).
-include_lib("eunit/include/eunit.hrl").

the_reference_world_is_that_of_the_paper_test() ->
    [First | _] = Lines = copter_world:lines(reference),
    ?assertEqual({1000, {-5.0, -5.0}, {5.0, -5.0}}, First),
    ?assertEqual([1000, 1001, 1002, 1003, 1004, 1005], [Id || {Id, _, _} <- Lines]),
    ?assertEqual({0, -8.0, -5.0, 1.0}, hd(copter_world:anchors(reference))).

%% 4 + 4 ceil(sqrt 10) = 20 m, anchors 1 m inside its corners.
a_box_has_room_for_its_copters_test() ->
    ?assertEqual({-10.0, -10.0, 10.0, 10.0}, copter_world:bounds({box, 10})),
    ?assertEqual({2, 9.0, 9.0, 2.0}, lists:nth(3, copter_world:anchors({box, 10}))),
    ?assertEqual({-4.0, -4.0, 4.0, 4.0}, copter_world:bounds({box, 1})).

clearance_is_the_distance_to_the_nearest_line_test() ->
    ?assertEqual(5.0, copter_world:clearance(reference, {0.0, 0.0})),
    ?assert(copter_world:clearance(reference, {7.9, 4.0}) < 0),
    %% to the line from (5,-5) to (8,0), which is 3 m to the right at this height
    ?assert(abs(copter_world:clearance(reference, {5.0, 0.0}) - 15 / math:sqrt(34)) < 1.0e-12).

copters_start_apart_from_lines_and_others_test() ->
    Free = fun(Place, Others) -> copter_world:free({box, 4}, Place, Others) end,
    ?assert(Free({4.5, 0.0}, [])),
    ?assertNot(Free({4.6, 0.0}, [])),
    ?assert(Free({0.0, 0.0}, [{2.6, 0.0}])),
    ?assertNot(Free({0.0, 0.0}, [{2.5, 0.0}])).

every_grid_fits_into_its_box_test() ->
    [?assertEqual(N, length(fitting(copter_world:grid(N, Seed), {box, N})))
     || {N, Seed} <- [{21, 0}, {25, 1}, {26, 7}, {200, 3}, {400, 4}]].

fitting(Copters, Box) ->
    [
        Id
     || {Id, Place} <- Copters,
        copter_world:free(Box, Place, [P || {Other, P} <- Copters, Other =/= Id])
    ].

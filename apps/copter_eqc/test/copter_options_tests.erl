-module(copter_options_tests).
-include_lib("eunit/include/eunit.hrl").

unknown_options_and_values_are_named_test() ->
    ?assertError({unknown_copter_options, [speed]}, copter_options:new(#{speed => 1})),
    ?assertError({bad_copter_options, [{world, box}]}, copter_options:new(#{world => box})),
    ?assertError(
        {bad_copter_options, [{configuration, hard}]}, copter_options:new(#{configuration => hard})
    ),
    ?assertError(
        {bad_copter_options, [{min_copters, 9}, {max_copters, 4}]},
        copter_options:new(#{min_copters => 9, max_copters => 4})
    ).

a_configuration_decides_what_is_not_given_test() ->
    ?assertMatch(#{its_ms := 50}, copter_options:new(#{configuration => fast_its})),
    ?assertMatch(#{its_ms := 20}, copter_options:new(#{configuration => fast_its, its_ms => 20})),
    Radii = copter_options:new(#{configuration => radii, set => #{base_radius => 3}}),
    ?assertEqual(#{comfort_radius => 0.9, base_radius => 3}, copter_options:values(Radii)).

worlds_have_a_fixed_number_of_copters_test() ->
    ?assertMatch(
        #{world := reference, min_copters := 4, max_copters := 4, max_faults := 0},
        copter_options:world('W1')
    ),
    ?assertMatch(#{min_copters := 10, max_faults := 3}, copter_options:world('W4')),
    ?assertEqual(9, length(copter_options:worlds())).

labels_say_what_differs_test() ->
    ?assertEqual(
        "reference world, 4 copters, at most 1 mild fault, default",
        copter_options:label(copter_options:world('W8'))
    ).

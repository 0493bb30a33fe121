-module(faultcheck_range_tests).

-include_lib("eunit/include/eunit.hrl").

%% The values of a type, in a process of its own.
drawn(Type, Count, Bias) ->
    model_lab:isolated(fun() ->
        faultcheck_proper:with_state(10, {1, 2, 3}, fun() ->
            faultcheck_range:with_bias(Bias, fun() ->
                [value(Type) || _ <- lists:seq(1, Count)]
            end)
        end)
    end).

value(Type) ->
    {ok, Imm} = faultcheck_proper:generate(Type),
    faultcheck_proper:clean(Imm).

values_are_uniform_over_the_whole_range_whatever_the_size_test() ->
    Values = drawn(faultcheck_range:int(-100000, 100000), 2000, 0),
    ?assert(lists:all(fun(V) -> is_integer(V) andalso abs(V) =< 100000 end, Values)),
    %% a quarter of them in each quarter: 500 +- 5 standard deviations
    Outer = length([V || V <- Values, V > 50000]),
    ?assert(abs(Outer - 500) < 100),
    Reals = drawn(faultcheck_range:real(2, 3), 1000, 0),
    ?assert(lists:all(fun(V) -> is_float(V) andalso V >= 2 andalso V =< 3 end, Reals)).

a_bias_gives_that_share_of_limits_test() ->
    Type = faultcheck_range:int(-15, 15),
    AtLimit = fun(Bias) -> length([V || V <- drawn(Type, 4000, Bias), abs(V) =:= 15]) end,
    %% 0.9 + 0.1 * 2/31 of 4000, 2/31 of 4000; +- 5 standard deviations
    ?assert(abs(AtLimit(0.9) - 3626) < 95),
    ?assert(abs(AtLimit(0) - 258) < 80),
    ?assertEqual(4000, AtLimit(1)).

both_limits_are_equally_likely_test() ->
    Low = length([V || V <- drawn(faultcheck_range:real(0, 1), 2000, 1), V == 0]),
    ?assert(abs(Low - 1000) < 112).

a_range_may_have_a_bias_of_its_own_or_none_test() ->
    Never = faultcheck_range:int(0, 1000000, #{boundary => false}),
    ?assertEqual([], [V || V <- drawn(Never, 100, 1), V =:= 0 orelse V =:= 1000000]),
    Always = faultcheck_range:int(0, 1000000, #{boundary => 1.0}),
    ?assertEqual([], [V || V <- drawn(Always, 100, 0), V =/= 0, V =/= 1000000]).

the_bias_of_the_run_counts_where_the_process_has_none_test() ->
    ok = application:set_env(faultcheck, boundary_bias, 0.5),
    ?assertEqual(0.5, faultcheck_range:bias()),
    ?assertEqual(0.25, faultcheck_range:with_bias(0.25, fun faultcheck_range:bias/0)),
    ok = application:unset_env(faultcheck, boundary_bias),
    ?assertEqual(0, faultcheck_range:bias()).

limits_are_in_the_type_test() ->
    Type = faultcheck_range:int(-15, 15, #{unit => "degree"}),
    ?assertMatch({ok, #{kind := int, min := -15, max := 15, unit := "degree"}},
                 faultcheck_range:limits(Type)),
    ?assertMatch({ok, #{kind := int, min := 3, max := 7}},
                 faultcheck_range:limits(proper_types:integer(3, 7))),
    ?assertMatch({ok, #{kind := real, min := 0.5, max := 7.0}},
                 faultcheck_range:limits(proper_types:float(0.5, 7))),
    ?assertEqual(none, faultcheck_range:limits(proper_types:integer())),
    ?assertEqual(none, faultcheck_range:limits(proper_types:oneof([1, 2]))),
    ?assertEqual(none, faultcheck_range:limits(7)).

wrong_options_are_named_test() ->
    ?assertError({range_option, bias, 1, _}, faultcheck_range:int(0, 1, #{bias => 1})),
    ?assertError({range_option, boundary, 2, _}, faultcheck_range:int(0, 1, #{boundary => 2})),
    ?assertError(function_clause, faultcheck_range:int(2, 1)).

%% The smallest failing value that PropEr reports.
shrunk(Type, Passes) ->
    Property = proper:forall(Type, Passes),
    {_, [Value], _} = model_lab:quickcheck(Property, [{numtests, 10000}]),
    Value.

integers_shrink_to_the_smallest_that_fails_test() ->
    ?assertEqual(7, shrunk(faultcheck_range:int(-15, 15), fun(V) -> V < 7 end)),
    ?assertEqual(-7, shrunk(faultcheck_range:int(-15, 15), fun(V) -> V > -7 end)),
    ?assertEqual(3, shrunk(faultcheck_range:int(3, 50), fun(_) -> false end)).

reals_shrink_to_round_values_test() ->
    ?assertEqual(0.0, shrunk(faultcheck_range:real(-1, 1), fun(_) -> false end)),
    Small = shrunk(faultcheck_range:real(0, 1), fun(V) -> V < 0.7 end),
    ?assert(Small >= 0.7 andalso Small < 0.7011),
    Low = shrunk(faultcheck_range:real(2, 20), fun(V) -> V < 5.5 end),
    ?assert(Low >= 5.5 andalso Low < 5.52).

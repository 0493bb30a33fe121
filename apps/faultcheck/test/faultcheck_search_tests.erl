-module(faultcheck_search_tests).

-include_lib("eunit/include/eunit.hrl").

%% A search for the cart of cart_model, in a process of its own.
search(Options) -> search(cart_model, Options).

search(Mod, Options) ->
    Base = #{begin_test => fun() -> cart_model:reset(100.0) end, max_runs => 3000},
    model_lab:isolated(fun() ->
        Result = faultcheck_search:search(Mod, maps:merge(Base, Options)),
        Held = [Ref || {{cart, Ref}, _} <- get()],
        {Result, length(Held)}
    end).

what_is_found_fails_and_the_same_seed_finds_the_same_test() ->
    {{found, #{commands := Commands, runs := Runs}} = First, _} = search(#{seed => 1}),
    ?assertEqual(First, element(1, search(#{seed => 1}))),
    ?assert(Runs > 1),
    Fails = model_lab:isolated(fun() ->
        ok = cart_model:reset(100.0),
        faultcheck_statem:run_commands(cart_model, Commands)
    end),
    ?assertMatch({_, _, {postcondition, false}}, Fails),
    {{found, #{commands := Others}}, _} = search(#{seed => 2}),
    ?assertNotEqual(Commands, Others).

%% Seeds 1 to 7; without boundary values, so that the search is all there is.
search_needs_fewer_runs_than_chance_test_() ->
    {timeout, 60, fun() ->
        Median = fun(Strategy) ->
            Runs = [
                maps:get(runs, element(2, element(1, search(#{
                    seed => Seed, strategy => Strategy, max_runs => 2000, bias => 0,
                    begin_test => fun() -> cart_model:reset(120.0) end
                }))))
             || Seed <- lists:seq(1, 7)
            ],
            lists:nth(4, lists:sort(Runs))
        end,
        ?assert(3 * Median(evolution) < Median(random))
    end}.

snapshots_save_time_and_change_nothing_else_test() ->
    {{_, With}, Held} = search(#{seed => 3, bias => 0}),
    {{_, Without}, 0} = search(#{seed => 3, bias => 0, snapshots => 0}),
    ?assertEqual(0, Held),
    ?assertEqual(maps:remove(simulated, Without), maps:remove(simulated, With)),
    ?assert(maps:get(simulated, With) < 0.9 * maps:get(simulated, Without)),
    ?assertEqual(maps:get(elapsed, Without), maps:get(simulated, Without)).

a_search_that_finds_nothing_has_the_nearest_and_its_cost_test() ->
    Far = #{begin_test => fun() -> cart_model:reset(1.0e6) end, max_runs => 137},
    {{not_found, Result}, Held} = search(Far),
    #{runs := Runs, value := Value, elapsed := Elapsed, key := Key} = Result,
    ?assertEqual(137, Runs),
    ?assertEqual(0, Held),
    %% 137 sequences of 20 s, the last command of each up to 1 s longer
    ?assert(Elapsed >= 137 * 20 andalso Elapsed =< 137 * 21),
    ?assert(Value < 1.0e6 - 60),
    ?assert(lists:member(Key, [left, right])).

a_boundary_bias_holds_during_the_search_only_test() ->
    {{_, #{commands := Commands}}, _} = search(#{bias => 1, max_runs => 20, strategy => random}),
    Pushes = [abs(V) || {set, _, {call, _, push, [V]}} <- Commands],
    ?assertEqual([10.0], lists:usort(Pushes)),
    ?assertEqual(0, faultcheck_range:bias()).

a_model_without_objective_is_the_callers_error_test() ->
    ?assertError({no_objective, bag_model, _},
                 faultcheck_search:search(bag_model, #{max_runs => 1})),
    ?assertMatch({found, #{outcome := {postcondition, false}, value := worst}},
                 model_lab:isolated(fun() ->
                     faultcheck_search:search(bag_model, #{
                         strategy => random, begin_test => fun bag_model:reset/0
                     })
                 end)).

an_objective_that_is_no_number_is_a_failure_test() ->
    {{found, #{outcome := Outcome, value := Value}}, _} = search(nan_model, #{}),
    ?assertEqual({objective, {nan, now, none}}, Outcome),
    ?assertEqual(worst, Value).

%% PropEr generates from the process's random state, commands of a model may draw from it too.
commands_that_draw_random_numbers_do_not_disturb_test() ->
    Noisy = fun() ->
        _ = rand:uniform(erlang:unique_integer([positive])),
        cart_model:reset(100.0)
    end,
    {{_, Quiet}, _} = search(#{seed => 5}),
    {{_, Disturbed}, _} = search(#{seed => 5, begin_test => Noisy}),
    ?assertEqual(Quiet, Disturbed).

options_are_checked_test() ->
    ?assertError({search_options, {unknown, [runs]}, _},
                 faultcheck_search_options:new(#{runs => 1})),
    ?assertError({search_options, {wrong, [{bias, 2}]}},
                 faultcheck_search_options:new(#{bias => 2})),
    ?assertMatch(#{lookback := 1.5}, faultcheck_search_options:new(#{})),
    ?assertMatch(#{lookback := 7}, faultcheck_search_options:new(#{lookback => 7})).

%% ---- as a property --------------------------------------------------------------------------

property(Options) ->
    Reset = fun() -> cart_model:reset(100.0) end,
    faultcheck_search:property(cart_model, maps:merge(#{begin_test => Reset}, Options)).

a_property_fails_with_what_a_search_finds_and_shrinks_it_test_() ->
    {timeout, 60, fun() ->
        {Result, [Commands], Shrink} =
            model_lab:quickcheck(property(#{bias => 0.9}), [{numtests, 1}]),
        ?assertEqual(false, Result),
        ?assertMatch(#{minimal := true, flaky := false}, Shrink),
        ?assert(length(Commands) < length(maps:get(original, Shrink))),
        ?assertEqual(none, model_lab:not_minimal(cart_model, Commands))
    end}.

a_property_passes_when_no_search_finds_anything_test() ->
    Far = #{begin_test => fun() -> cart_model:reset(1.0e6) end, max_runs => 60},
    Passed = model_lab:isolated(fun() ->
        true = proper:quickcheck(property(Far), [quiet, {numtests, 3}]),
        faultcheck_search:last()
    end),
    ?assertMatch(#{runs := 60}, Passed).

a_property_fails_where_the_objective_is_no_number_test() ->
    {Result, [Commands], _} =
        model_lab:quickcheck(faultcheck_search:property(nan_model, #{}), [{numtests, 1}]),
    ?assertEqual(false, Result),
    ?assertMatch([{set, _, {call, _, spoil, _}}], Commands).

%% What another process found is not searched again.
a_search_can_be_told_to_another_process_test() ->
    Type = faultcheck_search:commands(cart_model, #{
        max_runs => 50, begin_test => fun() -> put(runs, count() + 1), cart_model:reset(100.0) end
    }),
    Generate = fun() ->
        faultcheck_proper:with_state(10, {7, 8, 9}, fun() ->
            {ok, Imm} = faultcheck_proper:generate(Type),
            {faultcheck_proper:clean(Imm), rand:uniform(), count()}
        end)
    end,
    {{Commands, Next, Runs}, Found} =
        model_lab:isolated(fun() -> {Generate(), faultcheck_search:found()} end),
    ?assert(Runs > 0),
    Told = model_lab:isolated(fun() ->
        ok = faultcheck_search:remember(Found),
        Generate()
    end),
    ?assertEqual({Commands, Next, 0}, Told).

count() ->
    case get(runs) of
        undefined -> 0;
        N -> N
    end.

%% A test for each internal of PropEr that faultcheck_proper relies on.
-module(faultcheck_proper_tests).

-include_lib("eunit/include/eunit.hrl").
-undef(LET). % EUnit has one of its own
-include_lib("proper/include/proper_common.hrl").

-import(faultcheck_proper, [cook/1, shrink/3, number_state/1, set_number/2, end_number/1]).

with(Fun) ->
    model_lab:isolated(fun() -> faultcheck_proper:with_state(10, {1, 2, 3}, Fun) end).

a_type_of_its_own_generates_through_its_function_test() ->
    Type = faultcheck_proper:new_type(fun(Size) -> {'$used', fun() -> Size end, [Size]} end,
                                      fun(_) -> true end, fun(_, _, _) -> {[], done} end,
                                      fun(Base) -> Base end),
    ?assertEqual([10], with(fun() ->
                                    {ok, Imm} = faultcheck_proper:generate(Type),
                                    faultcheck_proper:clean(Imm)
                            end)).

proper_adds_no_shrinkers_to_it_test() ->
    Type = faultcheck_proper:new_type(fun(_) -> [a, b] end, fun(_) -> true end,
                                      fun(_, _, _) -> {[], done} end, fun(Base) -> Base end),
    {[], Next} = proper_shrink:shrink([a, b], Type, init),
    ?assertEqual({[], done}, proper_shrink:shrink([a, b], Type, Next)).

a_shrinker_is_told_what_was_accepted_test() ->
    Shrinker = fun(_, _, init) -> {[[1], [2]], waiting};
                  (_, _, State) -> {[], {told, State}}
               end,
    Type = faultcheck_proper:new_type(fun(_) -> [] end, fun(_) -> true end, Shrinker,
                                      fun(Base) -> Base end),
    {[[1], [2]], State} = proper_shrink:shrink([0], Type, init),
    ?assertMatch({[], {shrinker, _, _, {told, waiting}}}, proper_shrink:shrink([0], Type, State)),
    ?assertMatch({[], {shrinker, _, _, {told, {shrunk, 2, waiting}}}},
                 proper_shrink:shrink([2], Type, {shrunk, 2, State})).

impossible_types_are_an_error_test() ->
    Never = ?SUCHTHAT(X, proper_types:integer(), X =:= nothing),
    ?assertEqual(error, with(fun() -> faultcheck_proper:generate(Never) end)).

cleaning_keeps_the_value_test() ->
    ?assertEqual([1, {2, c}],
                 faultcheck_proper:clean([1, {'$used', [parts], {2, {'$used', x, c}}}])).

side_data_survives_beside_the_value_test() ->
    Imm = faultcheck_proper:with_side([a], #{1 => b}),
    ?assertEqual({ok, #{1 => b}}, faultcheck_proper:side(Imm)),
    ?assertEqual([a], faultcheck_proper:clean(Imm)),
    ?assertEqual(none, faultcheck_proper:side([a])),
    ?assertEqual(false, proper_types:is_raw_type(Imm)).

equal_values_with_side_data_differ_test() ->
    ?assertNotEqual(faultcheck_proper:with_side([a], x), faultcheck_proper:with_side([a], x)).

a_list_of_types_cooks_to_a_fixed_list_test() ->
    Type = cook([proper_types:integer(), exactly]),
    ?assert(proper_types:is_instance([5, exactly], Type)),
    ?assertNot(proper_types:is_instance([5], Type)),
    {[[0, exactly]], _} = shrink_until([7, exactly], Type).

%% The first step that offers anything.
shrink_until(Imm, Type) -> shrink_until(Imm, Type, init).
shrink_until(Imm, Type, State) ->
    case shrink(Imm, Type, State) of
        {[], Next} when Next =/= done -> shrink_until(Imm, Type, Next);
        Found -> Found
    end.

shrinkers_that_raise_end_test() ->
    ?assertEqual({[], done}, shrink(5, not_a_type, init)).

number_state_is_found_at_any_depth_test_() ->
    Int = proper_types:integer(0, 1000),
    [{Name, ?_assertMatch({0, 1, 500},
                          begin {_, S} = shrink_until(Imm, cook(Type)), number_state(S) end)}
     || {Name, Imm, Type} <-
            [{"alone", 500, Int},
             {"in an argument list", [a, 500], [a, Int]},
             {"in a tuple in a list", [{500}], [{Int}]},
             {"part of a ?LET", {'$used', 500, {500}}, ?LET(X, Int, {X})}]].

number_state_in_a_union_is_found_test() ->
    Type = cook(proper_types:union([proper_types:atom(), proper_types:integer(0, 1000)])),
    {_, State} = with(fun() -> after_alternatives(500, Type, init) end),
    ?assertMatch({0, 1, 500}, number_state(State)).

after_alternatives(Imm, Type, State) ->
    case shrink(Imm, Type, State) of
        {[0], _} = Found -> Found;
        {_, Next} -> after_alternatives(Imm, Type, Next)
    end.

steps_left_are_counted_down_and_up_test() ->
    Down = cook(proper_types:integer(-1000, -10)),
    {[-10], State} = shrink_until(-77, Down),
    ?assertEqual({-10, -1, 67}, number_state(State)),
    {[+0.0], Float} = shrink_until(3.75, cook(proper_types:float())),
    ?assertEqual({0.0, 1.0, 3}, number_state(Float)).

no_number_no_state_test() ->
    ?assertEqual(none, number_state(done)),
    ?assertEqual(none, number_state({shrinker, [], dummy, init})).

a_set_number_is_the_next_candidate_test() ->
    Type = cook([{proper_types:integer(0, 1000)}]),
    {_, State} = shrink_until([{500}], Type),
    ?assertMatch({[[{123}]], _}, shrink([{500}], Type, set_number(State, 123))).

an_ended_number_gives_way_to_the_next_one_test() ->
    Int = proper_types:integer(0, 1000),
    Type = cook([Int, Int]),
    {[[0, 6]], State} = shrink_until([5, 6], Type),
    {[[5, 0]], _} = shrink_until([5, 6], Type, end_number(State)).

uniform_integers_shrink_like_numbers_test() ->
    Type = cook(faultcheck_statem:uniform(10, 1 bsl 40)),
    {[10], State} = shrink_until(1 bsl 39, Type),
    ?assertEqual({10, 1, (1 bsl 39) - 10}, number_state(State)),
    ?assert(proper_types:is_instance(1 bsl 40, Type)),
    ?assertNot(proper_types:is_instance(9, Type)).

uniform_integers_ignore_the_size_test() ->
    Type = faultcheck_statem:uniform(0, 1 bsl 40),
    Values = with(fun() -> [begin {ok, V} = faultcheck_proper:generate(Type), V end
                            || _ <- lists:seq(1, 200)] end),
    ?assert(lists:max(Values) > 1 bsl 39),
    ?assert(lists:min(Values) >= 0).

the_size_is_multiplied_test() ->
    Type = faultcheck_proper:new_type(fun(Size) -> [Size] end, fun(_) -> true end,
                                      fun(_, _, _) -> {[], done} end, fun(B) -> B end),
    Resized = faultcheck_statem:more_commands(3, Type),
    ?assertEqual([30], with(fun() ->
                                    {ok, Imm} = faultcheck_proper:generate(Resized),
                                    faultcheck_proper:clean(Imm)
                            end)),
    ?assertEqual(10, with(fun faultcheck_proper:size/0)).

the_same_seed_gives_the_same_values_test() ->
    Draw = fun() -> faultcheck_proper:generate(proper_types:list(proper_types:integer())) end,
    ?assertEqual(with(Draw), with(Draw)).

the_random_state_is_as_before_test() ->
    _ = rand:seed(exsss, 7),
    Before = rand:export_seed(),
    First = faultcheck_proper:preserving_random(a, fun() -> rand:uniform(1000000) end),
    ?assertEqual(Before, rand:export_seed()),
    ?assertEqual(First, faultcheck_proper:preserving_random(a, fun() -> rand:uniform(1000000) end)),
    model_lab:isolated(fun() ->
                               faultcheck_proper:preserving_random(a, fun rand:uniform/0),
                               ?assertEqual(undefined, rand:export_seed())
                       end).

%% Targeted properties exist in PropEr 1.5 only; there, a search for long sequences has to find
%% one, and it has to shrink.
targeted_properties_search_and_shrink_test_() ->
    {timeout, 60, fun targeted/0}.

-ifdef(FORALL_TARGETED).
targeted() ->
    Property = ?FORALL_TARGETED(C, faultcheck_statem:commands(bag_model),
                                begin ?MAXIMIZE(length(C)), length(C) < 15 end),
    {false, [Commands], Summary} = model_lab:quickcheck(Property, [{search_steps, 10000}]),
    ?assertEqual(15, length(Commands)),
    ?assertMatch(#{minimal := true, shrunk := Commands}, Summary).
-else.
targeted() ->
    _ = code:ensure_loaded(proper_gen_next),
    ?assertNot(erlang:function_exported(proper_gen_next, set_user_nf, 2)).
-endif.

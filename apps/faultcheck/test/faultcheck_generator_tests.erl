-module(faultcheck_generator_tests).

-include_lib("eunit/include/eunit.hrl").

generated(Mod, Size, Count) -> generated(Mod, Size, Count, {1, 2, 3}).

generated(Mod, Size, Count, Seed) ->
    model_lab:isolated(
      fun() ->
              faultcheck_proper:with_state(
                Size, Seed,
                fun() -> [element(1, faultcheck_generator:generate(Mod, Size))
                          || _ <- lists:seq(1, Count)] end)
      end).

%% 2000 draws of 11 lengths: expectation 182 each, standard deviation 13.
lengths_are_uniform_from_none_to_size_test() ->
    Lengths = [length(C) || C <- generated(syn_model, 10, 2000)],
    Counts = [length([L || L <- Lengths, L =:= N]) || N <- lists:seq(0, 10)],
    ?assertEqual(2000, lists:sum(Counts)),
    ?assert(lists:min(Counts) > 182 - 5 * 13),
    ?assert(lists:max(Counts) < 182 + 5 * 13).

variables_are_numbered_from_one_test() ->
    [?assertEqual(lists:seq(1, length(C)), [N || {set, {var, N}, _} <- C])
     || C <- generated(bag_model, 20, 50)].

preconditions_hold_test() ->
    [?assertEqual(C, faultcheck_repair:repair(Mod, C))
     || Mod <- [chain_model, bag_model, odd_model], C <- generated(Mod, 30, 100)].

weights_decide_how_often_test() ->
    Names = [Name || C <- generated(bag_model, 30, 300), {set, _, {call, _, Name, _}} <- C],
    Count = fun(Name) -> length([N || N <- Names, N =:= Name]) end,
    %% 10 to 1, and explosion is always possible
    Ratio = Count(sensor) / Count(explosion),
    ?assert(Ratio > 8 andalso Ratio < 12.5).

weight_zero_is_never_chosen_test() ->
    Names = [Name || C <- generated(odd_model, 30, 100), {set, _, {call, _, Name, _}} <- C],
    ?assert(lists:member(fine, Names)),
    ?assertNot(lists:member(never, Names)).

arguments_that_a_precondition_rejects_are_chosen_again_test() ->
    Evens = [N || C <- generated(odd_model, 30, 100), {set, _, {call, _, even, [N]}} <- C],
    ?assertEqual([0, 2, 4, 6, 8], lists:usort(Evens)).

the_same_seed_gives_the_same_sequences_test() ->
    ?assertEqual(generated(syn_model, 20, 20), generated(syn_model, 20, 20)),
    ?assertNotEqual(generated(syn_model, 20, 20), generated(syn_model, 20, 20, {1, 2, 4})).

results_are_used_as_variables_test() ->
    Increments = [Var || C <- generated(chain_model, 30, 100),
                         {set, _, {call, _, incr, [Var, _]}} <- C],
    ?assertMatch([{var, _} | _], Increments).

neighbours_keep_a_part_and_are_legal_test() ->
    model_lab:isolated(
      fun() ->
              faultcheck_proper:with_state(
                20, {1, 2, 3},
                fun() ->
                        {Base, _} = faultcheck_generator:generate(chain_model, 20),
                        Near = [element(1, faultcheck_generator:mutate(chain_model, Base))
                                || _ <- lists:seq(1, 50)],
                        [?assertEqual(N, faultcheck_repair:repair(chain_model, N)) || N <- Near],
                        ?assert(lists:any(fun(N) -> lists:prefix(lists:sublist(Base, 3), N) end,
                                          Near))
                end)
      end).

-module(faultcheck_shrinker_tests).

-include_lib("eunit/include/eunit.hrl").

-define(UNKNOWN, #{kind => unknown, at => unknown}).

%% Shrinks a sequence with a function that says how it fails, or passes.
minimise(Mod, Commands, Options, Run) ->
    minimise(Mod, Commands, Options, ?UNKNOWN, Run).

minimise(Mod, Commands, Options, Failure, Run) ->
    model_lab:isolated(
      fun() ->
              faultcheck_proper:with_state(
                20, {1, 2, 3},
                fun() ->
                        All = faultcheck_shrinker:options(Options),
                        faultcheck_shrinker:minimise(Mod, Commands, #{}, Run, {All, Failure})
                end)
      end).

fails_if(Condition) ->
    fun(Commands) ->
            case Condition(Commands) of
                true -> {fails, unknown};
                false -> passes
            end
    end.

%% Arguments of one command of args_model in a sequence.
args(Commands, Name) ->
    [Args || {set, _, {call, args_model, N, Args}} <- Commands, N =:= Name].

%% A sequence of one command, shrunk while Condition holds for its arguments.
shrunk_args(Name, Args, Condition) ->
    Command = {set, {var, 1}, {call, args_model, Name, Args}},
    Test = fails_if(fun(C) -> lists:any(fun(A) -> apply(Condition, A) end, args(C, Name)) end),
    #{shrunk := [{set, {var, 1}, {call, args_model, Name, Shrunk}}], minimal := true,
      tries := Tries} = minimise(args_model, [Command], #{linear => 3}, Test),
    {Shrunk, Tries}.

%%% Arguments

a_large_number_is_bisected_test() ->
    {[1234567890123], Tries} =
        shrunk_args(wide, [17000000000000], fun(X) -> X >= 1234567890123 end),
    ?assert(Tries < 100).

numbers_shrink_towards_the_bound_next_to_zero_test() ->
    ?assertMatch({[-78], _}, shrunk_args(negative, [-5000], fun(X) -> X < -77 end)).

numbers_of_a_constrained_type_keep_the_constraint_test() ->
    {[1234568], _} = shrunk_args(even, [99999998], fun(X) -> X >= 1234567 end).

floats_shrink_to_whole_numbers_test() ->
    ?assertMatch({[4.0], _}, shrunk_args(real, [1000.7], fun(X) -> X > 3.25 end)).

alternatives_shrink_to_the_first_possible_one_test() ->
    ?assertMatch({[a], _}, shrunk_args(choice, [{pair, 6, true}], fun(_) -> true end)),
    ?assertMatch({[{pair, 6, false}], _},
                 shrunk_args(choice, [{pair, 900, true}],
                             fun({pair, X, _}) -> X >= 6; (_) -> false end)).

lists_lose_elements_test() ->
    ?assertMatch({[[[0, 0, 0]]], _},
                 shrunk_args(nested, [[[1, 2], [], [3, 4, 5, 6]]],
                             fun(L) -> lists:any(fun(X) -> length(X) >= 3 end, L) end)).

%% The linear values find what bisection jumps over: 7 and 107 fail, between them nothing.
a_failure_that_is_not_monotone_is_found_near_the_simplest_value_test() ->
    Command = {set, {var, 1}, {call, args_model, wide, [107]}},
    Test = fails_if(fun(C) -> lists:any(fun([X]) -> X rem 100 =:= 7 end, args(C, wide)) end),
    #{shrunk := [{set, _, {call, _, _, [7]}}]} = minimise(args_model, [Command], #{}, Test).

%% A ?LET is shrunk through its parts, which only the side data still has; PropEr's binaries
%% are made by one.
dependent_values_shrink_together_test() ->
    ?assertEqual([{3, [0, 0, 0]}], shrunk_generated(dependent, fun([{N, _}]) -> N >= 3 end)).

binaries_lose_bytes_test() ->
    ?assertEqual([<<0, 0>>], shrunk_generated(bytes, fun([B]) -> byte_size(B) >= 2 end)).

shrunk_generated(Name, Condition) ->
    Test = fails_if(fun(C) -> lists:any(Condition, args(C, Name)) end),
    #{shrunk := Shrunk, minimal := true} =
        model_lab:isolated(
          fun() ->
                  faultcheck_proper:with_state(
                    20, {5, 6, 7},
                    fun() ->
                            {Commands, Side} = generated(Test),
                            faultcheck_shrinker:minimise(args_model, Commands, Side, Test,
                                                         {faultcheck_shrinker:options(#{}),
                                                          ?UNKNOWN})
                    end)
          end),
    [{set, {var, 1}, {call, args_model, Name, Args}}] = Shrunk,
    Args.

generated(Test) ->
    {Commands, Side} = faultcheck_generator:generate(args_model, 20),
    case Test(Commands) of
        passes -> generated(Test);
        _ -> {Commands, Side}
    end.

%%% Sequences

bag(Names) ->
    [{set, {var, N}, {call, bag_model, Name, Args}}
     || {N, {Name, Args}} <- lists:zip(lists:seq(1, length(Names)), Names)].

the_rest_behind_the_failure_goes_first_test() ->
    Commands = bag([{sensor, [[0, 170]]} || _ <- lists:seq(1, 64)]),
    Test = fails_if(fun(C) -> length(C) >= 5 end),
    Failure = #{kind => unknown, at => 5},
    #{shrunk := Shrunk} = Summary = minimise(bag_model, Commands, #{confirm => 0}, Failure, Test),
    ?assertEqual(5, length(Shrunk)),
    %% without knowing the place, chunks have to find it
    #{tries := Tries} = minimise(bag_model, Commands, #{confirm => 0}, Test),
    ?assert(maps:get(tries, Summary) < Tries).

variables_are_renumbered_test() ->
    Commands = bag([{sensor, [[0, 170]]}, {bit_flip, [0, 0]}, {sensor, [[0, 170]]}]),
    Test = fails_if(fun(C) -> [ok || {set, _, {call, _, bit_flip, _}} <- C] =/= [] end),
    #{shrunk := [{set, {var, 1}, {call, bag_model, bit_flip, [0, 0]}}]} =
        minimise(bag_model, Commands, #{}, Test).

what_fails_without_commands_shrinks_to_nothing_test() ->
    #{shrunk := [], minimal := true} =
        minimise(bag_model, bag([{sensor, [[0, 170]]}]), #{}, fails_if(fun(_) -> true end)),
    #{shrunk := [], minimal := true} =
        minimise(bag_model, [], #{}, fails_if(fun(_) -> true end)).

no_candidate_is_tried_twice_test() ->
    Seen = ets:new(seen, [public, bag]),
    {Commands, _} = model_lab:isolated(fun() -> model_lab:failing(syn_model, 60, 1) end),
    Run = fun(C) -> ets:insert(Seen, {C, make_ref()}), model_lab:verdict(syn_model, C) end,
    #{tries := Tries} = minimise(syn_model, Commands, #{confirm => 0}, Run),
    Keys = [C || {C, _} <- ets:tab2list(Seen)],
    ?assertEqual(Tries, length(Keys)),
    ?assertEqual(length(Keys), length(lists:usort(Keys))).

%%% Other failures

%% The first sequence alone ends in a crash, all shorter ones only in a false postcondition.
a_different_failure_is_not_the_same_made_smaller_test() ->
    Commands = bag([{sensor, [[0, 170]]} || _ <- lists:seq(1, 4)]),
    Run = fun(C) when length(C) =:= 4 -> {fails, {error, {cb, crash}}};
             (_) -> {fails, postcondition}
          end,
    Failure = #{kind => {error, {cb, crash}}, at => unknown},
    #{shrunk := Shrunk, minimal := true} = minimise(bag_model, Commands, #{}, Failure, Run),
    ?assertEqual(4, length(Shrunk)).

%% A memory error may show in two ways; then both count.
a_failure_of_changing_kind_shrinks_by_any_test() ->
    Commands = bag([{sensor, [[0, 170]]} || _ <- lists:seq(1, 4)]),
    Runs = counters:new(1, []),
    Run = fun([]) -> passes;
             (_) ->
                  counters:add(Runs, 1, 1),
                  {fails, lists:nth(1 + counters:get(Runs, 1) rem 2, [crash, postcondition])}
          end,
    Failure = #{kind => crash, at => unknown},
    #{shrunk := [_], minimal := true} = minimise(bag_model, Commands, #{}, Failure, Run).

%%% Flaky failures, budgets

a_failure_that_passes_once_is_flaky_and_not_shrunk_test() ->
    Commands = bag([{sensor, [[0, 170]]} || _ <- lists:seq(1, 8)]),
    Runs = counters:new(1, []),
    Run = fun(_) ->
                  counters:add(Runs, 1, 1),
                  case counters:get(Runs, 1) rem 4 of 0 -> passes; _ -> {fails, unknown} end
          end,
    Summary = minimise(bag_model, Commands, #{}, Run),
    ?assertMatch(#{flaky := {8, 10}, minimal := false, shrunk := Commands, original := Commands,
                   tries := 10, stopped := none}, Summary),
    ?assertEqual(10, counters:get(Runs, 1)).

a_failure_that_never_repeats_is_flaky_test() ->
    ?assertMatch(#{flaky := {0, 10}}, minimise(bag_model, bag([{sensor, [[0, 170]]}]), #{},
                                               fun(_) -> passes end)).

max_tries_ends_shrinking_and_says_so_test() ->
    {Commands, _} = model_lab:isolated(fun() -> model_lab:failing(chain_model, 100, 3) end),
    Run = fun(C) -> model_lab:verdict(chain_model, C) end,
    #{shrunk := Shrunk} = Summary = minimise(chain_model, Commands, #{max_tries => 20}, Run),
    ?assertMatch(#{stopped := max_tries, minimal := false, tries := 20, flaky := false}, Summary),
    ?assertMatch({fails, _}, model_lab:verdict(chain_model, Shrunk)).

max_ms_ends_shrinking_and_says_so_test() ->
    Commands = bag([{sensor, [[0, 170]]} || _ <- lists:seq(1, 64)]),
    %% Passes time without sleeping: each run lasts until the clock has moved on.
    Run = fun(C) ->
                  wait_until(erlang:monotonic_time(millisecond) + 2),
                  case length(C) >= 20 of true -> {fails, unknown}; false -> passes end
          end,
    Summary = minimise(bag_model, Commands, #{max_ms => 4, confirm => 0}, Run),
    ?assertMatch(#{stopped := max_ms, minimal := false}, Summary),
    ?assert(maps:get(tries, Summary) =< 3).

wait_until(Time) ->
    case erlang:monotonic_time(millisecond) >= Time of
        true -> ok;
        false -> wait_until(Time)
    end.

unknown_options_and_wrong_values_are_the_callers_error_test() ->
    ?assertError({shrink_option, confrm, 1, {known, [confirm, linear, max_ms, max_tries]}},
                 faultcheck_shrinker:options(#{confrm => 1})),
    ?assertError({shrink_option, max_ms, -1, _}, faultcheck_shrinker:options(#{max_ms => -1})),
    ?assertError({shrink_option, linear, 0, _}, faultcheck_statem:commands(bag_model,
                                                                           #{linear => 0})).

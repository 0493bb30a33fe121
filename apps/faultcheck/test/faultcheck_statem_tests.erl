%% Command sequences under PropEr's own tools.
-module(faultcheck_statem_tests).

-include_lib("eunit/include/eunit.hrl").
-undef(LET). % EUnit has one of its own
-include_lib("proper/include/proper_common.hrl").

-import(faultcheck_statem, [commands/1, commands/2, command_names/1]).

%% Long sequences from the start: failures come early.
-define(MANY, {numtests, 100000}, {start_size, 40}).

ok(Commands) ->
    {_, _, Result} = model_lab:run(bag_model, Commands),
    Result =:= ok.

minimal(Commands) ->
    faultcheck_proper:with_state(10, {1, 2, 3},
                                 fun() -> model_lab:not_minimal(bag_model, Commands) end) =:= none.

a_failure_is_found_shrunk_and_described_test() ->
    {false, [Commands], Summary} =
        model_lab:quickcheck(model_lab:property(bag_model, #{}), [?MANY]),
    ?assertMatch(#{shrunk := Commands, minimal := true, stopped := none, flaky := false}, Summary),
    ?assert(length(maps:get(original, Summary)) >= length(Commands)),
    ?assert(model_lab:isolated(fun() -> minimal(Commands) end)),
    ?assertNot(ok(Commands)).

a_property_that_holds_shrinks_nothing_test() ->
    {true, undefined, undefined} =
        model_lab:quickcheck(?FORALL(C, commands(bag_model), is_list(C)), []).

%% Each wrapper as a property that fails, and the counterexample's sequence.
wrappers_test_() ->
    [{Name, {timeout, 60, fun() ->
                                  {false, Counterexample, #{shrunk := Shrunk, minimal := true}} =
                                      model_lab:quickcheck(Property, [?MANY]),
                                  Commands = Find(Counterexample),
                                  ?assertEqual(Commands, Shrunk),
                                  ?assert(model_lab:isolated(fun() -> minimal(Commands) end))
                          end}}
     || {Name, Property, Find} <- wrappers()].

wrappers() ->
    First = fun([C | _]) -> C end,
    [{"?WHENFAIL", ?FORALL(C, commands(bag_model), ?WHENFAIL(ok, ok(C))), First},
     {"aggregate", ?FORALL(C, commands(bag_model),
                           proper:aggregate(command_names(C), ok(C))), First},
     {"collect", ?FORALL(C, commands(bag_model), proper:collect(length(C), ok(C))), First},
     {"?TIMEOUT", ?FORALL(C, commands(bag_model), ?TIMEOUT(60000, ok(C))), First},
     {"?TRAPEXIT", ?FORALL(C, commands(bag_model), ?TRAPEXIT(ok(C))), First},
     {"?IMPLIES", ?FORALL(C, commands(bag_model), ?IMPLIES(true, ok(C))), First},
     {"conjunction", ?FORALL(C, commands(bag_model),
                             proper:conjunction([{good, true}, {bad, ok(C)}])), First},
     {"?FORALL inside", ?FORALL(C, commands(bag_model),
                                ?FORALL(_, proper_types:integer(), ok(C))), First},
     {"?FORALL outside", ?FORALL(_, proper_types:integer(),
                                 ?FORALL(C, commands(bag_model), ok(C))),
      fun([_, C]) -> C end},
     {"in a conjunction", proper:conjunction([{it, ?FORALL(C, commands(bag_model), ok(C))}]),
      fun([[{it, [C]}]]) -> C end},
     {"in a tuple", ?FORALL({C, _}, {commands(bag_model), proper_types:integer()}, ok(C)),
      fun([{C, _}]) -> C end},
     {"in a ?LET", ?FORALL({x, C}, ?LET(C, commands(bag_model), {x, C}), ok(C)),
      fun([{x, C}]) -> C end},
     {"in a ?SUCHTHAT", ?FORALL(C, ?SUCHTHAT(C, commands(bag_model), is_list(C)), ok(C)), First},
     {"in a union", ?FORALL(C, proper_types:union([commands(bag_model)]), ok(C)), First},
     {"longer", ?FORALL(C, faultcheck_statem:more_commands(3, commands(bag_model)), ok(C)),
      First}].

%% The time limit itself as the failure: it repeats, and shrinks to the command that waits.
a_time_out_is_a_failure_that_shrinks_test() ->
    Property = ?FORALL(C, commands(bag_model),
                       ?TIMEOUT(3, case [x || {set, _, {call, _, explosion, _}} <- C] of
                                       [] -> true;
                                       _ -> receive never -> true end
                                   end)),
    {false, [Commands], #{minimal := true}} = model_lab:quickcheck(Property, [?MANY]),
    ?assertMatch([{set, {var, 1}, {call, bag_model, explosion, [_]}}], Commands).

the_minimal_sequence_is_what_whenfail_sees_test() ->
    Table = ets:new(seen, [public]),
    Property = ?FORALL(C, commands(bag_model),
                       ?WHENFAIL(ets:insert(Table, {last, C}), ok(C))),
    {false, [Commands], _} = model_lab:quickcheck(Property, [?MANY]),
    ?assertEqual([{last, Commands}], ets:lookup(Table, last)).

noshrink_leaves_the_sequence_as_it_is_test() ->
    {false, [Commands], undefined} =
        model_lab:quickcheck(model_lab:property(bag_model, #{}), [?MANY, noshrink]),
    ?assertNot(ok(Commands)),
    Type = proper_types:noshrink(commands(bag_model)),
    {false, [_], undefined} = model_lab:quickcheck(?FORALL(C, Type, ok(C)), [?MANY]).

max_shrinks_ends_shrinking_and_shows_in_the_summary_test() ->
    %% The ten confirming runs are steps for PropEr too.
    {false, [Commands], Summary} =
        model_lab:quickcheck(model_lab:property(chain_model, #{}),
                             [{numtests, 100000}, {start_size, 60}, {max_size, 60},
                              {max_shrinks, 11}]),
    ?assertMatch(#{minimal := false, stopped := max_shrinks, flaky := false}, Summary),
    ?assertMatch({fails, _}, model_lab:verdict(chain_model, Commands)).

%% PropEr says false all the same, and prints that this was expected.
what_should_fail_is_not_shrunk_test() ->
    ?assertMatch({false, [_], undefined},
                 model_lab:quickcheck(proper:fails(model_lab:property(bag_model, #{})), [?MANY])).

a_counterexample_is_plain_and_can_be_checked_again_test() ->
    Property = model_lab:property(bag_model, #{}),
    {false, Counterexample, _} = model_lab:quickcheck(Property, [?MANY]),
    Text = io_lib:format("~p.~n", [Counterexample]),
    {ok, Tokens, _} = erl_scan:string(lists:flatten(Text)),
    {ok, Counterexample} = erl_parse:parse_term(Tokens),
    ?assertNot(model_lab:isolated(fun() -> proper:check(Property, Counterexample, [quiet]) end)).

%% The system under test remembers how often it ran, and answers wrongly two times in three.
a_flaky_failure_is_reported_with_its_rate_and_not_shrunk_test() ->
    Runs = counters:new(1, []),
    Property = ?FORALL(C, commands(bag_model),
                       begin
                           length(C) > 3 andalso counters:add(Runs, 1, 1),
                           length(C) =< 3 orelse counters:get(Runs, 1) rem 3 =:= 0
                       end),
    {false, [Commands], Summary} = model_lab:quickcheck(Property, [?MANY]),
    %% the failure itself was run 1, the re-runs 2 to 11: 3, 6 and 9 pass
    ?assertMatch(#{flaky := {7, 10}, minimal := false, original := Commands, shrunk := Commands},
                 Summary).

a_passing_confirmation_at_the_start_does_not_end_it_test() ->
    Runs = counters:new(1, []),
    Property = ?FORALL(C, commands(bag_model, #{confirm => 4}),
                       begin
                           length(C) > 3 andalso counters:add(Runs, 1, 1),
                           length(C) =< 3 orelse counters:get(Runs, 1) rem 2 =:= 0
                       end),
    {false, [_], Summary} = model_lab:quickcheck(Property, [?MANY]),
    ?assertMatch(#{flaky := {2, 4}}, Summary).

an_exception_in_a_command_is_a_failed_test_that_shrinks_test() ->
    Property = ?FORALL(C, commands(odd_model),
                       begin
                           Bad = [case S of
                                      {set, V, {call, M, crash, [none]}} ->
                                          {set, V, {call, M, crash, [{raise, error, {cb, x}}]}};
                                      _ -> S
                                  end || S <- C],
                           {_, _, Result} = faultcheck_statem:run_commands(odd_model, Bad),
                           Result =:= ok
                       end),
    {false, [Commands], #{minimal := true}} = model_lab:quickcheck(Property, [?MANY]),
    ?assertMatch([{set, {var, 1}, {call, odd_model, crash, [none]}}], Commands).

the_same_random_states_give_the_same_result_test() ->
    ?assertEqual(seeded_shrink(), seeded_shrink()).

%% Test i is generated with seed i.
seeded_shrink() ->
    Tests = counters:new(1, []),
    Seed = ?LAZY(begin
                     counters:add(Tests, 1, 1),
                     _ = rand:seed(exsss, counters:get(Tests, 1)),
                     seeded
                 end),
    Property = ?FORALL(_, Seed, model_lab:property(syn_model, #{})),
    {false, [seeded, Commands], Summary} =
        model_lab:quickcheck(Property, [{numtests, 100000}, {start_size, 200},
                                                       {max_size, 200}]),
    {Commands, maps:remove(ms, Summary)}.

progress_is_heard_and_changes_nothing_test() ->
    Self = self(),
    model_lab:isolated(
      fun() ->
              faultcheck_progress:set(fun(shrinking, Map) -> Self ! {progress, Map} end),
              Slow = ?FORALL(C, commands(bag_model),
                             begin
                                 wait_until(erlang:monotonic_time(millisecond) + 30),
                                 length(C) < 3
                             end),
              false = proper:quickcheck(Slow, [quiet]),
              faultcheck_progress:set(undefined)
      end),
    receive
        {progress, #{tries := Tries, accepted := _, original := _, length := _}} ->
            ?assert(Tries > 0)
    after 0 ->
            error(nothing_heard)
    end.

wait_until(Time) ->
    case erlang:monotonic_time(millisecond) >= Time of
        true -> ok;
        false -> wait_until(Time)
    end.

the_summary_can_be_forgotten_test() ->
    model_lab:isolated(
      fun() ->
              false = proper:quickcheck(model_lab:property(bag_model, #{}), [quiet, ?MANY]),
              #{} = faultcheck_statem:last_shrink(),
              ok = faultcheck_statem:reset_shrink(),
              ?assertEqual(undefined, faultcheck_statem:last_shrink())
      end).

command_names_are_mfas_test() ->
    ?assertEqual([{bag_model, sensor, 1}, {bag_model, bit_flip, 2}],
                 command_names([{set, {var, 1}, {call, bag_model, sensor, [[1, 2]]}},
                                {set, {var, 2}, {call, bag_model, bit_flip, [1, 2]}}])).

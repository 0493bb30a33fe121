-module(faultcheck_stats_tests).

-include_lib("eunit/include/eunit.hrl").
-undef(LET). % EUnit has one of its own
-include_lib("proper/include/proper_common.hrl").

set(N, Name, Args) -> {set, {var, N}, {call, odd_model, Name, Args}}.

runs_are_counted_between_start_and_stop_test() ->
    ok = faultcheck_stats:start(),
    _ = faultcheck_statem:run_commands(odd_model, [set(1, fine, [1]), set(2, crash, [none])]),
    _ = faultcheck_statem:run_commands(odd_model, [set(1, crash, [post_false]),
                                                   set(2, fine, [1])]),
    Stats = faultcheck_stats:stop(),
    ?assertEqual(#{tests => 2, commands => #{fine => 1, crash => 2}, faults => #{crash => 2},
                   lengths => #{2 => 1, 1 => 1}, rejected => #{}, requirements => #{'REQ-1' => 1}},
                 Stats),
    ?assertEqual("2 sequences\n"
                 "lengths: 1 to 2, mean 1.5\n"
                 "commands:\n"
                 "           2   66.7%  crash\n"
                 "           1   33.3%  fine\n"
                 "faults:\n"
                 "           2  100.0%  crash\n"
                 "requirements:\n"
                 "           1  100.0%  'REQ-1'\n",
                 lists:flatten(faultcheck_stats:format(Stats))).

nothing_is_counted_when_nobody_asks_test() ->
    _ = faultcheck_stats:stop(),
    _ = faultcheck_statem:run_commands(odd_model, [set(1, fine, [1])]),
    ?assertMatch(#{tests := 0, commands := C} when map_size(C) =:= 0, faultcheck_stats:stop()).

rejected_arguments_are_counted_test() ->
    ok = faultcheck_stats:start(),
    model_lab:isolated(
      fun() ->
              faultcheck_proper:with_state(
                30, {1, 2, 3}, fun() -> [faultcheck_generator:generate(odd_model, 30)
                                         || _ <- lists:seq(1, 20)] end)
      end),
    #{rejected := Rejected} = faultcheck_stats:stop(),
    ?assertEqual([even], maps:keys(Rejected)).

%% Each run of the body is a test, a candidate of the shrinker, or one of PropEr's own: at the
%% end of each of its two passes over the counterexample, and once more to report it.
shrinking_is_not_counted_test() ->
    ok = faultcheck_stats:start(),
    Bodies = counters:new(1, []),
    Property = ?FORALL(Commands, faultcheck_statem:commands(bag_model),
                       begin
                           counters:add(Bodies, 1, 1),
                           {_, _, Result} = model_lab:run(bag_model, Commands),
                           Result =:= ok
                       end),
    {false, _, #{tries := Tries}} =
        model_lab:quickcheck(Property, [{numtests, 100000}, {start_size, 40}]),
    #{tests := Tests} = faultcheck_stats:stop(),
    ?assert(Tries > 10),
    ?assertEqual(counters:get(Bodies, 1), Tests + Tries + 3).

counting_in_another_process_works_test() ->
    ok = faultcheck_stats:start(),
    model_lab:isolated(fun() ->
                               faultcheck_statem:run_commands(odd_model, [set(1, fine, [1])])
                       end),
    ?assertMatch(#{tests := 1}, faultcheck_stats:stop()).

counting_ends_with_the_process_that_started_it_test() ->
    model_lab:isolated(fun() -> faultcheck_stats:start() end),
    ?assertNot(faultcheck_stats:active()),
    _ = faultcheck_statem:run_commands(odd_model, [set(1, fine, [1])]),
    ?assertMatch(#{tests := 0}, faultcheck_stats:stop()).

-module(faultcheck_run_tests).

-include_lib("eunit/include/eunit.hrl").

-import(faultcheck_statem, [run_commands/2, run_commands/3, pretty/3]).

set(N, Name, Args) -> {set, {var, N}, {call, odd_model, Name, Args}}.

result(How) ->
    {_, _, Result} = run_commands(odd_model, [set(1, fine, [1]), set(2, crash, [How])]),
    Result.

a_run_gives_history_state_and_ok_test() ->
    ?assertEqual({[{#{ran => []}, 2}, {#{ran => [fine]}, 3}], #{ran => [fine, fine]}, ok},
                 run_commands(odd_model, [set(1, fine, [1]), set(2, fine, [2])])).

results_of_earlier_commands_are_put_in_test() ->
    {[_, {_, Used}], _, ok} =
        run_commands(odd_model, [set(1, fine, [1]), set(2, use, [[{x, {var, 1}}]])]),
    ?assertEqual({used, [{x, 2}]}, Used).

values_from_outside_are_put_in_test() ->
    {[_, {_, Used}], _, ok} =
        run_commands(odd_model, [set(1, fine, [1]), set(2, use, [{var, lib}])], [{lib, "l"}]),
    ?assertEqual({used, "l"}, Used).

symbolic_calls_in_arguments_are_evaluated_test() ->
    {[{_, 6}], _, ok} = run_commands(odd_model, [set(1, fine, [{call, erlang, '+', [2, 3]}])]).

exceptions_of_a_command_are_its_result_test_() ->
    [?_assertMatch({exception, Class, Reason, _}, result({raise, Class, Reason}))
     || {Class, Reason} <- [{error, {cb, {unknown_function, f, []}}}, {exit, why}, {throw, it}]].

an_argument_that_cannot_be_evaluated_is_a_failed_command_test() ->
    ?assertMatch({[{_, {exception, error, badarith, _}}], _, {exception, error, badarith, _}},
                 run_commands(odd_model, [set(1, fine, [{call, erlang, '+', [a, 3]}])])).

exceptions_of_the_model_are_results_test() ->
    ?assertMatch({precondition, {exception, error, pre, _}}, result(pre_raises)),
    ?assertMatch({postcondition, {exception, error, post, _}}, result(post_raises)),
    ?assertMatch({next_state, {exception, error, next, _}}, result(next_raises)).

conditions_that_do_not_hold_are_results_test() ->
    ?assertEqual({precondition, false}, result(pre_false)),
    ?assertEqual({postcondition, false}, result(post_false)),
    ?assertEqual({postcondition, {1, '/=', 2}}, result(post_explains)).

the_run_ends_at_the_first_failure_test() ->
    {History, _, _} = run_commands(odd_model, [set(1, fine, [1]), set(2, crash, [post_false]),
                                               set(3, fine, [1])]),
    ?assertEqual(2, length(History)).

how_a_run_failed_is_remembered_for_the_shrinker_test() ->
    Kind = fun(How) ->
                   Commands = [set(1, crash, [How]), set(2, fine, [1])],
                   _ = run_commands(odd_model, Commands),
                   faultcheck_run:failure(Commands)
           end,
    ?assertEqual(#{kind => postcondition, at => 1}, Kind(post_false)),
    ?assertEqual(#{kind => precondition, at => 1}, Kind(pre_false)),
    ?assertEqual(#{kind => property, at => unknown}, Kind(none)),
    ?assertEqual(#{kind => {error, {cb, crash}}, at => 1},
                 Kind({raise, error, {cb, {crash, #{signal => sigsegv}}}})),
    ?assertEqual(#{kind => {error, {cb, timeout}}, at => 1},
                 Kind({raise, error, {cb, {timeout, 100, #{}}}})),
    ?assertEqual(#{kind => {postcondition, error, post}, at => 1}, Kind(post_raises)),
    ?assertEqual(#{kind => unknown, at => unknown},
                 faultcheck_run:failure([set(1, fine, [other])])).

%%% Printing

text(Commands) ->
    Run = run_commands(odd_model, Commands),
    lists:flatten(pretty(odd_model, Commands, Run)).

each_command_is_a_line_test() ->
    ?assertEqual("  odd_model:fine(1) -> 2\n"
                 "  odd_model:even(4) -> 4\n",
                 text([set(1, fine, [1]), set(2, even, [4])])).

variables_are_named_where_they_are_used_test() ->
    ?assertEqual("  V1 = odd_model:fine(1) -> 2\n"
                 "  odd_model:use(V1) -> {used,2}\n",
                 text([set(1, fine, [1]), set(2, use, [{var, 1}])])).

bytes_are_numbers_not_text_test() ->
    ?assertEqual("  odd_model:fine(1) -> 2\n"
                 "  odd_model:use([85,170]) -> {used,[85,170]}\n",
                 text([set(1, fine, [1]), set(2, use, [[85, 170]])])).

the_command_that_failed_is_marked_with_why_test() ->
    ?assertEqual("  odd_model:fine(1) -> 2\n"
                 "! odd_model:crash(post_false) -> post_false\n"
                 "    postcondition false\n"
                 "  odd_model:fine(2)   (not run)\n",
                 text([set(1, fine, [1]), set(2, crash, [post_false]), set(3, fine, [2])])),
    ?assertEqual("! odd_model:crash(post_explains) -> post_explains\n"
                 "    postcondition: {1,'/=',2}\n",
                 text([set(1, crash, [post_explains])])),
    ?assertEqual("! odd_model:crash(pre_false)\n"
                 "    precondition false\n"
                 "  odd_model:fine(2)   (not run)\n",
                 text([set(1, crash, [pre_false]), set(2, fine, [2])])),
    ?assertEqual("! odd_model:crash({raise,exit,why})\n"
                 "    exit: why\n",
                 text([set(1, crash, [{raise, exit, why}])])),
    ?assertMatch("! odd_model:crash(pre_raises)\n"
                 "    in the precondition: error: pre in odd_model:crash_pre/2\n",
                 text([set(1, crash, [pre_raises])])),
    ?assertMatch("! odd_model:crash(post_raises) -> post_raises\n"
                 "    in the postcondition: error: post in odd_model:crash_post/3\n",
                 text([set(1, crash, [post_raises])])),
    ?assertMatch("! odd_model:crash(next_raises) -> next_raises\n"
                 "    in the next state: error: next in odd_model:crash_next/3\n",
                 text([set(1, crash, [next_raises])])).

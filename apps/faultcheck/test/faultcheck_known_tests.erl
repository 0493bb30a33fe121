-module(faultcheck_known_tests).
-include_lib("eunit/include/eunit.hrl").

%% What PropEr prints of a known test, and its verdict on so many of them.
told(Outcome, Numtests) ->
    Self = self(),
    Print = fun(Format, Args) -> Self ! {printed, io_lib:format(Format, Args)}, ok end,
    Property = proper:whenfail(fun() -> ok end, fun() -> faultcheck_known:test(Outcome) end),
    Result = proper:quickcheck(Property, [{numtests, Numtests}, {on_output, Print}]),
    {Result, printed([])}.

printed(Texts) ->
    receive
        {printed, Text} -> printed([Text | Texts])
    after 0 -> lists:flatten(lists:reverse(Texts))
    end.

%% The sample and its printer as PropEr has them.
sample() ->
    {sample, Sample, Printer, true} = proper:collect(seven, true),
    {Sample, Printer}.

a_passed_test_passes_with_its_samples_test() ->
    Outcome = faultcheck_known:outcome(passed, [sample()], [], <<>>),
    {true, Text} = told(Outcome, 3),
    ?assertNotEqual(nomatch, string:find(Text, "OK: Passed 3 test(s)")),
    %% PropEr 1.5 writes decimals.
    ?assertMatch({match, _}, re:run(Text, "100(\\.0+)?% +seven")).

a_rejected_test_is_rejected_test() ->
    Outcome = faultcheck_known:outcome(rejected, [], [], <<>>),
    ?assertMatch({{error, cant_satisfy}, _}, told(Outcome, 2)).

counts_are_added_test() ->
    ok = faultcheck_stats:start(),
    true = faultcheck_known:test(faultcheck_known:outcome(passed, [], [{tests, 1}], <<>>)),
    true = faultcheck_known:test(faultcheck_known:outcome(passed, [], [{tests, 2}], <<>>)),
    ?assertMatch(#{tests := 3}, faultcheck_stats:stop()).

what_leaves_nothing_behind_is_small_test() ->
    ?assertEqual(passed, faultcheck_known:outcome(passed, [], [], <<>>)).

a_failed_test_is_run_again_and_the_first_is_the_doubt_test() ->
    ?assertEqual(run, faultcheck_known:test(faultcheck_known:failed(none))),
    ?assertEqual(run, faultcheck_known:test(faultcheck_known:lost("it died"))),
    Lost = faultcheck_known:lost("it died"),
    Known = #{1 => passed, 9 => faultcheck_known:failed(none), 4 => Lost},
    ?assertMatch({4, "it died" ++ _}, faultcheck_known:doubt(Known)),
    ?assertEqual(none, faultcheck_known:doubt(#{1 => passed})).

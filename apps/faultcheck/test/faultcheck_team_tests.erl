%% Runs with workers, against runs without: real child VMs, some of them killed.
-module(faultcheck_team_tests).
-include_lib("eunit/include/eunit.hrl").

-import(runner_lab, [fresh/1, run/2, contains/2]).

team_test_() ->
    {setup, fun runner_lab:temporary/0, fun runner_lab:clean/1, fun(Dir) ->
        [
            {Title, {timeout, 60, fun() -> Test(fresh(Dir)) end}}
         || {Title, Test} <- tests()
        ]
    end}.

tests() ->
    [
        {"what passes looks the same with any number of workers", fun passing/1},
        {"what fails looks the same with any number of workers", fun failing/1},
        {"a search finds the same in any worker", fun search/1},
        {"each test is run once, by more than one VM", fun shared/1},
        {"a worker that is killed loses nothing but its test", fun killed/1},
        {"a test in which workers are killed again and again has failed", fun killed_again/1},
        {"a failure that does not repeat outside its worker is flaky", fun doubted/1},
        {"until the time is up", fun time/1},
        {"a library that is missing is status 3", fun missing/1},
        {"cover data of each worker", fun cover/1}
    ].

%% The same with 1, 2 and 3 workers; the last result. Times are not compared.
same(Words, Dir) ->
    [One, Two, Three] = [
        run(Words ++ ["--seed", "11", "--stats", "--workers", integer_to_list(N)], Dir)
     || N <- [1, 2, 3]
    ],
    ?assertEqual(One, Two),
    ?assertEqual(One, Three),
    One.

with_variable(Name, Value, Fun) ->
    true = os:putenv(Name, Value),
    try
        Fun()
    after
        os:unsetenv(Name)
    end.

passing(Dir) ->
    {0, Text} = same(["-p", "prop_good,prop_chatty,prop_fails"], Dir),
    contains("OK: Passed 100 test(s)", Text),
    contains("seven: [", Text),
    %% rejected cases
    contains("x", Text),
    contains("100 sequences", Text),
    contains("commands:", Text),
    contains("===> 3/3 properties passed", Text).

failing(Dir) ->
    with_variable("FAULTCHECK_TEST_LIMIT", "9", fun() ->
        {1, Text} = same(["-p", "prop_wrong,prop_value,prop_talk,prop_crash,prop_chatty"], Dir),
        contains("minimal", Text),
        contains("SIGSEGV", Text),
        contains("===> 0/5 properties passed, 5 failed", Text)
    end).

search(Dir) ->
    with_variable("FAULTCHECK_TEST_LIMIT", "80", fun() ->
        {1, Text} = same(["-p", "prop_search", "--boundary-bias", "0.5", "-n", "20"], Dir),
        contains("--boundary-bias 0.5", Text),
        contains("cart_model:push(", Text)
    end),
    with_variable("FAULTCHECK_TEST_LIMIT", "100000", fun() ->
        {0, Text} = same(["-p", "prop_search", "-n", "6"], Dir),
        contains("Smallest objective", Text)
    end).

shared(Dir) ->
    File = filename:join(Dir, "where"),
    with_variable("FAULTCHECK_TEST_DRAW", File, fun() ->
        {0, _} = run(["-p", "prop_where", "--workers", "2", "-n", "4000"], Dir)
    end),
    {ok, Text} = file:read_file(File),
    Ran = string:lexemes(Text, "\n"),
    ?assertEqual(4000, length(Ran)),
    ?assertEqual(2, length(lists:usort(Ran))).

%% Runs prop_struck, whose first tests do what Strikes says.
struck(Strikes, Workers, Dir) ->
    File = filename:join(Dir, "strikes"),
    ok = file:write_file(File, Strikes),
    with_variable("FAULTCHECK_TEST_STRIKES", File, fun() ->
        Result = run(["-p", "prop_struck", "--seed", "3", "--workers", Workers], Dir),
        {ok, Left} = file:read_file(File),
        {Result, binary_to_list(Left)}
    end).

killed(Dir) ->
    {Undisturbed, []} = struck("", "1", Dir),
    ?assertMatch({0, _}, Undisturbed),
    ?assertEqual({Undisturbed, []}, struck("k", "2", Dir)).

%% Whatever the run does with the test in the end, it is killed, too.
killed_again(Dir) ->
    {{1, Text}, _} = struck(lists:duplicate(100, $k), "2", Dir),
    contains("the child VM died of signal 9 (SIGKILL)", Text).

doubted(Dir) ->
    {{4, Text}, []} = struck("f", "2", Dir),
    contains("flaky: failed 0 of 1 times", Text),
    contains("it failed in a worker and passed when it was run again", Text).

time(Dir) ->
    {0, Text} = run(["-p", "prop_good", "--time", "1", "--workers", "2"], Dir),
    {match, [Passed]} = re:run(Text, "Passed ([0-9]+) test", [{capture, [1], list}]),
    ?assert(list_to_integer(Passed) > 0),
    {1, _} = run(["-p", "prop_wrong", "--time", "20", "--workers", "2"], Dir).

missing(Dir) ->
    same_missing(run(["-p", "prop_missing"], Dir),
                 run(["-p", "prop_missing", "--workers", "2"], Dir)).

same_missing({3, One}, {3, Two}) ->
    contains("no_such_library.so", One),
    contains("no_such_library.so", Two).

cover(Dir) ->
    File = filename:join([Dir, "covered", "faultcheck_covered.erl"]),
    ok = filelib:ensure_dir(File),
    ok = file:write_file(File, "-module(faultcheck_covered).\n-export([f/0]).\nf() -> 1.\n"),
    {ok, _} = compile:file(File, [debug_info, {outdir, filename:dirname(File)}]),
    {0, _} = run(["-p", "prop_fails", "-c", "--workers", "2"], Dir),
    Names = filelib:wildcard("*.coverdata", filename:join([Dir, "base", "cover"])),
    ?assertEqual(["proper-1.coverdata", "proper-2.coverdata", "proper.coverdata"], Names).

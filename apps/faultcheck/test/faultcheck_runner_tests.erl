%% Whole runs with real child VMs and C code that misbehaves (faultcheck_unruly.c).
-module(faultcheck_runner_tests).
-include_lib("eunit/include/eunit.hrl").

-import(runner_lab, [fresh/1, run/2, capture/2, capture/3, contains/2]).

-define(M, "faultcheck_unruly").

%% ---- one run of the program in this VM ----------------------------------------------------

run_test_() ->
    {setup, fun runner_lab:temporary/0, fun runner_lab:clean/1, fun(Dir) ->
        [
            {Title, {timeout, 60, fun() -> Test(fresh(Dir)) end}}
         || {Title, Test} <- tests()
        ]
    end}.

tests() ->
    [
        {"a property that holds", fun holds/1},
        {"a run that can be watched says once where", fun watched/1},
        {"a wrong result is shrunk and stored", fun wrong/1},
        {"a crash in the VM is confirmed and shrunk in a process of its own", fun crash/1},
        {"a crash in a guided search is confirmed and shrunk, too", fun search_crash/1},
        {"a hang is a failure that was confirmed with ten times the limit", fun hang/1},
        {"a timeout counts only with ten times the limit", fun slow/1},
        {"an exit of C code is a failure", fun leave/1},
        {"C code that prints disturbs nothing, in both transports", fun print/1},
        {"a failure that does not repeat is flaky", fun flaky/1},
        {"a crash that does not repeat is flaky, with the commands of the journal", fun guest/1},
        {"the run goes on behind a crash", fun goes_on/1},
        {"a value is shrunk, an exception told", fun values/1},
        {"a property without commands that ends its VM", fun halts/1},
        {"a property without commands that does not end", fun stuck/1},
        {"a property that is expected to fail", fun expected/1},
        {"a failure of plain values that does not repeat is flaky", fun chance/1},
        {"a library that is missing is status 3", fun missing/1},
        {"what ?WHENFAIL prints is shown once, for the smallest failure", fun talk/1},
        {"retry, store and regressions", fun stored/1},
        {"a damaged file of counterexamples is one line", fun damaged/1},
        {"JUnit and JSON reports", fun reports/1},
        {"the same seed gives the same output", fun same_seed/1},
        {"test i depends on seed and i alone", fun test_i/1},
        {"replay shows each command and compares with the record", fun replay/1},
        {"replay shows a run once that the property prints itself", fun replay_shows/1},
        {"the runs that confirm a failure are no shrinking steps of the user", fun few_shrinks/1},
        {"unknown modules and properties are one line", fun unknown/1},
        {"until the time is up", fun time/1},
        {"statistics", fun stats/1},
        {"targeted properties, where PropEr has them", fun targeted/1},
        {"cover data for rebar3 cover", fun cover/1}
    ].

holds(Dir) ->
    {Status, Text} = run(["-p", "prop_good"], Dir),
    ?assertEqual(0, Status),
    contains("OK: Passed 100 test(s).", Text),
    contains("===> 1/1 properties passed", Text).

watched(Dir) ->
    Line = "watch: node visualizer/dist/bridge.mjs, then open http://127.0.0.1:8765/\n",
    {1, Text} = run(["-p", "prop_good,prop_wrong", "--watch"], Dir),
    ?assertMatch([_, _], string:split(Text, Line, all)),
    {0, Unwatched} = run(["-p", "prop_good"], Dir),
    ?assertEqual(nomatch, string:find(Unwatched, "watch:")).

wrong(Dir) ->
    {Status, Text} = run(["-p", "prop_wrong", "--seed", "7"], Dir),
    ?assertEqual(1, Status),
    contains("postcondition false", Text),
    contains("repeat: faultcheck proper -m faultcheck_unruly -p prop_wrong --seed 7@", Text),
    [_, Repeat] = string:split(Text, "repeat: faultcheck proper "),
    [Words, _] = string:split(Repeat, "\n"),
    {1, Repeated} = capture(string:lexemes(Words, " "), Dir),
    ?assertEqual(Text, Repeated),
    {1, Warned} = run(["-p", "prop_wrong", "--seed", "7@0.0.1,1.2,24"], Dir),
    contains("warning: the seed may give other tests here: FaultCheck 0.0.1 then", Warned),
    contains("minimal", Text),
    #{shrunk := [Commands], seed := 7, status := failed} = the_case(Dir),
    ?assertEqual(10, sum(Commands)).

crash(Dir) ->
    {Status, Text} = run(["-p", "prop_crash"], Dir),
    ?assertEqual(1, Status),
    contains("SIGSEGV", Text),
    contains("faultcheck_unruly.c", Text),
    contains("minimal", Text),
    #{shrunk := [Commands], original := [Original]} = the_case(Dir),
    ?assertEqual(10, sum(Commands)),
    ?assert(length(Original) >= length(Commands)).

search_crash(Dir) ->
    {Status, Text} = run(["-p", "prop_search_crash", "-n", "1"], Dir),
    ?assertEqual(1, Status),
    contains("SIGSEGV", Text),
    #{shrunk := [Commands]} = the_case(Dir),
    ?assertEqual(10, sum(Commands)).

hang(Dir) ->
    {Status, Text} = run(["-p", "prop_hang"], Dir),
    ?assertEqual(1, Status),
    contains("150 ms", Text),
    #{shrunk := [Commands]} = the_case(Dir),
    ?assertEqual(10, sum(Commands)).

%% The limit of a call is 150 ms; slow takes 300.
slow(Dir) ->
    {4, Text} = run(["-p", "prop_slow", "--transport", "port"], Dir),
    contains("it passes with ten times the time limit", Text),
    contains("flaky", Text),
    {1, Hang} = run(["-p", "prop_hang", "--transport", "port", "--max_size", "8"], Dir),
    contains("150 ms", Hang).

leave(Dir) ->
    {Status, Text} = run(["-p", "prop_leave"], Dir),
    ?assertEqual(1, Status),
    contains("exit", Text),
    #{shrunk := [Commands]} = the_case(Dir),
    ?assertEqual(10, sum(Commands)).

print(Dir) ->
    {0, Nif} = run(["-p", "prop_print"], Dir),
    {0, Port} = run(["-p", "prop_print", "--transport", "port"], Dir),
    contains("Passed 100", Nif),
    contains("Passed 100", Port).

flaky(Dir) ->
    {Status, Text} = run(["-p", "prop_flaky"], Dir),
    ?assertEqual(4, Status),
    contains("flaky: failed ", Text),
    ?assertMatch(#{status := flaky}, the_case(Dir)).

guest(Dir) ->
    {Status, Text} = run(["-p", "prop_guest"], Dir),
    ?assertEqual(4, Status),
    contains("died of signal 11 (SIGSEGV) in faultcheck_unruly:step(guest,", Text),
    contains("not reproduced", Text),
    #{status := flaky, shrunk := [Commands]} = the_case(Dir),
    ?assert(sum(Commands) >= 10).

goes_on(Dir) ->
    {Status, Text} = run(["-p", "prop_crash,prop_good,prop_wrong"], Dir),
    ?assertEqual(1, Status),
    contains("===> 1/3 properties passed, 2 failed", Text),
    ?assertEqual(2, length(cases(Dir))).

values(Dir) ->
    {1, Text} = run(["-p", "prop_value,prop_raise"], Dir),
    contains("[0,0,0,0,0]", Text),
    contains("error:{long,5}", Text).

halts(Dir) ->
    {1, Text} = run(["-p", "prop_halt"], Dir),
    contains("the child VM exited with status 5", Text),
    contains("not shrunk", Text),
    #{shrunk := [Value]} = the_case(Dir),
    ?assert(length(Value) >= 5).

stuck(Dir) ->
    {1, Text} = run(["-p", "prop_stuck", "--timeout", "200"], Dir),
    contains("no progress for 200 ms", Text).

expected(Dir) ->
    {0, _} = run(["-p", "prop_fails"], Dir),
    {1, Text} = run(["-p", "prop_fails_not"], Dir),
    contains("expected to fail", Text),
    ?assertEqual([], cases(Dir)).

chance(Dir) ->
    {4, Text} = run(["-p", "prop_chance", "-n", "300"], Dir),
    contains("flaky: failed ", Text).

missing(Dir) ->
    {3, Text} = run(["-p", "prop_missing"], Dir),
    contains("no_such_library.so", Text).

talk(Dir) ->
    {1, Text} = run(["-p", "prop_talk"], Dir),
    ?assertEqual(2, length(string:split(Text, "told of", all))),
    contains("told of [0,0,0,0,0]", Text).

stored(Dir) ->
    {0, None} = run(["--retry"], Dir),
    contains("no counterexamples to run", None),
    {1, _} = run(["-p", "prop_value,prop_crash"], Dir),
    {1, Again} = run(["--retry"], Dir),
    contains("===> 0/2 properties passed, 2 failed", Again),
    {0, Stored} = run(["--store"], Dir),
    contains("stored 2 of 2", Stored),
    {0, Twice} = run(["--store"], Dir),
    contains("stored 0 of 2", Twice),
    {1, Kept} = run(["--regressions", "-p", "prop_value"], Dir),
    contains("===> 0/1 properties passed, 1 failed", Kept),
    {ok, [
        {faultcheck_unruly, prop_crash, [_]},
        {faultcheck_unruly, prop_value, [[0, 0, 0, 0, 0]]}
    ]} = file:consult(faultcheck_store:regression_file(filename:join(Dir, "test"))).

damaged(Dir) ->
    File = faultcheck_store:last_file(filename:join(Dir, "base")),
    ok = filelib:ensure_dir(File),
    ok = file:write_file(File, "{faultcheck_unruly, prop_value, [[0,"),
    {2, Text} = run(["--retry"], Dir),
    contains("damaged or was cut short", Text),
    ok = file:write_file(File, "{faultcheck_unruly, prop_valeu, [[0]]}.\n"),
    {2, Unknown} = run(["--retry"], Dir),
    contains("did you mean faultcheck_unruly:prop_value", Unknown).

reports(Dir) ->
    [Junit, Json] = [filename:join([Dir, "out", F]) || F <- ["r.xml", "r.json"]],
    {1, _} = run(["-p", "prop_good,prop_value", "--junit", Junit, "--json", Json], Dir),
    {Xml, []} = xmerl_scan:file(Junit),
    ?assertMatch({xmlObj, number, 1}, xmerl_xpath:string("count(//failure)", Xml)),
    ?assertMatch({xmlObj, number, 2}, xmerl_xpath:string("count(//testcase)", Xml)),
    {ok, Text} = file:read_file(Json),
    {ok, #{<<"passed">> := 1, <<"total">> := 2, <<"properties">> := [Good, Bad]}} =
        faultcheck_json:decode(Text),
    ?assertMatch(#{<<"status">> := <<"passed">>, <<"tests">> := 100}, Good),
    ?assertMatch(#{<<"status">> := <<"failed">>, <<"repeat">> := _, <<"case">> := _}, Bad),
    {2, Refused} = run(["-p", "prop_good", "--json", "/dev/null/r.json"], Dir),
    contains("cannot be written", Refused).

same_seed(Dir) ->
    Words = ["-p", "prop_wrong,prop_value,prop_crash", "--seed", "99"],
    {1, First} = run(Words, Dir),
    {1, Second} = run(Words, Dir),
    ?assertEqual(First, Second),
    {1, Third} = run(["-p", "prop_wrong,prop_value,prop_crash", "--seed", "98"], Dir),
    ?assertNotEqual(First, Third).

test_i(Dir) ->
    Drawn = fun(Words) ->
        File = filename:join(Dir, "draw"),
        true = os:putenv("FAULTCHECK_TEST_DRAW", File),
        Sizes = ["--start_size", "9", "--max_size", "9"],
        {0, _} = run(["-p", "prop_draw", "--seed", "4"] ++ Sizes ++ Words, Dir),
        {ok, Text} = file:read_file(File),
        ok = file:delete(File),
        string:split(string:trim(Text), "\n", all)
    end,
    Few = Drawn(["-n", "20"]),
    Many = Drawn(["-n", "50"]),
    ?assertEqual(Few, lists:sublist(Many, 20)).

replay(Dir) ->
    {1, _} = run(["-p", "prop_crash", "--seed", "1"], Dir),
    [Folder] = cases(Dir),
    {ok, Case} = faultcheck_case:read(Folder),
    Again = fun(What) -> capture(fun(R) -> faultcheck_replay:replay(What, R) end, [], Dir) end,
    {1, Text} = Again({Case, shrunk}),
    contains("as recorded", Text),
    {1, _} = Again({Case, original}),
    #{shrunk := [[_ | Rest]]} = Case,
    Shorter = Case#{shrunk := [Rest]},
    {0, Differs} = Again({Shorter, shrunk}),
    contains("differs from the record", Differs),
    Older = Case#{versions := (maps:get(versions, Case))#{otp := "24"}},
    {1, Warned} = Again({Older, shrunk}),
    contains("OTP 24 then", Warned).

replay_shows(Dir) ->
    {1, _} = run(["-p", "prop_shows", "--seed", "1"], Dir),
    [Folder] = cases(Dir),
    {ok, Case} = faultcheck_case:read(Folder),
    Replay = fun(R) -> faultcheck_replay:replay({Case, shrunk}, R) end,
    {1, Text} = capture(Replay, [], Dir),
    contains("told:", Text),
    ?assertMatch([_, _], string:split(Text, "postcondition false", all)),
    contains("as recorded", Text).

few_shrinks(Dir) ->
    {1, _} = run(["-p", "prop_wrong", "--seed", "7", "--max_shrinks", "1"], Dir),
    #{original := [Original], shrunk := [Shrunk], shrink := Shrink} = the_case(Dir),
    ?assertMatch(#{accepted := 1, minimal := false, stopped := max_shrinks}, Shrink),
    ?assertNotEqual(Original, Shrunk).

unknown(Dir) ->
    {2, Property} = run(["-p", "prop_godo"], Dir),
    ?assertEqual("no property prop_godo; did you mean prop_good?\n", Property),
    {2, Module} = capture(["-m", "faultcheck_unruyl"], Dir),
    contains("no module faultcheck_unruyl", Module).

time(Dir) ->
    File = filename:join(Dir, "t.json"),
    {0, Text} = run(["-p", "prop_good", "--time", "1", "--json", File], Dir),
    contains("OK: Passed ", Text),
    contains("1/1 properties passed", Text),
    {ok, Json} = file:read_file(File),
    {ok, #{<<"properties">> := [#{<<"ms">> := Ms}]}} = faultcheck_json:decode(Json),
    ?assert(Ms >= 1000 andalso Ms < 4000).

stats(Dir) ->
    {0, Text} = run(["-p", "prop_good", "--stats"], Dir),
    contains("step", Text).

targeted(Dir) ->
    case faultcheck_versions:proper() >= [1, 3] of
        true ->
            {1, Text} = run(["-p", "prop_targeted,prop_exists", "--seed", "1"], Dir),
            contains("found no such value", Text),
            #{status := failed, shrunk := [900]} = Case = the_case(Dir),
            ok = file:del_dir_r(filename:join(Dir, "cases")),
            {1, _} = run(["-p", "prop_targeted", "--seed", "1"], Dir),
            What = [test, size, original, shrunk],
            ?assertEqual(maps:with(What, Case), maps:with(What, the_case(Dir)));
        false ->
            {2, Text} = run(["-p", "prop_targeted"], Dir),
            contains("no property prop_targeted", Text)
    end.

cover(Dir) ->
    File = filename:join([Dir, "covered", "faultcheck_covered.erl"]),
    ok = filelib:ensure_dir(File),
    ok = file:write_file(File, "-module(faultcheck_covered).\n-export([f/0]).\nf() -> 1.\n"),
    {ok, _} = compile:file(File, [debug_info, {outdir, filename:dirname(File)}]),
    {0, _} = run(["-p", "prop_value", "-n", "1", "-c"], Dir),
    ?assert(filelib:file_size(filename:join([Dir, "base", "cover", "proper.coverdata"])) > 0).

cases(Dir) -> filelib:wildcard(filename:join([Dir, "cases", "*"])).

the_case(Dir) ->
    [Folder] = cases(Dir),
    {ok, Case} = faultcheck_case:read(Folder),
    Case.

sum(Commands) -> lists:sum([By || {set, _, {call, _, step, [_, By]}} <- Commands]).

%% Counts of gcov are exact, whatever process made the calls.
-module(cb_coverage_tests).

-include_lib("eunit/include/eunit.hrl").

with_directory(Test) ->
    Dir = cb_files:fresh_name("cb_coverage_tests", ""),
    try
        Test(Dir)
    after
        ok = file:del_dir_r(Dir)
    end.

%% How often `visit' was entered, as gcov says.
visits(Dir) ->
    [Counts] = filelib:wildcard(filename:join(Dir, "**/*.gcda")),
    ?assert(filelib:is_regular(filename:rootname(Counts) ++ ".gcno")),
    {ok, 0, Text} = cb_compiler:run("gcov", ["--stdout", Counts]),
    Pattern = "^ *([0-9]+)\\*?: *[0-9]+:int visit",
    {match, [Count]} = re:run(Text, Pattern, [multiline, {capture, all_but_first, list}]),
    list_to_integer(Count).

started(Dir, Options) -> cb_sut:start("covered.c", [{coverage, Dir} | Options]).

counts_of_many_forks_are_exact_test_() ->
    {timeout, 60, fun() ->
        with_directory(fun(Dir) ->
            Lib = started(Dir, [{reset, fork}]),
            Calls = [fork_and_visit(Lib, I rem 3) || I <- lists:seq(1, 300)],
            ok = cb:stop(Lib),
            ?assertEqual(lists:sum(Calls), visits(Dir))
        end)
    end}.

fork_and_visit(Lib, Count) ->
    ok = cb:restart(Lib),
    [cb:call(Lib, visit, [I rem 2]) || I <- lists:seq(1, Count)],
    Count.

each_transport_and_reset_test_() ->
    [
        {lists:concat([Transport, " ", Reset]),
            {timeout, 30, fun() -> counts(Transport, Reset) end}}
     || {Transport, Reset} <- [
            {nif, snapshot},
            {nif, reload},
            {port, snapshot},
            {port, reload},
            {port, respawn},
            {port, none}
        ]
    ].

%% A restore does not take the counters back; a flush in between does not lose any.
counts(Transport, Reset) ->
    with_directory(fun(Dir) ->
        Lib = started(Dir, [{transport, Transport}, {reset, Reset}]),
        [cb:call(Lib, visit, [1]) || _ <- lists:seq(1, 5)],
        ok = cb:restart(Lib),
        cb:call(Lib, visit, [0]),
        ok = cb:flush_coverage(Lib),
        ?assertEqual(6, visits(Dir)),
        cb:call(Lib, visit, [0]),
        ok = cb:stop(Lib),
        ?assertEqual(7, visits(Dir))
    end).

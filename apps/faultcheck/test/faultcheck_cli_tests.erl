%% The program as a user starts it: its exit status and output, and what is left when it, its
%% child VM, or both are killed in the middle of a test.
-module(faultcheck_cli_tests).
-include_lib("eunit/include/eunit.hrl").

%% ---- command lines ------------------------------------------------------------------------

usage_test_() ->
    [
        {Title, fun() ->
            {Status, Text} = said(Words),
            ?assertEqual(Expected, Status),
            ?assertNotEqual(nomatch, string:find(Text, Part))
        end}
     || {Title, Words, Expected, Part} <- [
            {"help", ["--help"], 0, "new DIR"},
            {"help of proper", ["proper", "--help"], 0, "--regressions"},
            {"help of new makes no folder", ["new", "--help"], 0, "Makes the folder DIR"},
            {"help of replay", ["replay", "--help"], 0, "--original"},
            {"help of a command that is none", ["varsion", "-h"], 2, "did you mean version?"},
            {"an option of new", ["new", "--force"], 2, "unknown option --force"},
            {"version", ["version"], 0, "PropEr"},
            {"nothing", [], 2, "Usage"},
            {"unknown command", ["varsion"], 2, "did you mean version?"},
            {"too few words", ["replay"], 2, "say which case: faultcheck replay CASE"},
            {"too many words", ["replay", "a", "b"], 2, "Usage: faultcheck replay CASE"},
            {"a report of nothing", ["report"], 2, "say which case: faultcheck report CASE"},
            {"unknown option", ["proper", "--nmtests", "5"], 2, "did you mean --numtests?"},
            {"bad value", ["proper", "-n", "many"], 2, "must be a whole number from 1, not many"},
            {"a case that is not there", ["replay", "no/such"], 2, "no case no/such"},
            {"help of export", ["export", "--help"], 0, "--at SECONDS"},
            {"an export without a format", ["export", "c"], 2, "--mcap, --csv or --svg"},
            {"an export of no case", ["export", "no/such", "--csv"], 2, "no case no/such"}
        ]
    ].

%% What the program prints in this VM.
said(Words) ->
    Self = self(),
    Device = spawn_link(fun() -> device(Self, []) end),
    Old = group_leader(),
    true = group_leader(Device, Self),
    Status =
        try
            faultcheck_cli:run(Words)
        after
            group_leader(Old, Self)
        end,
    Device ! {stop, Self},
    receive
        {Device, Text} -> {Status, Text}
    end.

device(Owner, Texts) ->
    receive
        {io_request, From, Tag, Request} ->
            {Text, Reply} = faultcheck_output:request(Request),
            From ! {io_reply, Tag, Reply},
            device(Owner, [Text | Texts]);
        {stop, Owner} ->
            Owner ! {self(), unicode:characters_to_list(lists:reverse(Texts))}
    end.

%% ---- a project, and signals ---------------------------------------------------------------

project_test_() ->
    {setup, fun project/0, fun file:del_dir_r/1, fun(Dir) ->
        [
            {timeout, 60, {"the new project's bug is found, stored and replayed", fun() ->
                finds(Dir)
            end}},
            {timeout, 60, {"a folder with a property alone", fun() -> alone(Dir) end}},
            {timeout, 60, {"a model's page is written and told, and it exports", fun() ->
                page(Dir)
            end}},
            {timeout, 60, {"a page that cannot be made leaves the case", fun() ->
                no_page(Dir)
            end}},
            {timeout, 60, {"a damaged case is one line", fun() -> damaged(Dir) end}},
            {timeout, 60, {"a model that does not compile is status 3", fun() -> broken(Dir) end}},
            {timeout, 60, {"SIGINT ends with 130 and leaves no process", fun() ->
                ?assertEqual({signal, 2}, signalled(Dir, 2, "1"))
            end}},
            {timeout, 60, {"SIGINT ends a run with workers", fun() ->
                ?assertEqual({signal, 2}, signalled(Dir, 2, "2"))
            end}},
            {timeout, 60, {"kill -9 of a program with workers leaves no process", fun() ->
                ?assertEqual({signal, 9}, signalled(Dir, 9, "2"))
            end}},
            {timeout, 60, {"kill -9 of a worker loses nothing", fun() -> worker_killed(Dir) end}},
            {timeout, 60, {"SIGTERM ends with 130 and leaves no process", fun() ->
                ?assertEqual({signal, 2}, signalled(Dir, 15, "1"))
            end}},
            {timeout, 60, {"kill -9 of the program leaves no process and whole files", fun() ->
                ?assertEqual({signal, 9}, signalled(Dir, 9, "1"))
            end}},
            {timeout, 60, {"kill -9 of the child VM fails its property, the run goes on", fun() ->
                child_killed(Dir)
            end}}
        ]
    end}.

project() ->
    Dir = cb_files:fresh_name("faultcheck-cli", ""),
    {0, _} = said(["new", Dir]),
    {2, _} = said(["new", Dir]),
    ok = file:write_file(filename:join([Dir, "test", "prop_wait.erl"]), waiting()),
    Dir.

%% Tells its VM's pid, then goes on for long.
waiting() ->
    "-module(prop_wait).\n"
    "-include_lib(\"proper/include/proper.hrl\").\n"
    "prop_wait() ->\n"
    "    ?FORALL(_, integer(), begin\n"
    "        New = \"pid.\" ++ os:getpid(),\n"
    "        ok = file:write_file(New, os:getpid()),\n"
    "        ok = file:rename(New, \"pid\"),\n"
    "        timer:sleep(10), true end).\n".

finds(Dir) ->
    {{exit, 1}, Text} = program(Dir, ["proper", "-m", "prop_ring", "--seed", "2"]),
    has("4 commands, shrunk from", Text),
    [Case] = filelib:wildcard(filename:join([Dir, "cases", "prop_ring-*"])),
    Name = filename:join("cases", filename:basename(Case)),
    {{exit, 1}, Replayed} = program(Dir, ["replay", Name]),
    has("prop_ring:add(0) -> 1", Replayed),
    has("as recorded", Replayed),
    {{exit, 0}, Report} = program(Dir, ["report", Name]),
    has("4 commands", Report),
    {{exit, 0}, Report} = program(Dir, ["report", filename:basename(Case)]),
    Source = filename:join([Dir, "c_src", "ring.c"]),
    {ok, C} = file:read_file(Source),
    Repaired = string:replace(C, "count > CAPACITY", "count >= CAPACITY"),
    ok = file:write_file(Source, Repaired),
    {{exit, 0}, _} = program(Dir, ["proper", "-m", "prop_ring", "--seed", "2"]),
    {{exit, 0}, Differs} = program(Dir, ["replay", Name]),
    has("differs from the record", Differs).

%% Fails at once; its report and its export are the functions given.
paged(Module, Functions) ->
    [
        "-module(", Module, ").\n-include_lib(\"faultcheck/include/faultcheck.hrl\").\n",
        "-export([report/2, export/3]).\n", Module, "() ->\n"
        "    ?FORALL(Commands, commands(?MODULE), begin\n"
        "        {_, _, Result} = run_commands(?MODULE, Commands), Result =:= ok end).\n"
        "initial_state() -> none.\n"
        "step_args(_) -> [].\n"
        "step() -> 1.\n"
        "step_post(_, [], Result) -> Result =:= 2.\n" | Functions
    ].

page(Dir) ->
    Functions =
        "report(_, Dir) ->\n"
        "    ok = faultcheck_case:add_file(Dir, \"report.html\", \"a page\"),\n"
        "    #{report => \"report.html\", watch => true, notes => [\"a note\"]}.\n"
        "export(_, Dir, #{format := csv}) ->\n"
        "    ok = faultcheck_case:add_file(Dir, \"x.csv\", \"1\"),\n"
        "    {ok, [filename:join(Dir, \"x.csv\")]};\n"
        "export(_, _, _) -> {error, \"only lines\"}.\n",
    ok = file:write_file(
        filename:join([Dir, "test", "prop_page.erl"]), paged("prop_page", Functions)
    ),
    {{exit, 1}, Text} = program(Dir, ["proper", "-m", "prop_page"]),
    [Case] = filelib:wildcard("cases/prop_page-*", Dir),
    has("report: " ++ Case ++ "/report.html", Text),
    has("watch: faultcheck play " ++ Case, Text),
    has("note: a note", Text),
    File = filename:join([Dir, Case, "report.html"]),
    ok = file:delete(File),
    {{exit, 0}, Again} = program(Dir, ["report", Case]),
    has("report: " ++ Case ++ "/report.html", Again),
    ?assertEqual({ok, <<"a page">>}, file:read_file(File)),
    {{exit, 0}, Written} = program(Dir, ["export", Case, "--csv"]),
    has("written: " ++ Case ++ "/x.csv", Written),
    {{exit, 2}, Refused} = program(Dir, ["export", Case, "--mcap"]),
    has("export: only lines", Refused).

no_page(Dir) ->
    Functions = "report(_, _) -> error(no_paper).\nexport(_, _, _) -> {ok, []}.\n",
    ok = file:write_file(
        filename:join([Dir, "test", "prop_no_page.erl"]), paged("prop_no_page", Functions)
    ),
    {{exit, 1}, Text} = program(Dir, ["proper", "-m", "prop_no_page"]),
    has("note: report/2 of the model failed: error:no_paper", Text),
    [_] = filelib:wildcard("cases/prop_no_page-*/case.json", Dir).

alone(Dir) ->
    Alone = filename:join(Dir, "alone"),
    File = filename:join([Alone, "test", "prop_alone.erl"]),
    ok = filelib:ensure_dir(File),
    {{exit, 3}, Empty} = program(Alone, ["proper"]),
    has("there is nothing to test here: no Erlang file in test/", Empty),
    Text = "-module(prop_alone).\n-include_lib(\"proper/include/proper.hrl\").\n"
           "prop_sum() -> ?FORALL(X, integer(), X + 1 > X).\n",
    ok = file:write_file(File, Text),
    {{exit, 0}, Passed} = program(Alone, ["proper"]),
    has("===> 1/1 properties passed", Passed),
    {{exit, 2}, Nowhere} = program(Dir, ["proper", "-d", "tset"]),
    has("no Erlang file in tset/, here or in an application", Nowhere).

damaged(Dir) ->
    [Case | _] = filelib:wildcard(filename:join([Dir, "cases", "prop_ring-*"])),
    File = filename:join(Case, "case.json"),
    {ok, Text} = file:read_file(File),
    ok = file:write_file(File, binary:part(Text, 0, byte_size(Text) div 2)),
    {{exit, 2}, Said} = program(Dir, ["replay", File]),
    has("damaged or cut short", Said),
    ?assertEqual(1, length(string:split(string:trim(Said), "\n", all))),
    ok = file:write_file(File, Text).

broken(Dir) ->
    File = filename:join([Dir, "test", "prop_broken.erl"]),
    ok = file:write_file(File, "-module(prop_broken).\nprop_broken() -> .\n"),
    {{exit, 3}, Text} = program(Dir, ["proper"]),
    has("prop_broken.erl", Text),
    ok = file:delete(File).

signalled(Dir, Signal, Workers) ->
    Words = ["proper", "-m", "prop_wait", "-n", "100000", "--workers", Workers],
    {Program, Pid} = waiting_program(Dir, Words),
    ok = cb_nif:kill(os_pid(Program), Signal),
    {ended, Ending} = ended(Program),
    ok = gone(Pid),
    Cases = filelib:wildcard(filename:join([Dir, "cases", "*"])),
    ?assertMatch([_ | _], Cases),
    [{ok, _} = faultcheck_case:read(Case) || Case <- Cases],
    {ok, Text} = file:read_file(filename:join(Dir, "log")),
    ?assertEqual(Signal =/= 9, string:find(Text, "===> interrupted") =/= nomatch),
    Ending.

worker_killed(Dir) ->
    Words = ["proper", "-m", "prop_wait", "-n", "100", "--workers", "2"],
    {Program, Pid} = waiting_program(Dir, Words),
    ok = cb_nif:kill(Pid, 9),
    {ended, Ending} = ended(Program),
    ?assertEqual({exit, 0}, Ending),
    {ok, Text} = file:read_file(filename:join(Dir, "log")),
    has("OK: Passed 100 test(s).", Text).

child_killed(Dir) ->
    Words = ["proper", "-p", "prop_wait,prop_ring", "-m", "prop_wait,prop_ring", "-n", "300"],
    {Program, Pid} = waiting_program(Dir, Words),
    ok = cb_nif:kill(Pid, 9),
    {ended, Ending} = ended(Program),
    ?assertEqual({exit, 4}, Ending),
    {ok, Text} = file:read_file(filename:join(Dir, "log")),
    has("the child VM died of signal 9 (SIGKILL)", Text),
    has("Testing prop_wait:prop_wait()", Text),
    has("===> 1/2 properties passed, 1 flaky", Text).

%% ---- OS processes -------------------------------------------------------------------------

%% Runs the program to its end in a directory.
program(Dir, Words) ->
    Program = start(Dir, Words),
    {ended, Ending} = ended(Program),
    {ok, Text} = file:read_file(filename:join(Dir, "log")),
    {Ending, unicode:characters_to_list(Text)}.

start(Dir, Words) ->
    _ = file:delete(filename:join(Dir, "log")),
    Erl = filename:join([code:root_dir(), "bin", "erl"]),
    Paths = lists:append([["-pa", P] || P <- code:get_path(), filename:pathtype(P) =:= absolute]),
    Args = ["+Bd", "-noinput"] ++ Paths ++ ["-s", "faultcheck_cli", "main", "-extra" | Words],
    Libs = filename:dirname(code:lib_dir(faultcheck)),
    {ok, Guard} = cb_guard:start(Erl, Args, #{
        cd => Dir,
        log => filename:join(Dir, "log"),
        env => [{"ERL_LIBS", Libs}, {"FAULTCHECK_CASES", false}]
    }),
    Guard.

ended(Guard) ->
    case cb_guard:next_event(Guard, 50000) of
        {data, _} -> ended(Guard);
        {ended, _} = Ended -> Ended;
        timeout -> {timeout, cb_guard:close(Guard)}
    end.

%% The guard's child is the program.
os_pid(Guard) ->
    Guarding = integer_to_list(cb_guard:os_pid(Guard)),
    File = filename:join(["/proc", Guarding, "task", Guarding, "children"]),
    {ok, Children} = file:read_file(File),
    [Pid | _] = string:lexemes(Children, " \n"),
    binary_to_integer(Pid).

%% Started, and in the middle of a test: the property has written the pid of its VM.
waiting_program(Dir, Words) ->
    File = filename:join(Dir, "pid"),
    _ = file:delete(File),
    Program = start(Dir, Words),
    Pid = poll(fun() -> file:read_file(File) end, fun({ok, Text}) -> binary_to_integer(Text) end),
    {Program, Pid}.

gone(Pid) ->
    poll(fun() -> cb_nif:kill(Pid, 0) end, fun({error, esrch}) -> ok end).

%% Files of other processes give no event: looks every 20 ms, at most 30 s.
poll(Look, Match) -> poll(Look, Match, 1500).

poll(Look, Match, Left) when Left > 0 ->
    Seen = Look(),
    try
        Match(Seen)
    catch
        error:function_clause ->
            receive
            after 20 -> poll(Look, Match, Left - 1)
            end
    end.

has(Part, Text) ->
    case string:find(Text, Part) of
        nomatch -> error({missing, Part, {in, Text}});
        _ -> ok
    end.

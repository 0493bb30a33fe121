%% @doc The program `bin/faultcheck'.
-module(faultcheck_cli).

-export([main/0, run/1, watch/0]).

-define(USAGE_ERROR, 2).
-define(NOT_BUILT, 3).

%% @doc Runs the words of the command line and ends the VM with the exit status.
-spec main() -> no_return().
main() ->
    %% What is printed may be more than Latin-1.
    _ = io:setopts([{encoding, unicode}]),
    erlang:halt(run(init:get_plain_arguments())).

-spec run([string()]) -> 0..255.
run(["help", Command]) ->
    run([Command, "--help"]);
run([Help | _]) when Help =:= "help"; Help =:= "--help"; Help =:= "-h" ->
    say("~ts", [usage()], 0);
run([Version]) when Version =:= "version"; Version =:= "--version" ->
    say("~ts~n", [faultcheck_versions:text(faultcheck_versions:all())], 0);
run([Command, Help | _]) when Help =:= "--help"; Help =:= "-h" ->
    case usage(Command) of
        none -> run([Command]);
        Text -> say("~ts", [Text], 0)
    end;
run(["new", [$- | _] = Option]) ->
    say("new: unknown option ~ts; what is wanted is the name of a folder to make (see faultcheck "
        "new --help)~n", [Option], ?USAGE_ERROR);
run(["new", Dir]) ->
    case faultcheck_project:new(Dir) of
        {ok, Lines} -> say("~ts~n", [lists:join($\n, Lines)], 0);
        {error, Line} -> say("~ts~n", [Line], ?USAGE_ERROR)
    end;
run(["proper" | Words]) ->
    case lists:member("--help", Words) orelse lists:member("-h", Words) of
        true -> say("~ts", [usage("proper")], 0);
        false -> proper(faultcheck_options:parse(Words))
    end;
run(["replay", Path]) ->
    stored(Path, fun(Case, _) -> replay({Case, shrunk}) end);
run(["replay", "--original", Path]) ->
    stored(Path, fun(Case, _) -> replay({Case, original}) end);
run(["replay", Path, "--original"]) ->
    run(["replay", "--original", Path]);
run(["report", Path]) ->
    stored(Path, fun report/2);
run(["export" | Words]) ->
    case faultcheck_export:parse(Words) of
        {ok, Path, What} -> stored(Path, fun(Case, Dir) -> export(Case, Dir, What) end);
        {error, Line} -> say("~ts~n", [Line], ?USAGE_ERROR)
    end;
run([Command]) when Command =:= "replay"; Command =:= "report" ->
    say("~ts: say which case: faultcheck ~ts CASE~n", [Command, Command], ?USAGE_ERROR);
run([Word | _]) ->
    Words = ["new", "proper", "replay", "play", "report", "export", "version", "help"],
    case lists:member(Word, Words) of
        true -> say("~ts: wrong arguments; ~ts~n", [Word, synopsis(Word)], ?USAGE_ERROR);
        false -> unknown(Word, Words)
    end;
run([]) ->
    say("~ts", [usage()], ?USAGE_ERROR).

unknown(Word, Words) ->
    Near = faultcheck_suggest:phrase(Word, Words),
    say("faultcheck: unknown command ~ts~ts (see faultcheck --help)~n", [Word, Near], ?USAGE_ERROR).

usage() ->
    "Usage: faultcheck COMMAND\n\n"
    "  new DIR                     make a project: a C file with a bug and a model that finds it\n"
    "  proper [options]            run the properties of the project here\n"
    "  replay CASE [--original]    run a stored case again, each command with its result\n"
    "  play CASE [options]         play a stored case or a live flight for the visualizer\n"
    "  report CASE                 print a stored case; its model writes report.html anew\n"
    "  export CASE --mcap|--csv|--svg\n"
    "                              write a stored case for other programs\n"
    "  version                     versions of FaultCheck, PropEr and Erlang/OTP\n"
    "  COMMAND --help              more on a command\n\n" ++ exit_statuses().

exit_statuses() ->
    "Exit status: 0 passed, 1 a property failed, 2 wrong usage or input, 3 the code under test\n"
    "could not be built or started, 4 only flaky failures, 130 interrupted.\n".

usage("new") ->
    synopsis("new") ++ "\n\n"
    "Makes the folder DIR with a small C file that has a bug, a model that finds it, and what\n"
    "rebar3 wants of a project. A folder that holds anything is left as it is.\n";
usage("proper") ->
    synopsis("proper") ++ "\n\n"
    "Compiles the project in the current folder and tests the properties prop_*/0 of the modules\n"
    "prop_* in test/. A failure is shrunk and stored as a folder in cases/ (FAULTCHECK_CASES\n"
    "names another place).\n\n" ++ faultcheck_options:help() ++ "\n" ++ exit_statuses();
usage("replay") ->
    synopsis("replay") ++ "\n\n"
    "Runs a stored case again and prints each command with its result. CASE is a folder below\n"
    "cases/ or its name alone, or a case.json. The project in the current folder is\n"
    "compiled first.\n\n"
    "  --original    the failure as it was found, before it was shrunk\n\n" ++ exit_statuses();
usage("report") ->
    synopsis("report") ++ "\n\n"
    "Prints a stored case. A model that exports report/2 adds files to its folder, anew each\n"
    "time; report.html is the one to open.\n";
usage("export") ->
    synopsis("export") ++ "\n\n"
    "Writes a stored case for other programs, if its model exports export/3.\n\n" ++
    faultcheck_export:help() ++ "\n" ++ exit_statuses();
usage("version") ->
    synopsis("version") ++ "\n";
usage(_) ->
    none.

synopsis("new") -> "Usage: faultcheck new DIR";
synopsis("proper") -> "Usage: faultcheck proper [options]";
synopsis("replay") -> "Usage: faultcheck replay CASE [--original]";
synopsis("play") -> "Usage: faultcheck play [CASE] [options] (see faultcheck play --help)";
synopsis("report") -> "Usage: faultcheck report CASE";
synopsis("export") ->
    "Usage: faultcheck export CASE --mcap|--csv|--svg [--at SECONDS] [--out FILE]";
synopsis("version") -> "Usage: faultcheck version";
synopsis("help") -> "Usage: faultcheck --help".

say(Format, Args, Status) ->
    io:format(Format, Args),
    Status.

proper({error, Line}) ->
    say("~ts~n", [Line], ?USAGE_ERROR);
proper({ok, Options}) ->
    built(Options, fun faultcheck_runner:run/1).

built(Options, Fun) ->
    ok = faultcheck_project:repair_plugin_link(),
    case faultcheck_build:project(maps:get(dir, Options)) of
        {ok, Built} -> Fun(request(Options, Built));
        {error, Text} -> say("~ts~n", [Text], ?NOT_BUILT)
    end.

request(Options, Built) ->
    Built#{
        options => Options,
        command => "faultcheck proper",
        replay => "faultcheck replay",
        watch => watch()
    }.

%% @doc What the folder of a case is put behind, to watch it in the visualizer: in a clone make does
%% it, and builds what is missing.
-spec watch() -> string().
watch() ->
    case filelib:is_regular("bin/faultcheck") of
        true -> "make visualizer CASE=";
        false -> "faultcheck play "
    end.

%% Calls Fun(Case, Dir) with the case that the user names.
stored(Given, Fun) ->
    case faultcheck_case:find(Given, faultcheck_case:directory()) of
        {ok, Path} -> read(Path, Fun);
        {error, Line} -> say("~ts~n", [Line], ?USAGE_ERROR)
    end.

read(Path, Fun) ->
    case faultcheck_case:read(Path) of
        {ok, Case} -> Fun(Case, folder(Path));
        {error, Line} -> say("~ts~n", [Line], ?USAGE_ERROR)
    end.

replay({Case, _} = What) ->
    built(options(Case), fun(Request) -> faultcheck_replay:replay(What, Request) end).

%% The test directories are those of the recorded run.
options(#{options := Words}) ->
    case faultcheck_options:parse(Words) of
        {ok, Options} -> maps:with([dir, verbose, timeout, sys_config], Options);
        {error, _} -> maps:with([dir, verbose], element(2, faultcheck_options:parse([])))
    end.

report(Case, Dir) ->
    built(options(Case), fun(Request) -> faultcheck_replay:report(Case, Dir, Request) end).

export(Case, Dir, What) ->
    built(options(Case), fun(Request) -> faultcheck_replay:export(Case, Dir, What, Request) end).

folder(Path) ->
    case filelib:is_dir(Path) of
        true -> Path;
        false -> filename:dirname(Path)
    end.

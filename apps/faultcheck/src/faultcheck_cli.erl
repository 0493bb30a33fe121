%% @doc The program `bin/faultcheck'.
-module(faultcheck_cli).

-export([main/0, run/1]).

-define(USAGE_ERROR, 2).
-define(NOT_BUILT, 3).

%% @doc Runs the words of the command line and ends the VM with the exit status.
-spec main() -> no_return().
main() ->
    %% What is printed may be more than Latin-1.
    _ = io:setopts([{encoding, unicode}]),
    erlang:halt(run(init:get_plain_arguments())).

-spec run([string()]) -> 0..255.
run([Help | _]) when Help =:= "help"; Help =:= "--help"; Help =:= "-h" ->
    say("~ts", [usage()], 0);
run([Version]) when Version =:= "version"; Version =:= "--version" ->
    say("~ts~n", [faultcheck_versions:text(faultcheck_versions:all())], 0);
run(["new", Dir]) ->
    case faultcheck_project:new(Dir) of
        {ok, Lines} -> say("~ts~n", [lists:join($\n, Lines)], 0);
        {error, Line} -> say("~ts~n", [Line], ?USAGE_ERROR)
    end;
run(["proper" | Words]) ->
    case lists:member("--help", Words) of
        true -> say("Usage: faultcheck proper [options]~n~n~ts", [faultcheck_options:help()], 0);
        false -> proper(faultcheck_options:parse(Words))
    end;
run(["replay", Path]) ->
    stored(Path, fun(Case) -> replay({Case, shrunk}) end);
run(["replay", "--original", Path]) ->
    stored(Path, fun(Case) -> replay({Case, original}) end);
run(["replay", Path, "--original"]) ->
    run(["replay", "--original", Path]);
run(["report", Path]) ->
    stored(Path, fun(Case) -> report(Case, Path) end);
run([Word | _]) ->
    Words = ["new", "proper", "replay", "report", "version", "help"],
    case lists:member(Word, Words) of
        true -> say("~ts: wrong arguments (see faultcheck --help)~n", [Word], ?USAGE_ERROR);
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
    "  proper [options]            run the properties of the project here (--help: the options)\n"
    "  replay CASE [--original]    run a stored case again, each command with its result\n"
    "  report CASE                 print a stored case; its model may add files to it\n"
    "  version\n\n"
    "Exit status: 0 passed, 1 a property failed, 2 wrong usage or input, 3 the code under test\n"
    "could not be built or started, 4 only flaky failures, 130 interrupted.\n".

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
    Built#{options => Options, command => "faultcheck proper", replay => "faultcheck replay"}.

stored(Path, Fun) ->
    case faultcheck_case:read(Path) of
        {ok, Case} -> Fun(Case);
        {error, Line} -> say("~ts~n", [Line], ?USAGE_ERROR)
    end.

replay({Case, _} = What) ->
    built(options(Case), fun(Request) -> faultcheck_runner:replay(What, Request) end).

%% The test directories are those of the recorded run.
options(#{options := Words}) ->
    case faultcheck_options:parse(Words) of
        {ok, Options} -> maps:with([dir, verbose, timeout, sys_config], Options);
        {error, _} -> maps:with([dir, verbose], element(2, faultcheck_options:parse([])))
    end.

report(Case, Path) ->
    Dir =
        case filelib:is_dir(Path) of
            true -> Path;
            false -> filename:dirname(Path)
        end,
    built(options(Case), fun(Request) -> faultcheck_runner:report(Case, Dir, Request) end).

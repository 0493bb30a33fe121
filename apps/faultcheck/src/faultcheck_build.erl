%% @doc Compiles a project and tells where its properties are: with rebar3 where it is installed,
%% otherwise the sources in `src/' and the test directories alone.
-module(faultcheck_build).

-export([project/1, directory/3]).
-export_type([built/0]).

-type built() :: #{
    places := [faultcheck_discovery:place()],
    paths := [file:filename()],
    cover_dirs := [file:filename()],
    base_dir := file:filename()
}.

-define(BASE, "_build/test").

%% @doc Compiles the project in the current directory; Dirs are its test directories. The error
%% is a text for the user.
-spec project([file:filename()]) -> {ok, built()} | {error, string()}.
project(Dirs) ->
    Apps = applications(),
    Rebar = os:find_executable("rebar3"),
    case compile(Rebar, Apps, Dirs) of
        ok -> {ok, built(Apps, Dirs)};
        {error, _} = Error -> Error
    end.

%% The project's applications: their names and directories.
applications() ->
    [
        {filename:basename(File, ".app.src"), filename:dirname(filename:dirname(File))}
     || Pattern <- ["src/*.app.src", "apps/*/src/*.app.src", "lib/*/src/*.app.src"],
        File <- filelib:wildcard(Pattern)
    ].

compile(_, [], Dirs) ->
    %% Nothing that rebar3 would build: properties alone, over C code.
    case places([], Dirs) of
        [] ->
            {error, text("there is nothing to test here: no Erlang file in ~ts, and neither "
                         "src/NAME.app.src nor apps/*/src/NAME.app.src (faultcheck new DIR makes "
                         "a project)", [lists:join(" or ", [D ++ "/" || D <- Dirs])])};
        _ ->
            directories(places([], Dirs), [])
    end;
compile(false, Apps, Dirs) ->
    directories(sources(Apps) ++ places(Apps, Dirs), Apps);
compile(Rebar, Apps, Dirs) ->
    case command(Rebar, ["as", "test", "compile"]) of
        {0, _} ->
            Others = [Dir || Dir <- Dirs, Dir =/= "test"],
            directories(places(Apps, Others), Apps);
        {_, Output} ->
            {error, "rebar3 as test compile failed:\n" ++ string:trim(Output)}
    end.

directories(Places, Apps) ->
    first_error([
        fun() -> directory(Sources, Beams, options(Apps)) end
     || {Sources, Beams} <- Places
    ]).

first_error([]) ->
    ok;
first_error([Step | Rest]) ->
    case Step() of
        ok -> first_error(Rest);
        {error, _} = Error -> Error
    end.

sources(Apps) ->
    [{filename:join(Dir, "src"), filename:join([?BASE, "lib", App, "ebin"])} || {App, Dir} <- Apps].

%% Where rebar3 puts the beams of test directories.
places(Apps, Dirs) ->
    OfApps = [
        {join(Dir, Test), filename:join([?BASE, "lib", App, Test])}
     || {App, Dir} <- Apps, Test <- Dirs
    ],
    OfRoot = [{Test, filename:join([?BASE, "extras", Test])} || Test <- Dirs],
    Places = OfApps ++ [P || {Sources, _} = P <- OfRoot, not lists:keymember(Sources, 1, OfApps)],
    [P || {Sources, _} = P <- Places, filelib:wildcard("*.erl", Sources) =/= []].

join(".", Test) -> Test;
join(Dir, Test) -> filename:join(Dir, Test).

options(Apps) ->
    Includes = [{i, filename:join(Dir, I)} || {_, Dir} <- Apps, I <- ["include", "src"]],
    [debug_info | Includes].

built(Apps, Dirs) ->
    Places = places(Apps, Dirs),
    Ebins = [filename:join([?BASE, "lib", App, "ebin"]) || {App, _} <- Apps],
    Deps = filelib:wildcard(filename:join([?BASE, "lib", "*", "ebin"])),
    Paths = [Beams || {_, Beams} <- Places] ++ lists:usort(Ebins ++ Deps),
    #{
        places => Places,
        paths => [filename:absname(P) || P <- Paths],
        cover_dirs => Ebins,
        base_dir => ?BASE
    }.

%% @doc Compiles the Erlang files of a directory into another. The error names the file.
-spec directory(file:filename(), file:filename(), [term()]) -> ok | {error, string()}.
directory(Sources, Beams, Options) ->
    ok = filelib:ensure_dir(filename:join(Beams, "x")),
    All = [{outdir, Beams}, {i, Sources}, return | Options],
    Files = lists:sort(filelib:wildcard("*.erl", Sources)),
    first_error([fun() -> file(filename:join(Sources, F), All) end || F <- Files]).

file(File, Options) ->
    case compile:file(File, Options) of
        {ok, _} -> ok;
        {ok, _, _Warnings} -> ok;
        {error, Errors, _} -> {error, lists:append([messages(F, Es) || {F, Es} <- Errors])}
    end.

messages(File, Errors) ->
    lists:append(lists:join("\n", [message(File, E) || E <- Errors])).

message(File, {none, Module, What}) ->
    text("~ts: ~ts", [File, Module:format_error(What)]);
message(File, {Where, Module, What}) ->
    text("~ts:~ts: ~ts", [File, where(Where), Module:format_error(What)]).

where({Line, Column}) -> text("~b:~b", [Line, Column]);
where(Line) -> integer_to_list(Line).

command(Program, Args) ->
    Port = open_port({spawn_executable, Program}, [
        {args, Args}, exit_status, stderr_to_stdout, in, binary, {env, [{"QUIET", "1"}]}
    ]),
    collect(Port, <<>>).

collect(Port, Text) ->
    receive
        {Port, {data, More}} -> collect(Port, <<Text/binary, More/binary>>);
        {Port, {exit_status, Status}} -> {Status, unicode:characters_to_list(Text)}
    end.

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

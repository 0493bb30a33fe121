%% @doc `faultcheck new DIR': a project that finds a bug in a C file, to begin from.
-module(faultcheck_project).

-export([new/1, repair_plugin_link/0]).

-define(PLUGIN_LINK, "_checkouts/rebar3_faultcheck").

%% @doc Makes the project and answers what to do next; the error is a line for the user.
-spec new(file:filename()) -> {ok, [string()]} | {error, string()}.
new(Dir) ->
    case file:list_dir(Dir) of
        {ok, [_ | _]} -> {error, text("~ts is not empty; choose a new directory", [Dir])};
        {error, enotdir} -> {error, text("~ts is a file; choose a new directory", [Dir])};
        _ -> write(Dir, files())
    end.

write(Dir, []) ->
    _ = link_plugin(filename:join(Dir, ?PLUGIN_LINK)),
    {ok, [
        text("made ~ts; c_src/ring.c has a bug, test/prop_ring.erl finds it:", [Dir]),
        text("  cd ~ts && faultcheck proper", [Dir])
    ]};
write(Dir, [{Name, Text} | Rest]) ->
    File = filename:join(Dir, Name),
    case {filelib:ensure_dir(File), file:write_file(File, Text)} of
        {ok, ok} -> write(Dir, Rest);
        {{error, Why}, _} -> {error, text("~ts: ~ts", [File, file:format_error(Why)])};
        {_, {error, Why}} -> {error, text("~ts: ~ts", [File, file:format_error(Why)])}
    end.

%% @doc `rebar3 proper' finds its plugin through a link in the project. This FaultCheck may be at
%% another place than the one that made the project.
-spec repair_plugin_link() -> ok.
repair_plugin_link() ->
    case {file:read_link(?PLUGIN_LINK), filelib:is_dir(?PLUGIN_LINK)} of
        {{ok, _}, false} ->
            _ = file:delete(?PLUGIN_LINK),
            _ = link_plugin(?PLUGIN_LINK),
            ok;
        _ ->
            ok
    end.

link_plugin(Link) ->
    Home = os:getenv("FAULTCHECK_HOME", ""),
    Installed = filelib:wildcard(filename:join(Home, "lib/faultcheck/rebar3_faultcheck-*")),
    case Installed ++ [D || D <- [filename:join(Home, ?PLUGIN_LINK)], filelib:is_dir(D)] of
        [Plugin | _] ->
            ok = filelib:ensure_dir(Link),
            file:make_symlink(Plugin, Link);
        [] ->
            {error, enoent}
    end.

files() ->
    Dir = filename:join(templates(), "new"),
    [
        {target(Name), read(filename:join(Dir, Name))}
     || Name <- filelib:wildcard("**/*", Dir), filelib:is_regular(filename:join(Dir, Name))
    ].

target("gitignore") -> ".gitignore";
target(Name) -> Name.

read(File) ->
    {ok, Text} = file:read_file(File),
    Text.

templates() ->
    case code:priv_dir(faultcheck) of
        {error, bad_name} ->
            Ebin = filename:dirname(code:which(?MODULE)),
            filename:join(filename:dirname(Ebin), "priv");
        Priv ->
            Priv
    end.

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

%% @doc `rebar3 proper': compiles the test profile, finds the properties and hands them to
%% faultcheck_runner, whose answer is the exit status.
%%
%% The options' table is faultcheck_options; this plugin holds a link to it, since it has to know
%% the options before the applications of the project are compiled.
-module(rebar3_faultcheck).

-export([init/1, do/1, format_error/1]).

-spec init(term()) -> {ok, term()}.
init(State) ->
    ok = check_command_line(init:get_plain_arguments()),
    ok = code:add_pathsz(beside_link(file:read_link("_checkouts/rebar3_faultcheck"))),
    Provider = providers:create([
        {name, proper},
        {module, ?MODULE},
        {profiles, [test]},
        {bare, true},
        {deps, [compile]},
        {example, "rebar3 proper -m prop_stack -n 1000"},
        {opts, faultcheck_options:getopt()},
        {short_desc, "Run PropEr properties, with C code under test in a child VM."},
        {desc, "Run PropEr properties. What they call runs in a child VM: C code that crashes or\n"
               "hangs is a failed property, shrunk and stored like any other."}
    ]),
    {ok, rebar_state:add_provider(State, Provider)}.

%% A project made by `faultcheck new' has a link to the plugin of its FaultCheck, installed or a
%% clone: the applications are beside it. In the clone itself they are the project's own.
beside_link({ok, Plugin}) ->
    Installed = filename:dirname(Plugin),
    Clone = filename:join(filename:dirname(Installed), "_build/default/lib"),
    lists:append([filelib:wildcard(filename:join(Dir, "*/ebin")) || Dir <- [Installed, Clone]]);
beside_link({error, _}) ->
    [].

%% rebar3 would answer a wrong option with status 1 and no suggestion. Where the whole command
%% line is ours, it is read before rebar3 does.
check_command_line([_Rebar3, "proper" | Words]) -> check_words(Words);
check_command_line([_Rebar3, "as", _Profiles, "proper" | Words]) -> check_words(Words);
check_command_line(_) -> ok.

check_words(Words) ->
    case lists:any(fun(W) -> lists:member(W, ["-h", "--help"]) end, Words) of
        true -> halt_with(0, "Usage: rebar3 proper [options]\n\n" ++ faultcheck_options:help());
        false -> check_parsed(faultcheck_options:parse(Words))
    end.

check_parsed({ok, _}) -> ok;
check_parsed({error, Line}) -> halt_with(2, Line).

-spec halt_with(0..255, string()) -> no_return().
halt_with(Status, Line) ->
    io:put_chars([Line, $\n]),
    erlang:halt(Status).

-spec do(term()) -> {ok, term()} | {error, string()}.
do(State) ->
    ok = code:add_pathsa(rebar_state:code_paths(State, all_deps)),
    case {code:ensure_loaded(faultcheck_runner), options(State)} of
        {{module, _}, {ok, Options}} -> finished(run(Options, State), State);
        {_, {error, Line}} -> halt_with(2, Line);
        {{error, _}, _} -> halt_with(2, missing())
    end.

missing() ->
    "FaultCheck is not on the code path: set ERL_LIBS to its lib/faultcheck, or run"
    " `faultcheck proper'".

%% From the command line, then from proper_opts in rebar.config.
options(State) ->
    {Parsed, _} = rebar_state:command_parsed_args(State),
    Words = lists:append([words(O) || O <- Parsed]),
    case {faultcheck_options:parse(Words), configured(State)} of
        {{ok, Given}, {ok, Configured}} -> {ok, maps:merge(Given, left(Configured, Words))};
        {{error, _} = Error, _} -> Error;
        {_, {error, Line}} -> {error, "rebar.config, proper_opts: " ++ Line}
    end.

%% rebar3 has parsed the line already; the words are the same again.
words({Key, true}) -> ["--" ++ atom_to_list(Key)];
words({Key, false}) -> ["--" ++ atom_to_list(Key), "false"];
words({Key, Value}) -> ["--" ++ atom_to_list(Key), lists:concat([Value])].

configured(State) -> faultcheck_options:check(rebar_state:get(State, proper_opts, [])).

left(Configured, Words) ->
    maps:filter(fun(Key, _) -> not lists:member("--" ++ atom_to_list(Key), Words) end, Configured).

run(Options, State) ->
    Dirs = maps:get(dir, Options),
    Places = places(Dirs, State),
    ok = compile_others(Dirs, Places, State),
    faultcheck_runner:run(#{
        options => Options,
        places => Places,
        paths => [Beams || {_, Beams} <- Places] ++ rebar_state:code_paths(State, all_deps),
        base_dir => rebar_dir:base_dir(State),
        cover_dirs => [filename:join(rebar_app_info:out_dir(A), "ebin") || A <- apps(State)],
        command => "rebar3 proper",
        replay => replay_command(),
        watch => faultcheck_cli:watch()
    }).

apps(State) -> [A || A <- rebar_state:project_apps(State), not rebar_app_info:is_checkout(A)].

%% The test directories of the applications and of the root, with the places of their beams.
places(Dirs, State) ->
    Apps = [
        {filename:join(rebar_app_info:dir(A), Dir), filename:join(rebar_app_info:out_dir(A), Dir)}
     || A <- apps(State), Dir <- Dirs
    ],
    Root = [
        {filename:absname(Dir), filename:join([rebar_dir:base_dir(State), "extras", Dir])}
     || Dir <- Dirs
    ],
    Places = Apps ++ [R || {Sources, _} = R <- Root, not lists:keymember(Sources, 1, Apps)],
    [P || {Sources, _} = P <- Places, filelib:wildcard("*.erl", Sources) =/= []].

%% rebar3 compiles the directory `test' in the test profile; others are compiled here.
compile_others(["test"], _Places, _State) ->
    ok;
compile_others(_Dirs, Places, State) ->
    Options = rebar_opts:erl_opts(rebar_state:opts(State)),
    Includes = [
        {i, filename:join(rebar_app_info:dir(A), Dir)}
     || A <- apps(State), Dir <- ["include", "src"]
    ],
    lists:foreach(
        fun({Sources, Beams}) ->
            case faultcheck_build:directory(Sources, Beams, Includes ++ Options) of
                ok -> ok;
                {error, Text} -> halt_with(2, Text)
            end
        end,
        Places
    ).

%% In a clone the program is bin/faultcheck; installed, it is on the path.
replay_command() ->
    case filelib:is_regular("bin/faultcheck") of
        true -> "bin/faultcheck replay";
        false -> "faultcheck replay"
    end.

%% rebar3 knows the statuses 0 and 1 only.
finished(0, State) -> {ok, State};
finished(Status, _State) -> erlang:halt(Status).

-spec format_error(term()) -> string().
format_error(Reason) -> lists:flatten(io_lib:format("~0tp", [Reason])).

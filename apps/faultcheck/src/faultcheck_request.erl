%% @doc What a user asks for, what he is told, and the child VMs that serve him.
-module(faultcheck_request).

-export([say/3, warn/3, printer/1, with_session/2, context/1]).
-export_type([request/0, run/0]).

-type request() :: #{
    options := faultcheck_options:options(),
    %% all that there are; the options choose
    places := [faultcheck_discovery:place()],
    %% code paths of the project, for the child
    paths := [file:filename()],
    %% where the last counterexamples and the files of this run are
    base_dir := file:filename(),
    %% where beams are that `--cover' counts
    cover_dirs := [file:filename()],
    %% how the user calls this: `rebar3 proper', and `faultcheck replay'
    command := string(),
    replay := string(),
    %% what a case's folder is put behind, to watch it in the visualizer
    watch => string(),
    print => fun((iodata()) -> ok),
    terminal => boolean()
}.
-type run() :: #{
    request := request(),
    seed := non_neg_integer(),
    versions := faultcheck_versions:versions(),
    work_dir := file:filename(),
    team => faultcheck_team:team()
}.

%% ---- what the user is told ----------------------------------------------------------------

%% @doc Prints a line.
-spec say(string(), [term()], request()) -> ok.
say(Format, Args, Request) ->
    (printer(Request))(unicode:characters_to_binary(io_lib:format(Format ++ "~n", Args))).

%% @doc Prints a line when versions differ in what the text says.
-spec warn([unicode:chardata()], string(), request()) -> ok.
warn([], _What, _Request) ->
    ok;
warn(Differences, What, Request) ->
    say("warning: ~ts: ~ts", [What, lists:join("; ", Differences)], Request).

%% @doc What prints.
-spec printer(request()) -> fun((iodata()) -> ok).
printer(Request) -> maps:get(print, Request, fun io:put_chars/1).

%% ---- a session ----------------------------------------------------------------------------

%% @doc Calls a function with a session, and ends the session whatever happens. Files of the run
%% are removed.
-spec with_session(request(), fun((run(), faultcheck_session:session()) -> {Result, Session})) ->
    Result
when
    Session :: faultcheck_session:session().
with_session(#{options := Options, base_dir := Base} = Request, Fun) ->
    WorkDir = work_dir(Base),
    Run = #{
        request => Request,
        seed => maps:get(seed, Options, new_seed()),
        versions => faultcheck_versions:all(),
        work_dir => WorkDir
    },
    ok = faultcheck_interrupt:install(self()),
    Session = faultcheck_session:new(config(Run)),
    Team = faultcheck_team:new(maps:get(workers, Options, 1), config(Run)),
    try
        {Result, Last} = Fun(Run#{team => Team}, Session),
        _ = faultcheck_session:stop(Last),
        Result
    after
        ok = faultcheck_team:stop(Team),
        ok = faultcheck_interrupt:remove(),
        _ = file:del_dir_r(WorkDir)
    end.

%% @doc What an outcome is made in.
-spec context(run()) -> faultcheck_outcome:context().
context(#{request := Request} = Run) ->
    maps:merge(
        maps:with([options, command, replay, watch], Request),
        maps:with([seed, versions, team], Run)
    ).

%% Different in every run, also of runs begun at the same moment.
new_seed() ->
    erlang:phash2({os:system_time(nanosecond), os:getpid(), make_ref()}, 1 bsl 32).

%% The files of this run; those of runs that were killed are removed.
work_dir(Base) ->
    Root = filename:join(Base, "faultcheck"),
    lists:foreach(
        fun(Name) ->
            Dead = cb_nif:kill(list_to_integer(Name), 0) =:= {error, esrch},
            Dead andalso file:del_dir_r(filename:join(Root, Name))
        end,
        [N || N <- filelib:wildcard("*", Root), element(2, string:to_integer(N)) =:= ""]
    ),
    filename:join(Root, os:getpid()).

config(#{request := #{options := Options} = Request, work_dir := WorkDir}) ->
    Child = #{work_dir => WorkDir, paths => maps:get(paths, Request), env => []},
    Config = [{config, File} || {ok, File} <- [maps:find(sys_config, Options)]],
    #{
        child => maps:merge(maps:merge(Child, maps:from_list(Config)), cover(Options, Request)),
        print => printer(Request),
        terminal => maps:get(terminal, Request, is_terminal()),
        verbose => maps:get(verbose, Options, true)
    }.

%% Whether what is printed goes to a terminal.
is_terminal() ->
    case file:read_link("/proc/self/fd/1") of
        {ok, "/dev/pts/" ++ _} -> true;
        {ok, "/dev/tty" ++ _} -> true;
        _ -> false
    end.

cover(#{cover := true}, #{cover_dirs := Dirs, base_dir := Base}) ->
    File = filename:join([Base, "cover", "proper.coverdata"]),
    ok = filelib:ensure_dir(File),
    #{cover => #{dirs => Dirs, file => File}};
cover(_, _) ->
    #{}.

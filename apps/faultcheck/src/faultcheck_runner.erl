%% @doc Runs properties and answers with the exit status.
%%
%% This VM never loads code under test: properties run in a child VM (faultcheck_session,
%% faultcheck_child), and a child that dies or hangs is a failed property (faultcheck_rescue), after
%% which the run goes on with the next one. `rebar3 proper' and `faultcheck proper' are the callers.
-module(faultcheck_runner).

-export([run/1, replay/2, report/3]).
-export_type([request/0, outcome/0, status/0]).

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
    print => fun((iodata()) -> ok),
    terminal => boolean()
}.
-type status() :: 0..4 | 130.
-type outcome() :: #{
    property := {module(), atom()},
    status := passed | failed | flaky | unstarted | error,
    tests := non_neg_integer(),
    ms := non_neg_integer(),
    atom() => term()
}.

-define(INTERRUPTED, 130).
-define(USAGE, 2).

-record(run, {
    request :: request(),
    options :: faultcheck_options:options(),
    seed :: non_neg_integer(),
    versions :: faultcheck_versions:versions(),
    work_dir :: file:filename()
}).

%% @doc Does what the options say and answers with the exit status of the program.
-spec run(request()) -> status().
run(#{options := Options, places := Places} = Request) ->
    Named = maps:get(module, Options, []),
    case faultcheck_discovery:find(Places, Named) of
        {ok, Found} -> run(faultcheck_discovery:select(Options, Found), Found, Request);
        {error, Line} -> usage(Line, Request)
    end.

run({error, Line}, _Found, Request) ->
    usage(Line, Request);
run({ok, Properties}, Found, #{options := Options, base_dir := Base} = Request) ->
    Last = faultcheck_store:last_file(Base),
    Kept = faultcheck_store:regression_file(hd(maps:get(dir, Options))),
    case Options of
        #{store := true} -> store(Last, Kept, Request);
        #{retry := true} -> again(Last, "no counterexamples to run", Properties, Found, Request);
        #{regressions := true} -> again(Kept, "no regressions to run", Properties, Found, Request);
        _ -> tests(Properties, Last, Request)
    end.

usage(Line, Request) ->
    say("~ts", [Line], Request),
    ?USAGE.

say(Format, Args, Request) ->
    (printer(Request))(unicode:characters_to_binary(io_lib:format(Format ++ "~n", Args))).

printer(Request) -> maps:get(print, Request, fun io:put_chars/1).

%% ---- kinds of runs ------------------------------------------------------------------------

store(Last, Kept, Request) ->
    case faultcheck_store:read(Last) of
        {ok, Entries} ->
            case faultcheck_store:add(Kept, Entries) of
                {ok, Added} ->
                    Counts = [Added, length(Entries), Kept],
                    say("===> stored ~b of ~b counterexamples in ~ts", Counts, Request),
                    0;
                {error, Line} ->
                    usage(Line, Request)
            end;
        {error, enoent} ->
            say("===> no counterexamples to store", [], Request),
            0;
        {error, Line} ->
            usage(Line, Request)
    end.

tests([], _Last, Request) ->
    say("===> 0/0 properties passed; no prop_* module in the test directories", [], Request),
    0;
tests(Properties, Last, #{options := Options} = Request) ->
    Now = faultcheck_versions:all(),
    Then = maps:get(seed_versions, Options, Now),
    warn(faultcheck_versions:differences(Then, Now), "the seed may give other tests here", Request),
    Jobs = [{Property, run} || Property <- Properties],
    session(Jobs, Request, fun(Outcomes) -> keep_last(Last, Outcomes, Request) end).

warn([], _What, _Request) ->
    ok;
warn(Differences, What, Request) ->
    say("warning: ~ts: ~ts", [What, lists:join("; ", Differences)], Request).

%% The failures of this run take the place of those before; when all passed, they stay.
keep_last(File, Outcomes, Request) ->
    Failed = [
        {M, F, CounterExample}
     || #{property := {M, F}, status := S, shrunk := CounterExample} <- Outcomes,
        S =:= failed orelse S =:= flaky
    ],
    case Failed =/= [] andalso faultcheck_store:write(File, Failed) of
        {error, Line} -> say("~ts", [Line], Request);
        _ -> ok
    end.

again(File, Nothing, Properties, Found, Request) ->
    case faultcheck_store:read(File) of
        {ok, Entries} -> checks(File, Entries, Properties, Found, Request);
        {error, enoent} -> checks(Nothing, Request);
        {error, Line} -> usage(Line, Request)
    end.

checks(Nothing, Request) ->
    say("===> ~ts", [Nothing], Request),
    0.

checks(File, Entries, Properties, Found, Request) ->
    Known = [{M, F} || {M, Fs} <- Found, F <- Fs],
    case [{M, F} || {M, F, _} <- Entries, not lists:member({M, F}, Known)] of
        [] ->
            Jobs = [{{M, F}, {check, C}} || {M, F, C} <- Entries, lists:member({M, F}, Properties)],
            say("===> Running ~b counterexamples of ~ts", [length(Jobs), File], Request),
            session(Jobs, Request, fun(_) -> ok end);
        [{M, F} | _] ->
            Names = [lists:concat([KM, ":", KF]) || {KM, KF} <- Known],
            Name = lists:concat([M, ":", F]),
            Near = faultcheck_suggest:phrase(Name, Names),
            Hint = "; a property in another directory needs --dir",
            usage(lists:concat([File, ": no property ", Name, Near, Hint]), Request)
    end.

%% @doc Runs a stored case again and prints each command with its result.
-spec replay({faultcheck_case:'case'(), shrunk | original}, request()) -> status().
replay({Case, Which}, #{options := Options} = Request) ->
    #{module := M, property := F, versions := Then, seed := Seed} = Case,
    CounterExample = maps:get(Which, Case),
    Differ = faultcheck_versions:differences(Then, faultcheck_versions:all()),
    warn(Differ, "the case was recorded with other versions", Request),
    With = Request#{options := maps:merge(recorded(Case), Options#{seed => Seed})},
    Job = {{M, F}, {replay, CounterExample}},
    with_session(With, fun(Run, Session) ->
        {Outcome, Next} = faultcheck_outcome:get(Job, context(Run), Session),
        {replayed(Outcome, Case, Request), Next}
    end).

recorded(#{transport := none}) -> #{};
recorded(#{transport := Transport}) -> #{transport => Transport}.

replayed(interrupted, _Case, _Request) ->
    ?INTERRUPTED;
replayed(#{status := Status} = Outcome, #{status := Then, reasons := Recorded}, Request) ->
    %% The history ends with the reason.
    Lines = [["  ", R] || R <- maps:get(reasons, Outcome, [])],
    History = maps:get(history, Outcome, lists:join($\n, Lines)),
    say("~ts", [string:trim(History, trailing)], Request),
    case same(Status, Then) andalso maps:get(reasons, Outcome, []) =:= Recorded of
        true ->
            say("~ts, as recorded", [Status], Request);
        false ->
            Was = lists:join("; ", [atom_to_list(Then) | Recorded]),
            say("~ts; differs from the record: ~ts", [Status, Was], Request)
    end,
    exit_status([Outcome]).

%% @doc Prints a stored case, and lets its model add to its folder.
-spec report(faultcheck_case:'case'(), file:filename(), request()) -> status().
report(#{module := M, property := F} = Case, Dir, Request) ->
    Shown = Case#{property := {M, F}, 'case' => Dir, replay => maps:get(replay, Request)},
    say("~ts", [lists:join($\n, faultcheck_report:failure(Shown))], Request),
    Job = {{M, F}, {report, Case, Dir}},
    with_session(Request, fun(Run, Session) ->
        case faultcheck_outcome:get(Job, context(Run), Session) of
            {#{status := passed}, Next} ->
                {0, Next};
            {#{reasons := Reasons}, Next} ->
                say("report/2 of the model: ~ts", [lists:join("; ", Reasons)], Request),
                {3, Next};
            {interrupted, Next} ->
                {?INTERRUPTED, Next}
        end
    end).

same(failed, _) -> true;
same(_, flaky) -> true;
same(_, _) -> false.

%% ---- a session ----------------------------------------------------------------------------

session(Jobs, Request, AtEnd) ->
    with_session(Request, fun(Run, Session) ->
        {Ended, Outcomes, Next} = properties(Jobs, Run, Session, []),
        _ = Ended =:= interrupted andalso say("===> interrupted", [], Request),
        ok = AtEnd(Outcomes),
        Written = reports(Outcomes, Run),
        say("~ts", [lists:join($\n, faultcheck_report:summary(Outcomes))], Request),
        Status =
            case {Ended, Written} of
                {interrupted, _} -> ?INTERRUPTED;
                {done, error} -> ?USAGE;
                {done, ok} -> exit_status(Outcomes)
            end,
        {Status, Next}
    end).

with_session(#{options := Options, base_dir := Base} = Request, Fun) ->
    WorkDir = work_dir(Base),
    Seed = maps:get(seed, Options, new_seed()),
    Run = #run{
        request = Request,
        options = Options,
        seed = Seed,
        versions = faultcheck_versions:all(),
        work_dir = WorkDir
    },
    ok = faultcheck_interrupt:install(self()),
    Session = faultcheck_session:new(config(Run)),
    try
        {Status, Last} = Fun(Run, Session),
        _ = faultcheck_session:stop(Last),
        Status
    after
        ok = faultcheck_interrupt:remove(),
        _ = file:del_dir_r(WorkDir)
    end.

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

config(#run{request = Request, options = Options, work_dir = WorkDir}) ->
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

properties([], _Run, Session, Done) ->
    {done, lists:reverse(Done), Session};
properties([Job | Rest], #run{request = Request} = Run, Session, Done) ->
    say("~ts", [faultcheck_report:title(element(1, Job))], Request),
    case faultcheck_outcome:get(Job, context(Run), Session) of
        {interrupted, Next} ->
            {interrupted, lists:reverse(Done), Next};
        {Outcome, Next} ->
            {Kept, After} = faultcheck_outcome:keep(Outcome, Job, context(Run), Next),
            ok = show(Kept, Request),
            properties(Rest, Run, After, [Kept | Done])
    end.

context(#run{request = Request, options = Options, seed = Seed, versions = Versions}) ->
    #{
        options => Options,
        seed => Seed,
        versions => Versions,
        command => maps:get(command, Request),
        replay => maps:get(replay, Request)
    }.

show(#{status := passed} = Outcome, Request) ->
    show_stats(Outcome, Request);
show(Outcome, Request) ->
    say("~ts", [lists:join($\n, faultcheck_report:failure(Outcome))], Request),
    show_stats(Outcome, Request).

show_stats(#{stats := Text}, Request) -> say("~ts", [Text], Request);
show_stats(_, _) -> ok.

%% ---- the end ------------------------------------------------------------------------------

exit_status(Outcomes) ->
    Statuses = [Status || #{status := Status} <- Outcomes],
    Any = fun(Wanted) -> lists:any(fun(S) -> lists:member(S, Wanted) end, Statuses) end,
    case {Any([failed, error]), Any([unstarted]), Any([flaky])} of
        {true, _, _} -> 1;
        {_, true, _} -> 3;
        {_, _, true} -> 4;
        _ -> 0
    end.

reports(Outcomes, #run{options = Options, versions = Versions, request = Request}) ->
    Files =
        [{File, faultcheck_junit:format(Outcomes)} || {ok, File} <- [maps:find(junit, Options)]] ++
            [
                {File, faultcheck_report:json(Versions, Outcomes)}
             || {ok, File} <- [maps:find(json, Options)]
            ],
    lists:foldl(fun(F, Result) -> write(F, Request, Result) end, ok, Files).

%% Readers see no half of a report.
write({File, Text}, Request, Result) ->
    New = File ++ ".new",
    case {filelib:ensure_dir(File), file:write_file(New, Text), file:rename(New, File)} of
        {ok, ok, ok} ->
            Result;
        Answers ->
            Why = hd([W || {error, W} <- tuple_to_list(Answers)]),
            say("the report ~ts cannot be written: ~ts", [File, file:format_error(Why)], Request),
            error
    end.

%% @doc Stored cases: runs one again, or prints it.
-module(faultcheck_replay).

-export([replay/2, report/3, export/4]).

-import(faultcheck_request, [say/3, warn/3, with_session/2, context/1]).

-type request() :: faultcheck_request:request().

-define(INTERRUPTED, 130).
-define(USAGE, 2).
-define(NOT_STARTED, 3).

%% @doc Runs a stored case again and prints each command with its result.
-spec replay({faultcheck_case:'case'(), shrunk | original}, request()) ->
    faultcheck_runner:status().
replay({Case, Which}, #{options := Options} = Request) ->
    #{module := M, property := F, versions := Then, seed := Seed} = Case,
    CounterExample = maps:get(Which, Case),
    Differ = faultcheck_versions:differences(Then, faultcheck_versions:all()),
    warn(Differ, "the case was recorded with other versions", Request),
    With = Request#{options := maps:merge(recorded(Case), Options#{seed => Seed})},
    {Printed, Watched} = watched(With),
    Job = {{M, F}, {replay, CounterExample}},
    with_session(Watched, fun(Run, Session) ->
        {Outcome, Next} = faultcheck_outcome:get(Job, context(Run), Session),
        {replayed(Outcome, Case, Printed, Request), Next}
    end).

recorded(#{transport := none}) -> #{};
recorded(#{transport := Transport}) -> #{transport => Transport}.

%% Prints as before, and remembers what: the property may print the run of its commands itself.
watched(Request) ->
    Key = make_ref(),
    Print = faultcheck_request:printer(Request),
    put(Key, []),
    Remember = fun(Text) ->
        put(Key, [get(Key), Text]),
        Print(Text)
    end,
    {fun() -> unicode:characters_to_list(erase(Key)) end, Request#{print => Remember}}.

replayed(interrupted, _Case, _Printed, _Request) ->
    ?INTERRUPTED;
replayed(#{status := Status} = Outcome, Case, Printed, Request) ->
    #{status := Then, reasons := Recorded} = Case,
    History = history(Outcome),
    Known = string:find(Printed(), History) =/= nomatch,
    _ = Known orelse say("~ts", [History], Request),
    case same(Status, Then) andalso maps:get(reasons, Outcome, []) =:= Recorded of
        true ->
            say("~ts, as recorded", [Status], Request);
        false ->
            Was = lists:join("; ", [atom_to_list(Then) | Recorded]),
            say("~ts; differs from the record: ~ts", [Status, Was], Request)
    end,
    faultcheck_outcome:exit_status([Outcome]).

%% The history ends with the reason.
history(Outcome) ->
    Reasons = lists:join($\n, [["  ", R] || R <- maps:get(reasons, Outcome, [])]),
    History = maps:get(history, Outcome, Reasons),
    string:trim(unicode:characters_to_list(History), trailing).

same(passed, passed) -> true;
same(failed, Then) -> Then =/= passed;
same(_, flaky) -> true;
same(_, _) -> false.

%% @doc Prints a stored case, and lets its model add to its folder.
-spec report(faultcheck_case:'case'(), file:filename(), request()) -> faultcheck_runner:status().
report(#{module := M, property := F} = Case, Dir, Request) ->
    Shown = Case#{property := {M, F}, 'case' => Dir, replay => maps:get(replay, Request)},
    say("~ts", [lists:join($\n, faultcheck_report:failure(Shown))], Request),
    Job = {{M, F}, {report, Case, Dir}},
    with_session(Request, fun(Run, Session) ->
        case faultcheck_outcome:get(Job, context(Run), Session) of
            {#{status := passed} = Outcome, Next} ->
                ok = tell(maps:get(told, Outcome, #{}), Dir, Request),
                {0, Next};
            {#{reasons := Reasons}, Next} ->
                say("report/2 of the model: ~ts", [lists:join("; ", Reasons)], Request),
                {?NOT_STARTED, Next};
            {interrupted, Next} ->
                {?INTERRUPTED, Next}
        end
    end).

tell(Told, Dir, Request) ->
    Lines = faultcheck_report:told(Told, (maps:with([watch], Request))#{'case' => Dir}),
    Notes = [["  note: ", Note] || Note <- maps:get(notes, Told, [])],
    lists:foreach(fun(Line) -> say("~ts", [Line], Request) end, Lines ++ Notes).

%% @doc Lets the model of a stored case write it for other programs.
-spec export(faultcheck_case:'case'(), file:filename(), faultcheck_export:what(), request()) ->
    faultcheck_runner:status().
export(#{module := M, property := F} = Case, Dir, What, Request) ->
    Job = {{M, F}, {export, Case, Dir, What}},
    with_session(Request, fun(Run, Session) ->
        case faultcheck_outcome:get(Job, context(Run), Session) of
            {#{status := passed, written := Files}, Next} ->
                lists:foreach(fun(File) -> say("written: ~ts", [File], Request) end, Files),
                {0, Next};
            {#{status := Status, reasons := Reasons}, Next} ->
                say("export: ~ts", [lists:join("; ", Reasons)], Request),
                {export_status(Status), Next};
            {interrupted, Next} ->
                {?INTERRUPTED, Next}
        end
    end).

export_status(error) -> ?USAGE;
export_status(_) -> ?NOT_STARTED.

%% @doc Runs properties and answers with the exit status.
%%
%% This VM never loads code under test: properties run in a child VM (faultcheck_session,
%% faultcheck_child), and a child that dies or hangs is a failed property (faultcheck_rescue), after
%% which the run goes on with the next one. `rebar3 proper' and `faultcheck proper' are the callers.
-module(faultcheck_runner).

-export([run/1]).
-export_type([outcome/0, status/0]).

-import(faultcheck_request, [say/3, warn/3, with_session/2, context/1]).

-type request() :: faultcheck_request:request().
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
%% where the bridge of the visualizer serves its page unless it is told otherwise
-define(PAGE, "http://127.0.0.1:8765/").

%% @doc Does what the options say and answers with the exit status of the program.
-spec run(request()) -> status().
run(#{options := #{watch := true, workers := N}} = Request) when N > 1 ->
    usage("--watch shows one test at a time: leave out --workers", Request);
run(#{options := Options, places := Places} = Request) ->
    Named = maps:get(module, Options, []),
    case {empty(maps:get(dir, Options), Places), faultcheck_discovery:find(Places, Named)} of
        {[], {ok, Found}} -> run(faultcheck_discovery:select(Options, Found), Found, Request);
        {[], {error, Line}} -> usage(Line, Request);
        {[Dir | _], _} -> usage("no Erlang file in " ++ Dir ++ "/, here or in an application",
                                  Request)
    end.

%% Directories that were asked for and hold nothing; `test' is always asked for.
empty(Dirs, Places) ->
    [Dir || Dir <- Dirs, Dir =/= "test", not lists:any(fun({P, _}) -> ends(P, Dir) end, Places)].

ends(Path, Dir) -> lists:suffix(filename:split(Dir), filename:split(Path)).

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

%% ---- a session ----------------------------------------------------------------------------

session(Jobs, Request, AtEnd) ->
    _ = watched(Request) andalso
        say("watch: node visualizer/dist/bridge.mjs, then open ~ts", [?PAGE], Request),
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
                {done, ok} -> faultcheck_outcome:exit_status(Outcomes)
            end,
        {Status, Next}
    end).

watched(#{options := Options}) -> maps:get(watch, Options, false).

properties([], _Run, Session, Done) ->
    {done, lists:reverse(Done), Session};
properties([Job | Rest], #{request := Request} = Run, Session, Done) ->
    say("~ts", [faultcheck_report:title(element(1, Job))], Request),
    case faultcheck_outcome:get(Job, context(Run), Session) of
        {interrupted, Next} ->
            {interrupted, lists:reverse(Done), Next};
        {Outcome, Next} ->
            {Kept, After} = faultcheck_outcome:keep(Outcome, Job, context(Run), Next),
            ok = show(Kept, Request),
            properties(Rest, Run, After, [Kept | Done])
    end.

show(#{status := passed} = Outcome, Request) ->
    show_stats(Outcome, Request);
show(Outcome, Request) ->
    say("~ts", [lists:join($\n, faultcheck_report:failure(Outcome))], Request),
    show_stats(Outcome, Request).

show_stats(#{stats := Text}, Request) -> say("~ts", [Text], Request);
show_stats(_, _) -> ok.

%% ---- the end ------------------------------------------------------------------------------

reports(Outcomes, #{versions := Versions, request := #{options := Options} = Request}) ->
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

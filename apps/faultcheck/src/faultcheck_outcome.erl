%% @doc What came of one property: runs its job, judges what happened, stores the case.
-module(faultcheck_outcome).

-export([get/3, keep/4, exit_status/1]).
-export_type([context/0]).

-type context() :: #{
    options := faultcheck_options:options(),
    seed := non_neg_integer(),
    versions := faultcheck_versions:versions(),
    command := string(),
    replay := string(),
    watch => string(),
    team := faultcheck_team:team()
}.
-type task() :: {{module(), atom()}, faultcheck_property:task()}.
-type session() :: faultcheck_session:session().

-define(LIMIT_MS, 10000).

%% @doc Runs a property for a task.
-spec get(task(), context(), session()) ->
    {faultcheck_runner:outcome() | interrupted, session()}.
get({_, run} = Task, #{team := Team} = Context, Session) ->
    Job = job(Task, Context),
    Began = erlang:monotonic_time(millisecond),
    case faultcheck_team:known(Job, Team) of
        interrupted ->
            {interrupted, Session};
        Known ->
            Ms = erlang:monotonic_time(millisecond) - Began,
            {Outcome, Next} = get(Task, told(Known, Job), Context, Session),
            {longer(Ms, Outcome), Next}
    end;
get(Task, Context, Session) ->
    get(Task, job(Task, Context), Context, Session).

%% The time was for the workers.
told(Known, #{time := _} = Job) when map_size(Known) > 0 -> Job#{known => Known, time := 0};
told(Known, Job) -> Job#{known => Known}.

longer(_Ms, interrupted) -> interrupted;
longer(More, #{ms := Ms} = Outcome) -> Outcome#{ms := Ms + More}.

get(Task, Job, Context, Session) ->
    {Answer, Next} = faultcheck_session:run(Job, Session),
    case judged(Answer, Job, Next) of
        {interrupted, Last} -> {interrupted, Last};
        {Result, Last} -> {outcome(Task, Result, info(Answer), Context), Last}
    end.

job({{Module, Function}, Task}, #{options := Options, seed := Seed}) ->
    Job = #{
        module => Module,
        function => Function,
        task => Task,
        seed => Seed,
        proper => faultcheck_options:proper(Options)
    },
    Names = [
        {transport, transport}, {time, time}, {stats, stats}, {timeout, limit},
        {boundary_bias, bias}, {max_runs, max_runs}, {watch, watch}
    ],
    Given = [{To, maps:get(From, Options)} || {From, To} <- Names, is_map_key(From, Options)],
    maps:merge(Job, maps:from_list(Given)).

info({result, _, Info}) -> Info;
info({dead, _, Info}) -> Info;
info({hang, Info}) -> Info;
info(_) -> #{}.

judged({result, #{status := failed, timeout := true} = Result, _}, #{task := run} = Job, Session) ->
    faultcheck_rescue:timeout(Result, Job, Session);
judged({result, Result, _}, _Job, Session) ->
    {Result, Session};
judged({dead, Ending, Info}, Job, Session) ->
    faultcheck_rescue:result({dead, Ending}, Info, limited(Info, Job), Session);
judged({hang, Info}, Job, Session) ->
    Limited = limited(Info, Job),
    faultcheck_rescue:result({hang, maps:get(limit, Limited)}, Info, Limited, Session);
judged({no_child, Line}, _Job, Session) ->
    {#{status => unstarted, tests => 0, ms => 0, reasons => [Line]}, Session};
judged(interrupted, _Job, Session) ->
    {interrupted, Session}.

%% The property's own limit, when it has told one.
limited(#{limit := Limit}, Job) -> Job#{limit => Limit};
limited(_, Job) -> maps:merge(#{limit => ?LIMIT_MS}, Job).

outcome({Property, Task}, Result, Info, #{options := Options} = Context) ->
    #{seed := Seed, versions := Versions, replay := Replay} = Context,
    Common = (maps:with([watch], Context))#{
        property => Property,
        seed => Seed,
        versions => Versions,
        replay => Replay,
        doc => maps:get(doc, Info, ""),
        long_result => maps:get(long_result, Options, false),
        words => words(Property, Context)
    },
    repeatable(Task, maps:merge(Common, Result), Context).

words({Module, Property}, #{options := Options, seed := Seed, versions := Versions}) ->
    lists:append([
        ["-m", atom_to_list(Module), "-p", atom_to_list(Property)],
        ["--seed", faultcheck_versions:seed(Seed, Versions)],
        faultcheck_options:arguments(Options)
    ]).

%% A stored counterexample has no seed.
repeatable(run, #{words := Words} = Outcome, #{command := Command}) ->
    Outcome#{repeat => lists:append(lists:join(" ", [Command | Words]))};
repeatable(_, Outcome, _) ->
    maps:remove(seed, Outcome).

%% @doc Stores a failure that was found as a case, and lets its model add to it.
-spec keep(faultcheck_runner:outcome(), task(), context(), session()) ->
    {faultcheck_runner:outcome(), session()}.
keep(#{status := Status, shrunk := _} = Outcome, {Property, run}, Context, Session) when
    Status =:= failed; Status =:= flaky
->
    Case = new_case(Property, Outcome, Context),
    case faultcheck_case:write(faultcheck_case:directory(), Case) of
        {ok, Dir} ->
            Job = job({Property, {report, Case, Dir}}, Context),
            report(faultcheck_session:run(Job, Session), Outcome#{'case' => Dir});
        {error, Line} ->
            {note("the case could not be stored: " ++ Line, Outcome), Session}
    end;
keep(Outcome, _Task, _Context, Session) ->
    {Outcome, Session}.

report({{result, #{status := passed} = Result, _}, Session}, Outcome) ->
    {with_told(maps:get(told, Result, #{}), Outcome), Session};
report({{result, #{reasons := [Reason | _]}, _}, Session}, Outcome) ->
    {note("report/2 of the model failed: " ++ Reason, Outcome), Session};
report({interrupted, Session}, Outcome) ->
    self() ! faultcheck_interrupt,
    {Outcome, Session};
report({_, Session}, Outcome) ->
    {note("report/2 of the model did not end", Outcome), Session}.

with_told(Told, Outcome) ->
    lists:foldl(fun note/2, Outcome#{told => Told}, maps:get(notes, Told, [])).

note(Line, Outcome) -> Outcome#{notes => maps:get(notes, Outcome, []) ++ [Line]}.

new_case({Module, Property}, #{status := Status, shrunk := Shrunk} = Outcome, Context) ->
    #{options := Options, seed := Seed, versions := Versions} = Context,
    Kept = [tries, accepted, minimal, stopped, flaky],
    Shrink = maps:with(Kept, maps:get(shrink, Outcome, #{})),
    #{
        module => Module,
        property => Property,
        status => Status,
        seed => Seed,
        test => maps:get(test, Outcome, none),
        size => maps:get(size, Outcome, none),
        transport => maps:get(transport, Options, none),
        options => maps:get(words, Outcome),
        versions => Versions,
        original => maps:get(original, Outcome, Shrunk),
        shrunk => Shrunk,
        reasons => maps:get(reasons, Outcome, []),
        shrink => maps:merge(Shrink, maps:with([flaky], Outcome))
    }.

%% @doc The exit status of the program that had these outcomes.
-spec exit_status([faultcheck_runner:outcome()]) -> 0 | 1 | 3 | 4.
exit_status(Outcomes) ->
    Statuses = [Status || #{status := Status} <- Outcomes],
    Any = fun(Wanted) -> lists:any(fun(S) -> lists:member(S, Wanted) end, Statuses) end,
    case {Any([failed, error]), Any([unstarted]), Any([flaky])} of
        {true, _, _} -> 1;
        {_, true, _} -> 3;
        {_, _, true} -> 4;
        _ -> 0
    end.

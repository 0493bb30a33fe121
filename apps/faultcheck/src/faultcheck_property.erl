%% @doc Runs one property with PropEr and says what came of it.
%%
%% A run has two phases. First the tests, without shrinking, until one fails: that gives the
%% number of the test, its size and the original counterexample. Then that one test again, from
%% its seed, with shrinking. The same second phase serves when the child VM died in a test: the
%% runner asks a new VM for the task `{repeat, Number, Size}'.
-module(faultcheck_property).

-export([run/3, dotted/2]).
-export_type([job/0, task/0, failure/0, result/0]).

-type task() ::
    run
    %% one test once more, shrunk when it fails
    | {repeat, Number :: pos_integer(), Size :: non_neg_integer()}
    %% the same without shrinking
    | {confirm, Number :: pos_integer(), Size :: non_neg_integer()}
    %% its values only; nothing of the property is run
    | {generate, Number :: pos_integer(), Size :: non_neg_integer()}
    %% a stored counterexample
    | {check, proper:counterexample()}
    %% the same, and the commands of the run with their results
    | {replay, proper:counterexample()}
    %% what the model adds to a stored case: its optional report(Case, Dir)
    | {report, faultcheck_case:'case'(), file:filename()}.
-type job() :: #{
    module := module(),
    function := atom(),
    task := task(),
    seed := non_neg_integer(),
    %% PropEr's options as the command line gives them; those of the property come before
    proper := [term()],
    transport => nif | port,
    %% application environment during this job
    env => [{atom(), atom(), term()}],
    limit => pos_integer(),
    %% seconds
    time => pos_integer(),
    stats => boolean()
}.
-type failure() :: #{
    test := pos_integer(), size := non_neg_integer(), original := proper:counterexample()
}.
-type result() :: #{
    status := passed | failed | flaky | unstarted | error,
    tests := non_neg_integer(),
    ms := non_neg_integer(),
    test => pos_integer(),
    size => non_neg_integer(),
    original => proper:counterexample(),
    shrunk => proper:counterexample(),
    shrinks => non_neg_integer(),
    %% why, one line each
    reasons => [string()],
    shrink => map(),
    flaky => {Failed :: non_neg_integer(), Runs :: pos_integer()},
    %% it failed because C code took too long
    timeout => true,
    %% the commands of a replay with their results, in lines
    history => string(),
    stats => string()
}.
-type tell() :: fun((term()) -> ok).

-define(NUMTESTS, 100).
-define(LIMIT_MS, 10000).
-define(RERUNS, 10).
%% From here on PropEr's dots are replaced by a line of progress.
-define(MOST_DOTS, 1000).

%% What the functions below share.
-record(run, {
    job :: job(),
    property :: {proper:test(), faultcheck_instrument:outer()},
    options :: [term()],
    numtests :: pos_integer(),
    fails :: boolean(),
    tests :: counters:counters_ref(),
    tell :: tell(),
    exceptions :: ets:tid(),
    deadline = infinity :: integer() | infinity
}).

-spec run(job(), counters:counters_ref(), tell()) -> result().
run(#{module := Module, function := Function} = Job, Tests, Tell) ->
    Began = now_ms(),
    Result =
        try
            Meta = meta(Module, Function, opts, []),
            ok = environment(Job, Meta),
            Property = faultcheck_instrument:peel(Module:Function()),
            Run = prepare(Job, Meta, Property, Tests, Tell),
            ok = Tell({tell, {started, started(Run, Meta)}}),
            task(Run)
        catch
            throw:{stop, Stopped} -> Stopped;
            Class:Reason:Stack -> outside(Class, Reason, Stack)
        end,
    maps:merge(#{tests => counters:get(Tests, 1), ms => now_ms() - Began}, Result).

now_ms() -> erlang:monotonic_time(millisecond).

%% An exception that PropEr did not catch: in the property's own function or in a set-up.
outside(Class, Reason, Stack) ->
    case faultcheck_reason:unstarted(Reason) of
        {true, Line} -> #{status => unstarted, reasons => [Line]};
        false -> #{status => error, reasons => faultcheck_reason:lines(Class, Reason, Stack)}
    end.

%% The meta functions of a property: prop_x(doc) and prop_x(opts).
meta(Module, Function, What, Default) ->
    _ = code:ensure_loaded(Module),
    case erlang:function_exported(Module, Function, 1) of
        true ->
            try
                Module:Function(What)
            catch
                error:function_clause -> Default
            end;
        false ->
            Default
    end.

%% What a job sets is gone with the next one.
environment(Job, Meta) ->
    Given = maps:get(env, Job, []),
    Transport = [
        {c_bridge, force_transport, T}
     || T <- transport(maps:find(transport, Job), proplists:lookup(transport, Meta))
    ],
    lists:foreach(
        fun(Key) -> application:unset_env(c_bridge, Key) end,
        [force_transport, force_reset, timeout_factor]
    ),
    lists:foreach(fun({App, Key, V}) -> application:set_env(App, Key, V) end, Transport ++ Given).

transport({ok, Transport}, _) -> [Transport];
transport(error, {transport, Transport}) -> [Transport];
transport(error, none) -> [].

prepare(#{proper := Given} = Job, Meta, {_, Outer} = Property, Tests, Tell) ->
    Options = [O || O <- Meta ++ Given, passed_on(O)],
    #run{
        job = Job,
        property = Property,
        options = [O || O <- Options, not is_tuple(O) orelse element(1, O) =/= numtests],
        numtests = numtests(Outer, Options),
        fails = is_map_key(fails, Outer) orelse lists:member(fails, Options),
        tests = Tests,
        tell = Tell,
        exceptions = ets:new(exceptions, [public])
    }.

%% PropEr's workers would all run the same tests: their seeds come from us. `fails' is judged here.
passed_on(fails) -> false;
passed_on(noshrink) -> true;
passed_on(Name) when Name =:= quiet; Name =:= verbose; Name =:= long_result -> false;
passed_on({Name, _}) when
    Name =:= transport; Name =:= timeout; Name =:= numworkers; Name =:= on_output;
    Name =:= to_file; Name =:= seed
->
    false;
passed_on({search_steps, _}) ->
    faultcheck_versions:proper() >= [1, 3];
passed_on(_) ->
    true.

numtests(#{numtests := N}, _Options) -> N;
numtests(_, Options) -> hd([N || {numtests, N} <- Options] ++ [?NUMTESTS]).

started(#run{job = Job, numtests = Numtests}, Meta) ->
    #{module := Module, function := Function} = Job,
    Limit = maps:get(limit, Job, proplists:get_value(timeout, Meta, ?LIMIT_MS)),
    #{limit => Limit, numtests => Numtests, doc => meta(Module, Function, doc, "")}.

%% ---- tasks --------------------------------------------------------------------------------

task(#run{job = #{task := run} = Job} = Run) ->
    ok = stats_start(Job),
    Result =
        case maps:find(time, Job) of
            {ok, Seconds} ->
                batches(0, Run#run{deadline = now_ms() + 1000 * Seconds});
            error ->
                tests(0, Run)
        end,
    stats_stop(Job, Result);
task(#run{job = #{task := {repeat, Number, Size}}} = Run) ->
    shrunk(Number, Size, Run);
task(#run{job = #{task := {confirm, Number, Size}}} = Run) ->
    case single(Number, Size, [noshrink], mute, #{}, Run) of
        true -> #{status => passed};
        {error, Reason} -> proper_error(Reason);
        Original -> failure(Number, Size, Original, Run)
    end;
task(#run{job = #{task := {generate, Number, Size}}} = Run) ->
    put(values, []),
    Instead = fun(Value) ->
        put(values, [Value | get(values)]),
        ok
    end,
    _ = single(Number, Size, [noshrink], mute, #{instead => Instead}, Run),
    #{status => passed, original => lists:reverse(get(values))};
task(#run{job = #{task := {check, CounterExample}}} = Run) ->
    check(CounterExample, Run);
task(#run{job = #{task := {replay, CounterExample}}} = Run) ->
    Result = check(CounterExample, Run),
    case faultcheck_run:last() of
        {_, Commands, Last} -> Result#{history => text("~ts", [pretty(Commands, Last)])};
        none -> Result
    end;
task(#run{job = #{task := {report, Case, Dir}, module := Module}}) ->
    Models = [M || {ok, Commands} <- [faultcheck_case:commands(maps:get(shrunk, Case))],
                   {set, _, {call, M, _, _}} <- Commands],
    report([Module | lists:usort(Models)], Case, Dir).

pretty(Commands, Last) -> faultcheck_pretty:format(Commands, Last).

report([], _Case, _Dir) ->
    #{status => passed};
report([Module | Rest], Case, Dir) ->
    _ = code:ensure_loaded(Module),
    case erlang:function_exported(Module, report, 2) of
        true ->
            _ = Module:report(Case, Dir),
            #{status => passed};
        false ->
            report(Rest, Case, Dir)
    end.

stats_start(#{stats := true}) -> faultcheck_stats:start();
stats_start(_) -> ok.

stats_stop(#{stats := true}, Result) ->
    Result#{stats => lists:flatten(faultcheck_stats:format(faultcheck_stats:stop()))};
stats_stop(_, Result) ->
    Result.

%% Batches of numtests each, so that the sizes grow again and again until the time is up.
batches(First, #run{numtests = Numtests, deadline = Deadline} = Run) ->
    case tests(First, Run) of
        #{status := passed} = Passed ->
            case now_ms() < Deadline of
                true -> batches(First + Numtests, Run);
                false -> passed(Passed, Run)
            end;
        Result ->
            Result
    end.

passed(Result, #run{tests = Tests, tell = Tell}) ->
    ok = Tell({show, utf8("OK: Passed ~b test(s).~n", [counters:get(Tests, 1)])}),
    Result.

%% The tests from number First + 1 on.
tests(First, #run{numtests = Numtests, fails = Fails, tell = Tell} = Run) ->
    Next = counting(First, Run),
    true = ets:delete_all_objects(Run#run.exceptions),
    Options = [{numtests, Numtests}, noshrink, {on_output, output(run, Run)} | Run#run.options],
    case quickcheck(Next, Options, #{}, Run) of
        true when Fails ->
            Line = "all tests passed, but the property is expected to fail",
            #{status => failed, reasons => [Line]};
        true ->
            #{status => passed};
        {error, Reason} ->
            proper_error(Reason);
        _ when Fails ->
            #{status => passed};
        Original ->
            Failure = failure(get(number), get(size), Original, Run),
            ok = Tell({tell, {failed, maps:with([test, size, original], Failure)}}),
            judged(Failure, Run)
    end.

%% The number of each test to come. After the failing one PropEr runs the property again, to
%% shrink it and to report it: the number stays.
counting(First, #run{tests = Tests, deadline = Deadline}) ->
    put(number, First),
    put(phase, testing),
    fun() ->
        case get(phase) of
            testing when Deadline =:= infinity ->
                count(Tests);
            testing ->
                case now_ms() < Deadline of
                    true -> count(Tests);
                    false -> stop
                end;
            failed ->
                get(number)
        end
    end.

count(Tests) ->
    Number = get(number) + 1,
    put(number, Number),
    put(size, faultcheck_instrument:size()),
    counters:add(Tests, 1, 1),
    Number.

quickcheck(Next, Options, More, #run{property = Property} = Run) ->
    Plan = maps:merge(plan(Next, Run), More),
    proper:quickcheck(faultcheck_instrument:test(Property, Plan), [long_result | Options]).

plan(Next, #run{job = #{module := M, function := F, seed := Seed}, exceptions = Exceptions}) ->
    #{property => {M, F}, seed => Seed, next => Next, exceptions => Exceptions}.

failure(Number, Size, Original, Run) ->
    Base = #{test => Number, size => Size, original => Original, shrunk => Original},
    maps:merge(Base, verdict(Original, Run)).

%% What the last run of the property says: why it failed, and whether it is the system under
%% test that could not be started.
verdict(CounterExample, Run) ->
    {Reason, Lines} = why(faultcheck_case:commands(CounterExample), faultcheck_run:last(), Run),
    case faultcheck_reason:unstarted(Reason) of
        {true, Line} ->
            throw({stop, #{status => unstarted, reasons => [Line]}});
        false ->
            Verdict = #{status => failed, reasons => Lines},
            case faultcheck_reason:is_timeout(Reason) of
                true -> Verdict#{timeout => true};
                false -> Verdict
            end
    end.

%% The run of the commands says most, then an exception, then what PropEr prints.
why({ok, Commands}, {_, Commands, {_, _, Result}}, _Run) when Result =/= ok ->
    {raised(Result), faultcheck_reason:trimmed(faultcheck_pretty:why(Result))};
why(_, _, #run{exceptions = Table}) ->
    case faultcheck_instrument:exception(Table) of
        {Class, Reason, Stack} -> {Reason, faultcheck_reason:lines(Class, Reason, Stack)};
        none -> {none, lists:reverse(get(printed))}
    end.

raised({exception, _, Reason, _}) -> Reason;
raised({_, {exception, _, Reason, _}}) -> Reason;
raised(_) -> none.

proper_error(Reason) ->
    #{status => error, reasons => [faultcheck_reason:proper(Reason)]}.

%% ---- after a failure ----------------------------------------------------------------------

judged(#{test := Number, size := Size, original := Original} = Failure, Run) ->
    case repeats(Original, Run) of
        all ->
            case lists:member(noshrink, Run#run.options) of
                true -> Failure;
                false -> maps:merge(Failure, shrunk(Number, Size, Run))
            end;
        {Failed, Runs} ->
            Failure#{status => flaky, flaky => {Failed, Runs}}
    end.

%% Command sequences are run again by their own shrinker.
repeats(Original, Run) ->
    case faultcheck_case:commands(Original) of
        {ok, _} -> all;
        none -> repeats(Original, Run, ?RERUNS, 0)
    end.

repeats(_Original, _Run, 0, ?RERUNS) ->
    all;
repeats(_Original, _Run, 0, Failed) ->
    {Failed, ?RERUNS};
repeats(Original, #run{property = Property, tell = Tell} = Run, Left, Failed) ->
    ok = Tell({mute, true}),
    Test = faultcheck_instrument:test(Property, plan(fun() -> get(number) end, Run)),
    Result = proper:check(Test, Original, [quiet]),
    ok = Tell({mute, false}),
    case Result of
        false -> repeats(Original, Run, Left - 1, Failed + 1);
        _ -> repeats(Original, Run, Left - 1, Failed)
    end.

%% One test from its seed, with shrinking.
shrunk(Number, Size, #run{tell = Tell} = Run) ->
    ok = faultcheck_statem:reset_shrink(),
    ok = faultcheck_statem:set_progress(fun(How) -> Tell({tell, {shrinking, How}}) end),
    case single(Number, Size, [], shrink, #{}, Run) of
        true ->
            #{status => flaky, flaky => {0, 1}};
        {error, Reason} ->
            proper_error(Reason);
        Shrunk ->
            Failure = failure(Number, Size, Shrunk, Run),
            with_shrink(faultcheck_statem:last_shrink(), Failure#{shrinks => get(shrinks)})
    end.

with_shrink(undefined, Failure) ->
    maps:remove(original, Failure);
with_shrink(#{flaky := false, original := Original} = Shrink, Failure) ->
    Failure#{
        original => faultcheck_case:with_commands(maps:get(shrunk, Failure), Original),
        shrink => Shrink
    };
with_shrink(#{flaky := Rate, original := Original} = Shrink, #{shrunk := Shrunk} = Failure) ->
    CounterExample = faultcheck_case:with_commands(Shrunk, Original),
    Failure#{
        status => flaky,
        flaky => Rate,
        original => CounterExample,
        shrunk => CounterExample,
        shrink => Shrink
    }.

single(Number, Size, More, Mode, Plan, #run{tests = Tests, tell = Tell} = Run) ->
    put(phase, testing),
    put(shrinks, 0),
    ok = Tell({mute, true}),
    Next = fun() -> Number end,
    counters:add(Tests, 1, 1),
    Options =
        More ++
            [{numtests, 1}, {start_size, Size}, {max_size, Size}, {on_output, output(Mode, Run)}] ++
            Run#run.options,
    Result = quickcheck(Next, Options, Plan, Run),
    ok = Tell({mute, false}),
    Result.

check(CounterExample, #run{property = Property, fails = Fails} = Run) ->
    put(printed, []),
    put(phase, checking),
    Plan = plan(fun() -> 1 end, Run),
    Options = [{on_output, output(check, Run)} | Run#run.options],
    case proper:check(faultcheck_instrument:test(Property, Plan), CounterExample, Options) of
        Passed when Passed =:= not Fails ->
            #{status => passed};
        {error, Reason} ->
            proper_error(Reason);
        _ ->
            Base = #{original => CounterExample, shrunk => CounterExample},
            maps:merge(Base, verdict(CounterExample, Run))
    end.

%% ---- what PropEr prints -------------------------------------------------------------------

%% In the first phase everything up to the failure is shown; the failure itself is reported by
%% the runner, after what the actions of a ?WHENFAIL print for the smallest counterexample.
output(Mode, #run{job = Job, property = {_, Outer}, numtests = N, tell = Tell} = Run) ->
    put(printed, []),
    Dots = dotted(Job, N),
    Print =
        case Outer of
            #{on_output := Print0} -> Print0;
            _ -> fun(Format, Args) -> Tell({show, utf8(Format, Args)}) end
        end,
    fun(Format, Args) ->
        output(Mode, get(phase), Format, Args, #{print => Print, dots => Dots, run => Run})
    end.

%% @doc Whether a job shows a dot for each test: not when there are too many to look at.
-spec dotted(job(), pos_integer()) -> boolean().
dotted(#{task := run} = Job, Numtests) ->
    Numtests =< ?MOST_DOTS andalso not is_map_key(time, Job);
dotted(_, _) ->
    false.

output(run, testing, Dot, [], #{dots := Dots, print := Print}) when Dot =:= "."; Dot =:= "x" ->
    Dots andalso Print(Dot, []),
    ok;
output(Mode, testing, "!", [], #{dots := Dots, print := Print, run := Run}) ->
    put(phase, failed),
    Mode =:= run andalso Dots andalso Print("!~n", []),
    failing(Mode, Run);
output(run, testing, Format, Args, #{run := #run{deadline = infinity}, print := Print}) ->
    Print(Format, Args),
    ok;
output(shrink, failed, ".", [], _) ->
    put(shrinks, get(shrinks) + 1),
    ok;
output(_Mode, _Phase, "~w~n", [_], _) ->
    ok;
output(shrink, failed, Format, [N], #{run := #run{tell = Tell}}) when is_integer(N) ->
    case string:find(Format, "time(s)") of
        nomatch -> ok;
        _ -> Tell({mute, false})
    end;
output(_Mode, _Phase, Format, Args, _) ->
    printed(string:trim(utf8(Format, Args))).

%% Nothing more of the property's own prints until the shrunk counterexample is reported.
failing(run, #run{options = Options, fails = Fails, tell = Tell}) ->
    Tell({mute, Fails orelse not lists:member(noshrink, Options)});
failing(_Mode, _Run) ->
    ok.

%% The lines that tell why a test failed.
printed(<<>>) ->
    ok;
printed(Text) ->
    Said = ["Test execution", "A linked", "Sub-property", "An exception"],
    case [S || S <- Said, string:prefix(Text, S) =/= nomatch] of
        [] -> ok;
        _ -> put(printed, [unicode:characters_to_list(Text) | get(printed)])
    end,
    ok.

%% Without PropEr's colours.
utf8(Format, Args) ->
    Text = unicode:characters_to_binary(io_lib:format(Format, Args)),
    re:replace(Text, <<"\\e\\[[0-9;]*m">>, <<>>, [global, {return, binary}]).

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

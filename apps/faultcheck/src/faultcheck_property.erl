%% @doc Runs one property with PropEr and says what came of it.
%%
%% A run has two phases. First the tests, without shrinking, until one fails (faultcheck_testing):
%% that gives the number of the test, its size and the original counterexample. Then that one test
%% again, from its seed, with shrinking (faultcheck_failing). The second phase serves as well when
%% the child VM died in a test: the runner asks a new VM for the task `{repeat, Number, Size}'.
-module(faultcheck_property).

-export([run/3, dotted/2]).
-export_type([job/0, task/0, failure/0, result/0]).

-type task() ::
    run
    %% tests whose numbers faultcheck_team gives out
    | share
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
    | {report, faultcheck_case:'case'(), file:filename()}
    %% what the model makes of it for other programs: its optional export(Case, Dir, What)
    | {export, faultcheck_case:'case'(), file:filename(), faultcheck_export:what()}.
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
    time => non_neg_integer(),
    stats => boolean(),
    %% boundary bias of generators, runs of a guided search
    bias => faultcheck_range:bias(),
    max_runs => pos_integer(),
    %% models that can shall show each test: {faultcheck, watch} in the application environment
    watch => boolean(),
    %% what workers have found out
    known => faultcheck_known:known()
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
    stats => string(),
    %% what the model says of its report, and what it exported
    told => faultcheck_case:told(),
    written => [file:filename()]
}.

-define(NUMTESTS, 100).
-define(LIMIT_MS, 10000).

-spec run(job(), counters:counters_ref(), faultcheck_testing:tell()) -> result().
run(#{module := Module, function := Function} = Job, Tests, Tell) ->
    Began = erlang:monotonic_time(millisecond),
    ok = faultcheck_progress:set(fun(What, How) -> Tell({tell, {What, How}}) end),
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
    Ms = erlang:monotonic_time(millisecond) - Began,
    maps:merge(#{tests => counters:get(Tests, 1), ms => Ms}, Result).

%% An exception that PropEr did not catch: in the property's own function or in a set-up.
outside(Class, Reason, Stack) ->
    case faultcheck_reason:unstarted(Reason) of
        {true, Line} -> #{status => unstarted, reasons => [Line]};
        false -> #{status => error, reasons => faultcheck_reason:lines(Class, Reason, Stack)}
    end.

%% ---- settings -----------------------------------------------------------------------------

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
        fun({App, Key}) -> application:unset_env(App, Key) end,
        [{c_bridge, K} || K <- [force_transport, force_reset, timeout_factor]] ++
            [{faultcheck, K} || K <- [boundary_bias, max_runs, watch]]
    ),
    Named = [{bias, boundary_bias}, {max_runs, max_runs}, {watch, watch}],
    Ours = [{faultcheck, To, maps:get(From, Job)} || {From, To} <- Named, is_map_key(From, Job)],
    Settings = Transport ++ Ours ++ Given,
    lists:foreach(fun({App, Key, V}) -> application:set_env(App, Key, V) end, Settings).

transport({ok, Transport}, _) -> [Transport];
transport(error, {transport, Transport}) -> [Transport];
transport(error, none) -> [].

prepare(#{proper := Given} = Job, Meta, {_, Outer} = Property, Tests, Tell) ->
    Options = [O || O <- Meta ++ Given, passed_on(O)],
    #{
        job => Job,
        property => Property,
        options => [O || O <- Options, not is_tuple(O) orelse element(1, O) =/= numtests],
        numtests => numtests(Outer, Options),
        fails => is_map_key(fails, Outer) orelse lists:member(fails, Options),
        tests => Tests,
        tell => Tell,
        exceptions => ets:new(exceptions, [public]),
        known => maps:get(known, Job, #{}),
        deadline => infinity
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

started(#{job := Job, numtests := Numtests}, Meta) ->
    #{module := Module, function := Function} = Job,
    Limit = maps:get(limit, Job, proplists:get_value(timeout, Meta, ?LIMIT_MS)),
    #{limit => Limit, numtests => Numtests, doc => meta(Module, Function, doc, "")}.

%% @doc Whether a job shows a dot for each test: not when there are too many to look at.
-spec dotted(job(), pos_integer()) -> boolean().
dotted(#{task := run} = Job, Numtests) ->
    Numtests =< faultcheck_transcript:most_dots() andalso not is_map_key(time, Job);
dotted(_, _) ->
    false.

%% ---- tasks --------------------------------------------------------------------------------

task(#{job := #{task := run} = Job} = Run) ->
    ok = stats_start(Job),
    Result =
        case maps:find(time, Job) of
            {ok, Seconds} ->
                Deadline = erlang:monotonic_time(millisecond) + 1000 * Seconds,
                batches(0, Run#{deadline := Deadline});
            error ->
                tests(0, Run)
        end,
    stats_stop(Job, Result);
task(#{job := #{task := share} = Job} = Run) ->
    ok = stats_start(Job),
    Result = faultcheck_share:run(Run),
    _ = faultcheck_stats:stop(),
    Result;
task(#{job := #{task := {repeat, Number, Size}}} = Run) ->
    faultcheck_failing:shrunk(Number, Size, Run);
task(#{job := #{task := {confirm, Number, Size}}} = Run) ->
    case faultcheck_testing:single(Number, Size, mute, Run) of
        true -> #{status => passed};
        {error, Reason} -> faultcheck_failing:error(Reason);
        Original -> faultcheck_failing:failure(Number, Size, Original, Run)
    end;
task(#{job := #{task := {generate, Number, Size}}} = Run) ->
    #{status => passed, original => faultcheck_testing:values(Number, Size, Run)};
task(#{job := #{task := {check, CounterExample}}} = Run) ->
    check(CounterExample, Run);
task(#{job := #{task := {replay, CounterExample}}} = Run) ->
    Result = check(CounterExample, Run),
    case faultcheck_run:last() of
        {_, Commands, Last} ->
            Text = io_lib:format("~ts", [faultcheck_pretty:format(Commands, Last)]),
            Result#{history => lists:flatten(Text)};
        none ->
            Result
    end;
task(#{job := #{task := {report, Case, Dir}, module := Module}}) ->
    case faultcheck_export:exporter(Module, Case, {report, 2}) of
        {ok, Model} -> #{status => passed, told => told(Model:report(Case, Dir))};
        none -> #{status => passed}
    end;
task(#{job := #{task := {export, Case, Dir, What}, module := Module}}) ->
    case faultcheck_export:run(Module, Case, Dir, What) of
        {ok, Files} -> #{status => passed, written => Files};
        {error, Line} -> #{status => error, reasons => [Line]}
    end.

%% Batches of numtests each, so that the sizes grow again and again until the time is up.
batches(First, #{numtests := Numtests, deadline := Deadline} = Run) ->
    case tests(First, Run) of
        #{status := passed} = Passed ->
            Known = is_map_key(First + Numtests + 1, maps:get(known, Run)),
            case Known orelse erlang:monotonic_time(millisecond) < Deadline of
                true -> batches(First + Numtests, Run);
                false -> passed(Passed, Run)
            end;
        Result ->
            Result
    end.

passed(Result, #{tests := Tests, tell := Tell}) ->
    Line = io_lib:format("OK: Passed ~b test(s).~n", [counters:get(Tests, 1)]),
    ok = Tell({show, unicode:characters_to_binary(Line)}),
    Result.

%% The tests from number First + 1 on.
tests(First, #{fails := Fails, tell := Tell} = Run) ->
    case faultcheck_testing:all(First, Run) of
        true when Fails ->
            Line = "all tests passed, but the property is expected to fail",
            #{status => failed, reasons => [Line]};
        true ->
            faultcheck_failing:doubted(First, Run);
        {error, Reason} ->
            faultcheck_failing:error(Reason);
        _ when Fails ->
            #{status => passed};
        not_found ->
            #{status => failed, reasons => ["the search of an ?EXISTS found no such value"]};
        {failed, Number, Size, Original} ->
            Failure = faultcheck_failing:failure(Number, Size, Original, Run),
            ok = Tell({tell, {failed, maps:with([test, size, original], Failure)}}),
            faultcheck_failing:judge(Failure, First, Run)
    end.

check(CounterExample, #{fails := Fails} = Run) ->
    case faultcheck_testing:check(CounterExample, Run) of
        Passed when Passed =:= not Fails ->
            #{status => passed};
        {error, Reason} ->
            faultcheck_failing:error(Reason);
        _ ->
            Base = #{original => CounterExample, shrunk => CounterExample},
            maps:merge(Base, faultcheck_failing:verdict(CounterExample, Run))
    end.

%% A model may say nothing.
told(Told) when is_map(Told) -> Told;
told(_) -> #{}.

stats_start(#{stats := true}) -> faultcheck_stats:start();
stats_start(_) -> ok.

stats_stop(#{stats := true}, Result) ->
    Result#{stats => lists:flatten(faultcheck_stats:format(faultcheck_stats:stop()))};
stats_stop(_, Result) ->
    Result.

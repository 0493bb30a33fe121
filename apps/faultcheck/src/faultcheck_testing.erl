%% @doc The tests of a property by PropEr: all of them, one again from its seed, or a stored
%% counterexample.
-module(faultcheck_testing).

-export([all/2, shared/3, again/3, single/4, values/3, check/2]).
-export_type([run/0, tell/0]).

%% To the process that carries what is printed; see faultcheck_worker.
-type tell() :: fun((term()) -> ok).
-type run() :: #{
    job := faultcheck_property:job(),
    property := {proper:test(), faultcheck_instrument:outer()},
    %% PropEr's, without numtests
    options := [term()],
    numtests := pos_integer(),
    %% the property is expected to fail
    fails := boolean(),
    %% how many tests were begun, for others to look at
    tests := counters:counters_ref(),
    tell := tell(),
    exceptions := ets:tid(),
    %% what workers have found out already
    known := faultcheck_known:known(),
    %% in milliseconds of the monotonic clock
    deadline := integer() | infinity
}.

%% @doc The tests from number First + 1 on, up to the first that fails, which is not shrunk.
-spec all(non_neg_integer(), run()) ->
    true
    | {failed, pos_integer(), non_neg_integer(), proper:counterexample()}
    | not_found
    | {error, term()}.
all(First, #{numtests := Numtests, exceptions := Exceptions} = Run) ->
    true = ets:delete_all_objects(Exceptions),
    Next = counting(First, fun(Number) -> begun(Number, Run) end),
    Print = faultcheck_transcript:printer(run, Run),
    case quickcheck(Next, [{numtests, Numtests}, noshrink, {on_output, Print}], #{}, Run) of
        true -> true;
        {error, _} = Error -> Error;
        false -> not_found;
        CounterExample -> {failed, get(number), get(size), CounterExample}
    end.

%% A test that is known takes no time; is there time for another one?
begun(Number, #{known := Known, deadline := Deadline} = Run) ->
    case Known of
        #{Number := Outcome} ->
            counted(known(faultcheck_known:test(Outcome), Number), Run);
        #{} ->
            case Deadline =:= infinity orelse erlang:monotonic_time(millisecond) < Deadline of
                true -> counted(run, Run);
                false -> stop
            end
    end.

%% It failed in a worker; should it pass now, its size is wanted.
known(run, Number) ->
    put({doubted, Number}, faultcheck_instrument:size()),
    run;
known(Test, _Number) ->
    {instead, Test}.

counted(Turn, #{tests := Tests}) ->
    counters:add(Tests, 1, 1),
    Turn.

%% @doc One loop through numtests numbers behind First, of which Turn says what to do with each.
%% Nothing is shown. Ends at the first test that fails.
-spec shared(non_neg_integer(), fun((pos_integer()) -> run | skip | stop), run()) ->
    true | {failed, pos_integer()} | {error, term()}.
shared(First, Turn, #{numtests := Numtests, exceptions := Exceptions, tests := Tests} = Run) ->
    true = ets:delete_all_objects(Exceptions),
    Next = counting(First, fun(Number) ->
        Is = Turn(Number),
        _ = Is =:= run andalso counters:add(Tests, 1, 1),
        put(running, Is =:= run),
        Is
    end),
    Print = faultcheck_transcript:printer(share, Run),
    Options = [{numtests, Numtests}, noshrink, {on_output, Print}],
    Samples = maps:from_list([{samples, true} || not is_map_key(time, maps:get(job, Run))]),
    case quickcheck(Next, Options, Samples, Run) of
        true -> true;
        {error, _} = Error -> Error;
        _ -> {failed, get(number)}
    end.

%% The number of each test to come. After the failing one PropEr runs the property again, to
%% shrink it and to report it: the number stays.
counting(First, Begun) ->
    put(number, First),
    put(phase, testing),
    fun() ->
        case get(phase) of
            testing -> count(get(number) + 1, Begun);
            failed -> get(number)
        end
    end.

count(Number, Begun) ->
    case Begun(Number) of
        stop ->
            stop;
        Turn ->
            put(number, Number),
            put(size, faultcheck_instrument:size()),
            turn(Turn, Number)
    end.

turn(run, Number) -> Number;
turn(Other, _Number) -> Other.

%% @doc The same tests once more, with shrinking, up to the failing one: for a property whose
%% test Number depends on those before it.
-spec again(non_neg_integer(), pos_integer(), run()) ->
    true | proper:counterexample() | {error, term()}.
again(First, Number, #{numtests := Numtests, tell := Tell} = Run) ->
    Next = counting(First, fun
        (N) when N =< Number -> run;
        (_) -> stop
    end),
    put(shrinks, 0),
    ok = Tell({mute, true}),
    Print = faultcheck_transcript:printer(shrink, Run),
    Result = quickcheck(Next, [{numtests, Numtests}, {on_output, Print}], #{}, Run),
    ok = Tell({mute, false}),
    Result.

%% @doc One test from its seed: shrunk when it fails (`shrink'), or without a word (`mute').
-spec single(pos_integer(), non_neg_integer(), shrink | mute, run()) ->
    true | proper:counterexample() | {error, term()}.
single(Number, Size, shrink, Run) -> single(Number, Size, shrink, [], #{}, Run);
single(Number, Size, mute, Run) -> single(Number, Size, mute, [noshrink], #{}, Run).

single(Number, Size, Mode, More, Plan, #{tests := Tests, tell := Tell} = Run) ->
    put(phase, testing),
    put(shrinks, 0),
    ok = Tell({mute, true}),
    counters:add(Tests, 1, 1),
    Sizes = [{numtests, 1}, {start_size, Size}, {max_size, Size}],
    Print = faultcheck_transcript:printer(Mode, Run),
    Options = More ++ [{on_output, Print} | Sizes],
    Result = quickcheck(fun() -> Number end, Options, Plan, Run),
    ok = Tell({mute, false}),
    Result.

%% @doc The values of one test; nothing of the property is run.
-spec values(pos_integer(), non_neg_integer(), run()) -> [term()].
values(Number, Size, Run) ->
    put(values, []),
    Instead = fun(Value) ->
        put(values, [Value | get(values)]),
        ok
    end,
    _ = single(Number, Size, mute, [noshrink], #{instead => Instead}, Run),
    lists:reverse(get(values)).

quickcheck(Next, First, More, #{property := Property, options := Options} = Run) ->
    Plan = maps:merge(plan(Next, Run), More),
    Test = faultcheck_instrument:test(Property, Plan),
    proper:quickcheck(Test, [long_result | First] ++ Options).

plan(Next, #{job := #{module := M, function := F, seed := Seed}, exceptions := Exceptions}) ->
    #{property => {M, F}, seed => Seed, next => Next, exceptions => Exceptions}.

%% @doc Runs the property with the values of a counterexample.
-spec check(proper:counterexample(), run()) -> boolean() | {error, term()}.
check(CounterExample, #{property := Property, options := Options} = Run) ->
    put(phase, checking),
    Print = faultcheck_transcript:printer(check, Run),
    Test = faultcheck_instrument:test(Property, plan(fun() -> 1 end, Run)),
    proper:check(Test, CounterExample, [{on_output, Print} | Options]).

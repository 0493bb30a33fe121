%% @doc What a failure is: does it repeat, why did it fail, and what is it when shrunk.
-module(faultcheck_failing).

-export([judge/3, doubted/2, shrunk/3, failure/4, verdict/2, error/1]).

-type result() :: faultcheck_property:result() | map().
-type run() :: faultcheck_testing:run().

-define(RERUNS, 10).

%% @doc A failure of the tests behind number First: flaky, or failed and shrunk.
-spec judge(result(), non_neg_integer(), run()) -> result().
judge(#{original := Original} = Failure, First, #{options := Options} = Run) ->
    Shrink = not lists:member(noshrink, Options),
    %% Command sequences are run again by their own shrinker.
    Known = Shrink andalso faultcheck_case:commands(Original) =/= none,
    case Known orelse repeats(Original, Run, ?RERUNS, 0) of
        true when Shrink -> smallest(Failure, First, Run);
        true -> Failure;
        {_, _} = Rate -> Failure#{status => flaky, flaky => Rate}
    end.

smallest(#{test := Number, size := Size, original := Original} = Failure, First, Run) ->
    case shrunk(Number, Size, Run) of
        #{status := flaky, flaky := {0, 1}} ->
            %% It passes when it is run alone, from its seed.
            case repeats(Original, Run, ?RERUNS, 0) of
                true -> maps:merge(Failure, shrunk_in_place(Failure, First, Run));
                Rate -> Failure#{status => flaky, flaky => Rate}
            end;
        Shrunk ->
            maps:merge(Failure, Shrunk)
    end.

%% The values were generated from what the tests before it had found (a targeted search).
shrunk_in_place(#{test := Number, size := Size}, First, Run) ->
    ok = faultcheck_statem:reset_shrink(),
    case faultcheck_testing:again(First, Number, with_confirming(Number, Size, Run)) of
        Passed when Passed =:= true; Passed =:= false ->
            #{notes => ["not shrunk: the test depends on those before it"]};
        {error, Reason} ->
            ?MODULE:error(Reason);
        Shrunk ->
            with_shrink(faultcheck_statem:last_shrink(), failure(Number, Size, Shrunk, Run))
    end.

repeats(_Original, _Run, 0, ?RERUNS) ->
    true;
repeats(_Original, _Run, 0, Failed) ->
    {Failed, ?RERUNS};
repeats(Original, #{tell := Tell, fails := false} = Run, Left, Failed) ->
    ok = Tell({mute, true}),
    Result = faultcheck_testing:check(Original, Run),
    ok = Tell({mute, false}),
    case Result of
        false -> repeats(Original, Run, Left - 1, Failed + 1);
        _ -> repeats(Original, Run, Left - 1, Failed)
    end.

%% @doc The tests behind number First have passed here; one of them may have failed in a worker.
-spec doubted(non_neg_integer(), run()) -> result().
doubted(First, #{known := Known, numtests := Numtests} = Run) ->
    case faultcheck_known:doubt(Known) of
        {Number, Line} when Number > First, Number =< First + Numtests ->
            Size = get({doubted, Number}),
            Values = faultcheck_testing:values(Number, Size, Run),
            #{status => flaky, flaky => {0, 1}, test => Number, size => Size, reasons => [Line],
              original => Values, shrunk => Values};
        _ ->
            #{status => passed}
    end.

%% @doc One test from its seed, with shrinking.
-spec shrunk(pos_integer(), non_neg_integer(), run()) -> result().
shrunk(Number, Size, Run) ->
    ok = faultcheck_statem:reset_shrink(),
    case faultcheck_testing:single(Number, Size, shrink, with_confirming(Number, Size, Run)) of
        true ->
            #{status => flaky, flaky => {0, 1}};
        {error, Reason} ->
            ?MODULE:error(Reason);
        Shrunk ->
            with_shrink(faultcheck_statem:last_shrink(), failure(Number, Size, Shrunk, Run))
    end.

%% PropEr takes the runs that confirm the failure of a command sequence for shrinking steps. A
%% user who limits the steps does not mean them.
with_confirming(Number, Size, #{options := Options} = Run) ->
    case [N || {max_shrinks, N} <- Options] of
        [] ->
            Run;
        _ ->
            Uncounted = Run#{tests := counters:new(1, [])},
            case faultcheck_case:commands(faultcheck_testing:values(Number, Size, Uncounted)) of
                none -> Run;
                {ok, _} -> Run#{options := [with_confirming(Option) || Option <- Options]}
            end
    end.

with_confirming({max_shrinks, N}) -> {max_shrinks, N + ?RERUNS};
with_confirming(Option) -> Option.

with_shrink(undefined, Failure) ->
    maps:remove(original, Failure#{shrinks => get(shrinks)});
with_shrink(#{flaky := Flaky, original := Original} = Shrink, #{shrunk := Shrunk} = Failure) ->
    Whole = Failure#{
        original => faultcheck_case:with_commands(Shrunk, Original), shrink => Shrink
    },
    case Flaky of
        false -> Whole;
        _ -> Whole#{status => flaky, flaky => Flaky, shrunk => maps:get(original, Whole)}
    end.

%% @doc A failing test with its reasons.
-spec failure(pos_integer(), non_neg_integer(), proper:counterexample(), run()) -> result().
failure(Number, Size, CounterExample, Run) ->
    Values = #{original => CounterExample, shrunk => CounterExample},
    maps:merge(Values#{test => Number, size => Size}, verdict(CounterExample, Run)).

%% @doc What the last run of the property says: why it failed. Throws `{stop, Result}' when it is
%% the system under test that could not be started.
-spec verdict(proper:counterexample(), run()) -> result().
verdict(CounterExample, Run) ->
    {Reason, Lines} =
        case faultcheck_parallel:why(CounterExample) of
            {ok, Words} -> {none, faultcheck_reason:trimmed(Words)};
            none -> why(faultcheck_case:commands(CounterExample), faultcheck_run:last(), Run)
        end,
    case faultcheck_reason:unstarted(Reason) of
        {true, Line} ->
            throw({stop, #{status => unstarted, reasons => [Line]}});
        false ->
            Timeout = [{timeout, true} || faultcheck_reason:is_timeout(Reason)],
            maps:merge(#{status => failed, reasons => Lines}, maps:from_list(Timeout))
    end.

%% The run of the commands says most, then an exception, then what PropEr prints.
why({ok, Commands}, {_, Commands, {_, _, Result}}, _Run) when Result =/= ok ->
    {raised(Result), faultcheck_reason:trimmed(faultcheck_pretty:why(Result))};
why(_, _, #{exceptions := Table}) ->
    case faultcheck_instrument:exception(Table) of
        {Class, Reason, Stack} -> {Reason, faultcheck_reason:lines(Class, Reason, Stack)};
        none -> {none, faultcheck_transcript:reasons()}
    end.

raised({exception, _, Reason, _}) -> Reason;
raised({_, {exception, _, Reason, _}}) -> Reason;
raised(_) -> none.

%% @doc The result when PropEr could not run the property.
-spec error(term()) -> result().
error(Reason) ->
    #{status => error, reasons => [faultcheck_reason:proper(Reason)]}.

%% @doc What came of tests that workers have run before the run that tells of them.
%%
%% The run goes through PropEr's loop as always; a test that is known passes, or is rejected, at
%% once, and leaves behind what it left behind in its worker: samples, counts, printed text. A test
%% that failed there is run again, and is the failure of the run. So the output is that of a run
%% without workers.
-module(faultcheck_known).

-export([outcome/4, failed/1, lost/1, test/1, doubt/1]).
-export_type([known/0, outcome/0]).

-type known() :: #{pos_integer() => outcome()}.
%% Small, as there may be many.
-type outcome() ::
    passed
    | {passed | rejected, Left :: binary()}
    %% the search that made the failing commands, so that it need not be done again
    | {failed, faultcheck_search:found()}
    %% its worker died or hung; why, in a line
    | {lost, string()}.

%% @doc What a test left behind.
-spec outcome(passed | rejected, list(), faultcheck_stats:rows(), binary()) -> outcome().
outcome(passed, [], [], <<>>) -> passed;
outcome(Result, Samples, Counts, Printed) ->
    {Result, term_to_binary({Samples, Counts, Printed})}.

%% @doc A test that failed, with the search that its process made last.
-spec failed(faultcheck_search:found()) -> outcome().
failed(Found) -> {failed, Found}.

%% @doc A test in which its worker died or hung, and how.
-spec lost(string()) -> outcome().
lost(Line) -> {lost, Line}.

%% @doc The test in place of one that is known; `run' for one that is to be run.
-spec test(outcome()) -> proper:test() | run.
test(passed) ->
    true;
test({failed, Found}) ->
    ok = faultcheck_search:remember(Found),
    run;
test({lost, _}) ->
    run;
test({Result, Left}) ->
    {Samples, Counts, Printed} = binary_to_term(Left),
    ok = faultcheck_stats:add(Counts),
    ok = io:put_chars(Printed),
    faultcheck_instrument:with_samples(Samples, ended(Result)).

ended(passed) -> true;
ended(rejected) -> proper:implies(false, fun() -> true end).

%% @doc The first test that failed in a worker, and how: should it pass when it is run again, it
%% is flaky.
-spec doubt(known()) -> {pos_integer(), string()} | none.
doubt(Known) ->
    Failed = [
        {Number, Line}
     || {Number, Outcome} <- maps:to_list(Known), Line <- line(Outcome)
    ],
    case lists:sort(Failed) of
        [First | _] -> First;
        [] -> none
    end.

line({failed, _}) -> ["it failed in a worker and passed when it was run again"];
line({lost, Line}) -> [Line ++ " in a worker; it passed when it was run again"];
line(_) -> [].

%% @doc A worker's share of the tests of a property: the child VM's side of faultcheck_team.
%%
%% The worker asks for numbers of tests and runs those, in PropEr's own loop, so that each test has
%% the size and the seed that it has in a run without workers; tests of others are passed over.
%% What came of a test is told at once, with all that it leaves behind in a run: PropEr's samples,
%% counts of faultcheck_stats, printed text. faultcheck_known puts it back into such a run.
-module(faultcheck_share).

-export([run/1, tested/2]).

-type run() :: faultcheck_testing:run().

%% @doc Runs blocks of tests until there are no more, or one fails.
-spec run(run()) -> #{status := passed | failed | error}.
run(#{property := Property} = Run) ->
    case faultcheck_instrument:independent(Property) of
        true -> blocks(ask(Run), Run);
        %% Its tests are left to the run itself.
        false -> #{status => error}
    end.

ask(#{tell := Tell}) ->
    ok = Tell({tell, want_tests}),
    receive
        {tests, Block} -> Block
    end.

blocks(none, _Run) ->
    #{status => passed};
blocks({First, _} = Block, #{numtests := Numtests, tell := Tell} = Run) ->
    put(block, Block),
    %% With a time limit the sizes grow again with every numtests tests.
    Offset = (First - 1) div Numtests * Numtests,
    _ = printed(Tell),
    case faultcheck_testing:shared(Offset, fun(Number) -> turn(Number, Run) end, Run) of
        true -> blocks(left(get(block), get(number), Run), Run);
        {failed, Number} -> failed(Number, Run);
        {error, _} -> #{status => error}
    end.

%% What becomes of a number: a test to run, one to pass over, or the end of this loop.
turn(Number, Run) ->
    case get(block) of
        {stopped, _} -> stop;
        {First, _} when Number < First -> skip;
        {_, Last} when Number =< Last -> run;
        _ -> turned(Number, ask(Run), Run)
    end.

%% A block that another worker left behind may have been passed already.
turned(Number, {First, _} = Block, Run) when First >= Number ->
    put(block, Block),
    turn(Number, Run);
turned(_Number, Block, _Run) ->
    put(block, {stopped, Block}),
    stop.

%% What is left to do when PropEr's loop has ended.
left({stopped, Block}, _Number, _Run) -> Block;
left({_, Last}, Number, Run) when Number >= Last -> ask(Run);
left({First, Last}, Number, _Run) when Number >= First -> {Number + 1, Last};
left(Block, _Number, _Run) -> Block.

%% ---- what came of a test ------------------------------------------------------------------

%% @doc The test that ran last has passed, or its precondition was false.
-spec tested(passed | rejected, run()) -> ok.
tested(Result, #{tell := Tell, exceptions := Table}) ->
    Samples = faultcheck_instrument:take_samples(Table),
    Outcome = faultcheck_known:outcome(Result, Samples, faultcheck_stats:take(), printed(Tell)),
    Tell({tell, {tested, get(number), Outcome}}).

failed(Number, #{tell := Tell}) ->
    ok = Tell({tell, {tested, Number, faultcheck_known:failed(faultcheck_search:found())}}),
    #{status => failed}.

%% What was printed since the last time.
printed(Tell) ->
    ok = Tell({capture, self()}),
    receive
        {captured, Text} -> Text
    end.

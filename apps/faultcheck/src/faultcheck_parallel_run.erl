%% @doc Executes a parallel case by Erlang processes, one for each branch.
-module(faultcheck_parallel_run).

-export([by_processes/1]).

-type execute() ::
    fun((faultcheck_parallel_case:test_case(), pos_integer()) -> [faultcheck_linear:outcome()]).

%% @doc A function that runs a case that many times, with Setup before each.
-spec by_processes(Setup :: fun(() -> term())) -> execute().
by_processes(Setup) ->
    fun(Case, Repetitions) ->
        [
            begin
                _ = Setup(),
                once(Case)
            end
         || _ <- lists:seq(1, Repetitions)
        ]
    end.

once({parallel, First, Branches, Last}) ->
    After = sequence(First, {#{}, #{}}),
    Outcomes = at_once(Branches, After),
    sequence(Last, lists:foldl(fun join/2, After, Outcomes)).

join({Results, Times}, {AllResults, AllTimes}) ->
    {maps:merge(AllResults, Results), maps:merge(AllTimes, Times)}.

%% All start when the last process is there.
at_once(Branches, Before) ->
    Caller = self(),
    Started = [
        spawn_monitor(fun() ->
            receive
                {Caller, go} -> Caller ! {self(), sequence(Branch, Before)}
            end
        end)
     || Branch <- Branches
    ],
    _ = [Pid ! {Caller, go} || {Pid, _} <- Started],
    [ended(Process) || Process <- Started].

ended({Pid, Monitor}) ->
    receive
        {Pid, Outcome} ->
            true = demonitor(Monitor, [flush]),
            Outcome;
        {'DOWN', Monitor, process, Pid, Reason} -> error({branch_died, Reason})
    end.

sequence(Commands, Before) ->
    lists:foldl(fun command/2, Before, Commands).

command({set, {var, N}, {call, Mod, Name, Args}}, {Results, Times}) ->
    Begin = erlang:unique_integer([monotonic]),
    Result =
        case faultcheck_run:attempt(fun() ->
                 apply(Mod, Name, faultcheck_run:evaluate(Args, Results))
             end) of
            {ok, Value} -> Value;
            Exception -> Exception
        end,
    End = erlang:unique_integer([monotonic]),
    {Results#{N => Result}, Times#{N => {Begin, End}}}.

%% @doc Looks for a failure that is expected, and gives it for judgement.
%%
%% For properties that pass only if another property fails in the expected way. The other property
%% runs as any user's would, in a process of its own, with generator and shrinker as they are.
-module(faultcheck_expected).

-export([failure/3]).

%% @doc The shrunk counterexample of the property that Make builds, drawn from Seed. Options are
%% PropEr's. Make and, at the end, Stop run in the searching process; an error that they raise (a
%% system under test that cannot be started, in its own words) is raised again here.
-spec failure(
    {Make :: fun(() -> proper:outer_test()), Stop :: fun(() -> term())},
    Seed :: non_neg_integer(),
    Options :: [term()]
) -> {found, proper:counterexample()} | not_found.
failure(Property, Seed, Options) ->
    Caller = self(),
    {Pid, Monitor} = spawn_monitor(fun() -> Caller ! {self(), tried(Property, Seed, Options)} end),
    receive
        {Pid, Result} ->
            true = demonitor(Monitor, [flush]),
            found(Result);
        {'DOWN', Monitor, process, Pid, Reason} ->
            error({search_ended, Reason})
    end.

found({raised, Reason, Stack}) -> erlang:raise(error, Reason, Stack);
found(true) -> not_found;
found([_ | _] = CounterExample) -> {found, CounterExample}.

tried(Property, Seed, Options) ->
    try
        searched(Property, Seed, Options)
    catch
        error:Reason:Stack -> {raised, Reason, Stack}
    end.

%% PropEr draws from the random state of this process, which it seeds before the set-up function
%% runs.
searched({Make, Stop}, Seed, Options) ->
    Seeded = proper:setup(fun() -> seed(Seed) end, Make()),
    Result = proper:quickcheck(Seeded, [long_result, quiet | Options]),
    _ = Stop(),
    Result.

seed(Seed) ->
    _ = rand:seed(exsss, Seed),
    fun() -> ok end.

%% @doc Looks for a collision under options that do not prevent it, and judges what was found.
%%
%% For properties that pass only if another property fails in the expected way. The other property
%% runs as any user's would, in a process of its own, with generator and shrinker as they are.
-module(copter_unsafe).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([fails_as_expected/2, find/2]).
-export_type([found/0]).

-type command() :: faultcheck_generator:command().
-type found() :: {found, [command()]} | not_found.

-define(TESTS, 5000).
-define(BIAS, 0.9).
%% ms
-define(SHRINKING, 3000).

%% @doc True if a collision is found, and what it shrinks to is a copter or more, steered and left
%% alone: nothing that is not needed, and it collides again.
-spec fails_as_expected(copter_options:options(), Seed :: non_neg_integer()) -> boolean().
fails_as_expected(Options, Seed) ->
    case find(Options, Seed) of
        not_found ->
            io:format("~s: no collision in ~b tests~n", [copter_options:label(Options), ?TESTS]),
            false;
        {found, Commands} ->
            expected(Options, Commands)
    end.

expected(Options, Commands) ->
    Names = lists:usort([Name || {set, _, {call, copter_eqc, Name, _}} <- Commands]),
    Again = copter_trial:run(Options, Commands),
    ok = copter_sut:stop(),
    case {Names -- [add_copter, iterate, steer], Again} of
        {[], {collision, _}} ->
            true;
        _ ->
            Label = copter_options:label(Options),
            io:format("~s: unexpected failure ~0tp of ~0tp~n", [Label, Again, Commands]),
            false
    end.

%% @doc The shrunk failure of the property over these options.
-spec find(copter_options:options(), Seed :: non_neg_integer()) -> found().
find(Options, Seed) ->
    Caller = self(),
    {Pid, Monitor} = spawn_monitor(fun() -> Caller ! {self(), result(Options, Seed)} end),
    receive
        {Pid, Result} ->
            true = demonitor(Monitor, [flush]),
            found(Result);
        {'DOWN', Monitor, process, Pid, Reason} ->
            error({search_ended, Reason})
    end.

result(Options, Seed) ->
    try
        search(Options, Seed)
    catch
        error:Reason:Stack -> {raised, Reason, Stack}
    end.

found({raised, Reason, Stack}) -> erlang:raise(error, Reason, Stack);
found(Found) -> Found.

%% PropEr draws from the random state of this process, which it seeds before the set-up function
%% runs.
search(Options, Seed) ->
    %% A simulator that cannot be started is told here, in its own words.
    ok = copter_eqc:begin_test(Options),
    Silent = copter_eqc:safe(Options, fun(_, _) -> ok end, #{max_ms => ?SHRINKING}),
    Seeded = ?SETUP(fun() -> seed(Seed) end, Silent),
    Sizes = [{numtests, ?TESTS}, {start_size, 30}, {max_size, 42}],
    Result = faultcheck_range:with_bias(?BIAS, fun() ->
        proper:quickcheck(Seeded, [long_result, quiet | Sizes])
    end),
    ok = copter_sut:stop(),
    case Result of
        true -> not_found;
        [Commands] -> {found, Commands}
    end.

seed(Seed) ->
    _ = rand:seed(exsss, Seed),
    fun() -> ok end.

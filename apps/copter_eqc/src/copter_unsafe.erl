%% @doc Looks for a collision under options that do not prevent it, and judges what was found.
%%
%% For properties that pass only if another property fails in the expected way. The other property
%% runs as any user's would, in a process of its own, with generator and shrinker as they are.
-module(copter_unsafe).

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
    Sizes = [{numtests, ?TESTS}, {start_size, 30}, {max_size, 42}],
    Make = fun() -> safe(Options) end,
    case faultcheck_expected:failure({Make, fun copter_sut:stop/0}, Seed, Sizes) of
        {found, [Commands]} -> {found, Commands};
        not_found -> not_found
    end.

safe(Options) ->
    ok = faultcheck_range:set_bias(?BIAS),
    %% A simulator that cannot be started is told here, in its own words.
    ok = copter_eqc:begin_test(Options),
    copter_eqc:safe(Options, fun(_, _) -> ok end, #{max_ms => ?SHRINKING}).

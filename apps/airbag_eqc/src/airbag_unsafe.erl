%% @doc Looks for the unintended explosion of an unprotected airbag, and judges what was found.
%%
%% For properties that pass only if another property fails in the expected way. The other property
%% runs as any user's would, in a process of its own, with generator and shrinker as they are.
-module(airbag_unsafe).

-export([fails_as_expected/2, find/2]).
-export_type([found/0]).

-type command() :: faultcheck_generator:command().
-type found() :: {found, [command()]} | not_found.

%% Enough for every variant: the slowest needs about a thousand tests in the median.
-define(TESTS, 50000).
-define(MOST_COMMANDS, 3).

%% @doc True if the failure is found, is a message that fires the airbag, and is short.
-spec fails_as_expected(airbag_options:options(), Seed :: non_neg_integer()) -> boolean().
fails_as_expected(Options, Seed) ->
    case find(Options, Seed) of
        not_found ->
            io:format("~s: no failure in ~b tests~n", [airbag_options:label(Options), ?TESTS]),
            false;
        {found, Commands} ->
            expected(Options, Commands)
    end.

expected(Options, Commands) ->
    Names = [Name || {set, _, {call, airbag_eqc, Name, _}} <- Commands],
    case length(Names) =< ?MOST_COMMANDS andalso lists:last(Names) =:= sensor of
        true ->
            true;
        false ->
            Label = airbag_options:label(Options),
            io:format("~s: unexpected failure ~0tp~n", [Label, Commands]),
            false
    end.

%% @doc The shrunk failure of the property over these options.
-spec find(airbag_options:options(), Seed :: non_neg_integer()) -> found().
find(Options, Seed) ->
    %% Sizes from the upper half: short sequences hold no failure.
    Sizes = [{numtests, ?TESTS}, {start_size, 20}, {max_size, 42}],
    Make = fun() -> safe(Options) end,
    case faultcheck_expected:failure({Make, fun airbag_sut:stop/0}, Seed, Sizes) of
        {found, [Commands]} -> {found, Commands};
        not_found -> not_found
    end.

safe(Options) ->
    %% An airbag that cannot be started is told here, in its own words.
    ok = airbag_eqc:begin_test(Options),
    airbag_eqc:safe(Options, fun(_, _) -> ok end).

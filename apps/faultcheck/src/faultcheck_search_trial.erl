%% @doc One repetition of a comparison of searches: what a search of one column cost in one world,
%% and what its failure is when shrunk.
-module(faultcheck_search_trial).

-export([columns/0, run/2, seed/3]).
-export_type([world/0, column/0, trial/0]).

-type column() :: uniform_random | boundary_random | uniform_guided | boundary_guided.
-type world() :: #{
    name := string(),
    %% what it is, in words, with its parameters
    label := string(),
    model := module(),
    %% of faultcheck_search_options: time, begin_test, and what differs from the defaults
    search := map(),
    %% most runs in one repetition, and repetitions, 0 for a column that is left out
    caps := #{column() => pos_integer()},
    repetitions := #{column() => non_neg_integer()}
}.
-type trial() :: #{
    world := string(),
    column := column(),
    repetition := pos_integer(),
    seed := non_neg_integer(),
    found := boolean(),
    runs := non_neg_integer(),
    %% simulated time in lengths of a sequence, with prefixes restored where there are snapshots
    time := float(),
    %% in milliseconds of the clock
    ms := non_neg_integer(),
    %% commands of the failure as found and as shrunk, and the names of the latter
    shrunk => {pos_integer(), [atom()]}
}.

%% The share of components at a limit of their range.
-define(BIAS, 0.9).
-define(SHRINK, #{confirm => 1, max_tries => 300, max_ms => 20000, linear => 8}).

%% @doc The columns of the comparison, in their order.
-spec columns() -> [column()].
columns() -> [uniform_random, boundary_random, uniform_guided, boundary_guided].

settings(uniform_random) -> #{strategy => random, bias => 0};
settings(boundary_random) -> #{strategy => random, bias => ?BIAS};
settings(uniform_guided) -> #{strategy => evolution, bias => 0};
settings(boundary_guided) -> #{strategy => evolution, bias => ?BIAS}.

%% @doc The seed of a repetition: Base + 100 000 W + 10 000 C + R for world number W and column
%% number C, from 0 on.
-spec seed({Base :: non_neg_integer(), World :: non_neg_integer()}, column(), pos_integer()) ->
    non_neg_integer().
seed({Base, World}, Column, Repetition) ->
    [Number] = [N || {N, C} <- lists:zip([0, 1, 2, 3], columns()), C =:= Column],
    Base + 100000 * World + 10000 * Number + Repetition.

%% @doc Runs a repetition in the calling process. The first few failures of a column are shrunk.
-spec run(
    world(), {column(), Repetition :: pos_integer(), Seed :: non_neg_integer(), boolean()}
) -> trial().
run(World, {Column, Repetition, Seed, Shrink}) ->
    #{name := Name, model := Model, search := Search, caps := Caps} = World,
    Options = maps:merge(Search#{plain_share => 0}, settings(Column)),
    Began = erlang:monotonic_time(millisecond),
    {Status, #{runs := Runs, simulated := Time} = Result} =
        faultcheck_search:search(Model, Options#{
            seed => Seed, max_runs => maps:get(Column, Caps)
        }),
    Ms = erlang:monotonic_time(millisecond) - Began,
    #{time := Length} = faultcheck_search_options:new(Search),
    Trial = #{
        world => Name,
        column => Column,
        repetition => Repetition,
        seed => Seed,
        found => Status =:= found,
        runs => Runs,
        time => Time / Length,
        ms => Ms
    },
    case Status =:= found andalso Shrink of
        true -> maps:merge(Trial, shrunk(Result, World, Seed));
        false -> Trial
    end.

%% A failure that does not fail from the beginning would speak of incomplete snapshots.
shrunk(#{commands := Commands, side := Side}, #{model := Model, search := Search}, Seed) ->
    #{begin_test := Begin} = faultcheck_search_options:new(Search),
    Verdict = fun(Candidate) ->
        _ = Begin(),
        case faultcheck_run:commands(Model, Candidate, [], faultcheck_search_run:observer(Model)) of
            {_, _, ok} -> passes;
            _ -> {fails, maps:get(kind, faultcheck_run:failure(Candidate))}
        end
    end,
    {fails, _} = Verdict(Commands),
    Failure = faultcheck_run:failure(Commands),
    #{shrunk := Shrunk} = faultcheck_proper:with_state(10, {Seed, 1, 1}, fun() ->
        Options = faultcheck_shrinker:options(?SHRINK),
        faultcheck_shrinker:minimise(Model, Commands, Side, Verdict, {Options, Failure})
    end),
    #{shrunk => {length(Commands), [Name || {set, _, {call, _, Name, _}} <- Shrunk]}}.

%% @doc Many tests of many settings: how often copters collide.
%%
%% A cell is one setting with its number of tests. All cells of an experiment are enumerated
%% together (faultcheck_enumerate), so that it shows progress, goes on where it was interrupted, and
%% gives the same numbers with any number of workers.
-module(copter_experiment).

-export([rates/4, searches/4]).
-export_type([cell/0, rate/0, rates/0, search/0]).

-type label() :: term().
-type cell() :: {label(), copter_options:options(), Tests :: pos_integer()}.
-type rate() :: #{
    tests := non_neg_integer(),
    collisions := non_neg_integer(),
    %% of all tests, up to their end or collision
    simulated_s := float()
}.
-type rates() :: #{label() => rate()}.
-type search() :: #{seed := integer(), found := boolean(), runs := pos_integer(),
                    simulated_s := float()}.

%% @doc Collision rates of all cells. Test i of each cell is drawn from the seed and i.
-spec rates(string(), [cell()], Seed :: non_neg_integer(), faultcheck_enumerate:options()) ->
    rates().
rates(Name, Cells, Seed, Enumerate) ->
    Items = [{Label, I} || {Label, _, Tests} <- Cells, I <- lists:seq(1, Tests)],
    ByLabel = maps:from_list([{Label, Options} || {Label, Options, _} <- Cells]),
    Check = fun({Label, Number}, _) ->
        test(Label, maps:get(Label, ByLabel), Seed, Number)
    end,
    Chunks = maps:merge(#{chunk => 50}, Enumerate),
    #{counts := Counts} = enumerated(Items, Check, {Name, Cells, Seed}, Chunks),
    maps:from_list([{Label, rate(Label, Counts)} || {Label, _, _} <- Cells]).

test(Label, Options, Seed, Number) ->
    Commands = copter_trial:commands(Options, Seed, Number),
    Result = copter_trial:run(Options, Commands),
    Counts = #{{Label, tests} => 1, {Label, us} => copter_sut:time_us()},
    case Result of
        safe -> {Counts, []};
        {collision, _} ->
            {Counts#{{Label, collisions} => 1}, []};
        {failed, Why} -> error({test_failed, Label, Number, Why})
    end.

rate(Label, Counts) ->
    #{
        tests => maps:get({Label, tests}, Counts, 0),
        collisions => maps:get({Label, collisions}, Counts, 0),
        simulated_s => maps:get({Label, us}, Counts, 0) / 1.0e6
    }.

%% @doc Guided searches, one for each seed 1..N; Search are options of faultcheck_search.
-spec searches(copter_options:options(), N :: pos_integer(), Search :: map(),
               faultcheck_enumerate:options()) -> [search()].
searches(#{horizon_ms := Horizon} = Options, N, Search, Enumerate) ->
    Begin = fun() -> ok = copter_eqc:begin_test(Options) end,
    Given = Search#{time => Horizon, begin_test => Begin},
    Check = fun(Seed, _) ->
        ok = copter_options:use(Options),
        {Status, #{runs := Runs, simulated := Simulated}} =
            faultcheck_search:search(copter_eqc, Given#{seed => Seed}),
        Result = #{
            seed => Seed,
            found => Status =:= found,
            runs => Runs,
            simulated_s => Simulated / 1000
        },
        {#{}, [Result]}
    end,
    Name = {searches, Options, Search},
    #{found := Found} =
        enumerated(lists:seq(1, N), Check, Name, maps:merge(#{chunk => 1}, Enumerate)),
    Found.

enumerated(Items, Check, Name, Options) ->
    %% Tests and collisions of the code that runs now; another's state is not taken up.
    Id = {Name, maps:get(name, Options, none)},
    Stop = fun(_) -> copter_sut:stop() end,
    case faultcheck_enumerate:run(faultcheck_space:items(Items), Check, Options#{
        name => Id, stop => Stop
    }) of
        {ok, Result} -> Result;
        {error, Reason} -> throw({enumeration, Reason})
    end.

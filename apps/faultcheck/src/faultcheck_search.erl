%% @doc Guided search: command sequences that come nearer and nearer to failing.
%%
%% ```
%% prop_no_collision() -> faultcheck_search:property(copter_eqc, #{bias => 0.9, time => 20}).
%%
%% {found, #{commands := Commands, runs := 412}} =
%%     faultcheck_search:search(copter_eqc, #{seed => 7, time => 20, max_runs => 5000}).
%% '''
%% The model says how near a run came (objective/1, see faultcheck_model). Strategy `evolution':
%%
%%   repeat until a run fails or the budget is spent:
%%     P := the 5 best of 20 fresh sequences
%%     until 60 children in succession do not improve the best:
%%       10 children, each of the better of two random members of P, or in 3 of 10 cases a fresh
%%          sequence: where the objective leads nowhere, chance goes on
%%       P := the 5 best of parents and children, at most 2 with the same Key
%%
%% Strategy `random' has fresh sequences only. Either way each run that was begun counts, and its
%% simulated time: with snapshots a child is charged for what follows the last snapshot in the part
%% it shares with its parent.
%%
%% A search is determined by its seed: one process, one population, its own random stream, which
%% commands of the model cannot disturb. Several searches (the tests of a property) run side by
%% side with `rebar3 proper --workers N'.
-module(faultcheck_search).

%% PropEr 1.5 declares the body of a property opaque, but takes plain terms.
-dialyzer({[no_opaque, no_return], [property/2, measured/2]}).
-export([search/2, commands/2, property/2, last/0]).
-export([found/0, remember/1]).
-export_type([result/0, found/0]).

-type result() :: #{
    %% the failing sequence, or the one that came nearest
    commands := [faultcheck_generator:command()],
    side := faultcheck_generator:side(),
    outcome := faultcheck_search_run:outcome(),
    value := number() | worst,
    key := term(),
    runs := non_neg_integer(),
    %% simulated time: of all runs from their beginning, and what was simulated
    elapsed := number(),
    simulated := number(),
    populations := non_neg_integer(),
    snapshots := boolean()
}.
%% The last search of this process and what it depends on, to be told to another process.
-type found() :: {Key :: term(), {found | not_found, result()}} | none.

-record(search, {
    mod :: module(),
    options :: faultcheck_search_options:options(),
    population = [] :: [faultcheck_search_run:run()],
    best = none :: faultcheck_search_run:run() | none,
    runs = 0 :: non_neg_integer(),
    elapsed = 0 :: number(),
    simulated = 0 :: number(),
    populations = 0 :: non_neg_integer(),
    %% children since the best became better by `improvement', and its value then
    idle = 0 :: non_neg_integer(),
    mark = worst :: number() | worst,
    %% snapshots that the system under test holds for us
    live = #{} :: #{term() => true}
}).

%% @doc Searches, outside of any property. Options: those of faultcheck_search_options and `seed'.
-spec search(module(), map()) -> {found | not_found, result()}.
search(Mod, Given) ->
    Seed = maps:get(seed, Given, 0),
    Options = faultcheck_search_options:new(maps:remove(seed, Given)),
    faultcheck_proper:with_state(10, {Seed, 0, 0}, fun() ->
        faultcheck_proper:preserving_random({?MODULE, Seed}, fun() -> begun(Mod, Options) end)
    end).

begun(Mod, #{strategy := Strategy} = Options) ->
    %% What a test begins with may also say what is generated.
    _ = undisturbed(maps:get(begin_test, Options)),
    Info = faultcheck_model:info(Mod),
    Strategy =:= random orelse faultcheck_model:has_objective(Info) orelse
        error({no_objective, Mod, "a guided search needs objective(State) of the model"}),
    Search = #search{mod = Mod, options = without_snapshots(Options)},
    case bias(Options) of
        undefined -> strategy(Search);
        Bias -> faultcheck_range:with_bias(Bias, fun() -> strategy(Search) end)
    end.

%% Some searches go without, so that inner values stay likely.
bias(#{bias := undefined}) ->
    undefined;
bias(#{bias := Bias, plain_share := Plain}) ->
    case rand:uniform() < Plain of
        true -> 0;
        false -> Bias
    end.

%% Fresh sequences have no parents.
without_snapshots(#{strategy := random} = Options) -> Options#{snapshots => 0};
without_snapshots(Options) -> Options.

%% ---- as a PropEr type and property --------------------------------------------------------

%% @doc As faultcheck_statem:commands/2, but a value is what a search finds: a failing sequence, or
%% the nearest one. The system under test runs while the value is made. Options: as search/2, and
%% `shrink', those of faultcheck_shrinker.
-spec commands(module(), map()) -> proper_types:type().
commands(Mod, Given) ->
    Options = faultcheck_search_options:new(maps:without([shrink, seed], Given)),
    faultcheck_statem:type(Mod, maps:get(shrink, Given, #{}), fun(_Size) ->
        {_, #{commands := Commands, side := Side}} = once(Mod, Options),
        {Commands, Side}
    end).

%% A failing test is made again from its seed before it is shrunk: that needs no second search.
once(Mod, Options) ->
    Seed = rand:uniform(1 bsl 58),
    Key = {Mod, maps:remove(begin_test, Options), faultcheck_range:bias(), Seed},
    case found() of
        {Key, Found} ->
            Found;
        _ ->
            Found = faultcheck_proper:preserving_random({?MODULE, Seed}, fun() ->
                begun(Mod, Options)
            end),
            ok = remember({Key, Found}),
            Found
    end.

%% @doc The last search of this process, for remember/1 in another one.
-spec found() -> found().
found() ->
    case get({?MODULE, last}) of
        undefined -> none;
        Last -> Last
    end.

%% @doc Makes what another process found the last search of this one.
-spec remember(found()) -> ok.
remember(none) ->
    ok;
remember(Found) ->
    _ = put({?MODULE, last}, Found),
    ok.

%% @doc The result of this process's last search; none when the commands came from elsewhere, such
%% as a stored case.
-spec last() -> result() | none.
last() ->
    case found() of
        {_, {_, Result}} -> Result;
        none -> none
    end.

%% @doc The property that no search finds a failing sequence; each test is one search. Give it its
%% number of searches: `prop_x(opts) -> [{numtests, 5}]'.
-spec property(module(), map()) -> proper:test().
property(Mod, Given) ->
    #{begin_test := Begin} = faultcheck_search_options:new(maps:without([shrink, seed], Given)),
    proper:forall(commands(Mod, Given), fun(Commands) ->
        _ = Begin(),
        Observe = faultcheck_search_run:observer(Mod),
        {_, _, Result} = Run = faultcheck_run:commands(Mod, Commands, [], Observe),
        Tell = fun() -> io:put_chars(faultcheck_pretty:format(Commands, Run)) end,
        proper:whenfail(Tell, fun() -> measured(last(), Result =:= ok) end)
    end).

measured(#{runs := Runs, value := Value}, Passed) when is_number(Value) ->
    proper:measure("Runs of a search", Runs,
                   proper:measure("Smallest objective", Value, Passed));
measured(_, Passed) ->
    Passed.

%% ---- strategies ---------------------------------------------------------------------------

strategy(#search{options = #{strategy := random}} = Search) ->
    random(Search);
strategy(Search) ->
    population(Search).

random(#search{mod = Mod, options = Options} = Search) ->
    case run(faultcheck_search_mutation:fresh(Mod, Options), none, Search) of
        {going, _, Next} -> random(Next);
        Ended -> Ended
    end.

%% A new population.
population(#search{options = #{fresh := Fresh}, populations = Number} = Search) ->
    fresh(Fresh, [], Search#search{populations = Number + 1, idle = 0, mark = worst}).

fresh(0, Runs, Search) ->
    generation(select(Runs, Search));
fresh(Left, Runs, #search{mod = Mod, options = Options} = Search) ->
    case run(faultcheck_search_mutation:fresh(Mod, Options), none, Search) of
        {going, Run, Next} -> fresh(Left - 1, [Run | Runs], Next);
        Ended -> Ended
    end.

%% A batch of children. They are all made before the first of them is run.
generation(#search{idle = Idle, options = #{patience := Patience}} = Search) when
    Idle >= Patience
->
    population(released([], Search#search{population = []}));
generation(#search{mod = Mod, options = Options} = Search) ->
    #search{population = Population} = Search,
    Children = [child(Mod, Population, Options) || _ <- lists:seq(1, maps:get(children, Options))],
    children(Children, [], Search).

child(Mod, Population, #{immigrants := Immigrants} = Options) ->
    case rand:uniform() < Immigrants of
        true ->
            {faultcheck_search_mutation:fresh(Mod, Options), none};
        false ->
            Parent = parent(Population),
            {faultcheck_search_mutation:child(Mod, Parent, Options), Parent}
    end.

parent(Population) ->
    Size = length(Population),
    nearer(lists:nth(rand:uniform(Size), Population), lists:nth(rand:uniform(Size), Population)).

nearer(#{value := A} = Run, #{value := B}) when A =< B -> Run;
nearer(_, Run) -> Run.

children([], Runs, #search{population = Parents} = Search) ->
    %% Children first: of equals the younger one stays.
    generation(improved(length(Runs), select(lists:reverse(Runs) ++ Parents, Search)));
children([{Sequence, Parent} | Rest], Runs, Search) ->
    case run(Sequence, Parent, Search) of
        {going, Run, Next} -> children(Rest, [Run | Runs], Next);
        Ended -> Ended
    end.

improved(Children, #search{population = [#{value := Best} | _]} = Search) ->
    #search{idle = Idle, mark = Mark, options = #{improvement := Least}} = Search,
    case is_number(Best) andalso (Mark =:= worst orelse Best < Mark - Least) of
        true -> Search#search{idle = 0, mark = Best};
        false -> Search#search{idle = Idle + Children}
    end.

%% The best of some runs become the population; the snapshots of the others are let go.
select(Runs, #search{options = #{population := Most, same_key := SameKey}} = Search) ->
    Sorted = lists:sort(fun(#{value := A}, #{value := B}) -> A =< B end, Runs),
    Kept = best(Sorted, Most, SameKey, #{}, []),
    released(Kept, Search#search{population = Kept}).

best([], _Left, _SameKey, _Keys, Kept) ->
    lists:reverse(Kept);
best(_Runs, 0, _SameKey, _Keys, Kept) ->
    lists:reverse(Kept);
best([#{key := Key, commands := Commands} = Run | Rest], Left, SameKey, Keys, Kept) ->
    Same = maps:get(Key, Keys, 0),
    Twin = lists:any(fun(#{commands := C}) -> C =:= Commands end, Kept),
    case Same < SameKey andalso not Twin of
        true -> best(Rest, Left - 1, SameKey, Keys#{Key => Same + 1}, [Run | Kept]);
        false -> best(Rest, Left, SameKey, Keys, Kept)
    end.

%% Lets go of the snapshots that those runs do not need.
released(Kept, #search{mod = Mod, live = Live} = Search) ->
    Needed = refs(Kept),
    lists:foreach(fun(Ref) -> Mod:release(Ref) end, maps:keys(maps:without(Needed, Live))),
    Search#search{live = maps:with(Needed, Live)}.

refs(Runs) -> lists:append([faultcheck_search_run:refs(Run) || Run <- Runs]).

%% ---- one run ------------------------------------------------------------------------------

run(_Sequence, _Parent, #search{runs = Runs, options = #{max_runs := Runs}} = Search) ->
    ended(not_found, Search#search.best, Search);
run(Sequence, Parent, #search{mod = Mod, options = Options, runs = Runs} = Search) ->
    Run = undisturbed(fun() -> faultcheck_search_run:new(Mod, Sequence, Parent, Options) end),
    #{outcome := Outcome, elapsed := Elapsed, simulated := Simulated} = Run,
    Next = Search#search{
        runs = Runs + 1,
        elapsed = Search#search.elapsed + Elapsed,
        simulated = Search#search.simulated + Simulated,
        best = best_of(Run, Search#search.best),
        live = maps:merge(Search#search.live, maps:from_list([{Ref, true} || Ref <- refs([Run])]))
    },
    faultcheck_progress:report(searching, fun() -> progress(Next) end),
    case Outcome of
        ok -> {going, Run, Next};
        _ -> ended(found, Run, Next)
    end.

%% What the system under test draws is not drawn from the search's random stream.
undisturbed(Fun) ->
    Random = rand:export_seed(),
    Result = Fun(),
    _ = rand:seed(Random),
    Result.

%% Without its snapshots.
best_of(#{value := Value} = Run, #{value := Before}) when Value < Before -> Run#{places := []};
best_of(Run, none) -> Run#{places := []};
best_of(_, Best) -> Best.

ended(Status, Run, #search{mod = Mod} = Search) ->
    #search{runs = Runs, elapsed = Elapsed, simulated = Simulated, populations = N} =
        released([], Search),
    Result = #{
        commands => maps:get(commands, Run),
        side => maps:get(side, Run),
        outcome => maps:get(outcome, Run),
        value => maps:get(value, Run),
        key => maps:get(key, Run),
        runs => Runs,
        elapsed => Elapsed,
        simulated => Simulated,
        populations => N,
        snapshots => faultcheck_model:has_snapshots(faultcheck_model:info(Mod))
    },
    {Status, Result}.

progress(#search{runs = Runs, options = #{max_runs := Most}, best = #{value := Value}}) ->
    #{runs => Runs, most => Most, nearest => Value}.

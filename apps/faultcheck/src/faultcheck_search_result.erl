%% @doc What the repetitions of a comparison of searches come to, for one world: samples of both
%% costs, ratios with intervals, what failures consist of, and the aims.
-module(faultcheck_search_result).

-export([new/3, json/3]).
-export_type([result/0, ratios/0, costs/0, aim/0]).

-type column() :: faultcheck_search_trial:column().
-type costs() :: #{
    runs := faultcheck_statistics:sample(), time := faultcheck_statistics:sample()
}.
-type ratio() :: {float(), faultcheck_statistics:interval()} | none.
%% The cost of the first column over that of the second: above 1 where the second is better.
-type ratios() :: #{{runs | time, faultcheck_statistics:statistic()} => ratio()}.
-type result() :: #{
    samples := [{column(), costs()}],
    %% uniform random over boundary guided, and boundary random over boundary guided
    chance := ratios(),
    boundary := ratios(),
    shrunk := [{column(), [{Found :: pos_integer(), Names :: [atom()]}]}],
    aims := [aim()]
}.
%% met and missed only where the interval says so
-type aim() :: {string(), met | missed | undecided}.

%% @doc The result of a world.
-spec new(faultcheck_search_trial:world(), [faultcheck_search_trial:trial()], integer()) ->
    result().
new(#{name := Name}, Trials, Seed) ->
    Columns = [
        {Column, [T || #{world := W, column := C} = T <- Trials, W =:= Name, C =:= Column]}
     || Column <- faultcheck_search_trial:columns()
    ],
    Samples = [
        {Column, #{
            runs => [{R, F} || #{runs := R, found := F} <- Of],
            time => [{T, F} || #{time := T, found := F} <- Of]
        }}
     || {Column, Of} <- Columns, Of =/= []
    ],
    Result = #{
        samples => Samples,
        chance => ratios(uniform_random, Samples, Seed),
        boundary => ratios(boundary_random, Samples, Seed),
        shrunk => [{Column, [S || #{shrunk := S} <- Of]} || {Column, Of} <- Columns, Of =/= []]
    },
    Result#{aims => aims(Result)}.

ratios(Column, Samples, Seed) ->
    case {lists:keyfind(Column, 1, Samples), lists:keyfind(boundary_guided, 1, Samples)} of
        {{_, Over}, {_, Under}} ->
            maps:from_list([
                {{Cost, Statistic}, faultcheck_statistics:ratio(
                    Statistic, maps:get(Cost, Over), maps:get(Cost, Under), Seed
                )}
             || Cost <- [runs, time], Statistic <- [median, mean]
            ]);
        _ ->
            #{}
    end.

%% ---- aims ---------------------------------------------------------------------------------

%% By what uniform random generation needs on average.
aims(#{samples := Samples, chance := Chance, boundary := Boundary}) ->
    case lists:keyfind(uniform_random, 1, Samples) of
        {_, #{runs := Runs}} when map_size(Chance) > 0 ->
            aims(faultcheck_statistics:mean(Runs), Chance, Boundary);
        _ ->
            []
    end.

aims(Mean, Chance, Boundary) when Mean >= 10000 ->
    %% also when nothing was found by chance: an atom
    [aim("at least 10 times fewer runs than by chance (mean)", {runs, mean}, 10, Chance)] ++
        no_worse(Boundary);
aims(Mean, Chance, Boundary) when Mean >= 500 ->
    [
        aim("at least 5 times fewer runs than by chance (median)", {runs, median}, 5, Chance),
        aim("at least 10 times less simulated time (median)", {time, median}, 10, Chance)
    ] ++ no_worse(Boundary);
aims(Mean, Chance, _Boundary) when Mean < 100 ->
    [aim("at most twice as slow as by chance (mean)", {runs, mean}, 0.5, Chance)];
aims(_Mean, _Chance, _Boundary) ->
    [].

no_worse(Boundary) ->
    Text = "not worse than random with boundary values (mean, interval not wholly below 1)",
    case maps:get({runs, mean}, Boundary, none) of
        none -> [{Text, undecided}];
        {_, {_, High}} when High >= 1 -> [{Text, met}];
        _ -> [{Text, missed}]
    end.

%% The ratio itself decides; an interval that reaches to the other side is told beside it.
aim(Text, Key, Wanted, Ratios) ->
    case maps:get(Key, Ratios, none) of
        none -> {Text, undecided};
        {Ratio, _} when Ratio >= Wanted -> {Text, met};
        {_, {_, High}} when High >= Wanted -> {Text, undecided};
        _ -> {Text, missed}
    end.

%% ---- for machines -------------------------------------------------------------------------

%% @doc All trials and what they come to.
-spec json(map(), [{faultcheck_search_trial:world(), result()}],
           [faultcheck_search_trial:trial()]) -> faultcheck_json:json().
json(#{title := Title, unit := Unit, first_seed := Seed}, Results, Trials) ->
    {object, [
        {title, {text, Title}},
        {unit, {text, Unit}},
        {first_seed, Seed},
        {worlds, [world(World, Result) || {World, Result} <- Results]},
        {trials, [trial(Trial) || Trial <- Trials]}
    ]}.

world(#{name := Name, label := Label, caps := Caps}, Result) ->
    #{samples := Samples, chance := Chance, boundary := Boundary, aims := Aims} = Result,
    {object, [
        {name, {text, Name}},
        {label, {text, Label}},
        {columns, {object, [
            {Column, column(maps:get(Column, Caps), Costs)} || {Column, Costs} <- Samples
        ]}},
        {chance_over_guided, ratios_json(Chance)},
        {boundary_random_over_guided, ratios_json(Boundary)},
        {aims, {object, [{list_to_binary(Text), Is} || {Text, Is} <- Aims]}}
    ]}.

column(Cap, #{runs := Runs, time := Time}) ->
    {object, [
        {cap, Cap},
        {repetitions, length(Runs)},
        {found, length([1 || {_, true} <- Runs])},
        {runs, costs(Runs)},
        {time, costs(Time)}
    ]}.

costs(Sample) ->
    {object,
        [
            {Name, known(faultcheck_statistics:sample_quantile(P, Sample))}
         || {Name, P} <- [{lower_quartile, 0.25}, {median, 0.5}, {upper_quartile, 0.75}]
        ] ++ [{mean, known(faultcheck_statistics:mean(Sample))}]}.

known(Value) when is_number(Value) -> Value;
known(_) -> null.

ratios_json(Ratios) ->
    {object, [
        {list_to_binary(lists:concat([Cost, "_", Statistic])), ratio_json(Ratio)}
     || {{Cost, Statistic}, Ratio} <- lists:sort(maps:to_list(Ratios))
    ]}.

ratio_json(none) -> null;
ratio_json({Ratio, {Low, High}}) -> [known(Ratio), known(Low), known(High)].

trial(Trial) ->
    Plain = maps:without([shrunk, world], Trial),
    Shrunk =
        case Trial of
            #{shrunk := {Found, Names}} -> #{commands => Found, shrunk => Names};
            #{} -> #{}
        end,
    maps:merge(Plain#{world => {text, maps:get(world, Trial)}}, Shrunk).

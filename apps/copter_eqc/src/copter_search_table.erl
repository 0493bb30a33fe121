%% @doc The results of copter_search_report as a page and as JSON.
%%
%% A search that ended at its cap found nothing: it is censored. Medians count it as longer than
%% any that found something; the mean is all runs of a column by its collisions, as of a geometric
%% distribution. Intervals of ratios are the middle 95 % of 2000 resampled sets of repetitions.
-module(copter_search_table).

-export([write/2, compared/3]).
-export_type([comparison/0]).

-type trial() :: #{found := boolean(), runs := pos_integer(), simulated_s := float()}.
%% How many times less the second takes, with the interval; unknown where too much is censored.
-type comparison() :: {float(), Low :: float(), High :: float()} | unknown.

-define(RESAMPLES, 2000).

%% @doc Writes search.md and search.json into a directory.
-spec write(file:filename(), copter_search_report:results()) -> ok.
write(Dir, #{settings := Settings} = Results) ->
    #{worlds := Worlds, seed := Seed, bias := Bias} = Settings,
    Text = [
        "# Guided search against chance\n\n",
        io_lib:format(
            "Made by `make search-report`; docs/copter.md and docs/search.md explain it. Seeds ~b\n"
            "and up, tests of ~b s, boundary bias ~.1f.\n\n",
            [Seed + 1, maps:get(horizon_ms, Settings) div 1000, Bias]
        ),
        "## Runs to the first collision\n\n",
        "Median [quartiles]; in brackets the share that found none.\n\n",
        row(["world", "n", "cap", "random", "random, biased", "search", "search, biased"]),
        row(["---", "---:", "---:", "---:", "---:", "---:", "---:"]),
        [runs_row(World, Results) || World <- Worlds],
        "\n## How many times fewer than uniform random: search, biased\n\n",
        row(["world", "ratio of medians, runs", "ratio of means, runs",
             "ratio of means, simulated time"]),
        row(["---", "---:", "---:", "---:"]),
        [ratio_row(World, random, Results) || {World, _, _} <- Worlds],
        "\n## How many times fewer than biased random: search, biased\n\n",
        row(["world", "ratio of medians, runs", "ratio of means, runs",
             "ratio of means, simulated time"]),
        row(["---", "---:", "---:", "---:"]),
        [ratio_row(World, random_bias, Results) || {World, _, _} <- Worlds],
        "\n## The worlds\n\n",
        [
            io_lib:format("* ~s: ~s~s\n", [World, copter_options:label(Options), set(Options)])
         || {World, _, _} <- Worlds, Options <- [copter_options:world(World)]
        ],
        "\n## What the failures consist of\n\n",
        "Commands before and after shrinking; the copters are not counted.\n\n",
        [shrunk_line(World, Results) || {World, _, _} <- Worlds]
    ],
    ok = file:write_file(filename:join(Dir, "search.md"), Text),
    file:write_file(filename:join(Dir, "search.json"), faultcheck_json:pretty(json(Results))).

set(#{set := Set}) when map_size(Set) =:= 0 -> "";
set(#{set := Set}) ->
    [io_lib:format(", ~s ~w", [Name, Value]) || {Name, Value} <- lists:sort(maps:to_list(Set))].

row(Cells) -> ["| ", lists:join(" | ", Cells), " |\n"].

runs_row({World, N, Cap}, #{trials := Trials}) ->
    Columns = [random, random_bias, search, search_bias],
    row([
        atom_to_list(World), integer_to_list(N), integer_to_list(Cap)
        | [spread(maps:get({World, C}, Trials)) || C <- Columns]
    ]).

spread(Trials) ->
    Missed = length([T || #{found := false} = T <- Trials]),
    [Low, Median, High] = [quantile(P, Trials) || P <- [0.25, 0.5, 0.75]],
    [
        shown(Median), " [", shown(Low), ", ", shown(High), "]",
        [io_lib:format(" (~b %)", [round(100 * Missed / length(Trials))]) || Missed > 0]
    ].

shown(censored) -> "above cap";
shown(Number) -> integer_to_list(round(Number)).

%% Censored ones are longer than all others.
quantile(P, Trials) ->
    Found = [R || #{found := true, runs := R} <- Trials],
    Index = P * (length(Trials) - 1),
    case Index =< length(Found) - 1 of
        true -> copter_statistics:quantile(Index / max(1, length(Found) - 1), Found);
        false -> censored
    end.

ratio_row(World, Against, #{trials := Trials}) ->
    Base = maps:get({World, Against}, Trials),
    Search = maps:get({World, search_bias}, Trials),
    row([
        atom_to_list(World)
        | [ratio(compared(Measure, Base, Search)) || Measure <- [median, runs, time]]
    ]).

ratio(unknown) -> "not known";
ratio({Ratio, Low, High}) -> io_lib:format("~.1f [~.1f, ~.1f]", [Ratio, Low, High]).

%% @doc How many times less the second set of repetitions took.
-spec compared(median | runs | time, [trial(), ...], [trial(), ...]) -> comparison().
compared(Measure, Base, Other) ->
    case divided(measure(Measure, Base), measure(Measure, Other)) of
        unknown ->
            unknown;
        Ratio ->
            {Resampled, _} = lists:mapfoldl(
                fun(_, State0) ->
                    {A, State1} = resample(Base, State0),
                    {B, State2} = resample(Other, State1),
                    {divided(measure(Measure, A), measure(Measure, B)), State2}
                end,
                rand:seed_s(exsss, 1),
                lists:seq(1, ?RESAMPLES)
            ),
            case [R || R <- Resampled, R =/= unknown] of
                [] -> unknown;
                Known ->
                    Bound = fun(P) -> copter_statistics:quantile(P, Known) end,
                    {Ratio, Bound(0.025), Bound(0.975)}
            end
    end.

divided(A, B) when is_number(A), is_number(B), B > 0 -> A / B;
divided(_, _) -> unknown.

measure(median, Trials) ->
    quantile(0.5, Trials);
measure(What, Trials) ->
    Cost = fun
        (#{runs := Runs}) when What =:= runs -> Runs;
        (#{simulated_s := Seconds}) -> Seconds
    end,
    case length([T || #{found := true} = T <- Trials]) of
        0 -> censored;
        Found -> lists:sum([Cost(T) || T <- Trials]) / Found
    end.

resample(Trials, State) ->
    Array = list_to_tuple(Trials),
    lists:mapfoldl(
        fun(_, S0) ->
            {I, S1} = rand:uniform_s(tuple_size(Array), S0),
            {element(I, Array), S1}
        end,
        State,
        Trials
    ).

shrunk_line(World, #{shrunk := Shrunk}) ->
    [
        io_lib:format("* ~s: ~b to ~s\n", [World, Before, words(After)])
     || {Before, After} <- maps:get(World, Shrunk, [])
    ].

words(Names) ->
    Counted = maps:to_list(lists:foldl(
        fun(Name, Counts) -> maps:update_with(Name, fun(N) -> N + 1 end, 1, Counts) end,
        #{},
        [N || N <- Names, N =/= add_copter]
    )),
    io_lib:format("~b: ~s", [
        lists:sum([N || {_, N} <- Counted]),
        lists:join(", ", [io_lib:format("~b ~s", [N, Name]) || {Name, N} <- lists:sort(Counted)])
    ]).

json(#{settings := Settings, trials := Trials}) ->
    #{
        settings => maps:map(fun plain/2, maps:without([progress, workers], Settings)),
        trials => [
            #{world => World, column => Column, trials => All}
         || {{World, Column}, All} <- lists:sort(maps:to_list(Trials))
        ]
    }.

plain(worlds, Worlds) -> [#{world => W, repetitions => N, cap => C} || {W, N, C} <- Worlds];
plain(_, Value) -> Value.

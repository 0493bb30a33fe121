%% @doc A comparison of searches in words and tables (Markdown).
-module(faultcheck_search_text).

-export([report/2, column/1]).

-type results() :: [{faultcheck_search_trial:world(), faultcheck_search_result:result()}].

%% @doc The name of a column.
-spec column(faultcheck_search_trial:column()) -> string().
column(uniform_random) -> "uniform random";
column(boundary_random) -> "boundary random";
column(uniform_guided) -> "guided, uniform";
column(boundary_guided) -> "guided, boundary".

%% @doc The whole report.
-spec report(map(), results()) -> unicode:chardata().
report(#{title := Title, unit := Unit, first_seed := Seed}, Results) ->
    [
        "# ", Title, "\n\n", introduction(Unit, Seed), overview(Results),
        [world(World, Result) || {World, Result} <- Results]
    ].

introduction(Unit, Seed) ->
    io_lib:format(
        "Cost until the first failure, in runs that were begun and in simulated time. Unit of\n"
        "both: ~ts; simulated time counts a prefix that was restored from a snapshot as nothing.\n"
        "Four columns: uniform and boundary-biased values (each component + or - its limit with\n"
        "probability 0.9), random and guided (docs/search.md). The number of repetitions was\n"
        "fixed beforehand. Seeds: ~b + 100 000 W + 10 000 C + R for world W, column C (from 0)\n"
        "and repetition R (from 1).\n\n"
        "Repetitions that reach their cap without a failure are censored: a median that would\n"
        "depend on them is given as \"above\", a mean is all runs over all failures. Intervals\n"
        "are 95 %, by the percentile bootstrap (2000 resamples) for ratios, exact (Poisson) for\n"
        "few failures. Waiting times are nearly geometric: 40 repetitions give a ratio within a\n"
        "factor of about 2 only.\n\n",
        [Unit, Seed]
    ).

%% ---- all worlds ---------------------------------------------------------------------------

overview(Results) ->
    [
        "## Overview\n\n",
        "Median of runs [quartiles], then how many times more uniform random needs than guided\n",
        "with boundary values: ratio [interval].\n\n",
        ["| |", [[" ", column(C), " |"] || C <- faultcheck_search_trial:columns()]],
        " ratio of medians | ratio of means | of medians, time |\n",
        "|---|---:|---:|---:|---:|---:|---:|---:|\n",
        [overview_row(World, Result) || {World, Result} <- Results],
        "\n"
    ].

overview_row(#{name := Name}, #{samples := Samples, chance := Chance}) ->
    Cells = [
        case lists:keyfind(Column, 1, Samples) of
            {_, #{runs := Sample}} -> spread(Sample);
            false -> "-"
        end
     || Column <- faultcheck_search_trial:columns()
    ],
    Ratios = [ratio(Key, Chance) || Key <- [{runs, median}, {runs, mean}, {time, median}]],
    ["| ", Name, [[" | ", Cell] || Cell <- Cells ++ Ratios], " |\n"].

ratio(Key, Ratios) ->
    case maps:get(Key, Ratios, none) of
        none -> "-";
        {Ratio, {Low, High}} -> [number(Ratio), " [", number(Low), ", ", number(High), "]"]
    end.

%% ---- one world ----------------------------------------------------------------------------

world(#{name := Name, label := Label} = World, Result) ->
    #{samples := Samples, shrunk := Shrunk, aims := Aims} = Result,
    [
        io_lib:format("## ~ts\n\n~ts\n\n", [Name, Label]),
        "| | repetitions | cap | found | runs: median [quartiles] | mean | time: median [quartiles]"
        " | mean |\n",
        "|---|---:|---:|---:|---:|---:|---:|---:|\n",
        [column_row(Column, World, Costs) || {Column, Costs} <- Samples],
        "\n",
        [few(Column, Costs) || {Column, Costs} <- Samples],
        compared("Uniform random over guided with boundary values", maps:get(chance, Result)),
        compared("Boundary random over guided with boundary values", maps:get(boundary, Result)),
        failures(Shrunk),
        [io_lib:format("Aim: ~ts: ~s.\n\n", [Text, Is]) || {Text, Is} <- Aims],
        io_lib:format("![Runs to the first failure in ~ts](search/~ts.svg)\n\n", [Name, Name])
    ].

column_row(Column, #{caps := Caps}, #{runs := Runs, time := Time}) ->
    Found = length([1 || {_, true} <- Runs]),
    io_lib:format("| ~ts | ~b | ~b | ~b (~b % censored) | ~ts | ~ts | ~ts | ~ts |\n", [
        column(Column), length(Runs), maps:get(Column, Caps), Found,
        round(100 * (length(Runs) - Found) / length(Runs)),
        spread(Runs), mean(Runs), spread(Time), mean(Time)
    ]).

%% Where most repetitions were censored the number of events says more.
few(Column, #{runs := Runs}) ->
    Events = length([1 || {_, true} <- Runs]),
    case 2 * Events < length(Runs) of
        true ->
            All = lists:sum([Cost || {Cost, _} <- Runs]),
            {Low, High} = faultcheck_statistics:events(Events),
            io_lib:format(
                "~ts: ~b failures in ~b runs, so one in ~ts (95 %: ~ts to ~ts).\n\n",
                [column(Column), Events, All, each(All, Events), each(All, High), each(All, Low)]
            );
        false ->
            []
    end.

each(_All, Events) when Events == 0 -> "infinitely many";
each(All, Events) -> number(All / Events).

compared(_Text, Ratios) when map_size(Ratios) =:= 0 ->
    [];
compared(Text, Ratios) ->
    io_lib:format("~ts: runs ~ts (medians), ~ts (means); time ~ts, ~ts.\n\n", [
        Text | [ratio({Cost, S}, Ratios) || Cost <- [runs, time], S <- [median, mean]]
    ]).

failures(Shrunk) ->
    case [{Column, Of} || {Column, [_ | _] = Of} <- Shrunk] of
        [] -> [];
        Some -> ["Shrunk failures:\n\n", [[failure(C, F) || F <- Of] || {C, Of} <- Some], "\n"]
    end.

failure(Column, {Found, Names}) ->
    Counted = [
        io_lib:format("~b ~ts", [length([N || N <- Names, N =:= Name]), Name])
     || Name <- lists:usort(Names)
    ],
    io_lib:format("- ~ts: ~b commands, shrunk to ~b: ~ts\n", [
        column(Column), Found, length(Names), lists:join(", ", Counted)
    ]).

%% ---- numbers ------------------------------------------------------------------------------

spread(Sample) ->
    [Low, Middle, High] = [
        quantile(faultcheck_statistics:sample_quantile(P, Sample)) || P <- [0.25, 0.5, 0.75]
    ],
    [Middle, " [", Low, ", ", High, "]"].

quantile({above, Cost}) -> ["above ", number(Cost)];
quantile(Cost) -> number(Cost).

mean(Sample) ->
    case faultcheck_statistics:mean(Sample) of
        none -> "-";
        Mean -> number(Mean)
    end.

%% Three places are more than the data hold.
number(infinity) -> "infinity";
number(Value) when abs(Value) >= 100 -> integer_to_list(round(Value));
number(Value) when abs(Value) >= 10 -> io_lib:format("~.1f", [float(Value)]);
number(Value) -> io_lib:format("~.2f", [float(Value)]).

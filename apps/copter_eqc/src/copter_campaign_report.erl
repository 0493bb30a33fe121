%% @doc The campaign's results as a page with charts, and as JSON.
-module(copter_campaign_report).

-export([write/2]).

%% @doc Writes copter_campaign.md, copter_campaign.json and the charts into a directory.
-spec write(file:filename(), copter_campaign:results()) -> ok.
write(Dir, Results) ->
    Text = [
        "# What holds, and where it ends\n\n",
        "Made by `make copter-campaign`; docs/copter.md explains what is counted. Rates are\n"
        "tests with a collision, with 95 % intervals (Wilson).\n\n",
        free(Results),
        faults(Dir, Results),
        survival(Results),
        stored(Results)
    ],
    ok = file:write_file(filename:join(Dir, "copter_campaign.md"), Text),
    Json = faultcheck_json:pretty(json(Results)),
    file:write_file(filename:join(Dir, "copter_campaign.json"), Json).

%% ---- without faults -------------------------------------------------------------------------

free(#{settings := Settings, free := Rate, searches := Searches}) ->
    #{seed := Seed, search_runs := Most} = Settings,
    #{tests := Tests, collisions := Collisions, simulated_s := Simulated} = Rate,
    Found = [S || #{found := true} = S <- Searches],
    Runs = lists:sum([R || #{runs := R} <- Searches]),
    [
        "## Hardened, without faults, 4 copters in the reference world\n\n",
        io_lib:format(
            "* ~b random tests, seed ~b, ~.1f s simulated in the mean: ~b collisions, ~s.\n",
            [Tests, Seed, Simulated / Tests, Collisions, copter_statistics:rate(Collisions, Tests)]
        ),
        io_lib:format(
            "* ~b guided searches, seeds 1 to ~b, at most ~b runs each, ~b runs in all: "
            "~b found a collision~ts.\n\n",
            [length(Searches), length(Searches), Most, Runs, length(Found), seeds(Found)]
        )
    ].

seeds([]) -> "";
seeds(Found) -> [" (seeds ", lists:join(", ", [integer_to_list(S) || #{seed := S} <- Found]), ")"].

%% ---- each fault alone -----------------------------------------------------------------------

faults(Dir, #{settings := Settings, faults := Rates}) ->
    #{configurations := Configurations, fault_tests := Tests, seed := Seed} = Settings,
    [
        "## Each realistic fault alone\n\n",
        io_lib:format(
            "Reference world, 4 copters, at most 3 faults of the kind at a time, default ranges; "
            "~b tests a number, seed ~b.\n\n",
            [Tests, Seed]
        ),
        row(["fault" | [copter_configuration:title(C) || C <- Configurations]]),
        row(["---" | ["---:" || _ <- Configurations]]),
        [
            row([
                copter_fault:title(Kind)
                | [shown(maps:get({Kind, C}, Rates)) || C <- Configurations]
            ])
         || Kind <- copter_fault:kinds()
        ],
        row(["all together" | [shown(sum(C, Rates)) || C <- Configurations]]),
        "\n",
        chart(Dir, Configurations, Rates)
    ].

shown(#{collisions := Collisions, tests := Tests}) -> copter_statistics:rate(Collisions, Tests).

sum(Configuration, Rates) ->
    All = [Rate || {{_, C}, Rate} <- maps:to_list(Rates), C =:= Configuration],
    #{
        collisions => lists:sum([N || #{collisions := N} <- All]),
        tests => lists:sum([N || #{tests := N} <- All])
    }.

chart(Dir, Configurations, Rates) ->
    Bars = [
        {copter_configuration:title(C), 100 * Collisions / Tests}
     || C <- Configurations, #{collisions := Collisions, tests := Tests} <- [sum(C, Rates)]
    ],
    Svg = faultcheck_chart:bars(#{
        title => "Tests with a collision, one kind of fault at a time",
        x_label => "share of tests (%)",
        bars => Bars
    }),
    ok = file:write_file(filename:join([Dir, "copter_campaign", "faults.svg"]), Svg),
    "![Tests with a collision under each configuration](copter_campaign/faults.svg)\n\n".

%% ---- the envelope ---------------------------------------------------------------------------

survival(#{settings := #{survival_tests := Tests, crowd_tests := Crowd}, survival := Rates}) ->
    Keys = lists:sort(maps:keys(Rates)),
    Columns = lists:usort([{Faults, Ranges} || {_, _, _, Faults, Ranges} <- Keys]),
    Rows = lists:usort([{Place, Copters, C} || {C, Place, Copters, _, _} <- Keys]),
    [
        "## Survival by copters, faults and their intensity\n\n",
        io_lib:format(
            "Share of tests without a collision; ~b tests a number, ~b of the box for 200.\n\n",
            [Tests, Crowd]
        ),
        row(["place", "copters", "configuration" | [column(C) || C <- Columns]]),
        row(["---", "---:", "---" | ["---:" || _ <- Columns]]),
        [
            row([
                atom_to_list(Place), integer_to_list(Copters), copter_configuration:title(C)
                | [survived(maps:get({C, Place, Copters, F, R}, Rates)) || {F, R} <- Columns]
            ])
         || {Place, Copters, C} <- Rows
        ],
        "\n"
    ].

column({0, _}) -> "no faults";
column({Faults, default}) -> io_lib:format("at most ~b", [Faults]);
column({Faults, mild}) -> io_lib:format("at most ~b mild", [Faults]).

survived(#{collisions := Collisions, tests := Tests}) ->
    copter_statistics:rate(Tests - Collisions, Tests).

%% ---- stored counterexamples -----------------------------------------------------------------

stored(#{settings := #{configurations := Configurations}, stored := Stored}) ->
    [
        "## Stored counterexamples\n\n",
        "Each under every configuration: when it collides, or that it survives.\n\n",
        row(["counterexample" | [copter_configuration:title(C) || C <- Configurations]]),
        row(["---" | ["---" || _ <- Configurations]]),
        [row([Name | [outcome(R) || {_, R} <- Results]]) || {Name, Results} <- Stored]
    ].

outcome(safe) -> "survives";
outcome({collision, #{kind := Kind, t_us := Time}}) ->
    io_lib:format("~s at ~.2f s", [Kind, Time / 1.0e6]);
outcome({failed, _}) -> "not run".

row(Cells) -> ["| ", lists:join(" | ", Cells), " |\n"].

%% ---- JSON -----------------------------------------------------------------------------------

json(#{settings := Settings, free := Free, searches := Searches} = Results) ->
    #{faults := Faults, survival := Survival, stored := Stored} = Results,
    #{
        settings => maps:without([progress, workers], Settings),
        free => rate(Free),
        searches => Searches,
        faults => [
            maps:merge(rate(Rate), #{fault => Kind, configuration => C})
         || {{Kind, C}, Rate} <- lists:sort(maps:to_list(Faults))
        ],
        survival => [
            maps:merge(rate(Rate), #{
                configuration => C, place => Place, copters => N, faults => F, ranges => Ranges
            })
         || {{C, Place, N, F, Ranges}, Rate} <- lists:sort(maps:to_list(Survival))
        ],
        stored => [
            #{name => {text, Name}, configuration => C, survives => Result =:= safe}
         || {Name, All} <- Stored, {C, Result} <- All
        ]
    }.

rate(#{tests := Tests, collisions := Collisions} = Rate) ->
    {Low, High} = copter_statistics:wilson(Collisions, Tests),
    Rate#{rate => Collisions / Tests, low => Low, high => High}.

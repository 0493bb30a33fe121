%% @doc The experiments of Paper I, section 5, repeated: `make airbag-report'.
%%
%% Writes airbag.md and its charts. It goes on where it ended when it was interrupted: finished
%% chunks are kept in state files that name the code they belong to. Random tests run in this VM,
%% one after the other, because there is one airbag in an OS process; masks are enumerated by
%% several workers, through ports. What the airbag prints goes to standard output.
-module(airbag_report).

-export([main/1, run/2, settings/0]).
-export_type([settings/0]).

-type settings() :: #{
    seeds := pos_integer(),
    tests := pos_integer(),
    coverage_tests := pos_integer(),
    flips := 1..4,
    %% of random tests
    transport := nif | port,
    %% of the enumeration
    workers := pos_integer(),
    progress := fun((faultcheck_enumerate:progress()) -> term())
}.

%% @doc Writes the report into a directory and ends the VM.
-spec main([file:filename()]) -> no_return().
main([Dir]) -> faultcheck_written:halt("airbag-report", fun() -> run(Dir, settings()) end).

%% @doc What `make airbag-report' runs.
-spec settings() -> settings().
settings() ->
    #{
        seeds => 100,
        tests => 100000,
        coverage_tests => 2000,
        flips => 4,
        transport => nif,
        workers => min(2, erlang:system_info(schedulers_online)),
        progress => fun faultcheck_enumerate:print_progress/1
    }.

%% @doc Runs all experiments and writes the report.
-spec run(file:filename(), settings()) -> ok.
run(Dir, #{transport := Transport} = Settings) ->
    {ok, _} = application:ensure_all_started(c_bridge),
    Charts = filename:join(Dir, "airbag"),
    ok = filelib:ensure_dir(filename:join([Charts, "state", "x"])),
    Context = Settings#{charts => Charts, code => fingerprint()},
    ok = airbag_sut:default_transport(Transport),
    Random = [first_failures(Context), long_runs(Context), guided(Context)],
    ok = airbag_sut:default_transport(port),
    Complete = [exhaustive(Context), coverage(Context)],
    Text = [title(Settings), Random, Complete],
    ok = file:write_file(filename:join(Dir, "airbag.md"), Text),
    remove_states(Charts).

%% Results are kept only for the code that gave them.
fingerprint() ->
    Libraries = filelib:wildcard(filename:join(filename:dirname(airbag_sut:library()), "*.so")),
    Files = [element(2, {ok, _} = file:read_file(F)) || F <- lists:sort(Libraries)],
    Modules = [M:module_info(md5) || M <- [airbag_eqc, airbag_experiment, faultcheck_generator]],
    integer_to_list(erlang:phash2({Files, Modules}, 1 bsl 32), 16).

remove_states(Charts) ->
    State = filename:join(Charts, "state"),
    _ = [ok = file:delete(F) || F <- filelib:wildcard(filename:join(State, "*"))],
    file:del_dir(State).

enumeration(Name, #{progress := Progress, charts := Charts, code := Code}) ->
    #{
        name => {Name, Code},
        state_file => filename:join([Charts, "state", Code ++ "-" ++ Name]),
        progress => fun(P) -> Progress(P#{name := list_to_atom(Name)}) end,
        progress_ms => 5000
    }.

done({ok, Result}) -> Result;
done({error, Reason}) -> throw({enumeration, Reason}).

chart(Name, Svg, Alt, #{charts := Charts}) ->
    ok = file:write_file(filename:join(Charts, Name ++ ".svg"), Svg),
    io_lib:format("![~ts](airbag/~s.svg)\n\n", [Alt, Name]).

title(#{seeds := Seeds, tests := Tests}) ->
    io_lib:format(
        "# The airbag's experiments\n\n"
        "The experiments of Paper I (B. Vedder, licentiate thesis), section 5, repeated with ~b\n"
        "seeds and ~b tests. Faults are permanent, and at most four are armed at a time.\n\n",
        [Seeds, Tests]
    ).

%% ---- tests until the first failure ----------------------------------------------------------

first_failures(#{seeds := Seeds} = Context) ->
    Experiments = [
        {"byte-2", "byte, 2 needed", "about 1000 tests", #{generator => byte}},
        {"byte-1", "byte, 1 needed", "fewer than 50", #{generator => byte, needed => 1}},
        {"focused-2", "focused, 2 needed", "fewer than 50, most of the time", #{
            generator => focused
        }},
        {"byte-2-long", "byte, 2 needed, sizes to 100", "", #{max_size => 100}},
        {"byte-1-long", "byte, 1 needed, sizes to 100", "", #{needed => 1, max_size => 100}}
    ],
    Rows = [{Label, Paper, numbers(Name, Changes, Context)}
            || {Name, Label, Paper, Changes} <- Experiments],
    Curves = [{Label, curve(Numbers, Seeds)} || {Label, Paper, Numbers} <- Rows, Paper =/= ""],
    Svg = faultcheck_chart:steps(#{
        title => "Tests until the unprotected airbag fires without cause",
        x_label => "tests (logarithmic)",
        y_label => "share of seeds that failed (%)",
        x_scale => log,
        series => Curves
    }),
    [
        "## Without protection: tests until the first failure\n\n",
        "| generator | paper | median | quartiles | below 50 tests | seeds that failed |\n",
        "|---|---|---:|---:|---:|---:|\n",
        [first_row(Row) || Row <- Rows],
        "\nThe paper does not say how long its sequences were. Here they have 10.8 commands in\n",
        "the mean (sizes to 42, as PropEr's); longer ones fail sooner: the last two rows.\n\n",
        chart("first-failures", Svg, "Tests until the first failure", Context)
    ].

numbers(Name, Changes, #{seeds := Seeds} = Context) ->
    Airbag = airbag_options:new(Changes#{protection => plain}),
    Options = enumeration("first-" ++ Name, Context),
    Firsts = done(airbag_experiment:first_failures(Airbag, Seeds, Options)),
    [N || {_, N} <- Firsts, N =/= none].

first_row({Label, Paper, Numbers}) ->
    Quantile = fun(P) -> round(faultcheck_statistics:quantile(P, Numbers)) end,
    Below = 100 * length([N || N <- Numbers, N < 50]) / length(Numbers),
    io_lib:format("| ~s | ~s | ~b | ~b to ~b | ~.1f % | ~b |\n", [
        Label, Paper, Quantile(0.5), Quantile(0.25), Quantile(0.75), Below, length(Numbers)
    ]).

%% Share of the seeds that failed within so many tests.
curve(Numbers, Seeds) ->
    Sorted = lists:sort(Numbers),
    Shares = [100 * I / Seeds || I <- lists:seq(1, length(Sorted))],
    lists:zip(Sorted, Shares).

%% ---- many tests with protection -------------------------------------------------------------

long_runs(Context) ->
    Runs = [
        {Configuration, Generator, Flips, long_run(Configuration, Generator, Flips, Context)}
     || Configuration <- [thesis, recommended], Generator <- [byte, focused], Flips <- [4, 2]
    ],
    [
        "## With E2E profile 1: many tests\n\n",
        "The paper found no failure in 100 000 tests. This lists every failure found here.\n\n",
        "| configuration | generator | bit flips | tests | failures |\n",
        "|---|---|---|---:|---|\n",
        [long_row(Run) || Run <- Runs],
        "\n",
        distribution(lists:keyfind(thesis, 1, Runs), Context)
    ].

long_run(Configuration, Generator, Flips, #{tests := Tests} = Context) ->
    Airbag = airbag_options:new(#{
        configuration => Configuration, generator => Generator, max_flips => Flips
    }),
    Name = io_lib:format("e2e-~s-~s-~b", [Configuration, Generator, Flips]),
    done(airbag_experiment:long_run(Airbag, 1, Tests, enumeration(lists:flatten(Name), Context))).

long_row({Configuration, Generator, Flips, #{found := Found, done := Tests}}) ->
    io_lib:format("| ~s | ~s | at most ~b | ~b | ~s |\n", [
        Configuration, Generator, Flips, Tests, failures(Found)
    ]).

failures([]) -> "none";
failures(Found) -> lists:join("; ", [failure(F) || F <- Found]).

failure(#{test := Number, flips := Flips, commands := Commands}) ->
    {set, _, {call, _, Name, [Data | _]}} = lists:last(Commands),
    io_lib:format("test ~b: mask `~s`, ~s ~w", [
        Number, airbag_exhaustive:hex(airbag_exhaustive:mask(Flips)), Name, Data
    ]).

distribution({_, _, _, #{counts := Counts, done := Tests}}, Context) ->
    Of = fun(Kind) -> lists:sort([{K, N} || {{T, K}, N} <- maps:to_list(Counts), T =:= Kind]) end,
    Lengths = Of(length),
    Commands = lists:sum([N || {_, N} <- Of(command)]),
    Mean = Commands / max(1, Tests),
    Names = named(fun atom_to_list/1, Of(command)),
    Statuses = named(fun airbag_coverage:status/1, Of(status)),
    [
        "### What these tests are\n\n",
        io_lib:format(
            "The thesis configuration with the byte generator: ~b tests, ~.1f commands in the\n"
            "mean, ~.1f % of the tests arm at least one fault and ~.1f % arm four or more.\n\n",
            [Tests, Mean, share(Of(faults), 1), share(Of(faults), 4)]
        ),
        chart("commands", bars("Commands run", "share of commands (%)", Names),
            "Commands run", Context),
        chart("faults", histogram("Faults armed in a test", "faults", Of(faults)),
            "Faults armed", Context),
        chart("lengths", histogram("Lengths of the tests", "commands in a test", Lengths),
            "Lengths", Context),
        chart("statuses", bars("Results of E2E_P01Check", "share of checks (%)", Statuses),
            "Statuses reached", Context)
    ].

%% Per cent of the tests with a value of at least Least.
share(Counts, Least) ->
    100 * lists:sum([N || {K, N} <- Counts, K >= Least]) /
        max(1, lists:sum([N || {_, N} <- Counts])).

bars(Title, Label, Counts) ->
    Sum = lists:sum([N || {_, N} <- Counts]),
    Bars = lists:reverse(lists:keysort(2, [{Name, 100 * N / Sum} || {Name, N} <- Counts])),
    faultcheck_chart:bars(#{title => Title, x_label => Label, bars => Bars}).

named(Name, Counts) -> [{Name(K), N} || {K, N} <- Counts].

histogram(Title, Label, Counts) ->
    faultcheck_chart:histogram(#{
        title => Title, x_label => Label, y_label => "tests", counts => Counts
    }).

%% ---- guided search --------------------------------------------------------------------------

%% Seeds that no option was chosen on.
-define(FIRST_SEED, 1001).

guided(#{seeds := Seeds}) ->
    Rows = [
        {Label, Chance, searched(Objective, Count)}
     || {Label, Chance, Objective, Count} <- [
            {"the whole protected region", "22 750", region, Seeds},
            {"the value byte alone", "22 750", value, max(1, Seeds div 3)}
        ]
    ],
    ok = airbag_sut:stop(),
    [
        "## With E2E profile 1: guided by a distance\n\n",
        "Thesis configuration; a test is one of the five values, 0 to 4 flips in bytes 0 and 1\n",
        "that stay, and four messages. The search (docs/search.md) is told in how many bits what\n",
        "arrives differs from a packet that counts. By chance: mean of random tests. Seeds from\n",
        io_lib:format("~b on.\n\n", [?FIRST_SEED]),
        "| bits of | median of tests | quartiles | mean | found | by chance |\n",
        "|---|---:|---:|---:|---:|---:|\n",
        [searched_row(Row) || Row <- Rows],
        "\n"
    ].

searched(Objective, Count) ->
    [
        airbag_masks_eqc:search(#{seed => Seed, objective => Objective})
     || Seed <- lists:seq(?FIRST_SEED, ?FIRST_SEED + Count - 1)
    ].

searched_row({Label, Chance, Results}) ->
    Runs = [Runs || {found, #{runs := Runs}} <- Results],
    Quantile = fun(P) -> round(faultcheck_statistics:quantile(P, Runs)) end,
    io_lib:format("| ~s | ~b | ~b to ~b | ~b | ~b of ~b | ~s |\n", [
        Label, Quantile(0.5), Quantile(0.25), Quantile(0.75),
        round(lists:sum(Runs) / length(Runs)), length(Runs), length(Results), Chance
    ]).

%% ---- every mask -----------------------------------------------------------------------------

exhaustive(#{flips := Flips} = Context) ->
    Runs = [
        {"thesis, bytes 0 and 1", enumerate_masks(thesis, [0, 1], Flips, Context)},
        {"recommended, all 4 bytes", enumerate_masks(recommended, [0, 1, 2, 3], Flips, Context)}
    ],
    [
        "## Every corruption mask\n\n",
        "Random tests could not show that nothing is left to find; enumeration can. Each mask\n",
        "is a permanent corruption; [x,170] is sent four times, for every x but 85.\n",
        "Undetected: an altered packet was accepted. Able: it also turns some [x,170] into\n",
        "[85,170].\n\n",
        "| configuration | bits flipped | masks | undetected | able | fired |\n",
        "|---|---:|---:|---:|---:|---:|\n",
        [mask_rows(Label, Run) || {Label, Run} <- Runs],
        "\nMasks that fire the airbag:\n\n",
        "| configuration | x | mask (XOR of bytes 0 to 3) |\n|---|---:|---|\n",
        [found_row(Label, Found) || {Label, #{found := All}} <- Runs, Found <- All],
        "\n"
    ].

enumerate_masks(Configuration, Bytes, Flips, Context) ->
    Options = enumeration("masks-" ++ atom_to_list(Configuration), Context),
    Parallel = Options#{workers => maps:get(workers, Context)},
    done(airbag_exhaustive:run(Configuration, Bytes, Flips, Parallel)).

mask_rows(Label, Run) ->
    Columns = [airbag_exhaustive:table(C, Run) || C <- [masks, undetected, able, fired]],
    [Masks | _] = Columns,
    [
        ["| ", Label, [io_lib:format(" | ~b", [N]) || N <- [Flips | cells(Flips, Columns)]], " |\n"]
     || Flips <- lists:seq(0, length(Masks) - 1)
    ].

cells(Flips, Columns) -> [lists:nth(Flips + 1, Column) || Column <- Columns].

found_row(Label, {X, Mask}) ->
    io_lib:format("| ~s | ~b | `~s` |\n", [Label, X, airbag_exhaustive:hex(Mask)]).

%% ---- statuses per fault class ---------------------------------------------------------------

coverage(#{coverage_tests := Tests}) ->
    Rows = [
        {Class, Configuration, airbag_coverage:reached(Class, Configuration, Tests)}
     || Class <- airbag_coverage:classes(), Configuration <- [thesis, recommended]
    ],
    [
        "## Statuses that each class of faults reaches\n\n",
        io_lib:format("Checks with each result, in ~b tests a row. `make coverage`\n", [Tests]),
        "makes the line coverage of each class, as HTML.\n\n",
        airbag_coverage:table(Rows)
    ].

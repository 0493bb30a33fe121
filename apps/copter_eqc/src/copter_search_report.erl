%% @doc What guided search brings over chance in the worlds W1 to W9: `make search-report'.
%%
%% The comparison itself is faultcheck_search_report; here are the worlds, how often each column is
%% repeated and up to how many runs. The numbers are chosen to end within an hour on two cores.
%% Seeds are those of the report: no variant was chosen on them.
-module(copter_search_report).

-export([main/1, run/2, settings/0]).
-export_type([settings/0]).

-type settings() :: #{
    first_seed := non_neg_integer(),
    %% by world: repetitions of uniform random, boundary random, guided uniform, guided boundary;
    %% most runs in one by chance, and guided
    worlds := [
        {atom(), [non_neg_integer()], Random :: pos_integer(), Guided :: pos_integer()}
    ],
    horizon_ms := pos_integer(),
    workers := pos_integer(),
    progress := fun((faultcheck_enumerate:progress()) -> term())
}.

%% @doc Writes the report into a directory and ends the VM. A second word `short' asks for few
%% repetitions.
-spec main([file:filename()]) -> no_return().
main([Dir]) -> written(Dir, settings());
main([Dir, "short"]) -> written(Dir, short(settings())).

-spec written(file:filename(), settings()) -> no_return().
written(Dir, Settings) -> faultcheck_written:halt("search-report", fun() -> run(Dir, Settings) end).

%% @doc What `make search-report' runs.
-spec settings() -> settings().
settings() ->
    Forty = [40, 40, 40, 40],
    #{
        first_seed => 8000000,
        worlds => [
            {'W1', Forty, 20000, 5000},
            {'W2', Forty, 20000, 5000},
            {'W3', Forty, 20000, 5000},
            {'W4', Forty, 20000, 5000},
            {'W5', Forty, 20000, 5000},
            {'W6', Forty, 20000, 5000},
            {'W7', [10, 10, 10, 24], 40000, 6000},
            {'W8', Forty, 20000, 5000},
            {'W9', Forty, 20000, 5000}
        ],
        horizon_ms => 20000,
        workers => min(2, erlang:system_info(schedulers_online)),
        progress => fun faultcheck_enumerate:print_progress/1
    }.

%% A quarter of the repetitions, and the rare failures of W7 left out.
short(#{worlds := Worlds} = Settings) ->
    Settings#{
        worlds => [
            {Name, [N div 4 || N <- Repetitions], Random, Guided}
         || {Name, Repetitions, Random, Guided} <- Worlds, Name =/= 'W7'
        ]
    }.

%% @doc Runs all searches; writes search.md, search.json and a chart for each world.
-spec run(file:filename(), settings()) -> ok | {error, faultcheck_enumerate:reason()}.
run(Dir, #{worlds := Worlds, horizon_ms := Horizon, first_seed := Seed} = Settings) ->
    {ok, _} = application:ensure_all_started(c_bridge),
    Report = #{
        title => "Guided search against chance",
        unit => io_lib:format("simulations of ~b s", [Horizon div 1000]),
        first_seed => Seed,
        start => fun() -> ok end,
        stop => fun copter_sut:stop/0,
        code => copter_campaign:fingerprint()
    },
    faultcheck_search_report:run(
        Dir,
        [world(World, Horizon) || World <- Worlds],
        maps:merge(Report, maps:with([workers, progress], Settings))
    ).

world({Name, Repetitions, Random, Guided}, Horizon) ->
    Options = (copter_options:world(Name))#{horizon_ms := Horizon},
    Columns = faultcheck_search_trial:columns(),
    #{
        name => atom_to_list(Name),
        label => label(Options),
        model => copter_eqc,
        search => #{time => Horizon, begin_test => fun() -> copter_eqc:begin_test(Options) end},
        caps => maps:from_list(lists:zip(Columns, [Random, Random, Guided, Guided])),
        repetitions => maps:from_list(lists:zip(Columns, Repetitions))
    }.

label(#{set := Set} = Options) ->
    Changes = [io_lib:format(", ~s ~w", [Name, V]) || {Name, V} <- lists:sort(maps:to_list(Set))],
    lists:flatten([copter_options:label(Options), Changes, "."]).

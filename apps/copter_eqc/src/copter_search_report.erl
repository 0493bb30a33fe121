%% @doc What guided search brings over chance: `make search-report'.
%%
%% In each of the worlds W1 to W9 the first collision is looked for many times over, by fresh
%% sequences and by the guided search, with values drawn evenly and with a bias to the limits of
%% their ranges. What is compared are runs, and simulated time. Seeds are those of the report: no
%% variant was chosen on them. Interrupted, it goes on where it ended.
-module(copter_search_report).

-export([main/1, run/2, settings/0]).
-export_type([settings/0, results/0, column/0]).

-type column() :: random | random_bias | search | search_bias.
-type settings() :: #{
    %% the first seed
    seed := non_neg_integer(),
    %% by world: searches of each column, and runs of each at most
    worlds := [{atom(), Repetitions :: pos_integer(), Cap :: pos_integer()}],
    bias := float(),
    horizon_ms := pos_integer(),
    %% failures of each world that are shrunk
    shrunk := non_neg_integer(),
    workers := pos_integer(),
    progress := fun((faultcheck_enumerate:progress()) -> term())
}.
-type trial() :: #{found := boolean(), runs := pos_integer(), simulated_s := float()}.
-type results() :: #{
    settings := settings(),
    trials := #{{atom(), column()} => [trial()]},
    %% names of the commands before and after
    shrunk := #{atom() => [{Before :: pos_integer(), After :: [atom()]}]}
}.

%% @doc Writes the report into a directory and ends the VM.
-spec main([file:filename()]) -> no_return().
main([Dir]) ->
    try
        ok = run(Dir, settings()),
        halt(0)
    catch
        error:{cb, Reason} -> fail(cb_error:format(Reason));
        throw:{enumeration, Reason} -> fail(faultcheck_enumerate:format_error(Reason))
    end.

-spec fail(unicode:chardata()) -> no_return().
fail(Line) ->
    io:format(standard_error, "search-report: ~ts~n", [Line]),
    halt(3).

%% @doc What `make search-report' runs.
-spec settings() -> settings().
settings() ->
    #{
        seed => 900001,
        worlds => [
            {'W1', 40, 20000}, {'W2', 40, 5000}, {'W3', 30, 5000}, {'W4', 30, 5000},
            {'W5', 40, 5000}, {'W6', 40, 5000}, {'W7', 12, 20000}, {'W8', 40, 5000},
            {'W9', 40, 5000}
        ],
        bias => 0.9,
        horizon_ms => 20000,
        shrunk => 5,
        workers => min(2, erlang:system_info(schedulers_online)),
        progress => fun faultcheck_enumerate:print_progress/1
    }.

%% @doc Runs all searches; writes search.md and search.json.
-spec run(file:filename(), settings()) -> ok.
run(Dir, Settings) ->
    {ok, _} = application:ensure_all_started(c_bridge),
    State = filename:join([Dir, "search", "state"]),
    ok = filelib:ensure_dir(State),
    {Trials, Shrunk} = searched(State, Settings),
    ok = copter_search_table:write(Dir, #{
        settings => Settings, trials => Trials, shrunk => Shrunk
    }),
    ok = file:delete(State).

searched(State, #{worlds := Worlds, workers := Workers, progress := Progress} = Settings) ->
    Items = [
        {World, Column, Number, Cap}
     || {World, Repetitions, Cap} <- Worlds,
        Column <- columns(),
        Number <- lists:seq(1, Repetitions)
    ],
    Check = fun(Item, _) -> {#{}, [searched_once(Item, Settings)]} end,
    Options = #{
        name => {copter_campaign:fingerprint(), maps:without([workers, progress], Settings)},
        chunk => 1,
        state_file => State,
        workers => Workers,
        progress => fun(P) -> Progress(P#{name => searches}) end,
        progress_ms => 5000,
        stop => fun(_) -> copter_sut:stop() end
    },
    case faultcheck_enumerate:run(faultcheck_space:items(Items), Check, Options) of
        {ok, #{found := Found}} -> {trials(Found), shrunk(Found)};
        {error, Reason} -> throw({enumeration, Reason})
    end.

columns() -> [random, random_bias, search, search_bias].

trials(Found) ->
    maps:groups_from_list(
        fun({World, Column, _, _}) -> {World, Column} end, fun({_, _, T, _}) -> T end, Found
    ).

shrunk(Found) ->
    maps:groups_from_list(
        fun({World, _, _, _}) -> World end,
        fun({_, _, _, Shrunk}) -> Shrunk end,
        [F || {_, _, _, Shrunk} = F <- Found, Shrunk =/= none]
    ).

%% ---- one search -------------------------------------------------------------------------------

searched_once({World, Column, Number, Cap}, #{seed := First, shrunk := Shrunk} = Settings) ->
    #{horizon_ms := Horizon} = Settings,
    Options = (copter_options:world(World))#{horizon_ms := Horizon},
    ok = copter_options:use(Options),
    Begin = fun() -> ok = copter_eqc:begin_test(Options) end,
    {Status, #{runs := Runs, simulated := Simulated} = Result} =
        faultcheck_search:search(copter_eqc, (strategy(Column, Settings))#{
            seed => First + Number, time => Horizon, begin_test => Begin, max_runs => Cap
        }),
    Found = Status =:= found,
    Trial = #{found => Found, runs => Runs, simulated_s => Simulated / 1000},
    Smaller =
        case Found andalso Column =:= search_bias andalso Number =< Shrunk of
            true -> smaller(Options, Result);
            false -> none
        end,
    {World, Column, Trial, Smaller}.

strategy(random, _) -> #{strategy => random, bias => 0};
strategy(random_bias, #{bias := Bias}) -> #{strategy => random, bias => Bias};
strategy(search, _) -> #{strategy => evolution, bias => 0};
strategy(search_bias, #{bias := Bias}) -> #{strategy => evolution, bias => Bias}.

smaller(Options, #{commands := Commands, side := Side}) ->
    Run = fun(Candidate) ->
        ok = copter_eqc:begin_test(Options),
        {_, _, Outcome} = faultcheck_statem:run_commands(copter_eqc, Candidate),
        Outcome =/= ok
    end,
    true = Run(Commands),
    Given = {faultcheck_shrinker:options(#{max_ms => 10000}), faultcheck_run:failure(Commands)},
    Shrunk = shrink(faultcheck_shrinker:first(copter_eqc, Commands, Side, Given), Run),
    {length(Commands), [Name || {set, _, {call, _, Name, _}} <- Shrunk]}.

%% The shrinker hands out candidates and is told whether they still fail.
shrink({try_, Candidate, Continue, _}, Run) ->
    Commands = faultcheck_proper:clean(Candidate),
    case Run(Commands) of
        true ->
            #{kind := Kind} = faultcheck_run:failure(Commands),
            shrink(Continue({fails, Kind}), Run);
        false ->
            shrink(Continue(passes), Run)
    end;
shrink({done, #{shrunk := Shrunk}}, _) ->
    Shrunk.

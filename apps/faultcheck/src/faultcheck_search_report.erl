%% @doc Compares random generation and guided search, with and without boundary values, on any
%% models: search.md with charts, and search.json.
%%
%% The number of repetitions is fixed beforehand, so that short ones are not favoured; each has a
%% seed of its own. Repetitions are run by workers; each finished one is kept in a state file, and
%% an interrupted report goes on where it ended. The result does not depend on the workers.
-module(faultcheck_search_report).

-export([run/3]).
-export_type([settings/0]).

-type settings() :: #{
    title := string(),
    %% what the numbers count: "simulations of 20 s"
    unit := string(),
    %% seeds go from there; see faultcheck_search_trial:seed/3
    first_seed := non_neg_integer(),
    workers := pos_integer(),
    %% run in each worker, beforehand and at the end
    start := fun(() -> term()),
    stop := fun(() -> term()),
    %% what the results depend on beside the worlds: kept results of other code are not used
    code := term(),
    progress := fun((faultcheck_enumerate:progress()) -> term())
}.

%% Failures of each column that are shrunk.
-define(SHRUNK, 3).

%% @doc Runs what is left to run and writes the report into a directory.
-spec run(file:filename(), [faultcheck_search_trial:world()], settings()) ->
    ok | {error, faultcheck_enumerate:reason()}.
run(Dir, Worlds, Settings) ->
    State = filename:join([Dir, "search", "state"]),
    ok = filelib:ensure_dir(State),
    case trials(State, Worlds, Settings) of
        {ok, Trials} ->
            ok = written(Dir, Worlds, Trials, Settings),
            file:delete(State);
        {error, _} = Error ->
            Error
    end.

trials(State, Worlds, Settings) ->
    #{workers := Workers, start := Start, stop := Stop, progress := Progress} = Settings,
    Items = items(Worlds, Settings),
    Options = #{
        name => {search, erlang:phash2({Items, named(Worlds), code(Settings)}, 1 bsl 32)},
        workers => Workers,
        chunk => 1,
        state_file => State,
        start => fun() ->
            _ = Start(),
            Worlds
        end,
        stop => fun(_) -> Stop() end,
        progress => fun(P) -> Progress(P#{name := search}) end,
        progress_ms => 5000
    },
    case faultcheck_enumerate:run(faultcheck_space:items(Items), fun trial/2, Options) of
        {ok, #{found := Trials}} -> {ok, Trials};
        {error, _} = Error -> Error
    end.

%% Kept results are those of the same worlds and the same code.
named(Worlds) -> [maps:with([name, label, model, caps], World) || World <- Worlds].

code(#{code := Code}) ->
    Modules = [
        faultcheck_search, faultcheck_search_mutation, faultcheck_search_run,
        faultcheck_search_trial, faultcheck_search_options, faultcheck_perturb,
        faultcheck_generator, faultcheck_range
    ],
    {Code, [Module:module_info(md5) || Module <- Modules]}.

trial({Number, Task}, Worlds) ->
    {#{}, [faultcheck_search_trial:run(lists:nth(Number, Worlds), Task)]}.

%% First repetitions of all first: an early end leaves something of each.
items(Worlds, #{first_seed := Base}) ->
    Tasks = [
        {Repetition, {Number, task(Base, Number, Column, Repetition)}}
     || {Number, #{repetitions := Repetitions}} <- numbered(Worlds),
        Column <- faultcheck_search_trial:columns(),
        Repetition <- lists:seq(1, maps:get(Column, Repetitions, 0))
    ],
    [Task || {_, Task} <- lists:keysort(1, Tasks)].

task(Base, Number, Column, Repetition) ->
    Seed = faultcheck_search_trial:seed({Base, Number - 1}, Column, Repetition),
    {Column, Repetition, Seed, Repetition =< ?SHRUNK}.

numbered(List) -> lists:zip(lists:seq(1, length(List)), List).

%% ---- files --------------------------------------------------------------------------------

written(Dir, Worlds, Trials, Settings) ->
    Results = [
        {World, faultcheck_search_result:new(World, Trials, maps:get(first_seed, Settings))}
     || World <- Worlds
    ],
    Charts = [chart(World, Result) || {World, Result} <- Results],
    lists:foreach(
        fun({Name, Svg}) ->
            ok = file:write_file(filename:join([Dir, "search", Name ++ ".svg"]), Svg)
        end,
        Charts
    ),
    Text = faultcheck_search_text:report(Settings, Results),
    ok = file:write_file(filename:join(Dir, "search.md"), unicode:characters_to_binary(Text)),
    Json = faultcheck_search_result:json(Settings, Results, Trials),
    file:write_file(filename:join(Dir, "search.json"), faultcheck_json:pretty(Json)).

chart(#{name := Name, repetitions := Repetitions}, #{samples := Samples}) ->
    Series = [
        {faultcheck_search_text:column(Column), curve(Sample)}
     || {Column, #{runs := Sample}} <- Samples, maps:get(Column, Repetitions, 0) > 0
    ],
    Svg = faultcheck_chart:steps(#{
        title => Name ++ ": runs to the first failure",
        x_label => "runs (logarithmic)",
        y_label => "share of repetitions that found one (%)",
        x_scale => log,
        series => Series
    }),
    {Name, Svg}.

%% Ends at the largest cost of all, found or not.
curve(Sample) ->
    Found = lists:sort([Cost || {Cost, true} <- Sample]),
    Shares = [100 * I / length(Sample) || I <- lists:seq(1, length(Found))],
    Last = lists:max([Cost || {Cost, _} <- Sample]),
    [{1, 0} | lists:zip(Found, Shares)] ++ [{Last, lists:last([0 | Shares])}].

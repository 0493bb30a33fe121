%% @doc The options of a guided search: names, types, defaults. An unknown one is the caller's
%% error.
-module(faultcheck_search_options).

-export([new/1]).
-export_type([options/0]).

-type options() :: #{
    %% `evolution' (see faultcheck_search) or `random': fresh sequences only
    strategy := evolution | random,
    %% runs of the system under test, those that were begun included
    max_runs := pos_integer(),
    %% length of a sequence in simulated time (X_duration; without any, in commands), and most
    %% commands in one
    time := number(),
    max_commands := pos_integer(),
    %% boundary bias of the generators (faultcheck_range); undefined: that of the process. Where it
    %% is given, a share of the searches goes without
    bias := faultcheck_range:bias() | undefined,
    plain_share := float(),
    %% called before each run that starts at the beginning, and before the first generation
    begin_test := fun(() -> term()),
    %% fresh sequences at the start of a population, its size, children per batch
    fresh := pos_integer(),
    population := pos_integer(),
    children := pos_integer(),
    %% how often a child is a fresh sequence instead
    immigrants := float(),
    %% members with the same Key
    same_key := pos_integer(),
    %% children without an improvement of the best by `improvement' until a new population
    patience := pos_integer(),
    improvement := number(),
    %% of faultcheck_perturb
    scale := faultcheck_perturb:scale(),
    %% how often an edit is placed where the run came nearest to failing, and how long before that
    %% on average
    follow := float(),
    lookback := number(),
    %% how often new commands address those of Key
    address := float(),
    %% of a run, where the model has them; 0: none
    snapshots := non_neg_integer()
}.

%% @doc The defaults, changed by those given.
-spec new(map()) -> options().
new(Given) ->
    Defaults = defaults(),
    Unknown = maps:keys(maps:without([lookback | maps:keys(Defaults)], Given)),
    Unknown =:= [] orelse error({search_options, {unknown, Unknown}, {known, known(Defaults)}}),
    Options = maps:merge(Defaults, Given),
    Wrong = [{Key, Value} || {Key, Value} <- maps:to_list(Options), not valid(Key, Value)],
    Wrong =:= [] orelse error({search_options, {wrong, Wrong}}),
    %% 1.5 s of 20 s
    maps:merge(#{lookback => 0.075 * maps:get(time, Options)}, Options).

known(Defaults) -> lists:sort([lookback | maps:keys(Defaults)]).

defaults() ->
    #{
        strategy => evolution,
        max_runs => application:get_env(faultcheck, max_runs, 2000),
        time => 20,
        max_commands => 500,
        bias => undefined,
        plain_share => 0.1,
        begin_test => fun() -> ok end,
        fresh => 20,
        population => 5,
        children => 10,
        immigrants => 0.3,
        same_key => 2,
        patience => 60,
        improvement => 1.0e-4,
        scale => 0.3,
        follow => 0.7,
        address => 0.6,
        snapshots => 32
    }.

valid(strategy, V) -> V =:= evolution orelse V =:= random;
valid(Key, V) when Key =:= time; Key =:= lookback; Key =:= scale -> is_number(V) andalso V > 0;
valid(improvement, V) -> is_number(V) andalso V >= 0;
valid(bias, undefined) -> true;
valid(Key, V) when Key =:= bias; Key =:= plain_share; Key =:= follow; Key =:= address;
    Key =:= immigrants
->
    is_number(V) andalso V >= 0 andalso V =< 1;
valid(begin_test, V) -> is_function(V, 0);
valid(snapshots, V) -> is_integer(V) andalso V >= 0;
valid(_, V) -> is_integer(V) andalso V > 0.

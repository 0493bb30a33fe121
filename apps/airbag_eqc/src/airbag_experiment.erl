%% @doc The random experiments of Paper I: how many tests until the first failure, and what many
%% tests reach.
%%
%% Test i of a seed is the same whatever ran before it. Sizes go through 1..max_size again and
%% again, as in repeated runs of a hundred tests: with PropEr's 42 the mean length is about 10.8
%% commands.
-module(airbag_experiment).

-export([first_failures/3, long_run/4, in_state/2, test/3]).
-export_type([first_failures/0, long_run/0, failure/0]).

%% The number of the first failing test of each seed, or none within the limit; seeds in order.
-type first_failures() :: [{Seed :: pos_integer(), pos_integer() | none}].
-type failure() :: #{
    test := pos_integer(),
    flips := [{Byte :: 0..3, Bit :: 0..7}],
    commands := [faultcheck_generator:command()]
}.
%% counts: {command, Name}, {length, N}, {faults, N} (armed in one test), {status, Name}
-type long_run() :: #{
    counts := #{term() => integer()}, found := [failure()], atom() => term()
}.

-define(MOST_TESTS, 100000).

%% @doc For seeds 1..Seeds: tests until the first failure.
-spec first_failures(airbag_options:options(), pos_integer(), faultcheck_enumerate:options()) ->
    {ok, first_failures()} | {error, faultcheck_enumerate:reason()}.
first_failures(Airbag, Seeds, Options) ->
    Space = faultcheck_space:items(lists:seq(1, Seeds)),
    Check = fun(Seed, _) -> {#{}, [{Seed, first_failure(Airbag, Seed, 1)}]} end,
    case enumerate(first_failures, Airbag, Space, Check, Options#{chunk => 1}) of
        {ok, #{found := Found}} -> {ok, Found};
        {error, _} = Error -> Error
    end.

first_failure(_Airbag, _Seed, Number) when Number > ?MOST_TESTS ->
    none;
first_failure(Airbag, Seed, Number) ->
    case test(Airbag, Seed, Number) of
        {_, {_, _, ok}} -> first_failure(Airbag, Seed, Number + 1);
        _ -> Number
    end.

%% @doc Tests 1..Tests of one seed, all of them, with what they reached.
-spec long_run(
    airbag_options:options(), Seed :: pos_integer(), pos_integer(), faultcheck_enumerate:options()
) -> {ok, long_run()} | {error, faultcheck_enumerate:reason()}.
long_run(Airbag, Seed, Tests, Options) ->
    Space = faultcheck_space:items(lists:seq(1, Tests)),
    Check = fun(Number, _) -> reached(Number, test(Airbag, Seed, Number)) end,
    enumerate({long_run, Seed}, Airbag, Space, Check, maps:merge(#{chunk => 500}, Options)).

enumerate(What, Airbag, Space, Check, Options) ->
    faultcheck_enumerate:run(Space, Check, Options#{
        name => {What, Airbag, maps:get(name, Options, none)},
        start => fun() -> start(Airbag) end,
        stop => fun(_) -> stop() end
    }).

start(Airbag) ->
    ok = airbag_eqc:begin_test(Airbag),
    [_] = airbag_sut:calls([{airbag_clear_statuses, []}]),
    ok.

stop() -> airbag_sut:stop().

%% @doc Runs Fun with an airbag for test/3.
-spec in_state(airbag_options:options(), fun(() -> Result)) -> Result.
in_state(Airbag, Fun) ->
    ok = start(Airbag),
    try
        Fun()
    after
        stop()
    end.

%% @doc One test: its commands and how they ran.
-spec test(airbag_options:options(), pos_integer(), pos_integer()) ->
    {[faultcheck_generator:command()], faultcheck_statem:run()}.
test(Airbag, Seed, Number) ->
    ok = airbag_options:use(Airbag),
    Commands = commands(size_of(Number, Airbag), {Seed, Number, 0}),
    ok = airbag_sut:begin_test(Airbag),
    {Commands, faultcheck_statem:run_commands(airbag_eqc, Commands)}.

commands(Size, Seed) ->
    faultcheck_proper:with_state(Size, Seed, fun() ->
        {Commands, _} = faultcheck_generator:generate(airbag_eqc, Size),
        Commands
    end).

size_of(Number, #{max_size := Most}) -> (Number - 1) rem Most + 1.

%% ---- what a test reached --------------------------------------------------------------------

reached(Number, {Commands, {History, _State, Result} = Run}) ->
    Done = [Name || {set, _, {call, _, Name, _}} <- lists:sublist(Commands, length(History))],
    Armed = length([N || N <- Done, N =:= bit_flip orelse N =:= repetition]),
    Keys = [{length, length(Done)}, {faults, Armed} | [{command, Name} || Name <- Done]],
    Counts = lists:foldl(fun count/2, statuses(), Keys),
    {Counts, [failure(Number, Commands, Run) || Result =/= ok]}.

count(Key, Counts) -> maps:update_with(Key, fun(N) -> N + 1 end, 1, Counts).

%% Statuses of E2E_P01Check since the last test.
statuses() ->
    Seen = airbag_sut:value_of(airbag_seen),
    [_] = airbag_sut:calls([{airbag_clear_statuses, []}]),
    maps:from_list([{{status, Name}, N} || {Name, N} <- maps:to_list(Seen), N > 0]).

failure(Number, Commands, {History, _, _}) ->
    {State, _} = lists:last(History),
    #{
        test => Number,
        flips => lists:sort([{B, I} || {bitflip, B, I} <- airbag_eqc:armed_faults(State)]),
        commands => lists:sublist(Commands, length(History))
    }.

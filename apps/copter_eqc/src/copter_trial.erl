%% @doc One test of the model: from a seed and a number, or from commands; and what came of it.
%%
%% Test i of a seed is the same whatever ran before it. It is filled up to the simulated time that
%% the options ask for, so that tests can be compared, and counted by the second.
-module(copter_trial).

-export([commands/3, run/2, rerun/2, continue/1, ending/2, continued/1]).
-export_type([result/0, ending/0]).

-type command() :: faultcheck_generator:command().
%% Of a test: nothing, a collision, or that something else was wrong.
-type result() :: safe | {collision, copter_sut:collision()} | {failed, term()}.
%% Everything that one run has in common with another that must be equal.
-type ending() :: #{
    result := result(),
    t_us := non_neg_integer(),
    true := [{non_neg_integer(), binary()}],
    perceived := [{non_neg_integer(), binary()}]
}.

%% More commands than any test needs to fill its time.
-define(MOST_COMMANDS, 1000).
-define(SIZE, 42).

%% @doc The commands of a test.
-spec commands(copter_options:options(), Seed :: non_neg_integer(), Number :: pos_integer()) ->
    [command()].
commands(#{horizon_ms := Horizon} = Options, Seed, Number) ->
    ok = copter_options:use(Options),
    faultcheck_proper:with_state(?SIZE, {Seed, Number, 0}, fun() ->
        {Commands, _} = faultcheck_generator:fill(copter_eqc, [], #{}, Horizon, ?MOST_COMMANDS),
        Commands
    end).

%% @doc Runs commands from the start.
-spec run(copter_options:options(), [command()]) -> result().
run(Options, Commands) ->
    ok = copter_eqc:begin_test(Options),
    {History, _, Result} = faultcheck_statem:run_commands(copter_eqc, Commands),
    result(Result, History).

result(ok, _) ->
    safe;
result({postcondition, false}, History) ->
    case lists:last(History) of
        {_, {collision, _} = Collision} -> Collision;
        {_, Other} -> {failed, Other}
    end;
result(Other, _) ->
    {failed, Other}.

%% @doc Runs commands whatever their preconditions say, as a stored sequence under other options.
-spec rerun(copter_options:options(), [command()]) -> result().
rerun(Options, Commands) ->
    ok = copter_eqc:begin_test(Options),
    continue(Commands).

%% @doc The same from where the simulator is now.
-spec continue([command()]) -> result().
continue([]) ->
    safe;
continue([{set, _, {call, copter_eqc, Name, Args}} | Rest]) ->
    case apply(copter_eqc, Name, Args) of
        ok -> continue(Rest);
        {collision, _} = Collision -> Collision;
        Other -> {failed, Other}
    end.

%% @doc Reruns commands, and looks at everything afterwards.
-spec ending(copter_options:options(), [command()]) -> ending().
ending(Options, Commands) ->
    ok = copter_eqc:begin_test(Options),
    continued(Commands).

%% @doc The same from where the simulator is now.
-spec continued([command()]) -> ending().
continued(Commands) ->
    Result = continue(Commands),
    #{
        result => Result,
        t_us => copter_sut:time_us(),
        true => copter_sut:bits(true),
        perceived => copter_sut:bits(perceived)
    }.

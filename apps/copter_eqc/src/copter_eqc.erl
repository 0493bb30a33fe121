%% @doc The model of Paper III, section 4.1: however copters are steered, and whatever faults their
%% sensors and radios have, they must not collide.
%%
%% A sequence begins with the copters; then they are steered, faults are armed, and time passes.
%% Each copter's id is an argument, so removing one while shrinking leaves the names, probes and
%% random streams of the others as they were. Which world and how many of everything, says
%% copter_options.
-module(copter_eqc).
-include_lib("faultcheck/include/faultcheck.hrl").

%% PropEr 1.5 calls its property types opaque, though a plain boolean is one of them.
-dialyzer({[no_opaque, no_return], [safe/1, safe/3]}).

-export([safe/1, safe/3, begin_test/1, report/2, export/3, view/0]).
-export_type([tell/0]).

-type tell() :: fun(([faultcheck_statem:command()], faultcheck_statem:run()) -> ok).

-record(state, {
    options :: copter_options:options(),
    %% in the order of adding
    copters = [] :: [{non_neg_integer(), copter_world:place()}],
    faults = [] :: [copter_fault:place() | {named, all, term()}],
    previous = setting :: setting | steer | iterate | fault
}).

%% Above so many copters one command adds them all.
-define(MOST_ONE_BY_ONE, 20).
%% How often: steering 4, time 5, faults 1 in all.
-define(STEER, 4).
-define(ITERATE, 5).
%% m, an objective that means: nothing to come close to so far.
-define(NOTHING_NEAR, 1.0e6).

initial_state() ->
    #state{options = copter_options:current()}.

faults() ->
    [
        fault_misalignment, fault_air, fault_drift, fault_gain, fault_reflection, fault_anchor,
        fault_corruption, fault_loss, fault_delay, fault_repetition, fault_jump
    ].

%% What a guided search only moves.
setting() -> [add_copter, add_grid].

%% What only a person does is never generated.
%%
%% The number of copters is uniform over its range: after N of them, the chance of no further one
%% is 1 in as many as may still come, and one more.
weight(_, Command) when
    Command =:= fly_add; Command =:= fly_remove; Command =:= fly_command; Command =:= fly_set;
    Command =:= fly_inject; Command =:= fly_clear; Command =:= fly_wait
->
    0;
weight(#state{previous = setting} = S, add_copter) ->
    max(1, others(S) * (option(max_copters, S) - length(S#state.copters)));
weight(#state{previous = setting, copters = Copters} = S, Command) when Command =/= add_grid ->
    case length(Copters) < option(min_copters, S) andalso not grid(S) of
        true -> 0;
        false -> usual(Command, S)
    end;
%% Never twice running when generated; in a sequence that shrinks they may follow each other, so
%% that removing what stood between them leaves the time as it was.
weight(#state{previous = Command}, Command) ->
    0;
weight(S, Command) ->
    usual(Command, S).

usual(steer, S) -> ?STEER * fault_kinds(S);
usual(iterate, S) -> ?ITERATE * fault_kinds(S);
usual(_, _) -> 1.

others(S) ->
    Faults =
        case option(max_faults, S) of
            0 -> 0;
            _ -> length(option(faults, S))
        end,
    (?STEER + ?ITERATE) * fault_kinds(S) + Faults.

%% Commands that share the weight of the faults; fault_clear is one of them.
fault_kinds(S) -> length(option(faults, S)) + 1.

grid(S) -> option(max_copters, S) > ?MOST_ONE_BY_ONE.

%% ---- add_copter: one more copter, x and y in cm --------------------------------------------
add_copter_pre(#state{previous = Previous, copters = Copters} = S) ->
    Previous =:= setting andalso not grid(S) andalso length(Copters) < option(max_copters, S).
add_copter_args(S) ->
    {MinX, MinY, MaxX, MaxY} = copter_world:bounds(option(world, S)),
    ?SUCHTHAT([_, X, Y], [next_id(S), place(MinX, MaxX), place(MinY, MaxY)], free(X, Y, S)).
add_copter_pre(S, [Id, X, Y]) -> not known(Id, S) andalso free(X, Y, S).
add_copter(Id, X, Y) -> copter_sut:add_copter(Id, X / 100, Y / 100).
add_copter_next(#state{copters = Copters} = S, _, [Id, X, Y]) ->
    S#state{copters = Copters ++ [{Id, metres(X, Y)}]}.
add_copter_post(_S, _, Result) -> Result =:= ok.

%% ---- add_grid: many copters, 4 m apart but for half a metre ---------------------------------
add_grid_pre(#state{previous = Previous, copters = Copters} = S) ->
    Previous =:= setting andalso Copters =:= [] andalso grid(S).
add_grid_args(S) ->
    [
        faultcheck_range:int(option(min_copters, S), option(max_copters, S), unbiased("copters")),
        faultcheck_range:int(0, 16#FFFFFFFF, unbiased("seed"))
    ].
add_grid(N, Seed) ->
    lists:foreach(
        fun({Id, {X, Y}}) -> ok = copter_sut:add_copter(Id, X, Y) end,
        copter_world:grid(N, Seed)
    ).
add_grid_next(S, _, [N, Seed]) -> S#state{copters = copter_world:grid(N, Seed)}.
add_grid_post(_S, _, Result) -> Result =:= ok.

%% ---- steer: what the pilot wants from now on; tenths of degrees, and of degrees/s -----------
%% Limits are where copters become fast: they are worth a bias.
steer_pre(S) -> flying(S).
steer_args(S) ->
    {Tilt, Turn} = copter_pilot:limits(),
    Angle = faultcheck_range:int(-Tilt, Tilt, #{unit => "0.1 degree"}),
    [copter(S), Angle, Angle, faultcheck_range:int(-Turn, Turn, #{unit => "0.1 degree/s"})].
steer_pre(S, [Copter | _]) -> steer_pre(S) andalso known(Copter, S).
steer(Copter, RollAngle, PitchAngle, Turn) ->
    {Roll, Pitch, Yaw} = copter_pilot:command(RollAngle, PitchAngle, Turn),
    copter_sut:command(Copter, Roll, Pitch, Yaw).
steer_next(S, _, _) -> S#state{previous = steer}.
steer_post(_S, _, Result) -> Result =:= ok.

%% ---- iterate: time passes, ms; the only command that may find a collision -------------------
iterate_pre(S) -> flying(S).
iterate_args(_S) -> [faultcheck_range:int(100, 2000, unbiased("ms"))].
iterate(Ms) -> copter_sut:iterate(Ms).
iterate_next(S, _, _) -> S#state{previous = iterate}.
iterate_post(_S, _, Outcome) -> Outcome =:= ok.
iterate_duration([Ms]) -> Ms.

%% ---- the realistic faults: see copter_fault for their arguments -----------------------------
fault_misalignment_pre(S) -> may(misalignment, S).
fault_misalignment_args(S) -> on_copter(misalignment, S).
fault_misalignment_pre(S, Args) -> may(misalignment, Args, S).
fault_misalignment(Copter, Axis, Angle) -> arm(misalignment, [Copter, Axis, Angle]).
fault_misalignment_next(S, _, Args) -> armed(misalignment, Args, S).
fault_misalignment_post(_S, _, Result) -> Result =:= ok.

fault_air_pre(S) -> may(air, S).
fault_air_args(S) -> on_copter(air, S).
fault_air_pre(S, Args) -> may(air, Args, S).
fault_air(Copter, Axis, Angle, Hold, Window, Seed) ->
    arm(air, [Copter, Axis, Angle, Hold, Window, Seed]).
fault_air_next(S, _, Args) -> armed(air, Args, S).
fault_air_post(_S, _, Result) -> Result =:= ok.

fault_drift_pre(S) -> may(drift, S).
fault_drift_args(S) -> on_copter(drift, S).
fault_drift_pre(S, Args) -> may(drift, Args, S).
fault_drift(Copter, Axis, Rate) -> arm(drift, [Copter, Axis, Rate]).
fault_drift_next(S, _, Args) -> armed(drift, Args, S).
fault_drift_post(_S, _, Result) -> Result =:= ok.

fault_gain_pre(S) -> may(gain, S).
fault_gain_args(S) -> on_copter(gain, S).
fault_gain_pre(S, Args) -> may(gain, Args, S).
fault_gain(Copter, Axis, Factor) -> arm(gain, [Copter, Axis, Factor]).
fault_gain_next(S, _, Args) -> armed(gain, Args, S).
fault_gain_post(_S, _, Result) -> Result =:= ok.

fault_reflection_pre(S) -> may(reflection, S).
fault_reflection_args(S) -> on_copter(reflection, S).
fault_reflection_pre(S, Args) -> may(reflection, Args, S).
fault_reflection(Copter, Anchor, Most, When, Seed) ->
    arm(reflection, [Copter, Anchor, Most, When, Seed]).
fault_reflection_next(S, _, Args) -> armed(reflection, Args, S).
fault_reflection_post(_S, _, Result) -> Result =:= ok.

fault_anchor_pre(S) -> may(anchor, S).
fault_anchor_args(S) -> copter_fault:args(anchor, option(ranges, S), anchors(S)).
fault_anchor_pre(S, Args) -> may(anchor, Args, S).
fault_anchor(Anchor, Axis, Offset) -> arm(anchor, [Anchor, Axis, Offset]).
fault_anchor_next(S, _, Args) -> armed(anchor, Args, S).
fault_anchor_post(_S, _, Result) -> Result =:= ok.

fault_corruption_pre(S) -> may(corruption, S).
fault_corruption_args(S) -> on_copter(corruption, S).
fault_corruption_pre(S, Args) -> may(corruption, Args, S).
fault_corruption(Copter, Byte, Bit) -> arm(corruption, [Copter, Byte, Bit]).
fault_corruption_next(S, _, Args) -> armed(corruption, Args, S).
fault_corruption_post(_S, _, Result) -> Result =:= ok.

fault_loss_pre(S) -> may(loss, S).
fault_loss_args(S) -> on_copter(loss, S).
fault_loss_pre(S, Args) -> may(loss, Args, S).
fault_loss(Copter, HowMuch) -> arm(loss, [Copter, HowMuch]).
fault_loss_next(S, _, Args) -> armed(loss, Args, S).
fault_loss_post(_S, _, Result) -> Result =:= ok.

fault_delay_pre(S) -> may(delay, S).
fault_delay_args(S) -> on_copter(delay, S).
fault_delay_pre(S, Args) -> may(delay, Args, S).
fault_delay(Copter, Ms) -> arm(delay, [Copter, Ms]).
fault_delay_next(S, _, Args) -> armed(delay, Args, S).
fault_delay_post(_S, _, Result) -> Result =:= ok.

fault_repetition_pre(S) -> may(repetition, S).
fault_repetition_args(S) -> on_copter(repetition, S).
fault_repetition_pre(S, Args) -> may(repetition, Args, S).
fault_repetition(Copter, Times, Ms) -> arm(repetition, [Copter, Times, Ms]).
fault_repetition_next(S, _, Args) -> armed(repetition, Args, S).
fault_repetition_post(_S, _, Result) -> Result =:= ok.

fault_jump_pre(S) -> may(jump, S).
fault_jump_args(S) -> on_copter(jump, S).
fault_jump_pre(S, Args) -> may(jump, Args, S).
fault_jump(Copter, Axis, Offset) -> arm(jump, [Copter, Axis, Offset]).
fault_jump_next(S, _, Args) -> armed(jump, Args, S).
fault_jump_post(_S, _, Result) -> Result =:= ok.

%% ---- fault_clear: all faults end ------------------------------------------------------------
fault_clear_pre(#state{faults = Faults}) -> Faults =/= [].
fault_clear_args(_S) -> [].
fault_clear() -> copter_sut:clear_faults().
fault_clear_next(S, _, []) -> S#state{faults = [], previous = fault}.
fault_clear_post(_S, _, Result) -> Result =:= ok.

%% ---- flown by hand: what a person may do in the visualizer beside steering ------------------

%% A copter at rest, at any time: m, and degrees of yaw.
fly_add_args(S) -> [next_id(S), 0.0, 0.0, 0.0].
fly_add_pre(S, [Id, _, _, _]) -> not known(Id, S).
fly_add(Id, X, Y, Yaw) -> copter_sut:add_copter(Id, X, Y, Yaw).
fly_add_next(#state{copters = Copters} = S, _, [Id, X, Y, _]) ->
    S#state{copters = Copters ++ [{Id, {X, Y}}]}.
fly_add_post(_S, _, Result) -> Result =:= ok.

fly_remove_args(S) -> [copter(S)].
fly_remove_pre(S, [Id]) -> known(Id, S).
fly_remove(Id) -> copter_sut:remove_copter(Id).
fly_remove_next(#state{copters = Copters} = S, _, [Id]) ->
    S#state{copters = lists:keydelete(Id, 1, Copters)}.
fly_remove_post(_S, _, Result) -> Result =:= ok.

%% Commands of the simulator's own: -1..1.
fly_command_args(S) -> [copter(S), 0.0, 0.0, 0.0].
fly_command_pre(S, [Id | _]) -> known(Id, S).
fly_command(Id, Roll, Pitch, Yaw) -> copter_sut:command(Id, Roll, Pitch, Yaw).
fly_command_post(_S, _, Result) -> Result =:= ok.

%% A parameter or gain of all copters, or a gain of one.
fly_set_args(_S) -> [all, comfort_radius, 0.45].
fly_set_pre(S, [Id, _, _]) -> Id =:= all orelse known(Id, S).
fly_set(all, Name, Value) -> copter_sut:set(Name, Value);
fly_set(Id, Name, Value) -> copter_sut:set(Id, Name, Value).
fly_set_post(_S, _, Result) -> Result =:= ok.

%% Any fault of libfaultcheck: where, the names of its model and parameters, when.
fly_inject_args(_S) -> [{probe, <<"PxId0">>}, <<"offset">>, [{<<"value">>, 0.0}], [], none].
fly_inject(Where, Model, Parameters, Trigger, Seed) ->
    copter_sut:arm_named(Where, Model, Parameters, Trigger, Seed).
fly_inject_next(#state{faults = Faults} = S, _, [Where, Model | _]) ->
    S#state{faults = Faults ++ [{named, all, {Where, Model}}]}.
fly_inject_post(_S, _, Result) -> Result =:= ok.

%% Time in which nobody flies, ms.
fly_wait_args(_S) -> [100].
fly_wait(Ms) -> copter_sut:iterate(Ms).
fly_wait_post(_S, _, Outcome) -> Outcome =:= ok.
fly_wait_duration([Ms]) -> Ms.

%% The faults of one place end.
fly_clear_args(_S) -> [{probe, <<"PxId0">>}].
fly_clear(Where) -> copter_sut:clear_faults(Where).
fly_clear_post(_S, _, Result) -> Result =:= ok.

%% ---- what a guided search asks for ----------------------------------------------------------

%% Metres of room left; the time of the simulator is in us, that of the commands in ms.
objective(_S) ->
    case copter_sut:closest() of
        #{value := inf} -> {?NOTHING_NEAR, {time, 0}, none};
        #{value := Value, t_us := Time, kind := Kind, ids := Ids} ->
            {Value, {time, Time / 1000}, {Kind, Ids}}
    end.

focus(#state{copters = Copters} = S, {Kind, [Id, Other]}) ->
    Wanted = [Id | [Other || Kind =:= copter]],
    case [Copter || {Known, _} = Copter <- Copters, lists:member(Known, Wanted)] of
        [] -> S;
        Involved -> S#state{copters = Involved}
    end;
focus(S, _) ->
    S.

%% A short manoeuvre of those involved.
insertion(S, Key) ->
    [
        {steer, steer_args(focus(S, Key))},
        {iterate, [faultcheck_range:int(100, 800, unbiased("ms"))]}
    ].

snapshot() -> copter_sut:snapshot().

restore(Snapshot) -> copter_sut:restore(Snapshot).

release(Snapshot) -> copter_sut:release(Snapshot).

%% ---- what the properties call ---------------------------------------------------------------

%% @doc Brings the simulator of these options into its state before the first command.
-spec begin_test(copter_options:options()) -> ok.
begin_test(Options) ->
    ok = copter_options:use(Options),
    copter_sut:begin_test(Options).

%% @doc The property: no sequence of commands makes copters collide.
-spec safe(copter_options:options()) -> proper:outer_test().
safe(Options) ->
    Tell = fun(Commands, Run) ->
        io:put_chars(faultcheck_statem:pretty(?MODULE, Commands, Run))
    end,
    safe(Options, Tell, #{}).

%% @doc The same, with what is to be told of a failure, and other limits for shrinking.
-spec safe(copter_options:options(), tell(), faultcheck_shrinker:options()) ->
    proper:outer_test().
safe(Options, Tell, Shrinking) ->
    %% Now, for report/2, and in the process of the tests.
    ok = copter_options:use(Options),
    ?SETUP(
        fun() ->
            ok = copter_options:use(Options),
            fun() -> ok end
        end,
        ?FORALL(Commands, more_commands(2, commands(?MODULE, Shrinking)), begin
            ok = copter_watch:test(Options, Commands),
            ok = begin_test(Options),
            {_, _, Result} = Run = run_commands(?MODULE, Commands),
            ?WHENFAIL(Tell(Commands, Run), aggregate(command_names(Commands), Result =:= ok))
        end)
    ).

%% @doc Adds to the folder of a stored case its scenario, for coptersim_run and make replay, and its
%% recording.
-spec report(faultcheck_case:'case'(), file:filename()) -> faultcheck_case:told().
report(Case, Dir) ->
    Settings = copter_sut:settings(copter_options:current()),
    Endings = copter_view:endings(Case, Settings),
    Scenario = copter_scenario:from_case(Case, Settings, Endings),
    ok = faultcheck_case:add_file(Dir, "scenario.json", faultcheck_json:pretty(Scenario)),
    View = copter_view:of_case(Case, shrunk, Settings, maps:get(shrunk, Endings)),
    case replay_recording:write({copter_view, View}, filename:join(Dir, "run.lcm")) of
        {ok, _} -> (replay_report:write(Dir))#{watch => true};
        {error, Line} -> error({recording, Line})
    end.

%% @doc The recording of a stored case for other programs.
-spec export(faultcheck_case:'case'(), file:filename(), faultcheck_export:what()) ->
    {ok, [file:filename()]} | {error, string()}.
export(_Case, Dir, What) -> replay_export:write(Dir, What).

%% @doc What shows cases of this model (replay_source).
-spec view() -> module().
view() -> copter_view.

%% ---- the model's own --------------------------------------------------------------------

option(Name, #state{options = Options}) -> maps:get(Name, Options).

flying(#state{copters = Copters}) -> Copters =/= [].

known(Id, #state{copters = Copters}) -> lists:keymember(Id, 1, Copters).

next_id(#state{copters = Copters}) -> lists:max([-1 | [Id || {Id, _} <- Copters]]) + 1.

copter(#state{copters = Copters}) -> oneof([Id || {Id, _} <- Copters]).

anchors(S) -> [Id || {Id, _, _, _} <- copter_world:anchors(option(world, S))].

place(Min, Max) -> faultcheck_range:int(round(100 * Min), round(100 * Max), unbiased("cm")).

unbiased(Unit) -> #{unit => Unit, boundary => false}.

free(X, Y, #state{copters = Copters} = S) ->
    copter_world:free(option(world, S), metres(X, Y), [Place || {_, Place} <- Copters]).

metres(X, Y) -> {X / 100, Y / 100}.

on_copter(Kind, S) ->
    [copter(S) | copter_fault:args(Kind, option(ranges, S), anchors(S))].

may(Kind, #state{faults = Faults} = S) ->
    flying(S) andalso
        length(Faults) < option(max_faults, S) andalso
        lists:member(Kind, option(faults, S)).

may(Kind, Args, #state{faults = Faults} = S) ->
    {_, Copter, _} = Place = copter_fault:place(Kind, Args),
    may(Kind, S) andalso
        (Copter =:= all orelse known(Copter, S)) andalso
        not lists:member(Place, Faults).

armed(Kind, Args, #state{faults = Faults} = S) ->
    S#state{faults = Faults ++ [copter_fault:place(Kind, Args)], previous = fault}.

arm(Kind, Args) -> copter_sut:arm(copter_fault:arming(Kind, Args, copter_sut:copters())).

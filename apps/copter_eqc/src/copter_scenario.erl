%% @doc A command sequence as a scenario, the file that coptersim_run reads (docs/coptersim.md).
%%
%% The scenario makes the same steps with the same numbers, so it ends as the sequence did, bit for
%% bit. Reals are written so that they read back as the same number.
-module(copter_scenario).

-export([from_commands/3, from_case/3]).

-define(US_PER_MS, 1000).
-define(NS_PER_US, 1000).

-type command() :: faultcheck_generator:command().

%% What has been told so far, newest events first.
-record(story, {
    dt_us :: pos_integer(),
    t_us = 0 :: non_neg_integer(),
    copters = [] :: [{non_neg_integer(), copter_world:place()}],
    events = [] :: [faultcheck_json:json()]
}).

%% @doc The scenario of a stored case: with its property, reasons, seed and versions.
-spec from_case(faultcheck_case:'case'(), [command()], copter_options:options()) ->
    faultcheck_json:json().
from_case(Case, Commands, Options) ->
    #{property := Property, reasons := Reasons, seed := Seed, versions := Versions} = Case,
    Origin = [
        {x_property, Property},
        {x_reasons, [{text, R} || R <- Reasons]},
        {x_seed, Seed},
        {x_versions, maps:map(fun(_, V) -> {text, V} end, Versions)}
    ],
    from_commands(Commands, Options, [{name, Property} | Origin]).

%% @doc The scenario of a sequence; Head are members that come first, `name' among them.
-spec from_commands([command()], copter_options:options(), [{atom(), faultcheck_json:json()}]) ->
    faultcheck_json:json().
from_commands(Commands, #{dt_us := Dt} = Options, Head) ->
    Calls = [{Name, Args} || {set, _, {call, _, Name, Args}} <- Commands],
    Story = lists:foldl(fun tell/2, #story{dt_us = Dt}, Calls),
    {object,
        [{format, <<"coptersim-scenario/1">>} | Head] ++
            settings(Options, Story) ++
            [
                {copters, [copter(C) || C <- lists:reverse(Story#story.copters)]},
                {events, lists:reverse(Story#story.events)}
            ]}.

settings(#{its_ms := Its, anchor_ms := Anchor, world := World} = Options, Story) ->
    #story{dt_us = Dt, t_us = Time} = Story,
    Values = maps:map(fun(_, V) -> float(V) end, copter_options:values(Options)),
    Gains = copter_configuration:gain_names(),
    [
        {dt_us, Dt},
        {duration_us, Time},
        {its_div, Its * ?US_PER_MS div Dt},
        {anchor_div, Anchor * ?US_PER_MS div Dt},
        {seed, 1},
        {gains, maps:with(Gains, Values)},
        {params, maps:map(fun whole/2, maps:without(Gains, Values))},
        {world,
            {object, [
                {lines, [line(L) || L <- copter_world:lines(World)]},
                {anchors, [anchor(A) || A <- copter_world:anchors(World)]}
            ]}}
    ].

%% Switches and choices are whole numbers.
whole(_, Value) when trunc(Value) == Value -> trunc(Value);
whole(_, Value) -> Value.

line({Id, {X1, Y1}, {X2, Y2}}) -> {object, [{id, Id}, {p1, [X1, Y1]}, {p2, [X2, Y2]}]}.

anchor({Id, X, Y, Z}) -> {object, [{id, Id}, {pos, [X, Y, Z]}]}.

copter({Id, {X, Y}}) -> {object, [{id, Id}, {pos, [X, Y]}]}.

tell({add_copter, [Id, X, Y]}, #story{copters = Copters} = Story) ->
    Story#story{copters = [{Id, {X / 100, Y / 100}} | Copters]};
tell({add_grid, [N, Seed]}, Story) ->
    Story#story{copters = lists:reverse(copter_world:grid(N, Seed))};
tell({iterate, [Ms]}, #story{dt_us = Dt, t_us = Time} = Story) ->
    Story#story{t_us = Time + Ms * ?US_PER_MS div Dt * Dt};
tell({steer, [Copter, RollAngle, PitchAngle, Turn]}, Story) ->
    {Roll, Pitch, Yaw} = copter_pilot:command(RollAngle, PitchAngle, Turn),
    event(command, [{copter, Copter}, {roll, Roll}, {pitch, Pitch}, {yaw, Yaw}], Story);
tell({fault_clear, []}, Story) ->
    event(clear_faults, [], Story);
tell({Command, Args}, #story{copters = Copters} = Story) ->
    Kind = list_to_existing_atom(string:prefix(atom_to_list(Command), "fault_")),
    Ids = [Id || {Id, _} <- Copters],
    lists:foldl(fun armed/2, Story, copter_fault:arming(Kind, Args, lists:sort(Ids))).

event(Type, Members, #story{t_us = Time, events = Events} = Story) ->
    Story#story{events = [{object, [{t_us, Time}, {type, Type} | Members]} | Events]}.

armed({Where, Fault, Seed}, Story) ->
    {Model, Trigger} = faultcheck_fault:normal(Fault),
    {Type, Place} =
        case Where of
            {probe, Probe} -> {fault, {probe, Probe}};
            {channel, Channel} -> {packet_fault, {channel, Channel}}
        end,
    Own = [{seed, Seed} || Seed =/= none],
    event(Type, [Place | model(Model)] ++ trigger(Trigger, Story) ++ Own, Story).

%% A probe of a position is called once a step.
trigger([], _) -> [];
trigger([{for, Calls}], #story{dt_us = Dt}) -> [{duration_us, Calls * Dt}];
trigger([{time, 0, For}], _) -> [{duration_us, For div ?NS_PER_US}];
trigger([{random, Share}], _) -> [{probability, Share}].

model({offset, Value}) -> [{model, offset}, {value, Value}];
model({amplification, Factor}) -> [{model, amplification}, {value, Factor}];
model({drift_timed, Rate, Limit}) -> [{model, drift_timed}, {rate, Rate}, {limit, Limit}];
model({random_offset, Low, High}) -> [{model, random_offset}, {low, Low}, {high, High}];
model({held_offset, Low, High, Ns}) ->
    [{model, held_offset}, {low, Low}, {high, High}, {ns, Ns}];
model({corruption, Byte, Bit}) -> [{model, corruption}, {byte, Byte}, {bit, Bit}];
model({drop, Packets}) -> [{model, drop}, {count, Packets}];
model(lose) -> [{model, lose}];
model({repeat, Times}) -> [{model, repeat}, {count, Times}];
model({delay, {ns, Ns}}) -> [{model, delay}, {ns, Ns}].

%% @doc A command sequence as a scenario, the file that coptersim_run reads (docs/coptersim.md).
%%
%% The scenario makes the same steps with the same numbers, so it ends as the sequence did, bit for
%% bit. Reals are written so that they read back as the same number.
-module(copter_scenario).

-export([from_commands/3, from_flight/3, from_case/3, fault/2]).

-define(US_PER_MS, 1000).
-define(NS_PER_US, 1000).

-type command() :: faultcheck_generator:command().

%% What has been told so far, newest events first.
-record(story, {
    dt_us :: pos_integer(),
    t_us = 0 :: non_neg_integer(),
    copters = [] :: [{non_neg_integer(), copter_world:place() | {float(), float(), float()}}],
    events = [] :: [faultcheck_json:json()]
}).

%% @doc The scenario of a stored case: with its property, reasons, seed and versions, and how its
%% sequences ended.
-spec from_case(faultcheck_case:'case'(), copter_sut:settings(), copter_view:endings()) ->
    faultcheck_json:json().
from_case(Case, Settings, Endings) ->
    #{property := Property, reasons := Reasons, seed := Seed, versions := Versions} = Case,
    {ok, Commands} = faultcheck_case:commands(maps:get(shrunk, Case)),
    Origin = [
        {x_property, Property},
        {x_reasons, [{text, R} || R <- Reasons]},
        {x_seed, Seed},
        {x_versions, maps:map(fun(_, V) -> {text, V} end, Versions)},
        {x_endings, maps:map(fun(_, Ending) -> {text, ending(Ending)} end, Endings)}
    ],
    from_flight(Commands, Settings, [{name, Property} | Origin]).

ending({failed, Text}) -> Text;
ending(passed) -> "passed".

%% @doc The scenario of a sequence; Head are members that come first, `name' among them.
-spec from_commands([command()], copter_options:options(), [{atom(), faultcheck_json:json()}]) ->
    faultcheck_json:json().
from_commands(Commands, Options, Head) ->
    from_flight(Commands, copter_sut:settings(Options), Head).

%% @doc The same from settings.
-spec from_flight([command()], copter_sut:settings(), [{atom(), faultcheck_json:json()}]) ->
    faultcheck_json:json().
from_flight(Commands, #{dt_us := Dt} = Settings, Head) ->
    Calls = [{Name, Args} || {set, _, {call, _, Name, Args}} <- Commands],
    Story = lists:foldl(fun tell/2, #story{dt_us = Dt}, Calls),
    {object,
        [{format, <<"coptersim-scenario/1">>} | Head] ++
            settings(Settings, Story) ++
            [
                {copters, [copter(C) || C <- lists:reverse(Story#story.copters)]},
                {events, lists:reverse(Story#story.events)}
            ]}.

settings(#{its_div := Its, anchor_div := Anchor, values := Given} = Settings, Story) ->
    #{lines := Lines, anchors := Anchors} = Settings,
    #story{dt_us = Dt, t_us = Time} = Story,
    Values = maps:map(fun value/2, Given),
    Gains = copter_configuration:gain_names(),
    [
        {dt_us, Dt},
        {duration_us, Time},
        {its_div, Its},
        {anchor_div, Anchor},
        {seed, 1},
        {gains, maps:with(Gains, Values)},
        {params, maps:map(fun whole/2, maps:without(Gains, Values))},
        {world,
            {object, [
                {lines, [line(L) || L <- Lines]},
                {anchors, [anchor(A) || A <- Anchors]}
            ]}}
    ].

value(_, Choice) when is_binary(Choice) -> Choice;
value(_, Value) -> float(Value).

%% Switches and choices are whole numbers.
whole(_, Choice) when is_binary(Choice) -> Choice;
whole(_, Value) when trunc(Value) == Value -> trunc(Value);
whole(_, Value) -> Value.

line({Id, {X1, Y1}, {X2, Y2}}) -> {object, [{id, Id}, {p1, [X1, Y1]}, {p2, [X2, Y2]}]}.

anchor({Id, X, Y, Z}) -> {object, [{id, Id}, {pos, [X, Y, Z]}]}.

copter({Id, Place}) -> {object, placed(Id, Place)}.

placed(Id, {X, Y}) -> [{id, Id}, {pos, [X, Y]}];
placed(Id, {X, Y, Yaw}) -> [{id, Id}, {pos, [X, Y]}, {yaw, Yaw}].

tell({add_copter, [Id, X, Y]}, #story{copters = Copters} = Story) ->
    Story#story{copters = [{Id, {X / 100, Y / 100}} | Copters]};
tell({add_grid, [N, Seed]}, Story) ->
    Story#story{copters = lists:reverse(copter_world:grid(N, Seed))};
tell({Name, [Ms]}, #story{dt_us = Dt, t_us = Time} = Story) when
    Name =:= iterate; Name =:= fly_wait
->
    Story#story{t_us = Time + Ms * ?US_PER_MS div Dt * Dt};
tell({steer, [Copter, RollAngle, PitchAngle, Turn]}, Story) ->
    {Roll, Pitch, Yaw} = copter_pilot:command(RollAngle, PitchAngle, Turn),
    event(command, [{copter, Copter}, {roll, Roll}, {pitch, Pitch}, {yaw, Yaw}], Story);
tell({fly_add, [Id, X, Y, Yaw]}, #story{t_us = 0, events = []} = Story) ->
    #story{copters = Copters} = Story,
    Story#story{copters = [{Id, {X, Y, Yaw}} | Copters]};
tell({fly_add, [Id, X, Y, Yaw]}, Story) ->
    event(add_copter, placed(Id, {X, Y, Yaw}), Story);
tell({fly_remove, [Id]}, Story) ->
    event(remove_copter, [{id, Id}], Story);
tell({fly_command, [Id, Roll, Pitch, Yaw]}, Story) ->
    event(command, [{copter, Id}, {roll, Roll}, {pitch, Pitch}, {yaw, Yaw}], Story);
tell({fly_set, [Id, Name, Value]}, Story) ->
    Of = [{copter, Id} || Id =/= all],
    case lists:member(Name, copter_configuration:gain_names()) of
        true -> event(gains, Of ++ [{Name, Value}], Story);
        false -> event(params, [{Name, Value}], Story)
    end;
tell({fly_inject, [{Kind, Place}, Model, Parameters, Trigger, Seed]}, Story) ->
    Type = maps:get(Kind, #{probe => fault, channel => packet_fault}),
    Own = [{seed, Seed} || Seed =/= none],
    Members = [{Kind, Place}, {model, Model}] ++ Parameters ++ trigger(Trigger, Story) ++ Own,
    event(Type, Members, Story);
tell({fly_clear, [{Kind, Place}]}, Story) ->
    event(clear_faults, [{Kind, Place}], Story);
tell({fault_clear, []}, Story) ->
    event(clear_faults, [], Story);
tell({Command, Args}, #story{copters = Copters} = Story) ->
    Kind = list_to_existing_atom(string:prefix(atom_to_list(Command), "fault_")),
    Ids = [Id || {Id, _} <- Copters],
    lists:foldl(fun armed/2, Story, copter_fault:arming(Kind, Args, lists:sort(Ids))).

%% @doc A fault by the names that scenarios use: its model, parameters and what its trigger says.
-spec fault(faultcheck_fault:fault(), Dt_us :: pos_integer()) -> [{atom(), term()}].
fault(Fault, Dt) ->
    {Model, Trigger} = faultcheck_fault:normal(Fault),
    model(Model) ++ trigger(Trigger, #story{dt_us = Dt}).

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

%% A probe of a position is called once a step. What a scenario has no words for has members that
%% coptersim_run refuses.
trigger(Trigger, Story) -> [condition(C, Story) || C <- Trigger, C =/= {time, 0, forever}].

condition({for, Calls}, #story{dt_us = Dt}) -> {duration_us, Calls * Dt};
condition({time, 0, For}, _) -> {duration_us, For div ?NS_PER_US};
condition({random, Share}, _) -> {probability, Share};
condition({time, Delay, _}, _) -> {delay_ns, Delay};
condition({from, Calls}, _) -> {from_calls, Calls}.

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

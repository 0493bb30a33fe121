%% @doc A command sequence as a scenario, the file that coptersim_run reads (docs/coptersim.md).
%%
%% The scenario makes the same steps with the same numbers, so it ends as the sequence did, bit for
%% bit. Reals are written so that they read back as the same number.
-module(copter_scenario).

-export([from_commands/3, from_case/3, from_plan/5, fault/3]).

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
        endings(Endings)
    ],
    from_flight(Commands, Settings, [{name, Property} | Origin]).

endings(Endings) -> {x_endings, maps:map(fun(_, E) -> {text, ending(E)} end, Endings)}.

ending({failed, Text}) -> Text;
ending(passed) -> "passed".

%% @doc The scenario of a sequence; Head are members that come first, `name' among them.
-spec from_commands([command()], copter_options:options(), [{atom(), faultcheck_json:json()}]) ->
    faultcheck_json:json().
from_commands(Commands, Options, Head) ->
    from_flight(Commands, copter_sut:settings(Options), Head).

from_flight(Commands, #{dt_us := Dt} = Settings, Head) ->
    Calls = [{Name, Args} || {set, _, {call, _, Name, Args}} <- Commands],
    scenario(lists:foldl(fun tell/2, #story{dt_us = Dt}, Calls), Settings, Head).

%% @doc The scenario of what was done in a flight up to a time, and how it ended then.
-spec from_plan(
    [copter_plan:planned()], End_us :: non_neg_integer(), copter_sut:settings(), Name :: string(),
    replay_source:ending()
) -> faultcheck_json:json().
from_plan(Planned, End, #{dt_us := Dt} = Settings, Name, Ending) ->
    Story = lists:foldl(
        fun({T, _, Call}, Story) -> tell(Call, Story#story{t_us = T}) end,
        #story{dt_us = Dt},
        [P || {_, _, {Command, _}} = P <- Planned, not copter_plan:is_time(Command)]
    ),
    Head = [{name, {text, Name}}, endings(#{shrunk => Ending})],
    scenario(Story#story{t_us = End}, Settings, Head).

scenario(Story, Settings, Head) ->
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
    When = trigger(Place, Trigger, Story#story.dt_us),
    event(Type, [{Kind, Place}, {model, Model} | parameters(Parameters)] ++ When ++ Own, Story);
tell({fly_clear, [{Kind, Place}]}, Story) ->
    event(clear_faults, [{Kind, Place}], Story);
tell({fault_clear, []}, Story) ->
    event(clear_faults, [], Story);
tell({Command, Args}, #story{copters = Copters} = Story) ->
    Kind = list_to_existing_atom(string:prefix(atom_to_list(Command), "fault_")),
    Ids = [Id || {Id, _} <- Copters],
    lists:foldl(fun armed/2, Story, copter_fault:arming(Kind, Args, lists:sort(Ids))).

%% Beside the other members, unless they have names of those.
parameters(Parameters) ->
    Members = [<<"t_us">>, <<"type">>, <<"probe">>, <<"channel">>, <<"model">>, <<"params">>,
               <<"duration_us">>, <<"delay_us">>, <<"from_calls">>, <<"for_calls">>,
               <<"probability">>, <<"seed">>],
    case [Name || {Name, _} <- Parameters, lists:member(Name, Members)] of
        [] -> Parameters;
        _ -> [{params, {object, Parameters}}]
    end.

%% @doc A fault by the names that scenarios use: its model, parameters and what its trigger says.
-spec fault(faultcheck_inject:where(), faultcheck_fault:fault(), Dt_us :: pos_integer()) ->
    [{atom(), term()}].
fault(Where, Fault, Dt) ->
    {Model, Trigger} = faultcheck_fault:normal(Fault),
    model(Model) ++ trigger(element(2, Where), Trigger, Dt).

event(Type, Members, #story{t_us = Time, events = Events} = Story) ->
    Story#story{events = [{object, [{t_us, Time}, {type, Type} | Members]} | Events]}.

armed({{Kind, Place} = Where, Fault, Seed}, Story) ->
    Type = maps:get(Kind, #{probe => fault, channel => packet_fault}),
    Own = [{seed, Seed} || Seed =/= none],
    event(Type, [{Kind, Place} | fault(Where, Fault, Story#story.dt_us)] ++ Own, Story).

%% A probe of a position is called once a step.
trigger(Place, Trigger, Dt) ->
    Counted = copter_view_params:is_position(Place) andalso not lists:keymember(from, 1, Trigger),
    lists:append([condition(C, Counted, Dt) || C <- Trigger]).

condition({for, Calls}, true, Dt) -> [{duration_us, Calls * Dt}];
condition({for, Calls}, false, _) -> [{for_calls, Calls}];
condition({from, Calls}, _, _) -> [{from_calls, Calls}];
condition({random, Share}, _, _) -> [{probability, Share}];
condition({time, Delay, For}, _, _) ->
    [{delay_us, Delay div ?NS_PER_US} || Delay > 0] ++
        [{duration_us, For div ?NS_PER_US} || For =/= forever].

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

%% @doc libfaultcheck compared, command by command, with the reference model faultcheck_ref.
%%
%% Each command does the same to the library and to the model; its postcondition is that both say
%% the same. A profile says which parts take part.
-module(faultcheck_eqc).
-include_lib("faultcheck/include/faultcheck.hrl").

%% PropEr 1.5 calls its property types opaque, though a plain boolean is one of them.
-dialyzer({[no_opaque, no_return], [agrees/1]}).

%% Bytes of a receiver's buffer that any packet fits into.
-define(ROOM, 64).

-export([agrees/1, profile/0]).
-export_type([profile/0]).

%% What the commands work on.
-type profile() ::
    probes | triggers | sensors | channels | communication | routing | everything.

-record(state, {
    profile :: profile(),
    contexts :: #{faultcheck_eqc_sut:context() => faultcheck_ref:context()},
    %% what snapshots hold
    saved = #{} :: #{{faultcheck_eqc_sut:context(), faultcheck_eqc_sut:slot()} =>
                         faultcheck_ref:context()}
}).

initial_state() ->
    #state{
        profile = profile(),
        contexts = #{a => faultcheck_ref:new(1), b => faultcheck_ref:new(1),
                     default => faultcheck_ref:new(1)}
    }.

%% @doc The profile in use.
-spec profile() -> profile().
profile() -> application:get_env(faultcheck_eqc, profile, everything).

use(Profile) -> application:set_env(faultcheck_eqc, profile, Profile).

faults() -> [add, legacy_add].

%% Traffic is what shows a fault; most faults get a trigger.
weight(_S, probe) -> 12;
weight(_S, put) -> 8;
weight(_S, get) -> 12;
weight(_S, add) -> 6;
weight(_S, trigger) -> 4;
weight(_S, legacy_add) -> 2;
weight(_S, legacy_trigger) -> 2;
weight(_S, legacy_probe) -> 2;
weight(_S, restore) -> 2;
weight(_S, _) -> 1.

%% ---- add: arm a fault -------------------------------------------------------------------------
add_args(S) ->
    ?LET(Place, place(S), [context(S), Place, model(S, Place)]).
add_pre(S, [Name, {Kind, _} = Place, Model]) ->
    allowed(Kind, S) andalso not second(Model, faultcheck_ref:faults(Place, context(Name, S)))
        andalso bounded(Place, Name, S).
add(Name, Place, Model) -> faultcheck_eqc_sut:add(Name, Place, Model).
add_next(S, Id, [Name, Place, Model]) ->
    with(Name, fun(C) -> element(2, faultcheck_ref:add(Place, Model, Id, C)) end, S).
add_post(S, [Name, Place, Model], Result) ->
    case faultcheck_ref:add(Place, Model, Result, context(Name, S)) of
        {'FC_OK', _} -> is_integer(Result) andalso Result > 0;
        {Code, _} -> Result =:= Code
    end.

%% A channel hands an altered copy to several receivers; the document does not say what two such
%% faults make of one packet.
second({asymmetric, _, _, _}, Faults) -> [a || #{model := {asymmetric, _, _, _}} <- Faults] =/= [];
second(_, _) -> false.

bounded(Place, Name, #state{profile = P} = S) ->
    Most = case P of triggers -> 2; routing -> 2; _ -> 4 end,
    length(faultcheck_ref:faults(Place, context(Name, S))) < Most.

%% ---- legacy_add: the same through the compatible interface ------------------------------------
legacy_add_args(S) ->
    ?LET({Kind, _} = Place, place(S), [Place, legacy_model(Kind)]).
legacy_add_pre(S, [{Kind, _} = Place, _]) -> allowed(Kind, S) andalso bounded(Place, default, S).
legacy_add(Place, Model) ->
    Before = faultcheck_eqc_sut:errors(default),
    ok = faultcheck_eqc_sut:legacy_add(Place, Model),
    case faultcheck_eqc_sut:errors(default) of
        Before -> faultcheck_eqc_sut:latest(default, Place);
        _ -> refused
    end.
legacy_add_next(S, Id, [Place, Model]) ->
    with(default, fun(C) -> element(2, faultcheck_ref:add(Place, legacy(Model), Id, C)) end, S).
legacy_add_post(S, [Place, Model], Result) ->
    case faultcheck_ref:add(Place, legacy(Model), Result, context(default, S)) of
        {'FC_OK', _} -> is_integer(Result) andalso Result > 0;
        {_, _} -> Result =:= refused
    end.

%% An int or a double has no bit above 63: refused when it is added (5.3).
legacy({bitflip, Bit}) when Bit > 63 -> {bitflip, -1};
legacy(Model) -> Model.

%% ---- trigger ----------------------------------------------------------------------------------
trigger_pre(S) -> armed(S) =/= [].
trigger_args(S) ->
    ?LET({Name, Id}, a_fault(S), [Name, Id, change(S)]).
trigger_pre(S, [Name, Id, _]) -> is_armed(Name, Id, S).
trigger(Name, Id, Change) -> faultcheck_eqc_sut:trigger(Name, Id, Change).
trigger_next(S, _, [Name, Id, Change]) ->
    with(Name, fun(C) -> element(2, faultcheck_ref:trigger(Id, Change, C)) end, S).
trigger_post(S, [Name, Id, Change], Result) ->
    Result =:= element(1, faultcheck_ref:trigger(Id, Change, context(Name, S))).

%% ---- legacy_trigger: on the latest fault of an identifier -------------------------------------
legacy_trigger_args(S) ->
    [place(S), {oneof([from, once, for]), oneof([0, 1, 2, 5])}].
legacy_trigger_pre(S, [{Kind, _}, _]) -> allowed(Kind, S).
legacy_trigger(Place, Change) -> faultcheck_eqc_sut:legacy_trigger(Place, Change).
legacy_trigger_next(S, _, [Place, Change]) ->
    with(default, fun(C) -> legacy_triggered(Place, Change, C) end, S).

legacy_triggered(Place, Change, C) ->
    case faultcheck_ref:latest(Place, C) of
        {ok, Id, _} -> element(2, faultcheck_ref:trigger(Id, Change, C));
        {'FC_E_NO_FAULT', Counted} -> Counted
    end.

%% ---- enable, remove: armed faults and one that there never was --------------------------------
enable_args(S) -> ?LET({Name, Id}, maybe_a_fault(S), [Name, Id, boolean()]).
enable_pre(S, [Name, Id, _]) -> is_known(Name, Id, S).
enable(Name, Id, Enabled) -> faultcheck_eqc_sut:enable(Name, Id, Enabled).
enable_next(S, _, [Name, Id, Enabled]) ->
    with(Name, fun(C) -> element(2, faultcheck_ref:enable(Id, Enabled, C)) end, S).
enable_post(S, [Name, Id, Enabled], Result) ->
    Result =:= element(1, faultcheck_ref:enable(Id, Enabled, context(Name, S))).

remove_args(S) -> ?LET({Name, Id}, maybe_a_fault(S), [Name, Id]).
remove_pre(S, [Name, Id]) -> is_known(Name, Id, S).
remove(Name, Id) -> faultcheck_eqc_sut:remove(Name, Id).
remove_next(S, _, [Name, Id]) ->
    with(Name, fun(C) -> element(2, faultcheck_ref:remove(Id, C)) end, S).
remove_post(S, [Name, Id], Result) ->
    Result =:= element(1, faultcheck_ref:remove(Id, context(Name, S))).

remove_all_args(S) -> [context(S), oneof([place(S), probes, channels])].
remove_all(Name, What) -> faultcheck_eqc_sut:remove_all(Name, What).
remove_all_next(S, _, [Name, What]) ->
    with(Name, fun(C) -> faultcheck_ref:remove_all(What, C) end, S).

latest_args(S) -> [context(S), place(S)].
latest(Name, Place) -> faultcheck_eqc_sut:latest(Name, Place).
latest_next(S, _, [Name, Place]) ->
    with(Name, fun(C) ->
        case faultcheck_ref:latest(Place, C) of
            {ok, _, After} -> After;
            {_, After} -> After
        end
    end, S).
latest_post(S, [Name, Place], Result) ->
    case faultcheck_ref:latest(Place, context(Name, S)) of
        {ok, Id, _} -> Result =:= Id;
        {Code, _} -> Result =:= Code
    end.

%% ---- probe ------------------------------------------------------------------------------------
probe_pre(S) -> allowed(probe, S).
probe_args(S) ->
    ?LET({Name, Id}, probed(S), begin
        Models = [M || #{model := M} <- faultcheck_ref:faults({probe, Id}, context(Name, S))],
        ?LET(Type, telling_type(Models), [Name, Id, Type, telling_value(Type, Models)])
    end).
probe_pre(S, _) -> probe_pre(S).
probe(Name, Id, Type, Value) ->
    faultcheck_eqc_sut:probe(Name, Id, Type, faultcheck_ref_value:new(Type, Value)).
probe_next(S, _, [Name, Id, Type, Value]) ->
    with(Name, fun(C) -> element(3, expected(Id, Type, Value, C)) end, S).
probe_post(S, [Name, Id, Type, Value], {Code, Result}) ->
    {Expected, Altered, _} = expected(Id, Type, Value, context(Name, S)),
    (Expected =:= unsure orelse Code =:= Expected) andalso
        faultcheck_ref_value:matches(Type, Altered, Result).

expected(Id, Type, Value, C) ->
    faultcheck_ref:probe(Id, Type, faultcheck_ref_value:new(Type, Value), C).

legacy_probe_pre(S) -> allowed(probe, S).
legacy_probe_args(S) -> ?LET(Type, oneof([i32, f64]), [probe_id(S), Type, value(Type)]).
legacy_probe_pre(S, _) -> legacy_probe_pre(S).
legacy_probe(Id, Type, Value) ->
    faultcheck_eqc_sut:legacy_probe(Id, Type, faultcheck_ref_value:new(Type, Value)).
legacy_probe_next(S, _, [Id, Type, Value]) ->
    with(default, fun(C) -> element(3, expected(Id, Type, Value, C)) end, S).
legacy_probe_post(S, [Id, Type, Value], Result) ->
    {_, Altered, _} = expected(Id, Type, Value, context(default, S)),
    faultcheck_ref_value:matches(Type, Altered, Result).

num_active_pre(S) -> allowed(probe, S).
num_active_args(S) -> [context(S), probe_id(S)].
num_active_pre(S, _) -> num_active_pre(S).
num_active(Name, Id) -> faultcheck_eqc_sut:num_active(Name, Id).
num_active_post(S, [Name, Id], Result) ->
    Result =:= faultcheck_ref:num_active(Id, context(Name, S)).

%% ---- channels ---------------------------------------------------------------------------------
put_pre(S) -> allowed(channel, S).
put_args(S) -> [context(S), channel(), packet()].
put_pre(S, _) -> put_pre(S).
put(Name, Channel, Data) -> faultcheck_eqc_sut:put(Name, Channel, Data).
put_next(S, _, [Name, Channel, Data]) ->
    with(Name, fun(C) -> element(2, faultcheck_ref:put(Channel, Data, C)) end, S).
put_post(S, [Name, Channel, Data], Result) ->
    Result =:= element(1, faultcheck_ref:put(Channel, Data, context(Name, S))).

get_pre(S) -> allowed(channel, S).
get_args(S) -> [context(S), channel(), receiver(), frequency([{9, ?ROOM}, {1, integer(0, 3)}])].
%% Whether a packet of unknown content fits is not known either: there must be room.
get_pre(S, [Name, Channel, Receiver, Capacity]) ->
    get_pre(S) andalso (Capacity >= ?ROOM orelse
        element(1, faultcheck_ref:get(Channel, Receiver, Capacity, context(Name, S))) =/=
            {packet, any}).
get(Name, Channel, Receiver, Capacity) ->
    faultcheck_eqc_sut:get(Name, Channel, Receiver, Capacity).
get_next(S, _, [Name, Channel, Receiver, Capacity]) ->
    with(Name, fun(C) -> element(2, faultcheck_ref:get(Channel, Receiver, Capacity, C)) end, S).
get_post(S, [Name, Channel, Receiver, Capacity], Result) ->
    case {element(1, faultcheck_ref:get(Channel, Receiver, Capacity, context(Name, S))), Result} of
        {{packet, any}, {packet, _}} -> true;
        {Expected, _} -> Result =:= Expected
    end.

subscribe_pre(#state{profile = P} = S) -> allowed(channel, S) andalso P =/= channels.
subscribe_args(S) -> [context(S), channel(), receiver()].
subscribe_pre(S, _) -> subscribe_pre(S).
subscribe(Name, Channel, Receiver) -> faultcheck_eqc_sut:subscribe(Name, Channel, Receiver).
subscribe_next(S, _, [Name, Channel, Receiver]) ->
    with(Name, fun(C) -> faultcheck_ref:subscribe(Channel, Receiver, C) end, S).
subscribe_post(_, _, Result) -> Result =:= 'FC_OK'.

restrict_pre(S) -> allowed(channel, S) andalso armed(S) =/= [].
restrict_args(S) -> ?LET({Name, Id}, a_fault(S), [Name, Id, receiver()]).
restrict_pre(S, [Name, Id, _]) -> is_armed(Name, Id, S).
restrict(Name, Id, Receiver) -> faultcheck_eqc_sut:restrict(Name, Id, Receiver).
restrict_next(S, _, [Name, Id, Receiver]) ->
    with(Name, fun(C) -> element(2, faultcheck_ref:restrict(Id, Receiver, C)) end, S).
restrict_post(S, [Name, Id, Receiver], Result) ->
    Result =:= element(1, faultcheck_ref:restrict(Id, Receiver, context(Name, S))).

clear_pre(S) -> allowed(channel, S).
clear_args(S) -> [context(S), channel()].
clear_pre(S, _) -> clear_pre(S).
clear(Name, Channel) -> faultcheck_eqc_sut:clear(Name, Channel).
clear_next(S, _, [Name, Channel]) ->
    with(Name, fun(C) -> faultcheck_ref:clear(Channel, C) end, S).

depth_pre(S) -> allowed(channel, S).
depth_args(S) -> [context(S), channel(), receiver()].
depth_pre(S, _) -> depth_pre(S).
depth(Name, Channel, Receiver) -> faultcheck_eqc_sut:depth(Name, Channel, Receiver).
depth_next(S, _, [Name, Channel, Receiver]) ->
    with(Name, fun(C) -> element(2, faultcheck_ref:depth(Channel, Receiver, C)) end, S).
depth_post(S, [Name, Channel, Receiver], Result) ->
    Result =:= element(1, faultcheck_ref:depth(Channel, Receiver, context(Name, S))).

%% ---- the context ------------------------------------------------------------------------------
advance_args(S) -> [context(S), oneof([0, 1, 999, 1000, 1001, 5000, 1000000000])].
advance(Name, Ns) -> faultcheck_eqc_sut:advance(Name, Ns).
advance_next(S, _, [Name, Ns]) -> with(Name, fun(C) -> faultcheck_ref:advance(Ns, C) end, S).

seed_args(S) -> [context(S), oneof([0, 1, 2, 16#FFFFFFFFFFFFFFFF])].
seed(Name, Seed) -> faultcheck_eqc_sut:seed(Name, Seed).
seed_next(S, _, [Name, Seed]) -> with(Name, fun(C) -> faultcheck_ref:seed(Seed, C) end, S).

reset_pre(S) -> armed(S) =/= [].
reset_args(S) -> [context(S)].
reset_pre(S, _) -> reset_pre(S).
reset(Name) -> faultcheck_eqc_sut:reset(Name).
reset_next(S, _, [Name]) -> with(Name, fun faultcheck_ref:reset/1, S).

%% ---- save, restore: the model is a term, so a copy of it is its snapshot ------------------------
save_pre(S) -> armed(S) =/= [].
save_args(S) -> [context(S), oneof([one, two])].
save_pre(S, _) -> save_pre(S).
save(Name, Slot) -> faultcheck_eqc_sut:save(Name, Slot).
save_next(#state{saved = Saved} = S, _, [Name, Slot]) ->
    S#state{saved = Saved#{{Name, Slot} => context(Name, S)}}.
save_post(_, _, Result) -> Result =:= ok.

restore_pre(#state{saved = Saved}) -> map_size(Saved) > 0.
restore_args(#state{saved = Saved}) ->
    ?LET({Name, Slot}, oneof(maps:keys(Saved)), [Name, Slot]).
restore_pre(#state{saved = Saved}, [Name, Slot]) -> is_map_key({Name, Slot}, Saved).
restore(Name, Slot) -> faultcheck_eqc_sut:restore(Name, Slot).
restore_next(#state{saved = Saved} = S, _, [Name, Slot]) ->
    with(Name, fun(_) -> maps:get({Name, Slot}, Saved) end, S).
restore_post(_, _, Result) -> Result =:= 'FC_OK'.

errors_args(S) -> [context(S)].
errors(Name) -> faultcheck_eqc_sut:errors(Name).
errors_post(S, [Name], Result) ->
    Expected = faultcheck_ref:errors(context(Name, S)),
    Expected =:= unsure orelse Result =:= Expected.

%% ---- the property -------------------------------------------------------------------------------

%% @doc The library does what the model does.
-spec agrees(profile()) -> proper:outer_test().
agrees(Profile) ->
    ?SETUP(
        fun() ->
            ok = use(Profile),
            fun() -> ok end
        end,
        ?FORALL(Commands, more_commands(3, commands(?MODULE)), begin
            ok = use(Profile),
            ok = faultcheck_eqc_sut:prepare(),
            {_, _, Result} = Run = run_commands(?MODULE, Commands),
            ?WHENFAIL(
                io:put_chars(faultcheck_statem:pretty(?MODULE, Commands, Run)),
                aggregate(command_names(Commands), Result =:= ok)
            )
        end)
    ).

%% ---- the state ----------------------------------------------------------------------------------

context(Name, #state{contexts = Contexts}) -> maps:get(Name, Contexts).

with(Name, Change, #state{contexts = Contexts} = S) ->
    #{Name := C} = Contexts,
    S#state{contexts = Contexts#{Name := Change(C)}}.

armed(#state{contexts = Contexts}) ->
    [
        {Name, Id}
     || {Name, C} <- maps:to_list(Contexts),
        {_, #{id := Id}} <- faultcheck_ref:faults(C)
    ].

is_armed(Name, Id, S) -> lists:member({Name, Id}, armed(S)).

is_known(Name, Id, S) -> Id =:= never() orelse is_armed(Name, Id, S).

allowed(probe, #state{profile = P}) ->
    lists:member(P, [probes, triggers, sensors, everything]);
allowed(channel, #state{profile = P}) ->
    lists:member(P, [channels, communication, routing, everything]).

%% ---- generators ---------------------------------------------------------------------------------

%% Two contexts show what leaks from one to the other; most things happen in one.
context(#state{profile = P}) when P =:= triggers; P =:= routing -> a;
context(_S) -> frequency([{6, a}, {1, b}, {3, default}]).

%% Few names, so that faults meet. One is no text.
probe_id(#state{profile = triggers}) -> <<"x">>;
probe_id(_S) -> frequency([{4, <<"x">>}, {2, <<"y">>}, {1, <<255, 1>>}, {1, <<>>}]).

channel() -> frequency([{4, <<"x">>}, {2, <<"y">>}]).

receiver() -> frequency([{3, <<>>}, {2, <<"r">>}, {1, <<"s">>}]).

place(#state{profile = P} = S) when P =:= probes; P =:= triggers; P =:= sensors ->
    {probe, probe_id(S)};
place(#state{profile = P}) when P =:= channels; P =:= communication; P =:= routing ->
    {channel, channel()};
place(S) -> oneof([{probe, probe_id(S)}, {channel, channel()}]).

a_fault(S) -> oneof(armed(S)).

maybe_a_fault(S) ->
    case armed(S) of
        [] -> {context(S), never()};
        _ -> frequency([{9, a_fault(S)}, {1, {context(S), never()}}])
    end.

%% An id that no fault has.
never() -> 987654321.

model(#state{profile = probes}, _) -> bad_or(a_model(faultcheck_fault_gen:probe()), probe);
%% Conditions meet on few faults that show each affected call.
model(#state{profile = triggers}, _) -> oneof([{offset, 1.0}, {bitflip, 4}, bitflip_random]);
model(#state{profile = sensors}, _) -> bad_or(a_model(faultcheck_fault_gen:sensor()), sensor);
model(#state{profile = channels}, _) -> legacy_model(channel);
%% Packets that are late meet faults that look elsewhere for packets.
model(#state{profile = routing}, {channel, Channel}) ->
    [Other] = [<<"x">>, <<"y">>] -- [Channel],
    frequency([
        {4, {misroute, Other}},
        {4, {delay, {gets, integer(1, 3)}}},
        {2, {delay, {ns, 1000}}},
        {2, {masquerade, Other}},
        {1, oneof([{resequence, 1}, {drop, 1}, repeat_last])}
    ]);
model(_, {probe, _}) -> a_model(?LET(T, type(), faultcheck_fault_gen:value(T)));
model(_, {channel, Channel}) ->
    Names = #{channels => [<<"x">>, <<"y">>] -- [Channel], receivers => [<<>>, <<"r">>, <<"s">>]},
    bad_or(a_model(faultcheck_fault_gen:communication(Names)), channel).

%% Triggers have a command of their own.
a_model(Fault) -> ?LET(F, Fault, faultcheck_fault:model(F)).

bad_or(Good, Kind) -> frequency([{19, Good}, {1, oneof(refused(Kind))}]).

refused(probe) -> [{bitflip, -1}, {stuck_bit, -1, 1}];
refused(sensor) ->
    [{drift, 1.0, -1.0}, {saturate, 2.0, 1.0}, {ramp, 1.0, 0}, {quantise, 0.0},
     {delay, {calls, -1}}, {dropout, 1.5, hold}, {spike, -0.5, 1.0},
     {noise_gauss, nan}, {random_offset, 1.0, 0.0}, {held_offset, 0.0, 1.0, 0},
     {oscillate, 1.0, 0}, {dead_zone, nan, 1.0}];
refused(channel) ->
    [{drop, -1}, {repeat, -1}, {corruption, -1, 0}, {corruption, 0, 8}, {resequence, -1},
     {delay, {gets, -1}}, {delay, {ns, -1}}, {insert, <<1>>, -1}].

legacy_model(probe) ->
    oneof([
        {bitflip, oneof([-1, 64, integer(0, 63), integer(0, 31)])},
        bitflip_random,
        stuck,
        {oneof([amplification, offset, set_to]),
         oneof([-1.5, 0.5, 3.0, 1.0e10, -1.0e10, 2147483647.0, -2147483648.0, nan, inf])}
    ]);
legacy_model(channel) ->
    oneof([
        {corruption, integer(-1, 3), integer(0, 8)},
        {oneof([drop, repeat]), integer(-1, 4)}
    ]).

%% Conditions that leave a fault alive, so that they meet.
change(#state{profile = triggers}) ->
    frequency([
        {1, {from, integer(0, 3)}},
        {1, {for, integer(5, 20)}},
        {3, {random, 0.5}},
        {3, {periodic, integer(2, 4), integer(1, 3)}},
        {2, {time, oneof([0, 1000]), oneof([forever, 1000000000])}}
    ]);
change(_S) ->
    frequency([
        {1, none},
        {3, {from, oneof([0, 1, 2, 3, 16#FFFFFFFFFFFFFFFF, 16#100000001])}},
        {3, {once, integer(0, 3)}},
        {4, {for, integer(-1, 4)}},
        {2, {random, oneof([0.0, 0.5, 0.5, 1.0, 1.5])}},
        {2, {periodic, integer(0, 4), integer(0, 3)}},
        {2, {time, oneof([0, 1000, 2000]), oneof([forever, 0, 1000, 5000])}}
    ]).

type() ->
    frequency([{3, f64}, {2, f32}, {3, i32} |
               [{1, T} || T <- [i8, i16, i64, u8, u16, u32, u64, bool, bytes]]]).

%% Half of the probes are where faults are armed: some show only in several calls running.
probed(#state{contexts = Contexts} = S) ->
    Anywhere = {context(S), probe_id(S)},
    Places = [
        {Name, Id}
     || {Name, C} <- maps:to_list(Contexts), {{probe, Id}, _} <- faultcheck_ref:faults(C)
    ],
    case Places of
        [] -> Anywhere;
        _ -> frequency([{1, Anywhere}, {1, oneof(Places)}])
    end.

%% What is held is held for each type, so calls of one type show it.
telling_type(Models) ->
    case [held || {dropout, _, hold} <- Models] of
        [] -> type();
        _ -> frequency([{1, type()}, {3, f64}])
    end.

%% Often exactly where an armed fault begins to act.
telling_value(Type, Models) ->
    case lists:flatmap(fun edges/1, Models) of
        [_ | _] = Edges when Type =:= f32; Type =:= f64 ->
            frequency([{2, value(Type)}, {1, oneof(Edges)}]);
        _ ->
            value(Type)
    end.

edges({dead_zone, Centre, Width}) when abs(Centre) < 1.0e300, abs(Width) < 1.0e300 ->
    [float(Centre - Width), float(Centre + Width)];
edges({saturate, Low, High}) ->
    [float(X) || X <- [Low, High], is_number(X)];
edges(_) ->
    [].

%% The limits, and values whose product with a parameter passes them.
value(bytes) -> packet();
value(bool) -> integer(0, 1);
value(Type) when Type =:= f32; Type =:= f64 ->
    frequency([
        {6, ?LET(N, integer(-40, 40), N / 4)},
        {1, oneof([inf, neg_inf, nan, -0.0, 5.0e-324, 1.0e-45, 3.4028234663852886e38])},
        {1, oneof([1.0e308, -1.0e308, 1.0e18, 16777217.0, 0.1])}
    ]);
value(Type) ->
    {Low, High} = faultcheck_ref_value:limits(Type),
    frequency([
        {4, integer(max(Low, -20), 20)},
        {2, oneof([Low, Low + 1, High - 1, High])},
        {1, uniform(Low, High)}
    ]).

packet() -> ?LET(N, integer(0, 5), binary(N)).

%% @doc Arms faults of faultcheck_fault in a library that uses libfaultcheck.
%%
%% ```
%% {ok, Lib} = cb:start(engine, [{so, "libengine.so"}]),
%% {ok, Id} = faultcheck_inject:arm(Lib, null, {probe, <<"speed">>}, {{offset, 2.5}, [{from, 9}]}),
%% ok = faultcheck_inject:enable(Lib, null, Id, false),
%% ok = faultcheck_inject:remove(Lib, null, Id).
%% '''
%% A context is a pointer that fc_new gave, or null for the default one. What libfaultcheck
%% refuses comes back as its error and its sentence.
-module(faultcheck_inject).

-export([arm/4, trigger/4, enable/4, remove/3, remove_all/3]).
-export([add_call/3, condition_call/4, fc_model/1, code_name/1, attempt/3]).
-export_type([where/0, context/0, id/0, reason/0, call/0]).

-type context() :: null | cb:ptr().
-type where() ::
    {probe, Id :: binary()}
    | {channel, Channel :: binary()}
    | {channel, Channel :: binary(), Receiver :: binary()}.
-type id() :: pos_integer().
-type reason() :: {invalid | atom(), unicode:chardata()}.
-type call() :: {atom(), [term()]}.

%% @doc Arms a fault. When a part of its trigger is refused, nothing stays armed.
-spec arm(cb:library(), context(), where(), faultcheck_fault:fault()) ->
    {ok, id()} | {error, reason()}.
arm(Lib, Context, Where, Fault) ->
    case check(Where, Fault) of
        ok -> arm_valid(Lib, Context, Where, faultcheck_fault:normal(Fault));
        {error, Line} -> {error, {invalid, Line}}
    end.

check(Where, Fault) ->
    case faultcheck_fault:validate(Fault) of
        ok -> check_place(Where, faultcheck_fault:class(Fault), faultcheck_fault:stage(Fault));
        Error -> Error
    end.

check_place({probe, _}, communication, _) ->
    {error, "a fault of channels was to be armed on a probe"};
check_place({probe, Id}, _, _) ->
    check_name(Id);
check_place({channel, Channel}, communication, _) ->
    check_name(Channel);
check_place({channel, Channel, Receiver}, communication, get) ->
    case check_name(Channel) of
        ok -> check_name(Receiver);
        Error -> Error
    end;
check_place({channel, _, _}, communication, put) ->
    {error, "a fault that acts on a put is for all receivers: {channel, Channel}"};
check_place(Where, Class, _) when is_tuple(Where), element(1, Where) =:= channel ->
    {error, io_lib:format("a model of class ~s was to be armed on a channel; "
                          "{field, Field, Model} applies it to packets", [Class])};
check_place(Where, _, _) ->
    {error, io_lib:format("~tp is no place: expected {probe, Id}, {channel, Channel} or "
                          "{channel, Channel, Receiver}", [Where])}.

check_name(Name) ->
    case faultcheck_fault_parameter:check(name, Name) of
        true -> ok;
        false -> {error, io_lib:format("~tp is no name: expected ~ts",
                                       [Name, faultcheck_fault_parameter:expected(name)])}
    end.

arm_valid(Lib, Context, Where, {Model, Trigger}) ->
    {Function, Args} = add_call(Context, Where, Model),
    case attempt(Lib, Function, Args) of
        {Id, _} when Id > 0 ->
            Restriction = restriction(Context, Id, Where),
            case all(Lib, Restriction ++ conditions(Lib, Context, Id, Trigger)) of
                ok ->
                    {ok, Id};
                {error, _} = Error ->
                    _ = cb:call(Lib, fc_remove, [Context, Id]),
                    Error
            end;
        {_, Error} ->
            Error()
    end.

restriction(Context, Id, {channel, _, Receiver}) ->
    [{fc_channel_fault_receiver, [Context, Id, Receiver]}];
restriction(_, _, _) ->
    [].

%% @doc Gives an armed fault another trigger, which counts from now on.
-spec trigger(cb:library(), context(), id(), faultcheck_fault:trigger()) -> ok | {error, reason()}.
trigger(Lib, Context, Id, Trigger) ->
    case faultcheck_fault:validate_trigger(Trigger) of
        ok -> all(Lib, [{fc_trigger_none, [Context, Id]} | conditions(Lib, Context, Id, Trigger)]);
        {error, Line} -> {error, {invalid, Line}}
    end.

%% @doc A disabled fault does nothing, and its trigger stands still.
-spec enable(cb:library(), context(), id(), boolean()) -> ok | {error, reason()}.
enable(Lib, Context, Id, Enabled) -> all(Lib, [{fc_enable, [Context, Id, Enabled]}]).

%% @doc Disarms one fault.
-spec remove(cb:library(), context(), id()) -> ok | {error, reason()}.
remove(Lib, Context, Id) -> all(Lib, [{fc_remove, [Context, Id]}]).

%% @doc Disarms a probe, a channel, or everything. Queued packets stay.
-spec remove_all(cb:library(), context(), where() | all) -> ok.
remove_all(Lib, Context, {probe, Id}) ->
    cb:call(Lib, fc_remove_probe_faults, [Context, Id]);
remove_all(Lib, Context, {channel, Channel}) ->
    cb:call(Lib, fc_channel_remove_faults, [Context, Channel]);
remove_all(Lib, Context, all) ->
    _ = cb:call_batch(Lib, [{fc_remove_all_probe_faults, [Context]},
                            {fc_channel_remove_all_faults, [Context]}]),
    ok.

all(_Lib, []) ->
    ok;
all(Lib, [{Function, Args} | Calls]) ->
    case attempt(Lib, Function, Args) of
        {0, _} -> all(Lib, Calls);
        {_, Error} -> Error()
    end.

%% @doc Calls a function of libfaultcheck: what it gives, and what its error is if that is one. Both
%% are asked for at once: an error is known to the thread that met it.
-spec attempt(cb:library(), atom(), [term()]) -> {term(), fun(() -> {error, reason()})}.
attempt(Lib, Function, Args) ->
    Calls = [{Function, Args}, {fc_last_error, []}, {fc_last_error_text, []}],
    [Result, Code, Text] = cb:call_batch(Lib, Calls),
    {Result, fun() -> {error, {code_name(Code), cb:cstring(Lib, Text)}} end}.

%% @doc The name of an FC_E_ code.
-spec code_name(integer()) -> atom().
code_name(0) -> 'FC_OK';
code_name(Code) when Code < 0, Code >= -12 ->
    element(-Code, {'FC_E_ARG', 'FC_E_NOMEM', 'FC_E_BIT', 'FC_E_INDEX', 'FC_E_VALUE', 'FC_E_TYPE',
                    'FC_E_NO_FAULT', 'FC_E_SPACE', 'FC_E_RECEIVER', 'FC_E_BLOCKED', 'FC_E_IO',
                    'FC_E_FORMAT'});
code_name(_) -> 'FC_E_UNKNOWN'.

%% ---- the calls of fc.h ----------------------------------------------------------------------

%% The window first: setting it takes back a duration.
conditions(Lib, Context, Id, Trigger) ->
    Order = fun({from, _}) -> 1; ({for, _}) -> 2; (_) -> 3 end,
    Sorted = lists:sort(fun(A, B) -> Order(A) =< Order(B) end, Trigger),
    [condition_call(Lib, Context, Id, Condition) || Condition <- Sorted].

%% @doc The call for one condition.
-spec condition_call(cb:library(), context(), integer(), faultcheck_fault:condition()) -> call().
condition_call(_, Ctx, Id, {from, N}) -> {fc_trigger_after, [Ctx, Id, N]};
condition_call(_, Ctx, Id, {for, N}) -> {fc_trigger_duration, [Ctx, Id, N]};
condition_call(_, Ctx, Id, {time, Delay, forever}) -> {fc_trigger_time, [Ctx, Id, Delay, -1]};
condition_call(_, Ctx, Id, {time, Delay, Ns}) -> {fc_trigger_time, [Ctx, Id, Delay, Ns]};
condition_call(_, Ctx, Id, {random, P}) -> {fc_trigger_random, [Ctx, Id, P]};
condition_call(_, Ctx, Id, {periodic, Period, Active}) ->
    {fc_trigger_periodic, [Ctx, Id, Period, Active]};
condition_call(Lib, Ctx, Id, {predicate, Function}) ->
    {fc_trigger_when, [Ctx, Id, cb:address_of(Lib, Function), null]}.

%% @doc The call that adds a model, whether or not its parameters are good.
-spec add_call(context(), where(), faultcheck_fault:model()) -> call().
add_call(Ctx, {probe, Id}, Model) -> add_value(Ctx, Id, Model);
add_call(Ctx, {channel, Channel}, Model) -> add_communication(Ctx, Channel, Model);
add_call(Ctx, {channel, Channel, _}, Model) -> add_communication(Ctx, Channel, Model).

add_value(Ctx, Id, stuck) -> {fc_add_stuck, [Ctx, Id]};
add_value(Ctx, Id, bitflip_random) -> {fc_add_bitflip_random, [Ctx, Id]};
add_value(Ctx, Id, {delay, {calls, N}}) -> {fc_add_delay, [Ctx, Id, N]};
add_value(Ctx, Id, {stuck_bit, Bit, Value}) -> {fc_add_stuck_bit, [Ctx, Id, Bit, Value =/= 0]};
add_value(Ctx, Id, {drift, Rate, Limit}) -> {fc_add_drift, [Ctx, Id, Rate, limit(Limit)]};
add_value(Ctx, Id, {drift_timed, Rate, Limit}) ->
    {fc_add_drift_timed, [Ctx, Id, Rate, limit(Limit)]};
add_value(Ctx, Id, {dropout, P, Mode}) -> {fc_add_dropout, [Ctx, Id, P, mode(Mode)]};
add_value(Ctx, Id, Model) ->
    [Name | Parameters] = tuple_to_list(Model),
    {value_function(Name), [Ctx, Id | Parameters]}.

value_function(bitflip) -> fc_add_bitflip;
value_function(amplification) -> fc_add_amplification;
value_function(offset) -> fc_add_offset;
value_function(set_to) -> fc_add_set_to;
value_function(noise_uniform) -> fc_add_noise_uniform;
value_function(noise_gauss) -> fc_add_noise_gauss;
value_function(random_offset) -> fc_add_random_offset;
value_function(held_offset) -> fc_add_held_offset;
value_function(ramp) -> fc_add_ramp;
value_function(quantise) -> fc_add_quantise;
value_function(dead_zone) -> fc_add_dead_zone;
value_function(saturate) -> fc_add_saturate;
value_function(oscillate) -> fc_add_oscillate;
value_function(spike) -> fc_add_spike.

limit(none) -> inf;
limit(Limit) -> Limit.

mode(hold) -> 0;
mode(zero) -> 1;
mode(nan) -> 2.

add_communication(Ctx, Ch, {corruption, Byte, Bit}) ->
    {fc_channel_add_corruption, [Ctx, Ch, Byte, Bit]};
add_communication(Ctx, Ch, {field, Field, Model}) ->
    {fc_channel_add_field, [Ctx, Ch, field(Field), fc_model(Model)]};
add_communication(Ctx, Ch, {truncate, N}) -> {fc_channel_add_truncate, [Ctx, Ch, N]};
add_communication(Ctx, Ch, {extend, N, Byte}) -> {fc_channel_add_extend, [Ctx, Ch, N, Byte]};
add_communication(Ctx, Ch, {drop, N}) -> {fc_channel_add_drop, [Ctx, Ch, N]};
add_communication(Ctx, Ch, {repeat, N}) -> {fc_channel_add_repeat, [Ctx, Ch, N]};
add_communication(Ctx, Ch, lose) -> {fc_channel_add_lose, [Ctx, Ch]};
add_communication(Ctx, Ch, repeat_last) -> {fc_channel_add_repeat_last, [Ctx, Ch]};
add_communication(Ctx, Ch, {insert, Data, N}) ->
    {fc_channel_add_insert, [Ctx, Ch, Data, byte_size(Data), N]};
add_communication(Ctx, Ch, {masquerade, From}) -> {fc_channel_add_masquerade, [Ctx, Ch, From]};
add_communication(Ctx, Ch, {resequence, N}) -> {fc_channel_add_resequence, [Ctx, Ch, N]};
add_communication(Ctx, Ch, block_get) -> {fc_channel_add_block_get, [Ctx, Ch]};
add_communication(Ctx, Ch, block_put) -> {fc_channel_add_block_put, [Ctx, Ch]};
add_communication(Ctx, Ch, {delay, {gets, N}}) -> {fc_channel_add_delay, [Ctx, Ch, N]};
add_communication(Ctx, Ch, {delay, {ns, N}}) -> {fc_channel_add_delay_time, [Ctx, Ch, N]};
add_communication(Ctx, Ch, {misroute, To}) -> {fc_channel_add_misroute, [Ctx, Ch, To]};
add_communication(Ctx, Ch, {asymmetric, Receivers, Part, Model}) ->
    {fc_channel_add_asymmetric,
     [Ctx, Ch, Receivers, length(Receivers), field(Part), fc_model(Model)]};
add_communication(Ctx, Ch, {subset, Receivers}) ->
    {fc_channel_add_subset, [Ctx, Ch, Receivers, length(Receivers)]}.

field(whole) ->
    null;
field({Offset, bytes, Length}) ->
    #{offset => Offset, type => 'FC_BYTES', big_endian => false, length => Length};
field({Offset, Type, Order}) ->
    #{offset => Offset, type => fc_type(Type), big_endian => Order =:= big, length => 0}.

fc_type(f32) -> 'FC_F32';
fc_type(f64) -> 'FC_F64';
fc_type(i8) -> 'FC_I8';
fc_type(i16) -> 'FC_I16';
fc_type(i32) -> 'FC_I32';
fc_type(i64) -> 'FC_I64';
fc_type(u8) -> 'FC_U8';
fc_type(u16) -> 'FC_U16';
fc_type(u32) -> 'FC_U32';
fc_type(u64) -> 'FC_U64';
fc_type(bool) -> 'FC_BOOL'.

%% @doc The struct fc_model of any value model.
-spec fc_model(faultcheck_fault:model()) -> map().
fc_model(Model) -> fc_model(Model, #{a => 0.0, b => 0.0, n => 0}).

fc_model({bitflip, N}, M) -> M#{kind => 0, n := N};
fc_model(bitflip_random, M) -> M#{kind => 1};
fc_model(stuck, M) -> M#{kind => 2};
fc_model({stuck_bit, N, V}, M) -> M#{kind => 3, n := N, a := float(V)};
fc_model({amplification, A}, M) -> M#{kind => 4, a := A};
fc_model({offset, A}, M) -> M#{kind => 5, a := A};
fc_model({set_to, A}, M) -> M#{kind => 6, a := A};
fc_model({noise_uniform, A}, M) -> M#{kind => 7, a := A};
fc_model({noise_gauss, A}, M) -> M#{kind => 8, a := A};
fc_model({random_offset, A, B}, M) -> M#{kind => 9, a := A, b := B};
fc_model({drift, A, B}, M) -> M#{kind => 10, a := A, b := limit(B)};
fc_model({drift_timed, A, B}, M) -> M#{kind => 11, a := A, b := limit(B)};
fc_model({ramp, A, N}, M) -> M#{kind => 12, a := A, n := N};
fc_model({delay, {calls, N}}, M) -> M#{kind => 13, n := N};
fc_model({quantise, A}, M) -> M#{kind => 14, a := A};
fc_model({dead_zone, A, B}, M) -> M#{kind => 15, a := A, b := B};
fc_model({saturate, A, B}, M) -> M#{kind => 16, a := A, b := B};
fc_model({oscillate, A, N}, M) -> M#{kind => 17, a := A, n := N};
fc_model({dropout, A, Mode}, M) -> M#{kind => 18, a := A, n := mode(Mode)};
fc_model({spike, A, B}, M) -> M#{kind => 19, a := A, b := B};
fc_model({held_offset, A, B, Ns}, M) -> M#{kind => 20, a := A, b := B, n := Ns}.

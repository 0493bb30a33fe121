%% @doc libfaultcheck as the system under test of the calling process: one instance, which ends with
%% its process, and the contexts a, b (made by fc_new) and default.
%%
%% FAULTCHECK_LIB_DIR names another directory for the library. Values cross the bridge as their
%% bytes, so no bit of a float is lost.
-module(faultcheck_eqc_sut).

-export([prepare/0, stop/0, add/3, trigger/3, latest/2, enable/3, remove/2, remove_all/2]).
-export([restrict/3, probe/4, num_active/2, put/3, get/4, subscribe/3, clear/2, depth/3]).
-export([advance/2, seed/2, reset/1, errors/1, save/2, restore/2, lib/0, context/1]).
-export([legacy_add/2, legacy_trigger/2, legacy_probe/3]).
-export([encode/2, decode/2]).
-export_type([context/0, slot/0]).

-type context() :: a | b | default.
%% Where a snapshot of a context is kept.
-type slot() :: one | two.
-type place() :: {probe | channel, binary()}.

%% Larger than what any test puts.
-define(ROOM, 64).

%% @doc All contexts as new, with manual clocks at 0.
-spec prepare() -> ok.
prepare() ->
    #{lib := Lib} = Sut = instance(),
    Calls = [
        Call
     || Name <- [a, b, default],
        Call <- [{fc_reset, [maps:get(Name, Sut)]}, {fc_advance, [maps:get(Name, Sut), 0]}]
    ],
    _ = cb:call_batch(Lib, Calls),
    forget_all().

instance() ->
    case get(?MODULE) of
        undefined ->
            Sut = start(),
            _ = put(?MODULE, Sut),
            Sut;
        Sut ->
            Sut
    end.

start() ->
    Options = [
        {so, cb_library:find("libfaultcheck.so", ?MODULE)},
        {transport, nif},
        {reset, {calls, [{fc_reset, [null]}]}},
        {module, false}
    ],
    case cb:start(faultcheck_eqc, Options) of
        {ok, Lib} ->
            [A, B] = cb:call_batch(Lib, [{fc_new, [null]}, {fc_new, [null]}]),
            Sut = #{
                lib => Lib,
                a => A,
                b => B,
                default => null,
                data => cb:create_array(Lib, 'unsigned char', binary:copy(<<0>>, ?ROOM)),
                length => cb:create_array(Lib, size_t, [0])
            },
            quiet(Lib, [A, B, null]),
            Sut;
        {error, Reason} ->
            error({cb, Reason})
    end.

%% The errors of the tests are expected. Any function that takes a pointer and looks at nothing
%% behind it will do in the place of the one that prints.
quiet(Lib, Contexts) ->
    Quiet = cb:address_of(Lib, fc_default),
    _ = cb:call_batch(Lib, [{fc_set_error_callback, [C, Quiet, null]} || C <- Contexts]),
    ok.

%% @doc Ends the instance.
-spec stop() -> ok.
stop() ->
    ok = forget_all(),
    case erase(?MODULE) of
        undefined -> ok;
        #{lib := Lib} -> cb:stop(Lib)
    end.

-spec lib() -> cb:lib().
lib() -> maps:get(lib, instance()).

-spec context(context()) -> null | cb:ptr().
context(Name) -> maps:get(Name, instance()).

call(Function, Args) -> cb:call(lib(), Function, Args).

%% Codes below 0 by name; 0 is FC_OK.
code(Code) when Code =< 0 -> faultcheck_inject:code_name(Code).

id(Id) when Id > 0 -> Id;
id(Code) -> code(Code).

%% ---- arming -----------------------------------------------------------------------------------

%% @doc The fault's id, or why not.
-spec add(context(), place(), faultcheck_fault:model()) -> pos_integer() | atom().
add(Context, Place, Model) ->
    {Function, Args} = faultcheck_inject:add_call(context(Context), Place, Model),
    id(call(Function, Args)).

-spec trigger(context(), integer(), faultcheck_ref_trigger:change()) -> atom().
trigger(Context, Id, none) ->
    code(call(fc_trigger_none, [context(Context), Id]));
trigger(Context, Id, {once, N}) ->
    code(call(fc_trigger_once_after, [context(Context), Id, N]));
trigger(Context, Id, Condition) ->
    {Function, Args} = faultcheck_inject:condition_call(lib(), context(Context), Id, Condition),
    code(call(Function, Args)).

-spec latest(context(), place()) -> pos_integer() | atom().
latest(Context, {probe, Id}) -> id(call(fc_latest, [context(Context), Id]));
latest(Context, {channel, Channel}) -> id(call(fc_channel_latest, [context(Context), Channel])).

-spec enable(context(), integer(), boolean()) -> atom().
enable(Context, Id, Enabled) -> code(call(fc_enable, [context(Context), Id, Enabled])).

-spec remove(context(), integer()) -> atom().
remove(Context, Id) -> code(call(fc_remove, [context(Context), Id])).

-spec remove_all(context(), place() | probes | channels) -> ok.
remove_all(Context, {probe, Id}) -> call(fc_remove_probe_faults, [context(Context), Id]);
remove_all(Context, {channel, Ch}) -> call(fc_channel_remove_faults, [context(Context), Ch]);
remove_all(Context, probes) -> call(fc_remove_all_probe_faults, [context(Context)]);
remove_all(Context, channels) -> call(fc_channel_remove_all_faults, [context(Context)]).

-spec restrict(context(), integer(), binary()) -> atom().
restrict(Context, Id, Receiver) ->
    code(call(fc_channel_fault_receiver, [context(Context), Id, Receiver])).

%% ---- the compatible interface, which acts on the default context ------------------------------

-spec legacy_add(place(), faultcheck_fault:model()) -> ok.
legacy_add({probe, Id}, {bitflip, Bit}) -> call(faultcheck_addFaultBitFlip, [Id, Bit]);
legacy_add({probe, Id}, bitflip_random) -> call(faultcheck_addFaultBitFlipRandom, [Id]);
legacy_add({probe, Id}, stuck) -> call(faultcheck_addFaultStuckToCurrent, [Id]);
legacy_add({probe, Id}, {amplification, K}) -> call(faultcheck_addFaultAmplification, [Id, K]);
legacy_add({probe, Id}, {offset, C}) -> call(faultcheck_addFaultOffset, [Id, C]);
legacy_add({probe, Id}, {set_to, V}) -> call(faultcheck_addFaultSetTo, [Id, V]);
legacy_add({channel, Ch}, {corruption, Byte, Bit}) ->
    call(faultcheck_packet_addFaultCorruptionBitFlip, [Ch, Byte, Bit]);
legacy_add({channel, Ch}, {drop, N}) -> call(faultcheck_packet_addFaultDrop, [Ch, N]);
legacy_add({channel, Ch}, {repeat, N}) -> call(faultcheck_packet_addFaultRepeat, [Ch, N]).

-spec legacy_trigger(place(), {from | once | for, integer()}) -> ok.
legacy_trigger({probe, Id}, {from, N}) -> call(faultcheck_setTriggerAfterIterations, [Id, N]);
legacy_trigger({probe, Id}, {once, N}) -> call(faultcheck_setTriggerOnceAfterIterations, [Id, N]);
legacy_trigger({probe, Id}, {for, N}) -> call(faultcheck_setDurationAfterTrigger, [Id, N]);
legacy_trigger({channel, Ch}, {from, N}) ->
    call(faultcheck_packet_setTriggerAfterIterations, [Ch, N]);
legacy_trigger({channel, Ch}, {once, N}) ->
    call(faultcheck_packet_setTriggerOnceAfterIterations, [Ch, N]);
legacy_trigger({channel, Ch}, {for, N}) ->
    call(faultcheck_packet_setDurationAfterTrigger, [Ch, N]).

%% @doc The probes for int and double: the value afterwards.
-spec legacy_probe(binary(), i32 | f64, faultcheck_ref_value:value()) ->
    faultcheck_ref_value:value().
legacy_probe(Id, Type, Value) ->
    Function = maps:get(Type, #{i32 => faultcheck_injectFaultInt,
                                f64 => faultcheck_injectFaultDouble}),
    with_bytes(Type, Value, fun(Pointer, _) -> {ok, call(Function, [Id, Pointer])} end).

%% ---- probes -----------------------------------------------------------------------------------

%% @doc The code and the value afterwards, floats as bits.
-spec probe(context(), binary(), faultcheck_ref_value:type(), faultcheck_ref_value:value()) ->
    {atom(), faultcheck_ref_value:value()}.
probe(Context, Id, Type, Value) ->
    with_bytes(Type, Value, fun(Pointer, Size) ->
        Args = [context(Context), Id, Pointer] ++ [Size || Type =:= bytes],
        {code, call(probe_function(Type), Args)}
    end).

with_bytes(Type, Value, Call) ->
    Bytes = encode(Type, Value),
    %% Behind the value stand bytes that nobody may touch.
    {ptr, _, At} = Buffer = cb:create_array(lib(), 'unsigned char', <<Bytes/binary, 16#A55A:16>>),
    Result = Call({ptr, ctype(Type), At}, byte_size(Bytes)),
    After = cb:read_bytes(lib(), Buffer, byte_size(Bytes) + 2),
    ok = cb:free(lib(), Buffer),
    {Changed, <<16#A55A:16>>} = split_binary(After, byte_size(Bytes)),
    case Result of
        {ok, ok} -> decode(Type, Changed);
        {code, Code} -> {code(Code), decode(Type, Changed)}
    end.

probe_function(f32) -> fc_probe_f32;
probe_function(f64) -> fc_probe_f64;
probe_function(i8) -> fc_probe_i8;
probe_function(i16) -> fc_probe_i16;
probe_function(i32) -> fc_probe_i32;
probe_function(i64) -> fc_probe_i64;
probe_function(u8) -> fc_probe_u8;
probe_function(u16) -> fc_probe_u16;
probe_function(u32) -> fc_probe_u32;
probe_function(u64) -> fc_probe_u64;
probe_function(bool) -> fc_probe_bool;
probe_function(bytes) -> fc_probe_bytes.

ctype(f32) -> float;
ctype(f64) -> double;
ctype(i8) -> int8_t;
ctype(i16) -> int16_t;
ctype(i32) -> int;
ctype(i64) -> int64_t;
ctype(u8) -> uint8_t;
ctype(u16) -> uint16_t;
ctype(u32) -> uint32_t;
ctype(u64) -> uint64_t;
ctype(bool) -> '_Bool';
ctype(bytes) -> 'unsigned char'.

%% @doc A value as its bytes in memory.
-spec encode(faultcheck_ref_value:type(), faultcheck_ref_value:value()) -> binary().
encode(bytes, Bytes) -> Bytes;
encode(bool, V) -> <<V>>;
encode(Type, V) -> <<V:(faultcheck_ref_value:width(Type, V))/little>>.

%% @doc Bytes in memory as a value, floats as bits.
-spec decode(faultcheck_ref_value:type(), binary()) -> faultcheck_ref_value:value().
decode(bytes, Bytes) -> Bytes;
decode(bool, <<V>>) -> V;
decode(Type, Bytes) ->
    Bits = bit_size(Bytes),
    case lists:member(Type, [i8, i16, i32, i64]) of
        true ->
            <<V:Bits/little-signed>> = Bytes,
            V;
        false ->
            <<V:Bits/little>> = Bytes,
            V
    end.

-spec num_active(context(), binary()) -> integer().
num_active(Context, Id) -> call(fc_num_active, [context(Context), Id]).

%% ---- channels ---------------------------------------------------------------------------------

-spec put(context(), binary(), binary()) -> atom().
put(Context, Channel, Data) ->
    code(call(fc_channel_put, [context(Context), Channel, Data, byte_size(Data)])).

%% @doc A packet, nothing, or a code; with FC_E_SPACE the length needed.
-spec get(context(), binary(), binary(), 0..64) ->
    nothing | {packet, binary()} | {'FC_E_SPACE', non_neg_integer()} | atom().
get(Context, Channel, Receiver, Capacity) ->
    #{lib := Lib, data := Data, length := Length} = instance(),
    Args = [context(Context), Channel, Receiver, Data, Capacity, Length],
    case cb:call(Lib, fc_channel_get, Args) of
        1 -> {packet, cb:read_bytes(Lib, Data, length_of(Lib, Length))};
        0 -> nothing;
        -8 -> {'FC_E_SPACE', length_of(Lib, Length)};
        Code -> code(Code)
    end.

length_of(Lib, Length) ->
    [N] = cb:read(Lib, Length, 1),
    N.

-spec subscribe(context(), binary(), binary()) -> atom().
subscribe(Context, Channel, Receiver) ->
    code(call(fc_channel_subscribe, [context(Context), Channel, Receiver])).

-spec clear(context(), binary()) -> ok.
clear(Context, Channel) -> call(fc_channel_clear, [context(Context), Channel]).

-spec depth(context(), binary(), binary()) -> non_neg_integer() | atom().
depth(Context, Channel, Receiver) ->
    case call(fc_channel_depth, [context(Context), Channel, Receiver]) of
        Depth when Depth >= 0 -> Depth;
        Code -> code(Code)
    end.

%% ---- the context ------------------------------------------------------------------------------

-spec advance(context(), non_neg_integer()) -> ok.
advance(Context, Ns) -> call(fc_advance, [context(Context), Ns]).

-spec seed(context(), non_neg_integer()) -> ok.
seed(Context, Seed) -> call(fc_seed, [context(Context), Seed]).

%% @doc Keeps the state of a context, in the place of what the slot held.
-spec save(context(), slot()) -> ok | 'FC_E_NOMEM'.
save(Context, Slot) ->
    forget({?MODULE, snapshot, Context, Slot}),
    case call(fc_save, [context(Context)]) of
        null ->
            'FC_E_NOMEM';
        Snapshot ->
            _ = put({?MODULE, snapshot, Context, Slot}, Snapshot),
            ok
    end.

-spec restore(context(), slot()) -> atom().
restore(Context, Slot) ->
    Snapshot = get({?MODULE, snapshot, Context, Slot}),
    code(call(fc_restore, [context(Context), Snapshot])).

forget_all() ->
    lists:foreach(fun forget/1, [K || {{?MODULE, snapshot, _, _} = K, _} <- erlang:get()]).

forget(Key) ->
    case erase(Key) of
        undefined -> ok;
        Snapshot -> call(fc_release, [Snapshot])
    end.

-spec reset(context()) -> ok.
reset(Context) -> call(fc_reset, [context(Context)]).

-spec errors(context()) -> non_neg_integer().
errors(Context) -> call(fc_error_count, [context(Context)]).

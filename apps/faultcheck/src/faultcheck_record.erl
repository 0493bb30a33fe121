%% @doc Recordings of libfaultcheck: what passes the probes, monitors and channels of a library
%% under test, and where a run differs from a golden one.
%%
%% ```
%% ok = faultcheck_record:start(Lib, null),
%% ... a run without faults ...
%% {ok, Golden} = faultcheck_record:stop(Lib, null),
%% ok = faultcheck_record:start(Lib, null),
%% ... the same with a fault ...
%% {ok, Run} = faultcheck_record:stop(Lib, null),
%% {ok, [#{id := <<"sensor">>, first := 2} | _]} = faultcheck_record:compare(Lib, Golden, Run).
%% '''
%% The order of a comparison is the way the error propagated. A recording is a binary: keep it in a
%% file, read it with calls/1, which needs no library.
-module(faultcheck_record).

-export([start/2, start/3, stop/2, calls/1, compare/3, compare/4, monitor/5, types/1]).
-export_type([type/0, call/0, value/0, tolerance/0, divergence/0]).

-type context() :: faultcheck_inject:context().
-type type() :: f32 | f64 | i8 | i16 | i32 | i64 | u8 | u16 | u32 | u64 | bool | bytes.
-type value() :: number() | inf | neg_inf | nan | boolean() | binary().
-type call() :: #{
    kind := probe | monitor | put | get,
    id := binary(),
    %% bytes for packets
    type := type(),
    %% number in the recording, from 0, and context time
    sequence := non_neg_integer(),
    time_ns := integer(),
    before := value(),
    'after' := value(),
    %% faults applied
    faults := non_neg_integer()
}.
%% Values differ when abs(A - B) > absolute + relative * abs(golden value).
-type tolerance() :: #{absolute => number(), relative => number()}.
-type divergence() :: #{
    id := binary(),
    kind := probe | channel,
    %% that both have; of those differing
    calls := non_neg_integer(),
    differing := non_neg_integer(),
    %% number of the first diverging call, from 0, and its time in the run, or in the golden one if
    %% it is missing
    first := non_neg_integer(),
    first_ns := integer(),
    missing := non_neg_integer(),
    extra := non_neg_integer(),
    largest_absolute := number() | atom(),
    largest_relative := number() | atom()
}.

-define(TYPES, {f32, f64, i8, i16, i32, i64, u8, u16, u32, u64, bool, bytes}).

%% @doc Records every probe and monitor call and every packet from now on, in memory.
-spec start(cb:library(), context()) -> ok | {error, faultcheck_inject:reason()}.
start(Lib, Context) -> done(Lib, fc_record_start, [Context, null]).

%% @doc The same into a file.
-spec start(cb:library(), context(), file:filename()) -> ok | {error, faultcheck_inject:reason()}.
start(Lib, Context, File) ->
    Name = unicode:characters_to_binary(File),
    done(Lib, fc_record_start, [Context, Name]).

done(Lib, Function, Args) ->
    case faultcheck_inject:attempt(Lib, Function, Args) of
        {0, _} -> ok;
        {_, Error} -> Error()
    end.

%% @doc Ends a recording and gives what is in memory: &lt;&lt;&gt;&gt; if it went to a file.
-spec stop(cb:library(), context()) -> {ok, binary()} | {error, faultcheck_inject:reason()}.
stop(Lib, Context) ->
    case done(Lib, fc_record_stop, [Context]) of
        ok -> {ok, copy(Lib, Context)};
        Error -> Error
    end.

copy(Lib, Context) ->
    case cb:call(Lib, fc_record_copy, [Context, null, 0]) of
        0 ->
            <<>>;
        Size ->
            Buffer = cb:create_array(Lib, 'unsigned char', binary:copy(<<0>>, Size)),
            Size = cb:call(Lib, fc_record_copy, [Context, Buffer, Size]),
            Bytes = cb:read_bytes(Lib, Buffer, Size),
            ok = cb:free(Lib, Buffer),
            Bytes
    end.

%% @doc A value of the model itself, to be recorded beside those of the library.
-spec monitor(cb:library(), context(), binary(), type(), value()) ->
    ok | {error, faultcheck_inject:reason()}.
monitor(Lib, Context, Id, bytes, Bytes) ->
    done(Lib, fc_monitor_bytes, [Context, Id, Bytes, byte_size(Bytes)]);
monitor(Lib, Context, Id, Type, Value) ->
    done(Lib, monitor_function(Type), [Context, Id, Value]).

monitor_function(f32) -> fc_monitor_f32;
monitor_function(f64) -> fc_monitor_f64;
monitor_function(i8) -> fc_monitor_i8;
monitor_function(i16) -> fc_monitor_i16;
monitor_function(i32) -> fc_monitor_i32;
monitor_function(i64) -> fc_monitor_i64;
monitor_function(u8) -> fc_monitor_u8;
monitor_function(u16) -> fc_monitor_u16;
monitor_function(u32) -> fc_monitor_u32;
monitor_function(u64) -> fc_monitor_u64;
monitor_function(bool) -> fc_monitor_bool.

%% @doc The types of a set of bits, bit T being the fc_type T.
-spec types(non_neg_integer()) -> [type()].
types(Bits) ->
    [T || {N, T} <- lists:zip(lists:seq(0, tuple_size(?TYPES) - 1), tuple_to_list(?TYPES)),
          Bits band (1 bsl N) =/= 0].

%% ---- golden runs ------------------------------------------------------------------------------

%% @doc How a run differs from a golden one, an entry for each identifier and channel that does, in
%% the order of their first divergences.
-spec compare(cb:library(), binary(), binary()) ->
    {ok, [divergence()]} | {error, faultcheck_inject:reason()}.
compare(Lib, Golden, Run) -> compare(Lib, Golden, Run, #{}).

-spec compare(cb:library(), binary(), binary(), tolerance()) ->
    {ok, [divergence()]} | {error, faultcheck_inject:reason()}.
compare(Lib, Golden, Run, Tolerance) ->
    Given = maps:merge(#{absolute => 0, relative => 0}, Tolerance),
    Args = [Golden, byte_size(Golden), Run, byte_size(Run), Given],
    case faultcheck_inject:attempt(Lib, fc_comparison_new, Args) of
        {null, Error} ->
            Error();
        {Comparison, _} ->
            Found = divergences(Lib, Comparison, 0),
            ok = cb:call(Lib, fc_comparison_free, [Comparison]),
            {ok, Found}
    end.

divergences(Lib, Comparison, At) ->
    case cb:call(Lib, fc_comparison_at, [Comparison, At]) of
        null ->
            [];
        Pointer ->
            [#{id := Id, is_channel := Channel} = Found] = cb:read(Lib, Pointer, 1),
            Kind = case Channel of true -> channel; false -> probe end,
            Divergence = (maps:remove(is_channel, Found))#{
                id := cb:cstring(Lib, Id), kind => Kind
            },
            [Divergence | divergences(Lib, Comparison, At + 1)]
    end.

%% ---- reading a recording, as src/recording.h describes it -------------------------------------

%% @doc The calls of a recording, in their order.
-spec calls(binary()) -> {ok, [call()]} | {error, {position, non_neg_integer()}}.
calls(<<"FCREC001", Entries/binary>>) -> entries(Entries, 8, #{}, []);
calls(_) -> {error, {position, 0}}.

entries(<<>>, _At, _Names, Calls) ->
    {ok, lists:reverse(Calls)};
entries(<<"N", Kind, Size:32/little, Name:Size/binary, Rest/binary>>, At, Names, Calls) when
    Kind < 2
->
    entries(Rest, At + 6 + Size, Names#{map_size(Names) => Name}, Calls);
entries(
    <<Tag, A, B, Name:32/little, Sequence:64/little, Time:64/little-signed, Faults:32/little,
        Contents/binary>>,
    At, Names, Calls
) when Tag =:= $V, A < tuple_size(?TYPES), is_map_key(Name, Names);
       Tag =:= $P, is_map_key(Name, Names) ->
    Type = case Tag of $V -> element(A + 1, ?TYPES); $P -> bytes end,
    case contents(Type, Contents) of
        {Before, After, Rest} ->
            Call = #{
                kind => kind(Tag, A, B), id => maps:get(Name, Names), type => Type,
                sequence => Sequence, time_ns => Time, faults => Faults,
                before => Before, 'after' => After
            },
            Size = 27 + byte_size(Contents) - byte_size(Rest),
            entries(Rest, At + Size, Names, [Call | Calls]);
        cut_off ->
            {error, {position, At}}
    end;
entries(_, At, _Names, _Calls) ->
    {error, {position, At}}.

kind($V, _, 0) -> probe;
kind($V, _, _) -> monitor;
kind($P, 0, _) -> get;
kind($P, _, _) -> put.

contents(Type, Bytes) ->
    case value(Type, Bytes) of
        {Before, Rest} ->
            case value(Type, Rest) of
                {After, Left} -> {Before, After, Left};
                cut_off -> cut_off
            end;
        cut_off ->
            cut_off
    end.

value(bytes, <<Size:32/little, Bytes:Size/binary, Rest/binary>>) -> {Bytes, Rest};
value(f32, <<Bits:4/binary, Rest/binary>>) -> {real(Bits), Rest};
value(f64, <<Bits:8/binary, Rest/binary>>) -> {real(Bits), Rest};
value(i8, <<V:8/signed, Rest/binary>>) -> {V, Rest};
value(i16, <<V:16/little-signed, Rest/binary>>) -> {V, Rest};
value(i32, <<V:32/little-signed, Rest/binary>>) -> {V, Rest};
value(i64, <<V:64/little-signed, Rest/binary>>) -> {V, Rest};
value(u8, <<V:8, Rest/binary>>) -> {V, Rest};
value(u16, <<V:16/little, Rest/binary>>) -> {V, Rest};
value(u32, <<V:32/little, Rest/binary>>) -> {V, Rest};
value(u64, <<V:64/little, Rest/binary>>) -> {V, Rest};
value(bool, <<V, Rest/binary>>) -> {V =/= 0, Rest};
value(_, _) -> cut_off.

real(Bytes) when byte_size(Bytes) =:= 4 ->
    case Bytes of
        <<V:32/float-little>> -> V;
        <<Bits:32/little>> -> no_real(Bits bsr 31, Bits band 16#7FFFFF)
    end;
real(Bytes) ->
    case Bytes of
        <<V:64/float-little>> -> V;
        <<Bits:64/little>> -> no_real(Bits bsr 63, Bits band 16#FFFFFFFFFFFFF)
    end.

no_real(0, 0) -> inf;
no_real(1, 0) -> neg_inf;
no_real(_, _) -> nan.

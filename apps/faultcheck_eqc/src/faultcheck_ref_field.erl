%% @doc A value model on a typed field of a packet (faultcheck.md, 7.7, corruption).
-module(faultcheck_ref_field).

-export([apply/6]).

%% @doc The packet is `any' when a byte of it is not known.
-spec apply(whole | faultcheck_fault:field(), faultcheck_fault:value_model(), binary(),
            all | binary(), integer(), faultcheck_ref_fault:fault()) ->
    {faultcheck_ref_model:code(), binary() | any, faultcheck_ref_fault:fault()}.
apply(whole, Model, Packet, Run, Now, Fault) ->
    ?MODULE:apply({0, bytes, 0}, Model, Packet, Run, Now, Fault);
apply(Field, Model, Packet, Run, Now, Fault) ->
    case split(Field, Packet) of
        error ->
            {'FC_E_INDEX', Packet, Fault};
        {Before, Type, Order, Bytes, After} ->
            Value = decode(Type, Order, Bytes),
            case faultcheck_ref_fault:apply_value(Model, {Type, Value}, Run, Now, Fault) of
                {'FC_OK', Result, Next} ->
                    {'FC_OK', join(Before, encode(Type, Order, Result), After), Next};
                {unsure, _, Next} ->
                    {unsure, any, Next};
                {Code, _, Next} ->
                    {Code, Packet, Next}
            end
    end.

%% Length 0: up to the end.
split({Offset, bytes, Length}, Packet) when Offset + Length =< byte_size(Packet) ->
    Size = case Length of 0 -> byte_size(Packet) - Offset; _ -> Length end,
    cut(Offset, bytes, big, Size, Packet);
split({Offset, Type, Order}, Packet) when Type =/= bytes ->
    case size_of(Type) of
        Size when Offset + Size =< byte_size(Packet) -> cut(Offset, Type, Order, Size, Packet);
        _ -> error
    end;
split(_, _) ->
    error.

cut(Offset, Type, Order, Size, Packet) ->
    <<Before:Offset/binary, Bytes:Size/binary, After/binary>> = Packet,
    {Before, Type, Order, Bytes, After}.

size_of(bool) -> 1;
size_of(Type) -> faultcheck_ref_value:width(Type, 0) div 8.

decode(bytes, _, Bytes) -> Bytes;
decode(bool, _, <<0>>) -> 0;
decode(bool, _, _) -> 1;
decode(Type, little, Bytes) -> decode(Type, big, reversed(Bytes));
decode(Type, big, Bytes) ->
    Bits = bit_size(Bytes),
    case lists:member(Type, [i8, i16, i32, i64]) of
        true ->
            <<V:Bits/signed>> = Bytes,
            V;
        false ->
            <<V:Bits>> = Bytes,
            V
    end.

encode(_, _, V) when is_atom(V); is_tuple(V) -> any;
encode(bytes, _, Bytes) -> Bytes;
encode(bool, _, V) -> <<V>>;
encode(Type, big, V) -> <<V:(8 * size_of(Type))>>;
encode(Type, little, V) -> reversed(encode(Type, big, V)).

reversed(Bytes) -> list_to_binary(lists:reverse(binary_to_list(Bytes))).

join(_, any, _) -> any;
join(Before, Bytes, After) -> <<Before/binary, Bytes/binary, After/binary>>.

%% @doc LCM messages as Erlang maps, and back.
%%
%% The keys are named exactly as in lcm/*.lcm; a message is complete, there are no defaults:
%% ```
%% Bytes = replay_lcm:encode(risk, #{t_us => 0, run => 1, observer => -1, ellipses => []}),
%% {ok, risk, #{n := 0, ellipses := []}} = replay_lcm:decode(Bytes).
%% '''
%% Members that count (`n', `nseg', `npt' ...) are made from the lists; they may be left out. Arrays
%% are lists, arrays of arrays lists of lists. Text is UTF-8: binaries after decoding, any chardata
%% for encoding, without NUL. Flags (int8_t) are numbers. Reals that are not finite are the atoms
%% `inf', `neg_inf' and `nan'; a number too large for a float becomes infinite.
%%
%% encode/2 raises {replay, Line} for what is no such message. decode/1,2 take bytes of any origin.
-module(replay_lcm).

-export([encode/2, decode/1, decode/2, channel/1, channels/0]).
-export_type([type/0, message/0, line/0, real/0]).

-type type() :: replay_lcm_type:name().
-type message() :: #{atom() => term()}.
-type real() :: float() | inf | neg_inf | nan.
%% One line for people.
-type line() :: string().

%% ---- Channels ----

%% @doc The channel that a type of message goes through.
-spec channel(type()) -> binary().
channel(Type) ->
    {_, Channel} = lists:keyfind(Type, 1, channels()),
    Channel.

%% @doc Every type that has a channel of its own.
-spec channels() -> [{type(), binary()}].
channels() ->
    [
        {frame, <<"VIZ_FRAME">>},
        {risk, <<"VIZ_RISK">>},
        {world, <<"VIZ_WORLD">>},
        {ranges, <<"VIZ_RANGE">>},
        {faults, <<"VIZ_FAULTS">>},
        {event, <<"VIZ_EVENT">>},
        {case_info, <<"VIZ_CASE">>},
        {status, <<"VIZ_STATUS">>},
        {control, <<"VIZ_CONTROL">>},
        {ack, <<"VIZ_ACK">>}
    ].

%% ---- Encoding ----

%% @doc The message as LCM sends it: fingerprint, then the members in order, big endian.
-spec encode(type(), message()) -> binary().
encode(frame, Message) ->
    case replay_lcm_frame:encode(Message) of
        {ok, Bytes} -> Bytes;
        unusual -> generic(frame, Message)
    end;
encode(risk, Message) ->
    case replay_lcm_risk:encode(Message) of
        {ok, Bytes} -> Bytes;
        unusual -> generic(risk, Message)
    end;
encode(Type, Message) ->
    generic(Type, Message).

generic(Type, Message) ->
    #{fingerprint := Fingerprint} = Struct = replay_lcm_type:struct(Type),
    iolist_to_binary([<<Fingerprint:64>> | put_struct(Struct, Message, [atom_to_list(Type)])]).

%% Where: names from the outermost to the member at hand, the latest first.
put_struct(#{fields := Fields, counts := Counts}, Message, Where) when is_map(Message) ->
    [put_field(Field, Counts, Message, Where) || Field <- Fields];
put_struct(_, Other, Where) ->
    unfit(Where, "a map", Other).

put_field({Name, Base, []}, Counts, Message, Where) when is_map_key(Name, Counts) ->
    #{Name := Array} = Counts,
    put_value(Base, array_length(member(Array, Message, Where), [Array | Where]), [Name | Where]);
put_field({Name, Base, Dimensions}, _Counts, Message, Where) ->
    put_array(Dimensions, Base, member(Name, Message, Where), [Name | Where]).

member(Name, Message, Where) ->
    case Message of
        #{Name := Value} -> Value;
        #{} -> bad(Where, io_lib:format("`~ts' is missing", [Name]))
    end.

array_length(List, _Where) when is_list(List) -> length(List);
array_length(Other, Where) -> unfit(Where, "a list", Other).

put_array([], Base, Value, Where) ->
    put_value(Base, Value, Where);
put_array([Size | Rest], Base, List, Where) when is_list(List) ->
    is_atom(Size) orelse length(List) =:= Size orelse
        unfit(Where, io_lib:format("a list of ~b", [Size]), List),
    [put_array(Rest, Base, Value, Where) || Value <- List];
put_array(_, _, Other, Where) ->
    unfit(Where, "a list", Other).

put_value({struct, Name}, Value, Where) -> put_struct(replay_lcm_type:struct(Name), Value, Where);
put_value(string, Text, Where) -> put_text(Text, Where);
put_value(float, X, Where) -> put_real(32, X, Where);
put_value(double, X, Where) -> put_real(64, X, Where);
put_value(int8_t, N, Where) -> put_integer(8, N, Where);
put_value(int16_t, N, Where) -> put_integer(16, N, Where);
put_value(int32_t, N, Where) -> put_integer(32, N, Where);
put_value(int64_t, N, Where) -> put_integer(64, N, Where);
put_value(boolean, N, Where) -> put_integer(8, N, Where);
put_value(byte, N, _Where) when is_integer(N), N >= 0, N =< 255 -> N;
put_value(byte, Other, Where) -> unfit(Where, "0 to 255", Other).

put_integer(Bits, N, _Where) when is_integer(N), N >= -(1 bsl (Bits - 1)), N < 1 bsl (Bits - 1) ->
    <<N:Bits>>;
put_integer(Bits, Other, Where) ->
    unfit(Where, io_lib:format("an integer of ~b bits", [Bits]), Other).

put_real(Bits, X, Where) ->
    try replay_lcm_real:bytes(Bits, X)
    catch error:function_clause -> unfit(Where, "a number, inf, neg_inf or nan", X)
    end.

put_text(Text, Where) ->
    Bytes = text_bytes(Text, Where),
    binary:match(Bytes, <<0>>) =:= nomatch orelse unfit(Where, "text without NUL", Text),
    [<<(byte_size(Bytes) + 1):32>>, Bytes, 0].

%% What was decoded may be no UTF-8 and still goes out as it came.
text_bytes(Text, _Where) when is_binary(Text) ->
    Text;
text_bytes(Text, Where) ->
    try unicode:characters_to_binary(Text) of
        Bytes when is_binary(Bytes) -> Bytes;
        _ -> unfit(Where, "text", Text)
    catch
        error:badarg -> unfit(Where, "text", Text)
    end.

-spec unfit([atom() | string()], iodata(), term()) -> no_return().
unfit(Where, Expected, Value) ->
    bad(Where, io_lib:format("expected ~ts, not ~0P", [Expected, Value, 12])).

-spec bad([atom() | string()], iodata()) -> no_return().
bad(Where, What) ->
    Path = lists:join(".", [io_lib:format("~ts", [Name]) || Name <- lists:reverse(Where)]),
    error({replay, lists:flatten([Path, ": ", What])}).

%% ---- Decoding ----

%% @doc A message of whatever type its fingerprint says.
-spec decode(binary()) -> {ok, type(), message()} | {error, line()}.
decode(<<Fingerprint:64, _/binary>> = Bytes) ->
    case replay_lcm_type:named(Fingerprint) of
        {ok, Type} ->
            case decode(Type, Bytes) of
                {ok, Message} -> {ok, Type, Message};
                {error, _} = Error -> Error
            end;
        error ->
            {error, lists:flatten(io_lib:format("no type has the fingerprint ~16.16.0b: "
                                                "sender or receiver is of another version",
                                                [Fingerprint]))}
    end;
decode(Bytes) when is_binary(Bytes) ->
    {error, "shorter than a fingerprint"}.

%% @doc A message that must be of the type given, to its last byte.
-spec decode(type(), binary()) -> {ok, message()} | {error, line()}.
decode(Type, Bytes) ->
    #{fingerprint := Expected} = Struct = replay_lcm_type:struct(Type),
    case Bytes of
        <<Expected:64, Body/binary>> ->
            body(Type, Struct, Body);
        <<Found:64, _/binary>> ->
            {error, lists:flatten(io_lib:format("~ts: type mismatch, fingerprint ~16.16.0b "
                                                "instead of ~16.16.0b", [Type, Found, Expected]))};
        _ ->
            {error, lists:flatten(io_lib:format("~ts: shorter than a fingerprint", [Type]))}
    end.

body(frame, Struct, Body) ->
    case replay_lcm_frame:decode(Body) of
        {ok, _} = Ok -> Ok;
        unusual -> generic_body(Struct, Body)
    end;
body(_, Struct, Body) ->
    generic_body(Struct, Body).

generic_body(#{name := Type} = Struct, Body) ->
    try get_struct(Struct, Body, [Type]) of
        {Message, <<>>} -> {ok, Message};
        {_, Rest} -> {error, wrong([Type], "~b bytes too many", [byte_size(Rest)])}
    catch
        throw:{bad_message, Line} -> {error, Line}
    end.

get_struct(#{fields := Fields}, Bytes, Where) ->
    lists:foldl(
        fun({Name, Base, Dimensions}, {Message, Rest}) ->
            Sizes = [size_of(D, Message) || D <- Dimensions],
            {Value, More} = get_array(Sizes, Base, Rest, [Name | Where]),
            {Message#{Name => Value}, More}
        end,
        {#{}, Bytes},
        Fields
    ).

size_of(Size, _Message) when is_integer(Size) -> Size;
size_of(Count, Message) -> maps:get(Count, Message).

get_array([], Base, Bytes, Where) ->
    get_value(Base, Bytes, Where);
get_array([Size | Rest] = Sizes, Base, Bytes, Where) ->
    Least = lists:foldl(fun erlang:'*'/2, replay_lcm_type:min_size(Base), Sizes),
    Size >= 0 andalso Least =< byte_size(Bytes) orelse
        refuse(Where, "~b of them cannot be in ~b bytes", [Size, byte_size(Bytes)]),
    get_items(Size, Rest, Base, Bytes, Where, []).

get_items(0, _, _, Bytes, _, Items) ->
    {lists:reverse(Items), Bytes};
get_items(N, Sizes, Base, Bytes, Where, Items) ->
    {Item, Rest} = get_array(Sizes, Base, Bytes, Where),
    get_items(N - 1, Sizes, Base, Rest, Where, [Item | Items]).

get_value({struct, Name}, Bytes, Where) ->
    get_struct(replay_lcm_type:struct(Name), Bytes, Where);
get_value(int8_t, <<N:8/signed, Rest/binary>>, _) -> {N, Rest};
get_value(int16_t, <<N:16/signed, Rest/binary>>, _) -> {N, Rest};
get_value(int32_t, <<N:32/signed, Rest/binary>>, _) -> {N, Rest};
get_value(int64_t, <<N:64/signed, Rest/binary>>, _) -> {N, Rest};
get_value(boolean, <<N:8/signed, Rest/binary>>, _) -> {N, Rest};
get_value(byte, <<N, Rest/binary>>, _) -> {N, Rest};
get_value(float, <<X:4/binary, Rest/binary>>, _) -> {replay_lcm_real:number(X), Rest};
get_value(double, <<X:8/binary, Rest/binary>>, _) -> {replay_lcm_real:number(X), Rest};
get_value(string, <<Length:32/signed, Rest/binary>>, Where) -> get_text(Length, Rest, Where);
get_value(Base, Bytes, Where) ->
    refuse(Where, "~ts does not fit in ~b bytes", [Base, byte_size(Bytes)]).

%% The length counts the NUL at the end.
get_text(Length, Bytes, Where) when Length >= 1, Length =< byte_size(Bytes) ->
    Size = Length - 1,
    <<Text:Size/binary, End, Rest/binary>> = Bytes,
    End =:= 0 andalso binary:match(Text, <<0>>) =:= nomatch orelse
        refuse(Where, "text of ~b bytes without a NUL at its end only", [Length]),
    {binary:copy(Text), Rest};
get_text(Length, Bytes, Where) ->
    refuse(Where, "text of ~b bytes cannot be in ~b", [Length, byte_size(Bytes)]).

-spec refuse([atom()], string(), [term()]) -> no_return().
refuse(Where, Format, Args) ->
    throw({bad_message, wrong(Where, Format, Args)}).

wrong(Where, Format, Args) ->
    Path = lists:join(".", [atom_to_list(Name) || Name <- lists:reverse(Where)]),
    lists:flatten([Path, ": " | io_lib:format(Format, Args)]).

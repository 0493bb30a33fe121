%% @doc LCM's UDP packets: a message in one, or in fragments when it is larger, and back.
%%
%% Received bytes are hostile: every count, offset and size is checked before anything is kept.
%% At most 64 messages are unfinished at a time (the oldest one goes), of at most 16 MiB each, and
%% together they hold at most 64 MiB.
-module(replay_lcm_packet).

-export([packets/3, new/0, receive_packet/3, unfinished/1]).
-export_type([from/0, reassembly/0, result/0]).

-define(SMALL, 16#4c433032).
-define(FRAGMENT, 16#4c433033).
%% Largest UDP payload over IPv4, less our header.
-define(SMALL_ROOM, (65507 - 8)).
-define(FRAGMENT_ROOM, (65507 - 20)).
-define(CHANNEL_MAX, 63).
-define(MESSAGE_MAX, (16 bsl 20)).
-define(UNFINISHED_MAX, 64).
-define(HELD_MAX, (64 bsl 20)).

%% Address and port of the sender, or whatever tells senders apart.
-type from() :: term().
-type key() :: {from(), Sequence :: non_neg_integer()}.
-record(partial, {
    age :: integer(),
    size :: non_neg_integer(),
    count :: pos_integer(),
    held = 0 :: non_neg_integer(),
    channel = none :: none | binary(),
    %% number => {offset, data}
    parts = #{} :: #{non_neg_integer() => {non_neg_integer(), binary()}}
}).
-record(reassembly, {
    clock = 0 :: non_neg_integer(),
    held = 0 :: non_neg_integer(),
    partials = #{} :: #{key() => #partial{}}
}).
-opaque reassembly() :: #reassembly{}.
-type result() :: {message, Channel :: binary(), Payload :: binary()} | more
                | {error, replay_lcm:line()}.

%% ---- Sending ----

%% @doc The packets of one message, each to be sent as it is. The sequence number is the sender's,
%% one more with each message (modulo 2^32). The payload begins with its fingerprint.
-spec packets(Sequence :: non_neg_integer(), Channel :: binary(), Payload :: binary()) ->
    {ok, [iodata(), ...]} | {error, replay_lcm:line()}.
packets(Sequence, Channel, Payload) ->
    case channel_error(Channel) of
        none when byte_size(Payload) > ?MESSAGE_MAX ->
            {error, say("message of ~b bytes: at most ~b", [byte_size(Payload), ?MESSAGE_MAX])};
        none when byte_size(Channel) + 1 + byte_size(Payload) =< ?SMALL_ROOM ->
            {ok, [[<<?SMALL:32, Sequence:32>>, Channel, 0, Payload]]};
        none ->
            {ok, fragments(Sequence, Channel, Payload)};
        Line ->
            {error, Line}
    end.

fragments(Sequence, Channel, Payload) ->
    First = ?FRAGMENT_ROOM - byte_size(Channel) - 1,
    Count = 1 + (byte_size(Payload) - First + ?FRAGMENT_ROOM - 1) div ?FRAGMENT_ROOM,
    [fragment(Number, First, Count, Sequence, Channel, Payload)
     || Number <- lists:seq(0, Count - 1)].

fragment(Number, First, Count, Sequence, Channel, Payload) ->
    {Offset, Room, Before} = case Number of
        0 -> {0, First, [Channel, 0]};
        _ -> {First + (Number - 1) * ?FRAGMENT_ROOM, ?FRAGMENT_ROOM, []}
    end,
    Size = byte_size(Payload),
    Part = binary:part(Payload, Offset, min(Room, Size - Offset)),
    [<<?FRAGMENT:32, Sequence:32, Size:32, Offset:32, Number:16, Count:16>>, Before, Part].

%% ---- Receiving ----

%% @doc Nothing received so far.
-spec new() -> reassembly().
new() -> #reassembly{}.

%% @doc How many messages wait for fragments.
-spec unfinished(reassembly()) -> non_neg_integer().
unfinished(#reassembly{partials = Partials}) -> map_size(Partials).

%% @doc Takes one packet: a message when it is whole; `more' for a fragment that leaves its message
%% unfinished, or that came before; a line for what is wrong, after which the message is forgotten.
-spec receive_packet(from(), binary(), reassembly()) -> {result(), reassembly()}.
receive_packet(_From, <<?SMALL:32, _Sequence:32, Rest/binary>>, R) ->
    case split_channel(Rest) of
        {ok, Channel, Payload} -> {{message, Channel, Payload}, R};
        {error, Line} -> {{error, Line}, R}
    end;
receive_packet(
    From,
    <<?FRAGMENT:32, Sequence:32, Size:32, Offset:32, Number:16, Count:16, Data/binary>>,
    R
) ->
    case fragment_data(Size, Offset, Number, Count, Data) of
        {ok, Channel, Part} ->
            join({From, Sequence}, {Size, Count}, {Number, Offset, Channel, Part}, R);
        {error, Line} ->
            {{error, Line}, R}
    end;
receive_packet(_From, Packet, R) ->
    {{error, say("no LCM packet: ~b bytes", [byte_size(Packet)])}, R}.

split_channel(Bytes) ->
    Scope = {0, min(byte_size(Bytes), ?CHANNEL_MAX + 1)},
    case binary:match(Bytes, <<0>>, [{scope, Scope}]) of
        {Length, 1} when Length > 0 ->
            <<Channel:Length/binary, 0, Payload/binary>> = Bytes,
            {ok, Channel, Payload};
        _ ->
            {error, say("no channel name of 1 to ~b bytes", [?CHANNEL_MAX])}
    end.

fragment_data(Size, _, _, _, _) when Size > ?MESSAGE_MAX ->
    {error, say("fragment of a message of ~b bytes: at most ~b", [Size, ?MESSAGE_MAX])};
fragment_data(_, _, Number, Count, _) when Number >= Count ->
    {error, say("fragment ~b of ~b", [Number, Count])};
fragment_data(Size, Offset, 0, _Count, Data) ->
    case split_channel(Data) of
        {ok, Channel, Part} when Offset =:= 0, byte_size(Part) =< Size -> {ok, Channel, Part};
        {ok, _, _} -> {error, say("the first fragment does not fit in ~b bytes", [Size])};
        {error, _} = Error -> Error
    end;
fragment_data(_, _, _, _, <<>>) ->
    {error, "fragment without data"};
fragment_data(Size, Offset, _Number, _Count, Data) when Offset + byte_size(Data) =< Size ->
    {ok, none, Data};
fragment_data(Size, Offset, _, _, Data) ->
    {error, say("fragment of ~b bytes at ~b of ~b", [byte_size(Data), Offset, Size])}.

join(Key, {Size, Count}, Fragment, R0) ->
    {Partial, R} = find(Key, Size, Count, R0),
    case Partial of
        #partial{size = Size, count = Count} ->
            add(Key, Fragment, Partial, R);
        _ ->
            {{error, "fragments of one message disagree on its size"}, forget(Key, R)}
    end.

find(Key, Size, Count, #reassembly{partials = Partials, clock = Clock} = R) ->
    case Partials of
        #{Key := Partial} -> {Partial, R};
        #{} -> {#partial{age = Clock, size = Size, count = Count}, R#reassembly{clock = Clock + 1}}
    end.

add(Key, {Number, Offset, Channel, Part}, #partial{parts = Parts} = Partial, R) ->
    case Parts of
        #{Number := {Offset, Part}} ->
            {more, R};
        #{Number := _} ->
            {{error, say("fragment ~b came twice, different", [Number])}, forget(Key, R)};
        #{} ->
            keep(Key, Partial#partial{
                held = Partial#partial.held + byte_size(Part),
                channel = case Number of 0 -> Channel; _ -> Partial#partial.channel end,
                parts = Parts#{Number => {Offset, binary:copy(Part)}}
            }, forget(Key, R))
    end.

%% The message is not among the unfinished ones here.
keep(_Key, #partial{held = Held, size = Size}, R) when Held > Size ->
    {{error, say("fragments overlap in a message of ~b bytes", [Size])}, R};
keep(_Key, #partial{count = Count, parts = Parts} = Partial, R) when map_size(Parts) =:= Count ->
    {whole(Partial), R};
keep(Key, Partial, #reassembly{partials = Partials} = R) ->
    Kept = R#reassembly{
        held = R#reassembly.held + cost(Partial),
        partials = Partials#{Key => Partial}
    },
    {more, make_room(Kept)}.

whole(#partial{channel = Channel, size = Size, parts = Parts}) ->
    case adjacent(lists:sort(maps:to_list(Parts)), 0, []) of
        {Size, Data} -> {message, Channel, Data};
        _ -> {error, say("fragments leave gaps in a message of ~b bytes", [Size])}
    end.

%% The data of fragments that follow one another, and where they end.
adjacent([{_Number, {At, Part}} | Rest], At, Before) ->
    adjacent(Rest, At + byte_size(Part), [Before, Part]);
adjacent([], End, Data) ->
    {End, iolist_to_binary(Data)};
adjacent(_, _, _) ->
    gap.

forget(Key, #reassembly{held = Held, partials = Partials} = R) ->
    case maps:take(Key, Partials) of
        {Partial, Rest} -> R#reassembly{held = Held - cost(Partial), partials = Rest};
        error -> R
    end.

%% Many tiny fragments cost more than what is in them.
cost(#partial{held = Held, parts = Parts}) -> Held + 128 * map_size(Parts).

%% The oldest go first.
make_room(#reassembly{held = Held, partials = Partials} = R) when
    map_size(Partials) > ?UNFINISHED_MAX; Held > ?HELD_MAX
->
    {_, Oldest} = lists:min([{Age, Key} || {Key, #partial{age = Age}} <- maps:to_list(Partials)]),
    make_room(forget(Oldest, R));
make_room(R) ->
    R.

channel_error(Channel) ->
    case binary:match(Channel, <<0>>) of
        nomatch when byte_size(Channel) >= 1, byte_size(Channel) =< ?CHANNEL_MAX -> none;
        _ -> say("channel ~0p: 1 to ~b bytes, no NUL", [Channel, ?CHANNEL_MAX])
    end.

say(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

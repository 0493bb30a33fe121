%% @doc MCAP files (mcap.dev, format version 0): messages in chunks, with the index behind them that
%% lets a viewer jump. Nothing is compressed.
%%
%% ```
%% Bytes = replay_mcap:format(#{
%%     schemas => [{1, <<"foxglove.Log">>, Schema}],
%%     channels => [{1, 1, <<"/log">>}],
%%     messages => [{1, 0, <<"{...}">>}]
%% }).
%% '''
-module(replay_mcap).

-export([format/1]).
-export_type([content/0]).

-type id() :: 0..65535.
-type content() :: #{
    %% JSON schemas
    schemas := [{id(), Name :: binary(), Schema :: binary()}],
    channels := [{id(), Schema :: id(), Topic :: binary()}],
    %% in order of time; JSON
    messages := [{Channel :: id(), Ns :: non_neg_integer(), binary()}]
}.

-define(MAGIC, 16#89, "MCAP0\r\n").
-define(CHUNK_BYTES, (1 bsl 20)).

-define(HEADER, 16#01).
-define(FOOTER, 16#02).
-define(SCHEMA, 16#03).
-define(CHANNEL, 16#04).
-define(MESSAGE, 16#05).
-define(CHUNK, 16#06).
-define(MESSAGE_INDEX, 16#07).
-define(CHUNK_INDEX, 16#08).
-define(STATISTICS, 16#0B).
-define(SUMMARY_OFFSET, 16#0E).
-define(DATA_END, 16#0F).

%% A chunk that is being filled: its records newest first, and for each channel the places of its
%% messages, newest first.
-record(chunk, {
    records = [] :: [iodata()],
    bytes = 0 :: non_neg_integer(),
    times = [] :: [non_neg_integer()],
    places = #{} :: #{id() => [{Ns :: non_neg_integer(), Offset :: non_neg_integer()}]}
}).

%% @doc The whole file.
-spec format(content()) -> binary().
format(#{schemas := Schemas, channels := Channels, messages := Messages}) ->
    Definitions = [schema(S) || S <- Schemas] ++ [channel(C) || C <- Channels],
    Start = iolist_to_binary([?MAGIC, record(?HEADER, [text(<<>>), text(<<"FaultCheck">>)])]),
    Chunks = chunks(Messages, Definitions),
    {Placed, DataEnds} = lists:mapfoldl(fun placed/2, byte_size(Start), Chunks),
    DataEnd = record(?DATA_END, <<0:32>>),
    SummaryAt = DataEnds + iolist_size(DataEnd),
    Groups = [
        {?SCHEMA, [schema(S) || S <- Schemas]},
        {?CHANNEL, [channel(C) || C <- Channels]},
        {?STATISTICS, [statistics(Schemas, Channels, Messages, length(Chunks))]},
        {?CHUNK_INDEX, [Index || {_, Index} <- Placed]}
    ],
    {Summary, Offsets, OffsetsAt} = summary(Groups, SummaryAt),
    iolist_to_binary([
        Start, [Bytes || {Bytes, _} <- Placed], DataEnd, Summary, Offsets,
        footer(SummaryAt, OffsetsAt, [Summary, Offsets]), ?MAGIC
    ]).

%% ---- records ----------------------------------------------------------------------------------

record(Opcode, Content) -> [Opcode, <<(iolist_size(Content)):64/little>>, Content].

text(Text) -> [<<(byte_size(Text)):32/little>>, Text].

%% A length in bytes goes in front of lists and maps.
counted(Content) -> [<<(iolist_size(Content)):32/little>>, Content].

schema({Id, Name, Schema}) ->
    record(?SCHEMA, [<<Id:16/little>>, text(Name), text(<<"jsonschema">>), text(Schema)]).

channel({Id, Schema, Topic}) ->
    Metadata = counted([]),
    record(?CHANNEL, [
        <<Id:16/little, Schema:16/little>>, text(Topic), text(<<"json">>), Metadata
    ]).

%% The CRC covers the summary and the footer up to it.
footer(SummaryAt, OffsetsAt, Before) ->
    Length = 8 + 8 + 4,
    Head = <<?FOOTER, Length:64/little, SummaryAt:64/little, OffsetsAt:64/little>>,
    [Head, <<(erlang:crc32([Before, Head])):32/little>>].

statistics(Schemas, Channels, Messages, Chunks) ->
    {First, Last} = span([Ns || {_, Ns, _} <- Messages]),
    Counts = lists:foldl(
        fun({Channel, _, _}, Sums) -> maps:update_with(Channel, fun(N) -> N + 1 end, 1, Sums) end,
        #{},
        Messages
    ),
    record(?STATISTICS, [
        <<(length(Messages)):64/little, (length(Schemas)):16/little>>,
        <<(length(Channels)):32/little, 0:32, 0:32, Chunks:32/little>>,
        <<First:64/little, Last:64/little>>,
        counted([<<Channel:16/little, N:64/little>> || {Channel, N} <- sorted(Counts)])
    ]).

span([]) -> {0, 0};
span(Times) -> {lists:min(Times), lists:max(Times)}.

sorted(Map) -> lists:sort(maps:to_list(Map)).

summary(Groups, At) ->
    Filled = [{Opcode, Records} || {Opcode, [_ | _] = Records} <- Groups],
    {Offsets, Behind} = lists:mapfoldl(
        fun({Opcode, Records}, Place) ->
            Size = iolist_size(Records),
            {record(?SUMMARY_OFFSET, <<Opcode, Place:64/little, Size:64/little>>), Place + Size}
        end,
        At,
        Filled
    ),
    {[Records || {_, Records} <- Filled], Offsets, Behind}.

%% ---- chunks -----------------------------------------------------------------------------------

%% The definitions stand in the first one.
chunks(Messages, Definitions) ->
    First = lists:foldl(fun add_record/2, #chunk{}, Definitions),
    filled(lists:zip(lists:seq(0, length(Messages) - 1), Messages), First).

filled([], Chunk) ->
    [Chunk];
filled(Messages, #chunk{bytes = Bytes} = Chunk) when Bytes >= ?CHUNK_BYTES ->
    [Chunk | filled(Messages, #chunk{})];
filled([{Number, {Channel, Ns, Data}} | Rest], #chunk{times = Times, places = Places} = Chunk) ->
    #chunk{bytes = Offset} = Chunk,
    Message = record(?MESSAGE, [
        <<Channel:16/little, Number:32/little, Ns:64/little, Ns:64/little>>, Data
    ]),
    Here = [{Ns, Offset} | maps:get(Channel, Places, [])],
    filled(Rest, add_record(Message, Chunk#chunk{
        times = [Ns | Times], places = Places#{Channel => Here}
    })).

add_record(Record, #chunk{records = Records, bytes = Bytes} = Chunk) ->
    Chunk#chunk{records = [Record | Records], bytes = Bytes + iolist_size(Record)}.

%% A chunk at a place in the file with its indexes, and its entry in the index of chunks.
placed(#chunk{records = Newest, bytes = Bytes, times = Times, places = Places}, At) ->
    Records = lists:reverse(Newest),
    {First, Last} = span(Times),
    Compression = text(<<>>),
    Chunk = record(?CHUNK, [
        <<First:64/little, Last:64/little, Bytes:64/little>>,
        <<(erlang:crc32(Records)):32/little>>, Compression, <<Bytes:64/little>>, Records
    ]),
    Length = iolist_size(Chunk),
    {Indexes, {Offsets, Behind}} = lists:mapfoldl(
        fun({Channel, Entries}, {Offsets, Place}) ->
            Index = message_index(Channel, lists:reverse(Entries)),
            {Index, {[<<Channel:16/little, Place:64/little>> | Offsets],
                     Place + iolist_size(Index)}}
        end,
        {[], At + Length},
        sorted(Places)
    ),
    Entry = record(?CHUNK_INDEX, [
        <<First:64/little, Last:64/little, At:64/little, Length:64/little>>,
        counted(lists:reverse(Offsets)), <<(Behind - At - Length):64/little>>,
        Compression, <<Bytes:64/little, Bytes:64/little>>
    ]),
    {{[Chunk, Indexes], Entry}, Behind}.

message_index(Channel, Entries) ->
    Pairs = [<<Ns:64/little, Offset:64/little>> || {Ns, Offset} <- Entries],
    record(?MESSAGE_INDEX, [<<Channel:16/little>>, counted(Pairs)]).

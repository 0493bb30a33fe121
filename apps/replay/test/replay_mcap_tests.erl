-module(replay_mcap_tests).
-include_lib("eunit/include/eunit.hrl").

%% Byte by byte from the format's description; a real file is read by another library in
%% visualizer/codec/exports.test.ts.

-define(MAGIC, 16#89, "MCAP", $0, $\r, $\n).

content() ->
    #{
        schemas => [{1, <<"S">>, <<"{}">>}],
        channels => [{2, 1, <<"/t">>}],
        messages => [{2, 3, <<"1">>}, {2, 5, <<"22">>}]
    }.

begins_and_ends_as_every_mcap_file_test() ->
    Magic = <<?MAGIC>>,
    File = replay_mcap:format(content()),
    ?assertEqual(Magic, binary:part(File, 0, 8)),
    ?assertEqual(Magic, binary:part(File, byte_size(File) - 8, 8)).

%% Opcode and length of each record up to the second magic.
records(Bytes) -> records(Bytes, []).
records(<<?MAGIC>>, Found) -> lists:reverse(Found);
records(<<Op, L:64/little, Content:L/binary, Rest/binary>>, Found) ->
    records(Rest, [{Op, Content} | Found]).

has_the_records_in_their_order_test() ->
    <<_:8/binary, Rest/binary>> = replay_mcap:format(content()),
    %% header, chunk, message index, end of data; schema, channel, statistics, chunk index; offsets
    ?assertEqual(
        [16#01, 16#06, 16#07, 16#0F, 16#03, 16#04, 16#0B, 16#08, 16#0E, 16#0E, 16#0E, 16#0E, 16#02],
        [Op || {Op, _} <- records(Rest)]
    ).

a_chunk_holds_definitions_and_messages_test() ->
    <<_:8/binary, Rest/binary>> = replay_mcap:format(content()),
    {16#06, Chunk} = lists:keyfind(16#06, 1, records(Rest)),
    <<3:64/little, 5:64/little, Size:64/little, Crc:32/little, 0:32, Size:64/little,
        Records:Size/binary>> = Chunk,
    ?assertEqual(erlang:crc32(Records), Crc),
    ?assertEqual(
        [
            {16#03,
                <<1:16/little, 1:32/little, "S", 10:32/little, "jsonschema", 2:32/little, "{}">>},
            {16#04, <<2:16/little, 1:16/little, 2:32/little, "/t", 4:32/little, "json", 0:32>>},
            {16#05, <<2:16/little, 0:32/little, 3:64/little, 3:64/little, "1">>},
            {16#05, <<2:16/little, 1:32/little, 5:64/little, 5:64/little, "22">>}
        ],
        records(<<Records/binary, ?MAGIC>>)
    ).

indexes_point_to_what_they_name_test() ->
    File = replay_mcap:format(content()),
    <<_:8/binary, Rest/binary>> = File,
    {16#08, Index} = lists:keyfind(16#08, 1, records(Rest)),
    <<3:64/little, 5:64/little, At:64/little, Length:64/little, 10:32/little, 2:16/little,
        IndexAt:64/little, _/binary>> = Index,
    ?assertMatch(<<16#06, _/binary>>, binary:part(File, At, Length)),
    ?assertEqual(At + Length, IndexAt),
    <<_:IndexAt/binary, 16#07, _:64, 2:16/little, 32:32/little, 3:64/little, First:64/little,
        5:64/little, Second:64/little, _/binary>> = File,
    %% behind the chunk's own head
    Records = At + 9 + 8 + 8 + 8 + 4 + 4 + 8,
    [
        ?assertMatch(<<16#05, _/binary>>, binary:part(File, Records + Offset, 1))
     || Offset <- [First, Second]
    ].

large_contents_go_into_several_chunks_test() ->
    Data = binary:copy(<<"x">>, 400000),
    Messages = [{2, T, Data} || T <- lists:seq(1, 6)],
    <<_:8/binary, Rest/binary>> = replay_mcap:format((content())#{messages := Messages}),
    Chunks = [Chunk || {16#06, Chunk} <- records(Rest)],
    ?assertMatch([<<1:64/little, 3:64/little, _/binary>>, <<4:64/little, 6:64/little, _/binary>>],
                 Chunks).

nothing_to_tell_is_a_file_too_test() ->
    <<_:8/binary, Rest/binary>> = replay_mcap:format((content())#{messages := []}),
    {16#0B, <<0:64, 1:16/little, 1:32/little, _/binary>>} = lists:keyfind(16#0B, 1, records(Rest)).

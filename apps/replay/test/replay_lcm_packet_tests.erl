-module(replay_lcm_packet_tests).
-include_lib("eunit/include/eunit.hrl").

-define(FROM, {{127, 0, 0, 1}, 4000}).

feed(Packets) -> feed(Packets, replay_lcm_packet:new(), []).

feed([], R, Results) ->
    {lists:reverse(Results), R};
feed([Packet | Rest], R0, Results) ->
    {Result, R} = replay_lcm_packet:receive_packet(?FROM, iolist_to_binary(Packet), R0),
    feed(Rest, R, [Result | Results]).

payload(Size) -> << <<(N rem 251)>> || N <- lists:seq(1, Size) >>.

packets(Size) ->
    {ok, Packets} = replay_lcm_packet:packets(9, <<"C">>, payload(Size)),
    [iolist_to_binary(P) || P <- Packets].

%% ---- liblcm's packets ----

packets_of_liblcm_are_read_test() ->
    {Results, R} = feed(replay_lcm_peer:packets()),
    {Whole, [more, {message, Channel, Big}]} = lists:split(10, Results),
    ?assertEqual([{message, C, replay_lcm_peer:bytes(B)}
                  || #{<<"channel">> := C, <<"bytes">> := B}
                         <- lists:sublist(replay_lcm_peer:messages(), 10)], Whole),
    ?assertEqual(<<"VIZ_FRAME">>, Channel),
    {ok, frame, #{objects := Objects}} = replay_lcm:decode(Big),
    ?assertEqual(lists:seq(0, 999), [Id || #{id := Id} <- Objects]),
    ?assertEqual(0, replay_lcm_packet:unfinished(R)).

packets_are_those_of_liblcm_test() ->
    Theirs = replay_lcm_peer:packets(),
    {Results, _} = feed(Theirs),
    Messages = [{C, P} || {message, C, P} <- Results],
    Ours = [iolist_to_binary(Packet)
            || {Sequence, {C, P}} <- lists:zip(lists:seq(0, 10), Messages),
               {ok, Packets} <- [replay_lcm_packet:packets(Sequence, C, P)],
               Packet <- Packets],
    ?assertEqual(Theirs, Ours).

%% ---- Sizes ----

a_message_is_split_just_above_the_largest_packet_test() ->
    %% 65507 bytes are the most that UDP over IPv4 carries; header 8, channel "C" and NUL 2
    ?assertMatch([_], packets(65507 - 10)),
    ?assertEqual(65507, byte_size(hd(packets(65507 - 10)))),
    ?assertMatch([_, _], packets(65507 - 9)).

what_cannot_be_sent_is_one_line_test_() ->
    [?_assertEqual({error, Line}, replay_lcm_packet:packets(0, Channel, Payload))
     || {Line, Channel, Payload} <- [
            {"channel <<>>: 1 to 63 bytes, no NUL", <<>>, <<>>},
            {"channel <<97,0,98>>: 1 to 63 bytes, no NUL", <<"a", 0, "b">>, <<>>},
            {"message of 16777217 bytes: at most 16777216", <<"C">>, <<0:16777217/unit:8>>}
        ]].

sizes_around_the_limits_come_back_test_() ->
    [?_assertMatch({message, <<"C">>, _}, lists:last(element(1, feed(packets(Size)))))
     || Size <- [0, 1, 65497, 65498, 2 * 65487 - 2, 2 * 65487 - 1, 300000]].

%% ---- Fragments on their way ----

any_order_is_put_right_test() ->
    Expected = {message, <<"C">>, payload(300000)},
    [begin
         {Results, R} = feed(Order),
         ?assertEqual([more, more, more, more, Expected], Results),
         ?assertEqual(0, replay_lcm_packet:unfinished(R))
     end || Order <- [lists:reverse(packets(300000)),
                      tl(packets(300000)) ++ [hd(packets(300000))]]].

a_repeated_fragment_changes_nothing_test() ->
    [A, B, C] = packets(150000),
    ?assertMatch({[more, more, more, more, {message, _, _}], _}, feed([A, A, B, B, C])).

a_lost_fragment_leaves_it_unfinished_test() ->
    [A, _, C] = packets(150000),
    {[more, more], R} = feed([A, C]),
    ?assertEqual(1, replay_lcm_packet:unfinished(R)).

senders_are_kept_apart_test() ->
    [A, B] = packets(100000),
    Other = {{127, 0, 0, 1}, 4001},
    {more, R1} = replay_lcm_packet:receive_packet(?FROM, A, replay_lcm_packet:new()),
    {more, R2} = replay_lcm_packet:receive_packet(Other, B, R1),
    ?assertEqual(2, replay_lcm_packet:unfinished(R2)).

at_most_64_are_unfinished_test() ->
    First = fun(N) ->
        {ok, [Packet | _]} = replay_lcm_packet:packets(N, <<"C">>, payload(70000)),
        iolist_to_binary(Packet)
    end,
    {_, R} = feed([First(N) || N <- lists:seq(1, 100)]),
    ?assertEqual(64, replay_lcm_packet:unfinished(R)),
    %% the oldest has gone: its second half is a new beginning; the newest one is completed
    {ok, [_, Second]} = replay_lcm_packet:packets(100, <<"C">>, payload(70000)),
    {Result, _} = replay_lcm_packet:receive_packet(?FROM, iolist_to_binary(Second), R),
    ?assertEqual({message, <<"C">>, payload(70000)}, Result).

unfinished_messages_hold_at_most_64_mib_test() ->
    Fragment = fun(Sequence, Number) ->
        Data = binary:copy(<<0>>, 65000),
        <<16#4c433033:32, Sequence:32, (16 bsl 20):32, (Number * 65000):32, Number:16, 300:16,
          Data/binary>>
    end,
    {_, R} = feed([Fragment(S, N) || S <- lists:seq(1, 6), N <- lists:seq(1, 200)]),
    %% 200 * 65000 bytes each: five of them fit in 64 MiB, less what they cost beside
    ?assertEqual(5, replay_lcm_packet:unfinished(R)).

fragment(Size, Offset, Number, Count, Data) ->
    <<16#4c433033:32, 5:32, Size:32, Offset:32, Number:16, Count:16, Data/binary>>.

hostile_packets_are_one_line_test_() ->
    First = fragment(10, 0, 0, 2, <<"C", 0, "12345">>),
    [?_assertMatch({error, Line}, lists:last(element(1, feed(Packets)))) || {Line, Packets} <- [
        {"no LCM packet: 0 bytes", [<<>>]},
        {"no LCM packet: 9 bytes", [<<"anything!">>]},
        {"no channel name of 1 to 63 bytes", [<<16#4c433032:32, 0:32, "channel">>]},
        {"no channel name of 1 to 63 bytes", [<<16#4c433032:32, 0:32, 0, 1, 2>>]},
        {"no channel name of 1 to 63 bytes",
         [[<<16#4c433032:32, 0:32>>, lists:duplicate(64, $c), 0]]},
        {"fragment of a message of 16777217 bytes: at most 16777216",
         [fragment(16777217, 0, 1, 2, <<"x">>)]},
        {"fragment 2 of 2", [fragment(10, 5, 2, 2, <<"x">>)]},
        {"fragment 0 of 0", [fragment(10, 0, 0, 0, <<"C", 0>>)]},
        {"fragment without data", [fragment(10, 5, 1, 2, <<>>)]},
        {"fragment of 6 bytes at 5 of 10", [fragment(10, 5, 1, 2, <<"678901">>)]},
        {"fragment of 1 bytes at 4294967295 of 10", [fragment(10, 16#ffffffff, 1, 2, <<"6">>)]},
        {"the first fragment does not fit in 4 bytes",
         [fragment(4, 0, 0, 2, <<"C", 0, "12345">>)]},
        {"the first fragment does not fit in 10 bytes", [fragment(10, 1, 0, 2, <<"C", 0, "1">>)]},
        {"fragments of one message disagree on its size",
         [First, fragment(11, 5, 1, 2, <<"67890">>)]},
        {"fragment 0 came twice, different",
         [First, fragment(10, 0, 0, 2, <<"C", 0, "1234X">>)]},
        {"fragments overlap in a message of 10 bytes",
         [First, fragment(10, 4, 1, 2, <<"567890">>)]},
        {"fragments leave gaps in a message of 10 bytes",
         [First, fragment(10, 6, 1, 2, <<"7890">>)]}
    ]].

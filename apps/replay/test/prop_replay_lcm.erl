%% @doc The LCM codec against itself, against liblcm, and against a network that loses, repeats and
%% damages. The peer (lcm_peer) is C++ made by lcm-gen.
-module(prop_replay_lcm).
-include_lib("proper/include/proper.hrl").

-export([prop_every_message_comes_back/0, prop_every_message_comes_back/1]).
-export([prop_liblcm_reads_what_we_write/0, prop_liblcm_reads_what_we_write/1]).
-export([prop_we_read_what_liblcm_writes/0, prop_we_read_what_liblcm_writes/1]).
-export([prop_damaged_messages_are_refused_or_read/0, prop_damaged_messages_are_refused_or_read/1]).
-export([prop_fragments_are_put_together/0, prop_fragments_are_put_together/1]).
-export([prop_damaged_packets_do_no_harm/0, prop_damaged_packets_do_no_harm/1]).
-export([prop_damaged_logs_give_what_is_whole/0, prop_damaged_logs_give_what_is_whole/1]).

-define(FROM, {{127, 0, 0, 1}, 4000}).

typed() -> ?LET(Type, replay_lcm_gen:type(), {Type, replay_lcm_gen:message(Type)}).

%% ---- messages ---------------------------------------------------------------------------------

prop_every_message_comes_back() ->
    ?FORALL({Type, Message}, typed(),
            aggregate([Type],
                      begin
                          Bytes = replay_lcm:encode(Type, Message),
                          same({ok, Type, Message}, replay_lcm:decode(Bytes))
                      end)).

prop_every_message_comes_back(doc) -> "Decoding gives the message that was encoded";
prop_every_message_comes_back(opts) -> [{numtests, 500}].

prop_liblcm_reads_what_we_write() ->
    ?SETUP(fun() -> fun() -> stop_peer() end end,
    ?FORALL({Type, Message}, typed(),
            aggregate([Type],
                      begin
                          Bytes = replay_lcm:encode(Type, Message),
                          same({Message, Bytes}, replay_lcm_peer:ask(peer(), Type, Bytes))
                      end))).

prop_liblcm_reads_what_we_write(doc) ->
    "The C++ code of lcm-gen finds the same values, and writes the same bytes";
prop_liblcm_reads_what_we_write(opts) -> [{numtests, 500}].

prop_we_read_what_liblcm_writes() ->
    ?FORALL(Seed, integer(1, 1 bsl 30),
            conjunction([{Type, same({{ok, Message}, Bytes},
                                     {replay_lcm:decode(Type, Bytes),
                                      replay_lcm:encode(Type, Message)})}
                         || {Type, Message, Bytes} <- replay_lcm_peer:made(Seed, 1)])).

prop_we_read_what_liblcm_writes(doc) ->
    "Messages made and written by C++ have the same values here, and the same bytes again";
prop_we_read_what_liblcm_writes(opts) -> [{numtests, 60}].

prop_damaged_messages_are_refused_or_read() ->
    ?FORALL(Bytes,
            ?LET({T, M}, typed(), replay_lcm_gen:damaged(replay_lcm:encode(T, M))),
            case replay_lcm:decode(Bytes) of
                %% NaN has many bit patterns, and one name
                {ok, Type, Message} ->
                    byte_size(replay_lcm:encode(Type, Message)) =:= byte_size(Bytes);
                {error, Line} ->
                    one_line(Line)
            end).

prop_damaged_messages_are_refused_or_read(doc) ->
    "Bytes with an error in them are either another message, to the last byte, or refused";
prop_damaged_messages_are_refused_or_read(opts) -> [{numtests, 1000}].

one_line(Line) -> length(Line) > 0 andalso not lists:member($\n, Line).

same(Expected, Expected) -> true;
same(Expected, Found) -> io:format("expected ~p~nfound ~p~n", [Expected, Found]), false.

%% One peer for all tests of this process.
peer() ->
    case get(lcm_peer) of
        undefined ->
            Peer = replay_lcm_peer:start(),
            put(lcm_peer, Peer),
            Peer;
        Peer ->
            Peer
    end.

stop_peer() ->
    case erase(lcm_peer) of
        undefined -> ok;
        Peer -> replay_lcm_peer:stop(Peer)
    end.

%% ---- packets ----------------------------------------------------------------------------------

%% Some messages, their packets in any order, some of them lost and some repeated.
traffic() ->
    ?LET(Sizes, non_empty(list(oneof([integer(0, 200), integer(65400, 65520),
                                      integer(100000, 300000)]))),
         ?LET({Packets, Lost, Seed}, {numbered(Sizes), integer(0, 2), integer()},
              {Sizes, lose(Lost, shuffled(Seed, Packets ++ lists:sublist(Packets, 3)))})).

numbered(Sizes) ->
    [{N, iolist_to_binary(Packet)}
     || {N, Size} <- lists:zip(lists:seq(1, length(Sizes)), Sizes),
        {ok, Packets} <- [replay_lcm_packet:packets(N, <<"C">>, payload(N, Size))],
        Packet <- Packets].

payload(N, Size) -> binary:copy(<<N:8>>, Size).

shuffled(Seed, List) ->
    [X || {_, X} <- lists:sort([{erlang:phash2({Seed, N}), X}
                                || {N, X} <- lists:zip(lists:seq(1, length(List)), List)])].

lose(N, List) -> lists:nthtail(min(N, length(List)), List).

prop_fragments_are_put_together() ->
    ?FORALL({Sizes, Packets}, traffic(),
            begin
                Distinct = lists:usort(Packets),
                Whole = [N || {N, Size} <- lists:zip(lists:seq(1, length(Sizes)), Sizes),
                              length([1 || {M, _} <- Distinct, M =:= N]) =:=
                                  length(numbered_one(N, Size))],
                Received = [{N, P} || {N, {message, <<"C">>, P}} <- received(Packets)],
                Expected = [{N, payload(N, lists:nth(N, Sizes))} || N <- Whole],
                aggregate([{length(Whole) =:= length(Sizes), all_whole}],
                          same(Expected, lists:usort(Received)))
            end).

numbered_one(N, Size) ->
    {ok, Packets} = replay_lcm_packet:packets(N, <<"C">>, payload(N, Size)),
    Packets.

received(Packets) ->
    {Results, _} = lists:mapfoldl(
        fun({N, Packet}, R0) ->
            {Result, R} = replay_lcm_packet:receive_packet(?FROM, Packet, R0),
            {{N, Result}, R}
        end,
        replay_lcm_packet:new(),
        Packets
    ),
    Results.

prop_fragments_are_put_together(doc) ->
    "A message arrives whole when all its packets do, in whatever order and how often, else not";
prop_fragments_are_put_together(opts) -> [{numtests, 60}].

prop_damaged_packets_do_no_harm() ->
    ?FORALL(Packets,
            ?LET({_, Packets}, traffic(), [damaged_head(P) || P <- Packets]),
            lists:all(fun({_, {message, Channel, P}}) ->
                              byte_size(Channel) =< 63 andalso byte_size(P) =< 16 bsl 20;
                         ({_, {error, Line}}) -> one_line(Line);
                         ({_, more}) -> true
                      end, received(Packets))).

%% In the header, where it matters.
damaged_head({N, <<Head:24/binary, Rest/binary>>}) ->
    ?LET(Damaged, weighted_default({1, Head}, {1, replay_lcm_gen:damaged(Head)}),
         {N, <<Damaged/binary, Rest/binary>>});
damaged_head({N, Packet}) ->
    {N, replay_lcm_gen:damaged(Packet)}.

prop_damaged_packets_do_no_harm(doc) ->
    "Whatever the headers say, there is a message within the limits, or a line";
prop_damaged_packets_do_no_harm(opts) -> [{numtests, 60}].

%% ---- logs -------------------------------------------------------------------------------------

prop_damaged_logs_give_what_is_whole() ->
    ?FORALL({Events, At, Damage},
            {list({integer(0, 1 bsl 40), elements([<<"A">>, <<"VIZ_FRAME">>]), binary()}),
             integer(0, 400), binary(4)},
            begin
                Encoded = [event(N, E) || {N, E} <- lists:zip(lists:seq(0, length(Events) - 1),
                                                              Events)],
                Whole = iolist_to_binary(Encoded),
                Before = min(At, byte_size(Whole)),
                Log = <<(binary:part(Whole, 0, Before))/binary, Damage/binary>>,
                Intact = intact(Encoded, Before),
                Read = case replay_lcm_log:events(Log) of
                    {ok, All} -> All;
                    {truncated, Line, Some} -> true = one_line(Line), Some
                end,
                Given = [{T, C, D} || #{t_us := T, channel := C, data := D} <- Read],
                same(lists:sublist(Events, Intact), lists:sublist(Given, Intact))
            end).

event(N, {T, Channel, Data}) ->
    <<16#eda1da01:32, N:64, T:64, (byte_size(Channel)):32, (byte_size(Data)):32, Channel/binary,
      Data/binary>>.

intact([First | Rest], Left) when byte_size(First) =< Left ->
    1 + intact(Rest, Left - byte_size(First));
intact(_, _) ->
    0.

prop_damaged_logs_give_what_is_whole(doc) ->
    "Events before the damage are read, and there is a line for the rest";
prop_damaged_logs_give_what_is_whole(opts) -> [{numtests, 300}].

#!/usr/bin/env escript
%%! -noinput
%% Feeds damaged bytes to the readers of LCM in Erlang, for so many seconds, or so many runs:
%%
%%   replay_fuzz.escript message|packet|fragments|log SECONDS [RUNS [FIRST_SEED]]
%%
%% Needs ERL_LIBS, and the clone as the current folder: the bytes that are damaged are liblcm's
%% (test/data/viz_messages.json.gz). Each run is determined by its seed. Ends with "Done N runs in S
%% second(s)", as libFuzzer does, or with the seed of what it found and exit status 1.
-mode(compile).

-define(SLOW_US, 1000000).
-define(FROM, {{127, 0, 0, 1}, 4000}).
%% What is written over lengths and counts.
-define(NUMBERS, [0, 1, -1, 16#7fffffff, 16#80000000, 16#ffff, 16#10000, 16 bsl 20, 255]).

main([Target, Seconds]) ->
    main([Target, Seconds, ""]);
main([Target, Seconds, Runs]) ->
    %% Other inputs each day, the same all day.
    Day = erlang:system_time(second) div 86400,
    main([Target, Seconds, Runs, integer_to_list(Day * 100000)]);
main([Target, Seconds, Runs, Seed]) ->
    case lists:member(Target, ["message", "packet", "fragments", "log"]) of
        true -> fuzz(list_to_atom(Target), limits(Seconds, Runs), list_to_integer(Seed));
        false -> usage()
    end;
main(_) ->
    usage().

usage() ->
    io:format(standard_error, "replay_fuzz: expected message, packet, fragments or log, then "
                              "seconds, runs and the first seed~n", []),
    halt(2).

limits(Seconds, "") ->
    {infinity, erlang:monotonic_time(second) + list_to_integer(Seconds)};
limits(_Seconds, Runs) ->
    {list_to_integer(Runs), infinity}.

fuzz(Target, Limits, Seed) ->
    Began = erlang:monotonic_time(second),
    Good = good(),
    Runs = runs(Target, Good, Limits, Seed, 0),
    Took = erlang:monotonic_time(second) - Began,
    io:format("Done ~b runs in ~b second(s)~n", [Runs, Took]).

%% An atom is more than any number.
runs(_Target, _Good, {Most, _}, _Seed, Done) when Done >= Most ->
    Done;
runs(Target, Good, {_, Deadline} = Limits, Seed, Done) ->
    case erlang:monotonic_time(second) >= Deadline of
        true ->
            Done;
        false ->
            one(Target, Good, Seed),
            runs(Target, Good, Limits, Seed + 1, Done + 1)
    end.

one(Target, Good, Seed) ->
    _ = rand:seed(exsss, Seed),
    Input = input(Target, Good),
    try timer:tc(fun() -> run(Target, Input) end) of
        {Us, ok} when Us < ?SLOW_US -> ok;
        {Us, ok} -> found(Target, Seed, {slow_us, Us})
    catch
        Class:Reason:Stack -> found(Target, Seed, {Class, Reason, Stack})
    end.

found(Target, Seed, What) ->
    io:format(standard_error, "replay_fuzz ~ts: seed ~b: ~p~n", [Target, Seed, What]),
    halt(1).

%% ---- inputs -----------------------------------------------------------------------------------

%% Messages, packets and events of a log as liblcm makes them.
good() ->
    {ok, Packed} = file:read_file("test/data/viz_messages.json.gz"),
    {ok, #{<<"messages">> := Messages, <<"packets">> := Packets}} =
        faultcheck_json:decode(zlib:gunzip(Packed)),
    #{
        messages => [bytes(B) || #{<<"bytes">> := B} <- Messages],
        packets => [bytes(P) || P <- Packets]
    }.

bytes(Hex) -> << <<(binary_to_integer(Pair, 16))>> || <<Pair:2/binary>> <= Hex >>.

input(message, #{messages := Messages}) ->
    damaged(any(Messages));
input(packet, #{packets := Packets}) ->
    damaged(any(Packets));
input(fragments, _) ->
    Sizes = [any([1, 100, 65497, 65498, 131000, 200000]) || _ <- lists:seq(1, below(4))],
    Sent = [P || {N, Size} <- lists:zip(lists:seq(1, length(Sizes)), Sizes), P <- packets(N, Size)],
    Order = [P || {_, P} <- lists:sort([{rand:uniform(), P} || P <- Sent ++ some(Sent)])],
    [sometimes(P) || P <- Order];
input(log, #{messages := Messages}) ->
    Events = [event(N, any(Messages)) || N <- lists:seq(0, below(5))],
    damaged(iolist_to_binary(Events)).

packets(N, Size) ->
    {ok, Packets} = replay_lcm_packet:packets(N, <<"CHANNEL">>, binary:copy(<<N>>, Size)),
    [iolist_to_binary(P) || P <- Packets].

event(N, Data) ->
    <<16#eda1da01:32, N:64, (1000 * N):64, 9:32, (byte_size(Data)):32, "VIZ_FRAME", Data/binary>>.

some(List) -> [X || X <- List, below(3) =:= 0].

%% In the header, where it matters.
sometimes(Packet) ->
    case below(4) of
        0 ->
            Size = min(30, byte_size(Packet)),
            <<Head:Size/binary, Rest/binary>> = Packet,
            <<(damaged(Head))/binary, Rest/binary>>;
        _ ->
            Packet
    end.

damaged(Bytes) ->
    lists:foldl(fun(_, B) -> damage(below(5), B) end, Bytes, lists:seq(1, below(4))).

damage(0, Bytes) -> binary:part(Bytes, 0, below(byte_size(Bytes) + 1));
damage(1, Bytes) -> splice(Bytes, 4, <<(any(?NUMBERS)):32>>);
damage(2, Bytes) -> splice(Bytes, 1, <<(below(256))>>);
damage(3, Bytes) -> splice(Bytes, below(20), <<>>);
damage(4, Bytes) -> splice(Bytes, 0, rand:bytes(below(20))).

%% Puts a piece in the place of so many bytes, anywhere.
splice(Bytes, Length, Piece) ->
    At = below(byte_size(Bytes) + 1),
    <<Before:At/binary, Rest/binary>> = Bytes,
    Skipped = min(Length, byte_size(Rest)),
    <<_:Skipped/binary, After/binary>> = Rest,
    <<Before/binary, Piece/binary, After/binary>>.

any(List) -> lists:nth(1 + below(length(List)), List).

below(N) -> rand:uniform(N) - 1.

%% ---- what must hold ---------------------------------------------------------------------------

run(message, Bytes) ->
    case replay_lcm:decode(Bytes) of
        {ok, Type, Message} ->
            true = byte_size(replay_lcm:encode(Type, Message)) =:= byte_size(Bytes),
            ok;
        {error, Line} ->
            line(Line)
    end;
run(packet, Bytes) ->
    run(fragments, [Bytes]);
run(fragments, Packets) ->
    Last = lists:foldl(
        fun(Packet, Before) ->
            {Result, After} = replay_lcm_packet:receive_packet(?FROM, Packet, Before),
            ok = received(Result),
            After
        end,
        replay_lcm_packet:new(),
        Packets
    ),
    true = replay_lcm_packet:unfinished(Last) =< 64,
    ok;
run(log, Bytes) ->
    case replay_lcm_log:events(Bytes) of
        {ok, Events} -> events(Events, byte_size(Bytes));
        {truncated, Line, Events} -> line(Line), events(Events, byte_size(Bytes))
    end.

received({message, Channel, Payload}) ->
    true = byte_size(Channel) >= 1 andalso byte_size(Channel) =< 63,
    true = byte_size(Payload) =< 16 bsl 20,
    ok;
received(more) ->
    ok;
received({error, Line}) ->
    line(Line).

%% There is no more in them than in the file.
events(Events, Size) ->
    true = lists:sum([28 + byte_size(C) + byte_size(D) || #{channel := C, data := D} <- Events])
        =< Size,
    ok.

line(Line) ->
    true = length(Line) > 0 andalso not lists:member($\n, Line),
    ok.

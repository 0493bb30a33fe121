%% @doc One communication fault at a time, many times over: what the receiver of libe2e says.
%%
%% A trial begins when the receiver has said OK, does something to the communication, notes the
%% status of the check that meets it, and ends when fault-free packets have brought OK back.
-module(e2e_fault_trial).

-export([faults/0, run/4]).
-export_type([fault/0, result/0]).

%% Its name, and what it is in words.
-type fault() :: {atom(), string()}.
-type result() :: #{
    statuses := #{e2e_receiver:status() | e2e_receiver:answer() => pos_integer()},
    %% most fault-free packets until OK
    recovery := non_neg_integer()
}.
-type link() :: {e2e_packet:profile(), e2e_packet:config(), Bytes :: pos_integer()}.

-spec faults() -> [fault()].
faults() ->
    [
        {repetition, "repetition: the packet before comes again"},
        {loss_1, "loss of 1 packet"},
        {loss_3, "loss of 3 packets"},
        {loss_5, "loss of 5 packets"},
        {loss_all, "loss of as many packets as the counter has values (1)"},
        {silence, "delay: nothing comes when a packet is due"},
        {insertion, "insertion of a packet sent 2 to 41 packets before"},
        {early, "incorrect sequence: the packet that overtakes another"},
        {late, "incorrect sequence: the packet that was overtaken"},
        {masquerade, "masquerade: right counter, other Data ID"},
        {addressing, "incorrect addressing: any counter, other Data ID"},
        {flips_1, "corruption: 1 bit"},
        {flips_2, "corruption: 2 bits"},
        {flips_3, "corruption: 3 bits"},
        {flips_4, "corruption: 4 bits"},
        {burst, "corruption: up to 8 bits in a row"},
        {random, "corruption: every byte at random"},
        {zeros, "corruption: all bytes 0"},
        {ones, "corruption: all bytes 255"},
        {truncation, "truncation by 1 to all but 1 bytes (2)"},
        {extension, "extension by 1 to 4 bytes (2)"}
    ].

%% @doc So many trials with packets of so many bytes. The seed decides everything.
-spec run(atom(), link(), Trials :: pos_integer(), Seed :: integer()) -> result().
run(Fault, {P, Config, _} = Link, Trials, Seed) ->
    _ = rand:seed(exsss, {Seed, erlang:phash2(P), erlang:phash2(Fault)}),
    ok = e2e_sut:prepare(),
    Machine = #{'WindowSizeValid' => 1, 'WindowSizeInit' => 1, 'WindowSizeInvalid' => 1},
    [ok, ok, ok] = e2e_sut:open(P, Config, Machine),
    ok = e2e_sut:set_counter(rand:uniform(e2e_packet:counters(P)) - 1),
    _ = recover(Link, 1),
    trials(Trials, Fault, Link, #{statuses => #{}, recovery => 0}).

trials(0, _, _, Result) ->
    Result;
trials(N, Fault, Link, #{statuses := Statuses, recovery := Most}) ->
    Status = trial(Fault, Link),
    Counted = maps:update_with(Status, fun(C) -> C + 1 end, 1, Statuses),
    trials(N - 1, Fault, Link, #{statuses => Counted, recovery => max(Most, recover(Link, 1))}).

%% Packets until the first OK. More than the model's bound would be an endless loop.
recover({P, Config, _} = Link, N) ->
    true = N =< e2e_eqc:recovery(P, Config),
    case check(send(Link)) of
        'OK' -> N;
        _ -> recover(Link, N + 1)
    end.

trial(repetition, Link) ->
    Packet = send(Link),
    _ = check(Packet),
    check(Packet);
trial(loss_1, Link) -> lose(1, Link);
trial(loss_3, Link) -> lose(3, Link);
trial(loss_5, Link) -> lose(5, Link);
%% The sender's counter is then as it was: nothing need be sent.
trial(loss_all, Link) -> lose(0, Link);
trial(silence, _) -> check(none);
trial(insertion, {P, _, _} = Link) ->
    N = e2e_packet:counters(P),
    Counter = e2e_sut:sender(),
    Age = 1 + rand:uniform(40),
    ok = e2e_sut:set_counter((Counter - Age - 1 + 40 * N) rem N),
    Packet = send(Link),
    ok = e2e_sut:set_counter(Counter),
    check(Packet);
trial(early, Link) ->
    _ = send(Link),
    check(send(Link));
trial(late, Link) ->
    Overtaken = send(Link),
    _ = check(send(Link)),
    check(Overtaken);
trial(masquerade, {P, _, _} = Link) ->
    check(foreign(e2e_eqc:counter_sent(P, e2e_sut:sender()), Link));
trial(addressing, {P, _, _} = Link) ->
    check(foreign(rand:uniform(e2e_packet:counters(P)) - 1, Link));
trial(Corruption, Link) ->
    check(corrupted(Corruption, Link, send(Link))).

lose(N, Link) ->
    _ = [send(Link) || _ <- lists:seq(1, N)],
    check(send(Link)).

%% From a sender that differs in nothing but the Data ID.
foreign(Counter, {P, Config, Bytes}) ->
    e2e_packet:protect(P, other_id(Config), Counter, rand:bytes(Bytes)).

other_id(#{'DataIDList' := Ids} = Config) ->
    Config#{'DataIDList' := [(Id + rand:uniform(255)) rem 256 || Id <- Ids]};
other_id(#{'DataIDMode' := 3, 'DataID' := Id} = Config) ->
    Config#{'DataID' := (Id + rand:uniform(16#FFF)) rem 16#1000};
other_id(#{'DataID' := Id} = Config) ->
    Config#{'DataID' := (Id + rand:uniform(16#FFFF)) rem 16#10000}.

corrupted(flips_1, _, Packet) -> flip(places(1, bit_size(Packet)), Packet);
corrupted(flips_2, _, Packet) -> flip(places(2, bit_size(Packet)), Packet);
corrupted(flips_3, _, Packet) -> flip(places(3, bit_size(Packet)), Packet);
corrupted(flips_4, _, Packet) -> flip(places(4, bit_size(Packet)), Packet);
corrupted(burst, _, Packet) ->
    Mask = rand:uniform(255),
    At = rand:uniform(bit_size(Packet) - 7) - 1,
    flip([At + I || I <- lists:seq(0, 7), Mask band (1 bsl I) =/= 0], Packet);
corrupted(random, _, Packet) -> rand:bytes(byte_size(Packet));
corrupted(zeros, _, Packet) -> <<0:(bit_size(Packet))>>;
corrupted(ones, _, Packet) -> <<<<255>> || <<_>> <= Packet>>;
corrupted(truncation, _, Packet) -> binary:part(Packet, 0, rand:uniform(byte_size(Packet) - 1));
corrupted(extension, _, Packet) -> <<Packet/binary, (rand:bytes(rand:uniform(4)))/binary>>.

%% So many different ones.
places(N, Bits) -> places(N, Bits, []).

places(0, _, Chosen) -> Chosen;
places(N, Bits, Chosen) ->
    At = rand:uniform(Bits) - 1,
    case lists:member(At, Chosen) of
        true -> places(N, Bits, Chosen);
        false -> places(N - 1, Bits, [At | Chosen])
    end.

flip(Places, Packet) ->
    Size = bit_size(Packet),
    <<Number:Size>> = Packet,
    <<(lists:foldl(fun(At, N) -> N bxor (1 bsl (Size - 1 - At)) end, Number, Places)):Size>>.

send({_, _, Bytes}) ->
    {ok, Packet} = e2e_sut:protect(rand:bytes(Bytes)),
    Packet.

%% The status, or what was returned instead of ok.
check(Packet) ->
    case e2e_sut:check(Packet) of
        ok -> maps:get('Status', e2e_sut:receiver());
        Answer -> Answer
    end.

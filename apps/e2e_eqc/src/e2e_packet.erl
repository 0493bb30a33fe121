%% @doc The packets of each profile as e2e.md sections 3 to 6 describe them: where the fields lie,
%% what the checksum covers, how a packet is protected and when it is intact.
%%
%% Configurations are maps with the AUTOSAR names, as the C library gets them.
-module(e2e_packet).

-export([profiles/0, counters/1, first_counter/1, algorithm/1, header_bytes/1]).
-export([lengths/2, length_fits/3, has_length/1, fields/2, read/2, write/3]).
-export([covered/2, trailing_id/1, protect/4, inspect/3, sign/4]).
-export_type([profile/0, config/0, field/0, name/0]).

-type profile() :: p01 | p02 | p04 | p05 | p06 | p07 | p08 | p11 | p22 | p44.
-type config() :: #{atom() => term()}.
-type name() :: crc | length | counter | id | nibble.
%% First bit counted from the left of the packet, number of bits, byte order.
-type field() :: {non_neg_integer(), pos_integer(), big | little}.

-spec profiles() -> [profile()].
profiles() -> [p01, p02, p04, p05, p06, p07, p08, p11, p22, p44].

%% @doc How many values the counter has.
-spec counters(profile()) -> pos_integer().
counters(P) when P =:= p01; P =:= p11 -> 15;
counters(P) when P =:= p02; P =:= p22 -> 16;
counters(P) when P =:= p05; P =:= p06 -> 16#100;
counters(P) when P =:= p04; P =:= p44 -> 16#10000;
counters(P) when P =:= p07; P =:= p08 -> 16#100000000.

%% @doc The counter that is sent after the state Counter 0: profiles 2 and 22 step first.
-spec first_counter(profile()) -> 0 | 1.
first_counter(P) when P =:= p02; P =:= p22 -> 1;
first_counter(_) -> 0.

-spec algorithm(profile()) -> e2e_crc:algorithm().
algorithm(P) when P =:= p01; P =:= p11 -> crc8;
algorithm(P) when P =:= p02; P =:= p22 -> crc8h2f;
algorithm(P) when P =:= p05; P =:= p06 -> crc16;
algorithm(P) when P =:= p04; P =:= p44; P =:= p08 -> crc32p4;
algorithm(p07) -> crc64.

-spec header_bytes(profile()) -> pos_integer().
header_bytes(P) when P =:= p01; P =:= p11; P =:= p02; P =:= p22 -> 2;
header_bytes(P) when P =:= p04; P =:= p44 -> 12;
header_bytes(p05) -> 3;
header_bytes(p06) -> 5;
header_bytes(p07) -> 20;
header_bytes(p08) -> 16.

%% @doc Do Protect and Check have an argument Length?
-spec has_length(profile()) -> boolean().
has_length(P) -> P =/= p01 andalso P =/= p02.

%% @doc The shortest and the longest packet that a configuration permits, in bytes; none when it
%% permits none.
-spec lengths(profile(), config()) -> {pos_integer(), pos_integer()} | none.
lengths(P, #{'MinDataLength' := Min, 'MaxDataLength' := Max} = Config) ->
    range(max(header_end(P, Config), (Min + 7) div 8), Max div 8);
lengths(P, Config) when P =:= p01; P =:= p11 ->
    #{'DataLength' := Bits} = Config,
    %% Profile 1 gets no length: its buffer reaches as far as the fields do.
    Reach = max(Bits div 8, reach(P, Config)),
    range(Reach, if P =:= p01 -> Reach; true -> Bits div 8 end);
lengths(P, #{'DataLength' := Bits} = Config) ->
    range(max(header_end(P, Config), Bits div 8), Bits div 8).

range(Min, Max) when Min =< Max -> {Min, Max};
range(_, _) -> none.

header_end(P, #{'Offset' := Offset}) -> Offset div 8 + header_bytes(P).

%% Where the last field of profile 1 or 11 ends.
reach(P, Config) ->
    lists:max([(At + Bits + 7) div 8 || {At, Bits, _} <- maps:values(fields(P, Config))]).

%% @doc Is this a length that Protect and Check accept?
-spec length_fits(profile(), config(), non_neg_integer()) -> boolean().
length_fits(P, Config, Bytes) ->
    case lengths(P, Config) of
        none -> false;
        {Min, Max} -> Bytes >= Min andalso Bytes =< Max
    end.

%% @doc The fields of a packet.
-spec fields(profile(), config()) -> #{name() => field()}.
fields(P, Config) when P =:= p01; P =:= p11 ->
    #{'CRCOffset' := Crc, 'CounterOffset' := Counter} = Config,
    Fields = #{crc => {Crc, 8, big}, counter => nibble_at(Counter)},
    case Config of
        #{'DataIDMode' := 3, 'DataIDNibbleOffset' := Id} -> Fields#{nibble => nibble_at(Id)};
        #{} -> Fields
    end;
fields(P, #{'Offset' := Offset}) ->
    maps:map(fun(_, {At, Bits, Order}) -> {Offset + At, Bits, Order} end, layout(P)).

%% Offset o addresses byte o div 8; o rem 8 = 0 is its low nibble.
nibble_at(Offset) -> {Offset div 8 * 8 + 4 - Offset rem 8, 4, big}.

layout(P) when P =:= p02; P =:= p22 -> #{crc => {0, 8, big}, counter => {12, 4, big}};
layout(P) when P =:= p04; P =:= p44 ->
    #{length => {0, 16, big}, counter => {16, 16, big}, id => {32, 32, big}, crc => {64, 32, big}};
layout(p05) -> #{crc => {0, 16, little}, counter => {16, 8, big}};
layout(p06) -> #{crc => {0, 16, big}, length => {16, 16, big}, counter => {32, 8, big}};
layout(p07) ->
    #{crc => {0, 64, big}, length => {64, 32, big}, counter => {96, 32, big}, id => {128, 32, big}};
layout(p08) ->
    #{crc => {0, 32, big}, length => {32, 32, big}, counter => {64, 32, big}, id => {96, 32, big}}.

%% @doc The value of a field.
-spec read(field(), binary()) -> non_neg_integer().
read({At, Bits, Order}, Packet) ->
    <<_:At, Field:Bits/bits, _/bits>> = Packet,
    case Order of
        big -> <<Value:Bits/big>> = Field, Value;
        little -> <<Value:Bits/little>> = Field, Value
    end.

%% @doc The packet with another value in a field; what does not fit is cut off.
-spec write(field(), non_neg_integer(), binary()) -> binary().
write({At, Bits, Order}, Value, Packet) ->
    <<Before:At/bits, _:Bits, After/bits>> = Packet,
    case Order of
        big -> <<Before/bits, Value:Bits/big, After/bits>>;
        little -> <<Before/bits, Value:Bits/little, After/bits>>
    end.

%% @doc How many bytes at the start of a packet the checksum covers, itself among them.
-spec covered(config(), binary()) -> non_neg_integer().
covered(#{'CounterOffset' := _, 'DataLength' := Bits}, _) -> Bits div 8;
covered(_, Packet) -> byte_size(Packet).

%% @doc How many bytes of an implicit Data ID follow the data in the checksum.
-spec trailing_id(profile()) -> 0..2.
trailing_id(P) when P =:= p02; P =:= p22 -> 1;
trailing_id(P) when P =:= p05; P =:= p06 -> 2;
trailing_id(_) -> 0.

%% @doc What the sender makes of a buffer, with this counter in the packet.
-spec protect(profile(), config(), Counter :: non_neg_integer(), binary()) -> binary().
protect(P, Config, Counter, Data) ->
    Values = #{
        counter => Counter,
        length => byte_size(Data),
        id => maps:get('DataID', Config, 0),
        nibble => maps:get('DataID', Config, 0) bsr 8
    },
    Fields = maps:remove(crc, fields(P, Config)),
    Fill = fun(Name, Field, Packet) -> write(Field, maps:get(Name, Values), Packet) end,
    Filled = maps:fold(Fill, Data, Fields),
    sign(P, Config, Counter, Filled).

%% @doc The packet with the checksum that belongs to the rest of it.
-spec sign(profile(), config(), Counter :: non_neg_integer(), binary()) -> binary().
sign(P, Config, Counter, Packet) ->
    write(maps:get(crc, fields(P, Config)), checksum(P, Config, Counter, Packet), Packet).

%% @doc The counter received, and whether the packet is as a sender of this configuration makes it.
-spec inspect(profile(), config(), binary()) -> {Counter :: non_neg_integer(), boolean()}.
inspect(P, Config, Packet) ->
    Fields = fields(P, Config),
    Counter = read(maps:get(counter, Fields), Packet),
    Id = maps:get('DataID', Config, 0),
    Expected = #{
        counter => Counter,
        crc => checksum(P, Config, Counter, Packet),
        length => byte_size(Packet),
        id => Id,
        nibble => (Id bsr 8) band 15
    },
    Wrong = [N || {N, F} <- maps:to_list(Fields), read(F, Packet) =/= maps:get(N, Expected)],
    {Counter, Wrong =:= []}.

checksum(P, Config, Counter, Packet) ->
    Length = covered(Config, Packet),
    <<Covered:Length/binary, _/binary>> = Packet,
    Data = without_crc(maps:get(crc, fields(P, Config)), Covered),
    case {P, Config} of
        {_, #{'DataIDList' := Ids}} ->
            e2e_crc:calculate(algorithm(P), <<Data/binary, (lists:nth(Counter rem 16 + 1, Ids))>>);
        {p05, #{'DataID' := Id}} ->
            e2e_crc:calculate(crc16, <<Data/binary, Id:16/little>>);
        {p06, #{'DataID' := Id}} ->
            e2e_crc:calculate(crc16, <<Data/binary, Id:16/big>>);
        {_, #{'DataIDMode' := Mode, 'DataID' := Id}} ->
            e2e_crc:remainder(crc8, <<(leading_id(Mode, Counter, Id))/binary, Data/binary>>);
        {_, #{}} ->
            e2e_crc:calculate(algorithm(P), Data)
    end.

without_crc({At, Bits, _}, Covered) when At div 8 < byte_size(Covered) ->
    <<Before:At/bits, _:Bits, After/bits>> = Covered,
    <<Before/bits, After/bits>>;
without_crc(_, Covered) ->
    Covered.

%% BOTH, ALT, LOW, NIBBLE
leading_id(0, _, Id) -> <<Id:16/little>>;
leading_id(1, Counter, Id) when Counter rem 2 =:= 0 -> <<Id>>;
leading_id(1, _, Id) -> <<(Id bsr 8)>>;
leading_id(2, _, Id) -> <<Id>>;
leading_id(3, _, Id) -> <<Id, 0>>.

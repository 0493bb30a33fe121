%% @doc The Hamming distance of a packet: the least number of flipped bits that no check sees.
%% Found by trying every combination of bits, not taken from a table.
%%
%% A checksum is linear, so each bit of the packet has a syndrome: what its flip does to the
%% checksum, computed by division of polynomials. Flips go undetected if and only if their
%% syndromes add up to 0. The counter is special in profiles 2 and 22 and in mode ALT of profile 1:
%% it chooses the Data ID, so each change of it is one alternative with a syndrome of its own.
-module(e2e_distance).

-export([least/4, least_of/2, undetected/4, exceeds/4, patterns/2]).
-export_type([distance/0]).

%% {D, N}: N patterns of D flipped bits go undetected, and none of fewer.
-type distance() :: {pos_integer(), pos_integer()} | {above, pos_integer()}.

%% @doc The distance of packets with this many bytes, searched up to Most.
-spec least(e2e_packet:profile(), e2e_packet:config(), pos_integer(), Most :: pos_integer()) ->
    distance().
least(P, Config, Bytes, Most) -> least(1, Most, code(P, Config, Bytes)).

%% @doc The distance of any linear code, from the syndromes of its bits.
-spec least_of(Syndromes :: [non_neg_integer()], Most :: pos_integer()) -> distance().
least_of(Syndromes, Most) -> least(1, Most, {Syndromes, [[{0, 0}]]}).

least(Flips, Most, _) when Flips > Most -> {above, Most};
least(Flips, Most, Code) ->
    case count(Flips, Code) of
        0 -> least(Flips + 1, Most, Code);
        N -> {Flips, N}
    end.

%% @doc How many patterns of so many flips go undetected: for the counter that is worst.
-spec undetected(e2e_packet:profile(), e2e_packet:config(), pos_integer(), pos_integer()) ->
    non_neg_integer().
undetected(P, Config, Bytes, Flips) -> count(Flips, code(P, Config, Bytes)).

%% @doc Are so many flips fewer than the distance? Not asked of many: no checksum of 8 bits has a
%% distance of 5, and none of the others one that random flips would tell from 5.
-spec exceeds(pos_integer(), e2e_packet:profile(), e2e_packet:config(), pos_integer()) -> boolean().
exceeds(Flips, P, Config, Bytes) ->
    Few = if P =:= p01; P =:= p02; P =:= p11; P =:= p22 -> 3; true -> 4 end,
    Flips =< Few andalso remembered(Flips, code(P, Config, Bytes)).

%% In the calling process, since most packets of a profile share few lengths.
remembered(Flips, Code) ->
    Key = {?MODULE, erlang:phash2(Code, 1 bsl 32), Flips},
    case get(Key) of
        undefined ->
            Holds = lists:all(fun(N) -> count(N, Code) =:= 0 end, lists:seq(1, Flips)),
            _ = put(Key, Holds),
            Holds;
        Holds ->
            Holds
    end.

%% @doc How many patterns of so many bits there are.
-spec patterns(Bits :: non_neg_integer(), Flips :: non_neg_integer()) -> non_neg_integer().
patterns(Bits, Flips) ->
    lists:foldl(fun(I, N) -> N * (Bits - I + 1) div I end, 1, lists:seq(1, Flips)).

%% ---- syndromes ----------------------------------------------------------------------------------

%% The syndromes of the bits that always do the same, and for each value of a counter that does
%% not, its changes: {flipped bits, syndrome}. Without such a counter one "change" of nothing.
code(P, Config, Bytes) ->
    Fields = #{crc := Crc} = e2e_packet:fields(P, Config),
    Places = places(P, Config, Bytes, Crc),
    case special_counter(P, Config) of
        none ->
            {lists:sort([S || {_, S} <- Places]), [[{0, 0}]]};
        Id ->
            #{counter := {At, Width, big}} = Fields,
            Chooses = fun({Bit, _}) -> Bit >= At andalso Bit < At + Width end,
            {Counter, Others} = lists:partition(Chooses, Places),
            Weights = [S || {_, S} <- lists:sort(Counter)],
            {lists:sort([S || {_, S} <- Others]), changes(Weights, Id)}
    end.

%% Each bit of the packet with its syndrome, x^k modulo the polynomial: the checksum's own bits are
%% the powers below its width, in front of them lies the implicit Data ID, then the data from its
%% end. Bits that the checksum does not cover have the syndrome 0.
places(P, Config, Bytes, {CrcAt, CrcWidth, _}) ->
    Algorithm = e2e_packet:algorithm(P),
    Covered = 8 * e2e_packet:covered(Config, <<0:Bytes/unit:8>>),
    Own = lists:seq(CrcAt, CrcAt + CrcWidth - 1),
    Data = lists:reverse(lists:seq(0, Covered - 1) -- Own),
    First = e2e_crc:width(Algorithm) + 8 * e2e_packet:trailing_id(P),
    Powers = powers(Algorithm, First + length(Data)),
    lists:zip(Own, lists:sublist(Powers, CrcWidth)) ++
        lists:zip(data_order(Algorithm, Data), lists:nthtail(First, Powers)) ++
        [{Bit, 0} || Bit <- lists:seq(Covered, 8 * Bytes - 1)].

%% The powers in order of the division: reflected checksums take the low bit of a byte first.
data_order(Algorithm, Bits) ->
    case lists:member(Algorithm, [crc8, crc8h2f, crc16]) of
        true -> Bits;
        false -> [Bit - Bit rem 8 + 7 - Bit rem 8 || Bit <- Bits]
    end.

powers(Algorithm, N) ->
    Width = e2e_crc:width(Algorithm),
    Polynomial = e2e_crc:polynomial(Algorithm),
    Next = fun(_, Power) -> {Power, reduce(Power bsl 1, Width, Polynomial)} end,
    {Powers, _} = lists:mapfoldl(Next, 1, lists:seq(1, N)),
    Powers.

reduce(Power, Width, Polynomial) when Power bsr Width =:= 1 -> Power bxor Polynomial;
reduce(Power, _, _) -> Power.

%% What the counter adds to the checksum beside its own bits: a function of its value.
special_counter(P, #{'DataIDList' := Ids}) ->
    fun(Counter) -> shifted(P, lists:nth(Counter + 1, Ids), 0) end;
special_counter(p01, #{'DataIDMode' := 1, 'DataID' := Id, 'DataLength' := Bits}) ->
    fun(Counter) ->
        Byte = if Counter rem 2 =:= 0 -> Id band 255; true -> Id bsr 8 end,
        shifted(p01, Byte, Bits - 8)
    end;
special_counter(_, _) ->
    none.

%% A byte with so many bits behind it.
shifted(P, Byte, Behind) ->
    e2e_crc:remainder(e2e_packet:algorithm(P), <<Byte, 0:Behind>>).

changes(Weights, Id) ->
    [
        [{ones(C bxor D), bits(C bxor D, Weights) bxor Id(C) bxor Id(D)} || D <- lists:seq(0, 15)]
     || C <- lists:seq(0, 15)
    ].

ones(N) -> length([1 || <<1:1>> <= <<N:4>>]).

bits(N, Weights) ->
    Chosen = [S || {1, S} <- lists:zip([B || <<B:1>> <= <<N:4>>], Weights)],
    lists:foldl(fun erlang:'bxor'/2, 0, Chosen).

%% ---- combinations -------------------------------------------------------------------------------

count(Flips, {Syndromes, Counters}) ->
    Places = place_of(Syndromes),
    Tuple = list_to_tuple(Syndromes),
    Of = fun(Changes) ->
        lists:sum([sums(Flips - W, S, Tuple, Places) || {W, S} <- Changes, W =< Flips])
    end,
    lists:max(lists:map(Of, Counters)).

%% Positions of each syndrome, from 1, ascending.
place_of(Syndromes) ->
    Numbered = lists:zip(Syndromes, lists:seq(1, length(Syndromes))),
    lists:foldr(
        fun({S, At}, Map) -> maps:update_with(S, fun(Ats) -> [At | Ats] end, [At], Map) end,
        #{},
        Numbered
    ).

%% How many sets of N syndromes add up to Sum.
sums(N, 0, Tuple, _) when N > 4 -> meet(N, Tuple);
sums(N, Sum, Tuple, Places) -> sums(N, Sum, 1, Tuple, Places).

sums(0, 0, _, _, _) -> 1;
sums(0, _, _, _, _) -> 0;
sums(1, Sum, From, _, Places) ->
    case Places of
        #{Sum := Ats} -> length([At || At <- Ats, At >= From]);
        #{} -> 0
    end;
sums(N, Sum, From, Tuple, Places) ->
    lists:sum([
        sums(N - 1, Sum bxor element(I, Tuple), I + 1, Tuple, Places)
     || I <- lists:seq(From, tuple_size(Tuple))
    ]).

%% Five or six that add up to 0: sums of three looked up among sums of the other two or three. Only
%% asked when no fewer add up to 0, so two that are equal have no syndrome in common; each set is
%% found once for each way to divide it.
meet(5, Tuple) ->
    Pairs = lists:foldl(
        fun(S, M) -> maps:update_with(S, fun(N) -> N + 1 end, 1, M) end, #{}, pairs(Tuple)
    ),
    over_triples(fun(S, Sum) -> Sum + maps:get(S, Pairs, 0) end, 0, Tuple) div 10;
meet(6, Tuple) ->
    equal(lists:sort(over_triples(fun(S, All) -> [S | All] end, [], Tuple)), 0) div 10.

%% How many pairs of equal members a sorted list has.
equal([], Sum) -> Sum;
equal([S | Rest], Sum) ->
    {Same, Others} = lists:splitwith(fun(R) -> R =:= S end, Rest),
    N = 1 + length(Same),
    equal(Others, Sum + N * (N - 1) div 2).

pairs(Tuple) ->
    Size = tuple_size(Tuple),
    [
        element(I, Tuple) bxor element(J, Tuple)
     || I <- lists:seq(1, Size), J <- lists:seq(I + 1, Size)
    ].

%% Folds over the sums of three, which are too many for a list when the packet is long.
over_triples(Fun, Acc, Tuple) ->
    Size = tuple_size(Tuple),
    lists:foldl(
        fun(I, Acc1) ->
            Rest = lists:seq(I + 1, Size),
            lists:foldl(
                fun(J, Acc2) ->
                    Two = element(I, Tuple) bxor element(J, Tuple),
                    third(Fun, Acc2, Two, J + 1, Tuple)
                end,
                Acc1,
                Rest
            )
        end,
        Acc,
        lists:seq(1, Size)
    ).

third(_, Acc, _, K, Tuple) when K > tuple_size(Tuple) -> Acc;
third(Fun, Acc, Two, K, Tuple) ->
    third(Fun, Fun(Two bxor element(K, Tuple), Acc), Two, K + 1, Tuple).

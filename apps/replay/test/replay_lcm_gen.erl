%% @doc Generators: any message of a type, written from the type itself; bytes that come close.
-module(replay_lcm_gen).
-include_lib("proper/include/proper.hrl").

-export([type/0, message/1, damaged/1]).

%% Types with a channel of their own; the others are parts of these.
type() -> elements([Type || {Type, _} <- replay_lcm:channels()]).

%% Complete, as decoding gives it: with the counts.
message(Type) ->
    #{fields := Fields, counts := Counts} = replay_lcm_type:struct(Type),
    Named = [{Name, member(Base, Dimensions)}
             || {Name, Base, Dimensions} <- Fields, not is_map_key(Name, Counts)],
    ?LET(Members, Named, counted(maps:from_list(Members), Counts)).

counted(Members, Counts) ->
    maps:fold(fun(Count, Array, M) -> M#{Count => length(maps:get(Array, Members))} end,
              Members, Counts).

member(Base, []) -> value(Base);
member(Base, [Size | Rest]) when is_integer(Size) -> vector(Size, member(Base, Rest));
member(Base, [_Count | Rest]) -> ?LET(N, integer(0, 6), vector(N, member(Base, Rest))).

value({struct, Type}) -> message(Type);
value(int8_t) -> whole(8);
value(int32_t) -> whole(32);
value(int64_t) -> whole(64);
value(float) -> real(float_of_32_bits());
value(double) -> real(oneof([float(), 1.7976931348623157e308, 5.0e-324]));
value(string) -> text().

%% Limits often: there the sign and the size matter.
whole(Bits) ->
    Max = (1 bsl (Bits - 1)) - 1,
    frequency([{1, Max}, {1, -Max - 1}, {1, -1}, {2, integer(-100, 100)},
               {2, integer(-Max - 1, Max)}]).

real(Finite) ->
    frequency([{8, Finite}, {1, elements([inf, neg_inf, nan, -0.0])}]).

%% What 32 bits can hold, so that it comes back as it went.
float_of_32_bits() ->
    ?LET(Bits, oneof([integer(0, 16#7f7fffff), 1, 16#7f7fffff, 16#00800000]),
         ?LET(Sign, elements([0, 16#80000000]), of_bits(Bits bor Sign))).

of_bits(Bits) ->
    <<X:32/float>> = <<Bits:32>>,
    X.

text() ->
    Character = oneof([integer(1, 127), integer(128, 16#7ff), integer(16#e000, 16#fffd),
                       integer(16#10000, 16#10ffff)]),
    ?LET(Characters, list(Character), unicode:characters_to_binary(Characters)).

%% Bytes with something changed: a piece lost, doubled or replaced, often by a count at its limit.
damaged(Bytes) ->
    ?LET({At, Length, Piece}, {integer(0, byte_size(Bytes)), integer(0, 12), piece()},
         begin
             <<Before:At/binary, Rest/binary>> = Bytes,
             Skipped = min(Length, byte_size(Rest)),
             <<_:Skipped/binary, After/binary>> = Rest,
             <<Before/binary, Piece/binary, After/binary>>
         end).

piece() ->
    oneof([<<>>, binary(), <<16#7fffffff:32>>, <<-1:32>>, <<16#80000000:32>>, <<0:32>>,
           ?LET(N, integer(0, 16#ffff), <<N:32>>)]).

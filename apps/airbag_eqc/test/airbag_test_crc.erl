%% @doc For tests: which corruption masks the CRC of profile 1 cannot see, computed bit by bit.
%%
%% With its start value and final XOR of profile 1 the CRC is linear: it misses a mask whose CRC
%% byte is the CRC of its other protected bytes, whatever the packet and the Data ID are.
-module(airbag_test_crc).

-export([misses/2]).

-spec misses(thesis | recommended, airbag_exhaustive:mask()) -> boolean().
misses(thesis, [Crc, First, _, _]) -> Crc =:= crc([First]);
misses(recommended, [Crc | Protected]) -> Crc =:= crc(Protected).

crc(Bytes) -> lists:foldl(fun(Byte, Remainder) -> crc8(Byte bxor Remainder, 8) end, 0, Bytes).

%% The polynomial is 1D.
crc8(Remainder, 0) -> Remainder;
crc8(Remainder, N) when Remainder >= 16#80 ->
    crc8(((Remainder bsl 1) bxor 16#1D) band 16#FF, N - 1);
crc8(Remainder, N) ->
    crc8(Remainder bsl 1, N - 1).

%% @doc The checksum of E2E profile 1 of a difference between two packets: the CRC 1D without its
%% start value and final XOR.
%%
%% The checksum is linear: that of packet A XOR that of packet B is that of A XOR B, whatever the
%% Data ID.
-module(airbag_crc).

-export([of_difference/1]).

-define(POLYNOMIAL, 16#1D).

%% @doc The difference of two checksums, from the difference of the protected bytes.
-spec of_difference([byte()]) -> byte().
of_difference(Bytes) ->
    lists:foldl(fun(Byte, Rest) -> shifted(Byte bxor Rest, 8) end, 0, Bytes).

shifted(Rest, 0) -> Rest;
shifted(Rest, N) when Rest >= 16#80 ->
    shifted((Rest bsl 1) bxor (16#100 bor ?POLYNOMIAL), N - 1);
shifted(Rest, N) -> shifted(Rest bsl 1, N - 1).

%% @doc IEEE-754 numbers of 32 and 64 bits as bytes, those included that are no Erlang floats.
-module(replay_lcm_real).

-export([bytes/2, number/1]).

%% @doc Big endian. What is too large for the size becomes infinite.
-spec bytes(32 | 64, number() | inf | neg_inf | nan) -> binary().
bytes(32, inf) -> <<16#7f800000:32>>;
bytes(32, neg_inf) -> <<16#ff800000:32>>;
bytes(32, nan) -> <<16#7fc00000:32>>;
bytes(64, inf) -> <<16#7ff00000:32, 0:32>>;
bytes(64, neg_inf) -> <<16#fff00000:32, 0:32>>;
bytes(64, nan) -> <<16#7ff80000:32, 0:32>>;
bytes(Bits, X) when is_number(X) ->
    try <<X:Bits/float>>
    catch error:badarg -> bytes(Bits, if X > 0 -> inf; true -> neg_inf end)
    end.

%% @doc The number in 4 or 8 bytes.
-spec number(binary()) -> replay_lcm:real().
number(<<X:32/float>>) -> X;
number(<<X:64/float>>) -> X;
number(<<0:1, 255, 0:23>>) -> inf;
number(<<1:1, 255, 0:23>>) -> neg_inf;
number(<<_:1, 255, _:23>>) -> nan;
number(<<0:1, 2047:11, 0:52>>) -> inf;
number(<<1:1, 2047:11, 0:52>>) -> neg_inf;
number(<<_:1, 2047:11, _:52>>) -> nan.

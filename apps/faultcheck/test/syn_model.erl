%% Forty kinds of commands, three of which matter: a(X), later b(Y, L) with Y > X + 5 and at
%% least two elements in L, later c(Z) with Z > Y and Z >= 100.
-module(syn_model).

-include("faultcheck.hrl").

-export([reset/0]).

reset() ->
    put(syn, none),
    ok.

initial_state() -> none.

a_args(_) -> [integer()].
a(X) -> put(syn, {a, X}), ok.

b_args(_) -> [integer(), list(integer())].
b(Y, L) ->
    case get(syn) of
        {a, X} when Y > X + 5, length(L) >= 2 -> put(syn, {b, X, Y}), ok;
        _ -> ok
    end.

c_args(_) -> [integer(0, 1000)].
c(Z) ->
    case get(syn) of
        {b, _, Y} when Z > Y, Z >= 100 -> boom;
        _ -> ok
    end.
c_post(_, [_], Answer) -> Answer =:= ok.

n1_args(_) -> [list(integer(0, 9))].
n1(_) -> ok.
n2_args(_) -> [binary()].
n2(_) -> ok.
n3_args(_) -> [oneof([a, b, integer()])].
n3(_) -> ok.
n4_args(_) -> [boolean()].
n4(_) -> ok.
n5_args(_) -> [{byte(), byte()}].
n5(_) -> ok.
n6_args(_) -> [integer()].
n6(_) -> ok.
n7_args(_) -> [list(integer(0, 9))].
n7(_) -> ok.
n8_args(_) -> [binary()].
n8(_) -> ok.
n9_args(_) -> [oneof([a, b, integer()])].
n9(_) -> ok.
n10_args(_) -> [boolean()].
n10(_) -> ok.
n11_args(_) -> [{byte(), byte()}].
n11(_) -> ok.
n12_args(_) -> [integer()].
n12(_) -> ok.
n13_args(_) -> [list(integer(0, 9))].
n13(_) -> ok.
n14_args(_) -> [binary()].
n14(_) -> ok.
n15_args(_) -> [oneof([a, b, integer()])].
n15(_) -> ok.
n16_args(_) -> [boolean()].
n16(_) -> ok.
n17_args(_) -> [{byte(), byte()}].
n17(_) -> ok.
n18_args(_) -> [integer()].
n18(_) -> ok.
n19_args(_) -> [list(integer(0, 9))].
n19(_) -> ok.
n20_args(_) -> [binary()].
n20(_) -> ok.
n21_args(_) -> [oneof([a, b, integer()])].
n21(_) -> ok.
n22_args(_) -> [boolean()].
n22(_) -> ok.
n23_args(_) -> [{byte(), byte()}].
n23(_) -> ok.
n24_args(_) -> [integer()].
n24(_) -> ok.
n25_args(_) -> [list(integer(0, 9))].
n25(_) -> ok.
n26_args(_) -> [binary()].
n26(_) -> ok.
n27_args(_) -> [oneof([a, b, integer()])].
n27(_) -> ok.
n28_args(_) -> [boolean()].
n28(_) -> ok.
n29_args(_) -> [{byte(), byte()}].
n29(_) -> ok.
n30_args(_) -> [integer()].
n30(_) -> ok.
n31_args(_) -> [list(integer(0, 9))].
n31(_) -> ok.
n32_args(_) -> [binary()].
n32(_) -> ok.
n33_args(_) -> [oneof([a, b, integer()])].
n33(_) -> ok.
n34_args(_) -> [boolean()].
n34(_) -> ok.
n35_args(_) -> [{byte(), byte()}].
n35(_) -> ok.
n36_args(_) -> [integer()].
n36(_) -> ok.
n37_args(_) -> [list(integer(0, 9))].
n37(_) -> ok.

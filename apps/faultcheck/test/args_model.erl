%% Arguments of every kind of type.
-module(args_model).

-include("faultcheck.hrl").

-export([reset/0]).

reset() -> ok.

initial_state() -> none.

wide_args(_) -> [uniform(0, 1 bsl 44)].
wide(_) -> ok.

negative_args(_) -> [integer(-100000, -10)].
negative(_) -> ok.

even_args(_) -> [?SUCHTHAT(X, uniform(0, 100000000), X rem 2 =:= 0)].
even(_) -> ok.

real_args(_) -> [float()].
real(_) -> ok.

choice_args(_) -> [oneof([a, b, frequency([{1, {single, integer()}},
                                           {2, {pair, integer(0, 1000), boolean()}}])])].
choice(_) -> ok.

nested_args(_) -> [list(list(integer()))].
nested(_) -> ok.

bytes_args(_) -> [binary()].
bytes(_) -> ok.

dependent_args(_) -> [?LET(N, integer(0, 9), {N, vector(N, integer(0, 99))})].
dependent(_) -> ok.

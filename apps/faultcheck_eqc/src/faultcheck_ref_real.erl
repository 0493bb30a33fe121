%% @doc IEEE-754 arithmetic where Erlang's stops: with infinities, NaN and signed zeros.
%%
%% `any' is a number that nobody can know: a bit of a NaN was changed, and which bits a NaN has
%% is not said anywhere.
-module(faultcheck_ref_real).

-export([param/1, add/2, subtract/2, multiply/2, divide/2, less/2, floor/1, magnitude/1]).
-export([decode/2, encode/2]).
-export_type([real/0, word/0]).

-type real() :: float() | inf | neg_inf | nan | any.
%% The bits of a float, or that it is some NaN, or not known.
-type word() :: non_neg_integer() | nan | any.

%% @doc A parameter as C gets it.
-spec param(number() | atom()) -> real().
param(none) -> inf;
param(N) when is_integer(N) -> float(N);
param(R) -> R.

-spec add(real(), real()) -> real().
add(any, _) -> any;
add(_, any) -> any;
add(nan, _) -> nan;
add(_, nan) -> nan;
add(inf, neg_inf) -> nan;
add(neg_inf, inf) -> nan;
add(X, _) when is_atom(X) -> X;
add(_, Y) when is_atom(Y) -> Y;
add(X, Y) -> finite(fun() -> X + Y end, X < 0).

-spec subtract(real(), real()) -> real().
subtract(X, Y) -> add(X, negate(Y)).

negate(inf) -> neg_inf;
negate(neg_inf) -> inf;
negate(F) when is_float(F) -> -F;
negate(R) -> R.

-spec multiply(real(), real()) -> real().
multiply(any, _) -> any;
multiply(_, any) -> any;
multiply(nan, _) -> nan;
multiply(_, nan) -> nan;
multiply(X, Y) when is_float(X), is_float(Y) ->
    finite(fun() -> X * Y end, negative(X) =/= negative(Y));
multiply(X, Y) ->
    case is_zero(X) orelse is_zero(Y) of
        true -> nan;
        false -> infinity(negative(X) =/= negative(Y))
    end.

%% @doc The divisor is above 0.
-spec divide(real(), real()) -> real().
divide(any, _) -> any;
divide(_, any) -> any;
divide(nan, _) -> nan;
divide(X, inf) when is_atom(X) -> nan;
divide(X, _) when is_atom(X) -> X;
divide(X, inf) -> 0.0 * X;
divide(X, Y) -> finite(fun() -> X / Y end, negative(X)).

%% @doc `any' compares as if it were a NaN: callers ask for it first.
-spec less(real(), real()) -> boolean().
less(X, Y) -> (not_a_number(X) orelse not_a_number(Y)) =:= false andalso rank(X) < rank(Y).

not_a_number(X) -> X =:= nan orelse X =:= any.

rank(neg_inf) -> {-1, 0};
rank(inf) -> {1, 0};
rank(F) -> {0, F}.

-spec floor(real()) -> real().
floor(F) when is_float(F) -> math:floor(F);
floor(R) -> R.

-spec magnitude(real()) -> real().
magnitude(neg_inf) -> inf;
magnitude(F) when is_float(F) -> abs(F);
magnitude(R) -> R.

finite(Compute, Negative) ->
    try Compute()
    catch error:badarith -> infinity(Negative)
    end.

infinity(true) -> neg_inf;
infinity(false) -> inf.

is_zero(X) -> is_float(X) andalso X == 0.

negative(inf) -> false;
negative(neg_inf) -> true;
negative(F) ->
    <<Sign:1, _:63>> = <<F/float>>,
    Sign =:= 1.

%% ---- words ------------------------------------------------------------------------------------

%% @doc The number that the bits of a float are.
-spec decode(f32 | f64, word()) -> real().
decode(_, Atom) when is_atom(Atom) -> Atom;
decode(f64, Word) -> decode(<<Word:64>>, 11, 52);
decode(f32, Word) -> decode(<<Word:32>>, 8, 23).

decode(Bits, Exponent, Fraction) ->
    Ones = (1 bsl Exponent) - 1,
    case Bits of
        <<0:1, Ones:Exponent, 0:Fraction>> -> inf;
        <<1:1, Ones:Exponent, 0:Fraction>> -> neg_inf;
        <<_:1, Ones:Exponent, _:Fraction>> -> nan;
        <<F:64/float>> -> F;
        <<F:32/float>> -> F
    end.

%% @doc The bits of a number, rounded to the type.
-spec encode(f32 | f64, real()) -> word().
encode(_, R) when R =:= nan; R =:= any -> R;
encode(f64, inf) -> 16#7FF0000000000000;
encode(f64, neg_inf) -> 16#FFF0000000000000;
encode(f32, inf) -> 16#7F800000;
encode(f32, neg_inf) -> 16#FF800000;
encode(f64, F) ->
    <<Word:64>> = <<F:64/float>>,
    Word;
encode(f32, F) ->
    try
        <<Word:32>> = <<F:32/float>>,
        Word
    catch
        error:badarg -> encode(f32, infinity(F < 0))
    end.

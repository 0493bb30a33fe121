%% @doc Typed values: bits, conversion to and from computed numbers (faultcheck.md, 2, 5.2, 7.2).
%%
%% Floats are their bits (faultcheck_ref_real:word/0), integers integers, a bool 0 or 1, bytes a
%% binary. `{near, Number, Tolerance}' is what a sine was added to, as its last digit is the
%% library's own; whatever is computed from it is not known.
-module(faultcheck_ref_value).

-export([new/2, width/2, flip/3, force/4, real/2, convert/3, convert_exactly/2, zero/2]).
-export([unsure/1, near/4, matches/3]).
-export([limits/1, is_float_type/1]).
-export_type([value/0, type/0]).

-type type() :: faultcheck_fault:value_type().
-type value() ::
    integer()
    | binary()
    | faultcheck_ref_real:word()
    | {near, faultcheck_ref_real:real(), float()}.

%% @doc From how commands show it: floats as numbers or inf, neg_inf, nan.
-spec new(type(), term()) -> value().
new(f32, nan) -> 16#7FC00000;
new(f64, nan) -> 16#7FF8000000000000;
new(Type, V) when Type =:= f32; Type =:= f64 -> faultcheck_ref_real:encode(Type, V);
new(_, V) -> V.

-spec is_float_type(type()) -> boolean().
is_float_type(Type) -> Type =:= f32 orelse Type =:= f64.

%% @doc Bits that can be flipped.
-spec width(type(), value()) -> non_neg_integer().
width(bytes, Bytes) -> 8 * byte_size(Bytes);
width(bool, _) -> 1;
width(Type, _) -> bits(Type).

bits(f32) -> 32;
bits(f64) -> 64;
bits(Type) ->
    [_ | Digits] = atom_to_list(Type),
    list_to_integer(Digits).

signed(Type) -> hd(atom_to_list(Type)) =:= $i.

-spec limits(type()) -> {integer(), integer()}.
limits(bool) -> {0, 1};
limits(Type) ->
    Bits = bits(Type),
    case signed(Type) of
        true -> {-(1 bsl (Bits - 1)), (1 bsl (Bits - 1)) - 1};
        false -> {0, (1 bsl Bits) - 1}
    end.

%% @doc One bit inverted; it is below width/2.
-spec flip(type(), non_neg_integer(), value()) -> value().
flip(Type, Bit, V) -> with_bit(Type, Bit, V, fun(B) -> 1 - B end).

%% @doc One bit forced.
-spec force(type(), non_neg_integer(), 0..1, value()) -> value().
force(Type, Bit, To, V) -> with_bit(Type, Bit, V, fun(_) -> To end).

with_bit(bytes, Bit, Bytes, Change) ->
    At = Bit div 8,
    <<Before:At/binary, Byte, After/binary>> = Bytes,
    <<Before/binary, (with_bit(u8, Bit rem 8, Byte, Change)), After/binary>>;
with_bit(_, _, V, _) when is_atom(V); is_tuple(V) ->
    any;
with_bit(bool, 0, V, Change) ->
    Change(V);
with_bit(Type, Bit, V, Change) ->
    Bits = bits(Type),
    <<Word:Bits>> = <<V:Bits>>,
    Old = (Word bsr Bit) band 1,
    New = (Word bxor (Old bsl Bit)) bor (Change(Old) bsl Bit),
    case not is_float_type(Type) andalso signed(Type) of
        true ->
            <<Signed:Bits/signed>> = <<New:Bits>>,
            Signed;
        false ->
            New
    end.

%% @doc The value as a double.
-spec real(type(), value()) -> faultcheck_ref_real:real().
real(_, {near, _, _}) -> any;
real(_, any) -> any;
real(Type, Word) when Type =:= f32; Type =:= f64 -> faultcheck_ref_real:decode(Type, Word);
real(_, Integer) -> float(Integer).

%% @doc A computed number as the type; `skip' when it has none.
-spec convert(type(), faultcheck_ref_real:real(), value()) -> {ok | skip | unsure, value()}.
convert(Type, Real, _) when Type =:= f32; Type =:= f64 ->
    {ok, faultcheck_ref_real:encode(Type, Real)};
convert(_, any, _) -> {unsure, any};
convert(_, nan, Old) -> {skip, Old};
convert(bool, Real, _) -> {ok, case Real == 0 of true -> 0; false -> 1 end};
convert(Type, inf, _) -> {ok, element(2, limits(Type))};
convert(Type, neg_inf, _) -> {ok, element(1, limits(Type))};
convert(Type, Real, _) -> {ok, convert_exactly(Type, trunc(Real))}.

%% @doc Limited to the type.
-spec convert_exactly(type(), integer()) -> integer().
convert_exactly(Type, Integer) ->
    {Low, High} = limits(Type),
    min(max(Integer, Low), High).

%% @doc All bits 0.
-spec zero(type(), value()) -> value().
zero(bytes, Bytes) -> binary:copy(<<0>>, byte_size(Bytes));
zero(_, _) -> 0.

%% @doc What is left to know of a value after something unknown has happened to it.
-spec unsure(value()) -> boolean().
unsure(V) -> V =:= any orelse is_tuple(V).

%% @doc A number whose last digits are not known, as the type.
-spec near(type(), faultcheck_ref_real:real(), float(), value()) -> {ok | skip | unsure, value()}.
near(Type, Real, Tolerance, Old) when not is_float(Real); Type =:= bool ->
    _ = Tolerance,
    case Type of
        bool when is_float(Real) -> {ok, any};
        _ -> convert(Type, Real, Old)
    end;
near(Type, Real, Tolerance, _) when Type =:= f32; Type =:= f64 ->
    {ok, {near, Real, Tolerance + rounding(Type, Real)}};
near(Type, Real, Tolerance, Old) ->
    {ok, Integer} = convert(Type, Real, Old),
    {ok, {near, float(Integer), 1.0 + Tolerance}}.

rounding(f32, Real) -> abs(Real) * 1.2e-7;
rounding(f64, Real) -> abs(Real) * 4.5e-16.

%% @doc Is this value of the library the expected one?
-spec matches(type(), value(), value()) -> boolean().
matches(_, any, _) -> true;
matches(Type, nan, Word) -> faultcheck_ref_real:decode(Type, Word) =:= nan;
matches(Type, {near, Real, Tolerance}, V) ->
    case real(Type, V) of
        Got when is_float(Got) -> abs(Got - Real) =< Tolerance;
        Infinite -> abs(Real) > 1.0e308 andalso is_atom(Infinite) orelse
                        (Type =:= f32 andalso abs(Real) > 3.40e38)
    end;
matches(_, Expected, Got) -> Expected =:= Got.

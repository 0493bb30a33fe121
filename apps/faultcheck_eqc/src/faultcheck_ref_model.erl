%% @doc What a fault model does to one value (faultcheck.md, 2, 5, 7.2, 7.6).
%%
%% Where the document leaves room, this is what libfaultcheck's headers and tests say: what a
%% window remembers is kept per probed type; whole contents that are put back cover the length
%% both have; a model that the type has no use for neither draws nor counts; a spike draws its
%% sign as an integer below 2, 0 being up.
-module(faultcheck_ref_model).

-import(faultcheck_ref_real, [param/1, add/2, subtract/2, multiply/2, divide/2, less/2]).

-export([new_window/0, apply/5]).
-export_type([window/0, code/0]).

-type code() :: 'FC_OK' | 'FC_E_BIT' | 'FC_E_VALUE' | 'FC_E_TYPE' | 'FC_E_INDEX' | unsure.
%% What is remembered since the window's first affected call: k, its time, and for each type the
%% inputs (the latest first) or the value that got through last.
-type window() :: #{k := non_neg_integer(), time => integer(), type() => term()}.
-type type() :: faultcheck_fault:value_type().
-type value() :: faultcheck_ref_value:value().
-type stream() :: faultcheck_ref_stream:stream().

-spec new_window() -> window().
new_window() -> #{k => 0}.

%% @doc The fault is triggered in this call.
-spec apply(faultcheck_fault:value_model(), {type(), value()}, Now :: integer(), window(),
            stream()) -> {code(), value(), window(), stream()}.
apply({Bits, Bit}, {Type, V}, _, W, S) when Bits =:= bitflip ->
    with_bit(Bit, {Type, V}, W, S, fun() -> faultcheck_ref_value:flip(Type, Bit, V) end);
apply({stuck_bit, Bit, To}, {Type, V}, _, W, S) ->
    with_bit(Bit, {Type, V}, W, S, fun() -> faultcheck_ref_value:force(Type, Bit, To, V) end);
apply(bitflip_random, {Type, V}, _, W, S) ->
    case faultcheck_ref_value:width(Type, V) of
        0 ->
            {'FC_E_BIT', V, W, S};
        Width ->
            {Bit, Next} = faultcheck_ref_stream:below(Width, S),
            {'FC_OK', faultcheck_ref_value:flip(Type, Bit, V), W, Next}
    end;
apply(stuck, {Type, V}, _, W, S) ->
    First = maps:get(Type, W, V),
    {'FC_OK', restored(First, V), W#{Type => First}, S};
apply({delay, {calls, N}}, {Type, V}, _, W, S) ->
    Inputs = maps:get(Type, W, []) ++ [V],
    Delayed = lists:nth(max(1, length(Inputs) - N), Inputs),
    {'FC_OK', restored(Delayed, V), W#{Type => Inputs}, S};
apply({set_to, Real}, {bytes, V}, _, W, S) ->
    {Code, Filled} = fill(param(Real), V),
    {Code, Filled, W, S};
apply(_, {bytes, V}, _, W, S) ->
    {'FC_E_TYPE', V, W, S};
apply({dropout, P, Mode}, {Type, V}, _, W, S) ->
    case Mode =:= nan andalso not faultcheck_ref_value:is_float_type(Type) of
        true -> {'FC_E_TYPE', V, W, S};
        false -> dropout(float(P), Mode, {Type, V}, W, S)
    end;
apply({Name, Real}, {Type, V}, _, W, S) when
    Name =:= amplification; Name =:= offset; Name =:= set_to
->
    {Code, Result} = arithmetic(Name, param(Real), Type, V),
    {Code, Result, W, S};
apply(Model, {Type, V}, Now, #{k := K} = W, S) ->
    X = faultcheck_ref_value:real(Type, V),
    Window = remember(Model, Type, X, Now, W),
    {Held, Drawn} = held(Model, Now, Window, S),
    {Result, Next} = sensor(Model, X, maps:get(Type, Held, X), {K, Now}, Held, Drawn),
    {Code, Converted} = converted(Model, Type, Result, V),
    {Code, Converted, Held#{k := K + 1}, Next}.

with_bit(Bit, {Type, V}, W, S, Change) ->
    case Bit < faultcheck_ref_value:width(Type, V) of
        true -> {'FC_OK', Change(), W, S};
        false -> {'FC_E_BIT', V, W, S}
    end.

restored(Kept, V) when is_binary(V) ->
    Common = min(byte_size(Kept), byte_size(V)),
    Rest = binary:part(V, Common, byte_size(V) - Common),
    <<(binary:part(Kept, 0, Common))/binary, Rest/binary>>;
restored(Kept, _) ->
    Kept.

fill(Real, V) when is_float(Real), Real > -1.0, Real < 256.0 ->
    {'FC_OK', binary:copy(<<(trunc(Real))>>, byte_size(V))};
fill(_, V) ->
    {'FC_E_VALUE', V}.

dropout(P, Mode, {Type, V}, W, S) ->
    {Unit, Next} = faultcheck_ref_stream:unit(S),
    Held = maps:get(Type, W, V),
    case {Unit < P, Mode} of
        {false, _} -> {'FC_OK', V, W#{Type => V}, Next};
        {true, hold} -> {'FC_OK', Held, W#{Type => Held}, Next};
        {true, zero} -> {'FC_OK', faultcheck_ref_value:zero(Type, V), W#{Type => Held}, Next};
        {true, nan} -> {'FC_OK', nan, W#{Type => Held}, Next}
    end.

%% ---- section 2 --------------------------------------------------------------------------------

%% 64-bit integers with a whole parameter: exactly.
arithmetic(Name, Real, Type, V) when
    (Type =:= i64 orelse Type =:= u64), is_float(Real), is_integer(V)
->
    case Real == math:floor(Real) of
        true ->
            Exact = exactly(Name, V, trunc(Real)),
            {'FC_OK', faultcheck_ref_value:convert_exactly(Type, Exact)};
        false ->
            through_double(Name, Real, Type, V)
    end;
arithmetic(Name, Real, Type, V) ->
    through_double(Name, Real, Type, V).

exactly(amplification, V, Whole) -> V * Whole;
exactly(offset, V, Whole) -> V + Whole;
exactly(set_to, _, Whole) -> Whole.

through_double(Name, Real, Type, V) ->
    X = faultcheck_ref_value:real(Type, V),
    Result =
        case Name of
            amplification -> multiply(X, Real);
            offset -> add(X, Real);
            set_to -> Real
        end,
    code(faultcheck_ref_value:convert(Type, Result, V)).

code({ok, V}) -> {'FC_OK', V};
code({skip, V}) -> {'FC_E_VALUE', V};
code({unsure, V}) -> {unsure, V}.

%% ---- section 7.6 ------------------------------------------------------------------------------

remember({ramp, _, _}, Type, X, _, W) -> maps:merge(#{Type => X}, W);
remember({drift_timed, _, _}, _, _, Now, W) -> maps:merge(#{time => Now}, W);
remember({held_offset, _, _, _}, _, _, Now, W) -> maps:merge(#{time => Now}, W);
remember(_, _, _, _, W) -> W.

%% One draw for all calls of a period; periods begin with the window.
held({held_offset, _, _, Ns}, Now, #{time := Start} = W, S) ->
    Period = (Now - Start) div Ns,
    case W of
        #{period := Period} ->
            {W, S};
        _ ->
            {Unit, Next} = faultcheck_ref_stream:unit(S),
            {W#{period => Period, unit => Unit}, Next}
    end;
held(_, _, W, S) ->
    {W, S}.

sensor({noise_uniform, A}, X, _, _, _, S) ->
    {Unit, Next} = faultcheck_ref_stream:unit(S),
    {add(X, multiply(param(A), 2 * Unit - 1)), Next};
sensor({noise_gauss, Deviation}, X, _, _, _, S) ->
    {Gauss, Next} = faultcheck_ref_stream:gauss(S),
    {add(X, multiply(param(Deviation), Gauss)), Next};
sensor({random_offset, Low, High}, X, _, _, _, S) ->
    {Unit, Next} = faultcheck_ref_stream:unit(S),
    Range = subtract(param(High), param(Low)),
    {add(add(X, param(Low)), multiply(Range, Unit)), Next};
sensor({held_offset, Low, High, _}, X, _, _, #{unit := Unit}, S) ->
    Range = subtract(param(High), param(Low)),
    {add(add(X, param(Low)), multiply(Range, Unit)), S};
sensor({spike, P, Height}, X, _, _, _, S) ->
    case faultcheck_ref_stream:unit(S) of
        {Unit, Next} when Unit < P ->
            case faultcheck_ref_stream:below(2, Next) of
                {0, Last} -> {add(X, param(Height)), Last};
                {1, Last} -> {subtract(X, param(Height)), Last}
            end;
        {_, Next} ->
            {X, Next}
    end;
sensor(Model, X, First, Call, Window, S) ->
    {certain(Model, X, First, Call, Window), S}.

certain({drift, Rate, Limit}, X, _, {K, _}, _) ->
    add(X, limited(multiply(param(Rate), float(K + 1)), param(Limit)));
certain({drift_timed, Rate, Limit}, X, _, {_, Now}, #{time := Start}) ->
    add(X, limited(multiply(param(Rate), (Now - Start) * 1.0e-9), param(Limit)));
certain({ramp, V, N}, _, First, {K, _}, _) ->
    Step = float(min(K + 1, N)),
    add(First, divide(multiply(subtract(param(V), First), Step), float(N)));
certain({quantise, Step}, X, _, _, _) ->
    Q = param(Step),
    multiply(Q, faultcheck_ref_real:floor(add(divide(X, Q), 0.5)));
certain({dead_zone, Centre, Width}, X, _, _, _) ->
    C = param(Centre),
    case less(faultcheck_ref_real:magnitude(subtract(X, C)), param(Width)) of
        _ when X =:= any -> any;
        true -> C;
        false -> X
    end;
certain({saturate, Low, High}, X, _, _, _) ->
    at_most(param(High), at_least(param(Low), X));
certain({oscillate, A, N}, X, _, {K, _}, _) ->
    add(X, multiply(param(A), math:sin(2 * math:pi() * (K rem N) / N))).

limited(Drift, Limit) -> at_most(Limit, at_least(subtract(0.0, Limit), Drift)).

at_least(_, any) -> any;
at_least(Low, X) ->
    case less(X, Low) of
        true -> Low;
        false -> X
    end.

at_most(_, any) -> any;
at_most(High, X) ->
    case less(High, X) of
        true -> High;
        false -> X
    end.

%% The library computes the sine itself; the document does not say how.
converted({oscillate, A, _}, Type, Result, V) ->
    Tolerance =
        case param(A) of
            Amplitude when is_float(Amplitude) -> abs(Amplitude) * 1.0e-15;
            _ -> 0.0
        end,
    code(faultcheck_ref_value:near(Type, Result, Tolerance, V));
converted(_, Type, Result, V) ->
    code(faultcheck_ref_value:convert(Type, Result, V)).

%% @doc What is written through `set' is read back equal, for every scalar type, in both transports.
-module(prop_cb).

-include_lib("proper/include/proper.hrl").

-export([prop_scalars_are_read_back/0]).

prop_scalars_are_read_back() ->
    ?SETUP(
        fun start/0,
        ?FORALL({Variable, Value}, assignment(), begin
            Written = [cb:set(Name, Variable, Value) || Name <- names()],
            Read = [cb:value_of(Name, Variable) || Name <- names()],
            {[ok, ok], [Value, Value]} =:= {Written, Read}
        end)
    ).

names() -> [prop_cb_nif, prop_cb_port].

start() ->
    [
        cb_sut:start(Name, "arithmetic.c", [{transport, Transport}, {module, false}])
     || {Name, Transport} <- lists:zip(names(), [nif, port])
    ],
    fun() -> lists:foreach(fun cb:stop/1, names()) end.

%% Limits and their neighbours are as likely as all values between them together.
assignment() ->
    oneof([{Variable, number(Type)} || {Variable, Type} <- variables()]).

variables() ->
    [
        {g_schar, {signed, 8}},
        {g_uchar, {unsigned, 8}},
        {g_char, {signed, 8}},
        {g_short, {signed, 16}},
        {g_ushort, {unsigned, 16}},
        {g_int, {signed, 32}},
        {g_uint, {unsigned, 32}},
        {g_long, {signed, 64}},
        {g_ulong, {unsigned, 64}},
        {g_llong, {signed, 64}},
        {g_ullong, {unsigned, 64}},
        {g_int8, {signed, 8}},
        {g_uint64, {unsigned, 64}},
        {g_size, {unsigned, 64}},
        {g_bool, bool},
        {g_level, level},
        {g_float, float32},
        {g_double, float64}
    ].

number({signed, Bits}) -> between(-(1 bsl (Bits - 1)), (1 bsl (Bits - 1)) - 1);
number({unsigned, Bits}) -> between(0, (1 bsl Bits) - 1);
number(bool) -> boolean();
number(level) -> oneof(['LOW', 'MIDDLE', 'HIGH', 1, 6, 100]);
number(float32) -> oneof([nan, inf, neg_inf, ?LET(Bits, between(0, 16#ffffffff), single(Bits))]);
number(float64) -> oneof([nan, inf, neg_inf, float()]).

between(Low, High) -> oneof([Low, Low + 1, 0, 1, High - 1, High, integer(Low, High)]).

%% Only numbers that a float of C holds exactly.
single(Bits) ->
    case <<Bits:32>> of
        <<Single:32/float>> -> Single;
        _ -> 0.5
    end.

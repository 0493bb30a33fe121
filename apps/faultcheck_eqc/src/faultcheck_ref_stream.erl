%% @doc The stream of random numbers of a fault (faultcheck.md, 7.3): SplitMix64.
-module(faultcheck_ref_stream).

-export([new/3, below/2, unit/1, gauss/1]).
-export_type([stream/0]).

-opaque stream() :: non_neg_integer().

-define(GAMMA, 16#9E3779B97F4A7C15).
-define(MASK, 16#FFFFFFFFFFFFFFFF).

%% @doc Ordinal: how many faults the identifier had been given before.
-spec new(Seed :: non_neg_integer(), binary(), Ordinal :: non_neg_integer()) -> stream().
new(Seed, Identifier, Ordinal) ->
    Seed bxor fnv1a64(Identifier) bxor (Ordinal * ?GAMMA band ?MASK).

fnv1a64(Bytes) ->
    lists:foldl(
        fun(Byte, Hash) -> (Hash bxor Byte) * 16#100000001B3 band ?MASK end,
        16#CBF29CE484222325,
        binary_to_list(Bytes)).

next(State) ->
    Next = (State + ?GAMMA) band ?MASK,
    A = (Next bxor (Next bsr 30)) * 16#BF58476D1CE4E5B9 band ?MASK,
    B = (A bxor (A bsr 27)) * 16#94D049BB133111EB band ?MASK,
    {B bxor (B bsr 31), Next}.

%% @doc An integer below N, by multiply-high.
-spec below(pos_integer(), stream()) -> {non_neg_integer(), stream()}.
below(N, Stream) ->
    {Word, Next} = next(Stream),
    {Word * N bsr 64, Next}.

%% @doc The top 53 bits times 2^-53.
-spec unit(stream()) -> {float(), stream()}.
unit(Stream) ->
    {Word, Next} = next(Stream),
    {(Word bsr 11) / 9007199254740992, Next}.

%% @doc Twelve units less 6.
-spec gauss(stream()) -> {float(), stream()}.
gauss(Stream) ->
    {Sum, Last} = lists:foldl(
        fun(_, {Sum, S}) ->
            {Unit, Next} = unit(S),
            {Sum + Unit, Next}
        end,
        {0.0, Stream},
        lists:seq(1, 12)),
    {Sum - 6, Last}.

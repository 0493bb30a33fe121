%% @doc Finite spaces whose items are computed from their index, so nothing is held in memory.
%%
%% A space is a map with its size and a function from 0..Size-1 to the item:
%%
%% ```
%% S = faultcheck_space:subsets([a, b, c], 2),
%% [faultcheck_space:at(I, S) || I <- lists:seq(0, 6)].
%% %% [[], [a], [b], [c], [a,b], [a,c], [b,c]]
%% '''
%%
%% faultcheck_enumerate walks through a space.
-module(faultcheck_space).

-export([items/1, subsets/2, words/2, product/2, map/2, size/1, at/2]).
-export_type([space/0, index/0]).

-type index() :: non_neg_integer().
-type space() :: #{size := non_neg_integer(), at := fun((index()) -> term())}.

%% @doc The items of a list.
-spec items([term()]) -> space().
items(List) ->
    Tuple = list_to_tuple(List),
    #{size => tuple_size(Tuple), at => fun(I) -> element(I + 1, Tuple) end}.

%% @doc Every set of at most Max elements of the list: smaller sets first, each in list order.
-spec subsets([term()], non_neg_integer()) -> space().
subsets(List, Max) when is_integer(Max), Max >= 0 ->
    N = length(List),
    Sizes = [binomial(N, K) || K <- lists:seq(0, min(Max, N))],
    #{size => lists:sum(Sizes), at => fun(I) -> subset(I, 0, Sizes, N, List) end}.

subset(I, K, [Size | Sizes], N, List) when I >= Size ->
    subset(I - Size, K + 1, Sizes, N, List);
subset(I, K, _Sizes, N, List) ->
    combination(I, N, K, List).

%% The I-th of the K-element subsets of a list of N elements, in lexicographic order.
combination(_I, _N, 0, _List) ->
    [];
combination(I, N, K, [Element | Rest]) ->
    WithElement = binomial(N - 1, K - 1),
    case I < WithElement of
        true -> [Element | combination(I, N - 1, K - 1, Rest)];
        false -> combination(I - WithElement, N - 1, K, Rest)
    end.

%% @doc Every list of at most Max elements of the alphabet, shorter lists first.
-spec words([term()], non_neg_integer()) -> space().
words(Alphabet, Max) when is_integer(Max), Max >= 0 ->
    Letters = list_to_tuple(Alphabet),
    Sizes = [power(tuple_size(Letters), K) || K <- lists:seq(0, Max)],
    #{size => lists:sum(Sizes), at => fun(I) -> word(I, 0, Sizes, Letters) end}.

word(I, K, [Size | Sizes], Letters) when I >= Size -> word(I - Size, K + 1, Sizes, Letters);
word(I, K, _Sizes, Letters) -> digits(I, K, Letters, []).

digits(_I, 0, _Letters, Word) ->
    Word;
digits(I, K, Letters, Word) ->
    Base = tuple_size(Letters),
    digits(I div Base, K - 1, Letters, [element(I rem Base + 1, Letters) | Word]).

%% @doc Every pair {A, B}; B changes fastest.
-spec product(space(), space()) -> space().
product(#{size := SizeA} = A, #{size := SizeB} = B) ->
    #{size => SizeA * SizeB, at => fun(I) -> {at(I div SizeB, A), at(I rem SizeB, B)} end}.

%% @doc The same space with each item changed by a function.
-spec map(fun((term()) -> term()), space()) -> space().
map(Fun, #{at := At} = Space) ->
    Space#{at := fun(I) -> Fun(At(I)) end}.

-spec size(space()) -> non_neg_integer().
size(#{size := Size}) -> Size.

%% @doc The item of an index, 0 .. size - 1.
-spec at(index(), space()) -> term().
at(I, #{size := Size, at := At}) when is_integer(I), I >= 0, I < Size ->
    At(I).

binomial(N, K) -> binomial(N, K, 1, 1).

binomial(_N, K, I, Product) when I > K -> Product;
binomial(N, K, I, Product) -> binomial(N, K, I + 1, Product * (N - I + 1) div I).

power(Base, K) -> lists:foldl(fun(_, P) -> P * Base end, 1, lists:seq(1, K)).

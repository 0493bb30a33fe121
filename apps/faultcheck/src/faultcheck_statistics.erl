%% @doc Numbers for reports on waiting times: quantiles, rates with censoring, and intervals.
%%
%% A sample is a list of {Cost, Found}: what a repetition cost until it found something, or until
%% it was given up (censored).
-module(faultcheck_statistics).

-export([quantile/2, sample_quantile/2, mean/1, ratio/4, events/1]).
-export_type([sample/0, statistic/0, interval/0]).

-type sample() :: [{Cost :: number(), Found :: boolean()}].
-type statistic() :: median | mean.
-type interval() :: {Low :: number(), High :: number() | infinity}.

-define(RESAMPLES, 2000).
%% of each tail of a 95 % interval
-define(TAIL, 0.025).
%% Bisection ends when the limits are this near to each other.
-define(NEAR, 1.0e-9).

%% @doc The P-quantile of a list of numbers, interpolated between neighbours.
-spec quantile(float(), [number(), ...]) -> float().
quantile(P, Numbers) -> of_sorted(P, lists:sort(Numbers)).

of_sorted(P, Sorted) ->
    Place = P * (length(Sorted) - 1),
    Index = floor(Place),
    Low = lists:nth(Index + 1, Sorted),
    High = lists:nth(min(Index + 2, length(Sorted)), Sorted),
    float(Low + (Place - Index) * (High - Low)).

%% @doc The same of a sample; {above, Cost} where it depends on repetitions that were given up.
-spec sample_quantile(float(), sample()) -> float() | {above, float()}.
sample_quantile(P, Sample) ->
    %% Those given up would have cost more than the others: they come last.
    Sorted = [Cost || {_, Cost} <- lists:sort([{not Found, Cost} || {Cost, Found} <- Sample])],
    Found = length([1 || {_, true} <- Sample]),
    case ceil(P * (length(Sample) - 1)) < Found of
        true -> of_sorted(P, Sorted);
        false -> {above, quantile(P, Sorted)}
    end.

%% @doc Cost for each find: the mean where nothing was given up; none where nothing was found.
-spec mean(sample()) -> float() | none.
mean(Sample) ->
    case length([1 || {_, true} <- Sample]) of
        0 -> none;
        Found -> lists:sum([Cost || {Cost, _} <- Sample]) / Found
    end.

%% @doc A statistic of one sample over that of another, with a 95 % interval: the percentile
%% bootstrap over 2000 resamples, from a seed. none where a median depends on censored repetitions
%% or nothing was found. A resample without finds counts as the end of the scale that it is on.
-spec ratio(statistic(), sample(), sample(), Seed :: integer()) -> {float(), interval()} | none.
ratio(Statistic, Over, Under, Seed) ->
    case {statistic(Statistic, Over), statistic(Statistic, Under)} of
        {A, B} when is_float(A), is_float(B), B > 0 ->
            Random = rand:seed_s(exsss, Seed),
            {Overs, Random1} = resampled(Statistic, Over, Random),
            {Unders, _} = resampled(Statistic, Under, Random1),
            Ratios = lists:sort([divided(X, Y) || {X, Y} <- lists:zip(Overs, Unders)]),
            {A / B, {at(?TAIL, Ratios), at(1 - ?TAIL, Ratios)}};
        _ ->
            none
    end.

statistic(median, Sample) -> sample_quantile(0.5, Sample);
statistic(mean, Sample) -> mean(Sample).

%% An atom is greater than every number.
divided(X, Y) when is_float(X), is_float(Y), Y > 0 -> X / Y;
divided(X, _) when is_float(X) -> 0.0;
divided(_, _) -> infinity.

at(P, Sorted) -> lists:nth(1 + round(P * (length(Sorted) - 1)), Sorted).

resampled(Statistic, Sample, Random) ->
    Tuple = list_to_tuple(Sample),
    lists:mapfoldl(
        fun(_, State) ->
            {Drawn, Next} = drawn(tuple_size(Tuple), Tuple, State, []),
            {statistic(Statistic, Drawn), Next}
        end,
        Random,
        lists:seq(1, ?RESAMPLES)
    ).

drawn(0, _Tuple, Random, Drawn) ->
    {Drawn, Random};
drawn(Left, Tuple, Random, Drawn) ->
    {N, Next} = rand:uniform_s(tuple_size(Tuple), Random),
    drawn(Left - 1, Tuple, Next, [element(N, Tuple) | Drawn]).

%% @doc The exact 95 % interval of the mean of a Poisson distribution that gave so many events.
-spec events(non_neg_integer()) -> interval().
events(0) ->
    {0.0, upper(0)};
events(Count) ->
    %% At the lower limit so many or more have a probability of 2.5 %.
    Low = bisect(fun(Mean) -> 1 - up_to(Count - 1, Mean) < ?TAIL end, 0.0, float(Count)),
    {Low, upper(Count)}.

upper(Count) -> bisect(fun(Mean) -> up_to(Count, Mean) > ?TAIL end, float(Count), 4.0 * Count + 10).

%% Where a condition that holds at Low ceases to hold.
bisect(Holds, Low, High) when High - Low > ?NEAR * High ->
    Middle = (Low + High) / 2,
    case Holds(Middle) of
        true -> bisect(Holds, Middle, High);
        false -> bisect(Holds, Low, Middle)
    end;
bisect(_Holds, Low, _High) ->
    Low.

%% The probability of at most Count events.
up_to(Count, Mean) ->
    {_, Sum} = lists:foldl(
        fun(I, {Term, Sum}) ->
            Next = Term * Mean / I,
            {Next, Sum + Next}
        end,
        {math:exp(-Mean), math:exp(-Mean)},
        lists:seq(1, Count)
    ),
    Sum.

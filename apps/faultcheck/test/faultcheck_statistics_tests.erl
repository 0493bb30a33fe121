-module(faultcheck_statistics_tests).
-include_lib("eunit/include/eunit.hrl").

-import(faultcheck_statistics, [quantile/2, sample_quantile/2, mean/1, ratio/4, events/1]).

quantiles_by_hand_test() ->
    ?assertEqual(2.0, quantile(0.5, [3, 1, 2])),
    ?assertEqual(2.5, quantile(0.5, [4, 1, 2, 3])),
    ?assertEqual(1.75, quantile(0.25, [4, 1, 2, 3])),
    ?assertEqual(7.0, quantile(0.75, [7])).

found(Costs) -> [{Cost, true} || Cost <- Costs].

%% Three found and two given up at 10: the median is known, the upper quartile is not.
censored_quantiles_test() ->
    Sample = found([3, 1, 20]) ++ [{10, false}, {10, false}],
    ?assertEqual(20.0, sample_quantile(0.5, Sample)),
    ?assertEqual(3.0, sample_quantile(0.25, Sample)),
    ?assertMatch({above, _}, sample_quantile(0.75, Sample)).

means_are_cost_for_each_find_test() ->
    ?assertEqual(2.0, mean(found([1, 2, 3]))),
    ?assertEqual(13.0, mean(found([1, 2]) ++ [{23, false}])),
    ?assertEqual(none, mean([{23, false}])).

%% 95 % limits of the Poisson mean, from tables of the chi-squared distribution: half of the
%% quantiles 0.025 at 2k and 0.975 at 2k + 2 degrees of freedom.
poisson_limits_test() ->
    Near = fun({A, B}, {C, D}) -> abs(A - C) < 0.005 andalso abs(B - D) < 0.005 end,
    ?assert(Near({0.0, 3.689}, events(0))),
    ?assert(Near({0.0253, 5.572}, events(1))),
    ?assert(Near({0.6187, 8.767}, events(3))),
    ?assert(Near({4.795, 18.390}, events(10))).

%% Exponential waiting times, 200 of each: the ratio of means is 4; the standard deviation of its
%% logarithm is sqrt(2/200), so the interval goes from 4 * exp(-0.196) to 4 * exp(0.196), more or
%% less.
ratio_of_means_test() ->
    {Slow, Random} = waiting(400, 200, rand:seed_s(exsss, 1)),
    {Fast, _} = waiting(100, 200, Random),
    {Ratio, {Low, High}} = ratio(mean, Slow, Fast, 7),
    ?assert(Ratio > 3.2 andalso Ratio < 5.0),
    ?assert(Low < Ratio andalso Ratio < High),
    ?assert(abs(math:log(High / Low) - 0.392) < 0.08),
    ?assertEqual({Ratio, {Low, High}}, ratio(mean, Slow, Fast, 7)).

waiting(Mean, Count, Random) ->
    lists:mapfoldl(
        fun(_, State) ->
            {U, Next} = rand:uniform_s(State),
            {{-Mean * math:log(1.0 - U), true}, Next}
        end,
        Random,
        lists:seq(1, Count)
    ).

ratio_of_medians_test() ->
    {Ratio, {Low, High}} = ratio(median, found([10, 10, 10]), found([5, 5, 5]), 1),
    ?assertEqual({2.0, 2.0, 2.0}, {Ratio, Low, High}),
    ?assertEqual(none, ratio(median, [{5, false}], found([5]), 1)),
    ?assertEqual(none, ratio(mean, [{5, false}], found([5]), 1)),
    %% resamples without finds
    {_, {_, infinity}} = ratio(mean, [{5, true}, {5, false}, {5, false}], found([5]), 1).

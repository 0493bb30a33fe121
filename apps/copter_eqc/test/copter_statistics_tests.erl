-module(copter_statistics_tests).
-include_lib("eunit/include/eunit.hrl").

%% By hand: 0 of n gives z^2 / (n + z^2); 5 of 50 from R's prop.test(5, 50, correct = FALSE).
intervals_test() ->
    {Zero, High} = copter_statistics:wilson(0, 20000),
    ?assert(Zero == 0),
    ?assert(abs(High - 3.841459 / 20003.841459) < 1.0e-9),
    {Low5, High5} = copter_statistics:wilson(5, 50),
    ?assert(abs(Low5 - 0.04347) < 1.0e-4),
    ?assert(abs(High5 - 0.21360) < 1.0e-4),
    {Low, All} = copter_statistics:wilson(10, 10),
    ?assert(abs(Low - 10 / 13.841459) < 1.0e-6),
    ?assert(abs(All - 1.0) < 1.0e-12).

rates_are_readable_test() ->
    ?assertEqual("0 % [0, 0.019]", copter_statistics:rate(0, 20000)),
    ?assertEqual("10.0 % [4.35, 21.4]", copter_statistics:rate(5, 50)).

-module(copter_figures_tests).
-include_lib("eunit/include/eunit.hrl").

%% The orderings that section 11 of docs/coptersim.md requires.
every_ordering_holds_test_() ->
    {timeout, 60, fun() ->
        {ok, _} = application:ensure_all_started(c_bridge),
        Figures = copter_figures:figures(),
        ok = copter_sut:stop(),
        ?assertEqual(7, length(Figures)),
        [?assertEqual({Name, Text, true}, {Name, Text, Holds})
         || #{name := Name, checks := Checks} <- Figures, {Text, Holds} <- Checks]
    end}.

settling_is_read_off_the_samples_test() ->
    Samples = [{Ms, Error, 0.0, 0} || {Ms, Error} <- [
        {0, 0.0}, {20, 1.5}, {40, 0.2}, {60, 0.05}, {80, 0.15}, {100, 0.02}
    ]],
    ?assertEqual(80, copter_flight:settled(Samples, 20, 100, 0.1)),
    ?assertEqual(0, copter_flight:settled(Samples, 100, 100, 0.1)),
    ?assertEqual(never, copter_flight:settled(Samples, 20, 80, 0.1)),
    ?assertEqual(0.75, copter_flight:mean_error(Samples, 0, 40)).

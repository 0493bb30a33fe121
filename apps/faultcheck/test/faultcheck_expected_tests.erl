-module(faultcheck_expected_tests).
-include_lib("proper/include/proper.hrl").
-include_lib("eunit/include/eunit.hrl").

-define(TIMES, [{numtests, 200}]).

%% It shrinks as any user's would, is drawn from the seed alone, and Stop runs in the same process.
found_and_shrunk_test() ->
    Small = fun() -> ?FORALL(N, choose(0, 1000), N < 500) end,
    Stop = fun() -> put(stopped, true) end,
    ?assertEqual({found, [500]}, faultcheck_expected:failure({Small, Stop}, 1, ?TIMES)),
    ?assertEqual(undefined, get(stopped)).

same_seed_same_values_test() ->
    Drawn = fun(Seed) ->
        Me = self(),
        Make = fun() -> ?FORALL(N, choose(0, 1 bsl 40), is_pid(Me ! {drawn, N}) orelse true) end,
        not_found = faultcheck_expected:failure({Make, fun() -> ok end}, Seed, [{numtests, 5}]),
        received()
    end,
    Once = Drawn(7),
    ?assertEqual(5, length(Once)),
    ?assertEqual(Once, Drawn(7)),
    ?assertNotEqual(Once, Drawn(8)).

received() ->
    receive
        {drawn, N} -> [N | received()]
    after 0 -> []
    end.

error_of_the_system_under_test_test() ->
    Make = fun() -> error({cb, not_loaded}) end,
    ?assertError({cb, not_loaded}, faultcheck_expected:failure({Make, fun() -> ok end}, 1, [])).

process_that_dies_test() ->
    Make = fun() -> exit(self(), kill) end,
    Stop = fun() -> ok end,
    ?assertError({search_ended, killed}, faultcheck_expected:failure({Make, Stop}, 1, [])).

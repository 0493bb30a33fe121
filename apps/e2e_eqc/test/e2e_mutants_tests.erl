-module(e2e_mutants_tests).
-include_lib("proper/include/proper.hrl").
-include_lib("eunit/include/eunit.hrl").

%% Exported for hunt/2, as properties of a module would be.
-export([prop_holds/0, prop_fails_at_seventh/0]).

prop_holds() -> ?FORALL(_, integer(), true).

prop_fails_at_seventh() ->
    ?FORALL(_, integer(), begin
        N = case get(tests) of undefined -> 1; Before -> Before + 1 end,
        _ = put(tests, N),
        N =/= 7
    end).

counts_tests_over_rounds_test() ->
    _ = erase(tests),
    ?assertMatch({killed, prop_fails_at_seventh, 7, _}, e2e_mutants:hunt([?MODULE], [5, 5])).

survives_test() ->
    _ = put(tests, 100),
    ?assertMatch({survived, 8, _}, e2e_mutants:hunt([?MODULE], [3, 1])).

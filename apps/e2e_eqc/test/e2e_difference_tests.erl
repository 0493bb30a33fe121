-module(e2e_difference_tests).
-include_lib("eunit/include/eunit.hrl").

same_test() ->
    ?assertEqual(true, e2e_difference:same([#{a => {1, <<2>>}}], [#{a => {1, <<2>>}}])).

first_difference_test_() ->
    [
        ?_assertEqual({at, Path, expected, E, got, A}, e2e_difference:same(Expected, Actual))
     || {Expected, Actual, Path, E, A} <- [
            {1, 2, [], 1, 2},
            {[ok, #{a => 1, b => {x, 1}}], [ok, #{a => 1, b => {x, 2}}], [2, b, 2], 1, 2},
            {{ok, 1, 2}, {ok, 3, 4}, [2], 1, 3},
            {#{a => 1}, #{b => 1}, [], #{a => 1}, #{b => 1}},
            {[1], [1, 2], [], [1], [1, 2]},
            {[1], none, [], [1], none}
        ]
    ].

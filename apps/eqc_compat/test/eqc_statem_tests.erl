-module(eqc_statem_tests).

-include_lib("eunit/include/eunit.hrl").

postconditions_tell_what_differs_test() ->
    ?assertEqual(true, eqc_statem:eq(1, 1)),
    ?assertEqual({1, '/=', 2}, eqc_statem:eq(1, 2)).

-module(eqc_tests).

-include_lib("eunit/include/eunit.hrl").

statistics_are_propers_test() ->
    ?assert(eqc:quickcheck(eqc:numtests(5, eqc:measure(size, 3, eqc:collect(a, true))), [quiet])).

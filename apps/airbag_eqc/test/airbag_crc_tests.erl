-module(airbag_crc_tests).
-include_lib("eunit/include/eunit.hrl").

%% The masks of DataLength 16 that the enumeration finds undetected: 13 40, 26 80, 01 83.
checksums_of_differences_test() ->
    ?assertEqual([16#13, 16#26, 16#01, 0],
                 [airbag_crc:of_difference([D]) || D <- [16#40, 16#80, 16#83, 0]]).

%% Against the bit by bit computation of the tests, of all masks of the recommended configuration
%% with these changes in bytes 1 and 2.
agrees_with_the_undetected_masks_test() ->
    [
        ?assert(airbag_test_crc:misses(recommended, [airbag_crc:of_difference([A, B, 0]), A, B, 0]))
     || A <- lists:seq(0, 255, 5), B <- [0, 1, 128, 255]
    ].

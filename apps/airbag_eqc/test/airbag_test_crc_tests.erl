-module(airbag_test_crc_tests).
-include_lib("eunit/include/eunit.hrl").

%% Numbers of undetected masks that were computed apart from this project: 0, 0, 18 of 4960, 128 of
%% 35960 in 32 bits; 3 of 1820 in 16 bits.
missed(Configuration, Bytes) ->
    Positions = [{Byte, Bit} || Byte <- Bytes, Bit <- lists:seq(0, 7)],
    Space = faultcheck_space:subsets(Positions, 4),
    Check = fun(Flips, _) ->
        Mask = airbag_exhaustive:mask(Flips),
        {#{length(Flips) => hd([1 || airbag_test_crc:misses(Configuration, Mask)] ++ [0])}, []}
    end,
    {ok, #{counts := Counts}} = faultcheck_enumerate:run(Space, Check, #{workers => 2}),
    [maps:get(Flips, Counts) || Flips <- [1, 2, 3, 4]].

numbers_of_missed_masks_test_() ->
    {timeout, 60, [
        ?_assertEqual([0, 0, 0, 3], missed(thesis, [0, 1])),
        ?_assertEqual([0, 0, 18, 128], missed(recommended, [0, 1, 2, 3]))
    ]}.

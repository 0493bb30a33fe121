%% Expected counts and masks were computed from the CRC polynomial alone, apart from this project.
-module(airbag_exhaustive_tests).
-include_lib("eunit/include/eunit.hrl").

exhaustive_test_() ->
    {setup, fun airbag_test_sut:port/0, fun(_) -> ok end, [
        {"thesis, up to four flips", {timeout, 60, fun thesis/0}},
        {"recommended, up to three flips", {timeout, 60, fun recommended/0}},
        {"resumed with another number of workers", {timeout, 60, fun resumed/0}}
    ]}.

thesis() ->
    {ok, #{found := Found} = Result} = airbag_exhaustive:run(thesis, [0, 1], 4, #{}),
    ?assertEqual([1, 16, 120, 560, 1820], airbag_exhaustive:table(masks, Result)),
    ?assertEqual([0, 0, 0, 0, 3], airbag_exhaustive:table(undetected, Result)),
    ?assertEqual([0, 0, 0, 0, 3], airbag_exhaustive:table(fired, Result)),
    ?assertEqual(
        [
            {21, [16#13, 16#40, 0, 0]},
            {213, [16#26, 16#80, 0, 0]},
            {214, [16#01, 16#83, 0, 0]}
        ],
        lists:sort(Found)
    ).

recommended() ->
    {ok, #{found := Found} = Result} =
        airbag_exhaustive:run(recommended, [0, 1, 2, 3], 3, #{workers => 2}),
    ?assertEqual([1, 32, 496, 4960], airbag_exhaustive:table(masks, Result)),
    ?assertEqual([0, 0, 0, 18], airbag_exhaustive:table(undetected, Result)),
    ?assertEqual([0, 0, 0, 10], airbag_exhaustive:table(able, Result)),
    ?assertEqual(
        [
            {21, [16#60, 16#40, 0, 0]},
            {69, [16#18, 16#10, 0, 0]},
            {81, [16#06, 16#04, 0, 0]},
            {81, [16#20, 16#04, 0, 16#80]},
            {84, [16#08, 16#01, 0, 16#20]},
            {87, [16#03, 16#02, 0, 0]},
            {87, [16#10, 16#02, 0, 16#40]},
            {93, [16#0c, 16#08, 0, 0]},
            {117, [16#30, 16#20, 0, 0]},
            {213, [16#c0, 16#80, 0, 0]}
        ],
        lists:sort(Found)
    ).

resumed() ->
    File = cb_files:fresh_name("airbag_exhaustive", ""),
    try
        Options = #{state_file => File, chunk => 16},
        {stopped, #{done := Done}} =
            airbag_exhaustive:run(thesis, [0, 1], 3, Options#{stop_after => 100}),
        ?assert(Done >= 100 andalso Done < 697),
        {ok, Result} = airbag_exhaustive:run(thesis, [0, 1], 3, Options#{workers => 2}),
        ?assertEqual([1, 16, 120, 560], airbag_exhaustive:table(masks, Result)),
        ?assertEqual([0, 0, 0, 0], airbag_exhaustive:table(undetected, Result))
    after
        file:delete(File)
    end.

masks_are_built_from_flips_test() ->
    ?assertEqual([16#13, 16#40, 0, 0],
        airbag_exhaustive:mask([{0, 0}, {0, 1}, {0, 4}, {1, 6}])),
    ?assertEqual("13 40 00 00", lists:flatten(airbag_exhaustive:hex([16#13, 16#40, 0, 0]))).

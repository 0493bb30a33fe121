-module(airbag_report_tests).
-include_lib("eunit/include/eunit.hrl").

report_test_() ->
    {setup, fun airbag_test_sut:port/0, fun(_) -> ok end,
        {"a small report is complete", {timeout, 120, fun report/0}}}.

report() ->
    Dir = cb_files:fresh_name("airbag_report", ""),
    Settings = (airbag_report:settings())#{
        seeds => 1,
        tests => 84,
        coverage_tests => 42,
        flips => 2,
        transport => port,
        progress => fun(_) -> ok end
    },
    try
        ok = airbag_report:run(Dir, Settings),
        {ok, Text} = file:read_file(filename:join(Dir, "airbag.md")),
        {match, Pictures} = re:run(Text, "\\]\\((airbag/[a-z-]+\\.svg)\\)", [
            global, {capture, [1], list}
        ]),
        ?assertEqual(5, length(Pictures)),
        [?assert(filelib:is_regular(filename:join(Dir, P))) || [P] <- Pictures],
        Has = fun(Part) -> ?assertNotEqual(nomatch, binary:match(Text, Part)) end,
        Has(<<"| byte, 2 needed | about 1000 tests |">>),
        Has(<<"| thesis | byte | at most 2 | 84 | none |">>),
        Has(<<"| 1 of 1 | 22 750 |">>),
        Has(<<"| recommended, all 4 bytes | 2 | 496 | 0 | 0 | 0 |">>),
        Has(<<"| none (figure 3) | thesis |">>),
        %% nothing is left to resume from
        ?assertEqual([], filelib:wildcard(filename:join([Dir, "airbag", "state", "*"])))
    after
        _ = file:del_dir_r(Dir)
    end.

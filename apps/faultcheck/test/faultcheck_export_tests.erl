-module(faultcheck_export_tests).
-include_lib("eunit/include/eunit.hrl").

%% A module of this test can export cases, see export/3 below.
-export([export/3]).

words_in_any_order_test() ->
    Expected = {ok, "cases/a", #{format => svg, at => 7.42, out => "m.svg"}},
    ?assertEqual(
        Expected,
        faultcheck_export:parse(["cases/a", "--svg", "--at", "7.42", "--out", "m.svg"])
    ),
    ?assertEqual(
        Expected,
        faultcheck_export:parse(["--at", "7.42", "--out", "m.svg", "--svg", "cases/a"])
    ).

each_format_is_an_option_test_() ->
    [
        ?_assertEqual({ok, "c", #{format => Format}}, faultcheck_export:parse(["c", Option]))
     || {Option, Format} <- [{"--mcap", mcap}, {"--csv", csv}, {"--svg", svg}]
    ].

whole_seconds_are_seconds_test() ->
    {ok, "c", #{at := 3}} = faultcheck_export:parse(["c", "--svg", "--at", "3"]).

what_is_wrong_is_told_in_one_line_test_() ->
    [
        {Part, fun() ->
            {error, Line} = faultcheck_export:parse(Words),
            ?assertNotEqual({Line, nomatch}, {Line, string:find(Line, Part)}),
            ?assertEqual(nomatch, string:find(Line, "\n"))
        end}
     || {Words, Part} <- [
            {[], "which case"},
            {["c"], "--mcap, --csv or --svg"},
            {["c", "--svg", "--at"], "needs a value"},
            {["c", "--svg", "--at", "soon"], "not soon"},
            {["c", "--svg", "--at", "-1"], "not -1"},
            {["c", "--mcap", "--at", "1"], "--at is for --svg"},
            {["c", "--mcap", "--csv"], "one at a time"},
            {["c", "--mpac"], "did you mean --mcap"},
            {["c", "d", "--csv"], "unexpected argument d"}
        ]
    ].

stored(Model) -> #{shrunk => [[{set, {var, 1}, {call, Model, x, []}}]]}.

the_model_of_the_commands_exports_test() ->
    ?assertEqual(
        {ok, ["dir/x.csv"]},
        faultcheck_export:run(lists, stored(?MODULE), "dir", #{format => csv})
    ).

nobody_exports_test() ->
    {error, Line} = faultcheck_export:run(lists, stored(sets), "dir", #{format => csv}),
    ?assertNotEqual(nomatch, string:find(Line, "neither lists nor the model")).

export(_Case, Dir, #{format := Format}) -> {ok, [lists:concat([Dir, "/x.", Format])]}.

-module(faultcheck_report_tests).
-include_lib("eunit/include/eunit.hrl").

a_failure_tells_all_test() ->
    Expected = [
        "Failed: m:prop_x() in test 17 (size 8)",
        "  postcondition false",
        "  1 command, shrunk from 3:",
        "    m:push(1)",
        "  shrinking: 9 candidates, 2 accepted, minimal",
        "  stored in cases/prop_x-1",
        "  replay: faultcheck replay cases/prop_x-1",
        "  seed 5 with FaultCheck 0.1.0, PropEr 1.2, OTP 25, git none",
        "  repeat: rebar3 proper -p prop_x --seed 5"
    ],
    ?assertEqual(Expected, [lists:flatten(L) || L <- faultcheck_report:failure(failure())]).

what_the_model_told_stands_below_the_replay_test() ->
    Told = (failure())#{
        told => #{report => "report.html", watch => true}, watch => "make visualizer CASE="
    },
    Lines = [lists:flatten(L) || L <- faultcheck_report:failure(Told)],
    [_Replay | Behind] = lists:dropwhile(
        fun(Line) -> Line =/= "  replay: faultcheck replay cases/prop_x-1" end, Lines
    ),
    ?assertMatch(
        [
            "  report: cases/prop_x-1/report.html",
            "  watch: make visualizer CASE=cases/prop_x-1"
            | _
        ],
        Behind
    ).

a_case_that_cannot_be_watched_is_not_offered_test() ->
    Told = (failure())#{told => #{report => "a.html"}, watch => "make visualizer CASE="},
    Lines = faultcheck_report:failure(Told),
    ?assertEqual([], [Line || Line <- Lines, string:find(Line, "watch") =/= nomatch]).

stopped_shrinking_is_not_minimal_test() ->
    Stopped = #{tries => 5, accepted => 1, minimal => false, stopped => max_ms},
    Lines = faultcheck_report:failure((failure())#{shrink := Stopped}),
    ?assert(lists:member("  shrinking: 5 candidates, 1 accepted, not minimal: stopped at max_ms",
        Lines)).

summary_test() ->
    Passed = #{status => passed, property => {m, prop_a}},
    ?assertEqual(["===> 2/2 properties passed"], faultcheck_report:summary([Passed, Passed])),
    ?assertEqual(
        [
            "===> 1/3 properties passed, 1 failed, 1 flaky",
            "===> Failed test cases:",
            "m:prop_x() -> false (pushes)",
            "m:prop_x() -> flaky"
        ],
        faultcheck_report:summary([
            Passed, (failure())#{doc => "pushes"}, (failure())#{status := flaky}
        ])
    ),
    [_, _, Long] = faultcheck_report:summary([(failure())#{long_result => true, shrunk := [7]}]),
    ?assertEqual("m:prop_x() -> [7]", Long).

progress_test() ->
    ?assertEqual(
        "prop_x: 500 of 2000 tests, 250/s, 6 s to go",
        faultcheck_report:progress({m, prop_x}, 500, 2000, {tests, 2000})
    ),
    ?assertEqual(
        "prop_x: 0 tests, 0/s, 8 s to go",
        faultcheck_report:progress({m, prop_x}, 0, 2000, {ms, 10000})
    ).

shrinking_progress_test() ->
    ?assertEqual(
        "prop_x: shrinking, 40 candidates, 7 commands of 90",
        faultcheck_report:shrinking_progress(
            {m, prop_x}, #{tries => 40, accepted => 3, original => 90, length => 7}
        )
    ).

searching_progress_test() ->
    ?assertEqual(
        "prop_x: test 3, search: 120 runs of 2000, nearest 0.5",
        faultcheck_report:searching_progress(
            {m, prop_x}, 3, #{runs => 120, most => 2000, nearest => 0.5}
        )
    ).

json_test() ->
    Versions = maps:get(versions, failure()),
    {ok, #{<<"total">> := 1, <<"passed">> := 0, <<"properties">> := [P]}} =
        faultcheck_json:decode(faultcheck_report:json(Versions, [failure()])),
    ?assertMatch(
        #{
            <<"module">> := <<"m">>,
            <<"property">> := <<"prop_x">>,
            <<"status">> := <<"failed">>,
            <<"seed">> := 5,
            <<"reasons">> := [<<"postcondition false">>],
            <<"counterexample">> := [<<"m:push(1)">>],
            <<"case">> := <<"cases/prop_x-1">>
        },
        P
    ).

failure() ->
    Push = fun(N) -> {set, {var, N}, {call, m, push, [N]}} end,
    #{
        property => {m, prop_x},
        status => failed,
        tests => 17,
        ms => 12,
        test => 17,
        size => 8,
        seed => 5,
        versions => #{faultcheck => "0.1.0", proper => "1.2", otp => "25", git => "none"},
        original => [[Push(1), Push(2), Push(3)]],
        shrunk => [[Push(1)]],
        reasons => ["postcondition false"],
        shrink => #{tries => 9, accepted => 2, minimal => true, stopped => none, flaky => false},
        'case' => "cases/prop_x-1",
        replay => "faultcheck replay",
        repeat => "rebar3 proper -p prop_x --seed 5"
    }.

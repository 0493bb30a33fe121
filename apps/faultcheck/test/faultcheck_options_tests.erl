-module(faultcheck_options_tests).
-include_lib("eunit/include/eunit.hrl").

defaults_test() ->
    {ok, Options} = faultcheck_options:parse([]),
    ?assertMatch(#{dir := ["test"], verbose := true, retry := false, cover := false}, Options),
    ?assertNot(is_map_key(numtests, Options)).

forms_test_() ->
    [
        ?_assertMatch({ok, #{Key := Value}}, faultcheck_options:parse(Words))
     || {Words, Key, Value} <- [
            {["-n", "7"], numtests, 7},
            {["-n7"], numtests, 7},
            {["--numtests", "7"], numtests, 7},
            {["--numtests=7"], numtests, 7},
            {["-m", "a,b"], module, [a, b]},
            {["-d", "t1,t2"], dir, ["t1", "t2"]},
            {["--retry"], retry, true},
            {["--verbose", "false"], verbose, false},
            {["-v", "false"], verbose, false},
            {["--noshrink=true"], noshrink, true},
            {["--transport", "port"], transport, port},
            {["--seed", "5"], seed, 5},
            {["--seed", "5@0.1.0,1.2,25"], seed, 5},
            {["--seed", "5@0.1.0,1.2,25"], seed_versions,
                #{faultcheck => "0.1.0", proper => "1.2", otp => "25"}},
            {["--start_size", "0"], start_size, 0},
            {["--junit", "a b.xml"], junit, "a b.xml"}
        ]
    ].

errors_test_() ->
    [
        ?_assertEqual({error, Line}, faultcheck_options:parse(Words))
     || {Words, Line} <- [
            {["--numtest", "1"], "unknown option --numtest; did you mean --numtests?"},
            {["-x"], "unknown option -x"},
            {["-n"], "option --numtests needs a value: a whole number from 1"},
            {["-n", "0"], "option --numtests must be a whole number from 1, not 0"},
            {["-n", "12x"], "option --numtests must be a whole number from 1, not 12x"},
            {["--transport", "tcp"], "option --transport must be nif or port, not tcp"},
            {["--retry=maybe"], "option --retry must be true or false, not maybe"},
            {["--seed", "4294967296"],
                "option --seed must be a whole number from 0 to 4294967295 as it was printed, not"
                " 4294967296"},
            {["--seed", "5@0.1.0"],
                "option --seed must be a whole number from 0 to 4294967295 as it was printed, not"
                " 5@0.1.0"},
            {["-p", ","], "option --prop must be names separated by commas, not ,"},
            {["prop_x"], "unexpected argument prop_x; options begin with - (see --help)"}
        ]
    ].

configured_test() ->
    ?assertEqual(
        {ok, #{numtests => 5, noshrink => true}},
        faultcheck_options:check([{numtests, 5}, noshrink])
    ),
    ?assertEqual(
        {error, "option --numtests must be a whole number from 1, not many"},
        faultcheck_options:check([{numtests, many}])
    ),
    ?assertMatch({error, "unknown option numtest; did you mean" ++ _},
        faultcheck_options:check([{numtest, 1}])).

told_to_proper_test() ->
    {ok, Options} = faultcheck_options:parse(["-n", "9", "--noshrink", "--seed", "1", "--retry"]),
    ?assertEqual([{numtests, 9}, noshrink], faultcheck_options:proper(Options)).

%% The words of the line that repeats a run mean the same run.
arguments_read_back_test_() ->
    [
        ?_test(begin
            {ok, Options} = faultcheck_options:parse(Words),
            {ok, Again} = faultcheck_options:parse(faultcheck_options:arguments(Options)),
            ?assertEqual(Options, Again)
        end)
     || Words <- [
            [],
            ["-n", "5", "--transport", "nif", "--noshrink"],
            ["-d", "a,b", "--time", "3", "--max_size", "9", "--any_to_integer"]
        ]
    ].

every_option_has_help_test() ->
    Help = faultcheck_options:help(),
    [
        ?assertNotEqual(nomatch, string:find(Help, "--" ++ Long))
     || {_, _, Long, _, _} <- faultcheck_options:getopt()
    ],
    Shorts = [S || {_, S, _, _, _} <- faultcheck_options:getopt(), S =/= undefined],
    ?assertEqual(length(Shorts), length(lists:usort(Shorts))).

%% Written with a hyphen; the option of the map has an underscore, and that is understood, too.
boundary_bias_and_workers_test() ->
    {ok, Options} = faultcheck_options:parse([
        "--boundary-bias", "0.9", "--workers", "2", "--max_runs", "500"
    ]),
    ?assertMatch(#{boundary_bias := 0.9, workers := 2, max_runs := 500}, Options),
    ?assertMatch({ok, #{boundary_bias := 1}}, faultcheck_options:parse(["--boundary_bias=1"])),
    %% the number of workers changes no result
    ?assertEqual(["--boundary-bias", "0.9", "--max_runs", "500"],
                 faultcheck_options:arguments(Options)),
    [
        ?assertEqual({error, "option --boundary-bias must be a number from 0 to 1, not " ++ Text},
                     faultcheck_options:parse(["--boundary-bias", Text]))
     || Text <- ["1.5", "-1", "x", "0.9x", "nan"]
    ],
    ?assertMatch({error, _}, faultcheck_options:parse(["--workers", "0"])),
    ?assertEqual({ok, #{boundary_bias => 0.5}}, faultcheck_options:check([{boundary_bias, 0.5}])),
    ?assertMatch({error, _}, faultcheck_options:check([{boundary_bias, 7}])).

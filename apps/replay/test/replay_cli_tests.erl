-module(replay_cli_tests).
-include_lib("eunit/include/eunit.hrl").

words_become_options_test() ->
    ?assertEqual({ok, #{}}, replay_cli:parse([])),
    ?assertEqual(
        {ok, #{'case' => "cases/x", original => true, speed => 0.5, udp => "127.0.0.1:1"}},
        replay_cli:parse(["cases/x", "--original", "--speed", "0.5", "--udp=127.0.0.1:1"])
    ),
    ?assertEqual(help, replay_cli:parse(["cases/x", "--help"])).

wrong_words_are_one_line_test() ->
    Refused = [
        {["--sped", "1"], "unknown option --sped; did you mean --speed"},
        {["a", "b"], "unexpected argument b"},
        {["--speed"], "--speed needs a value"},
        {["--speed", "fast"], "--speed: expected a number from 0.05 to 20, not fast"},
        {["--speed", "0"], "--speed: expected a number from 0.05 to 20"},
        {["--live=yes"], "--live takes no value"},
        {["case", "--live"], "a case, --live or --scenario: expected one of them"},
        {["--allow-control"], "--allow-control and --token-file: expected both or none"},
        {["--udp", "127.0.0.1:1", "--group", "udpm://"], "--group and --udp: expected one"}
    ],
    [
        begin
            {error, Line} = replay_cli:parse(Words),
            ?assertEqual({Line, Expected}, {Line, lists:sublist(Line, length(Expected))})
        end
     || {Words, Expected} <- Refused
    ].

%% What it says goes to the standard error of this VM.
a_case_that_is_not_there_is_wrong_input_test() ->
    ?assertEqual(2, replay_cli:run(["no/such"])),
    ?assertEqual(2, replay_cli:run(["nosuch", "--cases", "no/where"])).

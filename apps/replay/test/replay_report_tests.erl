-module(replay_report_tests).
-include_lib("eunit/include/eunit.hrl").

%% A page whose script speaks of the end of a page.
-define(PAGE, <<"<html><body><script>let end = '</body>'</script>\n</body></html>">>).

log() -> log(10, 100).

%% So many frames with a contour each, so many a second; an event with each tenth.
log(Frames, Rate) ->
    iolist_to_binary([
        [
            event(N, T, frame, #{
                t_us => T, run => 1, seq => N, objects => []
            }),
            event(N, T, risk, #{t_us => T, run => 1, observer => -1, ellipses => []}),
            [
                event(N, T, event, #{
                    t_us => T, run => 1, seq => N, kind => "log", a => -1, b => -1, x => 0.0,
                    y => 0.0, text => <<"</script><script>alert(1)</script> ", 16#1F4A5/utf8>>
                })
             || N rem 10 =:= 0
            ]
        ]
     || N <- lists:seq(0, Frames - 1), T <- [N * 1000000 div Rate]
    ]).

event(N, T, Type, Message) ->
    replay_lcm_log:bytes(#{
        number => N, t_us => T, channel => replay_lcm:channel(Type),
        data => replay_lcm:encode(Type, Message)
    }).

report(Log, Title) ->
    {Html, []} = replay_report:format(?PAGE, Log, Title),
    iolist_to_binary(Html).

%% What a browser would find in the element.
log_in(Report) ->
    Element =
        "<script type=\"application/gzip\" id=\"log\" data-name=\"[^\"<>]*\">([^<]*)</script>",
    {match, [Base64]} = re:run(Report, Element, [{capture, all_but_first, binary}]),
    zlib:gunzip(base64:decode(Base64)).

the_log_comes_out_as_it_went_in_test() ->
    ?assertEqual(log(), log_in(report(log(), "a case"))).

it_stands_at_the_end_of_the_page_and_changes_nothing_else_test() ->
    Report = report(log(), "a case"),
    [Front, Back] = re:split(Report, "<script type=\"application/gzip\".*</script>\n", [dotall]),
    ?assertEqual(?PAGE, <<Front/binary, Back/binary>>),
    ?assertEqual(<<"</body></html>">>, Back).

the_same_log_gives_the_same_bytes_test() ->
    ?assertEqual(report(log(), "a case"), report(log(), "a case")).

text_of_messages_and_names_stays_inert_test() ->
    Report = report(log(), "\"><script>alert(2)</script> \x{1F4A5}"),
    ?assertEqual(2, length(binary:matches(Report, <<"<script">>))),
    ?assertEqual(nomatch, binary:match(Report, <<"alert(">>, [{scope, {0, 60}}])),
    ?assertNotEqual(nomatch, binary:match(Report, <<"&lt;script&gt;alert(2)">>)),
    ?assertEqual(log(), log_in(Report)).

a_small_report_has_all_frames_test() ->
    {_, []} = replay_report:format(?PAGE, log(), "a case", 100000).

of_a_large_one_frames_are_thinned_and_nothing_else_test() ->
    Log = log(400, 100),
    {Whole, []} = replay_report:format(?PAGE, Log, "a case"),
    {Html, [Note]} = replay_report:format(?PAGE, Log, "a case", iolist_size(Whole) - 1),
    ?assertMatch("report.html has 20 frames a second" ++ _, Note),
    {ok, Before} = replay_lcm_log:events(Log),
    {ok, After} = replay_lcm_log:events(log_in(iolist_to_binary(Html))),
    [
        begin
            ?assertEqual(times(<<"VIZ_EVENT">>, Before), times(<<"VIZ_EVENT">>, After)),
            Times = times(Channel, After),
            %% every fifth, and the last
            ?assertEqual([T || T <- lists:seq(0, 3950000, 50000)] ++ [3990000], Times)
        end
     || Channel <- [<<"VIZ_FRAME">>, <<"VIZ_RISK">>]
    ].

times(Wanted, Events) -> [T || #{channel := Channel, t_us := T} <- Events, Channel =:= Wanted].

what_cannot_be_small_is_written_and_told_test() ->
    {Html, [Note]} = replay_report:format(?PAGE, log(400, 100), "a case", 100),
    ?assertMatch("report.html has 1 frames a second" ++ _, Note),
    {ok, Events} = replay_lcm_log:events(log_in(iolist_to_binary(Html))),
    ?assertEqual([0, 1000000, 2000000, 3000000, 3990000], times(<<"VIZ_FRAME">>, Events)).

a_case_without_a_recording_gets_a_note_test() ->
    #{notes := [Note]} = Told = replay_report:write(cb_files:fresh_name("case", "")),
    ?assertMatch("no report.html: " ++ _, Note),
    ?assertNot(is_map_key(report, Told)).

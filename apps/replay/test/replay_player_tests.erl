%% The player with wall time by hand: w/2 wakes it as its timer would until a moment.
-module(replay_player_tests).
-include_lib("eunit/include/eunit.hrl").

-define(TOKEN, <<"0123456789abcdef">>).

opened(What) -> opened(What, #{}).

opened(What, Changes) ->
    Options = maps:merge(
        #{
            opening => {view, What}, number => 7, view => replay_test_source, token => ?TOKEN,
            cases => "/nonexistent", scenarios => "/nonexistent", playing => true, speed => 1.0
        },
        Changes
    ),
    {ok, Out, Player} = replay_player:open(Options, 0),
    {Out, Player}.

moving() -> {moving, 1000000, passed, passed}.

%% All that was published until then.
until(Wall, Player) -> until(Wall, [], Player).

until(Wall, Out, Player) ->
    case replay_player:next_wake(Player) of
        Next when Next > Wall -> {Out, Player};
        Next ->
            {More, After} = replay_player:wake(Next, Player),
            until(Wall, Out ++ More, After)
    end.

of_type(Type, Out) -> [M || {publish, {T, M}} <- Out, T =:= Type].

ask(Verb, Changes, Player) -> ask_at(0, Verb, Changes, Player).

ask_at(Now, Verb, Changes, Player) ->
    Seq = get_seq(),
    Message = maps:merge(
        #{client => <<"page-1">>, token => ?TOKEN, seq => Seq, verb => Verb, object => -1,
          args => [], text => <<>>},
        Changes
    ),
    {Out, Next} = replay_player:control(Message, sender, Now, Player),
    [#{ok := Ok, text := Text}] = of_type(ack, Out),
    {Ok, lists:flatten(io_lib:format("~ts", [Text])), Out, Next}.

get_seq() ->
    N = case get(seq) of undefined -> 1; M -> M + 1 end,
    put(seq, N),
    N.

status(Out) -> lists:last(of_type(status, Out)).

%% ---- playing ----------------------------------------------------------------------------------

plays_sixty_frames_a_second_to_the_end_test() ->
    {Begun, Player} = opened(moving()),
    {Out, Done} = until(3000000, Player),
    Frames = of_type(frame, Begun ++ Out),
    Seqs = lists:usort([Seq || #{seq := Seq} <- Frames]),
    ?assert(abs(length(Seqs) - 61) =< 1),
    ?assertEqual(lists:seq(0, length(Seqs) - 1), Seqs),
    ?assertEqual([7], lists:usort([R || #{run := R} <- Frames])),
    Times = [T || #{t_us := T} <- Frames],
    ?assertEqual(Times, lists:sort(Times)),
    ?assertMatch(#{verdict := 1, paused := 1, t_us := 1000000, duration_us := 1000000, mode := 2,
                   control_allowed := 1, message := ""}, status(Out)),
    %% and then only repeats
    {Later, _} = until(13000000, Done),
    ?assertEqual([lists:last(Seqs)], lists:usort([S || #{seq := S} <- of_type(frame, Later)])),
    ?assert(length(of_type(frame, Later)) =< 11),
    ?assert(length(of_type(case_info, Later)) >= 9).

status_comes_five_times_a_second_and_the_rest_once_test() ->
    {_, Player} = opened({moving, 20000000, passed, passed}),
    {Out, _} = until(10000000, Player),
    ?assert(abs(length(of_type(status, Out)) - 50) =< 8),
    [?assert(abs(length(of_type(Type, Out)) - 10) =< 1) || Type <- [case_info, world, faults]],
    ?assert(abs(length(of_type(ranges, Out)) - 86) =< 16).

%% Of each second: the numbers of the events that were told.
numbers_told(Seconds, Player) ->
    {Told, _} = lists:mapfoldl(
        fun(Second, P) ->
            {Out, Next} = until(Second * 1000000 + 500000, P),
            {[N || #{seq := N} <- of_type(event, Out)], Next}
        end,
        Player,
        lists:seq(1, Seconds)
    ),
    Told.

events_are_told_again_each_second_test() ->
    {Begun, P0} = opened({moving, 100000, {failed, "x"}, {failed, "y"}}),
    {Out, P1} = until(500000, P0),
    Events = of_type(event, Begun ++ Out),
    ?assertEqual([0, 1, 2], [N || #{seq := N} <- Events]),
    {Later, _} = until(1500000, P1),
    ?assertEqual(Events, of_type(event, Later)),
    ?assertEqual([[0, 1, 2], [0, 1, 2], [0, 1, 2]], numbers_told(3, P1)),
    %% another run tells its own only
    {1, "", _, P2} = ask_at(500000, <<"restart">>, #{}, P1),
    {Again, _} = until(2500000, P2),
    ?assertEqual([8], lists:usort([R || #{run := R} <- of_type(event, Again)])).

many_events_are_told_again_in_turn_test() ->
    {_, P0} = opened(live),
    Steer = fun(_, P) ->
        {1, "", _, Next} = ask(<<"steer">>, #{object => 0, args => [0.1, 0, 0]}, P),
        Next
    end,
    %% with the first of all, and its release, 450
    P1 = lists:foldl(Steer, P0, lists:seq(1, 448)),
    {_, P2} = until(500000, P1),
    ?assertEqual(
        [lists:seq(0, 199), lists:seq(200, 399), lists:seq(0, 149) ++ lists:seq(400, 449),
         lists:seq(150, 349)],
        numbers_told(4, P2)
    ).

speed_is_that_of_wall_time_test() ->
    {_, Player} = opened({moving, 20000000, passed, passed}, #{speed => 4.0}),
    {Out, _} = until(1000000, Player),
    #{t_us := T} = lists:last(of_type(frame, Out)),
    ?assert(abs(T - 4000000) =< 4 * 16667).

late_wakes_do_not_add_up_test() ->
    {_, Player} = opened({moving, 20000000, passed, passed}),
    %% each 10 ms later than its time
    Late = lists:foldl(
        fun(_, P) ->
            {_, Next} = replay_player:wake(replay_player:next_wake(P) + 10000, P),
            Next
        end,
        Player,
        lists:seq(1, 100)
    ),
    Wake = replay_player:next_wake(Late),
    {Out, _} = replay_player:wake(Wake, Late),
    #{t_us := T} = lists:last(of_type(frame, Out)),
    ?assertEqual(Wake div 5000 * 5000, T).

%% ---- verdicts ---------------------------------------------------------------------------------

end_of(Ending, Recorded) ->
    {_, Player} = opened({moving, 100000, Ending, Recorded}),
    {Out, _} = until(900000, Player),
    {status(Out), [T || #{kind := <<"verdict">>, text := T} <- of_type(event, Out)]}.

a_failure_as_recorded_has_failed_test() ->
    [?assertMatch({#{verdict := 2, message := ""}, [_]}, end_of({failed, "x"}, Recorded))
     || Recorded <- [any_failure, unknown, {failed, "x"}]].

another_ending_differs_and_says_how_test() ->
    Cases = [{passed, any_failure}, {passed, {failed, "y"}}, {{failed, "x"}, {failed, "y"}},
             {{failed, "x"}, passed}],
    [
        begin
            {#{verdict := 3, message := Message}, [_, Told]} = end_of(Ending, Recorded),
            ?assertMatch("this build does not end as recorded" ++ _, Message),
            ?assertMatch("differs" ++ _, Told)
        end
     || {Ending, Recorded} <- Cases
    ].

a_run_of_no_length_ends_too_test() ->
    {_, Player} = opened({moving, 0, passed, passed}),
    {Out, Done} = until(100000, Player),
    ?assert(replay_player:has_ended(Done)),
    ?assertMatch(#{verdict := 1, t_us := 0, paused := 1}, status(Out)).

%% ---- what people ask for ----------------------------------------------------------------------

pause_stays_and_play_goes_on_test() ->
    {_, P0} = opened(moving()),
    {_, P1} = until(500000, P0),
    {1, "", _, P2} = ask_at(500000, <<"pause">>, #{}, P1),
    {Out, P3} = until(2000000, P2),
    ?assertMatch(#{t_us := T, paused := 1} when T =< 500000, status(Out)),
    {1, "", _, P4} = ask_at(2000000, <<"play">>, #{}, P3),
    {More, _} = until(2100000, P4),
    #{t_us := T1} = lists:last(of_type(frame, More)),
    ?assert(abs(T1 - 600000) =< 40000).

seeking_back_is_another_run_from_the_start_test() ->
    {_, P0} = opened({moving, 5000000, passed, passed}),
    {_, P1} = until(3000000, P0),
    {1, "", _, P2} = ask_at(3000000, <<"pause">>, #{}, P1),
    {1, "", _, P3} = ask_at(3000000, <<"seek">>, #{args => [1.2345]}, P2),
    {Out, _} = until(3500000, P3),
    Frames = [F || #{run := 8} = F <- of_type(frame, Out)],
    %% told sparsely on the way, and it begins with what happens at time 0
    Times = lists:usort([T || #{t_us := T} <- Frames]),
    ?assertEqual([N * 100000 || N <- lists:seq(1, 12)] ++ [1230000], Times),
    ?assertMatch([#{t_us := 0, text := <<"go">>, seq := 0}],
                 [E || #{run := 8} = E <- of_type(event, Out)]),
    ?assertMatch(#{t_us := 1230000, paused := 1, run := 8}, status(Out)).

seeking_forward_stays_in_the_run_test() ->
    {_, P0} = opened({moving, 5000000, passed, passed}, #{playing => false}),
    {1, "", _, P1} = ask(<<"seek">>, #{args => [4.5]}, P0),
    {Out, P2} = until(1000000, P1),
    ?assertMatch(#{t_us := 4500000, run := 7, verdict := 0}, status(Out)),
    %% past the end is the end
    {1, "", _, P3} = ask_at(1000000, <<"seek">>, #{args => [99]}, P2),
    {More, _} = until(2000000, P3),
    ?assertMatch(#{t_us := 5000000, run := 7, verdict := 1}, status(More)).

a_long_way_leaves_time_to_be_asked_test() ->
    {_, P0} = opened({moving, 100000000, passed, passed}, #{playing => false}),
    {1, "", _, P1} = ask(<<"seek">>, #{args => [90]}, P0),
    {_, P2} = replay_player:wake(1, P1),
    {1, "", _, P3} = ask_at(2, <<"seek">>, #{args => [1]}, P2),
    {Out, _} = until(1000000, P3),
    ?assertMatch(#{t_us := 1000000}, status(Out)).

steps_are_frames_test() ->
    {_, P0} = opened({moving, 5000000, passed, passed}),
    {_, P1} = until(1000000, P0),
    {1, "", _, P2} = ask_at(1000000, <<"pause">>, #{}, P1),
    {Out0, P3} = until(1200000, P2),
    #{t_us := T0} = status(Out0),
    {1, "", _, P4} = ask_at(1200000, <<"step">>, #{args => [2]}, P3),
    {Out1, P5} = until(1400000, P4),
    #{t_us := T1, paused := 1} = status(Out1),
    ?assertEqual((T0 + 2 * 16667) div 5000 * 5000, T1),
    {1, "", _, P6} = ask_at(1400000, <<"step">>, #{args => [-1]}, P5),
    {Out2, _} = until(1600000, P6),
    ?assertEqual((T1 - 16667) div 5000 * 5000, maps:get(t_us, status(Out2))).

play_at_the_end_begins_again_test() ->
    {_, P0} = opened(moving()),
    {_, P1} = until(2000000, P0),
    {1, "", _, P2} = ask_at(2000000, <<"play">>, #{}, P1),
    {Out, P3} = until(2500000, P2),
    ?assertMatch(#{run := 8, paused := 0, verdict := 0}, status(Out)),
    {More, _} = until(4000000, P3),
    ?assertMatch(#{run := 8, paused := 1, verdict := 1}, status(More)).

a_loop_goes_round_test() ->
    {_, P0} = opened(moving()),
    {1, "", _, P1} = ask(<<"loop">>, #{args => [0.2, 0.4]}, P0),
    {Out, P2} = until(1000000, P1),
    ?assert(lists:all(fun(#{t_us := T}) -> T =< 400000 end, of_type(frame, Out))),
    ?assertMatch(#{run := R, paused := 0} when R >= 9, status(Out)),
    {1, "", _, P3} = ask_at(1000000, <<"loop">>, #{}, P2),
    {More, _} = until(3000000, P3),
    ?assertMatch(#{t_us := 1000000, verdict := 1}, status(More)).

what_cannot_be_loaded_leaves_what_is_there_test() ->
    {_, P0} = opened(moving()),
    {0, Text, _, P1} = ask(<<"load">>, #{text => <<"gone">>, args => [0]}, P0),
    ?assertEqual("there is no {named,\"gone\"}", Text),
    {Out, _} = until(500000, P1),
    ?assertMatch(#{run := 7}, status(Out)).

another_case_is_another_run_test() ->
    {_, P0} = opened(moving()),
    {1, "", _, P1} = ask(<<"load">>, #{text => <<"other">>, args => [1]}, P0),
    {Out, _} = until(2000000, P1),
    ?assertMatch(#{run := 8, t_us := 500000, verdict := 1}, status(Out)).

%% Several pages ask a player that was started again for what they all showed.
a_case_that_is_played_already_is_not_begun_again_test() ->
    %% the next status, up to 0.2 s later
    Then = fun(Now, Verb, Changes, P0) ->
        {1, "", Out, P1} = ask_at(Now, Verb, Changes, P0),
        {More, P2} = until(Now + 210000, P1),
        {status(Out ++ More), P2}
    end,
    Load = fun(Now, P) -> Then(Now, <<"load">>, #{text => <<"other">>, args => [0]}, P) end,
    {_, P0} = opened(moving()),
    {#{run := 8}, P1} = Load(0, P0),
    {#{run := 8, t_us := T, paused := 0}, P2} = Load(210000, P1),
    ?assert(T >= 200000),
    %% also while it stands
    {#{t_us := Still}, P3} = Then(420000, <<"pause">>, #{}, P2),
    {#{run := 8, t_us := Still, paused := 1}, P4} = Load(700000, P3),
    %% but when it is over
    {_, P5} = Then(900000, <<"play">>, #{}, P4),
    {_, P6} = until(2000000, P5),
    {#{run := 9, t_us := Again, paused := 0}, P7} = Load(2000000, P6),
    ?assert(Again < 300000),
    %% and when a person flies it
    {#{mode := 1}, P8} = Then(2250000, <<"fork">>, #{}, P7),
    {#{run := 10, mode := 2}, _} = Load(2500000, P8).

%% ---- live -------------------------------------------------------------------------------------

a_replay_is_not_steered_test() ->
    {_, P0} = opened(moving()),
    {0, Text, _, _} = ask(<<"steer">>, #{object => 0, args => [0.1, 0, 0]}, P0),
    ?assertEqual("steer: only in a live flight; fork this replay first", Text).

steering_ends_by_itself_test() ->
    {_, P0} = opened(live),
    {1, "", _, P1} = ask(<<"steer">>, #{object => 0, args => [0.1, 0, 0]}, P0),
    {1, "", _, P2} = ask_at(200000, <<"steer">>, #{object => 0, args => [0.1, 0, 0]}, P1),
    {Held, P3} = until(499999, P2),
    [#{objects := [#{flags := 16}]} | _] = lists:reverse(of_type(frame, Held)),
    {Left, _} = until(500000, P3),
    ?assertMatch([#{text := <<"release">>}], of_type(event, Left)),
    [#{objects := [#{flags := 0}]}] = of_type(frame, Left).

a_fork_goes_on_and_becomes_a_case_test() ->
    {_, P0} = opened(moving()),
    {_, P1} = until(500000, P0),
    {1, "", Out, P2} = ask_at(500000, <<"fork">>, #{}, P1),
    ?assertMatch(#{mode := 1, duration_us := -1, run := 7, verdict := 0}, status(Out)),
    {More, P3} = until(3000000, P2),
    #{t_us := T} = lists:last(of_type(frame, More)),
    ?assert(T > 2900000),
    ?assertMatch([{store, #{property := prop_test}, _}], replay_player:close(P3)),
    %% also when something else is loaded; and only once
    {1, "", Loaded, P4} = ask_at(3000000, <<"load">>, #{text => <<"other">>, args => [0]}, P3),
    ?assertMatch([_], [S || {store, _, _} = S <- Loaded]),
    ?assertEqual([], replay_player:close(P4)).

a_notice_is_an_event_of_the_run_test() ->
    {_, P0} = opened(live),
    {_, P1} = until(500000, P0),
    {Out, P2} = replay_player:notice("stored the flight", P1),
    [#{kind := <<"log">>, text := "stored the flight", run := 7, seq := 1}] =
        of_type(event, Out),
    {Later, _} = until(1200000, P2),
    ?assertMatch([_], [E || #{kind := <<"log">>} = E <- of_type(event, Later)]).

a_live_flight_in_which_nobody_did_anything_is_not_kept_test() ->
    {_, P0} = opened(live),
    {_, P1} = until(1000000, P0),
    ?assertEqual([], replay_player:close(P1)).

a_failed_flight_is_not_forked_test() ->
    {_, P0} = opened({moving, 100000, {failed, "x"}, unknown}),
    {_, P1} = until(1000000, P0),
    {0, Text, _, _} = ask_at(1000000, <<"fork">>, #{}, P1),
    ?assertEqual("fork: it is over, x; seek back first", Text).

a_live_flight_only_goes_forward_test() ->
    {_, P0} = opened(live),
    {_, P1} = until(1000000, P0),
    {0, "seek: a live flight only goes forward", _, _} =
        ask_at(1000000, <<"seek">>, #{args => [0]}, P1),
    {0, "step: a live flight cannot go back", _, _} =
        ask_at(1000000, <<"step">>, #{args => [-1]}, P1),
    {1, "", Out, P2} = ask_at(1000000, <<"stop_all">>, #{}, P1),
    ?assertMatch(#{paused := 1}, status(Out)),
    {1, "", Again, _} = ask_at(1000000, <<"restart">>, #{}, P2),
    ?assertMatch(#{run := 8, mode := 1, t_us := 0, paused := 0}, status(Again)).

%% ---- who may ask ------------------------------------------------------------------------------

nobody_controls_a_player_without_a_token_test() ->
    {_, Player} = opened(moving(), #{token => none}),
    Message = #{client => <<"c">>, token => <<>>, seq => 1, verb => <<"pause">>, object => -1,
                args => [], text => <<>>},
    ?assertEqual({[], Player}, replay_player:control(Message, sender, 0, Player)).

a_wrong_token_is_refused_and_logged_test() ->
    {_, P0} = opened(moving()),
    {0, Text, Out, P1} = ask(<<"pause">>, #{token => <<"0123456789abcdeF">>}, P0),
    ?assertEqual("control: wrong token; load the page again", Text),
    ?assertMatch([_], [L || {log, L} <- Out]),
    ?assertEqual(P0, P1).

repeated_and_overtaken_requests_have_no_effect_test() ->
    {_, P0} = opened(moving()),
    {1, "", _, P1} = ask(<<"step">>, #{seq => 5, args => [3]}, P0),
    {Out1, P2} = until(300000, P1),
    {1, "", _, P3} = ask_at(300000, <<"step">>, #{seq => 5, args => [3]}, P2),
    {Out2, P4} = until(600000, P3),
    ?assertEqual(maps:get(t_us, status(Out1)), maps:get(t_us, status(Out2))),
    {0, "came too late, after a newer one", _, P5} =
        ask_at(600000, <<"step">>, #{seq => 4, args => [3]}, P4),
    %% another client of another bridge begins anew
    {1, "", _, _} = ask_at(600000, <<"play">>, #{seq => 1, client => <<"page-2">>}, P5).

bad_verbs_are_refused_in_one_line_test() ->
    {_, P} = opened(live),
    Refused = [
        {<<"plai">>, #{}, "plai: there is no such verb; did you mean play"},
        {<<"seek">>, #{}, "seek: 1 numbers are expected, not 0"},
        {<<"seek">>, #{args => [nan]}, "seek: nan is no finite number"},
        {<<"speed">>, #{args => [inf]}, "speed: inf is no finite number"},
        {<<"load">>, #{text => <<"../../etc">>, args => [0]}, "load: expected a case id"},
        {<<"load">>, #{text => <<"a\n">>, args => [0]}, "load: expected a case id"},
        {<<"scenario">>, #{text => <<"../x.json">>}, "scenario: expected a file name"},
        {<<"inject">>, #{text => <<"{">>}, "inject: not JSON at byte 1"},
        {<<"inject">>, #{text => <<"[]">>}, "inject: expected a JSON object"},
        {<<"inject">>, #{text => binary:copy(<<" ">>, 5000)}, "inject: a text of 5000 bytes"},
        {<<"steer">>, #{args => [1, 2, 3]}, "steer: which object?"},
        {<<"observe">>, #{object => 99}, "observe: there is no object 99"},
        {<<27, "[2J">>, #{}, "[2J: there is no such verb"}
    ],
    [
        begin
            {0, Text, _, _} = ask(Verb, Changes, P),
            ?assertEqual({Text, Expected}, {Text, lists:sublist(Text, length(Expected))}),
            ?assertEqual(nomatch, string:find(Text, "\n"))
        end
     || {Verb, Changes, Expected} <- Refused
    ].

numbers_are_clamped_test() ->
    {_, P0} = opened(moving()),
    {1, "", Out, P1} = ask(<<"speed">>, #{args => [1.0e9]}, P0),
    ?assertMatch(#{speed := 20.0}, status(Out)),
    {1, "", Out2, _} = ask(<<"speed">>, #{args => [-3]}, P1),
    ?assertMatch(#{speed := 0.05}, status(Out2)).

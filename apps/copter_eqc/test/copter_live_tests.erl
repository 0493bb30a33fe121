%% Flights by hand, and forks of replays, with wall time by hand (replay_player).
-module(copter_live_tests).
-include_lib("eunit/include/eunit.hrl").

-define(TOKEN, <<"token">>).

opened(Opening) -> opened(Opening, "/nonexistent").

opened(Opening, Scenarios) ->
    {ok, _, Player} = replay_player:open(#{
        opening => Opening, number => 1, view => copter_view, token => ?TOKEN,
        cases => "/nonexistent", scenarios => Scenarios, playing => true, speed => 1.0
    }, 0),
    _ = put(now, 0),
    Player.

live() -> opened({view, live}).

%% What was published meanwhile.
wait(Us, Player) ->
    Until = get(now) + Us,
    _ = put(now, Until),
    wait_until(Until, [], Player).

wait_until(Until, Out, Player) ->
    case replay_player:next_wake(Player) of
        Next when Next > Until -> {Out, Player};
        Next ->
            {More, After} = replay_player:wake(Next, Player),
            wait_until(Until, Out ++ More, After)
    end.

%% Player and what was published; the answer must be good.
ask(Verb, Object, Args, Text, P0) ->
    {1, _, Out, P1} = answer(Verb, Object, Args, Text, P0),
    {Out, P1}.

refused(Verb, Object, Args, Text, P0) ->
    {0, Line, _, _} = answer(Verb, Object, Args, Text, P0),
    ?assertEqual(nomatch, string:find(Line, "\n")),
    Line.

answer(Verb, Object, Args, Text, P0) ->
    Seq = case get(seq) of undefined -> 1; N -> N + 1 end,
    _ = put(seq, Seq),
    {Out, P1} = replay_player:control(
        #{client => <<"c">>, token => ?TOKEN, seq => Seq, verb => Verb, object => Object,
          args => Args, text => Text},
        sender, get(now), P0
    ),
    [#{ok := Ok, text := Line}] = of_type(ack, Out),
    {Ok, unicode:characters_to_list(Line), Out, P1}.

of_type(Type, Out) -> [M || {publish, {T, M}} <- Out, T =:= Type].

object(Id, Out) ->
    #{objects := Objects} = lists:last(of_type(frame, Out)),
    hd([O || #{id := I} = O <- Objects, I =:= Id]).

two_copters() ->
    P0 = live(),
    {_, P1} = ask(<<"add_object">>, -1, [-3.0, 0.0], <<>>, P0),
    {_, P2} = ask(<<"add_object">>, -1, [3.0, 0.0], <<>>, P1),
    P2.

%% ---- flying -----------------------------------------------------------------------------------

copters_come_and_go_test() ->
    {Out, P1} = wait(100000, two_copters()),
    #{pos := [-3.0, Y, _]} = object(0, Out),
    ?assert(Y == 0),
    {_, P2} = ask(<<"remove_object">>, 0, [], <<>>, P1),
    {More, P3} = wait(100000, P2),
    #{objects := [#{id := 1}]} = lists:last(of_type(frame, More)),
    ?assertEqual("remove_object: there is no copter 0",
                 refused(<<"remove_object">>, 0, [], <<>>, P3)).

%% Positive roll accelerates along x, until nobody holds the stick any more.
steering_moves_a_copter_and_is_released_test() ->
    {_, P1} = ask(<<"steer">>, 0, [0.1, 0.0, 0.0], <<>>, two_copters()),
    {Held, P2} = wait(290000, P1),
    #{flags := Flags, vel := [Vx, _, _], roll := Roll} = object(0, Held),
    ?assert(Flags band 16 =:= 16 andalso Vx > 0.05 andalso abs(Roll - 0.1) < 0.02),
    {Left, _} = wait(710000, P2),
    #{flags := After, roll := Level} = object(0, Left),
    ?assert(After band 16 =:= 0 andalso abs(Level) < 0.001).

%% A ranging fault moves what is perceived, not what is.
a_fault_changes_what_is_perceived_test() ->
    {_, P1} = wait(500000, two_copters()),
    Fault = <<"{\"probe\":\"RangeId0Anch1\",\"model\":\"offset\",\"params\":{\"value\":2.0}}">>,
    {_, P2} = ask(<<"inject">>, 0, [], Fault, P1),
    {Out, P3} = wait(3000000, P2),
    #{flags := Flags, pos := [X, Y, _], pos_est := [Ex, Ey, _]} = object(0, Out),
    ?assert(Flags band 4 =:= 4),
    ?assert(abs(X - Ex) + abs(Y - Ey) > 0.2),
    [#{probe := <<"RangeId0Anch1">>, type := <<"offset">>, active := 1, to_us := -1, hits := Hits,
       params := <<"{\"value\":2.0}">>}] = maps:get(items, lists:last(of_type(faults, Out))),
    ?assert(Hits >= 5),
    {_, P4} = ask(<<"clear_faults">>, -1, [], <<>>, P3),
    {More, _} = wait(3000000, P4),
    #{flags := 0, pos := [X2, Y2, _], pos_est := [Ex2, Ey2, _]} = object(0, More),
    ?assert(abs(X2 - Ex2) + abs(Y2 - Ey2) < 0.1).

%% One call of the probe of position is one step, which moves the copter's belief for good.
a_fault_may_last_so_many_calls_test() ->
    {_, P1} = wait(500000, two_copters()),
    Fault = <<"{\"probe\":\"PxId0\",\"model\":\"offset\",\"params\":{\"value\":0.5},"
              "\"from_calls\":0,\"for_calls\":1}">>,
    {_, P2} = ask(<<"inject">>, 0, [], Fault, P1),
    {Out, _} = wait(16667, P2),
    #{pos := [X, _, _], pos_est := [Ex, _, _]} = object(0, Out),
    ?assert(abs(Ex - X - 0.5) < 0.01),
    [#{hits := 1, to_us := To, from_us := From}] =
        maps:get(items, lists:last(of_type(faults, Out))),
    ?assertEqual(5000, To - From).

parameters_can_be_set_test() ->
    P0 = two_copters(),
    {_, P1} = ask(<<"set">>, -1, [0.7], <<"comfort_radius">>, P0),
    {Out, P2} = wait(100000, P1),
    ?assertMatch(#{comfort := 0.7}, object(0, Out)),
    {_, P3} = ask(<<"set">>, 0, [0.3], <<"pos_p">>, P2),
    ?assertMatch("set: there is no parameter comfort_radios; did you mean comfort_radius" ++ _,
                 refused(<<"set">>, -1, [0.7], <<"comfort_radios">>, P3)),
    ?assertEqual("set: parameter comfort_radius: -1 is outside 0..100",
                 refused(<<"set">>, -1, [-1.0], <<"comfort_radius">>, P3)),
    ?assertEqual("set: comfort_radius is one for all: set it without an object",
                 refused(<<"set">>, 0, [1.0], <<"comfort_radius">>, P3)).

what_cannot_be_injected_is_refused_in_one_line_test() ->
    P = two_copters(),
    Texts = [
        {<<"{\"probe\":\"PzId0\",\"model\":\"offset\"}">>, "inject: there is no probe"},
        {<<"{\"probe\":\"PxId9\",\"model\":\"offset\"}">>, "inject: there is no probe"},
        {<<"{\"model\":\"offset\"}">>, "inject: \"probe\" and \"model\" are needed"},
        {<<"{\"probe\":\"PxId0\",\"model\":\"ofset\",\"params\":{}}">>, "inject: "},
        {<<"{\"probe\":\"PxId0\",\"model\":\"offset\",\"params\":{\"value\":[]}}">>,
         "inject: value must be a number or a text"},
        {<<"{\"probe\":\"PxId0\",\"model\":\"offset\",\"params\":{\"value\":1},\"for_s\":-1}">>,
         "inject: for_s must be a number from 0 up"},
        {<<"{\"probe\":\"PxId0\",\"model\":\"offset\",\"params\":{\"value\":1},\"for_s\":1,"
           "\"for_calls\":1}">>, "inject: either seconds or calls"},
        {<<"{\"probe\":\"PxId0\",\"model\":\"offset\",\"params\":{\"value\":1},\"when\":1}">>,
         "inject: unknown member when"}
    ],
    [
        begin
            Line = refused(<<"inject">>, -1, [], Text, P),
            ?assertEqual({Line, Expected}, {Line, lists:sublist(Line, length(Expected))})
        end
     || {Text, Expected} <- Texts
    ],
    %% and the flight goes on
    {Out, _} = wait(1100000, P),
    ?assertMatch(#{items := []}, lists:last(of_type(faults, Out))).

the_page_is_told_what_may_be_injected_and_set_test() ->
    {Out, _} = wait(1100000, two_copters()),
    #{params := Params} = lists:last(of_type(case_info, Out)),
    {ok, #{<<"probes">> := Probes, <<"channels">> := Channels, <<"settings">> := Settings}} =
        faultcheck_json:decode(Params),
    ?assert(lists:member(<<"RangeId1Anch3">>, Probes)),
    ?assertEqual([<<"ITS_DATA0">>, <<"ITS_DATA1">>], Channels),
    ?assertMatch(#{<<"comfort_radius">> := 0.45, <<"pos_p">> := 0.8}, Settings).

a_scenario_is_flown_live_test() ->
    Dir = filename:join(code:priv_dir(copter_eqc), "counterexamples"),
    P0 = opened({view, live}, Dir),
    {Told, Waited} = wait(100000, P0),
    #{params := Params} = lists:last(of_type(case_info, Told)),
    {ok, #{<<"scenarios">> := Names}} = faultcheck_json:decode(Params),
    ?assert(lists:member(<<"deaf_copter.json">>, Names)),
    {_, P1} = ask(<<"scenario">>, -1, [], <<"deaf_copter.json">>, Waited),
    {Out, P2} = wait(2000000, P1),
    ?assertMatch(#{mode := 1, verdict := 2, run := 2, t_us := 1415000},
                 lists:last(of_type(status, Out))),
    ?assertEqual(filename:join(Dir, "no.json") ++ ": no such file or directory",
                 refused(<<"scenario">>, -1, [], <<"no.json">>, P2)).

%% ---- forks and stored cases -------------------------------------------------------------------

in_folder(Test) ->
    Dir = cb_files:fresh_name("cases", ""),
    try Test(Dir) after file:del_dir_r(Dir) end.

%% A case of the property as a failing run would store it.
stored_case(Root) ->
    {_, Options, Commands} = lists:keyfind("jump", 1, copter_stored:all()),
    ok = copter_options:use(Options),
    Case = #{
        module => prop_copter_demo, property => prop_copters_survive_faults, status => failed,
        seed => 17, test => 3, size => 20, transport => none, options => [],
        versions => faultcheck_versions:all(), original => [Commands], shrunk => [Commands],
        reasons => ["postcondition false"], shrink => #{tries => 5, accepted => 1}
    },
    {ok, Dir} = faultcheck_case:write(Root, Case),
    _ = copter_eqc:report(Case, Dir),
    Dir.

ends_as_recorded_test() ->
    in_folder(fun(Root) ->
        P = opened({'case', stored_case(Root), shrunk}),
        {Out, _} = wait(4000000, P),
        ?assertMatch(#{verdict := 2, message := "", t_us := 2750000, duration_us := 2750000},
                     lists:last(of_type(status, Out))),
        #{params := Params, seed := <<"17">>} = lists:last(of_type(case_info, Out)),
        {ok, #{<<"recorded">> := Recorded, <<"shrink_steps">> := 5}} =
            faultcheck_json:decode(Params),
        ?assertMatch(<<"failed: copters 0 and 2 collided at 2.750000 s", _/binary>>, Recorded)
    end).

a_doctored_case_differs_test() ->
    in_folder(fun(Root) ->
        Dir = stored_case(Root),
        File = filename:join(Dir, "case.json"),
        {ok, Text} = file:read_file(File),
        ok = file:write_file(File, string:replace(Text, "-1452", "-1400", all)),
        {Out, _} = wait(4000000, opened({'case', Dir, shrunk})),
        #{verdict := 3, message := Message} = lists:last(of_type(status, Out)),
        ?assertMatch("this build does not end as recorded" ++ _, Message)
    end).

a_case_without_its_scenario_is_refused_in_one_line_test() ->
    in_folder(fun(Root) ->
        Dir = stored_case(Root),
        ok = file:delete(filename:join(Dir, "scenario.json")),
        {error, Line} = replay_source:of_case(Dir, shrunk, none),
        ?assertEqual(Dir ++ ": scenario.json is missing; faultcheck report " ++ Dir ++ " writes it",
                     Line)
    end).

%% The example that comes along is the flight of a property too.
a_fork_of_the_example_can_be_stored_test() ->
    {_, P1} = wait(1000000, opened({view, example})),
    {_, P2} = ask(<<"fork">>, -1, [], <<>>, P1),
    {_, P3} = wait(500000, P2),
    [{store, #{property := prop_copters_survive_a_crowd, shrunk := [Commands]}, _}] =
        replay_player:close(P3),
    ?assertEqual(safe, copter_trial:run(copter_options:new(#{max_faults => 0}), Commands)).

%% The sky may be empty for a while.
a_flight_by_hand_is_a_sequence_of_its_property_test() ->
    {_, P1} = wait(500000, live()),
    {_, P2} = ask(<<"add_object">>, -1, [1.0, 1.0], <<>>, P1),
    {_, P3} = wait(500000, P2),
    {_, P4} = ask(<<"remove_object">>, 0, [], <<>>, P3),
    {_, P5} = wait(500000, P4),
    [{store, #{property := prop_copters_survive_faults, shrunk := [Commands]}, _}] =
        replay_player:close(P5),
    T = copter_sut:time_us(),
    ?assertEqual([fly_wait, fly_add, iterate, fly_remove, fly_wait],
                 [Name || {set, _, {call, copter_eqc, Name, _}} <- Commands]),
    ?assertEqual(safe, copter_trial:run(copter_options:new(#{world => reference}), Commands)),
    ?assertEqual(T, copter_sut:time_us()).

%% Stored, opened again: it ends in the same moment with the same bits.
a_fork_is_stored_and_played_again_test() ->
    in_folder(fun(Root) ->
        {_, P1} = wait(1000000, opened({'case', stored_case(Root), shrunk})),
        {_, P2} = ask(<<"fork">>, -1, [], <<>>, P1),
        {_, P3} = ask(<<"steer">>, 0, [0.05, -0.1, 0.2], <<>>, P2),
        {_, P4} = wait(1000000, P3),
        Fault = <<"{\"probe\":\"RollId2\",\"model\":\"drift_timed\",\"params\":{\"rate\":0.2,"
                  "\"limit\":5},\"for_s\":1}">>,
        {_, P5} = ask(<<"inject">>, 2, [], Fault, P4),
        {_, P6} = ask(<<"add_object">>, -1, [2.0, 2.0], <<>>, P5),
        {_, P7} = wait(2000000, P6),
        {_, P8} = ask(<<"stop_all">>, -1, [], <<>>, P7),
        [{store, Case, Files}] = replay_player:close(P8),
        Flown = [copter_sut:bits(V) || V <- [true, perceived]],
        T = copter_sut:time_us(),
        {ok, Dir} = faultcheck_case:write(Root, Case),
        [ok = file:write_file(filename:join(Dir, Name), Text) || {Name, Text} <- Files],
        {ok, {copter_view, View}} = replay_source:of_case(Dir, shrunk, none),
        {_, Begun} = copter_view:start(View),
        {_, Ended} = copter_view:advance(60000000, Begun),
        ?assertEqual(T, copter_view:now(Ended)),
        ?assertEqual({passed, passed}, {copter_view:ending(Ended), copter_view:recorded(Ended)}),
        ?assert(Flown =:= [copter_sut:bits(V) || V <- [true, perceived]]),
        %% as the property runs it
        {ok, Commands} = faultcheck_case:commands(maps:get(shrunk, Case)),
        ?assertEqual(safe, copter_trial:run(copter_options:new(#{world => reference}), Commands)),
        ?assert(Flown =:= [copter_sut:bits(V) || V <- [true, perceived]]),
        %% and as the scenario beside it
        ?assertMatch({ok, _}, copter_plan:read_scenario(filename:join(Dir, "scenario.json")))
    end).

%% ---- flights in the world of a scenario that no property has ----------------------------------

own_world(Dt) ->
    faultcheck_json:encode({object, [
        {format, <<"coptersim-scenario/1">>}, {dt_us, Dt}, {duration_us, 60000000},
        {its_div, 20}, {anchor_div, 20},
        {world, {object, [
            {lines, [{object, [{id, 7}, {p1, [-9, 9]}, {p2, [9, 9]}]}]},
            {anchors, [{object, [{id, N}, {pos, [X, Y, 2]}]}
                       || {N, X, Y} <- [{0, -5, -5}, {1, 5, -5}, {2, 0, 5}]]}
        ]}},
        {copters, [{object, [{id, 0}, {pos, [-3, 0]}]}, {object, [{id, 1}, {pos, [3, 0]}]}]}
    ]}).

%% Kept with its scenario, and played again from it: the same bits, the same end.
is_kept_and_played_again(Dt) ->
    in_folder(fun(Root) ->
        ok = filelib:ensure_dir(filename:join(Root, "x")),
        ok = file:write_file(filename:join(Root, "own.json"), own_world(Dt)),
        {_, P1} = wait(500000, opened({view, {scenario, filename:join(Root, "own.json")}})),
        {_, P2} = ask(<<"steer">>, 0, [0.05, -0.1, 0.2], <<>>, P1),
        {_, P3} = ask(<<"set">>, -1, [0.5], <<"comfort_radius">>, P2),
        Faults = [
            <<"{\"probe\":\"RangeId1Anch0\",\"model\":\"random_offset\",\"params\":{\"low\":0,"
              "\"high\":1},\"from_calls\":1,\"for_calls\":3}">>,
            <<"{\"probe\":\"RollId0\",\"model\":\"dropout\",\"params\":{\"probability\":0.5,"
              "\"mode\":\"zero\"},\"from_s\":0.2,\"for_s\":0.5}">>,
            <<"{\"probe\":\"ITS_DATA1\",\"model\":\"field\",\"params\":{\"type\":\"f32\","
              "\"apply\":\"saturate\",\"low\":\"-inf\",\"high\":2}}">>,
            <<"{\"probe\":\"PyId1\",\"model\":\"offset\",\"params\":{\"constant\":0.3},"
              "\"from_calls\":0,\"for_calls\":1}">>
        ],
        P4 = lists:foldl(fun(F, P) -> {_, Next} = ask(<<"inject">>, -1, [], F, P), Next end,
                         P3, Faults),
        {_, P5} = wait(1500000, P4),
        {_, P6} = ask(<<"add_object">>, -1, [0.0, -4.0], <<>>, P5),
        {_, P7} = wait(700000, P6),
        [{store, {flight, Id} = Kept, Files}] = replay_player:close(P7),
        Flown = [copter_sut:bits(V) || V <- [true, perceived]],
        T = copter_sut:time_us(),
        {ok, Dir} = replay_kept:write(Root, Kept, Files),
        ?assertEqual({ok, Dir}, replay_kept:find(Id, Root)),
        {ok, {copter_view, View}} = replay_source:of_case(Dir, shrunk, copter_view),
        ?assertEqual(passed, copter_view:recorded(View)),
        {_, Begun} = copter_view:start(View),
        {_, Ended} = copter_view:advance(60000000, Begun),
        ?assertEqual({T, passed}, {copter_view:now(Ended), copter_view:ending(Ended)}),
        ?assert(Flown =:= [copter_sut:bits(V) || V <- [true, perceived]]),
        %% and again by the program
        Trace = copter_test_scenario:run(filename:join(Dir, "scenario.json"), T),
        ?assertMatch(#{<<"end_t_us">> := T}, Trace),
        ?assertEqual(copter_test_scenario:compared({run, safe}),
                     copter_test_scenario:compared({trace, Trace}))
    end).

a_flight_in_a_world_of_its_own_is_kept_test() -> is_kept_and_played_again(5000).

so_is_one_with_short_steps_test() -> is_kept_and_played_again(500).

-module(copter_view_tests).
-include_lib("eunit/include/eunit.hrl").

%% Given a stored collision, its recording

opened(Name) ->
    {ok, View} = copter_view:open({named, Name}),
    {copter_view, View}.

recorded(Name) -> replay_recording:messages(opened(Name)).

of_type(Wanted, Messages) -> [{T, M} || {T, {Type, M}} <- Messages, Type =:= Wanted].

ends_as_the_sequence_does_test() ->
    {_, #{ending := {failed, Text}, end_us := End}} = recorded("jump"),
    {_, Options, Commands} = lists:keyfind("jump", 1, copter_stored:all()),
    {collision, #{ids := [A, B], t_us := T}} = copter_trial:rerun(Options, Commands),
    ?assertEqual(T, End),
    ?assertMatch({match, _}, re:run(Text, lists:concat(["copters ", A, " and ", B, " collided"]))).

has_a_frame_every_20_ms_and_at_each_event_test() ->
    {Messages, #{frames := Count}} = recorded("reflection_into_wall"),
    Times = [T || {T, _} <- of_type(frame, Messages)],
    ?assertEqual(Count, length(Times)),
    Gaps = [B - A || {A, B} <- lists:zip(lists:droplast(Times), tl(Times))],
    ?assert(lists:all(fun(Gap) -> Gap > 0 andalso Gap =< 20000 end, Gaps)),
    Events = [T || {T, _} <- of_type(event, Messages)],
    ?assertEqual([], lists:usort(Events) -- Times).

frames_show_what_the_simulator_computes_test() ->
    {Messages, _} = recorded("deaf_copter"),
    {_, Options, Commands} = lists:keyfind("deaf_copter", 1, copter_stored:all()),
    _ = copter_trial:rerun(Options, Commands),
    {_, #{objects := Objects}} = lists:last(of_type(frame, Messages)),
    [
        begin
            #{px := X, py := Y, roll := Roll, yaw := Yaw} = copter_sut:state(Id, true),
            #{px := EstX, vy := EstVy} = copter_sut:state(Id, perceived),
            ?assertMatch(#{pos := [X, Y, 0.5], pos_est := [EstX | _], vel_est := [_, EstVy, _]}, O),
            ?assert(abs(maps:get(roll, O) * 180 / math:pi() - Roll) < 1.0e-9),
            ?assert(abs(maps:get(yaw, O) * 180 / math:pi() - Yaw) < 1.0e-9)
        end
     || #{id := Id} = O <- Objects
    ],
    %% both who collided are marked, and their zone is the default one
    ?assertMatch([#{flags := F1, comfort := 0.45}, #{flags := F2}] when F1 band 1 =:= 1 andalso
                 F2 band 1 =:= 1, Objects).

folder() ->
    Dir = cb_files:fresh_name("view", ""),
    ok = file:make_dir(Dir),
    Dir.

is_the_same_file_each_time_test() ->
    Dir = folder(),
    Files = [filename:join(Dir, Name) || Name <- ["a.lcm", "b.lcm"]],
    [{ok, _} = replay_recording:write(opened("jump"), File) || File <- Files],
    [{ok, A}, {ok, B}] = [file:read_file(File) || File <- Files],
    ?assert(A =:= B),
    {ok, Events} = replay_lcm_log:events(A),
    Types = [Type || #{data := Data} <- Events, {ok, Type, _} <- [replay_lcm:decode(Data)]],
    ?assertEqual(length(Events), length(Types)),
    ?assertEqual([case_info, event, faults, frame, ranges, risk, status, world],
                 lists:usort(Types)),
    %% whoever reads up to the end knows the verdict
    #{data := Last} = lists:last([E || #{channel := <<"VIZ_STATUS">>} = E <- Events]),
    ?assertMatch({ok, status, #{verdict := 2, mode := 2, t_us := T, duration_us := T}},
                 replay_lcm:decode(Last)),
    ok = file:del_dir_r(Dir).

a_fault_is_shown_while_it_acts_test() ->
    {Messages, _} = recorded("jump"),
    Told = [{T, Items} || {T, #{items := Items}} <- of_type(faults, Messages), Items =/= []],
    {1400000, [#{probe := <<"PyId2">>, active := 1, from_us := 1400000, to_us := 1405000,
                 object := 2, hits := 0}]} = hd(Told),
    {_, [#{active := 0, hits := 1}]} = lists:nth(2, Told),
    Faulted = [T || {T, #{objects := Os}} <- of_type(frame, Messages), #{flags := F} <- Os,
                    F band 4 =:= 4],
    ?assertEqual([1400000], Faulted),
    %% 1.452 m to the south is where it believes to be a step later
    {_, #{objects := [_, #{pos := [_, Y, _], pos_est := [_, EstY, _]}]}} =
        lists:keyfind(1420000, 1, of_type(frame, Messages)),
    ?assert(abs(EstY - Y + 1.452) < 0.01).

contours_are_those_of_whoever_collided_test() ->
    {Messages, _} = recorded("jump"),
    Risks = of_type(risk, Messages),
    ?assertEqual([0], lists:usort([O || {_, #{observer := O}} <- Risks])),
    {_, #{ellipses := Ellipses}} = lists:last(Risks),
    %% copter 2, and six lines by their places
    ?assertEqual([{0, 2} | [{1, N} || N <- lists:seq(0, 5)]],
                 [{Kind, About} || #{kind := Kind, about := About} <- Ellipses]).

%% A radius that follows the error differs from copter to copter.
zones_may_follow_the_error_test() ->
    {_, Options, Commands} = lists:keyfind("reflection_into_wall", 1, copter_stored:all()),
    Settings = copter_sut:settings(Options#{set := #{comfort_error_gain => 1.0}}),
    Plan = copter_plan:from_commands(Commands, 5000),
    {ok, View} = copter_view:open({flight, "x", Settings, Plan}),
    {Messages, _} = replay_recording:messages({copter_view, View}),
    Radii = [R || {_, #{objects := Os}} <- of_type(frame, Messages), #{comfort := R} <- Os],
    ?assertEqual(0.45, hd(Radii)),
    ?assert(lists:max(Radii) > 0.5 andalso lists:max(Radii) =< 0.45 + 0.5).

%% ---- scenarios ----------------------------------------------------------------------------------

a_scenario_flies_as_its_sequence_test() ->
    {_, Options, Commands} = lists:keyfind("crowd_without_faults", 1, copter_stored:all()),
    Json = filename:join(code:priv_dir(copter_eqc), "counterexamples/crowd_without_faults.json"),
    {ok, #{settings := Settings, plan := Plan, name := <<"crowd_without_faults">>}} =
        copter_plan:read_scenario(Json),
    {ok, View} = copter_view:open({flight, "scenario", Settings, Plan}),
    {_, Started} = copter_view:start(View),
    {_, Ended} = copter_view:advance(30000000, Started),
    Bits = [copter_sut:bits(V) || V <- [true, perceived]],
    {collision, #{t_us := T}} = copter_trial:rerun(Options, Commands),
    ?assertEqual(T, copter_view:now(Ended)),
    ?assert(Bits =:= [copter_sut:bits(V) || V <- [true, perceived]]).

%% Times of a fault count from that of its event, also when that is between two steps.
windows_of_scenarios_test() ->
    File = filename:join(folder(), "s.json"),
    Trigger = fun(T, Members) ->
        ok = file:write_file(File, faultcheck_json:encode({object, [
            {format, <<"coptersim-scenario/1">>}, {dt_us, 5000}, {duration_us, 5000},
            {copters, []},
            {events, [{object, [{t_us, T}, {type, fault}, {probe, <<"PxId0">>}, {model, offset},
                                {value, 1}, {x_why, <<"a comment">>} | Members]}]}
        ]})),
        {ok, #{plan := #{planned := [{15000, 0, Call}]}}} = copter_plan:read_scenario(File),
        {fly_inject, [{probe, <<"PxId0">>}, <<"offset">>, [{<<"value">>, 1}], When, none]} = Call,
        When
    end,
    ?assertEqual([], Trigger(15000, [{delay_us, 0}])),
    ?assertEqual([{time, 2000000, forever}], Trigger(15000, [{delay_us, 2000}])),
    ?assertEqual([{time, 2000000, 7000000}],
                 Trigger(12000, [{delay_us, 5000}, {duration_us, 7000}])),
    ?assertEqual([{time, 0, 7000000}], Trigger(12000, [{duration_us, 10000}])),
    ?assertEqual([{time, 0, 0}], Trigger(12000, [{duration_us, 1000}])),
    ?assertEqual([{from, 2}, {for, 3}], Trigger(12000, [{for_calls, 3}, {from_calls, 2}])),
    ok = file:del_dir_r(filename:dirname(File)).

what_is_no_scenario_is_said_in_one_line_test() ->
    Dir = folder(),
    File = filename:join(Dir, "s.json"),
    Refused = fun(Text) ->
        ok = file:write_file(File, Text),
        {error, Line} = copter_plan:read_scenario(File),
        ?assertEqual(nomatch, string:find(Line, "\n")),
        Line
    end,
    ?assertMatch({match, _}, re:run(Refused("{"), "not JSON at byte 1")),
    ?assertMatch({match, _}, re:run(Refused("{}"), "not a scenario")),
    Head = "{\"format\":\"coptersim-scenario/1\",\"dt_us\":5000,\"copters\":[]",
    ?assertMatch({match, _}, re:run(Refused(Head ++ "}"), "duration_us is missing")),
    Events = ",\"duration_us\":1,\"events\":[{\"t_us\":0,\"type\":\"dance\"}]}",
    ?assertMatch({match, _}, re:run(Refused(Head ++ Events), "events of type dance")),
    Fault = fun(Model, Members) ->
        Refused(Head ++ ",\"duration_us\":1,\"events\":[{\"t_us\":0,\"type\":\"packet_fault\","
                "\"channel\":\"ITS_DATA0\",\"model\":\"" ++ Model ++ "\"," ++ Members ++ "}]}")
    end,
    Lines = [
        {"lose", "\"delay_us\":-1,\"duration_us\":9",
         "delay_us: a whole number from 0 up expected"},
        {"lose", "\"for_calls\":0.5", "for_calls: a whole number from 0 up expected"},
        {"lose", "\"delay_us\":0,\"for_calls\":1",
         "either delay_us and duration_us, or from_calls and for_calls"},
        {"repeat", "\"count\":10001", "ITS_DATA0: count: 10000 are the most"},
        {"extend", "\"params\":{\"count\":65537}", "ITS_DATA0: count: 65536 are the most"},
        {"drop", "\"params\":{\"count\":[]}", "ITS_DATA0: count must be a number or a text"}
    ],
    [?assertEqual(File ++ ": " ++ Why, Fault(Model, Members)) || {Model, Members, Why} <- Lines],
    ok = file:del_dir_r(Dir).

-module(copter_eqc_tests).
-include_lib("eunit/include/eunit.hrl").

sequences(Changes, Size, N) ->
    ok = copter_options:use(copter_options:new(Changes)),
    [
        faultcheck_proper:with_state(Size, {1, 2, Number}, fun() ->
            {Commands, _} = faultcheck_generator:generate(copter_eqc, Size),
            [{Name, Args} || {set, _, {call, _, Name, Args}} <- Commands]
        end)
     || Number <- lists:seq(1, N)
    ].

names(Sequence) -> [Name || {Name, _} <- Sequence].

copters_come_first_and_their_number_is_uniform_test() ->
    Sequences = [S || S <- sequences(#{max_copters => 5}, 200, 500), length(S) > 6],
    Counts = [
        begin
            {Copters, Rest} = lists:splitwith(fun(Name) -> Name =:= add_copter end, names(S)),
            ?assertNot(lists:member(add_copter, Rest)),
            length(Copters)
        end
     || S <- Sequences
    ],
    Shares = [length([C || C <- Counts, C =:= N]) / length(Counts) || N <- lists:seq(1, 5)],
    %% four standard deviations of 0.2 in some 480 sequences
    [?assert(abs(Share - 0.2) < 0.075) || Share <- Shares].

a_fixed_number_of_copters_is_kept_test() ->
    Changes = #{world => reference, min_copters => 4, max_copters => 4},
    [
        ?assertEqual(4, length([a || add_copter <- names(S)]))
     || S <- sequences(Changes, 100, 50), length(S) > 4
    ].

many_copters_are_one_command_test() ->
    Changes = #{world => {box, 200}, min_copters => 100, max_copters => 200},
    [
        begin
            [{add_grid, [N, _]} | Rest] = S,
            ?assert(N >= 100 andalso N =< 200),
            ?assertNot(lists:member(add_grid, names(Rest)))
        end
     || S <- sequences(Changes, 30, 20), S =/= []
    ].

steering_and_time_alternate_test() ->
    [
        ?assertEqual([], [A || {A, A} <- pairs(names(S)), A =:= steer orelse A =:= iterate])
     || S <- sequences(#{}, 100, 30)
    ].

pairs([]) -> [];
pairs(List) -> lists:zip(lists:droplast(List), tl(List)).

faults_are_limited_test() ->
    Sequences = sequences(#{max_faults => 2}, 200, 100),
    ?assertEqual(2, lists:max([most_armed(names(S), 0, 0) || S <- Sequences])),
    Without = [F || S <- sequences(#{max_faults => 0}, 100, 30), F <- names(S), is_fault(F)],
    ?assertEqual([], Without),
    Only = [F || S <- sequences(#{faults => [loss]}, 100, 30), F <- names(S), is_fault(F)],
    ?assertEqual([fault_clear, fault_loss], lists:usort(Only)).

is_fault(Name) -> lists:prefix("fault_", atom_to_list(Name)).

most_armed([], _, Most) -> Most;
most_armed([fault_clear | Rest], _, Most) -> most_armed(Rest, 0, Most);
most_armed([Name | Rest], Now, Most) ->
    Next = case is_fault(Name) of true -> Now + 1; false -> Now end,
    most_armed(Rest, Next, max(Most, Next)).

%% A copter that is taken out takes along what is about it alone.
removing_a_copter_leaves_the_others_test() ->
    ok = copter_options:use(copter_options:new(#{})),
    Commands = copter_test_commands:of_calls([
        {add_copter, [0, 0, 0]}, {add_copter, [1, 500, 0]}, {steer, [0, 10, 0, 0]},
        {iterate, [100]}, {steer, [1, 20, 0, 0]}, {fault_gain, [0, roll, 1050]}, {iterate, [200]}
    ]),
    Kept = faultcheck_repair:repair(copter_eqc, tl(Commands)),
    ?assertEqual(
        [{add_copter, [1, 500, 0]}, {iterate, [100]}, {steer, [1, 20, 0, 0]}, {iterate, [200]}],
        [{F, A} || {set, _, {call, _, F, A}} <- Kept]
    ).

%% What the runner asks of a model when it stores a case.
a_case_gets_its_scenario_its_recording_and_its_page_test() ->
    ok = copter_options:use(copter_options:new(#{world => reference})),
    Commands = copter_test_commands:of_calls([{add_copter, [0, 0, 0]}, {iterate, [1000]}]),
    Dir = cb_files:fresh_name("copter_case", ""),
    ok = file:make_dir(Dir),
    try
        Told = copter_eqc:report(
            #{
                module => prop_copter,
                property => prop_x,
                status => failed,
                options => [],
                shrink => #{},
                reasons => ["postcondition false"],
                seed => 4711,
                versions => #{faultcheck => "1", proper => "2", otp => "3", git => "4"},
                original => [Commands],
                shrunk => [Commands]
            },
            Dir
        ),
        ?assertMatch(#{watch := true}, Told),
        ?assert(filelib:is_regular(filename:join(Dir, "run.lcm"))),
        %% Where nobody has built the page, a note says so.
        case replay_report:page() of
            {ok, _} -> ?assert(filelib:is_regular(filename:join(Dir, "report.html")));
            {error, Line} -> ?assertEqual(["no report.html: " ++ Line], maps:get(notes, Told))
        end,
        {ok, Text} = file:read_file(filename:join(Dir, "scenario.json")),
        {ok, Scenario} = faultcheck_json:decode(Text),
        ?assertMatch(
            #{
                <<"format">> := <<"coptersim-scenario/1">>,
                <<"name">> := <<"prop_x">>,
                <<"x_seed">> := 4711,
                <<"x_versions">> := #{<<"otp">> := <<"3">>},
                <<"duration_us">> := 1000000
            },
            Scenario
        )
    after
        file:del_dir_r(Dir)
    end.

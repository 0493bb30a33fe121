%% What a failing flight leaves in its folder for people.
-module(copter_report_tests).
-include_lib("eunit/include/eunit.hrl").

-define(MB, 1000000).
%% The page is at most so large (viz_page_kb bounds its script, compressed).
-define(PAGE, (500 * 1000)).

%% Ten copters in a row on the middle line, each steered a little.
commands() ->
    [call(N + 1, add_copter, [N, -500 + 110 * N, 0]) || N <- lists:seq(0, 9)] ++
        [call(20 + N, steer, [N, 0, 4, 0]) || N <- lists:seq(0, 9)] ++
        [call(40 + N, iterate, [2000]) || N <- lists:seq(0, 14)].

call(N, Name, Args) -> {set, {var, N}, {call, copter_eqc, Name, Args}}.

recorded(File) ->
    #{dt_us := Dt} = Settings = copter_sut:settings(copter_options:new(#{world => reference})),
    Plan = copter_plan:from_commands(commands(), Dt),
    {ok, View} = copter_view:open({flight, "ten copters", Settings, Plan}),
    {ok, Summary} = replay_recording:write({copter_view, View}, File),
    Summary.

report_test_() ->
    {timeout, 60, {"a flight of ten copters for 30 s makes a report of at most 2 MB", fun() ->
        File = cb_files:fresh_name("flight", ".lcm"),
        #{end_us := 30000000, ending := passed} = recorded(File),
        {ok, Log} = file:read_file(File),
        ok = file:delete(File),
        {Html, []} = replay_report:format(<<"<body></body>">>, Log, "ten copters"),
        Size = iolist_size(Html),
        ?assert(Size + ?PAGE =< 2 * ?MB),
        {Again, []} = replay_report:format(<<"<body></body>">>, Log, "ten copters"),
        ?assertEqual(iolist_to_binary(Html), iolist_to_binary(Again))
    end}}.

%% Of the machine nothing is told: neither folders nor who runs it.
nothing_of_the_machine_is_in_a_recording_test() ->
    File = cb_files:fresh_name("flight", ".lcm"),
    _ = recorded(File),
    {ok, Log} = file:read_file(File),
    ok = file:delete(File),
    {ok, Here} = file:get_cwd(),
    Private = [Here, filename:dirname(File)] ++ [
        Value || Name <- ["HOME", "PWD"], Value <- [os:getenv(Name)], is_list(Value),
        length(Value) > 1
    ],
    [
        ?assertEqual({Text, nomatch}, {Text, binary:match(Log, unicode:characters_to_binary(Text))})
     || Text <- Private
    ].

%% The simulator told by C++ (coptersim_stream) and by Erlang (copter_view, replay_recording): the
%% same scenario must give the same messages, byte for byte.
-module(copter_stream_tests).
-include_lib("eunit/include/eunit.hrl").

-define(SAME, [<<"VIZ_FRAME">>, <<"VIZ_RISK">>, <<"VIZ_RANGE">>, <<"VIZ_WORLD">>,
               <<"VIZ_FAULTS">>]).

both_tell_the_same_test_() ->
    {timeout, 60, [
        {Name, fun() -> tell_the_same(Name, Observer) end}
     || {Name, Observer} <- [{"crossing", "0"}, {"lost_messages", "0"}, {"reflection", "0"}]
    ]}.

tell_the_same(Name, Observer) ->
    Scenario = filename:join([root(), "examples", "copter", Name ++ ".json"]),
    Native = cb_files:fresh_name("copter_stream", ".lcm"),
    Erlang = cb_files:fresh_name("copter_stream", ".lcm"),
    try
        ok = stream(["--log", Native, "--observer", Observer, Scenario]),
        record(Scenario, Erlang),
        {Theirs, Ours} = {by_channel(Native), by_channel(Erlang)},
        ?assert(length(maps:get(<<"VIZ_FRAME">>, Ours)) > 100),
        [?assertEqual({Channel, maps:get(Channel, Theirs)}, {Channel, maps:get(Channel, Ours)})
         || Channel <- ?SAME]
    after
        [file:delete(File) || File <- [Native, Erlang]]
    end.

record(Scenario, File) ->
    {ok, #{name := Name, settings := Settings, plan := Plan}} =
        copter_plan:read_scenario(Scenario),
    {ok, View} = copter_view:open({flight, binary_to_list(Name), Settings, Plan}),
    {ok, _} = replay_recording:write({copter_view, View}, File).

%% Each message with its time.
by_channel(File) ->
    {ok, Events} = replay_lcm_log:read(File),
    lists:foldr(
        fun(#{channel := Channel, t_us := T, data := Data}, All) ->
            maps:update_with(Channel, fun(Later) -> [{T, Data} | Later] end, [{T, Data}], All)
        end,
        #{},
        Events
    ).

root() ->
    Up = fun(_, Path) -> filename:dirname(Path) end,
    lists:foldl(Up, filename:absname(library()), [lib, native, '_build', clone]).

library() -> cb_library:find("libcoptersim.so", copter_sut).

stream(Args) ->
    Program = filename:join([filename:dirname(filename:dirname(library())), "bin",
                             "coptersim_stream"]),
    filelib:is_regular(Program) orelse
        error({no_program, Program, "it needs liblcm-dev, liblcm-bin and a new build"}),
    Port = open_port({spawn_executable, Program}, [{args, Args}, binary, exit_status]),
    ended(Port).

ended(Port) ->
    receive
        {Port, {data, _}} -> ended(Port);
        {Port, {exit_status, 0}} -> ok;
        {Port, {exit_status, Status}} -> {exit_status, Status}
    end.

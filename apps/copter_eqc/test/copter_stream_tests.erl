%% The same flight told in C++ (coptersim_stream) and in Erlang: the same bytes.
-module(copter_stream_tests).
-include_lib("eunit/include/eunit.hrl").

-define(CHANNELS, [<<"VIZ_FRAME">>, <<"VIZ_RISK">>, <<"VIZ_RANGE">>]).

%% The program is built where liblcm is installed.
both_tell_the_same_test_() ->
    Program = copter_test_scenario:program("coptersim_stream"),
    [
        {Name, fun() -> compare(Program, Name) end}
     || filelib:is_regular(Program), {Name, _, _} <- copter_stored:all()
    ].

compare(Program, Name) ->
    Dir = cb_files:fresh_name("stream", ""),
    ok = file:make_dir(Dir),
    Scenario = filename:join([code:priv_dir(copter_eqc), "counterexamples", Name ++ ".json"]),
    {ok, View} = copter_view:open({named, Name}),
    Ours = filename:join(Dir, "ours.lcm"),
    {ok, _} = replay_recording:write({copter_view, View}, Ours),
    Theirs = filename:join(Dir, "theirs.lcm"),
    Args = ["--log", Theirs, "--observer", observer(Ours), Scenario],
    _ = copter_test_scenario:output_of(Program, Args),
    {A, B} = {told(Ours), told(Theirs)},
    Common = [{Key, V, maps:get(Key, B)} || {Key, V} <- maps:to_list(A), is_map_key(Key, B)],
    %% most moments are told by both
    ?assert(length(Common) * 10 > 9 * map_size(B)),
    ?assertEqual([], [Key || {Key, X, Y} <- Common, X =/= Y]),
    ok = file:del_dir_r(Dir).

observer(File) ->
    {ok, Events} = replay_lcm_log:read(File),
    [#{data := Data} | _] = [E || #{channel := <<"VIZ_RISK">>} = E <- Events],
    {ok, risk, #{observer := Id}} = replay_lcm:decode(Data),
    integer_to_list(Id).

%% By channel and moment, without the numbers of run and frame.
told(File) ->
    {ok, Events} = replay_lcm_log:read(File),
    maps:from_list([
        {{Channel, T}, body(Channel, Data)}
     || #{channel := Channel, t_us := T, data := Data} <- Events, lists:member(Channel, ?CHANNELS)
    ]).

body(<<"VIZ_FRAME">>, <<Type:64, T:64, _Run:32, _Seq:32, Rest/binary>>) -> {Type, T, Rest};
body(_, <<Type:64, T:64, _Run:32, Rest/binary>>) -> {Type, T, Rest}.

%% The player's process over real UDP, from one socket of this host to another; waits are for
%% messages, never for time.
-module(replay_player_server_tests).
-include_lib("eunit/include/eunit.hrl").

-define(TOKEN, <<"0123456789abcdef0123456789abcdef">>).
-define(PATIENCE, 5000).

with_player(What, Test) ->
    {ok, Probe} = gen_udp:open(0, [{ip, {127, 0, 0, 1}}]),
    {ok, Port} = inet:port(Probe),
    ok = gen_udp:close(Probe),
    Url = lists:concat(["127.0.0.1:", Port]),
    {ok, Lcm} = replay_lcm_udp:open(Url, #{role => listener}),
    Cases = cb_files:fresh_name("cases", ""),
    Self = self(),
    {ok, Player} = replay_player_server:start(#{
        player => #{
            opening => {view, What}, number => 100, view => replay_test_source, token => ?TOKEN,
            cases => Cases, scenarios => Cases, playing => true, speed => 1.0
        },
        url => Url,
        udp => #{},
        say => fun(Line) -> Self ! {said, lists:flatten(Line)} end
    }),
    try
        Test(#{lcm => Lcm, player => Player, url => Url, cases => Cases})
    after
        is_process_alive(Player) andalso replay_player_server:stop(Player),
        replay_lcm_udp:close(Lcm),
        file:del_dir_r(Cases)
    end.

%% The first message of that kind that fits.
await(Type, Fits, Lcm) ->
    Channel = replay_lcm:channel(Type),
    receive
        {udp, _, _, _, _} = Info ->
            case replay_lcm_udp:incoming(Info, Lcm) of
                {message, Channel, Payload, _, Next} ->
                    {ok, Message} = replay_lcm:decode(Type, Payload),
                    case Fits(Message) of
                        true -> {Message, Next};
                        false -> await(Type, Fits, Next)
                    end;
                {message, _, _, _, Next} -> await(Type, Fits, Next);
                {none, Next} -> await(Type, Fits, Next);
                %% of a socket that is closed by now
                unknown -> await(Type, Fits, Lcm)
            end;
        {udp_passive, _} = Info ->
            case replay_lcm_udp:incoming(Info, Lcm) of
                {none, Next} -> await(Type, Fits, Next);
                unknown -> await(Type, Fits, Lcm)
            end
    after ?PATIENCE ->
        error({nothing_came, Type})
    end.

any(_) -> true.

ask(Seq, Verb, Changes, Lcm) ->
    Message = maps:merge(
        #{client => <<"page-1">>, token => ?TOKEN, seq => Seq, verb => Verb, object => -1,
          args => [], text => <<>>},
        Changes
    ),
    ok = replay_lcm_udp:publish(Lcm, <<"VIZ_CONTROL">>, replay_lcm:encode(control, Message)),
    await(ack, fun(#{seq := S}) -> S =:= Seq end, Lcm).

is_played_and_asked_over_udp_test() ->
    with_player({moving, 60000000, passed, passed}, fun(#{lcm := L0}) ->
        {#{run := 100}, L1} = await(frame, fun any/1, L0),
        {#{case_id := <<"test">>}, L2} = await(case_info, fun any/1, L1),
        {#{ok := 1}, L3} = ask(1, <<"pause">>, #{}, L2),
        {#{paused := 1}, L4} = await(status, fun(#{paused := P}) -> P =:= 1 end, L3),
        {#{ok := 1}, L5} = ask(2, <<"seek">>, #{args => [30.0]}, L4),
        {#{run := 100}, L6} = await(frame, fun(#{t_us := T}) -> T =:= 30000000 end, L5),
        {#{ok := 1}, L7} = ask(3, <<"seek">>, #{args => [0.5]}, L6),
        {#{run := 101}, L8} = await(frame, fun(#{t_us := T}) -> T =:= 500000 end, L7),
        {#{ok := 0, text := <<"dance: there is no such verb">>}, _} = ask(4, <<"dance">>, #{}, L8)
    end).

plays_as_fast_as_time_passes_test() ->
    with_player({moving, 60000000, passed, passed}, fun(#{lcm := L0}) ->
        {#{t_us := T0}, L1} = await(frame, fun any/1, L0),
        Begun = erlang:monotonic_time(microsecond),
        {#{t_us := T1}, _} = await(frame, fun(#{t_us := T}) -> T >= T0 + 500000 end, L1),
        Took = erlang:monotonic_time(microsecond) - Begun,
        ?assert(abs(Took - (T1 - T0)) < 100000)
    end).

steering_is_released_test() ->
    with_player(live, fun(#{lcm := L0}) ->
        {_, L1} = await(frame, fun any/1, L0),
        {#{ok := 1}, L2} = ask(1, <<"steer">>, #{object => 0, args => [0.1, 0.0, 0.0]}, L1),
        {_, L3} = await(frame, fun(#{objects := [#{flags := F}]}) -> F =:= 16 end, L2),
        {_, _} = await(frame, fun(#{objects := [#{flags := F}]}) -> F =:= 0 end, L3)
    end).

a_flight_is_stored_when_the_player_ends_test() ->
    with_player(live, fun(#{lcm := L0, player := Player, cases := Cases}) ->
        {_, L1} = await(frame, fun any/1, L0),
        {#{ok := 1}, L2} = ask(1, <<"set">>, #{text => <<"y">>, args => [2.0]}, L1),
        ok = replay_player_server:stop(Player),
        {#{text := <<"stored this flight as ", Id/binary>>}, _} =
            await(event, fun(#{kind := Kind}) -> Kind =:= <<"log">> end, L2),
        ?assert(filelib:is_dir(filename:join(Cases, Id))),
        [Case] = filelib:wildcard(filename:join(Cases, "*/case.json")),
        {ok, #{status := passed}} = faultcheck_case:read(Case),
        {ok, <<"more">>} = file:read_file(filename:join(filename:dirname(Case), "more.txt"))
    end).

a_live_flight_is_written_while_it_goes_on_test() ->
    with_player(live, fun(#{lcm := L0, player := Player, cases := Cases}) ->
        {_, L1} = await(frame, fun any/1, L0),
        {#{ok := 1}, L2} = ask(1, <<"set">>, #{text => <<"y">>, args => [2.0]}, L1),
        Pattern = filename:join(Cases, ".unfinished-*/*/more.txt"),
        Unfinished = fun() -> filelib:wildcard(Pattern) end,
        %% within ten seconds of flight
        {#{t_us := T}, _} = await(frame, fun(#{t_us := T}) ->
            Unfinished() =/= [] orelse T > 10000000
        end, L2),
        ?assert(T =< 10000000),
        ok = replay_player_server:stop(Player),
        ?assertEqual([], Unfinished()),
        ?assertMatch([_], filelib:wildcard(filename:join(Cases, "*/case.json")))
    end).

%% A player that is killed leaves the flight to the next one; here its folder gets the number of a
%% process that is none.
a_flight_outlives_its_player_test() ->
    Cases = cb_files:fresh_name("cases", ""),
    {ok, Source} = replay_test_source:open(live),
    ok = replay_unsaved:write(Cases, replay_test_source, Source),
    ok = replay_unsaved:write(Cases, replay_test_source, Source),
    %% not while its player lives
    ?assertEqual([], replay_unsaved:recover(Cases)),
    [Root] = filelib:wildcard(filename:join(Cases, ".unfinished-*")),
    ok = file:rename(Root, filename:join(Cases, ".unfinished-999999999")),
    [Dir] = replay_unsaved:recover(Cases),
    {ok, #{property := prop_test}} = faultcheck_case:read(Dir),
    {ok, <<"more">>} = file:read_file(filename:join(Dir, "more.txt")),
    ?assertEqual([], filelib:wildcard(filename:join(Cases, ".unfinished-*"))),
    ok = replay_unsaved:write(Cases, replay_test_source, Source),
    ok = replay_unsaved:forget(Cases),
    ?assertEqual([], filelib:wildcard(filename:join(Cases, ".unfinished-*"))),
    ok = file:del_dir_r(Cases).

%% Whoever listens may go and come again.
a_new_listener_hears_everything_within_a_second_test() ->
    with_player({moving, 60000000, passed, passed}, fun(#{lcm := L0, url := Url}) ->
        {_, L1} = await(frame, fun any/1, L0),
        ok = replay_lcm_udp:close(L1),
        {ok, L2} = replay_lcm_udp:open(Url, #{role => listener}),
        lists:foldl(
            fun(Type, L) -> element(2, await(Type, fun any/1, L)) end,
            L2,
            [frame, world, case_info, faults, status]
        ),
        replay_lcm_udp:close(L2)
    end).

what_is_no_control_message_is_refused_in_one_line_test() ->
    with_player({moving, 60000000, passed, passed}, fun(#{lcm := L0}) ->
        {_, L1} = await(frame, fun any/1, L0),
        ok = replay_lcm_udp:publish(L1, <<"VIZ_CONTROL">>, <<0:64>>),
        receive
            {said, "refused a control message: " ++ Line} ->
                ?assertEqual(nomatch, string:find(Line, "\n"))
        after ?PATIENCE -> error(nothing_said)
        end,
        {#{ok := 0}, L2} = ask(1, <<"pause">>, #{token => <<"guess">>}, L1),
        receive
            {said, "refused a control message with a wrong token"} -> ok
        after ?PATIENCE -> error(nothing_said)
        end,
        {#{paused := 0}, _} = await(status, fun any/1, L2)
    end).

a_port_in_use_is_one_line_test() ->
    {error, Line} = replay_player_server:start(#{
        player => #{
            opening => {view, live}, number => 1, view => replay_test_source, token => none,
            cases => "", scenarios => "", playing => true, speed => 1.0
        },
        url => "udpm://10.0.0.1:7667", udp => #{}, say => fun(_) -> ok end
    }),
    ?assertMatch({match, _}, re:run(Line, "10.0.0.1")).

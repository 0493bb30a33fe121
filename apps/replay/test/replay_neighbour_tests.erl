%% Two players on one group, over real multicast on the loopback interface.
-module(replay_neighbour_tests).
-include_lib("eunit/include/eunit.hrl").

url() ->
    {ok, Probe} = gen_udp:open(0, [{ip, {127, 0, 0, 1}}]),
    {ok, Port} = inet:port(Probe),
    ok = gen_udp:close(Probe),
    lists:concat(["udpm://239.255.76.67:", Port, "?ttl=0"]).

moving() -> {moving, 60000000, passed, passed}.

options(Url) -> options(Url, moving()).

options(Url, What) ->
    #{
        player => #{
            opening => {view, What}, number => 1,
            view => replay_test_source, token => none, cases => "", scenarios => "",
            %% a paused one is heard as well
            playing => false, speed => 1.0
        },
        url => Url, udp => #{}, say => fun(_) -> ok end
    }.

player(Url) ->
    {ok, Player} = replay_player_server:start(options(Url)),
    Player.

another_player_is_found_until_it_ends_test() ->
    Url = url(),
    Player = player(Url),
    ?assertMatch({found, "another player sends to 239.255.76.67:" ++ _},
                 replay_neighbour:find(Url, #{})),
    ?assertEqual(2, replay_cli:run(["--group", Url])),
    %% on another group it is not met
    ?assertEqual(none, replay_neighbour:find(url(), #{})),
    ok = replay_player_server:stop(Player),
    ?assertEqual(none, replay_neighbour:find(Url, #{})).

by_unicast_nobody_is_looked_for_test() ->
    ?assertEqual(none, replay_neighbour:find("127.0.0.1:7667", #{})),
    ?assertEqual(none, replay_neighbour:find("no address", #{})).

%% ---- started together -------------------------------------------------------------------------

-define(PATIENCE, 10000).
-define(ALWAYS, 1000000000).

%% Somebody who tells a status as a player does, and hears what is told.
neighbour(Url) ->
    {ok, Lcm} = replay_lcm_udp:open(Url, #{}),
    Lcm.

tell(Lcm) ->
    Status = #{
        mode => 2, paused => 1, speed => 1.0, t_us => 0, duration_us => 0, run => 1, verdict => 0,
        control_allowed => 0, message => <<>>
    },
    ok = replay_lcm_udp:publish(Lcm, <<"VIZ_STATUS">>, replay_lcm:encode(status, Status)).

%% The port of the next status that is told.
teller(Lcm) ->
    receive
        Info when element(1, Info) =:= udp; element(1, Info) =:= udp_passive ->
            case replay_lcm_udp:incoming(Info, Lcm) of
                {message, <<"VIZ_STATUS">>, _, {_, Port}, Next} -> {Port, Next};
                {message, _, _, _, Next} -> teller(Next);
                {none, Next} -> teller(Next);
                unknown -> teller(Lcm)
            end
    after ?PATIENCE -> error(nobody_tells)
    end.

%% Statuses until all of these ports have told so many.
told([], Lcm) ->
    Lcm;
told(Awaited, Lcm) ->
    {Port, Next} = teller(Lcm),
    told(lists:delete(Port, Awaited), Next).

%% One that sends from a port on that side of another one.
neighbour_with(Fits, Url) ->
    Lcm = neighbour(Url),
    case Fits(replay_lcm_udp:source_port(Lcm)) of
        true ->
            Lcm;
        false ->
            Found = neighbour_with(Fits, Url),
            ok = replay_lcm_udp:close(Lcm),
            Found
    end.

ended(Player) ->
    Monitor = monitor(process, Player),
    receive
        {'DOWN', Monitor, process, Player, Reason} -> Reason
    after ?PATIENCE -> error(goes_on)
    end.

with_unsure(Us, Test) ->
    Url = url(),
    {ok, Player} = replay_player_server:start((options(Url))#{unsure_us => Us}),
    Listener = neighbour(Url),
    {Port, Heard} = teller(Listener),
    try Test(#{url => Url, player => Player, port => Port, listener => Heard})
    after
        replay_lcm_udp:close(Listener),
        is_process_alive(Player) andalso replay_player_server:stop(Player)
    end.

the_higher_port_gives_way_test() ->
    with_unsure(?ALWAYS, fun(#{url := Url, player := Player, port := Port, listener := Listener}) ->
        Higher = neighbour_with(fun(P) -> P > Port end, Url),
        ok = tell(Higher),
        HigherPort = replay_lcm_udp:source_port(Higher),
        %% two of its own after that: its own do not make it give way either
        _ = told([HigherPort, Port, Port], Listener),
        Lower = neighbour_with(fun(P) -> P < Port end, Url),
        ok = tell(Lower),
        {shutdown, {another, "another player sends to 239.255.76.67:" ++ _}} = ended(Player),
        [ok = replay_lcm_udp:close(L) || L <- [Higher, Lower]]
    end).

one_that_plays_for_long_does_not_give_way_test() ->
    with_unsure(0, fun(#{url := Url, player := Player, port := Port, listener := Listener}) ->
        Lower = neighbour_with(fun(P) -> P < Port end, Url),
        ok = tell(Lower),
        _ = told([replay_lcm_udp:source_port(Lower), Port, Port], Listener),
        ?assert(is_process_alive(Player)),
        ok = replay_lcm_udp:close(Lower)
    end).

%% Neither has listened before.
of_two_that_begin_together_one_remains_test() ->
    Url = url(),
    Listener = neighbour(Url),
    Begin = fun() -> replay_player_server:start((options(Url))#{unsure_us => ?ALWAYS}) end,
    case [Begin(), Begin()] of
        [{ok, First}, {error, {another, _}}] ->
            ok = replay_player_server:stop(First);
        [{ok, A}, {ok, B}] ->
            [MonitorA, MonitorB] = [monitor(process, P) || P <- [A, B]],
            Rest =
                receive
                    {'DOWN', MonitorA, process, A, {shutdown, {another, _}}} -> B;
                    {'DOWN', MonitorB, process, B, {shutdown, {another, _}}} -> A
                after ?PATIENCE -> error(both_go_on)
                end,
            Left = neighbour(Url),
            {Port, Next} = teller(Left),
            _ = told([Port, Port, Port, Port, Port], Next),
            ?assert(is_process_alive(Rest)),
            ok = replay_lcm_udp:close(Left),
            ok = replay_player_server:stop(Rest)
    end,
    ok = replay_lcm_udp:close(Listener).

%% Whatever its port: it was there when the other had sent nothing yet.
one_that_is_heard_before_the_beginning_was_first_test() ->
    Url = url(),
    Other = neighbour(Url),
    Happens = fun() ->
        ok = tell(Other),
        receive
            {udp, _, _, _, _} = Info -> self() ! Info
        after ?PATIENCE -> error(nothing_came)
        end
    end,
    ?assertMatch({error, {another, "another player sends to " ++ _}},
                 replay_player_server:start(options(Url, {after_that, Happens, moving()}))),
    ok = replay_lcm_udp:close(Other).

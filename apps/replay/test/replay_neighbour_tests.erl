%% Two players on one group, over real multicast on the loopback interface.
-module(replay_neighbour_tests).
-include_lib("eunit/include/eunit.hrl").

url() ->
    {ok, Probe} = gen_udp:open(0, [{ip, {127, 0, 0, 1}}]),
    {ok, Port} = inet:port(Probe),
    ok = gen_udp:close(Probe),
    lists:concat(["udpm://239.255.76.67:", Port, "?ttl=0"]).

player(Url) ->
    {ok, Player} = replay_player_server:start(#{
        player => #{
            opening => {view, {moving, 60000000, passed, passed}}, number => 1,
            view => replay_test_source, token => none, cases => "", scenarios => "",
            %% a paused one is heard as well
            playing => false, speed => 1.0
        },
        url => Url, udp => #{}, say => fun(_) -> ok end
    }),
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

%% Real sockets on the loopback interface; a port of its own for each test.
-module(replay_lcm_udp_tests).
-include_lib("eunit/include/eunit.hrl").

-define(TIMEOUT_MS, 5000).

%% A port that was free a moment ago.
free_port() ->
    {ok, Socket} = gen_udp:open(0, [{ip, {127, 0, 0, 1}}]),
    {ok, Port} = inet:port(Socket),
    ok = gen_udp:close(Socket),
    Port.

multicast() -> lists:concat(["udpm://239.255.76.67:", free_port(), "?ttl=0"]).
unicast() -> lists:concat(["127.0.0.1:", free_port()]).

%% The next message or bad packet; the state has taken note of what came before.
next(Lcm) ->
    receive
        Info ->
            case replay_lcm_udp:incoming(Info, Lcm) of
                {message, Channel, Payload, From, Next} -> {Channel, Payload, From, Next};
                {bad, Line, From, Next} -> {bad, Line, From, Next};
                {none, Next} -> next(Next)
            end
    after ?TIMEOUT_MS -> error(nothing_received)
    end.

messages_go_to_everyone_who_listens_test() ->
    Url = multicast(),
    {ok, A} = replay_lcm_udp:open(Url, #{}),
    {ok, Sender} = replay_lcm_udp:open(Url, #{listen => false}),
    Parent = self(),
    {Other, Monitor} = spawn_monitor(fun() ->
        {ok, B} = replay_lcm_udp:open(Url, #{}),
        Parent ! listening,
        {Channel, Payload, _, _} = next(B),
        exit({heard, Channel, Payload})
    end),
    receive listening -> ok after ?TIMEOUT_MS -> error(timeout) end,
    ok = replay_lcm_udp:publish(Sender, <<"C">>, <<"payload">>),
    {<<"C">>, <<"payload">>, {{127, 0, 0, 1}, _}, _} = next(A),
    receive
        {'DOWN', Monitor, process, Other, Reason} ->
            ?assertEqual({heard, <<"C">>, <<"payload">>}, Reason)
    after ?TIMEOUT_MS -> error(timeout)
    end,
    ok = replay_lcm_udp:close(A),
    ok = replay_lcm_udp:close(Sender).

many_and_large_messages_arrive_in_order_test() ->
    {ok, Lcm} = replay_lcm_udp:open(multicast(), #{}),
    Sizes = [1, 70000, 2, 200000, 3 | lists:duplicate(400, 10)],
    lists:foldl(
        fun(Size, L0) ->
            Payload = binary:copy(<<Size:8>>, Size),
            ok = replay_lcm_udp:publish(L0, <<"C">>, Payload),
            {<<"C">>, Payload, _, L} = next(L0),
            L
        end,
        Lcm,
        Sizes
    ),
    ok = replay_lcm_udp:close(Lcm).

a_listener_by_unicast_answers_the_latest_sender_test() ->
    Url = unicast(),
    {ok, L0} = replay_lcm_udp:open(Url, #{role => listener}),
    {ok, P0} = replay_lcm_udp:open(Url, #{role => publisher}),
    ok = replay_lcm_udp:publish(L0, <<"A">>, <<"to nobody">>),
    ok = replay_lcm_udp:publish(P0, <<"B">>, <<"hello">>),
    {<<"B">>, <<"hello">>, _, L1} = next_of(L0, P0),
    ok = replay_lcm_udp:publish(L1, <<"C">>, <<"answer">>),
    {<<"C">>, <<"answer">>, _, _} = next_of(P0, L1),
    ok = replay_lcm_udp:close(L1),
    ok = replay_lcm_udp:close(P0).

%% This process owns both.
next_of(Lcm, Other) ->
    receive
        Info ->
            case replay_lcm_udp:incoming(Info, Lcm) of
                {message, Channel, Payload, From, Next} -> {Channel, Payload, From, Next};
                unknown -> {none, _} = replay_lcm_udp:incoming(Info, Other), next_of(Lcm, Other)
            end
    after ?TIMEOUT_MS -> error(nothing_received)
    end.

what_is_no_packet_of_lcm_is_told_test() ->
    Url = unicast(),
    {ok, Lcm} = replay_lcm_udp:open(Url, #{role => listener}),
    {ok, #{port := Port}} = replay_lcm_url:parse(Url, false),
    {ok, Socket} = gen_udp:open(0, [{ip, {127, 0, 0, 1}}]),
    ok = gen_udp:send(Socket, {127, 0, 0, 1}, Port, <<"rubbish">>),
    {bad, "no LCM packet: 7 bytes", {{127, 0, 0, 1}, _}, _} = next(Lcm),
    ok = gen_udp:close(Socket),
    ok = replay_lcm_udp:close(Lcm).

foreign_senders_and_messages_are_not_heard_test() ->
    {ok, Lcm} = replay_lcm_udp:open(unicast(), #{role => listener}),
    ?assertEqual(unknown, replay_lcm_udp:incoming({some, message}, Lcm)),
    ok = replay_lcm_udp:close(Lcm).

a_port_in_use_is_one_line_test() ->
    Url = unicast(),
    {ok, Lcm} = replay_lcm_udp:open(Url, #{role => listener}),
    {error, Line} = replay_lcm_udp:open(Url, #{role => listener}),
    ?assertNotEqual(nomatch, string:find(Line, "is in use by another program")),
    ok = replay_lcm_udp:close(Lcm).

the_network_must_be_allowed_test() ->
    ?assertMatch({error, _}, replay_lcm_udp:open("udpm://239.255.76.67:7667?ttl=1", #{})).

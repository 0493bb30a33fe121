-module(replay_lcm_url_tests).
-include_lib("eunit/include/eunit.hrl").

the_default_stays_on_this_host_test() ->
    ?assertEqual({ok, #{kind => multicast, address => {239, 255, 76, 67}, port => 7667, ttl => 0,
                        recv_buf_size => 2097152}},
                 replay_lcm_url:parse(replay_lcm_url:default(), false)).

what_is_left_out_is_as_in_lcm_test() ->
    {ok, Short} = replay_lcm_url:parse("udpm://", false),
    ?assertEqual(replay_lcm_url:parse("udpm://239.255.76.67:7667?ttl=0", false), {ok, Short}).

one_receiver_by_unicast_test() ->
    ?assertMatch({ok, #{kind := unicast, address := {127, 0, 0, 1}, port := 7668}},
                 replay_lcm_url:parse("127.0.0.1:7668", false)).

the_network_must_be_allowed_test() ->
    ?assertEqual({error, "udpm://239.255.76.67:7667?ttl=1: ttl=1 lets packets leave this host; "
                         "use ttl=0 (--allow-network allows it)"},
                 replay_lcm_url:parse("udpm://239.255.76.67:7667?ttl=1", false)),
    ?assertMatch({ok, #{ttl := 1}}, replay_lcm_url:parse("udpm://239.255.76.67:7667?ttl=1", true)),
    ?assertEqual({error, "10.0.0.1:7667: not of this host; --allow-network allows it"},
                 replay_lcm_url:parse("10.0.0.1:7667", false)),
    ?assertMatch({ok, #{kind := unicast}}, replay_lcm_url:parse("10.0.0.1:7667", true)).

what_is_wrong_is_one_line_test_() ->
    [?_assertEqual({error, Url ++ ": " ++ Line}, replay_lcm_url:parse(Url, false))
     || {Url, Line} <- [
            {"tcpq://127.0.0.1:7700", "expected udpm://GROUP:PORT?ttl=0 or 127.0.0.1:PORT"},
            {"udpm://127.0.0.1:7667",
             "127.0.0.1 is no multicast address (224.0.0.0 to 239.255.255.255)"},
            {"udpm://239.255.76.67", "expected ADDRESS:PORT"},
            {"udpm://239.255.76:7667", "`239.255.76' is no IPv4 address"},
            {"udpm://239.255.76.67:0", "port must be 1 to 65535, not `0'"},
            {"udpm://239.255.76.67:7667?ttl=x", "ttl must be 0 to 255, not `x'"},
            {"udpm://239.255.76.67:7667?ttl=256", "ttl must be 0 to 255, not `256'"},
            {"udpm://239.255.76.67:7667?recv_buf_size=0",
             "recv_buf_size must be 1 to 1073741824, not `0'"},
            {"udpm://239.255.76.67:7667?x=1",
             "unknown option `x=1'; there are ttl and recv_buf_size"},
            {"", "expected ADDRESS:PORT"}
        ]].

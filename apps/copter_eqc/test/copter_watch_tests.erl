%% Tests that are shown while they run: heard over UDP, and the same as those that are not.
-module(copter_watch_tests).
-include_lib("eunit/include/eunit.hrl").

-define(PATIENCE, 20000).

-export([few/0]).

few() ->
    Changes = #{max_copters => 2, max_faults => 0, configuration => hardened},
    copter_eqc:safe(copter_options:new(Changes)).

run(Watch) ->
    Job = #{
        module => ?MODULE, function => few, task => run, seed => 4711,
        proper => [{numtests, 2}, quiet], watch => Watch
    },
    Result = faultcheck_property:run(Job, counters:new(1, []), fun(_) -> ok end),
    maps:remove(ms, Result).

watched_tests_are_heard_and_come_to_the_same_test_() ->
    {timeout, 60, fun() ->
        {ok, Probe} = gen_udp:open(0, [{ip, {127, 0, 0, 1}}]),
        {ok, Port} = inet:port(Probe),
        ok = gen_udp:close(Probe),
        Url = lists:concat(["127.0.0.1:", Port]),
        {ok, Lcm} = replay_lcm_udp:open(Url, #{role => listener}),
        true = os:putenv("LCM_DEFAULT_URL", Url),
        Unwatched = run(false),
        Self = self(),
        {_, Monitor} = spawn_monitor(fun() -> Self ! {result, run(true)} end),
        Heard = heard(Lcm, []),
        Watched = receive {result, Result} -> Result after ?PATIENCE -> error(no_result) end,
        receive {'DOWN', Monitor, _, _, _} -> ok end,
        true = os:unsetenv("LCM_DEFAULT_URL"),
        replay_lcm_udp:close(Lcm),
        application:unset_env(faultcheck, watch),
        ?assertMatch(#{status := passed}, Unwatched),
        ?assertEqual(Unwatched, Watched),
        ?assertEqual([<<"test 1">>, <<"test 2">>],
                     lists:usort([Id || {case_info, #{case_id := Id}} <- Heard])),
        %% what they are, and how to repeat them
        ?assertEqual(
            [{<<"copter_watch_tests:few">>, <<"4711, test ", N>>} || N <- "12"],
            lists:usort([{P, S} || {case_info, #{property := P, seed := S}} <- Heard])
        ),
        Runs = lists:usort([R || {frame, #{run := R}} <- Heard]),
        ?assertMatch([_, _], Runs),
        %% each up to its verdict
        ?assertEqual(Runs, lists:usort([R || {status, #{run := R, verdict := 1}} <- Heard]))
    end}.

%% What another player shows is not mixed with tests.
beside_another_player_tests_are_not_shown_test_() ->
    {timeout, 60, fun() ->
        {ok, Probe} = gen_udp:open(0, [{ip, {127, 0, 0, 1}}]),
        {ok, Port} = inet:port(Probe),
        ok = gen_udp:close(Probe),
        Url = lists:concat(["udpm://239.255.76.67:", Port, "?ttl=0"]),
        {ok, Player} = replay_player_server:start(#{
            player => #{
                opening => {view, live}, number => 1, view => copter_view, token => none,
                cases => "", scenarios => "", playing => false, speed => 1.0
            },
            url => Url, udp => #{}, say => fun(_) -> ok end
        }),
        true = os:putenv("LCM_DEFAULT_URL", Url),
        {ok, Lcm} = replay_lcm_udp:open(Url, #{}),
        Self = self(),
        {_, Monitor} = spawn_monitor(fun() -> Self ! {result, run(true)} end),
        Watched = receive {result, Result} -> Result after ?PATIENCE -> error(no_result) end,
        receive {'DOWN', Monitor, _, _, _} -> ok end,
        true = os:unsetenv("LCM_DEFAULT_URL"),
        ok = replay_player_server:stop(Player),
        %% what has come up to the end of the tests
        ok = replay_lcm_udp:publish(Lcm, <<"END">>, <<>>),
        Runs = runs_until_end(Lcm, []),
        ok = replay_lcm_udp:close(Lcm),
        application:unset_env(faultcheck, watch),
        ?assertMatch(#{status := passed}, Watched),
        ?assertEqual([1], lists:usort(Runs))
    end}.

runs_until_end(Lcm, Runs) ->
    receive
        Info when element(1, Info) =:= udp; element(1, Info) =:= udp_passive ->
            case replay_lcm_udp:incoming(Info, Lcm) of
                {message, <<"END">>, _, _, _} ->
                    Runs;
                {message, <<"VIZ_STATUS">>, Payload, _, Next} ->
                    {ok, #{run := Run}} = replay_lcm:decode(status, Payload),
                    runs_until_end(Next, [Run | Runs]);
                {message, _, _, _, Next} -> runs_until_end(Next, Runs);
                {none, Next} -> runs_until_end(Next, Runs);
                unknown -> runs_until_end(Lcm, Runs)
            end
    after ?PATIENCE -> error(no_end)
    end.

%% Until the second verdict.
heard(Lcm, Heard) ->
    case length(lists:usort([R || {status, #{run := R, verdict := 1}} <- Heard])) of
        2 -> Heard;
        _ ->
            receive
                Info when element(1, Info) =:= udp; element(1, Info) =:= udp_passive ->
                    case replay_lcm_udp:incoming(Info, Lcm) of
                        {message, _, Payload, _, Next} ->
                            {ok, Type, Message} = replay_lcm:decode(Payload),
                            heard(Next, [{Type, Message} | Heard]);
                        {none, Next} -> heard(Next, Heard);
                        unknown -> heard(Lcm, Heard)
                    end
            after ?PATIENCE -> error({not_heard, length(Heard)})
            end
    end.

%% @doc Shows sources one after the other, each once from beginning to end: what `rebar3 proper
%% --watch' is made of.
%%
%% The calling process shows, and waits as long as that takes.
-module(replay_broadcast).

-export([open/1, show/3]).
-export_type([broadcast/0]).

-record(broadcast, {lcm :: replay_lcm_udp:lcm(), number :: pos_integer()}).
-opaque broadcast() :: #broadcast{}.

-define(US_PER_MS, 1000).

%% @doc To a URL (replay_lcm_url). The error is one line.
-spec open(string()) -> {ok, broadcast()} | {error, string()}.
open(Url) ->
    case replay_lcm_udp:open(Url, #{listen => false}) of
        {ok, Lcm} -> {ok, #broadcast{lcm = Lcm, number = replay_player:first_number()}};
        {error, _} = Error -> Error
    end.

%% @doc Shows what a module opens; so many simulated seconds a second, 20 at most.
-spec show({module(), replay_source:what()}, Speed :: number(), broadcast()) ->
    {ok, broadcast()} | {error, string()}.
show({View, What}, Speed, #broadcast{number = Number} = Broadcast) ->
    Options = #{
        opening => {view, What}, number => Number, view => View, token => none, cases => "",
        scenarios => "", playing => true, speed => float(Speed)
    },
    case replay_player:open(Options, now_us()) of
        {ok, Out, Player} ->
            ok = publish(Out, Broadcast),
            ok = to_the_end(Player, Broadcast),
            {ok, Broadcast#broadcast{number = Number + 1}};
        {error, _} = Error ->
            Error
    end.

to_the_end(Player, Broadcast) ->
    Wait = max(0, replay_player:next_wake(Player) - now_us()),
    receive
    after (Wait + ?US_PER_MS - 1) div ?US_PER_MS -> ok
    end,
    {Out, Next} = replay_player:wake(now_us(), Player),
    ok = publish(Out, Broadcast),
    case replay_player:has_ended(Next) of
        true -> ok;
        false -> to_the_end(Next, Broadcast)
    end.

now_us() -> erlang:monotonic_time(microsecond).

%% Who cannot be reached sees nothing; the tests go on.
publish(Out, #broadcast{lcm = Lcm}) ->
    lists:foreach(
        fun({publish, {Type, Message}}) ->
            Bytes = replay_lcm:encode(Type, Message),
            replay_lcm_udp:publish(Lcm, replay_lcm:channel(Type), Bytes)
        end,
        Out
    ).

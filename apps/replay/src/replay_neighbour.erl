%% @doc Whether somebody else plays on a group already: pages would show both, mixed.
%%
%% Whoever plays tells VIZ_STATUS five times a second, also when paused, so a short while of
%% listening is enough. One that was killed tells nothing any more.
-module(replay_neighbour).

-export([find/2]).

-define(LISTEN_MS, 600).

%% @doc Listens for another player; the line says that there is one. By unicast nobody else can be
%% heard, and where nothing can be opened the one who plays will say why: none.
-spec find(string(), replay_lcm_udp:options()) -> none | {found, replay_lcm:line()}.
find(Url, Options) ->
    Allow = maps:get(allow_network, Options, false),
    case replay_lcm_url:parse(Url, Allow) of
        {ok, #{kind := multicast} = Address} -> listening(Url, Options, Address);
        _ -> none
    end.

%% By a process of its own: packets that come late go with it.
listening(Url, Options, Address) ->
    Caller = self(),
    {Pid, Monitor} =
        spawn_monitor(fun() -> Caller ! {?MODULE, self(), heard(Url, Options)} end),
    receive
        {'DOWN', Monitor, process, Pid, _} -> found(Pid, Address)
    end.

%% What the process has told, if it came to that, was there before its end.
found(Pid, Address) ->
    receive
        {?MODULE, Pid, true} -> {found, line(Address)};
        {?MODULE, Pid, false} -> none
    after 0 -> none
    end.

heard(Url, Options) ->
    case replay_lcm_udp:open(Url, Options#{listen => true}) of
        {ok, Lcm} ->
            Timer = erlang:start_timer(?LISTEN_MS, self(), enough),
            until(Timer, Lcm);
        {error, _} ->
            false
    end.

until(Timer, Lcm) ->
    receive
        {timeout, Timer, enough} ->
            false;
        Info ->
            case replay_lcm_udp:incoming(Info, Lcm) of
                {message, <<"VIZ_STATUS">>, _, _, _} -> true;
                {message, _, _, _, Next} -> until(Timer, Next);
                {bad, _, _, Next} -> until(Timer, Next);
                {none, Next} -> until(Timer, Next);
                unknown -> until(Timer, Lcm)
            end
    end.

line(#{address := Ip, port := Port}) ->
    lists:flatten(
        io_lib:format("another player sends to ~ts:~b already; end it, or use another group",
                      [inet:ntoa(Ip), Port])
    ).

%% @doc Whether somebody else plays on a group already: pages would show both, mixed.
%%
%% Whoever plays tells VIZ_STATUS five times a second, also when paused, so a short while of
%% listening is enough. One that was killed tells nothing any more.
%%
%% Two that were started together have both heard nothing. So each listens on for a second after it
%% has begun to send, and of the two the one that sends from the higher port gives way. One that was
%% heard before the first message was sent was there first.
-module(replay_neighbour).

-export([find/2, is_heard/1, gives_way/3, line/1]).

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
        {?MODULE, Pid, true} -> {found, line_of(Address)};
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

%% @doc Whether somebody plays there, by what has come in so far. For whoever sends nothing yet.
-spec is_heard(replay_lcm_udp:lcm()) -> {boolean(), replay_lcm_udp:lcm()}.
is_heard(Lcm) ->
    receive
        Info when element(1, Info) =:= udp; element(1, Info) =:= udp_passive ->
            case replay_lcm_udp:incoming(Info, Lcm) of
                {message, <<"VIZ_STATUS">>, _, _, Next} -> {true, Next};
                {message, _, _, _, Next} -> is_heard(Next);
                {bad, _, _, Next} -> is_heard(Next);
                {none, Next} -> is_heard(Next);
                unknown -> is_heard(Lcm)
            end
    after 0 ->
        {false, Lcm}
    end.

%% @doc Whether one that plays gives way to whoever told a status; the line says to whom.
-spec gives_way(replay_lcm_udp:from(), replay_lcm_udp:lcm(), string()) ->
    false | {true, replay_lcm:line()}.
gives_way({_, Port}, Lcm, Url) ->
    case Port < replay_lcm_udp:source_port(Lcm) of
        true -> {true, line(Url)};
        false -> false
    end.

%% @doc What is said then.
-spec line(string()) -> replay_lcm:line().
line(Url) ->
    {ok, Address} = replay_lcm_url:parse(Url, true),
    line_of(Address).

line_of(#{address := Ip, port := Port}) ->
    lists:flatten(
        io_lib:format("another player sends to ~ts:~b already; end it, or use another group",
                      [inet:ntoa(Ip), Port])
    ).

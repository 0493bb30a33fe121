%% @doc LCM messages over UDP, without liblcm and without leaving this host.
%%
%% The loopback interface is named at every socket, so that no route is needed. The process that
%% opens it owns it: it gets the packets as Erlang messages and hands each one to incoming/2.
%% ```
%% {ok, Lcm} = replay_lcm_udp:open("udpm://239.255.76.67:7667?ttl=0", #{}),
%% ok = replay_lcm_udp:publish(Lcm, <<"VIZ_STATUS">>, replay_lcm:encode(status, Status)),
%% receive Info ->
%%     case replay_lcm_udp:incoming(Info, Lcm) of
%%         {message, Channel, Payload, From, Lcm1} -> ...;
%%         {bad, Line, From, Lcm1} -> ...;   % one packet that is none of LCM's
%%         {none, Lcm1} -> ...;              % a fragment, or a foreign sender
%%         unknown -> ...                    % not of this socket
%%     end
%% end.
%% '''
%% By unicast (`127.0.0.1:7667') a `publisher' sends to that address and hears the answers to its
%% own port; a `listener' has that address and answers whoever it heard last.
-module(replay_lcm_udp).

-export([open/2, publish/3, incoming/2, source_port/1, close/1]).
-export_type([lcm/0, options/0, from/0]).

-type options() :: #{
    %% packets may leave the host; false
    allow_network => boolean(),
    %% hear messages, not only publish; true
    listen => boolean(),
    %% by unicast; publisher
    role => publisher | listener
}.
-type from() :: {inet:ip4_address(), inet:port_number()}.
-record(lcm, {
    sender :: gen_udp:socket(),
    %% may be the sender itself
    receiver :: gen_udp:socket() | none,
    to :: from() | nobody,
    %% to is the latest sender
    answers :: boolean(),
    %% hear any sender
    any_sender :: boolean(),
    sequence :: atomics:atomics_ref(),
    reassembly :: replay_lcm_packet:reassembly()
}).
-opaque lcm() :: #lcm{}.

-define(LOOPBACK, {127, 0, 0, 1}).
%% Packets until the socket waits for incoming/2.
-define(BURST, 200).
%% Linux: IPPROTO_IP, IP_MULTICAST_ALL
-define(ONLY_OWN_GROUPS, {raw, 0, 49, <<0:32/native>>}).

%% @doc Opens the sockets for a URL (see replay_lcm_url).
-spec open(string(), options()) -> {ok, lcm()} | {error, replay_lcm:line()}.
open(Url, Options) ->
    AllowNetwork = maps:get(allow_network, Options, false),
    case replay_lcm_url:parse(Url, AllowNetwork) of
        {ok, Address} ->
            case sockets(Address, Options) of
                {ok, Sender, Receiver, To} ->
                    {ok, #lcm{
                        sender = Sender,
                        receiver = Receiver,
                        to = To,
                        answers = To =:= nobody,
                        any_sender = AllowNetwork orelse maps:get(kind, Address) =:= multicast,
                        sequence = atomics:new(1, [{signed, false}]),
                        reassembly = replay_lcm_packet:new()
                    }};
                {error, Reason} ->
                    {error, failed(Url, Address, Reason)}
            end;
        {error, _} = Error ->
            Error
    end.

sockets(#{kind := multicast, address := Group, port := Port, ttl := Ttl} = Address, Options) ->
    Interface = case Ttl of 0 -> [{multicast_if, ?LOOPBACK}]; _ -> [] end,
    Sending = [binary, {active, false}, {multicast_ttl, Ttl}, {multicast_loop, true},
               {sndbuf, 1 bsl 20} | Interface],
    case gen_udp:open(0, Sending) of
        {ok, Sender} ->
            case maps:get(listen, Options, true) andalso join(Address) of
                false -> {ok, Sender, none, {Group, Port}};
                {ok, Receiver} -> {ok, Sender, Receiver, {Group, Port}};
                {error, _} = Error -> gen_udp:close(Sender), Error
            end;
        {error, _} = Error ->
            Error
    end;
sockets(#{kind := unicast, address := Ip, port := Port} = Address, Options) ->
    {At, To} = case maps:get(role, Options, publisher) of
        publisher -> {{source(Ip), 0}, {Ip, Port}};
        listener -> {{Ip, Port}, nobody}
    end,
    case receiving(At, Address, []) of
        {ok, Socket} -> {ok, Socket, Socket, To};
        {error, _} = Error -> Error
    end.

source(Ip) when element(1, Ip) =:= 127 -> ?LOOPBACK;
source(_) -> {0, 0, 0, 0}.

%% Bound to the group, so that unicast to the port does not come in.
join(#{address := Group, port := Port, ttl := Ttl} = Address) ->
    Interface = case Ttl of 0 -> ?LOOPBACK; _ -> {0, 0, 0, 0} end,
    receiving({Group, Port}, Address, [{add_membership, {Group, Interface}}]).

receiving({Ip, Port}, #{kind := Kind, recv_buf_size := Size}, Options) ->
    Shared = case Kind of
        multicast -> [{reuseaddr, true}, ?ONLY_OWN_GROUPS];
        unicast -> []
    end,
    gen_udp:open(Port, [binary, {ip, Ip}, {active, ?BURST}, {recbuf, Size}, {buffer, 65536}]
                       ++ Shared ++ Options).

failed(Url, #{port := Port}, eaddrinuse) ->
    say("~ts: port ~b is in use by another program; stop it or choose another port", [Url, Port]);
failed(Url, #{address := Ip}, Reason) when Reason =:= enodev; Reason =:= enetunreach;
                                           Reason =:= eaddrnotavail ->
    say("~ts: ~ts; is the loopback interface up? (ip link set lo up; "
        "ip route replace ~ts/32 dev lo src 127.0.0.1)",
         [Url, inet:format_error(Reason), inet:ntoa(Ip)]);
failed(Url, _, Reason) ->
    say("~ts: ~ts", [Url, inet:format_error(Reason)]).

%% @doc Sends one message to everyone who listens. By any process.
-spec publish(lcm(), Channel :: binary(), Payload :: binary()) ->
    ok | {error, replay_lcm:line()}.
publish(#lcm{to = nobody}, _Channel, _Payload) ->
    ok;
publish(#lcm{sender = Socket, to = {Ip, Port} = To, sequence = Sequence}, Channel, Payload) ->
    Next = atomics:add_get(Sequence, 1, 1) - 1,
    case replay_lcm_packet:packets(Next band 16#ffffffff, Channel, Payload) of
        {ok, Packets} -> send(Socket, To, Packets, say("~ts:~b", [inet:ntoa(Ip), Port]));
        {error, _} = Error -> Error
    end.

send(_Socket, _To, [], _Where) ->
    ok;
send(Socket, {Ip, Port} = To, [Packet | Rest], Where) ->
    case gen_udp:send(Socket, Ip, Port, Packet) of
        ok -> send(Socket, To, Rest, Where);
        {error, Reason} -> {error, say("~ts: ~ts", [Where, inet:format_error(Reason)])}
    end.

%% @doc What an Erlang message of this process means; see above. By unicast, senders that are not of
%% this host are not heard unless the network is allowed. By multicast only the loopback interface
%% is heard; there a sender of this host may have any of its addresses: programs of liblcm have that
%% of another interface.
-spec incoming(term(), lcm()) ->
    {message, Channel :: binary(), Payload :: binary(), from(), lcm()}
    | {bad, replay_lcm:line(), from(), lcm()}
    | {none, lcm()}
    | unknown.
incoming({udp, Socket, Ip, Port, Packet}, #lcm{receiver = Socket, any_sender = Any} = Lcm) when
    element(1, Ip) =:= 127; Any
->
    From = {Ip, Port},
    {Result, Reassembly} =
        replay_lcm_packet:receive_packet(From, Packet, Lcm#lcm.reassembly),
    Heard = heard(From, Lcm#lcm{reassembly = Reassembly}),
    case Result of
        {message, Channel, Payload} -> {message, Channel, Payload, From, Heard};
        {error, Line} -> {bad, Line, From, Heard};
        more -> {none, Heard}
    end;
incoming({udp, Socket, _, _, _}, #lcm{receiver = Socket} = Lcm) ->
    {none, Lcm};
incoming({udp_passive, Socket}, #lcm{receiver = Socket} = Lcm) ->
    ok = inet:setopts(Socket, [{active, ?BURST}]),
    {none, Lcm};
%% The other side of a unicast address has gone: the next one may come.
incoming({udp_error, Socket, _Reason}, #lcm{receiver = Socket} = Lcm) ->
    {none, Lcm};
incoming(_, _) ->
    unknown.

%% A listener by unicast answers the latest sender.
heard(From, #lcm{answers = true} = Lcm) -> Lcm#lcm{to = From};
heard(_From, Lcm) -> Lcm.

%% @doc The port that messages are sent from: by it others know one sender from another.
-spec source_port(lcm()) -> inet:port_number().
source_port(#lcm{sender = Socket}) ->
    {ok, Port} = inet:port(Socket),
    Port.

%% @doc Closes the sockets.
-spec close(lcm()) -> ok.
close(#lcm{sender = Sender, receiver = Receiver}) ->
    gen_udp:close(Sender),
    case Receiver of
        none -> ok;
        _ -> gen_udp:close(Receiver)
    end.

say(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

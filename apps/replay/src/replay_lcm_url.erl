%% @doc Where messages go: LCM's URLs, and plain addresses for one receiver on this host.
%%
%% `udpm://239.255.76.67:7667?ttl=0' is LCM's multicast, which this project keeps on the loopback
%% interface; `127.0.0.1:7667' is unicast, which standard LCM tools do not see.
-module(replay_lcm_url).

-export([default/0, parse/2]).
-export_type([address/0]).

-type address() :: #{
    kind := multicast | unicast,
    address := inet:ip4_address(),
    port := inet:port_number(),
    ttl := 0..255,
    %% bytes asked of the kernel for received packets
    recv_buf_size := pos_integer()
}.

-define(RECV_BUF_SIZE, 2097152).
-define(BUFFER_MAX, (1 bsl 30)).

%% @doc LCM's own group and port, on this host.
-spec default() -> string().
default() -> "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=2097152".

%% @doc Reads a URL. What could leave the host is refused unless the network is allowed.
-spec parse(string(), AllowNetwork :: boolean()) -> {ok, address()} | {error, replay_lcm:line()}.
parse(Url, AllowNetwork) ->
    try
        {ok, allowed(address(Url), AllowNetwork)}
    catch
        throw:{bad_url, Line} -> {error, say("~ts: ~ts", [Url, Line])}
    end.

address("udpm://" ++ Rest) ->
    {Place, Options} = case string:split(Rest, "?") of
        [P, O] -> {P, string:lexemes(O, "&")};
        [P] -> {P, []}
    end,
    {Ip, Port} = place(Place, {{239, 255, 76, 67}, 7667}),
    element(1, Ip) >= 224 andalso element(1, Ip) =< 239 orelse
        bad("~ts is no multicast address (224.0.0.0 to 239.255.255.255)", [inet:ntoa(Ip)]),
    lists:foldl(fun option/2, new(multicast, Ip, Port), Options);
address(Place) ->
    case string:find(Place, "://") of
        nomatch ->
            {Ip, Port} = place(Place, none),
            new(unicast, Ip, Port);
        _ ->
            bad("expected udpm://GROUP:PORT?ttl=0 or 127.0.0.1:PORT", [])
    end.

new(Kind, Ip, Port) ->
    #{kind => Kind, address => Ip, port => Port, ttl => 0, recv_buf_size => ?RECV_BUF_SIZE}.

place("", Default) when Default =/= none ->
    Default;
place(Place, _) ->
    case string:split(Place, ":") of
        [Host, Port] -> {host(Host), number(Port, "port", 1, 65535)};
        _ -> bad("expected ADDRESS:PORT", [])
    end.

host(Host) ->
    case inet:parse_ipv4strict_address(Host) of
        {ok, Ip} -> Ip;
        {error, _} -> bad("`~ts' is no IPv4 address", [Host])
    end.

option(Option, Address) ->
    case string:split(Option, "=") of
        ["ttl", N] -> Address#{ttl := number(N, "ttl", 0, 255)};
        ["recv_buf_size", N] ->
            Address#{recv_buf_size := number(N, "recv_buf_size", 1, ?BUFFER_MAX)};
        _ -> bad("unknown option `~ts'; there are ttl and recv_buf_size", [Option])
    end.

number(Text, What, Min, Max) ->
    case string:to_integer(Text) of
        {N, ""} when is_integer(N), N >= Min, N =< Max -> N;
        _ -> bad("~ts must be ~b to ~b, not `~ts'", [What, Min, Max, Text])
    end.

allowed(#{kind := unicast, address := Ip}, false) when element(1, Ip) =/= 127 ->
    bad("not of this host; --allow-network allows it", []);
allowed(#{ttl := Ttl}, false) when Ttl > 0 ->
    bad("ttl=~b lets packets leave this host; use ttl=0 (--allow-network allows it)", [Ttl]);
allowed(Address, _) ->
    Address.

-spec bad(string(), [term()]) -> no_return().
bad(Format, Args) -> throw({bad_url, say(Format, Args)}).

say(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

%% @doc For tests: liblcm and the code of lcm-gen as a program (lcm_peer), and what they have made
%% (test/data/viz_*).
-module(replay_lcm_peer).

-export([root/0, program/1, data/1, messages/0, packets/0, fingerprints/0]).
-export([start/0, ask/3, stop/1, made/2, value/2, bytes/1]).

%% The clone that this test runs in.
root() ->
    Lib = cb_library:find("libcoptersim.so", replay_lcm),
    filename:dirname(filename:dirname(filename:dirname(filename:dirname(filename:absname(Lib))))).

%% The path of a native program; its absence is a failure, not a skip.
program(Name) ->
    Lib = cb_library:find("libcoptersim.so", replay_lcm),
    File = filename:join([filename:dirname(filename:dirname(Lib)), "bin", Name]),
    filelib:is_regular(File) orelse
        error({replay, "no " ++ File ++ ": it needs liblcm-dev, liblcm-bin and a new build"}),
    File.

data(Name) ->
    filename:join([root(), "test", "data", Name]).

fixture() ->
    {ok, Packed} = file:read_file(data("viz_messages.json.gz")),
    {ok, Json} = faultcheck_json:decode(zlib:gunzip(Packed)),
    Json.

fingerprints() -> maps:get(<<"types">>, fixture()).
packets() -> [bytes(P) || P <- maps:get(<<"packets">>, fixture())].
messages() -> maps:get(<<"messages">>, fixture()).

bytes(Hex) ->
    << <<(binary_to_integer(Pair, 16))>> || <<Pair:2/binary>> <= Hex >>.

%% What the peer calls a value, as replay_lcm has it: keys are atoms, other texts stay binaries.
value(Type, Json) ->
    #{fields := Fields} = replay_lcm_type:struct(Type),
    maps:from_list([{Name, member(Base, maps:get(atom_to_binary(Name), Json))}
                    || {Name, Base, _} <- Fields]).

member(Base, List) when is_list(List) -> [member(Base, Item) || Item <- List];
member({struct, Type}, Json) -> value(Type, Json);
member(Base, Name) when is_binary(Name), (Base =:= float orelse Base =:= double) ->
    binary_to_existing_atom(Name);
member(Base, Number) when Base =:= float; Base =:= double -> float(Number);
member(_, Value) -> Value.

%% ---- The peer, running ----

start() ->
    open_port({spawn_executable, program("lcm_peer")},
              [{args, ["read"]}, {line, 1 bsl 20}, binary, exit_status]).

stop(Peer) ->
    true = port_close(Peer),
    ok.

%% What the peer makes of bytes: the message as it understands them, and its own bytes for it.
ask(Peer, Type, Bytes) ->
    Hex = [io_lib:format("~2.16.0b", [B]) || <<B>> <= Bytes],
    true = port_command(Peer, [atom_to_list(Type), " ", Hex, "\n"]),
    case answer(Peer, []) of
        <<"error">> ->
            error;
        Line ->
            [Json, Again] = string:split(Line, " ", trailing),
            {ok, Decoded} = faultcheck_json:decode(Json),
            {value(Type, Decoded), bytes(Again)}
    end.

answer(Peer, Before) ->
    receive
        {Peer, {data, {noeol, Part}}} -> answer(Peer, [Before, Part]);
        {Peer, {data, {eol, Part}}} -> iolist_to_binary([Before, Part]);
        {Peer, {exit_status, Status}} -> error({peer_ended, Status})
    end.

%% Messages that the peer makes up: {Type, Message, Bytes}.
made(Seed, Count) ->
    Args = ["messages", integer_to_list(Seed), integer_to_list(Count)],
    Port = open_port({spawn_executable, program("lcm_peer")},
                     [{args, Args}, binary, exit_status, use_stdio]),
    Lines = binary:split(all(Port, []), <<"\n">>, [global, trim]),
    [one(Line) || Line <- Lines].

all(Port, Before) ->
    receive
        {Port, {data, Part}} -> all(Port, [Before, Part]);
        {Port, {exit_status, 0}} -> iolist_to_binary(Before)
    end.

one(Line) ->
    {ok, #{<<"type">> := Name, <<"value">> := Value, <<"bytes">> := Hex}} =
        faultcheck_json:decode(Line),
    Type = binary_to_existing_atom(Name),
    {Type, value(Type, Value), bytes(Hex)}.

%% @doc Starts an OS process through the guard program, talks to it and tells how it ended.
%%
%% The guard passes file descriptors 3 and 4 on to the process: packets go straight between this
%% VM and the process, so whatever it prints on 1 and 2 (both end in the log file) corrupts
%% nothing. The process dies with its guard, the guard dies with this VM.
%%
%% ```
%% {ok, G} = cb_guard:start(Erl, ["-noinput", ...], #{log => "child.log"}),
%% ok = cb_guard:send(G, term_to_binary(hello)),
%% {data, Bin} = cb_guard:next_event(G, 5000),
%% ok = cb_guard:kill(G), {ended, {signal, 9}} = cb_guard:next_event(G, 5000).
%% '''
%% The process that called start/3 owns the guard and gets its messages; event/2 reads them in a
%% receive loop of one's own. In a child VM, child_channel/0 opens the other end.
-module(cb_guard).

-export([start/3, send/2, kill/1, os_pid/1, event/2, next_event/2, close/1]).
-export([child_channel/0]).
-export_type([guard/0, options/0, event/0, ending/0, reason/0]).

-opaque guard() :: #{port := port(), os_pid := pos_integer()}.
-type options() :: #{
    %% where fds 1 and 2 go; without it they are those of this VM
    log => file:filename(),
    env => [{string(), string() | false}],
    cd => file:filename()
}.
-type ending() :: {exit, 0..127} | {signal, 1..127}.
-type event() :: {data, binary()} | {ended, ending()}.
-type reason() :: {load, file:filename(), {dlerror, string()}}.

-define(SIGTERM, 15).

-spec start(file:filename(), [string()], options()) -> {ok, guard()} | {error, reason()}.
start(Exe, Args, Options) ->
    case {cb_files:program("c_bridge_guard"), os:find_executable(Exe)} of
        {{ok, _}, false} ->
            {error, {load, Exe, {dlerror, "no such program"}}};
        {{ok, Guard}, Found} ->
            open(Guard, [maps:get(log, Options, "-"), Found | Args], Options);
        {{error, _} = Error, _} ->
            Error
    end.

open(Guard, Args, Options) ->
    Settings = [
        {args, Args},
        {packet, 4},
        {env, maps:get(env, Options, [])},
        binary,
        nouse_stdio,
        exit_status
        | [{cd, Dir} || {ok, Dir} <- [maps:find(cd, Options)]]
    ],
    Port = open_port({spawn_executable, Guard}, Settings),
    case erlang:port_info(Port, os_pid) of
        {os_pid, OsPid} -> {ok, #{port => Port, os_pid => OsPid}};
        %% It has ended already; its status is in the message queue.
        undefined -> {ok, #{port => Port, os_pid => 0}}
    end.

%% @doc Sends one packet. Nothing happens if the process has ended: its end is told by an event.
-spec send(guard(), iodata()) -> ok.
send(#{port := Port}, Packet) ->
    try port_command(Port, Packet) of
        true -> ok
    catch
        error:badarg -> ok
    end.

%% @doc Ends the process and all it started; the event `{ended, _}' follows.
-spec kill(guard()) -> ok.
kill(#{os_pid := 0}) ->
    ok;
kill(#{os_pid := OsPid}) ->
    case cb_nif:kill(OsPid, ?SIGTERM) of
        ok -> ok;
        {error, esrch} -> ok
    end.

%% @doc The pid of the guard program.
-spec os_pid(guard()) -> non_neg_integer().
os_pid(#{os_pid := OsPid}) -> OsPid.

%% @doc What a message received by the owner means; `none' if it is not from this guard.
-spec event(guard(), Message :: term()) -> event() | none.
event(#{port := Port}, {Port, {data, Packet}}) -> {data, Packet};
event(#{port := Port}, {Port, {exit_status, Status}}) -> {ended, ending(Status)};
event(_Guard, _Message) -> none.

ending(Status) when Status > 128 -> {signal, Status - 128};
ending(Status) -> {exit, Status}.

-spec next_event(guard(), timeout()) -> event() | timeout.
next_event(#{port := Port} = Guard, Timeout) ->
    receive
        {Port, _} = Message -> event(Guard, Message)
    after Timeout -> timeout
    end.

%% @doc Kills what still runs and forgets what it sent. Returns when the process is gone.
-spec close(guard()) -> ok.
close(#{port := Port} = Guard) ->
    case erlang:port_info(Port) of
        undefined ->
            flush(Port);
        _ ->
            ok = kill(Guard),
            await_end(Guard)
    end.

await_end(#{port := Port} = Guard) ->
    case next_event(Guard, infinity) of
        {data, _} -> await_end(Guard);
        {ended, _} -> flush(Port)
    end.

flush(Port) ->
    receive
        {Port, _} -> flush(Port)
    after 0 -> ok
    end.

%% @doc In the process started: the port to the VM that started it. Its owner gets
%% `{Port, {data, Packet}}' and, when that VM is gone, `{Port, eof}'.
-spec child_channel() -> port().
child_channel() -> open_port({fd, 3, 4}, [{packet, 4}, binary, eof]).

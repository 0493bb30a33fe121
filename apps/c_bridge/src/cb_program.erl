%% @doc One running port program: a request, its answer, and how the program ends.
%%
%% All functions must be called by the process that called start/2: the port sends it its
%% messages. The port is not linked to it, so that the program's end is a message and no exit
%% signal; who starts a program sees to its end (cb_janitor). Answers to requests that were given
%% up are recognised by their number and dropped.
-module(cb_program).

-export([start/2, request/4, await_end/2, await_child_end/2, signal/2, kill/1, stop/2, forget/1]).
-export([os_pid/1]).
-export_type([program/0, outcome/0, ending/0, callback/0, reason/0]).

-record(program, {
    port :: port(),
    monitor :: reference(),
    os_pid :: non_neg_integer(),
    next = 1 :: pos_integer()
}).

-opaque program() :: #program{}.
-type ending() :: {exit, 0..127} | {signal, 1..127} | unknown.
-type outcome() ::
    {ok, term()}
    | {error, term()}
    | {ended, ending()}
    | {child_ended, ending()}
    | {abandoned, term()}
    | timeout.
%% What a stub asks Erlang during a call.
-type callback() :: fun((Function :: atom(), [term()]) -> {ok, term()} | {error, term()}).
-type reason() :: {load, file:filename(), {dlerror, string()} | {protocol, term()}}.

-define(PROTOCOL, 1).
-define(HELLO_MS, 30000).
-define(SIGQUIT, 3).
-define(SIGKILL, 9).

%% @doc Starts the program; the library's own output goes to the file Log.
-spec start(file:filename(), [{string(), string() | false}]) ->
    {ok, program()} | {error, reason()}.
start(Log, Env) ->
    case cb_files:program("c_bridge_port") of
        {ok, Exe} -> hello(Exe, open(Exe, Log, Env));
        {error, _} = Error -> Error
    end.

open(Exe, Log, Env) ->
    Options = [{args, [Log]}, {env, Env}, {packet, 4}, binary, exit_status, use_stdio],
    Port = open_port({spawn_executable, Exe}, Options),
    true = unlink(Port),
    Monitor = monitor(port, Port),
    case erlang:port_info(Port, os_pid) of
        {os_pid, OsPid} -> #program{port = Port, monitor = Monitor, os_pid = OsPid};
        undefined -> #program{port = Port, monitor = Monitor, os_pid = 0}
    end.

hello(Exe, Program) ->
    case request(Program, hello, ?HELLO_MS, fun no_callback/2) of
        {{ok, #{protocol := ?PROTOCOL}}, Ready} ->
            {ok, Ready};
        {Other, Failed} ->
            ok = kill(Failed),
            _ = await_end(Failed, ?HELLO_MS),
            {error, {load, Exe, {protocol, Other}}}
    end.

no_callback(Function, _Args) -> {error, {unexpected_callback, Function}}.

-spec os_pid(program()) -> non_neg_integer().
os_pid(#program{os_pid = OsPid}) -> OsPid.

%% @doc Sends a request and waits for its answer, or for the end of who should give it.
-spec request(program(), term(), timeout(), callback()) -> {outcome(), program()}.
request(#program{next = Id} = Program, Request, Timeout, Callback) ->
    case await_child_end(Program, 0) of
        timeout ->
            Packet = term_to_binary({Id, Request}),
            Next = Program#program{next = Id + 1},
            {send(Next, Packet, fun() -> await(Program, Id, Timeout, Callback) end), Next};
        EndedBefore ->
            {EndedBefore, Program}
    end.

send(#program{port = Port} = Program, Packet, Then) ->
    try port_command(Port, Packet) of
        true -> Then()
    catch
        error:badarg -> {ended, await_end(Program, 1000)}
    end.

await(#program{port = Port, monitor = Monitor} = Program, Id, Timeout, Callback) ->
    receive
        {Port, {data, Packet}} ->
            case binary_to_term(Packet) of
                {Id, ok, Value} -> {ok, Value};
                {Id, error, Reason} -> {error, Reason};
                {0, child, Ending} -> {child_ended, Ending};
                {0, callback, Function, Args} ->
                    answer(Program, Id, Timeout, Callback, Callback(Function, Args));
                {Stale, _, _} when Stale < Id -> await(Program, Id, Timeout, Callback)
            end;
        {Port, {exit_status, Status}} ->
            {ended, ending(Status)};
        {'DOWN', Monitor, port, Port, _} ->
            {ended, unknown}
    after Timeout -> timeout
    end.

answer(Program, Id, Timeout, Callback, {ok, Value}) ->
    Packet = term_to_binary({callback, Value}),
    send(Program, Packet, fun() -> await(Program, Id, Timeout, Callback) end);
answer(_Program, _Id, _Timeout, _Callback, {error, Reason}) ->
    {abandoned, Reason}.

ending(Status) when Status > 128 -> {signal, Status - 128};
ending(Status) -> {exit, Status}.

%% @doc Waits until the program has ended; `unknown' if that cannot be seen in time.
-spec await_end(program(), timeout()) -> ending().
await_end(#program{port = Port, monitor = Monitor} = Program, Timeout) ->
    receive
        {Port, {exit_status, Status}} -> ending(Status);
        {Port, {data, _}} -> await_end(Program, Timeout);
        {'DOWN', Monitor, port, Port, _} -> unknown
    after Timeout -> unknown
    end.

%% @doc Waits until the forked child, or with it the program, has ended.
-spec await_child_end(program(), timeout()) ->
    {child_ended, ending()} | {ended, ending()} | timeout.
await_child_end(#program{port = Port, monitor = Monitor} = Program, Timeout) ->
    receive
        {Port, {data, Packet}} ->
            case binary_to_term(Packet) of
                {0, child, Ending} -> {child_ended, Ending};
                _ -> await_child_end(Program, Timeout)
            end;
        {Port, {exit_status, Status}} ->
            {ended, ending(Status)};
        {'DOWN', Monitor, port, Port, _} ->
            {ended, unknown}
    after Timeout -> timeout
    end.

%% @doc `quit' makes a hanging program say where it hangs, `kill' ends it.
-spec signal(non_neg_integer(), quit | kill) -> ok.
signal(0, _Signal) ->
    ok;
signal(OsPid, Signal) ->
    case cb_nif:kill(OsPid, number(Signal)) of
        ok -> ok;
        {error, esrch} -> ok
    end.

number(quit) -> ?SIGQUIT;
number(kill) -> ?SIGKILL.

-spec kill(program()) -> ok.
kill(#program{os_pid = OsPid}) -> signal(OsPid, kill).

%% @doc Asks the program to end, insists after Patience milliseconds, and forgets its messages.
-spec stop(program(), timeout()) -> ok.
stop(#program{port = Port} = Program, Patience) ->
    try port_command(Port, term_to_binary({Program#program.next, stop})) of
        true -> await_or_kill(Program, Patience)
    catch
        error:badarg -> ok
    end,
    forget(Program).

await_or_kill(Program, Patience) ->
    case await_end(Program, Patience) of
        unknown ->
            ok = kill(Program),
            _ = await_end(Program, 5000),
            ok;
        _ ->
            ok
    end.

%% @doc Drops what the ended program has left in the message queue.
-spec forget(program()) -> ok.
forget(#program{port = Port, monitor = Monitor}) ->
    true = demonitor(Monitor, [flush]),
    try port_close(Port) of
        true -> ok
    catch
        error:badarg -> ok
    end,
    flush(Port).

flush(Port) ->
    receive
        {Port, _} -> flush(Port)
    after 0 -> ok
    end.

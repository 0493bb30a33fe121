%% @doc One running port program: a request, its answer, and how the program ends.
%%
%% All functions must be called by the process that called start/3: the port sends it its
%% messages. The port is not linked to it, so that the program's end is a message and no exit
%% signal; who starts a program sees to its end (cb_janitor). Answers to requests that were given
%% up are recognised by their number and dropped.
-module(cb_program).

-export([start/3, watch/2, call/2, request/3, stop/2, forget/1]).
-export([os_pid/1, signal/2, kill/1, await_end/2, await_child_end/2]).
-export_type([program/0, outcome/0, ending/0, callback/0, reason/0]).

-record(program, {
    port :: port(),
    monitor :: reference(),
    os_pid :: non_neg_integer(),
    callback :: callback(),
    %% The number of the last request, and that of the last one that the janitor need not watch.
    %% Outside of the record, so that a request makes no garbage to speak of.
    counters :: atomics:atomics_ref()
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

%% Counters.
-define(LAST, 1).
-define(UNWATCHED, 2).
-define(PROTOCOL, 1).
-define(HELLO_MS, 30000).
-define(SIGQUIT, 3).
-define(SIGKILL, 9).

%% @doc Starts the program; the library's own output goes to the file Log. Callback answers when
%% a stub asks.
-spec start(file:filename(), [{string(), string() | false}], callback()) ->
    {ok, program()} | {error, reason()}.
start(Log, Env, Callback) ->
    case cb_files:program("c_bridge_port") of
        {ok, Exe} -> hello(Exe, open(Exe, Log, Env, Callback));
        {error, _} = Error -> Error
    end.

open(Exe, Log, Env, Callback) ->
    Options = [{args, [Log]}, {env, Env}, {packet, 4}, binary, exit_status, use_stdio],
    Port = open_port({spawn_executable, Exe}, Options),
    true = unlink(Port),
    #program{
        port = Port,
        monitor = monitor(port, Port),
        os_pid = os_pid_of(Port),
        callback = Callback,
        counters = atomics:new(2, [])
    }.

%% 0 if it has ended already.
os_pid_of(Port) ->
    case erlang:port_info(Port, os_pid) of
        {os_pid, OsPid} -> OsPid;
        undefined -> 0
    end.

hello(Exe, Program) ->
    case request(Program, hello, ?HELLO_MS) of
        {ok, #{protocol := ?PROTOCOL}} ->
            {ok, Program};
        Other ->
            ok = kill(Program),
            _ = await_end(Program, ?HELLO_MS),
            ok = forget(Program),
            {error, {load, Exe, {protocol, Other}}}
    end.

-spec os_pid(program()) -> non_neg_integer().
os_pid(#program{os_pid = OsPid}) -> OsPid.

%% @doc The janitor sees to the end of the program, and to the answers to call/2.
-spec watch(program(), cb_janitor:janitor()) -> ok.
watch(#program{os_pid = OsPid, counters = Counters, monitor = Monitor}, Janitor) ->
    cb_janitor:program(Janitor, OsPid, Counters, Monitor).

%% @doc Sends a request and waits for its answer, for the end of who should give it, or for the
%% janitor to say that the answer is overdue.
-spec call(program(), term()) -> outcome().
call(#program{counters = Counters} = Program, Request) ->
    Id = atomics:add_get(Counters, ?LAST, 1),
    Outcome = exchange(Program, Id, Request, infinity),
    ok = atomics:put(Counters, ?UNWATCHED, Id),
    Outcome.

%% @doc The same with a time of its own.
-spec request(program(), term(), timeout()) -> outcome().
request(#program{counters = Counters} = Program, Request, Timeout) ->
    exchange(Program, unwatched(Counters), Request, Timeout).

unwatched(Counters) ->
    Id = atomics:get(Counters, ?LAST) + 1,
    ok = atomics:put(Counters, ?UNWATCHED, Id),
    ok = atomics:put(Counters, ?LAST, Id),
    Id.

exchange(Program, Id, Request, Timeout) ->
    case send(Program, {Id, Request}) of
        sent -> await(Program, Id, Timeout);
        closed -> {ended, await_end(Program, 1000)}
    end.

send(#program{port = Port}, Term) ->
    try port_command(Port, term_to_binary(Term)) of
        true -> sent
    catch
        error:badarg -> closed
    end.

await(#program{port = Port, monitor = Monitor} = Program, Id, Timeout) ->
    receive
        {Port, {data, Packet}} ->
            case binary_to_term(Packet) of
                {Id, ok, Value} -> {ok, Value};
                {Id, error, Reason} -> {error, Reason};
                {0, child, Ending} -> {child_ended, Ending};
                {0, callback, Function, Args} -> answer(Program, Id, Timeout, Function, Args);
                {Stale, _, _} when Stale < Id -> await(Program, Id, Timeout)
            end;
        {Port, {exit_status, Status}} ->
            {ended, ending(Status)};
        {'DOWN', Monitor, port, Port, _} ->
            {ended, unknown};
        {overdue, Monitor, Id} ->
            timeout;
        {overdue, Monitor, _AnsweredAtLast} ->
            await(Program, Id, Timeout)
    after Timeout -> timeout
    end.

answer(#program{callback = Callback, counters = Counters} = Program, Id, Timeout, Function, Args) ->
    %% The time of a stub is not that of the system under test.
    Unwatched = atomics:exchange(Counters, ?UNWATCHED, Id),
    Answer = Callback(Function, Args),
    ok = atomics:put(Counters, ?UNWATCHED, Unwatched),
    case Answer of
        {ok, Value} ->
            case send(Program, {callback, Value}) of
                sent -> await(Program, Id, Timeout);
                closed -> {ended, await_end(Program, 1000)}
            end;
        {error, Reason} ->
            {abandoned, Reason}
    end.

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
stop(#program{counters = Counters} = Program, Patience) ->
    case send(Program, {unwatched(Counters), stop}) of
        sent -> await_or_kill(Program, Patience);
        closed -> ok
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
    flush(Port, Monitor).

flush(Port, Monitor) ->
    receive
        {Port, _} -> flush(Port, Monitor);
        {overdue, Monitor, _} -> flush(Port, Monitor)
    after 0 -> ok
    end.

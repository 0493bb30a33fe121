%% @doc The `port' transport: the system under test in an OS process of its own.
%%
%% A crash, a hang or an exit of the C code ends that OS process, never this VM: the caller gets
%% `{error, Reason}' and restart/1 starts a fresh one. Who keeps the OS process is cb_keeper; here
%% are the questions that can be put to it.
-module(cb_port).

-export([start/1, request/3, restart/1, stop/1, last_crash/1]).
-export_type([keeper/0]).

-type keeper() :: pid().

%% @doc Starts and loads. The map returned is what the core says about the library, with the
%% reset chosen.
-spec start(cb_keeper:config()) -> {ok, keeper(), map()} | {error, term()}.
start(Config) ->
    Self = self(),
    {Keeper, Monitor} = spawn_monitor(cb_keeper, init, [Self, Config]),
    receive
        {Keeper, {started, Info}} ->
            true = demonitor(Monitor, [flush]),
            {ok, Keeper, Info};
        {'DOWN', Monitor, process, Keeper, {shutdown, Reason}} ->
            {error, Reason};
        {'DOWN', Monitor, process, Keeper, Reason} ->
            {error, {keeper, Reason}}
    end.

%% @doc Any request of the table in docs/architecture.md. In is what a crash is reported in.
-spec request(keeper(), term(), cb_crash:sut()) -> {ok, term()} | {error, term()}.
request(Keeper, Request, In) -> ask(Keeper, {request, Request, In}).

%% @doc Resets the system under test, or starts it again if it is gone.
-spec restart(keeper()) -> ok | {error, term()}.
restart(Keeper) -> ask(Keeper, restart).

-spec stop(keeper()) -> ok | {error, term()}.
stop(Keeper) ->
    case ask(Keeper, stop) of
        {error, {not_running, stopped}} -> ok;
        Reply -> Reply
    end.

-spec last_crash(keeper()) -> none | cb_crash:crash().
last_crash(Keeper) ->
    case ask(Keeper, last_crash) of
        {error, {not_running, stopped}} -> none;
        Crash -> Crash
    end.

ask(Keeper, Question) ->
    Reference = monitor(process, Keeper),
    Keeper ! {ask, self(), Reference, Question},
    await_reply(Keeper, Reference).

await_reply(Keeper, Reference) ->
    receive
        {Reference, reply, Reply} ->
            true = demonitor(Reference, [flush]),
            Reply;
        {Reference, callback, Fun, Args} ->
            Keeper ! {Reference, called_back, run_stub(Fun, Args)},
            await_reply(Keeper, Reference);
        {'DOWN', Reference, process, Keeper, _} ->
            {error, {not_running, stopped}}
    end.

%% Stubs run in the process that called into the system under test.
run_stub(Fun, Args) ->
    try
        {ok, apply(Fun, Args)}
    catch
        Class:Reason:Stack -> {error, {Class, Reason, Stack}}
    end.

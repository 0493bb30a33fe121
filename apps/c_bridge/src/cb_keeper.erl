%% @doc A process that holds one system under test for several processes.
%%
%% Used when `cb:start/2' is given an owner other than the process that calls it. It ends, and with
%% it everything it started, when it is told to stop or when the owner is gone.
-module(cb_keeper).

-export([start/2, ask/2]).
-export_type([keeper/0]).

-type keeper() :: pid().

%% Who waits for the present answer.
-define(CALLER, {?MODULE, caller}).

%% @doc Starts the system under test of the configuration.
-spec start(cb_instance:config(), pid() | none) -> {ok, map(), keeper()} | {error, term()}.
start(Config, Owner) ->
    Starter = self(),
    {Keeper, Monitor} = spawn_monitor(fun() -> init(Starter, Config, Owner) end),
    receive
        {Keeper, {started, Info}} ->
            true = demonitor(Monitor, [flush]),
            {ok, Info, Keeper};
        {'DOWN', Monitor, process, Keeper, {shutdown, Reason}} ->
            {error, Reason};
        {'DOWN', Monitor, process, Keeper, Reason} ->
            {error, {keeper, Reason}}
    end.

%% @doc Puts a question and waits for its answer.
-spec ask(keeper(), {request, term(), cb_crash:sut()} | restart | last_crash | stop) -> term().
ask(Keeper, Question) ->
    Reference = monitor(process, Keeper),
    Keeper ! {ask, self(), Reference, Question},
    await_reply(Keeper, Reference).

await_reply(Keeper, Reference) ->
    receive
        {Reference, reply, Reply} ->
            true = demonitor(Reference, [flush]),
            Reply;
        {Reference, stub, Fun, Args} ->
            Keeper ! {Reference, stub_value, cb_port:run_stub(Fun, Args)},
            await_reply(Keeper, Reference);
        {'DOWN', Reference, process, Keeper, _} ->
            {error, {not_running, stopped}}
    end.

init(Starter, Config, Owner) ->
    case cb_instance:start(Config, fun ask_caller/3) of
        {ok, Info, Instance} ->
            Watched = [monitor(process, Owner) || is_pid(Owner)],
            Starter ! {self(), {started, Info}},
            loop(Instance, Watched);
        {error, Reason} ->
            exit({shutdown, Reason})
    end.

%% What the port has to say stays in the queue until an answer is awaited.
loop(Instance, Watched) ->
    receive
        {ask, From, Reference, stop} ->
            ok = cb_instance:stop(Instance),
            From ! {Reference, reply, ok};
        {ask, From, Reference, Question} ->
            _ = put(?CALLER, {From, Reference}),
            {Reply, Next} = answer(Instance, Question),
            From ! {Reference, reply, Reply},
            loop(Next, Watched);
        {'DOWN', Owner, process, _, _} when [Owner] =:= Watched ->
            cb_instance:stop(Instance)
    end.

answer(Instance, {request, Request, In}) -> cb_instance:request(Instance, Request, In);
answer(Instance, restart) -> cb_instance:restart(Instance);
answer(Instance, last_crash) -> {cb_instance:last_crash(Instance), Instance}.

%% Stubs run in the process that called, so that they see its dictionary; during start, here.
ask_caller(Function, Fun, Args) ->
    case get(?CALLER) of
        {From, Reference} ->
            Monitor = monitor(process, From),
            From ! {Reference, stub, Fun, Args},
            await_stub(Monitor, From, Reference, Function);
        undefined ->
            cb_port:run_stub(Fun, Args)
    end.

await_stub(Monitor, From, Reference, Function) ->
    receive
        {Reference, stub_value, Value} ->
            true = demonitor(Monitor, [flush]),
            Value;
        {'DOWN', Monitor, process, _, Why} ->
            {error, {caller, Why}};
        {ask, From, Question, _} ->
            %% The stub itself asks: it would wait for the call that waits for it.
            From ! {Question, reply, {error, {in_call, Function}}},
            await_stub(Monitor, From, Reference, Function)
    end.

%% @doc The `port' transport: the system under test in an OS process of its own.
%%
%% A crash, a hang or an exit of the C code ends that OS process, never this VM: the caller gets
%% `{error, Reason}' and restart/1 starts a fresh one.
%%
%% The process that starts a system under test talks to its port itself, which is the fastest way;
%% nobody else can use it then, and it ends with that process. With another owner, or none, there
%% is a process in between (cb_keeper) that any process can ask.
-module(cb_port).

-export([start/2, request/3, restart/1, stop/1, last_crash/1, run_stub/2]).
-export_type([at/0]).

%% The reference is the key of the state in the dictionary of the process.
-opaque at() :: {own, pid(), reference()} | cb_keeper:keeper().

%% @doc Starts and loads. The map returned is what the core says about the library, with the
%% reset chosen.
-spec start(cb_instance:config(), Owner :: pid() | none) ->
    {ok, at(), map()} | {error, term()}.
start(Config, Owner) when Owner =:= self() ->
    Reference = make_ref(),
    case cb_instance:start(Config, stub_runner(Reference)) of
        {ok, Info, Instance} ->
            _ = put(Reference, {idle, Instance}),
            {ok, {own, self(), Reference}, Info};
        {error, _} = Error ->
            Error
    end;
start(Config, Owner) ->
    case cb_keeper:start(Config, Owner) of
        {ok, Info, Keeper} -> {ok, Keeper, Info};
        {error, _} = Error -> Error
    end.

%% @doc Any request of the table in docs/architecture.md. In is what a crash is reported in.
-spec request(at(), term(), cb_crash:sut()) -> {ok, term()} | {error, term()}.
request({own, _, Reference} = At, Request, In) ->
    case get(Reference) of
        {idle, Instance} ->
            {Reply, Next} = cb_instance:request(Instance, Request, In),
            ok = keep(Reference, Instance, Next),
            Reply;
        Other ->
            unusable(Other, At)
    end;
request(Keeper, Request, In) ->
    cb_keeper:ask(Keeper, {request, Request, In}).

%% Nothing changes as long as all goes well.
keep(_Reference, Same, Same) ->
    ok;
keep(Reference, _Instance, Next) ->
    _ = put(Reference, {idle, Next}),
    ok.

unusable({in_call, _} = Why, _) -> {error, Why};
unusable(undefined, {own, Owner, _}) when Owner =:= self() -> {error, {not_running, stopped}};
unusable(undefined, {own, Owner, _}) -> {error, {other_process, Owner}}.

%% While a stub runs, the system under test waits for it and takes no requests.
stub_runner(Reference) ->
    fun(Function, Fun, Args) ->
        Before = put(Reference, {in_call, Function}),
        Value = run_stub(Fun, Args),
        _ =
            case Before of
                undefined -> erase(Reference);
                _ -> put(Reference, Before)
            end,
        Value
    end.

%% @doc The value of a stub, or why there is none.
-spec run_stub(fun(), [term()]) -> {ok, term()} | {error, term()}.
run_stub(Fun, Args) ->
    try
        {ok, apply(Fun, Args)}
    catch
        Class:Reason:Stack -> {error, {Class, Reason, Stack}}
    end.

%% @doc Resets the system under test, or starts it again if it is gone.
-spec restart(at()) -> ok | {error, term()}.
restart({own, _, Reference} = At) ->
    case get(Reference) of
        {idle, Instance} ->
            {Reply, Next} = cb_instance:restart(Instance),
            ok = keep(Reference, Instance, Next),
            Reply;
        Other ->
            unusable(Other, At)
    end;
restart(Keeper) ->
    cb_keeper:ask(Keeper, restart).

%% @doc Ends the system under test; nothing happens if that has been done.
-spec stop(at()) -> ok | {error, term()}.
stop(At) ->
    case stop_running(At) of
        {error, {not_running, stopped}} -> ok;
        Reply -> Reply
    end.

stop_running({own, _, Reference} = At) ->
    case get(Reference) of
        {idle, Instance} ->
            _ = erase(Reference),
            cb_instance:stop(Instance);
        Other ->
            unusable(Other, At)
    end;
stop_running(Keeper) ->
    cb_keeper:ask(Keeper, stop).

-spec last_crash(at()) -> none | cb_crash:crash().
last_crash({own, _, Reference}) ->
    case get(Reference) of
        {idle, Instance} -> cb_instance:last_crash(Instance);
        _ -> none
    end;
last_crash(Keeper) ->
    case cb_keeper:ask(Keeper, last_crash) of
        {error, {not_running, stopped}} -> none;
        Crash -> Crash
    end.

%% @doc The process that owns one system under test in an OS process of its own.
%%
%% It ends, and with it everything it started, when it is told to stop or when the process named
%% as owner is gone. Questions come from cb_port.
-module(cb_keeper).

-export([init/2]).
-export_type([config/0]).

-type config() :: #{
    file := file:filename(),
    load_options := map(),
    env := [{string(), string() | false}],
    log := file:filename() | temporary,
    reset := cb_reset:asked(),
    force_reset := none | {force, cb_reset:asked()},
    timeout := timeout(),
    %% load and start have more time than a call
    slow_timeout := timeout(),
    sanitize := [address | undefined],
    stubs := #{atom() => fun()},
    owner := pid() | none
}.

-record(keeper, {
    config :: config(),
    log :: file:filename(),
    owner :: reference() | none,
    program = none :: none | cb_program:program(),
    choice = none :: none | cb_reset:choice(),
    %% the forked child that serves, in fork mode
    child = none :: none | pos_integer(),
    %% why there is nothing to call
    down = none :: none | term(),
    last_crash = none :: none | cb_crash:crash(),
    %% the generation that the next process starts with
    generation = 1 :: pos_integer(),
    %% where in the log the present test began
    log_from = 0 :: non_neg_integer(),
    %% places named already: while a failure is shrunk, the same crash comes again and again
    symbols = #{} :: cb_symbols:known()
}).

-define(STOP_MS, 5000).
-define(QUIT_MS, 1000).
%% A log file of our own is cut when a restart finds it longer than this.
-define(LOG_BYTES, 8388608).
-define(LOG_CHECK_EVERY, 256).

%% @doc Tells Starter `{Keeper, {started, Info}}', or exits with `{shutdown, Reason}'.
-spec init(pid(), config()) -> ok.
init(Starter, #{owner := Owner} = Config) ->
    %% The port's end must arrive as a message.
    process_flag(trap_exit, true),
    Log = log_file(Config),
    From = cb_log:length(Log),
    Keeper = #keeper{config = Config, log = Log, owner = watch(Owner), log_from = From},
    case boot(Keeper) of
        {ok, Info, Ready} ->
            Starter ! {self(), {started, Info}},
            loop(Ready, 0);
        {error, Reason, Failed} ->
            ok = shut_down(Failed),
            ok = delete_log(Failed),
            exit({shutdown, Reason})
    end.

watch(none) -> none;
watch(Owner) -> monitor(process, Owner).

log_file(#{log := temporary}) -> cb_files:fresh_name("c_bridge", ".log");
log_file(#{log := File}) -> File.

delete_log(#keeper{config = #{log := temporary}, log = Log}) ->
    _ = file:delete(Log),
    ok;
delete_log(_) ->
    ok.

%% What the port has to say is read where an answer is awaited; at the end of the program that is
%% the next request.
loop(#keeper{owner = Owner} = Keeper, Restarts) ->
    receive
        {ask, From, Reference, {request, Request, In}} ->
            {Reply, Next} = serve(Keeper, {From, Reference}, Request, In),
            From ! {Reference, reply, Reply},
            loop(Next, Restarts);
        {ask, From, Reference, restart} ->
            {Reply, Next} = reset(check_log(Keeper, Restarts), {From, Reference}),
            From ! {Reference, reply, Reply},
            loop(Next, Restarts + 1);
        {ask, From, Reference, last_crash} ->
            From ! {Reference, reply, Keeper#keeper.last_crash},
            loop(Keeper, Restarts);
        {ask, From, Reference, stop} ->
            ok = terminate(Keeper),
            From ! {Reference, reply, ok};
        {'DOWN', Owner, process, _, _} ->
            terminate(Keeper)
    end.

terminate(Keeper) ->
    ok = shut_down(Keeper),
    delete_log(Keeper).

check_log(#keeper{config = #{log := temporary}, log = Log} = Keeper, Restarts) when
    Restarts rem ?LOG_CHECK_EVERY =:= 0
->
    case cb_log:length(Log) > ?LOG_BYTES of
        true ->
            ok = cb_log:cut(Log),
            Keeper#keeper{log_from = 0};
        false ->
            Keeper
    end;
check_log(Keeper, _) ->
    Keeper.

%% ---- one request ---------------------------------------------------------------------------

serve(#keeper{down = none} = Keeper, Caller, Request, In) ->
    #keeper{config = #{timeout := Timeout}} = Keeper,
    exchange(Keeper, Caller, Request, In, Timeout);
serve(#keeper{down = Why} = Keeper, _Caller, _Request, _In) ->
    {{error, {not_running, Why}}, Keeper}.

exchange(#keeper{program = Program} = Keeper, Caller, Request, In, Timeout) ->
    Callback = fun(Function, Args) -> ask_stub(Keeper, Caller, Function, Args) end,
    {Outcome, Next} = cb_program:request(Program, Request, Timeout, Callback),
    outcome(Outcome, Keeper#keeper{program = Next}, In, Timeout).

outcome({ok, _} = Reply, Keeper, In, _) -> check_sanitizer(Reply, Keeper, In);
outcome({error, _} = Reply, Keeper, In, _) -> check_sanitizer(Reply, Keeper, In);
outcome({ended, Ending}, Keeper, In, _) -> died(Ending, buried(Keeper), In);
outcome({child_ended, Ending}, Keeper, In, _) -> died(Ending, Keeper#keeper{child = none}, In);
outcome(timeout, Keeper, In, Ms) -> timed_out(Keeper, In, Ms);
outcome({abandoned, Why}, Keeper, _In, _) -> down({callback, Why}, ended_by(kill, Keeper)).

%% Tells the caller to run the stub, so that it sees its own process dictionary.
ask_stub(#keeper{config = #{stubs := Stubs}}, {From, Reference}, Function, Args) ->
    case Stubs of
        #{Function := Fun} ->
            Monitor = monitor(process, From),
            From ! {Reference, callback, Fun, Args},
            await_stub(Monitor, From, Reference, Function);
        #{} ->
            {error, {Function, no_such_stub}}
    end.

await_stub(Monitor, From, Reference, Function) ->
    receive
        {Reference, called_back, {ok, Value}} ->
            true = demonitor(Monitor, [flush]),
            {ok, Value};
        {Reference, called_back, {error, Why}} ->
            true = demonitor(Monitor, [flush]),
            {error, {Function, Why}};
        {'DOWN', Monitor, process, _, Why} ->
            {error, {Function, {caller, Why}}};
        {ask, From, Question, _} ->
            %% The stub itself asks: it would wait for the call that waits for it.
            From ! {Question, reply, {error, {in_call, Function}}},
            await_stub(Monitor, From, Reference, Function)
    end.

%% UBSan prints and goes on: what it printed belongs to this request.
check_sanitizer(Reply, #keeper{config = #{sanitize := []}} = Keeper, _In) ->
    {Reply, Keeper};
check_sanitizer(Reply, #keeper{log = Log, log_from = From} = Keeper, In) ->
    Text = cb_log:since(Log, From),
    case cb_crash:sanitizer_lines(Text) of
        [] ->
            {Reply, Keeper};
        [First | _] ->
            Reason = {sanitizer, undefined, #{summary => First, log => Text, in => In}},
            Seen = Keeper#keeper{log_from = From + byte_size(Text), last_crash = Reason},
            {{error, Reason}, Seen}
    end.

%% ---- the end of a process --------------------------------------------------------------------

died(Ending, Keeper, In) ->
    down_of(Ending, Keeper, In).

timed_out(Keeper, In, Ms) ->
    down_of({timeout, Ms}, ended_by(quit, Keeper), In).

down_of(Ending, #keeper{log = Log, log_from = From} = Keeper, In) ->
    Finding = cb_crash:examine(Ending, cb_log:since(Log, From)),
    {Frames, Named} = frames(cb_crash:addresses(Finding), Keeper),
    down(cb_crash:reason(Finding, In, Frames), Named).

%% In fork mode the parent is sound and knows the library; otherwise a fresh program is asked.
frames(Addresses, #keeper{program = Program, symbols = Known} = Keeper) ->
    {Frames, NowKnown, Next} = cb_symbols:frames(Addresses, Known, Program),
    {Frames, Keeper#keeper{symbols = NowKnown, program = Next}}.

down(Reason, #keeper{log = Log} = Keeper) ->
    Down = Keeper#keeper{down = Reason, last_crash = Reason, log_from = cb_log:length(Log)},
    {{error, Reason}, Down}.

%% Makes who serves end: the child if there is one, else the program. SIGQUIT lets it say where
%% it hangs; SIGKILL follows when it does not end by that.
ended_by(Signal, #keeper{program = Program, child = none} = Keeper) ->
    ok = cb_program:signal(cb_program:os_pid(Program), Signal),
    case cb_program:await_end(Program, ?QUIT_MS) of
        unknown when Signal =:= quit -> ended_by(kill, Keeper);
        _ -> buried(Keeper)
    end;
ended_by(Signal, #keeper{program = Program, child = Child} = Keeper) ->
    ok = cb_program:signal(Child, Signal),
    case cb_program:await_child_end(Program, ?QUIT_MS) of
        {child_ended, _} -> Keeper#keeper{child = none};
        timeout when Signal =:= quit -> ended_by(kill, Keeper);
        _ -> ended_by(kill, Keeper#keeper{child = none})
    end.

buried(#keeper{program = Program} = Keeper) ->
    ok = cb_program:forget(Program),
    Keeper#keeper{program = none, child = none}.

%% ---- start, reset, stop ----------------------------------------------------------------------

boot(#keeper{config = Config, log = Log} = Keeper) ->
    case cb_program:start(Log, maps:get(env, Config)) of
        {ok, Program} -> load(Keeper#keeper{program = Program, child = none, down = none});
        {error, Reason} -> {error, Reason, Keeper}
    end.

load(#keeper{config = Config, generation = Generation} = Keeper) ->
    #{file := File, load_options := Options, slow_timeout := Timeout} = Config,
    Request = {load, File, Options#{generation => Generation}},
    case exchange(Keeper, no_caller(), Request, {load, File}, Timeout) of
        {{ok, Loaded}, Next} -> choose(Loaded, Next);
        {{error, Reason}, Next} -> {error, Reason, Next}
    end.

choose(Loaded, #keeper{config = #{reset := Asked, force_reset := Forced}} = Keeper) ->
    case cb_reset:choose(port, Asked, Forced, Loaded) of
        {ok, Choice} ->
            case requests(after_load(Choice), Keeper#keeper{choice = Choice}, no_caller()) of
                {ok, Ready} -> {ok, maps:merge(Loaded, Choice), Ready};
                {{error, Reason}, Failed} -> {error, Reason, Failed}
            end;
        {error, Reason} ->
            {error, Reason, Keeper}
    end.

no_caller() -> {self(), make_ref()}.

after_load(#{method := snapshot} = Choice) -> [snapshot | cb_reset:requests(Choice)];
after_load(#{method := fork} = Choice) -> [fork | cb_reset:requests(Choice)];
after_load(Choice) -> cb_reset:requests(Choice).

%% Each reset starts at most two generations of pointers: its own and that of the calls after it.
reset(#keeper{generation = Generation} = Keeper, Caller) ->
    reset_by_method(Keeper#keeper{generation = Generation + 2}, Caller).

reset_by_method(#keeper{program = none} = Keeper, _Caller) ->
    boot_again(Keeper);
reset_by_method(#keeper{choice = #{method := respawn}} = Keeper, _Caller) ->
    ok = shut_down(Keeper),
    boot_again(Keeper);
reset_by_method(#keeper{choice = #{method := fork}, child = none} = Keeper, Caller) ->
    again([fork], Keeper#keeper{down = none}, Caller);
reset_by_method(#keeper{choice = #{method := fork}} = Keeper, Caller) ->
    again([fork], end_child(Keeper), Caller);
reset_by_method(#keeper{down = Why} = Keeper, _Caller) when Why =/= none ->
    boot_again(ended_by(kill, Keeper));
reset_by_method(#keeper{choice = #{method := snapshot}} = Keeper, Caller) ->
    again([restore], Keeper, Caller);
reset_by_method(#keeper{choice = #{method := reload}} = Keeper, Caller) ->
    again([reload], Keeper, Caller);
reset_by_method(Keeper, Caller) ->
    again([], Keeper, Caller).

boot_again(Keeper) ->
    case boot(Keeper) of
        {ok, _, Ready} -> {ok, Ready};
        {error, Reason, Failed} -> {{error, Reason}, Failed#keeper{down = Reason}}
    end.

again(_, #keeper{program = none} = Keeper, _Caller) ->
    boot_again(Keeper);
again(First, #keeper{choice = Choice} = Keeper, Caller) ->
    requests(First ++ cb_reset:requests(Choice), Keeper, Caller).

requests([], Keeper, _Caller) ->
    {ok, Keeper};
requests([Request | Requests], Keeper, Caller) ->
    #keeper{config = #{slow_timeout := Timeout}} = Keeper,
    case exchange(Keeper, Caller, Request, Request, Timeout) of
        {{ok, Child}, Next} when Request =:= fork ->
            requests(Requests, Next#keeper{child = Child}, Caller);
        {{ok, _}, Next} ->
            requests(Requests, Next, Caller);
        {{error, Reason}, Next} ->
            {{error, Reason}, Next#keeper{down = Reason}}
    end.

%% The child writes its coverage counts and exits; the parent reports its end.
end_child(#keeper{program = Program} = Keeper) ->
    case cb_program:request(Program, end_test, ?STOP_MS, fun(_, _) -> {error, ending} end) of
        {{ok, _}, Next} ->
            case cb_program:await_child_end(Next, ?STOP_MS) of
                {child_ended, _} -> Keeper#keeper{program = Next, child = none};
                {ended, _} -> buried(Keeper#keeper{program = Next});
                timeout -> ended_by(kill, Keeper#keeper{program = Next})
            end;
        {{child_ended, _}, Next} ->
            Keeper#keeper{program = Next, child = none};
        {{ended, _}, Next} ->
            buried(Keeper#keeper{program = Next});
        {_, Next} ->
            ended_by(kill, Keeper#keeper{program = Next})
    end.

shut_down(#keeper{program = none}) ->
    ok;
shut_down(#keeper{program = Program, child = none}) ->
    cb_program:stop(Program, ?STOP_MS);
shut_down(Keeper) ->
    case end_child(Keeper) of
        #keeper{child = none} = Ended -> shut_down(Ended)
    end.

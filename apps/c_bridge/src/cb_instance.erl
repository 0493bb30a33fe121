%% @doc One system under test behind a port program: started, asked, reset, ended.
%%
%% The functions take and give the state, and must all be called by the process that called
%% start/2, because the port program sends its answers to that process. `cb_port' and `cb_keeper'
%% hold such states. In fork mode the program loads the library once and a forked child of it serves
%% one test; otherwise the program itself serves.
-module(cb_instance).

-export([start/2, request/3, restart/1, stop/1, last_crash/1]).
-export_type([config/0, instance/0, ask_stub/0]).

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
    stubs := #{atom() => fun()}
}.
%% Runs a stub in the process that called.
-type ask_stub() :: fun((Function :: atom(), fun(), [term()]) -> {ok, term()} | {error, term()}).

-record(instance, {
    config :: config(),
    callback :: cb_program:callback(),
    log = none :: none | cb_log:log(),
    janitor :: cb_janitor:janitor(),
    restarts = 0 :: non_neg_integer(),
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

-opaque instance() :: #instance{}.

-define(STOP_MS, 5000).
-define(QUIT_MS, 1000).
%% A log file of our own is cut when a restart finds it longer than this.
-define(LOG_BYTES, 8388608).
-define(LOG_CHECK_EVERY, 256).

%% @doc Starts the program and loads the library. The map returned is what the core says about it,
%% with the reset chosen. The end of the calling process ends the system under test.
%% Ask runs a stub.
-spec start(config(), ask_stub()) -> {ok, map(), instance()} | {error, term()}.
start(Config, Ask) ->
    State = #instance{
        config = Config,
        callback = stub_callback(Config, Ask),
        janitor = cb_janitor:start(maps:get(timeout, Config))
    },
    case boot(State) of
        {ok, Info, Ready} ->
            {ok, Info, Ready};
        {error, Reason, Failed} ->
            ok = stop(Failed),
            {error, Reason}
    end.

%% @doc Any request of the table in docs/architecture.md. In is what a crash is reported in.
-spec request(instance(), term(), cb_crash:sut()) ->
    {{ok, term()} | {error, term()}, instance()}.
request(#instance{down = none, program = Program} = State, Request, In) ->
    outcome(cb_program:call(Program, Request), State, In);
request(#instance{down = Why} = State, _Request, _In) ->
    {{error, {not_running, Why}}, State}.

%% @doc Resets the system under test, or starts it again if it is gone.
-spec restart(instance()) -> {ok | {error, term()}, instance()}.
restart(#instance{restarts = Restarts} = State) ->
    reset(check_log(State#instance{restarts = Restarts + 1})).

%% @doc Ends the program and what it has forked.
-spec stop(instance()) -> ok.
stop(#instance{janitor = Janitor, log = Log} = State) ->
    ok = shut_down(State),
    ok = cb_log:close(Log),
    cb_janitor:finished(Janitor).

-spec last_crash(instance()) -> none | cb_crash:crash().
last_crash(#instance{last_crash = Crash}) -> Crash.

check_log(#instance{log = Log, restarts = Restarts} = State) when
    Restarts rem ?LOG_CHECK_EVERY =:= 0
->
    case cb_log:cut(Log, ?LOG_BYTES) of
        cut -> State#instance{log_from = 0};
        left_alone -> State
    end;
check_log(State) ->
    State.

%% ---- one request ---------------------------------------------------------------------------

exchange(#instance{program = Program} = State, Request, In, Timeout) ->
    case cb_program:request(Program, Request, Timeout) of
        timeout -> timed_out(State, In, Timeout);
        Outcome -> outcome(Outcome, State, In)
    end.

outcome({ok, _} = Reply, State, In) -> check_sanitizer(Reply, State, In);
outcome({error, _} = Reply, State, In) -> check_sanitizer(Reply, State, In);
outcome({ended, Ending}, State, In) -> died(Ending, buried(State), In);
outcome({child_ended, Ending}, State, In) -> died(Ending, State#instance{child = none}, In);
outcome(timeout, #instance{config = #{timeout := Ms}} = State, In) -> timed_out(State, In, Ms);
outcome({abandoned, Why}, State, _In) -> gave_up({callback, Why}, ended_by(kill, State)).

stub_callback(#{stubs := Stubs}, Ask) ->
    fun(Function, Args) ->
        case Stubs of
            #{Function := Fun} -> of_stub(Function, Ask(Function, Fun, Args));
            #{} -> {error, {Function, no_such_stub}}
        end
    end.

of_stub(_Function, {ok, _} = Value) -> Value;
of_stub(Function, {error, Why}) -> {error, {Function, Why}}.

%% UBSan prints and goes on: what it printed belongs to this request.
check_sanitizer(Reply, #instance{config = #{sanitize := []}} = State, _In) ->
    {Reply, State};
check_sanitizer(Reply, #instance{log = Log, log_from = From} = State, In) ->
    Text = cb_log:since(Log, From),
    case cb_crash:sanitizer_lines(Text) of
        [] ->
            {Reply, State};
        [First | _] ->
            Reason = {sanitizer, undefined, #{summary => First, log => Text, in => In}},
            Seen = State#instance{log_from = From + byte_size(Text), last_crash = Reason},
            {{error, Reason}, Seen}
    end.

%% ---- the end of a process --------------------------------------------------------------------

died(Ending, State, In) ->
    down_of(Ending, State, In).

timed_out(State, In, Ms) ->
    down_of({timeout, Ms}, ended_by(quit, State), In).

down_of(Ending, #instance{log = Log, log_from = From} = State, In) ->
    Finding = cb_crash:examine(Ending, cb_log:since(Log, From)),
    {Frames, Named} = frames(cb_crash:addresses(Finding), State),
    down(cb_crash:reason(Finding, In, Frames), Named).

%% In fork mode the parent is sound and knows the library; otherwise a fresh program is asked.
frames(Addresses, #instance{program = Program, symbols = Known} = State) ->
    {Frames, NowKnown} = cb_symbols:frames(Addresses, Known, Program),
    {Frames, State#instance{symbols = NowKnown}}.

%% The C code cannot go on without the value of its stub.
gave_up(Reason, State) ->
    {{error, Reason}, State#instance{down = Reason}}.

down(Reason, #instance{log = Log} = State) ->
    Down = State#instance{down = Reason, last_crash = Reason, log_from = cb_log:length(Log)},
    {{error, Reason}, Down}.

%% Makes who serves end: the child if there is one, else the program. SIGQUIT lets it say where
%% it hangs; SIGKILL follows when it does not end by that.
ended_by(Signal, #instance{program = Program, child = none} = State) ->
    ok = cb_program:signal(cb_program:os_pid(Program), Signal),
    case cb_program:await_end(Program, ?QUIT_MS) of
        unknown when Signal =:= quit -> ended_by(kill, State);
        _ -> buried(State)
    end;
ended_by(Signal, #instance{program = Program, child = Child} = State) ->
    ok = cb_program:signal(Child, Signal),
    case cb_program:await_child_end(Program, ?QUIT_MS) of
        {child_ended, _} -> State#instance{child = none};
        timeout when Signal =:= quit -> ended_by(kill, State);
        _ -> ended_by(kill, State#instance{child = none})
    end.

buried(#instance{program = Program} = State) ->
    ok = cb_program:forget(Program),
    State#instance{program = none, child = none}.

%% ---- start, reset, stop ----------------------------------------------------------------------

boot(#instance{config = #{env := Env, log := Where}, janitor = Janitor} = State) ->
    Path = cb_log:path(Where),
    case cb_program:start(Path, Env, State#instance.callback) of
        {ok, Program} ->
            ok = cb_program:watch(Program, Janitor),
            ok = cb_log:close(State#instance.log),
            Log = cb_log:open(Where, Path),
            load(State#instance{
                program = Program,
                child = none,
                down = none,
                log = Log,
                log_from = cb_log:length(Log)
            });
        {error, Reason} ->
            {error, Reason, State}
    end.

load(#instance{config = Config, generation = Generation} = State) ->
    #{file := File, load_options := Options, slow_timeout := Timeout} = Config,
    Request = {load, File, Options#{generation => Generation}},
    case exchange(State, Request, {load, File}, Timeout) of
        {{ok, Loaded}, Next} -> choose(Loaded, Next);
        {{error, Reason}, Next} -> {error, Reason, Next}
    end.

choose(Loaded, #instance{config = #{reset := Asked, force_reset := Forced}} = State) ->
    case cb_reset:choose(port, Asked, Forced, Loaded) of
        {ok, Choice} ->
            case requests(after_load(Choice), State#instance{choice = Choice}) of
                {ok, Ready} -> {ok, maps:merge(Loaded, Choice), Ready};
                {{error, Reason}, Failed} -> {error, Reason, Failed}
            end;
        {error, Reason} ->
            {error, Reason, State}
    end.

after_load(#{method := snapshot} = Choice) -> [snapshot | cb_reset:requests(Choice)];
after_load(#{method := fork} = Choice) -> [fork | cb_reset:requests(Choice)];
after_load(Choice) -> cb_reset:requests(Choice).

%% Each reset starts at most two generations of pointers: its own and that of the calls after it.
reset(#instance{generation = Generation} = State) ->
    reset_by_method(State#instance{generation = Generation + 2}).

reset_by_method(#instance{program = none} = State) ->
    boot_again(State);
reset_by_method(#instance{choice = #{method := respawn}} = State) ->
    ok = shut_down(State),
    boot_again(State);
reset_by_method(#instance{choice = #{method := fork}, child = none} = State) ->
    again([fork], State#instance{down = none});
reset_by_method(#instance{choice = #{method := fork}} = State) ->
    again([fork], end_child(State));
reset_by_method(#instance{down = Why} = State) when Why =/= none ->
    boot_again(ended_by(kill, State));
reset_by_method(#instance{choice = #{method := snapshot}} = State) ->
    again([restore], State);
reset_by_method(#instance{choice = #{method := reload}} = State) ->
    again([reload], State);
reset_by_method(State) ->
    again([], State).

boot_again(State) ->
    case boot(State) of
        {ok, _, Ready} -> {ok, Ready};
        {error, Reason, Failed} -> {{error, Reason}, Failed#instance{down = Reason}}
    end.

again(_, #instance{program = none} = State) ->
    boot_again(State);
again(First, #instance{choice = Choice} = State) ->
    requests(First ++ cb_reset:requests(Choice), State).

requests([], State) ->
    {ok, State};
requests([Request | Requests], State) ->
    #instance{config = #{slow_timeout := Timeout}} = State,
    case exchange(State, Request, Request, Timeout) of
        {{ok, Child}, Next} when Request =:= fork ->
            requests(Requests, Next#instance{child = Child});
        {{ok, _}, Next} ->
            requests(Requests, Next);
        {{error, Reason}, Next} ->
            {{error, Reason}, Next#instance{down = Reason}}
    end.

%% The child writes its coverage counts and exits; the parent reports its end.
end_child(#instance{program = Program} = State) ->
    case cb_program:request(Program, end_test, ?STOP_MS) of
        {ok, _} -> child_gone(cb_program:await_child_end(Program, ?STOP_MS), State);
        Otherwise -> child_gone(Otherwise, State)
    end.

child_gone({child_ended, _}, State) -> State#instance{child = none};
child_gone({ended, _}, State) -> buried(State);
child_gone(_, State) -> ended_by(kill, State).

shut_down(#instance{program = none}) ->
    ok;
shut_down(#instance{program = Program, child = none}) ->
    cb_program:stop(Program, ?STOP_MS);
shut_down(State) ->
    case end_child(State) of
        #instance{child = none} = Ended -> shut_down(Ended)
    end.

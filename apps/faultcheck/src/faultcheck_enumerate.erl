%% @doc Bounded-exhaustive enumeration: checks every item of a space.
%%
%% ```
%% Space = faultcheck_space:subsets(lists:seq(0, 15), 4),
%% Check = fun(Bits, Sut) -> {#{length(Bits) => 1}, [B || B <- [Bits], fires(Sut, B)]} end,
%% {ok, #{counts := Counts, found := Found}} =
%%     faultcheck_enumerate:run(Space, Check, #{start => fun start_sut/0, workers => 2}).
%% '''
%% The check answers with counts, which are summed, and with findings, which are kept in the order
%% of the items. Work is handed out in chunks of a fixed size and merged in the order of the
%% chunks, so the result does not depend on the number of workers. With a state file
%% (faultcheck_enumerate_state) each finished chunk is kept, and a later run with the same name,
%% size and chunk goes on where the earlier one ended, however that one ended.
-module(faultcheck_enumerate).

-export([run/3, print_progress/1, format_error/1]).
-export_type([check/0, options/0, outcome/0, result/0, progress/0, reason/0]).

-type outcome() :: {Counts :: #{term() => integer()}, Found :: [term()]}.
-type check() :: fun((Item :: term(), Context :: term()) -> outcome()).
-type options() :: #{
    %% what is enumerated, with every parameter that changes an outcome; part of the state file
    name => term(),
    workers => pos_integer(),
    chunk => pos_integer(),
    state_file => file:filename() | none,
    %% run in each worker: one system under test belongs to one worker
    start => fun(() -> term()),
    stop => fun((Context :: term()) -> term()),
    progress => fun((progress()) -> term()),
    %% least time between two calls of progress
    progress_ms => non_neg_integer(),
    %% milliseconds, monotonic
    clock => fun(() -> integer()),
    %% start no further chunk after so many items of this run
    stop_after => pos_integer() | infinity
}.
-type result() :: #{
    counts := #{term() => integer()},
    found := [term()],
    done := non_neg_integer(),
    total := non_neg_integer(),
    elapsed_ms := non_neg_integer()
}.
-type progress() :: #{
    name := term(),
    done := non_neg_integer(),
    total := non_neg_integer(),
    elapsed_ms := non_neg_integer(),
    %% estimated from the speed of this run
    remaining_ms := non_neg_integer() | unknown
}.
-type reason() ::
    {check, Item :: term(), error | exit | throw, Reason :: term(), Stack :: term()}
    | {start, error | exit | throw, Reason :: term(), Stack :: term()}
    | {worker, Reason :: term()}
    | faultcheck_enumerate_state:reason().

-record(run, {
    ref :: reference(),
    space :: faultcheck_space:space(),
    options :: options(),
    started :: integer(),
    %% chunks not handed out yet, in order
    todo :: [non_neg_integer()],
    finished :: #{non_neg_integer() => outcome()},
    %% items of this run, the basis of the estimate
    now = 0 :: non_neg_integer(),
    done :: non_neg_integer(),
    shown :: integer(),
    state :: faultcheck_enumerate_state:state(),
    %% monitor of each worker that lives
    workers = #{} :: #{reference() => pid()}
}).

%% @doc Checks every item; `stopped' when stop_after ended the run before the last chunk.
-spec run(faultcheck_space:space(), check(), options()) ->
    {ok, result()} | {stopped, result()} | {error, reason()}.
run(Space, Check, Options0) ->
    Options = maps:merge(defaults(), Options0),
    #{name := Name, chunk := Chunk, state_file := File} = Options,
    Id = #{name => Name, size => faultcheck_space:size(Space), chunk => Chunk},
    case faultcheck_enumerate_state:open(File, Id) of
        {ok, State, Finished} ->
            try
                work(new_run(Space, Options, State, Finished), Check)
            after
                faultcheck_enumerate_state:close(State)
            end;
        {error, _} = Error ->
            Error
    end.

defaults() ->
    #{
        name => undefined,
        workers => 1,
        chunk => 64,
        state_file => none,
        start => fun() -> undefined end,
        stop => fun(_) -> ok end,
        progress => fun(_) -> ok end,
        progress_ms => 1000,
        clock => fun() -> erlang:monotonic_time(millisecond) end,
        stop_after => infinity
    }.

new_run(Space, #{chunk := Chunk, clock := Clock} = Options, State, Finished) ->
    Size = faultcheck_space:size(Space),
    Chunks = lists:seq(0, (Size + Chunk - 1) div Chunk - 1),
    Now = Clock(),
    #run{
        ref = make_ref(),
        space = Space,
        options = Options,
        started = Now,
        shown = Now,
        todo = [C || C <- Chunks, not is_map_key(C, Finished)],
        finished = Finished,
        done = lists:sum([items_in(C, Chunk, Size) || C <- maps:keys(Finished)]),
        state = State
    }.

items_in(Index, Chunk, Size) -> min(Size, (Index + 1) * Chunk) - Index * Chunk.

%% ---- the coordinator: hands out chunks, collects outcomes -----------------------------------

work(#run{options = #{workers := N}, todo = Todo} = Run, Check) ->
    Workers = [start_worker(Run, Check) || _ <- lists:seq(1, min(N, length(Todo)))],
    loop(Run#run{workers = maps:from_list([{Monitor, Pid} || {Pid, Monitor} <- Workers])}).

loop(#run{workers = Workers} = Run) when map_size(Workers) =:= 0 ->
    finish(Run);
loop(#run{ref = Ref, workers = Workers} = Run) ->
    receive
        {Ref, Pid, ready} ->
            loop(hand_out(Pid, Run));
        {Ref, Pid, {finished, Index, Outcome}} ->
            loop(hand_out(Pid, store(Index, Outcome, Run)));
        {Ref, _Pid, {failed, Reason}} ->
            stop_workers(Run),
            {error, Reason};
        {'DOWN', Monitor, process, _Pid, normal} when is_map_key(Monitor, Workers) ->
            loop(Run#run{workers = maps:remove(Monitor, Workers)});
        {'DOWN', Monitor, process, _Pid, Reason} when is_map_key(Monitor, Workers) ->
            stop_workers(Run#run{workers = maps:remove(Monitor, Workers)}),
            {error, {worker, Reason}}
    end.

hand_out(Pid, #run{todo = [Index | Todo], ref = Ref} = Run) ->
    case budget_left(Run) of
        true ->
            Pid ! {Ref, check, Index},
            Run#run{todo = Todo};
        false ->
            Pid ! {Ref, stop},
            Run
    end;
hand_out(Pid, #run{todo = [], ref = Ref} = Run) ->
    Pid ! {Ref, stop},
    Run.

budget_left(#run{options = #{stop_after := infinity}}) -> true;
budget_left(#run{options = #{stop_after := Budget}, now = Now}) -> Now < Budget.

store(Index, Outcome, #run{options = #{chunk := Chunk}, space = Space} = Run) ->
    ok = faultcheck_enumerate_state:append(Run#run.state, Index, Outcome),
    Items = items_in(Index, Chunk, faultcheck_space:size(Space)),
    show(Run#run{
        finished = (Run#run.finished)#{Index => Outcome},
        now = Run#run.now + Items,
        done = Run#run.done + Items
    }).

show(#run{options = #{clock := Clock, progress := Report, progress_ms := Least}} = Run) ->
    Now = Clock(),
    Last = Run#run.done =:= faultcheck_space:size(Run#run.space),
    case Last orelse Now - Run#run.shown >= Least of
        true ->
            _ = Report(progress(Now - Run#run.started, Run)),
            Run#run{shown = Now};
        false ->
            Run
    end.

progress(Elapsed, #run{done = Done, now = Now, space = Space, options = #{name := Name}}) ->
    Total = faultcheck_space:size(Space),
    Remaining =
        case Now of
            0 -> unknown;
            _ -> Elapsed * (Total - Done) div Now
        end,
    #{
        name => Name,
        done => Done,
        total => Total,
        elapsed_ms => Elapsed,
        remaining_ms => Remaining
    }.

finish(#run{todo = Todo, finished = Finished, space = Space} = Run) ->
    #run{options = #{clock := Clock}, started = Started, done = Done} = Run,
    {Counts, Found} = merge([Outcome || {_, Outcome} <- lists:sort(maps:to_list(Finished))]),
    Result = #{
        counts => Counts,
        found => Found,
        done => Done,
        total => faultcheck_space:size(Space),
        elapsed_ms => Clock() - Started
    },
    case Todo of
        [] -> {ok, Result};
        _ -> {stopped, Result}
    end.

stop_workers(#run{ref = Ref, workers = Workers}) ->
    Stop = fun(Monitor, Pid) ->
        exit(Pid, kill),
        receive
            {'DOWN', Monitor, process, Pid, _} -> ok
        end
    end,
    maps:foreach(Stop, Workers),
    flush(Ref).

flush(Ref) ->
    receive
        {Ref, _, _} -> flush(Ref)
    after 0 -> ok
    end.

%% ---- a worker: one context, chunk after chunk -----------------------------------------------

start_worker(#run{ref = Ref, space = Space, options = Options}, Check) ->
    Owner = self(),
    spawn_monitor(fun() ->
        OwnerDown = erlang:monitor(process, Owner),
        Send = fun(Message) ->
            _ = Owner ! {Ref, self(), Message},
            ok
        end,
        worker(Ref, OwnerDown, Space, Options, Check, Send)
    end).

worker(Ref, OwnerDown, Space, #{start := Start, stop := Stop} = Options, Check, Send) ->
    try Start() of
        Context ->
            Send(ready),
            worker_loop(Ref, OwnerDown, Space, Options, fun(I) -> Check(I, Context) end, Send),
            _ = Stop(Context),
            ok
    catch
        Class:Reason:Stack -> Send({failed, {start, Class, Reason, Stack}})
    end.

worker_loop(Ref, OwnerDown, Space, #{chunk := Chunk} = Options, Check, Send) ->
    receive
        {Ref, check, Index} ->
            First = Index * Chunk,
            Last = First + items_in(Index, Chunk, faultcheck_space:size(Space)) - 1,
            case check_items(First, Last, Space, Check, []) of
                {ok, Outcome} ->
                    Send({finished, Index, Outcome}),
                    worker_loop(Ref, OwnerDown, Space, Options, Check, Send);
                {error, Reason} ->
                    Send({failed, Reason})
            end;
        {Ref, stop} ->
            ok;
        {'DOWN', OwnerDown, process, _, _} ->
            ok
    end.

check_items(I, Last, _Space, _Check, Outcomes) when I > Last ->
    {ok, merge(lists:reverse(Outcomes))};
check_items(I, Last, Space, Check, Outcomes) ->
    Item = faultcheck_space:at(I, Space),
    try Check(Item) of
        {Counts, Found} when is_map(Counts), is_list(Found) ->
            check_items(I + 1, Last, Space, Check, [{Counts, Found} | Outcomes]);
        Other ->
            {error, {check, Item, error, {bad_outcome, Other}, []}}
    catch
        Class:Reason:Stack -> {error, {check, Item, Class, Reason, Stack}}
    end.

merge(Outcomes) ->
    Add = fun(Key, N, Counts) -> maps:update_with(Key, fun(M) -> M + N end, N, Counts) end,
    Counts = lists:foldl(fun({C, _}, Acc) -> maps:fold(Add, Acc, C) end, #{}, Outcomes),
    {Counts, lists:append([Found || {_, Found} <- Outcomes])}.

%% ---- text -----------------------------------------------------------------------------------

%% @doc A progress function for terminals: one line on standard error.
-spec print_progress(progress()) -> ok.
print_progress(#{name := Name, done := Done, total := Total, remaining_ms := Remaining}) ->
    io:format(
        standard_error,
        "~s: ~b of ~b (~b %)~s~n",
        [label(Name), Done, Total, Done * 100 div max(1, Total), left(Done, Total, Remaining)]
    ).

left(Total, Total, _Remaining) -> "";
left(_Done, _Total, unknown) -> "";
left(_Done, _Total, Ms) when Ms < 90000 -> io_lib:format(", about ~b s left", [Ms div 1000 + 1]);
left(_Done, _Total, Ms) -> io_lib:format(", about ~b min left", [(Ms + 59999) div 60000]).

label(Name) when is_atom(Name) -> atom_to_list(Name);
label(Name) -> io_lib:format("~tp", [Name]).

%% @doc One line for a reason.
-spec format_error(reason()) -> unicode:chardata().
format_error({check, Item, Class, Reason, _Stack}) ->
    io_lib:format("the check of item ~0tp ended with ~p ~0tp", [Item, Class, Reason]);
format_error({start, Class, Reason, _Stack}) ->
    io_lib:format("a worker could not start its system: ~p ~0tp", [Class, Reason]);
format_error({worker, Reason}) ->
    io_lib:format("a worker ended unexpectedly: ~0tp", [Reason]);
format_error({state_file, _File, _Reason} = Error) ->
    faultcheck_enumerate_state:format_error(Error).

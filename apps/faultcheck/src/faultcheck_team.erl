%% @doc Workers: child VMs that run the tests of a property side by side, each with a system under
%% test of its own.
%%
%% The tests are given out in blocks, in order. Once one has failed, only those with smaller
%% numbers are finished. A worker that is killed from outside (SIGKILL) loses the test it was in,
%% which is run again, by whoever asks first; one that dies in another way, or hangs, or is killed
%% in the same test twice, has found a failure. In the end the run itself (faultcheck_known) tells
%% what came of the tests, and runs the first that failed again: so what it shows does not depend
%% on the number of workers, nor on which of them was faster.
-module(faultcheck_team).

-export([new/2, known/2, stop/1]).
-export_type([team/0, config/0]).

-type config() :: #{
    child := faultcheck_child:options(),
    print := fun((iodata()) -> ok),
    terminal := boolean(),
    verbose := boolean()
}.
-opaque team() :: #{members := [pid()], config := config()}.
-type block() :: {First :: pos_integer(), Last :: pos_integer()}.

-define(MOST_IN_A_BLOCK, 32).
-define(BLOCKS_PER_WORKER, 8).
-define(FIRST_PROGRESS_MS, 2000).
-define(PROGRESS_MS, 10000).
-define(TERMINAL_PROGRESS_MS, 500).

-record(work, {
    job :: faultcheck_property:job(),
    config :: config(),
    members :: [pid()],
    %% those that run a share now
    busy :: [pid()],
    known = #{} :: faultcheck_known:known(),
    %% the first number not given out yet, and the last there is once it is known
    next = 1 :: pos_integer(),
    limit = none :: none | pos_integer() | infinity,
    block = 1 :: pos_integer(),
    %% what each worker has been given
    given = #{} :: #{pid() => block()},
    %% what a worker that died has left
    back = [] :: [block()],
    %% tests in which a worker was killed once
    killed = [] :: [pos_integer()],
    searching = #{} :: #{pid() => map()},
    began :: integer(),
    shown :: integer(),
    deadline = infinity :: integer() | infinity,
    interrupted = false :: boolean(),
    %% nothing more is given out: interrupted, or this property cannot be shared or not be run;
    %% then the run itself does the rest, and tells why it cannot
    ended = false :: boolean()
}).

%% @doc So many workers; none when one is enough. Their VMs start with the first property.
-spec new(pos_integer(), config()) -> team().
new(1, Config) ->
    #{members => [], config => Config};
new(Count, #{child := Child} = Config) ->
    Members = [
        spawn_link(fun() -> member("worker-" ++ integer_to_list(N), own_cover(N, Child)) end)
     || N <- lists:seq(1, Count)
    ],
    #{members => Members, config => Config}.

own_cover(N, #{cover := #{file := File} = Cover} = Child) ->
    Own = filename:rootname(File) ++ "-" ++ integer_to_list(N) ++ filename:extension(File),
    Child#{cover := Cover#{file := Own}};
own_cover(_N, Child) ->
    Child.

%% @doc Ends the workers.
-spec stop(team()) -> ok.
stop(#{members := Members}) ->
    Ended = [{Pid, erlang:monitor(process, Pid)} || Pid <- Members],
    lists:foreach(
        fun({Pid, _}) ->
            Pid ! faultcheck_interrupt,
            Pid ! stop
        end,
        Ended
    ),
    lists:foreach(
        fun({Pid, Monitor}) ->
            receive
                {'DOWN', Monitor, process, Pid, _} -> ok
            end
        end,
        Ended
    ).

%% ---- giving out tests ---------------------------------------------------------------------

%% @doc What workers find out about the tests of a job.
-spec known(faultcheck_property:job(), team()) -> faultcheck_known:known() | interrupted.
known(_Job, #{members := []}) ->
    #{};
known(Job, #{members := Members, config := Config}) ->
    Now = now_ms(),
    lists:foreach(fun(Pid) -> Pid ! {work, self(), Job#{task := share}} end, Members),
    Work = loop(#work{
        job = Job,
        config = Config,
        members = Members,
        busy = Members,
        began = Now,
        shown = Now + first_interval(Config)
    }),
    ok = clear(Work),
    case Work of
        #work{interrupted = true} -> interrupted;
        #work{known = Known} -> Known
    end.

%% The time begins when the first worker is ready.
deadline(#{time := Seconds}) -> now_ms() + 1000 * Seconds;
deadline(_) -> infinity.

loop(#work{busy = []} = Work) ->
    %% A worker that died may have left tests behind when all others were done.
    case to_do(Work) of
        {none, _} ->
            Work;
        {_, _} ->
            #work{members = [Pid | _], job = Job} = Work,
            Pid ! {work, self(), Job#{task := share}},
            loop(Work#work{busy = [Pid]})
    end;
loop(Work) ->
    receive
        {worker, Pid, Message} ->
            loop(show(said(Message, Pid, Work)));
        faultcheck_interrupt ->
            lists:foreach(fun(Pid) -> Pid ! faultcheck_interrupt end, Work#work.busy),
            loop(Work#work{interrupted = true, ended = true})
    end.

said({started, #{numtests := Numtests}}, _Pid, #work{limit = none, job = Job} = Work) ->
    Share = Numtests div (?BLOCKS_PER_WORKER * length(Work#work.members)),
    Deadline = deadline(Job),
    Work#work{
        limit = limit(Numtests, Deadline),
        deadline = Deadline,
        block = max(1, min(?MOST_IN_A_BLOCK, Share))
    };
said({started, _}, _Pid, Work) ->
    Work;
said(want_tests, Pid, Work) ->
    {Block, Next} = to_do(Work),
    Pid ! {tests, Block},
    case Block of
        none -> Next;
        _ -> Next#work{given = (Next#work.given)#{Pid => Block}}
    end;
said({tested, Number, Outcome}, _Pid, #work{known = Known} = Work) ->
    Work#work{known = Known#{Number => Outcome}};
said({searching, How}, Pid, #work{searching = Searching} = Work) ->
    Work#work{searching = Searching#{Pid => How}};
said({lost, Number, How}, Pid, Work) ->
    lost(Number, How, left(Pid, Work));
said(gave_up, _Pid, Work) ->
    Work#work{ended = true};
said(idle, Pid, #work{busy = Busy} = Work) ->
    left(Pid, Work#work{busy = lists:delete(Pid, Busy)}).

limit(Numtests, infinity) -> Numtests;
limit(_Numtests, _Deadline) -> infinity.

%% The next block, and what is left then: nothing behind a test that failed.
to_do(#work{ended = true} = Work) ->
    {none, Work};
to_do(#work{back = [{First, Last} | Back]} = Work) ->
    case min(Last, last(Work)) of
        End when End >= First -> {{First, End}, Work#work{back = Back}};
        _ -> to_do(Work#work{back = Back})
    end;
to_do(#work{next = First, block = Size} = Work) ->
    case min(First + Size - 1, last(Work)) of
        Last when Last >= First -> {{First, Last}, Work#work{next = Last + 1}};
        _ -> {none, Work}
    end.

last(#work{limit = none}) ->
    0;
last(#work{limit = Limit, known = Known, next = Next, deadline = Deadline}) ->
    Failed =
        case faultcheck_known:doubt(Known) of
            {Number, _} -> Number - 1;
            none -> infinity
        end,
    InTime =
        case Deadline =:= infinity orelse now_ms() < Deadline of
            true -> infinity;
            false -> Next - 1
        end,
    lists:min([Limit, Failed, InTime]).

%% What a worker has not told of goes back.
left(Pid, #work{given = Given, known = Known, back = Back} = Work) ->
    case Given of
        #{Pid := {First, Last}} ->
            Open = [{N, N} || N <- lists:seq(First, Last), not is_map_key(N, Known)],
            Work#work{given = maps:remove(Pid, Given), back = lists:sort(Open ++ Back)};
        #{} ->
            Work
    end.

%% A worker ended in a test.
lost(none, _How, Work) ->
    Work;
lost(Number, {ended, {signal, 9}}, #work{killed = Killed} = Work) ->
    case lists:member(Number, Killed) of
        false -> Work#work{killed = [Number | Killed]};
        true -> lost(Number, {ended, killed_twice}, Work)
    end;
lost(Number, How, #work{known = Known} = Work) ->
    Work#work{known = Known#{Number => faultcheck_known:lost(words(How))}}.

words(hang) -> "it made no progress";
words({ended, killed_twice}) -> "the child VM was killed twice";
words({ended, Ending}) -> lists:flatten(["the child VM ", faultcheck_reason:ending(Ending)]).

%% ---- progress -----------------------------------------------------------------------------

show(#work{config = #{verbose := true, terminal := Terminal} = Config, shown = Due} = Work) ->
    Now = now_ms(),
    case Now >= Due of
        true ->
            Line = line(Now, Work),
            ok = (maps:get(print, Config))(
                case Terminal of
                    true -> ["\r\e[K", Line];
                    false -> [Line, $\n]
                end
            ),
            Work#work{shown = Now + interval(Config)};
        false ->
            Work
    end;
show(Work) ->
    Work.

line(Now, #work{job = #{module := M, function := F}, known = Known, began = Began} = Work) ->
    Goal =
        case Work#work.limit of
            infinity -> {ms, Work#work.deadline - Began};
            none -> {tests, 1};
            Limit -> {tests, Limit}
        end,
    Searches = [
        io_lib:format("; search: ~b runs of ~b, nearest ~p", [Runs, Most, Nearest])
     || #{runs := Runs, most := Most, nearest := Nearest} <- maps:values(Work#work.searching)
    ],
    [faultcheck_report:progress({M, F}, map_size(Known), Now - Began, Goal), Searches].

first_interval(#{terminal := true}) -> ?FIRST_PROGRESS_MS;
first_interval(_) -> ?PROGRESS_MS.

interval(#{terminal := true}) -> ?TERMINAL_PROGRESS_MS;
interval(_) -> ?PROGRESS_MS.

clear(#work{config = #{terminal := true, verbose := true, print := Print}}) -> Print("\r\e[K");
clear(_) -> ok.

now_ms() -> erlang:monotonic_time(millisecond).

%% ---- a worker: keeps a child VM, starts another when it dies ------------------------------

-spec member(string(), faultcheck_child:options()) -> ok.
member(Name, Options) -> idle(none, {Name, 0, Options}).

idle(Child, Start) ->
    receive
        {work, From, Job} ->
            {NextChild, NextStart} = work(Child, Job, From, Start),
            From ! {worker, self(), idle},
            idle(NextChild, NextStart);
        faultcheck_interrupt ->
            idle(Child, Start);
        stop when Child =:= none ->
            ok;
        stop ->
            faultcheck_child:stop(Child)
    end.

work(none, Job, From, {Name, Count, Options} = Start) ->
    case faultcheck_child:start(Name ++ "." ++ integer_to_list(Count), Options) of
        {ok, Child} -> work(Child, Job, From, {Name, Count + 1, Options});
        {error, _} ->
            From ! {worker, self(), gave_up},
            {none, Start}
    end;
work(Child, Job, From, Start) ->
    Say = fun(Message) ->
        From ! {worker, self(), Message},
        ok
    end,
    case events(Child, faultcheck_child:run(Child, Job), Job, Say) of
        done ->
            {Child, Start};
        interrupted ->
            ok = faultcheck_child:close(Child),
            {none, Start};
        lost ->
            work(none, Job, From, Start)
    end.

events(Child, Watch, Job, Say) ->
    case faultcheck_child:next(Child, Watch) of
        {want_tests, Next} ->
            ok = Say(want_tests),
            receive
                {tests, _} = Tests ->
                    ok = faultcheck_child:send(Child, Tests),
                    events(Child, Next, Job, Say);
                faultcheck_interrupt ->
                    interrupted
            end;
        {Said, Next} when element(1, Said) =:= started; element(1, Said) =:= tested;
                          element(1, Said) =:= searching ->
            ok = Say(Said),
            events(Child, Next, Job, Say);
        {{ended, _} = How, _} ->
            ok = Say({lost, current(Child, Job), How}),
            lost;
        {hang, _} ->
            Current = current(Child, Job),
            _ = faultcheck_child:quit(Child),
            ok = Say({lost, Current, hang}),
            lost;
        {interrupted, _} ->
            interrupted;
        {{result, #{status := Status}}, _} when Status =:= passed; Status =:= failed ->
            done;
        {{Ended, _}, _} when Ended =:= result; Ended =:= died ->
            ok = Say(gave_up),
            done;
        {_, Next} ->
            events(Child, Next, Job, Say)
    end.

%% The test that the child was in.
current(Child, #{module := M, function := F}) ->
    case faultcheck_journal:read(faultcheck_child:journal(Child)) of
        {ok, #{property := {M, F}, test := Test}} -> Test;
        _ -> none
    end.

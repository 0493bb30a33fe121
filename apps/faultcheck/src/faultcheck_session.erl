%% @doc A child VM to give jobs to, started when it is needed and again when the last one died,
%% and the display of what its jobs print.
-module(faultcheck_session).

-export([new/1, run/2, stop/1, last_journal/1, last_log/1, print/2]).
-export_type([session/0, config/0, answer/0, info/0]).

-type config() :: #{
    child := faultcheck_child:options(),
    print := fun((iodata()) -> ok),
    %% whether a line of progress may be rewritten in place
    terminal := boolean(),
    verbose := boolean()
}.
-opaque session() :: #{
    config := config(),
    child := faultcheck_child:child() | none,
    %% the one whose journal and log tell what happened last
    last := faultcheck_child:child() | none,
    number := non_neg_integer()
}.
%% What a job said before it ended, in whatever way.
-type info() :: #{
    limit => pos_integer(),
    numtests => pos_integer(),
    doc => string(),
    tests => non_neg_integer(),
    searching => true,
    failed => faultcheck_property:failure()
}.
-type answer() ::
    {result, faultcheck_property:result(), info()}
    | {dead, cb_guard:ending(), info()}
    | {hang, info()}
    | {no_child, string()}
    | interrupted.

-define(FIRST_PROGRESS_MS, 2000).
-define(PROGRESS_MS, 10000).

-spec new(config()) -> session().
new(Config) ->
    #{config => Config, child => none, last => none, number => 0}.

-spec run(faultcheck_property:job(), session()) -> {answer(), session()}.
run(Job, #{child := none, number := Number, config := #{child := Options}} = Session) ->
    Name = "child-" ++ integer_to_list(Number),
    case faultcheck_child:start(Name, Options) of
        {ok, Child} ->
            run(Job, Session#{child := Child, last := Child, number := Number + 1});
        {error, Line} ->
            {{no_child, Line}, Session}
    end;
run(Job, #{child := Child} = Session) ->
    Watch = faultcheck_child:run(Child, Job),
    Now = now_ms(),
    Shown = #{
        job => Job,
        began => Now,
        %% when to show progress next, and whether its line is on the screen now
        next => Now + first_interval(Session),
        open => false,
        %% what was printed last was no line end; PropEr's dots so far
        midline => false,
        dots => 0
    },
    loop(Watch, #{}, Shown, Session).

loop(Watch, Info, #{job := Job} = Shown, #{child := Child} = Session) ->
    case faultcheck_child:next(Child, Watch) of
        {{output, Text}, Next} ->
            loop(Next, Info, shown(Text, clear(Shown, Session), Session), Session);
        {{started, Started}, Next} ->
            loop(Next, maps:merge(Info, Started), Shown, Session);
        {{failed, Failure}, Next} ->
            loop(Next, Info#{failed => Failure}, Shown, Session);
        {{progress, Tests}, Next} ->
            loop(Next, Info#{tests => Tests}, progress(Tests, Info, Shown, Session), Session);
        {{shrinking, How}, Next} ->
            Line = faultcheck_report:shrinking_progress(property(Job), How),
            loop(Next, Info, progress_line(Line, Shown, Session), Session);
        {{searching, How}, Next} ->
            Test = maps:get(tests, Info, 0),
            Line = faultcheck_report:searching_progress(property(Job), Test, How),
            Searching = Info#{searching => true},
            loop(Next, Searching, progress_line(Line, Shown, Session), Session);
        {{result, Result}, _} ->
            ok = end_line(Shown, Session),
            {{result, Result, Info}, Session};
        {{died, Line}, _} ->
            ok = end_line(Shown, Session),
            Died = #{status => error, ms => 0, reasons => [Line]},
            {{result, Died#{tests => maps:get(tests, Info, 0)}, Info}, Session};
        {{ended, Ending}, _} ->
            ok = end_line(catch_up(Info, Shown, Session), Session),
            {{dead, Ending, Info}, Session#{child := none}};
        {hang, _} ->
            ok = end_line(catch_up(Info, Shown, Session), Session),
            _ = faultcheck_child:quit(Child),
            {{hang, Info}, Session#{child := none}};
        {interrupted, _} ->
            ok = end_line(Shown, Session),
            ok = faultcheck_child:close(Child),
            {interrupted, Session#{child := none}}
    end.

shown(Text, #{dots := Dots} = Shown, Session) ->
    ok = output(Text, Session),
    After = Shown#{midline := midline(Text, Session)},
    case Text of
        <<Dot>> when Dot =:= $.; Dot =:= $x -> After#{dots := Dots + 1};
        _ -> After
    end.

%% The last dots die with the VM that printed them; the journal knows how many there were.
catch_up(Info, #{dots := Dots, job := Job} = Shown, Session) ->
    Dotted = faultcheck_property:dotted(Job, maps:get(numtests, Info, 1)),
    case {Dotted, faultcheck_journal:read(last_journal(Session))} of
        {true, {ok, #{test := Test}}} when Test - 1 > Dots ->
            shown(binary:copy(<<".">>, Test - 1 - Dots), Shown, Session);
        _ ->
            Shown
    end.

midline(Text, #{config := #{verbose := Verbose}}) ->
    Verbose andalso binary:last(Text) =/= $\n.

end_line(Shown, Session) ->
    case clear(Shown, Session) of
        #{midline := true} -> print("\n", Session);
        _ -> ok
    end.

output(Text, #{config := #{verbose := true, print := Print}}) -> Print(Text);
output(_Text, _Session) -> ok.

%% @doc Shows a text of the runner's own.
-spec print(iodata(), session()) -> ok.
print(Text, #{config := #{print := Print}}) -> Print(Text).

%% Nothing is said while the failing test is shrunk or a search runs: these have lines of their own.
progress(_Tests, #{failed := _}, Shown, _Session) ->
    Shown;
progress(_Tests, #{searching := true}, Shown, _Session) ->
    Shown;
progress(Tests, Info, #{began := Began, job := Job} = Shown, Session) ->
    Goal = goal(Job, Info),
    Line = faultcheck_report:progress(property(Job), Tests, now_ms() - Began, Goal),
    progress_line(Line, Shown, Session).

%% Not more often than somebody wants to read.
progress_line(Line, #{next := Next} = Shown, Session) ->
    #{config := #{verbose := Verbose, terminal := Terminal}} = Session,
    Now = now_ms(),
    case Verbose andalso Now >= Next of
        true ->
            _ = maps:get(midline, Shown) andalso print("\n", Session),
            show_progress(Line, Terminal, Session),
            Shown#{next := Now + interval(Terminal), open := Terminal, midline := false};
        false ->
            Shown
    end.

property(#{module := M, function := F}) -> {M, F}.

goal(#{time := Seconds}, _) -> {ms, 1000 * Seconds};
goal(_, Info) -> {tests, maps:get(numtests, Info, 1)}.

first_interval(#{config := #{terminal := true}}) -> ?FIRST_PROGRESS_MS;
first_interval(_) -> ?PROGRESS_MS.

interval(true) -> 500;
interval(false) -> ?PROGRESS_MS.

show_progress(Line, true, Session) -> print(["\r\e[K", Line], Session);
show_progress(Line, false, Session) -> print([Line, $\n], Session).

%% Takes away the line of progress that is being rewritten.
clear(#{open := true} = Shown, Session) ->
    ok = print("\r\e[K", Session),
    Shown#{open := false};
clear(Shown, _Session) ->
    Shown.

now_ms() -> erlang:monotonic_time(millisecond).

%% @doc Ends the child VM, if there is one.
-spec stop(session()) -> session().
stop(#{child := none} = Session) ->
    Session;
stop(#{child := Child} = Session) ->
    ok = faultcheck_child:stop(Child),
    Session#{child := none}.

%% @doc The journal of the child that ran the last job.
-spec last_journal(session()) -> file:filename().
last_journal(#{last := Child}) -> faultcheck_child:journal(Child).

%% @doc The end of what the child that ran the last job printed.
-spec last_log(session()) -> string().
last_log(#{last := Child}) -> faultcheck_child:log(Child).

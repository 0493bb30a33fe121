%% @doc What to make of a child VM that died or hung in the middle of a test.
%%
%% The journal names the test and the commands begun. A new child runs that test again from its
%% seed, C code now in processes of its own (transport port, reset by fork), so that a crash or a
%% hang is an ordinary failure: confirmed first, then shrunk. What does not repeat is reported as
%% flaky, with the commands of the journal.
-module(faultcheck_rescue).

-export([result/4, timeout/3]).

-type how() :: {dead, cb_guard:ending()} | {hang, Ms :: pos_integer()}.
-type session() :: faultcheck_session:session().
-type found() :: {faultcheck_property:result() | interrupted, session()}.

%% A timeout counts only if it repeats with ten times the limit.
-define(PATIENCE, 10).
-define(GRACE_MS, 1000).

%% @doc The result of a job that ended How, in place of the one that it could not give.
-spec result(how(), faultcheck_session:info(), faultcheck_property:job(), session()) -> found().
result(How, Info, #{module := M, function := F, task := Task} = Job, Session) ->
    Log = faultcheck_session:last_log(Session),
    case {Task, faultcheck_journal:read(faultcheck_session:last_journal(Session))} of
        {{Kind, CounterExample}, _} when Kind =:= check; Kind =:= replay ->
            Story = story(How, Log, #{commands => []}),
            checked(CounterExample, How, Story, Job, Session);
        {{report, _, _}, _} ->
            {#{status => error, tests => 0, ms => 0, reasons => story(How, Log, #{commands => []})},
                Session};
        {_, {ok, #{property := {M, F}} = Entry}} ->
            {Found, Next} = again(How, Entry, story(How, Log, Entry), Job, Session),
            {with_tests(Found, Entry), Next};
        {_, _} ->
            Line = "the child VM " ++ ended(How) ++ " before the first test",
            Result = #{status => unstarted, reasons => [Line | log_lines(Log)]},
            {with_tests(Result, #{test => maps:get(tests, Info, 0)}), Session}
    end.

with_tests(interrupted, _) -> interrupted;
with_tests(Result, #{test := Test}) -> maps:merge(#{ms => 0}, Result#{tests => Test}).

ended({dead, Ending}) -> faultcheck_reason:ending(Ending);
ended({hang, Ms}) -> io_lib:format("made no progress for ~b ms", [Ms]).

%% The lines that tell what happened, as far as it is known without running it again.
story(How, Log, #{commands := Commands}) ->
    During =
        case Commands of
            [] -> "";
            [{parallel, _, _, _}] -> " while commands ran at once";
            _ -> " in " ++ lists:last(faultcheck_case:lines([Commands]))
        end,
    [lists:flatten(["the child VM ", ended(How), During]) | log_lines(Log)].

log_lines("") -> [];
log_lines(Log) -> ["it printed: " ++ L || L <- lists:sublist(string:split(Log, "\n", all), 5)].

%% C code outside this VM, each test in a process of its own.
apart(Factor) ->
    [
        {c_bridge, force_transport, port},
        {c_bridge, force_reset, fork},
        {c_bridge, timeout_factor, Factor}
    ].

%% The limit of the C bridge should strike first.
patient(Limit, Factor) -> Limit * Factor + ?GRACE_MS.

patience({hang, _}) -> ?PATIENCE;
patience({dead, _}) -> 1.

job(Task, Factor, Job) ->
    Limit = maps:get(limit, Job, 10000),
    Again = Job#{task := Task, env => apart(Factor), limit => patient(Limit, Factor)},
    maps:without([time, stats], Again).

again(How, #{test := Number, size := Size} = Entry, Story, Job, Session) ->
    Confirm = job({confirm, Number, Size}, patience(How), Job),
    case faultcheck_session:run(Confirm, Session) of
        {{result, #{status := failed} = Failure, _}, Next} ->
            Notes = beginning(Entry, Failure),
            shrunk(How, Failure#{notes => Notes, story => Story}, Job, Next);
        {{result, #{status := passed}, _}, Next} ->
            {lost(Entry, Story), Next};
        {{result, #{reasons := Reasons} = Other, _}, Next} ->
            {Other#{reasons := Story ++ Reasons}, Next};
        {{no_child, Line}, Next} ->
            {#{status => unstarted, reasons => Story ++ [Line]}, Next};
        {interrupted, Next} ->
            {interrupted, Next};
        {_DeadOrHang, Next} ->
            hopeless(Entry, Story, Job, Next)
    end.

%% The commands of the test are those of the journal, and may go on behind them.
beginning(#{attempt := 0, cut := false, commands := [_ | _] = Journaled}, Failure) ->
    case faultcheck_case:commands(maps:get(original, Failure)) of
        {ok, Commands} ->
            case lists:prefix(Journaled, Commands) of
                true -> [];
                false -> ["the test made again from its seed has other commands than the journal"]
            end;
        none ->
            []
    end;
beginning(_, _) ->
    [].

shrunk(How, #{test := Number, size := Size, story := Story} = Failure0, Job, Session) ->
    Failure = maps:remove(story, Failure0),
    case faultcheck_session:run(job({repeat, Number, Size}, 1, Job), Session) of
        {{result, #{status := failed} = Shrunk, _}, Next} ->
            settled(How, Failure, maps:merge(Failure, Shrunk), Job, Next);
        {{result, #{status := flaky} = Flaky, _}, Next} ->
            {maps:merge(Failure#{reasons := Story}, Flaky), Next};
        {interrupted, Next} ->
            {interrupted, Next};
        {_, Next} ->
            Note = "shrinking ended with its VM, so this is the original",
            {Failure#{notes := [Note | maps:get(notes, Failure)]}, Next}
    end.

%% A sequence shrunk with the ordinary limit may just be slow: it must hang with the long one too.
settled({dead, _}, _Failure, Shrunk, _Job, Session) ->
    {Shrunk, Session};
settled({hang, _}, Failure, #{shrunk := CounterExample} = Shrunk, Job, Session) ->
    case faultcheck_session:run(job({check, CounterExample}, ?PATIENCE, Job), Session) of
        {{result, #{status := failed}, _}, Next} ->
            {Shrunk, Next};
        {interrupted, Next} ->
            {interrupted, Next};
        {_, Next} ->
            Note = "the shrunk commands end within ten times the limit, so this is the original",
            {Failure#{notes := [Note | maps:get(notes, Failure)]}, Next}
    end.

%% A parallel case is one record of the journal.
counterexample([{parallel, _, _, _} = Case]) -> [Case];
counterexample(Commands) -> [Commands].

%% It passed when run again.
lost(#{test := Number, size := Size, commands := Commands}, Story) ->
    #{
        status => flaky,
        test => Number,
        size => Size,
        flaky => {0, 1},
        shrunk => counterexample(Commands),
        original => counterexample(Commands),
        reasons => Story,
        notes => [
            "not reproduced with C code in a process of its own; the commands are the journal's"
        ]
    }.

%% It ended its VM again although C code ran elsewhere: something else than c_bridge ran it.
hopeless(#{test := Number, size := Size, commands := Commands}, Story, Job, Session) ->
    Failure = #{
        status => failed,
        test => Number,
        size => Size,
        reasons => Story,
        notes => ["not shrunk: it ends its VM with transport port, too"]
    },
    case {Commands, faultcheck_session:run(job({generate, Number, Size}, 1, Job), Session)} of
        {_, {interrupted, Next}} ->
            {interrupted, Next};
        {[_ | _], {_, Next}} ->
            {Failure#{shrunk => counterexample(Commands), original => counterexample(Commands)},
                Next};
        {[], {{result, #{original := Values}, _}, Next}} ->
            {Failure#{shrunk => Values, original => Values}, Next};
        {[], {_, Next}} ->
            {Failure, Next}
    end.

%% A stored counterexample that ended its VM.
checked(CounterExample, How, Story, #{task := Task} = Job, Session) ->
    Failure = #{
        status => failed,
        tests => 1,
        ms => 0,
        original => CounterExample,
        shrunk => CounterExample,
        reasons => Story
    },
    case faultcheck_session:run(job(Task, patience(How), Job), Session) of
        {{result, #{status := passed}, _}, Next} ->
            {Failure#{status := flaky, flaky => {0, 1}}, Next};
        {{result, #{status := failed} = Result, _}, Next} ->
            {Result, Next};
        {interrupted, Next} ->
            {interrupted, Next};
        {_, Next} ->
            {Failure, Next}
    end.

%% @doc A failure by a timeout of C code, tried again with more time: flaky if it then passes.
-spec timeout(faultcheck_property:result(), faultcheck_property:job(), session()) -> found().
timeout(#{test := Number, size := Size} = Failure, Job, Session) ->
    Limit = maps:get(limit, Job, 10000),
    Patient = (maps:without([time, stats], Job))#{
        task := {confirm, Number, Size},
        env => [{c_bridge, timeout_factor, ?PATIENCE}],
        limit => patient(Limit, ?PATIENCE)
    },
    case faultcheck_session:run(Patient, Session) of
        {{result, #{status := passed}, _}, Next} ->
            Original = maps:get(original, Failure),
            Notes = ["it passes with ten times the time limit"],
            {Failure#{status := flaky, flaky => {0, 1}, shrunk := Original, notes => Notes}, Next};
        {interrupted, Next} ->
            {interrupted, Next};
        {_, Next} ->
            {Failure, Next}
    end.

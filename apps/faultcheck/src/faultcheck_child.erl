%% @doc Starts, watches and ends the child VM in which properties run.
%%
%% The process that starts a child gets its messages: next/2 waits for the next thing the child
%% says, for its end, or for a word from elsewhere, and tells a hang from slow work by the journal:
%% while a test runs, the journal must move within the limit.
-module(faultcheck_child).

-export([start/2, run/2, send/2, next/2, quit/1, stop/1, close/1, log/1, journal/1]).
-export_type([child/0, event/0, options/0]).

-type options() :: #{
    %% files of this run: the log and the journal
    work_dir := file:filename(),
    paths := [file:filename()],
    env := [{atom(), atom(), term()}],
    config => file:filename(),
    cover => #{dirs := [file:filename()], file := file:filename()}
}.
-type child() :: #{
    guard := cb_guard:guard(),
    os_pid := pos_integer(),
    log := file:filename(),
    journal := file:filename(),
    versions := faultcheck_versions:versions()
}.
-type event() ::
    faultcheck_worker:from_worker()
    | {ended, cb_guard:ending()}
    | interrupted
    | hang.
%% What next/2 needs to see a hang: the state of the journal, since when, and the limit.
-type watch() :: #{limit := pos_integer(), seen := binary(), since := integer()}.

-define(START_MS, 60000).
-define(QUIT_MS, 1000).
-define(STOP_MS, 20000).
%% Before the first test a property may compile and load what it tests.
-define(SETUP_FACTOR, 12).
-define(STACK_KILOWORDS, "4096").

%% @doc A child that is ready for jobs. The error is a line for the user.
-spec start(string(), options()) -> {ok, child()} | {error, string()} | interrupted.
start(Name, #{work_dir := Dir} = Options) ->
    Log = filename:join(Dir, Name ++ ".log"),
    Journal = filename:join(Dir, Name ++ ".journal"),
    ok = filelib:ensure_dir(Log),
    ok = file:write_file(Log, ""),
    Settings = #{log => Log, env => [{"ERL_CRASH_DUMP_SECONDS", "0"}]},
    case cb_guard:start(erl(), arguments(), Settings) of
        {ok, Guard} -> greet(Guard, Log, Journal, Options);
        {error, Reason} -> {error, text("no child VM: ~ts", [cb_error:format(Reason)])}
    end.

erl() -> filename:join([code:root_dir(), "bin", "erl"]).

%% Large scheduler stacks: C code called through the NIF runs on them.
arguments() ->
    Ebins = [filename:dirname(code:which(M)) || M <- [?MODULE, cb_guard]],
    Stacks = ["+sss", ?STACK_KILOWORDS, "+sssdcpu", ?STACK_KILOWORDS],
    ["-boot", "no_dot_erlang", "-noinput" | Stacks] ++
        ["-pa" | Ebins] ++ ["-s", "faultcheck_worker", "main"].

greet(Guard, Log, Journal, Options) ->
    case cb_guard:next_event(Guard, ?START_MS) of
        {data, Packet} ->
            {hello, OsPid} = binary_to_term(Packet),
            Setup = #{
                paths => maps:get(paths, Options),
                env => maps:get(env, Options),
                config => maps:get(config, Options, none),
                journal => Journal,
                cover => maps:get(cover, Options, none)
            },
            ok = cb_guard:send(Guard, term_to_binary({setup, Setup})),
            Child = #{guard => Guard, os_pid => OsPid, log => Log, journal => Journal},
            ready(Child);
        {ended, Ending} ->
            {error, text("the child VM ~ts: ~ts", [faultcheck_reason:ending(Ending), tail(Log)])};
        timeout ->
            ok = cb_guard:close(Guard),
            {error, text("the child VM did not start in ~b s", [?START_MS div 1000])}
    end.

ready(#{guard := Guard, log := Log} = Child) ->
    case cb_guard:next_event(Guard, ?START_MS) of
        {data, Packet} ->
            case binary_to_term(Packet) of
                {ready, Versions} ->
                    {ok, Child#{versions => Versions}};
                {setup_failed, Line} ->
                    ok = cb_guard:close(Guard),
                    {error, Line}
            end;
        {ended, Ending} ->
            {error, text("the child VM ~ts: ~ts", [faultcheck_reason:ending(Ending), tail(Log)])};
        timeout ->
            ok = cb_guard:close(Guard),
            {error, "the child VM did not get ready"}
    end.

tail(Log) ->
    {ok, Text} = file:read_file(Log),
    Length = min(byte_size(Text), 500),
    string:trim(binary:part(Text, byte_size(Text) - Length, Length)).

%% @doc Gives a job. Limit bounds the time until the property has begun its first test, too.
-spec run(child(), faultcheck_property:job()) -> watch().
run(#{guard := Guard, journal := Journal}, Job) ->
    ok = cb_guard:send(Guard, term_to_binary({run, Job})),
    Limit = maps:get(limit, Job, 10000) * ?SETUP_FACTOR,
    #{limit => Limit, seen => faultcheck_journal:progress(Journal), since => now_ms()}.

%% @doc Tells a child something while its job runs.
-spec send(child(), faultcheck_worker:to_worker()) -> ok.
send(#{guard := Guard}, Message) -> cb_guard:send(Guard, term_to_binary(Message)).

%% @doc The next event of a running job.
-spec next(child(), watch()) -> {event(), watch()}.
next(#{guard := Guard} = Child, #{limit := Limit} = Watch) ->
    receive
        faultcheck_interrupt ->
            {interrupted, Watch};
        {Port, _} = Message when is_port(Port) ->
            case cb_guard:event(Guard, Message) of
                {data, Packet} -> said(binary_to_term(Packet), Watch);
                {ended, _} = Ended -> {Ended, Watch};
                none -> next(Child, Watch)
            end
    after max(20, min(500, Limit div 8)) ->
        still(Child, Watch)
    end.

said({started, #{limit := Limit}} = Event, Watch) ->
    {Event, Watch#{begun => Limit}};
said(Event, Watch) ->
    {Event, Watch}.

still(#{journal := Journal} = Child, #{seen := Seen, since := Since, limit := Limit} = Watch) ->
    Now = now_ms(),
    case faultcheck_journal:progress(Journal) of
        Seen when Now - Since > Limit -> {hang, Watch};
        Seen -> next(Child, Watch);
        Moved -> next(Child, moving(Watch#{seen := Moved, since := Now}))
    end.

%% The first test has begun: from now on the property's own limit counts.
moving(#{begun := Limit} = Watch) -> Watch#{limit := Limit};
moving(Watch) -> Watch.

now_ms() -> erlang:monotonic_time(millisecond).

%% @doc Ends a child that hangs: asks it where it is (SIGQUIT; the log tells), then kills it.
-spec quit(child()) -> cb_guard:ending().
quit(#{guard := Guard, os_pid := OsPid}) ->
    _ = cb_nif:kill(OsPid, 3),
    await_end(Guard, ?QUIT_MS).

await_end(Guard, Ms) ->
    case cb_guard:next_event(Guard, Ms) of
        {data, _} ->
            await_end(Guard, Ms);
        {ended, Ending} ->
            Ending;
        timeout ->
            ok = cb_guard:close(Guard),
            {signal, 9}
    end.

%% @doc Ends a child that is idle; it writes its cover data first.
-spec stop(child()) -> ok.
stop(#{guard := Guard} = Child) ->
    ok = cb_guard:send(Guard, term_to_binary(stop)),
    _ = await_end(Guard, ?STOP_MS),
    close(Child).

%% @doc Ends a child, whatever it does, and returns when it is gone.
-spec close(child()) -> ok.
close(#{guard := Guard}) -> cb_guard:close(Guard).

%% @doc The last lines that the child, and C code in it, printed.
-spec log(child()) -> string().
log(#{log := Log}) ->
    unicode:characters_to_list(tail(Log)).

-spec journal(child()) -> file:filename().
journal(#{journal := Journal}) -> Journal.

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

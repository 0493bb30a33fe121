%% @doc The child VM's side: takes jobs from the VM that started it, carries what properties print
%% back to it, and answers with results.
%%
%% This process owns the channel and is the group leader of the process that runs a property, so
%% it goes on answering while C code keeps that process busy. Packets are Erlang terms; both
%% directions are the types to_worker() and from_worker().
-module(faultcheck_worker).

-export([main/0]).
-export_type([to_worker/0, from_worker/0, setup/0]).

-type setup() :: #{
    paths := [file:filename()],
    env := [{atom(), atom(), term()}],
    config := file:filename() | none,
    journal := file:filename(),
    cover := #{dirs := [file:filename()], file := file:filename()} | none
}.
-type to_worker() ::
    {setup, setup()}
    | {run, faultcheck_property:job()}
    %% the answer to want_tests
    | {tests, {First :: pos_integer(), Last :: pos_integer()} | none}
    | stop.
-type from_worker() ::
    {hello, OsPid :: pos_integer()}
    | {ready, faultcheck_versions:versions()}
    | {setup_failed, string()}
    %% the limit without progress in ms, and the number of tests to come
    | {started, #{limit := pos_integer(), numtests := pos_integer(), doc := string()}}
    | {output, binary()}
    | {progress, non_neg_integer()}
    %% of a job `share': asks for numbers of tests, tells what came of one
    | want_tests
    | {tested, pos_integer(), faultcheck_known:outcome()}
    | {failed, faultcheck_property:failure()}
    %% how far shrinking is: tries, accepted, original, length
    | {shrinking, #{atom() => non_neg_integer()}}
    %% how far a guided search is: runs, most, nearest
    | {searching, #{atom() => number() | worst}}
    | {result, faultcheck_property:result()}
    | {died, string()}
    | stopped.

-define(JOURNAL_BYTES, 1 bsl 20).
-define(PROGRESS_MS, 500).

-record(state, {
    channel :: port(),
    %% the process that runs a property
    runner = none :: {pid(), reference()} | none,
    tests :: counters:counters_ref(),
    %% what it prints is dropped while true
    mute = false :: boolean(),
    %% what it prints is kept there, when a process has asked for it once
    captured = none :: none | binary(),
    cover = none :: file:filename() | none
}).

%% @doc Started with `erl -s faultcheck_worker main'; ends the VM when its channel closes.
-spec main() -> no_return().
main() ->
    Channel = cb_guard:child_channel(),
    true = register(?MODULE, self()),
    send(Channel, {hello, list_to_integer(os:getpid())}),
    loop(#state{channel = Channel, tests = counters:new(1, [])}).

-spec loop(#state{}) -> no_return().
loop(#state{channel = Channel, runner = Runner} = State) ->
    receive
        {Channel, {data, Packet}} ->
            loop(command(binary_to_term(Packet), State));
        {Channel, eof} ->
            erlang:halt(0, [{flush, false}]);
        {io_request, From, Tag, Request} ->
            {Text, Reply} = faultcheck_output:request(Request),
            Next = output(Text, State),
            From ! {io_reply, Tag, Reply},
            loop(Next);
        {mute, Mute} ->
            loop(State#state{mute = Mute});
        {show, Text} ->
            Next = output(Text, State#state{mute = false}),
            loop(Next#state{mute = State#state.mute});
        {capture, From} ->
            From ! {captured, captured(State)},
            loop(State#state{captured = <<>>});
        {tell, Message} ->
            send(Channel, Message),
            loop(State);
        progress ->
            loop(progress(State));
        {'DOWN', Ref, process, Pid, Reason} when Runner =:= {Pid, Ref} ->
            loop(ended(Reason, State))
    end.

output(<<>>, State) ->
    State;
output(_Text, #state{mute = true} = State) ->
    State;
output(Text, #state{captured = none, channel = Channel} = State) ->
    send(Channel, {output, Text}),
    State;
output(Text, #state{captured = Before} = State) ->
    State#state{captured = <<Before/binary, Text/binary>>}.

captured(#state{captured = none}) -> <<>>;
captured(#state{captured = Text}) -> Text.

-spec send(port(), from_worker()) -> ok.
send(Channel, Message) ->
    true = port_command(Channel, term_to_binary(Message)),
    ok.

-spec command(to_worker(), #state{}) -> #state{}.
command({setup, Setup}, #state{channel = Channel} = State) ->
    case setup(Setup) of
        {ok, Cover} ->
            send(Channel, {ready, faultcheck_versions:all()}),
            State#state{cover = Cover};
        {error, Line} ->
            send(Channel, {setup_failed, Line}),
            State
    end;
command({run, Job}, #state{tests = Tests} = State) ->
    counters:put(Tests, 1, 0),
    Main = self(),
    Runner = spawn_monitor(fun() -> run(Main, Job, Tests) end),
    _ = erlang:send_after(?PROGRESS_MS, self(), progress),
    State#state{runner = Runner, mute = false, captured = none};
command({tests, _} = Tests, #state{runner = Runner} = State) ->
    %% It may have died while it waited.
    _ = [Pid ! Tests || {Pid, _} <- [Runner]],
    State;
command(stop, #state{channel = Channel, cover = Cover}) ->
    _ = Cover =/= none andalso cover:export(Cover),
    send(Channel, stopped),
    erlang:halt(0).

%% PropEr needs a process that does not trap exits.
run(Main, Job, Tests) ->
    true = group_leader(Main, self()),
    Tell = fun(Message) ->
        Main ! Message,
        ok
    end,
    Result = faultcheck_property:run(Job, Tests, Tell),
    Main ! {tell, {result, Result}}.

progress(#state{runner = none} = State) ->
    State;
progress(#state{channel = Channel, tests = Tests} = State) ->
    send(Channel, {progress, counters:get(Tests, 1)}),
    _ = erlang:send_after(?PROGRESS_MS, self(), progress),
    State.

ended(normal, State) ->
    State#state{runner = none};
ended(Reason, #state{channel = Channel} = State) ->
    Line = io_lib:format("the process of the property died: ~0tP", [Reason, 30]),
    send(Channel, {died, lists:flatten(Line)}),
    State#state{runner = none}.

setup(#{paths := Paths, env := Env, config := Config, journal := Journal, cover := Cover}) ->
    ok = code:add_pathsa(lists:reverse(Paths)),
    case configure(Config) of
        ok ->
            lists:foreach(fun({App, Key, Value}) -> application:set_env(App, Key, Value) end, Env),
            journal(Journal, Cover);
        {error, _} = Error ->
            Error
    end.

journal(File, Cover) ->
    case faultcheck_journal:open(File, ?JOURNAL_BYTES) of
        ok -> {ok, cover(Cover)};
        {error, Reason} -> {error, text("the journal cannot be written: ~0tp", [Reason])}
    end.

configure(none) ->
    ok;
configure(File) ->
    case file:consult(File) of
        {ok, [Apps]} when is_list(Apps) ->
            application:set_env([App || {_, _} = App <- Apps], []);
        {ok, _} ->
            {error, text("~ts must hold one list of {Application, Settings}", [File])};
        {error, Reason} ->
            {error, text("~ts: ~ts", [File, file:format_error(Reason)])}
    end.

cover(none) ->
    none;
cover(#{dirs := Dirs, file := File}) ->
    {ok, _} = cover:start(),
    lists:foreach(fun cover:compile_beam_directory/1, Dirs),
    File.

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

%% @doc What is about to be executed, written before it is executed.
%%
%% The child VM opens the journal once; from then on every test, every shrinking candidate and
%% every command leaves a record in a memory-mapped file, so that the VM that started the child
%% can tell what ran when the child died or stopped moving:
%%
%% ```
%% ok = faultcheck_journal:open("run.journal", 1 bsl 20),
%% ok = faultcheck_journal:test(#{property => {prop_m, prop_x}, seed => 1, test => 7, size => 12}),
%% ok = faultcheck_journal:command({set, {var, 1}, {call, m, push, [4]}}),
%% {ok, #{test := 7, commands := [_]}} = faultcheck_journal:read("run.journal").
%% '''
%% Where no journal is open (a property run by hand with `proper:quickcheck/1'), command/1 costs
%% one look-up.
-module(faultcheck_journal).

-export([open/2, close/0, test/1, attempt/0, command/1, read/1, progress/1]).
-export_type([head/0, entry/0, reason/0]).

-type head() :: #{
    property := {module(), atom()},
    seed := non_neg_integer(),
    %% number of the test in the run, from 1
    test := pos_integer(),
    size := non_neg_integer()
}.
-type entry() :: #{
    property := {module(), atom()},
    seed := non_neg_integer(),
    test := pos_integer(),
    size := non_neg_integer(),
    %% 0: the test itself, otherwise the how many-th candidate of its shrinking or re-run
    attempt := non_neg_integer(),
    commands := [term()],
    %% true when the file was too small for all commands: the first ones are missing
    cut := boolean()
}.
-type reason() :: {journal, file:filename(), empty | not_a_journal | truncated | term()}.

%% The bytes that tell one state from the next: the header and the first record's beginning,
%% which holds the counter.
-define(PROGRESS_BYTES, 96).

%% @doc Opens File for this VM. All its processes write to it.
-spec open(file:filename(), pos_integer()) -> ok | {error, reason()}.
open(File, Bytes) ->
    case cb_journal:open(File, Bytes) of
        {ok, Journal} ->
            State = {Journal, counters:new(2, [])},
            persistent_term:put(?MODULE, State);
        {error, _} = Error ->
            Error
    end.

-spec close() -> ok.
close() ->
    _ = persistent_term:erase(?MODULE),
    ok.

%% @doc A new test begins. The records of the one before are forgotten.
-spec test(head()) -> ok.
test(Head) ->
    case persistent_term:get(?MODULE, none) of
        none ->
            ok;
        {Journal, Counters} ->
            put(?MODULE, Head),
            counters:put(Counters, 2, 0),
            start(Journal, Counters, Head, false)
    end.

%% @doc The body of the property is about to run: for the test itself first, then once for each
%% candidate of its shrinking.
-spec attempt() -> ok.
attempt() ->
    case {persistent_term:get(?MODULE, none), get(?MODULE)} of
        {none, _} ->
            ok;
        {_, undefined} ->
            ok;
        {{Journal, Counters}, Head} ->
            start(Journal, Counters, Head, false),
            counters:add(Counters, 2, 1)
    end.

%% @doc A command is about to be executed.
-spec command(term()) -> ok.
command(Command) ->
    case persistent_term:get(?MODULE, none) of
        none -> ok;
        {Journal, Counters} -> append(Journal, Counters, term_to_binary(Command))
    end.

append(Journal, Counters, Record) ->
    case cb_journal:append(Journal, Record) of
        ok ->
            ok;
        {error, full} ->
            %% Forget the first commands rather than stand still: a journal that does not move
            %% is taken for a hang.
            start(Journal, Counters, get(?MODULE), true),
            _ = cb_journal:append(Journal, Record),
            ok
    end.

%% The counter comes first, at a fixed place: see ?PROGRESS_BYTES.
start(Journal, Counters, Head, Cut) ->
    ok = counters:add(Counters, 1, 1),
    Count = counters:get(Counters, 1),
    Attempt = counters:get(Counters, 2),
    Record = [<<Count:64>>, term_to_binary({Head, Attempt, Cut})],
    case cb_journal:start(Journal, Record) of
        ok -> ok;
        {error, full} -> ok
    end.

%% @doc What ran last, as far as it was written.
-spec read(file:filename()) -> {ok, entry()} | {error, reason()}.
read(File) ->
    case cb_journal:read(File) of
        {ok, [<<_Count:64, Head/binary>> | Commands]} -> decode(File, Head, Commands);
        {ok, []} -> {error, {journal, File, empty}};
        {error, _} = Error -> Error
    end.

decode(File, HeadBytes, Commands) ->
    try {binary_to_term(HeadBytes), [binary_to_term(C) || C <- Commands]} of
        {{undefined, _, _}, _} ->
            {error, {journal, File, empty}};
        {{Head, Attempt, Cut}, Terms} ->
            {ok, Head#{attempt => Attempt, commands => Terms, cut => Cut}}
    catch
        error:badarg -> {error, {journal, File, truncated}}
    end.

%% @doc Bytes that differ whenever the writer has moved on. Empty while there is no journal.
-spec progress(file:filename()) -> binary().
progress(File) ->
    case file:open(File, [read, raw, binary]) of
        {ok, Fd} ->
            Bytes = file:read(Fd, ?PROGRESS_BYTES),
            ok = file:close(Fd),
            case Bytes of
                {ok, Head} -> Head;
                eof -> <<>>
            end;
        {error, _} ->
            <<>>
    end.

%% @doc A memory-mapped file of records that survives the death of the process that wrote it.
%%
%% ```
%% {ok, J} = cb_journal:open("run.journal", 1 bsl 20),
%% ok = cb_journal:start(J, term_to_binary({test, 17, Seed})),
%% ok = cb_journal:append(J, term_to_binary({set, {var, 1}, Call})),
%% {ok, [Head | Commands], complete} = cb_journal:read("run.journal").
%% '''
%% Writing a record costs a copy, no system call. The layout is in docs/architecture.md.
-module(cb_journal).

-export([open/2, start/2, append/2, read/1]).
-export_type([journal/0, reason/0]).

-type journal() :: cb_nif:journal().
-type reason() :: {journal, file:filename(), not_a_journal | truncated | file:posix() | term()}.

%% Magic, bytes available, bytes used, flags, zeros up to byte 64; then the records.
-define(MAGIC, "CBJRNL1\n").
-define(FILLER, 32).
-define(RECORD_MISSING, 1).

%% @doc Creates or empties File and maps it. Bytes is the room for records, 4 bytes each and
%% their contents.
-spec open(file:filename(), pos_integer()) -> {ok, journal()} | {error, reason()}.
open(File, Bytes) ->
    case cb_nif:journal_open(File, Bytes) of
        {ok, Journal} -> {ok, Journal};
        {error, Why} -> {error, {journal, File, Why}}
    end.

%% @doc Forgets the records so far and writes the first one.
-spec start(journal(), binary()) -> ok | {error, full}.
start(Journal, Record) -> cb_nif:journal_reset(Journal, Record).

-spec append(journal(), binary()) -> ok | {error, full}.
append(Journal, Record) -> cb_nif:journal_append(Journal, Record).

%% @doc The records, in the order written, and whether one more did not fit. Works whether or
%% not the writer lives.
-spec read(file:filename()) -> {ok, [binary()], complete | overflowed} | {error, reason()}.
read(File) ->
    case file:read_file(File) of
        {ok, <<?MAGIC, _:64, Used:64/little, Flags:64/little, _:?FILLER/binary, Rest/binary>>} ->
            records(File, Used, Flags, Rest);
        {ok, <<?MAGIC, _/binary>>} ->
            {error, {journal, File, truncated}};
        {ok, _} ->
            {error, {journal, File, not_a_journal}};
        {error, Posix} ->
            {error, {journal, File, Posix}}
    end.

records(File, Used, _Flags, Bytes) when Used > byte_size(Bytes) ->
    {error, {journal, File, truncated}};
records(File, Used, Flags, Bytes) ->
    case split(binary:part(Bytes, 0, Used), []) of
        {ok, Records} when Flags band ?RECORD_MISSING =:= 0 -> {ok, Records, complete};
        {ok, Records} -> {ok, Records, overflowed};
        truncated -> {error, {journal, File, truncated}}
    end.

split(<<>>, Records) ->
    {ok, lists:reverse(Records)};
split(<<Size:32/little, Record:Size/binary, Rest/binary>>, Records) ->
    split(Rest, [Record | Records]);
split(_, _) ->
    truncated.

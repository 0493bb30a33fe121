%% @doc A memory-mapped file of records that survives the death of the process that wrote it.
%%
%% ```
%% {ok, J} = cb_journal:open("run.journal", 1 bsl 20),
%% ok = cb_journal:start(J, term_to_binary({test, 17, Seed})),
%% ok = cb_journal:append(J, term_to_binary({set, {var, 1}, Call})),
%% {ok, [Head | Commands]} = cb_journal:read("run.journal").
%% '''
%% Writing a record costs a copy, no system call. The layout is in docs/architecture.md.
-module(cb_journal).

-export([open/2, start/2, append/2, read/1]).
-export_type([journal/0, reason/0]).

-type journal() :: cb_nif:journal().
-type reason() :: {journal, file:filename(), not_a_journal | truncated | file:posix() | term()}.

-define(MAGIC, "FCJRNL1\n").
-define(HEADER, 16).

%% @doc Creates or empties File and maps it. Bytes is its size, and with that the room for records.
-spec open(file:filename(), pos_integer()) -> {ok, journal()} | {error, reason()}.
open(File, Bytes) ->
    case cb_nif:journal_open(File, Bytes) of
        {ok, Journal} -> {ok, Journal};
        {error, Why} -> {error, {journal, File, Why}}
    end.

%% @doc Forgets the records so far and writes the first one.
-spec start(journal(), iodata()) -> ok | {error, full}.
start(Journal, Record) -> cb_nif:journal_start(Journal, Record).

-spec append(journal(), iodata()) -> ok | {error, full}.
append(Journal, Record) -> cb_nif:journal_append(Journal, Record).

%% @doc The records, in the order written. Works whether or not the writer lives.
-spec read(file:filename()) -> {ok, [binary()]} | {error, reason()}.
read(File) ->
    case file:read_file(File) of
        {ok, <<?MAGIC, End:64/little, Rest/binary>>} ->
            records(File, End - ?HEADER, Rest);
        {ok, _} ->
            {error, {journal, File, not_a_journal}};
        {error, Posix} ->
            {error, {journal, File, Posix}}
    end.

records(File, Length, Bytes) when Length < 0; Length > byte_size(Bytes) ->
    {error, {journal, File, truncated}};
records(File, Length, Bytes) ->
    split(File, binary:part(Bytes, 0, Length), []).

split(_File, <<>>, Records) ->
    {ok, lists:reverse(Records)};
split(File, <<Size:32/little, Record:Size/binary, Rest/binary>>, Records) ->
    split(File, Rest, [Record | Records]);
split(File, _, _) ->
    {error, {journal, File, truncated}}.

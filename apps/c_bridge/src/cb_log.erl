%% @doc The file that the output of a system under test goes to.
%%
%% A file of our own has no name any more once the program has opened it, so that nothing is left
%% behind whatever ends how. It belongs to the process that opened it.
-module(cb_log).

-export([path/1, open/2, close/1, length/1, since/2, cut/2]).
-export_type([log/0]).

-compile({no_auto_import, [length/1]}).

-opaque log() :: {named, file:filename()} | {unnamed, file:fd()}.

%% Nobody reads more than this of what a test printed.
-define(MOST, 1048576).

%% @doc The name to be given to the program that writes.
-spec path(temporary | file:filename()) -> file:filename().
path(temporary) -> cb_files:fresh_name("c_bridge", ".log");
path(File) -> File.

%% @doc For reading what is written to Path, which the program has opened.
-spec open(temporary | file:filename(), Path :: file:filename()) -> log().
open(temporary, Path) ->
    {ok, Device} = file:open(Path, [read, write, raw, binary]),
    ok = file:delete(Path),
    {unnamed, Device};
open(File, File) ->
    {named, File}.

-spec close(none | log()) -> ok.
close({unnamed, Device}) -> file:close(Device);
close(_) -> ok.

-spec length(none | log()) -> non_neg_integer().
length(none) ->
    0;
length({named, File}) ->
    filelib:file_size(File, prim_file);
length({unnamed, Device}) ->
    {ok, Length} = file:position(Device, eof),
    Length.

%% @doc What was written from byte From on; of very much, the end.
-spec since(log(), non_neg_integer()) -> binary().
since(Log, From) ->
    Length = length(Log),
    case min(Length - From, ?MOST) of
        Bytes when Bytes > 0 -> read(Log, Length - Bytes, Bytes);
        _ -> <<>>
    end.

read({unnamed, Device}, From, Bytes) ->
    read_device(Device, From, Bytes);
read({named, File}, From, Bytes) ->
    {ok, Device} = file:open(File, [read, raw, binary]),
    Text = read_device(Device, From, Bytes),
    ok = file:close(Device),
    Text.

read_device(Device, From, Bytes) ->
    case file:pread(Device, From, Bytes) of
        {ok, Text} -> Text;
        eof -> <<>>
    end.

%% @doc Empties a file of our own that is longer than Most; who has it open for appending goes on
%% at its start.
-spec cut(none | log(), Most :: pos_integer()) -> cut | left_alone.
cut({unnamed, Device} = Log, Most) ->
    case length(Log) > Most of
        true ->
            {ok, 0} = file:position(Device, 0),
            ok = file:truncate(Device),
            cut;
        false ->
            left_alone
    end;
cut(_, _) ->
    left_alone.

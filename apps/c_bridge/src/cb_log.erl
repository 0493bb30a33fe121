%% @doc The file that the output of a system under test goes to.
-module(cb_log).

-compile({no_auto_import, [length/1]}).

-export([length/1, since/2, cut/1]).

%% Nobody reads more than this of what a test printed.
-define(MOST, 1048576).

-spec length(file:filename()) -> non_neg_integer().
length(Log) -> filelib:file_size(Log, prim_file).

%% @doc What was written from byte From on; of very much, the end.
-spec since(file:filename(), non_neg_integer()) -> binary().
since(Log, From) ->
    case min(length(Log) - From, ?MOST) of
        Bytes when Bytes > 0 -> cb_files:tail(Log, Bytes);
        _ -> <<>>
    end.

%% @doc Empties the file; who has it open for appending goes on at its start.
-spec cut(file:filename()) -> ok | {error, file:posix()}.
cut(Log) -> file:write_file(Log, <<>>).

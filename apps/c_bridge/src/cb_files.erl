%% @doc Where the files of this application are, and fresh names for temporary ones.
-module(cb_files).

-export([priv_dir/0, program/1, fresh_name/2, temporary_dir/0]).

%% @doc The directory of the native programs, wherever the application is installed.
-spec priv_dir() -> file:filename().
priv_dir() ->
    case code:priv_dir(c_bridge) of
        {error, bad_name} ->
            Ebin = filename:dirname(code:which(?MODULE)),
            filename:join(filename:dirname(Ebin), "priv");
        Dir ->
            Dir
    end.

-spec program(string()) ->
    {ok, file:filename()} | {error, {load, file:filename(), {dlerror, string()}}}.
program(Name) ->
    File = filename:join(priv_dir(), Name),
    case filelib:is_regular(File) of
        true -> {ok, File};
        false -> {error, {load, File, {dlerror, "no such program: build the native side first"}}}
    end.

%% @doc A file name not used before, in the temporary directory.
-spec fresh_name(string(), string()) -> file:filename().
fresh_name(Prefix, Extension) ->
    Unique = integer_to_list(erlang:unique_integer([positive])),
    Clock = integer_to_list(erlang:system_time(nanosecond), 36),
    Name = lists:append([Prefix, "-", os:getpid(), "-", Clock, "-", Unique, Extension]),
    filename:join(temporary_dir(), Name).

-spec temporary_dir() -> file:filename().
temporary_dir() ->
    case os:getenv("TMPDIR") of
        Unset when Unset =:= false; Unset =:= "" -> "/tmp";
        Dir -> Dir
    end.

%% @doc The control token, which player and bridge share through a file (docs/visualizer.md):
%% whoever comes first makes it.
-module(replay_token).

-export([shared/1]).

-define(BYTES, 32).
-define(OTHERS, 8#077).

-include_lib("kernel/include/file.hrl").

%% @doc The token of the file, which is made when it is not there. The error is one line.
-spec shared(file:filename()) -> {ok, binary()} | {error, string()}.
shared(File) ->
    case made(File) of
        ok -> read(File);
        {error, Why} -> {error, line("~ts: ~ts", [File, file:format_error(Why)])}
    end.

made(File) ->
    case filelib:is_file(File) of
        true -> ok;
        false -> make(File)
    end.

%% It appears whole or not at all, and only if there is none: a link does that.
make(File) ->
    New = lists:concat([File, ".", os:getpid()]),
    Digits = [io_lib:format("~2.16.0b", [B]) || <<B>> <= crypto_bytes(?BYTES)],
    case written(New, [Digits, $\n]) of
        ok ->
            Linked = file:make_link(New, File),
            _ = file:delete(New),
            case Linked of
                {error, eexist} -> ok;
                Other -> Other
            end;
        {error, _} = Error ->
            Error
    end.

written(New, Text) ->
    Steps = [
        fun() -> filelib:ensure_dir(New) end,
        fun() -> file:write_file(New, "", [exclusive]) end,
        fun() -> file:change_mode(New, 8#600) end,
        fun() -> file:write_file(New, Text) end
    ],
    lists:foldl(fun(Step, ok) -> Step(); (_, Error) -> Error end, ok, Steps).

%% The kernel's, as the crypto application may be missing.
crypto_bytes(N) ->
    {ok, Device} = file:open("/dev/urandom", [read, raw, binary]),
    {ok, Bytes} = file:read(Device, N),
    ok = file:close(Device),
    Bytes.

read(File) ->
    {ok, #file_info{mode = Mode}} = file:read_file_info(File),
    {ok, Text} = file:read_file(File),
    Token = string:trim(Text),
    case re:run(Token, "^[0-9a-fA-F]{32,128}$", [dollar_endonly]) of
        _ when Mode band ?OTHERS =/= 0 ->
            {error, line("~ts: others may read it; run: chmod 600 ~ts", [File, File])};
        {match, _} ->
            {ok, Token};
        nomatch ->
            {error, line("~ts: expected 32 to 128 hexadecimal digits", [File])}
    end.

line(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

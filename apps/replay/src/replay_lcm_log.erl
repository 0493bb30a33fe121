%% @doc LCM logs: files of messages with times, as lcm-logger writes them.
%%
%% An event is a header of 28 bytes (magic, i64 number, i64 time in us, i32 length of the channel,
%% i32 length of the data), then channel and data. Files compressed with gzip are read as well.
%% Files are hostile: no length is believed before it is checked.
%%
%% A writer makes a temporary file, which close/1 renames; discard/1 leaves nothing behind.
-module(replay_lcm_log).

-export([fold/3, read/1, events/1, bytes/1]).
-export([create/1, write/4, close/1, discard/1]).
-export_type([event/0, writer/0]).

-define(MAGIC, 16#eda1da01).
-define(HEADER, 28).
-define(CHANNEL_MAX, 63).
-define(DATA_MAX, (16 bsl 20)).
-define(READ_AHEAD, (256 bsl 10)).

-type event() :: #{
    number := integer(),
    t_us := integer(),
    channel := binary(),
    %% with the fingerprint: what replay_lcm:decode/1 takes
    data := binary()
}.
-record(writer, {
    file :: file:filename(),
    temporary :: file:filename(),
    device :: file:io_device(),
    number = 0 :: non_neg_integer()
}).
-opaque writer() :: #writer{}.
-type line() :: replay_lcm:line().

%% ---- Reading ----

%% @doc Folds over the events of a file in order. `truncated' is a file that ends inside an event or
%% goes on with something else: Acc is that of the events before.
-spec fold(file:filename_all(), fun((event(), Acc) -> Acc), Acc) ->
    {ok, Acc} | {truncated, line(), Acc} | {error, line()}.
fold(File, Fun, Acc) ->
    case file:open(File, [read, raw, binary, compressed, {read_ahead, ?READ_AHEAD}]) of
        {ok, Device} ->
            More = fun() -> file:read(Device, ?READ_AHEAD) end,
            try events(<<>>, More, {0, 0}, Fun, Acc) of
                {truncated, Line, Done} -> {truncated, about(File, Line), Done};
                Done -> Done
            catch
                throw:{unreadable, Reason} -> {error, about(File, file:format_error(Reason))}
            after
                ok = file:close(Device)
            end;
        {error, Reason} ->
            {error, about(File, file:format_error(Reason))}
    end.

%% @doc All events of a file.
-spec read(file:filename_all()) ->
    {ok, [event()]} | {truncated, line(), [event()]} | {error, line()}.
read(File) ->
    reversed(fold(File, fun(Event, Events) -> [Event | Events] end, [])).

%% @doc All events of a log's bytes.
-spec events(binary()) -> {ok, [event()]} | {truncated, line(), [event()]}.
events(Bytes) ->
    reversed(events(Bytes, fun() -> eof end, {0, 0}, fun(E, Es) -> [E | Es] end, [])).

reversed({ok, Events}) -> {ok, lists:reverse(Events)};
reversed({truncated, Line, Events}) -> {truncated, Line, lists:reverse(Events)};
reversed({error, _} = Error) -> Error.

%% At: {events, bytes} before the buffer.
events(Buffer, More, {Count, Offset} = At, Fun, Acc) ->
    case event(Buffer) of
        {ok, Event, Rest} ->
            Size = byte_size(Buffer) - byte_size(Rest),
            events(Rest, More, {Count + 1, Offset + Size}, Fun, Fun(Event, Acc));
        {short, Needed} ->
            case fill(Buffer, Needed, More) of
                <<>> -> {ok, Acc};
                Filled when byte_size(Filled) >= Needed -> events(Filled, More, At, Fun, Acc);
                Filled -> {truncated, short(Needed, byte_size(Filled), At), Acc}
            end;
        {wrong, What} ->
            {truncated, wrong(What, At), Acc}
    end.

event(<<?MAGIC:32, Number:64/signed, T:64/signed, C:32, D:32, Rest/binary>>) when
    C >= 1, C =< ?CHANNEL_MAX, D =< ?DATA_MAX
->
    case Rest of
        <<Channel:C/binary, Data:D/binary, More/binary>> ->
            {ok, #{number => Number, t_us => T, channel => binary:copy(Channel),
                   data => binary:copy(Data)}, More};
        _ ->
            {short, ?HEADER + C + D}
    end;
event(<<?MAGIC:32, _:128, C:32, D:32, _/binary>>) ->
    {wrong, io_lib:format("lengths ~b and ~b, allowed are 1 to ~b for the channel and up to ~b "
                          "for the data", [C, D, ?CHANNEL_MAX, ?DATA_MAX])};
event(<<?MAGIC:32, _/binary>>) ->
    {short, ?HEADER};
event(<<Magic:32, _/binary>>) ->
    {wrong, io_lib:format("begins with ~8.16.0b instead of ~8.16.0b: no LCM log",
                          [Magic, ?MAGIC])};
event(_) ->
    {short, ?HEADER}.

fill(Buffer, Needed, More) ->
    fill([Buffer], byte_size(Buffer), Needed, More).

fill(Parts, Size, Needed, _More) when Size >= Needed ->
    iolist_to_binary(lists:reverse(Parts));
fill(Parts, Size, Needed, More) ->
    case More() of
        {ok, Bytes} -> fill([Bytes | Parts], Size + byte_size(Bytes), Needed, More);
        eof -> iolist_to_binary(lists:reverse(Parts));
        {error, Reason} -> throw({unreadable, Reason})
    end.

short(Needed, Left, {Count, Offset}) ->
    say("truncated: event ~b at byte ~b needs ~b bytes, ~b are left",
        [Count, Offset, Needed, Left]).

wrong(What, {Count, Offset}) ->
    say("event ~b at byte ~b: ~ts", [Count, Offset, What]).

about(File, Line) -> say("~ts: ~ts", [File, Line]).

say(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

%% ---- Writing ----

%% @doc A new log; an existing file stays as it is until close/1.
-spec create(file:filename()) -> {ok, writer()} | {error, line()}.
create(File) ->
    Unique = filename:basename(cb_files:fresh_name("log", ".tmp")),
    Temporary = filename:join(filename:dirname(File), "." ++ Unique),
    case file:open(Temporary, [write, raw, binary, exclusive, {delayed_write, 1 bsl 18, 200}]) of
        {ok, Device} -> {ok, #writer{file = File, temporary = Temporary, device = Device}};
        {error, Reason} -> {error, about(File, file:format_error(Reason))}
    end.

%% @doc Appends one message; the time is that of the log, here simulated us.
-spec write(writer(), integer(), binary(), iodata()) -> {ok, writer()} | {error, line()}.
write(#writer{device = Device, number = Number, file = File} = Writer, T, Channel, Data) ->
    Event = #{number => Number, t_us => T, channel => Channel, data => Data},
    case file:write(Device, bytes(Event)) of
        ok -> {ok, Writer#writer{number = Number + 1}};
        {error, Reason} -> {error, about(File, file:format_error(Reason))}
    end.

%% @doc An event as it is in a log.
-spec bytes(#{number := integer(), t_us := integer(), channel := binary(), data := iodata()}) ->
    iodata().
bytes(#{number := Number, t_us := T, channel := Channel, data := Data}) ->
    Lengths = <<(byte_size(Channel)):32, (iolist_size(Data)):32>>,
    [<<?MAGIC:32, Number:64, T:64>>, Lengths, Channel, Data].

%% @doc Gives the log its name.
-spec close(writer()) -> ok | {error, line()}.
close(#writer{device = Device, temporary = Temporary, file = File} = Writer) ->
    case finish([fun() -> file:datasync(Device) end, fun() -> file:close(Device) end,
                 fun() -> file:rename(Temporary, File) end]) of
        ok ->
            ok;
        {error, Reason} ->
            discard(Writer),
            {error, about(File, file:format_error(Reason))}
    end.

%% Tells of delayed writes that failed too.
finish([]) -> ok;
finish([Step | Rest]) ->
    case Step() of
        ok -> finish(Rest);
        {error, _} = Error -> Error
    end.

%% @doc Forgets the log.
-spec discard(writer()) -> ok.
discard(#writer{device = Device, temporary = Temporary}) ->
    _ = file:close(Device),
    _ = file:delete(Temporary),
    ok.

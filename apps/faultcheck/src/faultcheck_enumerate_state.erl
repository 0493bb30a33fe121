%% @doc The state file of an enumeration: one line of Erlang term text per finished chunk.
%%
%% ```
%% {faultcheck_enumerate,1,#{chunk => 64,name => ...,size => 2517}}.
%% {chunk,0,#{undetected => 3},[...]}.
%% '''
%%
%% Lines are only appended. A run that was killed while it wrote leaves an incomplete last line;
%% it is dropped, and that chunk is done again. Any other line that does not read is an error.
-module(faultcheck_enumerate_state).

-export([open/2, append/3, close/1, format_error/1]).
-export_type([state/0, id/0, reason/0]).

-type id() :: #{name := term(), size := non_neg_integer(), chunk := pos_integer()}.
-opaque state() :: none | {file:filename(), file:io_device()}.
-type reason() ::
    {state_file, file:filename(),
        {belongs_to, term(), wanted, id()} | {line, pos_integer()} | file:posix()}.

%% @doc Opens or creates the file; returns the chunks it holds.
-spec open(file:filename() | none, id()) ->
    {ok, state(), #{non_neg_integer() => faultcheck_enumerate:outcome()}} | {error, reason()}.
open(none, _Id) ->
    {ok, none, #{}};
open(File, Id) ->
    case file:read_file(File) of
        {ok, Text} -> resume(File, Id, binary:split(Text, <<"\n">>, [global]));
        {error, enoent} -> rewrite(File, Id, #{});
        {error, Reason} -> {error, {state_file, File, Reason}}
    end.

%% What follows the last line feed is empty or incomplete.
resume(File, Id, Lines) ->
    case parse(lists:droplast(Lines), 1, []) of
        {ok, [{faultcheck_enumerate, 1, Id} | Chunks]} ->
            rewrite(File, Id, maps:from_list([{I, {C, F}} || {chunk, I, C, F} <- Chunks]));
        {ok, [{faultcheck_enumerate, 1, Other} | _]} ->
            {error, {state_file, File, {belongs_to, Other, wanted, Id}}};
        {ok, []} ->
            rewrite(File, Id, #{});
        {ok, _} ->
            {error, {state_file, File, {line, 1}}};
        {error, Line} ->
            {error, {state_file, File, {line, Line}}}
    end.

parse([], _Number, Terms) ->
    {ok, lists:reverse(Terms)};
parse([Line | Lines], Number, Terms) ->
    case parse_line(Line) of
        {ok, Term} -> parse(Lines, Number + 1, [Term | Terms]);
        error -> {error, Number}
    end.

parse_line(Line) ->
    case erl_scan:string(binary_to_list(Line)) of
        {ok, Tokens, _} -> known(erl_parse:parse_term(Tokens));
        {error, _, _} -> error
    end.

known({ok, {faultcheck_enumerate, 1, Id} = Term}) when is_map(Id) -> {ok, Term};
known({ok, {chunk, I, C, F} = Term}) when is_integer(I), is_map(C), is_list(F) -> {ok, Term};
known(_) -> error.

%% A new file takes the place of the old one, so an incomplete line never stays in the middle.
rewrite(File, Id, Chunks) ->
    New = File ++ ".new",
    Text = [line({faultcheck_enumerate, 1, Id}) | [chunk_line(C) || C <- maps:to_list(Chunks)]],
    Steps = [
        fun() -> filelib:ensure_dir(File) end,
        fun() -> file:write_file(New, Text) end,
        fun() -> file:rename(New, File) end
    ],
    case first_error(Steps) of
        ok -> open_for_append(File, Chunks);
        {error, Reason} -> {error, {state_file, File, Reason}}
    end.

first_error([]) ->
    ok;
first_error([Step | Steps]) ->
    case Step() of
        ok -> first_error(Steps);
        {error, _} = Error -> Error
    end.

open_for_append(File, Chunks) ->
    case file:open(File, [append, raw, binary]) of
        {ok, Device} -> {ok, {File, Device}, Chunks};
        {error, Reason} -> {error, {state_file, File, Reason}}
    end.

%% @doc Keeps the outcome of one chunk.
-spec append(state(), non_neg_integer(), faultcheck_enumerate:outcome()) -> ok.
append(none, _Index, _Outcome) -> ok;
append({_File, Device}, Index, Outcome) -> ok = file:write(Device, chunk_line({Index, Outcome})).

-spec close(state()) -> ok.
close(none) -> ok;
close({_File, Device}) -> ok = file:close(Device).

chunk_line({Index, {Counts, Found}}) -> line({chunk, Index, Counts, Found}).

%% ~w has no line feeds and no characters above 7 bit that erl_scan would not read back.
line(Term) -> io_lib:format("~w.\n", [Term]).

-spec format_error(reason()) -> unicode:chardata().
format_error({state_file, File, {belongs_to, Other, wanted, Id}}) ->
    io_lib:format(
        "state file ~ts belongs to ~0tp, this run is ~0tp; remove it or name another",
        [File, Other, Id]
    );
format_error({state_file, File, {line, Number}}) ->
    io_lib:format("state file ~ts, line ~b: not a line of an enumeration; remove the file",
        [File, Number]);
format_error({state_file, File, Reason}) ->
    io_lib:format("state file ~ts: ~ts", [File, file:format_error(Reason)]).

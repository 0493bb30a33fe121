%% @doc The two files of counterexamples that `rebar3 proper' keeps: the last failures, and the
%% ones kept as regressions. Both hold terms `{Module, Property, CounterExample}.', which
%% `proper:check(Module:Property(), CounterExample)' runs again.
-module(faultcheck_store).

-export([last_file/1, regression_file/1, read/1, write/2, add/2]).
-export_type([entry/0]).

-type entry() :: {module(), atom(), proper:counterexample()}.

-spec last_file(BaseDir :: file:filename()) -> file:filename().
last_file(BaseDir) -> filename:join(BaseDir, "rebar3_proper-counterexamples.consult").

-spec regression_file(TestDir :: file:filename()) -> file:filename().
regression_file(TestDir) -> filename:join(TestDir, "proper-regressions.consult").

%% @doc The entries of a file. The error is a line for the user, with the place in the file.
-spec read(file:filename()) -> {ok, [entry()]} | {error, enoent | string()}.
read(File) ->
    case file:consult(File) of
        {ok, Terms} -> entries(File, Terms, 1, []);
        {error, enoent} -> {error, enoent};
        {error, {Line, _, _}} when is_integer(Line) -> {error, not_a_term(File, Line)};
        {error, Reason} -> {error, text("~ts: ~ts", [File, file:format_error(Reason)])}
    end.

entries(_File, [], _N, Done) ->
    {ok, lists:reverse(Done)};
entries(File, [{M, F, C} = Entry | Rest], N, Done) when is_atom(M), is_atom(F), is_list(C) ->
    entries(File, Rest, N + 1, [Entry | Done]);
entries(File, [Other | _], N, _Done) ->
    Format = "~ts: term ~b must be {Module, Property, CounterExample}, not ~0tP",
    {error, text(Format, [File, N, Other, 12])}.

not_a_term(File, Line) ->
    text("~ts:~b: not a complete Erlang term; the file is damaged or was cut short", [File, Line]).

%% @doc Replaces a file: whoever reads it meanwhile sees the old one or the new one.
-spec write(file:filename(), [entry()]) -> ok | {error, string()}.
write(File, Entries) ->
    Temporary = File ++ ".new",
    Text = [io_lib:format("~tp.~n", [Entry]) || Entry <- Entries],
    Steps = [
        fun() -> filelib:ensure_dir(File) end,
        fun() -> file:write_file(Temporary, unicode:characters_to_binary(Text)) end,
        fun() -> file:rename(Temporary, File) end
    ],
    case first_error(Steps) of
        ok -> ok;
        {error, Reason} -> {error, text("~ts: ~ts", [File, file:format_error(Reason)])}
    end.

first_error([]) ->
    ok;
first_error([Step | Rest]) ->
    case Step() of
        ok -> first_error(Rest);
        {error, _} = Error -> Error
    end.

%% @doc Appends the entries that the file does not hold yet, and leaves its text as it is:
%% people write comments into it. Answers how many were added.
-spec add(file:filename(), [entry()]) -> {ok, non_neg_integer()} | {error, string()}.
add(File, Entries) ->
    case read(File) of
        {ok, Old} -> append(File, new(Entries, Old));
        {error, enoent} -> append(File, new(Entries, []));
        {error, _} = Error -> Error
    end.

new(Entries, Old) ->
    lists:foldl(fun(E, New) -> New ++ [E || not lists:member(E, New ++ Old)] end, [], Entries).

append(_File, []) ->
    {ok, 0};
append(File, New) ->
    Old =
        case file:read_file(File) of
            {ok, Text} -> Text;
            {error, enoent} -> <<>>
        end,
    Temporary = File ++ ".new",
    Added = unicode:characters_to_binary([io_lib:format("~n~tp.~n", [Entry]) || Entry <- New]),
    ok = filelib:ensure_dir(File),
    case
        first_error([
            fun() -> file:write_file(Temporary, [Old, Added]) end,
            fun() -> file:rename(Temporary, File) end
        ])
    of
        ok -> {ok, length(New)};
        {error, Reason} -> {error, text("~ts: ~ts", [File, file:format_error(Reason)])}
    end.

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

%% @doc The stored case: one failure of one property, everything needed to show and repeat it.
%%
%% A case is a folder `cases/<id>/'; its `case.json' is the truth, other files are derived from it.
%% The id is the property's name and 8 hex digits of the hash of the shrunk terms, so the same
%% failure found again is the same case. Terms are kept as Erlang text, the form in which
%% `proper:check/2' wants them: a list with the value of each ?FORALL.
-module(faultcheck_case).

-export([write/2, add_file/3, read/1, find/2, directory/0, id/2]).
-export([commands/1, with_commands/2, lines/1]).
-export_type(['case'/0, status/0, told/0]).

%% passed: a run that a person wants to keep.
-type status() :: failed | flaky | passed.
-type 'case'() :: #{
    module := module(),
    property := atom(),
    status := status(),
    seed := non_neg_integer(),
    %% of the failing test
    test := pos_integer() | none,
    size := non_neg_integer() | none,
    transport := nif | port | none,
    %% the command line that repeats it
    options := [string()],
    versions := faultcheck_versions:versions(),
    original := proper:counterexample(),
    shrunk := proper:counterexample(),
    %% why it failed, in lines
    reasons := [string()],
    %% tries, accepted, minimal, stopped, flaky
    shrink := #{atom() => term()}
}.

%% What a model's report(Case, Dir) may answer instead of ok: the file for people that it wrote into
%% the folder, whether the case can be watched in the visualizer, and lines for the user.
-type told() :: #{
    report => file:filename(),
    watch => boolean(),
    notes => [string()]
}.

-define(FORMAT, 1).

%% @doc Where cases are: the environment variable FAULTCHECK_CASES, or `cases'.
-spec directory() -> file:filename().
directory() ->
    case os:getenv("FAULTCHECK_CASES") of
        Unset when Unset =:= false; Unset =:= "" -> "cases";
        Dir -> Dir
    end.

-spec id(atom(), proper:counterexample()) -> string().
id(Property, Shrunk) ->
    <<Hash:4/binary, _/binary>> = erlang:md5(term_text(Shrunk)),
    Digits = [io_lib:format("~2.16.0b", [Byte]) || <<Byte>> <= Hash],
    lists:flatten([atom_to_list(Property), $-, Digits]).

%% @doc Stores a case below Root and answers its folder. Whoever looks meanwhile sees no half
%% of it: new folders and files get their name when they are complete.
-spec write(file:filename(), 'case'()) -> {ok, file:filename()} | {error, string()}.
write(Root, #{property := Property, shrunk := Shrunk} = Case) ->
    Dir = filename:join(Root, id(Property, Shrunk)),
    Text = faultcheck_json:pretty(to_json(filename:basename(Dir), Case)),
    case filelib:is_dir(Dir) of
        true -> replace(Dir, Text);
        false -> create(Dir, Text)
    end.

create(Dir, Text) ->
    New = lists:concat([filename:dirname(Dir), "/.new-", filename:basename(Dir), "-", os:getpid()]),
    File = filename:join(New, "case.json"),
    done(Dir, [
        %% First the place of the cases: its error is the one that tells.
        fun() -> filelib:ensure_dir(New) end,
        fun() -> filelib:ensure_dir(File) end,
        fun() -> file:write_file(File, Text) end,
        fun() -> file:rename(New, Dir) end
    ]).

replace(Dir, Text) ->
    done(Dir, written(Dir, "case.json", Text)).

%% @doc Puts a file into the folder of a case, in the place of one of this name. Whoever looks
%% meanwhile sees the one or the other. A failure is the error `{not_written, Line}'.
-spec add_file(file:filename(), file:filename(), iodata()) -> ok.
add_file(Dir, Name, Content) ->
    case done(Dir, written(Dir, Name, Content)) of
        {ok, _} -> ok;
        {error, Line} -> error({not_written, Line})
    end.

written(Dir, Name, Content) ->
    New = filename:join(Dir, lists:concat([".", Name, "-", os:getpid()])),
    [
        fun() -> file:write_file(New, Content) end,
        fun() -> file:rename(New, filename:join(Dir, Name)) end
    ].

done(Dir, []) ->
    {ok, Dir};
done(Dir, [Step | Rest]) ->
    case Step() of
        ok -> done(Dir, Rest);
        {error, Why} -> {error, text("~ts: ~ts", [Dir, file:format_error(Why)])}
    end.

to_json(Id, Case) ->
    #{module := Module, property := Property, status := Status, versions := Versions} = Case,
    {object, [
        {format, ?FORMAT},
        {id, {text, Id}},
        {module, Module},
        {property, Property},
        {status, Status},
        {reasons, [{text, R} || R <- maps:get(reasons, Case)]},
        {seed, maps:get(seed, Case)},
        {test, number(maps:get(test, Case))},
        {size, number(maps:get(size, Case))},
        {transport, number(maps:get(transport, Case))},
        {options, [{text, O} || O <- maps:get(options, Case)]},
        {versions,
            {object, [
                {K, {text, maps:get(K, Versions)}}
             || K <- [faultcheck, proper, otp, git]
            ]}},
        {original, {text, term_text(maps:get(original, Case))}},
        {shrunk, {text, term_text(maps:get(shrunk, Case))}},
        {shrink, maps:map(fun shrink_entry/2, maps:get(shrink, Case))}
    ]}.

shrink_entry(flaky, {Failed, Runs}) -> [Failed, Runs];
shrink_entry(_, Value) -> Value.

number(none) -> null;
number(Value) -> Value.

term_text(Term) -> unicode:characters_to_binary(io_lib:format("~0lp", [Term])).

%% @doc Reads a case from its folder or its case.json. The error is a line for the user.
-spec read(file:filename()) -> {ok, 'case'()} | {error, string()}.
read(Path) ->
    File =
        case filelib:is_dir(Path) of
            true -> filename:join(Path, "case.json");
            false -> Path
        end,
    case file:read_file(File) of
        {ok, Text} -> decode(File, faultcheck_json:decode(Text));
        {error, enoent} -> {error, no_such(Path, directory())};
        {error, Why} -> {error, text("~ts: ~ts", [File, file:format_error(Why)])}
    end.

%% @doc The case that a user names: by the path of its folder or file, or by its id, which is the
%% name of its folder below Root. The error is a line for the user.
-spec find(file:filename(), file:filename()) -> {ok, file:filename()} | {error, string()}.
find(Given, Root) ->
    Below = [filename:join(Root, Given) || filename:basename(Given) =:= Given],
    case lists:filter(fun is_there/1, [Given | Below]) of
        [Path | _] -> {ok, Path};
        [] -> {error, no_such(Given, Root)}
    end.

is_there(Path) ->
    case filelib:is_dir(Path) of
        true -> filelib:is_file(filename:join(Path, "case.json"));
        false -> filelib:is_file(Path)
    end.

no_such(Path, Root) ->
    Known = filelib:wildcard("*", Root),
    Near = faultcheck_suggest:phrase(filename:basename(Path), Known),
    text("no case ~ts; stored cases are folders below ~ts~ts", [Path, Root, Near]).

decode(File, {ok, #{<<"format">> := ?FORMAT} = Json}) ->
    try
        {ok, from_json(Json)}
    catch
        throw:{bad, Key, Why} -> {error, text("~ts: ~ts ~ts", [File, Key, Why])};
        error:{badkey, Key} -> {error, text("~ts: the entry ~ts is missing", [File, Key])}
    end;
decode(File, {ok, #{<<"format">> := Other}}) ->
    {error, text("~ts: format ~0tp; this version reads ~b", [File, Other, ?FORMAT])};
decode(File, {ok, _}) ->
    {error, text("~ts: not a stored case: it has no \"format\"", [File])};
decode(File, {error, {offset, Offset}}) ->
    {error, text("~ts: not JSON at byte ~b; damaged or cut short", [File, Offset])}.

from_json(Json) ->
    Versions = maps:get(<<"versions">>, Json),
    #{
        module => name(<<"module">>, Json),
        property => name(<<"property">>, Json),
        status => one_of(<<"status">>, [failed, flaky, passed], Json),
        reasons => [unicode:characters_to_list(R) || R <- maps:get(<<"reasons">>, Json)],
        seed => maps:get(<<"seed">>, Json),
        test => optional(<<"test">>, Json),
        size => optional(<<"size">>, Json),
        transport => one_of(<<"transport">>, [null, nif, port], Json),
        options => [unicode:characters_to_list(O) || O <- maps:get(<<"options">>, Json)],
        versions => #{
            faultcheck => string(<<"faultcheck">>, Versions),
            proper => string(<<"proper">>, Versions),
            otp => string(<<"otp">>, Versions),
            git => string(<<"git">>, Versions)
        },
        original => counterexample(<<"original">>, Json),
        shrunk => counterexample(<<"shrunk">>, Json),
        shrink => shrink(maps:get(<<"shrink">>, Json))
    }.

shrink(Json) when is_map(Json) ->
    Known = [tries, accepted, minimal, stopped, flaky],
    maps:from_list([
        {Key, shrunk(Value)}
     || Key <- Known, {ok, Value} <- [maps:find(atom_to_binary(Key, utf8), Json)]
    ]);
shrink(_) ->
    throw({bad, <<"shrink">>, "must be an object"}).

shrunk([Failed, Runs]) -> {Failed, Runs};
shrunk(Stopped) when is_binary(Stopped) -> binary_to_atom(Stopped, utf8);
shrunk(Value) -> Value.

string(Key, Json) ->
    case maps:get(Key, Json) of
        Text when is_binary(Text) -> unicode:characters_to_list(Text);
        _ -> throw({bad, Key, "must be a string"})
    end.

name(Key, Json) -> list_to_atom(string(Key, Json)).

optional(Key, Json) ->
    case maps:get(Key, Json) of
        null -> none;
        Number when is_integer(Number) -> Number;
        _ -> throw({bad, Key, "must be a whole number or null"})
    end.

one_of(Key, Allowed, Json) ->
    Value = maps:get(Key, Json),
    case [A || A <- Allowed, A =:= Value orelse atom_to_binary(A, utf8) =:= Value] of
        [null] -> none;
        [Atom] -> Atom;
        [] -> throw({bad, Key, text("must be one of ~0tp", [Allowed])})
    end.

counterexample(Key, Json) ->
    case term(Key, Json) of
        List when is_list(List) -> List;
        _ -> throw({bad, Key, "must be the text of a list: a value for each ?FORALL"})
    end.

term(Key, Json) ->
    Text = string(Key, Json),
    case erl_scan:string(Text ++ ".") of
        {ok, Tokens, _} ->
            case erl_parse:parse_term(Tokens) of
                {ok, Term} -> Term;
                {error, _} -> throw({bad, Key, "is not the text of an Erlang term"})
            end;
        {error, _, _} ->
            throw({bad, Key, "is not the text of an Erlang term"})
    end.

%% ---- counterexamples ----------------------------------------------------------------------

%% @doc The command sequence in a counterexample, if it has one.
-spec commands(proper:counterexample()) -> {ok, [term()]} | none.
commands([Value | Rest]) ->
    case is_commands(Value) of
        true -> {ok, Value};
        false -> commands(Rest)
    end;
commands(_) ->
    none.

is_commands([_ | _] = Value) -> is_proper_list(Value) andalso lists:all(fun is_command/1, Value);
is_commands(_) -> false.

is_proper_list(Value) -> is_integer(catch length(Value)).

is_command({set, {var, _}, {call, M, F, A}}) -> is_atom(M) andalso is_atom(F) andalso is_list(A);
is_command(_) -> false.

%% @doc The counterexample with other commands in the place of its own.
-spec with_commands(proper:counterexample(), [term()]) -> proper:counterexample().
with_commands([Value | Rest], Commands) ->
    case is_commands(Value) of
        true -> [Commands | Rest];
        false -> [Value | with_commands(Rest, Commands)]
    end;
with_commands([], _Commands) ->
    [].

%% @doc A counterexample for a reader: a line for each command, or for each value.
-spec lines(proper:counterexample()) -> [string()].
lines(CounterExample) ->
    lists:append([value_lines(Value) || Value <- CounterExample]).

value_lines({parallel, _, [_ | _], _} = Case) ->
    [text("~ts", [Line]) || Line <- faultcheck_parallel:lines(Case)];
value_lines(Value) ->
    case is_commands(Value) of
        true -> [text("~ts", [Line]) || Line <- faultcheck_pretty:commands(Value)];
        false -> string:split(text("~lp", [Value]), "\n", all)
    end.

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

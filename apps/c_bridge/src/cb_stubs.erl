%% @doc C functions in place of undefined ones: a constant, or a question to Erlang.
%%
%% A stub is compiled together with the source that declares the function, so that all types of
%% the declaration are there. The declaration is taken from gcc's -aux-info.
-module(cb_stubs).

-export([declarations/2, assign/2, source/3]).
-export_type([declarations/0, stub/0, reason/0]).

%% Return type and parameter types, as gcc spells them.
-type declarations() :: #{atom() => {binary(), [binary()]}}.
-type stub() :: {atom(), term() | fun()}.
-type reason() ::
    {stub, atom(), not_declared | {bad_value, term()} | {unsupported_declaration, binary()}}.

%% @doc The functions that a C source declares.
-spec declarations(file:filename(), [string()]) ->
    {ok, declarations()} | {error, cb_compiler:reason()}.
declarations(Source, Flags) ->
    Output = cb_files:fresh_name("c_bridge", ".aux"),
    Args = Flags ++ ["-aux-info", Output, "-fsyntax-only", Source],
    Result =
        case cb_compiler:must(Source, "gcc", Args) of
            {ok, _} ->
                {ok, Text} = file:read_file(Output),
                {ok, parse(binary:split(Text, <<"\n">>, [global, trim_all]), #{})};
            {error, _} = Error ->
                Error
        end,
    _ = file:delete(Output),
    Result.

parse([], Found) ->
    Found;
parse([Line | Lines], Found) ->
    Declaration = "^/\\* .* \\*/ extern ([^()]*[ *])([A-Za-z_][A-Za-z_0-9]*) \\((.*)\\);",
    case re:run(Line, Declaration, [{capture, all_but_first, binary}]) of
        {match, [Return, Name, Parameters]} ->
            Type = string:trim(Return),
            Function = binary_to_atom(Name),
            parse(Lines, Found#{Function => {Type, parameters(string:trim(Parameters))}});
        nomatch ->
            parse(Lines, unsupported(Line, Found))
    end.

%% A function that returns a pointer to a function: name and parameters are inside of the type.
unsupported(Line, Found) ->
    Pattern = "^/\\* .* \\*/ (extern .*\\(\\*+ *([A-Za-z_][A-Za-z_0-9]*) \\(.*);",
    case re:run(Line, Pattern, [{capture, all_but_first, binary}]) of
        {match, [Text, Name]} -> Found#{binary_to_atom(Name) => {unsupported, Text}};
        nomatch -> Found
    end.

parameters(<<"void">>) -> [];
parameters(<<"/*", _/binary>>) -> [];
parameters(Text) -> split(Text, 0, <<>>, []).

%% At the commas that are in no parentheses.
split(<<>>, _, Part, Parts) -> lists:reverse([string:trim(Part) | Parts]);
split(<<",", Rest/binary>>, 0, Part, Parts) -> split(Rest, 0, <<>>, [string:trim(Part) | Parts]);
split(<<"(", Rest/binary>>, N, Part, Parts) -> split(Rest, N + 1, <<Part/binary, "(">>, Parts);
split(<<")", Rest/binary>>, N, Part, Parts) -> split(Rest, N - 1, <<Part/binary, ")">>, Parts);
split(<<C, Rest/binary>>, N, Part, Parts) -> split(Rest, N, <<Part/binary, C>>, Parts).

%% @doc Gives each stub to the first source that declares its function.
-spec assign([stub()], [{file:filename(), declarations()}]) ->
    {ok, #{file:filename() => [stub()]}} | {error, reason()}.
assign(Stubs, Sources) -> assign(Stubs, Sources, #{}).

assign([], _, Assigned) ->
    {ok, Assigned};
assign([{Function, Value} = Stub | Stubs], Sources, Assigned) ->
    case [{File, Type} || {File, #{Function := Type}} <- Sources] of
        [] ->
            {error, {stub, Function, not_declared}};
        [{_, {unsupported, Text}} | _] ->
            {error, {stub, Function, {unsupported_declaration, Text}}};
        [{File, {Return, _}} | _] ->
            case is_function(Value) orelse literal(Return, Value) of
                error ->
                    {error, {stub, Function, {bad_value, Value}}};
                _ ->
                    Others = maps:get(File, Assigned, []),
                    assign(Stubs, Sources, Assigned#{File => Others ++ [Stub]})
            end
    end.

%% @doc The text of a C file that is Source with stubs after it.
-spec source(file:filename(), [stub()], declarations()) -> iolist().
source(Source, Stubs, Declarations) ->
    [
        "#include \"", Source, "\"\n",
        "#pragma GCC diagnostic error \"-Woverflow\"\n",
        "__attribute__((weak, visibility(\"default\")))\n",
        "void (*c_bridge_stub_callback)(const char *, void **, void *);\n"
        | [stub(Stub, maps:get(Function, Declarations)) || {Function, _} = Stub <- Stubs]
    ].

stub({Function, Value}, {Return, Parameters}) ->
    Names = [[", (void *)&a", integer_to_list(I)] || {I, P} <- number(Parameters), P =/= <<"...">>],
    [
        Return, " ", atom_to_binary(Function), "(", declare(Parameters), ") {\n",
        body(Function, Value, Return, Names),
        "}\n"
    ].

number(Parameters) -> lists:zip(lists:seq(1, length(Parameters)), Parameters).

declare([]) -> "";
declare(Parameters) -> lists:join(", ", [parameter(I, P) || {I, P} <- number(Parameters)]).

parameter(_, <<"...">>) -> "...";
parameter(I, Type) -> ["__typeof__(", Type, ") a", integer_to_list(I)].

body(Function, Fun, Return, Names) when is_function(Fun) ->
    Arguments = ["    void *arguments[] = {(void *)0", Names, "};\n"],
    Name = ["\"", atom_to_binary(Function), "\""],
    case Return of
        <<"void">> ->
            [Arguments, "    c_bridge_stub_callback(", Name, ", arguments + 1, (void *)0);\n"];
        _ ->
            [
                Arguments,
                "    __typeof__(", Return, ") result;\n",
                "    __builtin_memset((void *)&result, 0, sizeof(result));\n",
                "    c_bridge_stub_callback(", Name, ", arguments + 1, (void *)&result);\n",
                "    return result;\n"
            ]
    end;
body(_Function, _Value, <<"void">>, _) ->
    "";
body(_Function, Value, Return, _) ->
    {ok, Literal} = literal(Return, Value),
    ["    return ", Literal, ";\n"].

literal(<<"void">>, _) -> {ok, ""};
literal(_, Value) when is_integer(Value) -> {ok, integer(Value)};
literal(_, Value) when is_float(Value) -> {ok, io_lib:format("~.17g", [Value])};
literal(_, null) -> {ok, "(void *)0"};
literal(_, true) -> {ok, "1"};
literal(_, false) -> {ok, "0"};
literal(_, nan) -> {ok, "__builtin_nan(\"\")"};
literal(_, inf) -> {ok, "__builtin_inf()"};
literal(_, neg_inf) -> {ok, "-__builtin_inf()"};
literal(_, Value) when is_atom(Value) -> enumerator(atom_to_binary(Value));
literal(_, Value) when is_binary(Value) -> {ok, [$", [escape(Byte) || <<Byte>> <= Value], $"]};
literal(_, _) -> error.

%% The largest negative number cannot be written as one.
integer(-16#8000000000000000) -> "(-9223372036854775807LL - 1)";
integer(Value) when Value > 16#7fffffffffffffff -> [integer_to_list(Value), "ULL"];
integer(Value) -> [integer_to_list(Value), "LL"].

enumerator(Name) ->
    case re:run(Name, "^[A-Za-z_][A-Za-z_0-9]*$") of
        {match, _} -> {ok, Name};
        nomatch -> error
    end.

escape(Byte) -> io_lib:format("\\~3.8.0b", [Byte]).

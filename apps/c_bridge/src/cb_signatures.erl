%% @doc Types for a library without debug information, from its headers.
%%
%% For each exported symbol that the headers declare, an object file gets a variable
%% `__typeof__(symbol) *cb_sig_symbol' whose type the core reads from the debug information.
-module(cb_signatures).

-export([object/4]).

%% @doc Makes the object file in Dir.
-spec object(file:filename(), [file:filename()], {string(), [string()]}, file:filename()) ->
    {ok, file:filename()} | {error, cb_compiler:reason()}.
object(Library, Headers, {Compiler, Flags}, Dir) ->
    case exported(Library) of
        {ok, Symbols} ->
            Base = filename:join(Dir, "signatures"),
            Source = Base ++ extension(Headers),
            typed(Source, Base ++ ".o", Headers, Symbols, {Compiler, Flags});
        {error, _} = Error ->
            Error
    end.

extension(Headers) ->
    case lists:any(fun cb_compiler:is_cxx/1, Headers) of
        true -> ".cpp";
        false -> ".c"
    end.

exported(Library) ->
    case cb_compiler:must(Library, "nm", ["-D", "--defined-only", "-P", Library]) of
        {ok, Output} ->
            Lines = binary:split(Output, <<"\n">>, [global, trim_all]),
            Names = [hd(binary:split(Line, [<<" ">>, <<"@">>])) || Line <- Lines],
            {ok, [Name || Name <- lists:usort(Names), is_plain(Name)]};
        {error, _} = Error ->
            Error
    end.

is_plain(Name) -> re:run(Name, "^[A-Za-z][A-Za-z_0-9]*$", [{capture, none}]) =:= match.

%% The compiler says which symbols the headers do not declare; the rest is compiled.
typed(Source, Object, Headers, Symbols, {Compiler, Flags}) ->
    ok = file:write_file(Source, text(Headers, Symbols)),
    Limit =
        case cb_compiler:is_clang(Compiler) of
            true -> "-ferror-limit=0";
            false -> "-fmax-errors=0"
        end,
    case cb_compiler:run(Compiler, Flags ++ ["-w", Limit, "-fsyntax-only", Source]) of
        {ok, _, Output} ->
            Known = Symbols -- undeclared(Output),
            ok = file:write_file(Source, text(Headers, Known)),
            Args = Flags ++ ["-w", "-g", "-O0", "-c", "-o", Object, Source],
            compile(hd(Headers), Compiler, Args, Object);
        {error, Why} ->
            {error, {compile, hd(Headers), Why}}
    end.

compile(Header, Compiler, Args, Object) ->
    case cb_compiler:must(Header, Compiler, Args) of
        {ok, _} -> {ok, Object};
        {error, _} = Error -> Error
    end.

text(Headers, Symbols) ->
    [
        [["#include \"", Header, "\"\n"] || Header <- Headers],
        [["__typeof__(", Symbol, ") *cb_sig_", Symbol, ";\n"] || Symbol <- Symbols]
    ].

undeclared(Output) ->
    Pattern =
        "error: (?:'([A-Za-z_0-9]+)' (?:undeclared|was not declared)"
        "|use of undeclared identifier '([A-Za-z_0-9]+)')",
    case re:run(Output, Pattern, [global, {capture, all_but_first, binary}]) of
        {match, Found} -> lists:usort([lists:last(Groups) || Groups <- Found]);
        nomatch -> []
    end.

%% @doc From the options of `cb:start/2' to a shared library that can be loaded.
%%
%% Sources are compiled with `-g -O0 -fPIC -shared' (flags given come after these) into a cache:
%% a directory whose name is the hash of the preprocessed sources, the flags and the stubs.
-module(cb_compile).

-export([library/2]).
-export_type([build/0, reason/0]).

-type build() :: #{
    file := file:filename(),
    load_options := map(),
    env := [{string(), string()}]
}.
-type reason() ::
    cb_compiler:reason()
    | cb_stubs:reason()
    | {undefined, [binary()]}
    | {cache, file:filename(), file:posix()}.

%% @doc The library to load, what the core is to be told with it, and the environment it needs.
-spec library(atom(), cb_options:options()) -> {ok, build()} | {error, reason()}.
library(Name, Options) ->
    try
        File = file(Name, Options),
        Coverage = cb_coverage:environment(maps:get(coverage, Options)),
        Env = Coverage ++ cb_sanitizer:environment(Options),
        {ok, #{file => File, load_options => signatures(File, Options), env => Env}}
    catch
        throw:{?MODULE, Reason} -> {error, Reason}
    end.

-spec fail(reason()) -> no_return().
fail(Reason) -> throw({?MODULE, Reason}).

get_or_fail({ok, Value}) -> Value;
get_or_fail({error, Reason}) -> fail(Reason).

file(_Name, #{so := So}) when So =/= none ->
    %% A name without a directory may be one for the dynamic linker.
    case filelib:is_regular(So) of
        true -> filename:absname(So);
        false -> So
    end;
file(Name, #{c_src := Sources} = Options) ->
    Files = [existing(Source) || Source <- Sources],
    {Stubs, Declared} = stubs(Files, Options),
    Key = key([Name, Stubs, link_inputs(Options)], Files, Options),
    Library = filename:join([cache_dir(Options), Key, atom_to_list(Name) ++ ".so"]),
    case filelib:is_regular(Library) of
        true -> Library;
        false -> make(Library, Files, Stubs, Declared, Options)
    end.

existing(File) ->
    case filelib:is_regular(File) of
        true -> filename:absname(File);
        false -> fail({compile, File, no_such_file})
    end.

%% ---- flags ---------------------------------------------------------------------------------

compile_flags(#{cflags := Flags} = Options) ->
    ["-g", "-O0", "-fPIC"] ++ coverage_flags(Options) ++ cb_sanitizer:flags(Options) ++
        include_flags(Options) ++ Flags.

include_flags(#{include_dirs := Dirs}) -> ["-I" ++ filename:absname(Dir) || Dir <- Dirs].

%% libgcov's functions are in the library only if they are asked for.
coverage_flags(#{coverage := none}) -> [];
coverage_flags(_) -> ["--coverage"].

link_flags(#{ldflags := Flags, lib_dirs := Dirs, libs := Libs} = Options) ->
    Absolute = [filename:absname(Dir) || Dir <- Dirs],
    Coverage = [
        "-Wl,-u,__gcov_dump,-u,__gcov_reset"
     || maps:get(coverage, Options) =/= none
    ],
    coverage_flags(Options) ++ Coverage ++ cb_sanitizer:link_flags(Options) ++ ["-Wl,-z,defs"] ++
        lists:flatmap(fun(Dir) -> ["-L" ++ Dir, "-Wl,-rpath," ++ Dir] end, Absolute) ++
        Flags ++ ["-l" ++ Lib || Lib <- Libs] ++ ["-Wl,--as-needed", "-lm"].

%% Files named in the flags: another version of an archive makes another library.
link_inputs(#{ldflags := Flags, lib_dirs := Dirs, libs := Libs}) ->
    Archives = [filename:join(Dir, "lib" ++ Lib ++ ".a") || Dir <- Dirs, Lib <- Libs],
    [{File, hash(Text)} || File <- Flags ++ Archives, {ok, Text} <- [read_regular(File)]].

read_regular(File) ->
    case filelib:is_regular(File) of
        true -> file:read_file(File);
        false -> none
    end.

%% ---- the cache -----------------------------------------------------------------------------

cache_dir(#{cache_dir := default}) ->
    case {filelib:is_dir("_build"), os:getenv("HOME")} of
        {true, _} -> filename:absname("_build/c_bridge");
        {false, Home} when is_list(Home), Home =/= "" -> filename:basedir(user_cache, "c_bridge");
        {false, _} -> filename:join(cb_files:temporary_dir(), "c_bridge-" ++ os:getpid())
    end;
cache_dir(#{cache_dir := Dir}) ->
    filename:absname(Dir).

key(Terms, Files, #{compiler := Compilers} = Options) ->
    Flags = compile_flags(Options),
    Texts = [preprocessed(File, cb_compiler:for(File, Compilers), Flags) || File <- Files],
    hash(term_to_binary([Compilers, Flags, link_flags(Options), Terms | Texts])).

%% With -dD, which shows the version of the compiler too.
preprocessed(File, Compiler, Flags) ->
    get_or_fail(cb_compiler:must(File, Compiler, Flags ++ ["-E", "-dD", File])).

hash(Binary) ->
    lists:flatten([io_lib:format("~2.16.0b", [Byte]) || <<Byte>> <= erlang:md5(Binary)]).

%% ---- building ------------------------------------------------------------------------------

%% Objects have a directory of their own for each build, so that two VMs can build the same at the
%% same time; the library appears when it is complete.
make(Library, Files, Stubs, Declared, Options) ->
    Unique = filename:basename(cb_files:fresh_name("build", "")),
    Dir = filename:join(filename:dirname(Library), Unique),
    made(filelib:ensure_dir(filename:join(Dir, "x")), Dir),
    Numbered = lists:zip(lists:seq(1, length(Files)), Files),
    Objects = [object(I, File, Dir, Stubs, Declared, Options) || {I, File} <- Numbered],
    New = filename:join(Dir, filename:basename(Library)),
    link(New, Objects, Files, Options),
    made(file:rename(New, Library), Library),
    Library.

made(ok, _) -> ok;
made({error, Posix}, File) -> fail({cache, File, Posix}).

object(I, File, Dir, Stubs, Declared, #{compiler := Compilers} = Options) ->
    Base = integer_to_list(I) ++ "-" ++ filename:basename(filename:rootname(File)),
    Object = filename:join(Dir, Base ++ ".o"),
    Generated = filename:join(Dir, Base ++ filename:extension(File)),
    Source = with_stubs(File, Generated, Stubs, Declared),
    Args = compile_flags(Options) ++ ["-c", "-o", Object, Source],
    _ = get_or_fail(cb_compiler:must(File, cb_compiler:for(File, Compilers), Args)),
    Object.

with_stubs(File, Generated, Stubs, Declared) ->
    case Stubs of
        #{File := Own} ->
            Text = cb_stubs:source(File, Own, maps:get(File, Declared)),
            made(file:write_file(Generated, Text), Generated),
            Generated;
        #{} ->
            File
    end.

link(Library, Objects, [First | _] = Files, #{compiler := {C, Cxx}} = Options) ->
    Compiler =
        case lists:any(fun cb_compiler:is_cxx/1, Files) of
            true -> Cxx;
            false -> C
        end,
    Args = ["-shared", "-o", Library | Objects] ++ link_flags(Options),
    case cb_compiler:run(Compiler, Args) of
        {ok, 0, _} -> ok;
        {ok, _, Output} -> fail(link_error(First, Output));
        {error, Why} -> fail({compile, First, Why})
    end.

link_error(File, Output) ->
    case re:run(Output, "undefined reference to `(.*)'", [global, {capture, [1], binary}]) of
        {match, Names} -> {undefined, lists:usort(lists:append(Names))};
        nomatch -> {compile, File, {failed, cb_compiler:errors(Output)}}
    end.

%% ---- stubs and headers -----------------------------------------------------------------------

stubs(_Files, #{stubs := []}) ->
    {#{}, #{}};
stubs(Files, #{stubs := Stubs} = Options) ->
    Flags = include_flags(Options) ++ maps:get(cflags, Options),
    Sources = [
        {File, get_or_fail(cb_stubs:declarations(File, Flags))}
     || File <- Files, not cb_compiler:is_cxx(File)
    ],
    {get_or_fail(cb_stubs:assign(Stubs, Sources)), maps:from_list(Sources)}.

signatures(_File, #{headers := []}) ->
    #{};
signatures(File, #{headers := Headers, compiler := Compilers} = Options) ->
    Found = [header(Header, Options) || Header <- Headers],
    Compiler = cb_compiler:for(first_cxx(Found), Compilers),
    Flags = include_flags(Options) ++ maps:get(cflags, Options),
    Texts = [preprocessed(Header, Compiler, Flags) || Header <- Found],
    {ok, Library} = read_library(File),
    Key = hash(term_to_binary([Compiler, Flags, Library | Texts])),
    Dir = filename:join(cache_dir(Options), Key),
    case filelib:is_regular(filename:join(Dir, "signatures.o")) of
        true ->
            #{signatures => filename:join(Dir, "signatures.o")};
        false ->
            made(filelib:ensure_dir(filename:join(Dir, "x")), Dir),
            Object = get_or_fail(cb_signatures:object(File, Found, {Compiler, Flags}, Dir)),
            #{signatures => Object}
    end.

%% One C++ header makes all of them C++.
first_cxx(Headers) ->
    case lists:filter(fun cb_compiler:is_cxx/1, Headers) of
        [Header | _] -> Header;
        [] -> hd(Headers)
    end.

%% As given, or in one of the include directories.
header(Header, #{include_dirs := Dirs}) ->
    Candidates = [Header | [filename:join(Dir, Header) || Dir <- Dirs]],
    case lists:filter(fun filelib:is_regular/1, Candidates) of
        [Found | _] -> filename:absname(Found);
        [] -> fail({compile, Header, no_such_file})
    end.

read_library(File) ->
    case file:read_file(File) of
        {ok, Library} -> {ok, Library};
        {error, Posix} -> fail({load, File, {dlerror, file:format_error(Posix)}})
    end.

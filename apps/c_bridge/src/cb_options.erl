%% @doc The options of `cb:start/2': each checked, with its default.
-module(cb_options).

-export([parse/1]).
-export_type([option/0, options/0, reason/0]).

-type option() ::
    %% what to load: a shared library, or C/C++ sources to be compiled to one
    {so, file:filename_all()}
    | {c_src, file:filename_all() | [file:filename_all()]}
    | {cflags, [unicode:chardata()]}
    | {ldflags, [unicode:chardata()]}
    | {include_dirs, [file:filename_all()]}
    | {libs, [unicode:chardata()]}
    | {lib_dirs, [file:filename_all()]}
    %% headers tell the types of a library without debug information
    | {headers, [file:filename_all()]}
    %% functions to be put in place of undefined ones
    | {stubs, [{atom(), term() | fun()}]}
    %% the compiler for C and the one for C++
    | {compiler, {unicode:chardata(), unicode:chardata()}}
    | {cache_dir, file:filename_all()}
    | {transport, port | nif}
    %% on dirty schedulers: all functions, or those named
    | {dirty, boolean() | [atom()]}
    | {reset, cb_reset:asked()}
    %% of one call, in milliseconds; only `port' can keep it
    | {timeout, timeout()}
    | {sanitize, [address | undefined]}
    %% a directory for the coverage counts
    | {coverage, file:filename_all() | none}
    %% the environment and the output of the system under test, `port' only
    | {env, [{string(), string() | false}]}
    | {log, file:filename_all() | temporary}
    %% whose end stops the system under test; if that is not the process that starts it, all
    %% processes can use it (`port' only)
    | {owner, pid() | none}
    %% whether the module Name with a function for each C function is made
    | {module, boolean()}.
-type options() :: #{atom() => term()}.
-type reason() ::
    {bad_option, term(), Expected :: string()}
    | {missing_option, [atom()]}
    | {needs_port, term()}.

%% @doc All options with their values, those of the application's environment (see `cb') applied.
-spec parse([option()]) -> {ok, options()} | {error, reason()}.
parse(Options) when is_list(Options) ->
    try lists:foldl(fun set/2, defaults(), Options) of
        Parsed -> together(forced(Parsed))
    catch
        throw:{bad_option, Option, Expected} -> {error, {bad_option, Option, Expected}}
    end;
parse(Options) ->
    {error, {bad_option, Options, "a list of options"}}.

defaults() ->
    #{
        so => none,
        c_src => [],
        cflags => [],
        ldflags => [],
        include_dirs => [],
        libs => [],
        lib_dirs => [],
        headers => [],
        stubs => [],
        compiler => {"gcc", "g++"},
        cache_dir => default,
        transport => port,
        dirty => false,
        reset => auto,
        timeout => 5000,
        sanitize => [],
        coverage => none,
        env => [],
        log => temporary,
        owner => self(),
        module => true
    }.

set({Key, Value} = Option, Options) when is_map_key(Key, Options) ->
    case check(Key, Value) of
        {ok, Good} -> Options#{Key := Good};
        {expected, What} -> throw({bad_option, Option, What})
    end;
set(Option, Options) ->
    Known = lists:join(", ", [atom_to_list(Key) || Key <- lists:sort(maps:keys(Options))]),
    throw({bad_option, Option, lists:flatten(["{Name, Value} with Name one of ", Known])}).

check(so, File) -> text(File, "a file name");
check(c_src, [Character | _] = File) when is_integer(Character) -> check(c_src, [File]);
check(c_src, File) when is_binary(File) -> check(c_src, [File]);
check(transport, Value) -> one_of(Value, [port, nif]);
check(dirty, Names) when is_list(Names) -> all(Names, fun is_atom/1, "names of C functions");
check(dirty, Value) -> one_of(Value, [false, true]);
check(module, Value) -> one_of(Value, [true, false]);
check(reset, {calls, Calls} = Reset) ->
    case all(Calls, fun is_call/1, "{calls, [{Function, Args}]}") of
        {ok, _} -> {ok, Reset};
        Expected -> Expected
    end;
check(reset, Value) -> one_of(Value, [auto, fork, snapshot, reload, respawn, none]);
check(timeout, infinity) -> {ok, infinity};
check(timeout, Ms) when is_integer(Ms), Ms > 0 -> {ok, Ms};
check(timeout, _) -> {expected, "milliseconds above 0, or infinity"};
check(sanitize, Kinds) -> all(Kinds, fun is_sanitizer/1, "a list of address and undefined");
check(stubs, Stubs) -> all(Stubs, fun is_stub/1, "[{Function, Value or Fun}]");
check(coverage, none) -> {ok, none};
check(coverage, Dir) -> text(Dir, "a directory");
check(cache_dir, Dir) -> text(Dir, "a directory");
check(log, temporary) -> {ok, temporary};
check(log, File) -> text(File, "a file name");
check(env, Env) -> all(Env, fun is_env/1, "[{Name, Value}], strings");
check(owner, none) -> {ok, none};
check(owner, Pid) when is_pid(Pid) -> {ok, Pid};
check(owner, _) -> {expected, "a pid or none"};
check(compiler, {C, Cxx}) -> compiler(text(C, "a program"), text(Cxx, "a program"));
check(compiler, _) -> {expected, "{CCompiler, CxxCompiler}"};
check(_Texts, Values) -> texts(Values).

compiler({ok, C}, {ok, Cxx}) -> {ok, {C, Cxx}};
compiler(_, _) -> {expected, "{CCompiler, CxxCompiler}"}.

one_of(Value, Values) ->
    case lists:member(Value, Values) of
        true -> {ok, Value};
        false -> {expected, io_lib:format("one of ~w", [Values])}
    end.

all(Values, Test, What) when is_list(Values) ->
    case lists:all(Test, Values) of
        true -> {ok, Values};
        false -> {expected, What}
    end;
all(_, _, What) ->
    {expected, What}.

is_call({_Function, Args}) -> is_list(Args);
is_call(_) -> false.

is_sanitizer(Kind) -> Kind =:= address orelse Kind =:= undefined.

is_stub({Function, _}) -> is_atom(Function);
is_stub(_) -> false.

is_env({Name, Value}) -> is_list(Name) andalso (Value =:= false orelse is_list(Value));
is_env(_) -> false.

text(Text, What) when is_binary(Text); is_list(Text), Text =/= [] ->
    try unicode:characters_to_list(Text) of
        Characters when is_list(Characters) -> {ok, Characters};
        _ -> {expected, What}
    catch
        error:badarg -> {expected, What}
    end;
text(_, What) ->
    {expected, What}.

texts(Values) when is_list(Values) ->
    Texts = [text(Value, "a string") || Value <- Values],
    case lists:all(fun({Outcome, _}) -> Outcome =:= ok end, Texts) of
        true -> {ok, [Text || {ok, Text} <- Texts]};
        false -> {expected, "a list of strings"}
    end;
texts(_) ->
    {expected, "a list of strings"}.

%% What a runner asks for wins over the model.
forced(#{timeout := Timeout} = Options) ->
    Factor = application:get_env(c_bridge, timeout_factor, 1),
    Transport = application:get_env(c_bridge, force_transport, maps:get(transport, Options)),
    Options#{
        transport := Transport,
        timeout := scaled(Timeout, Factor),
        slow_timeout => scaled(60000, Factor),
        force_reset => force_reset(application:get_env(c_bridge, force_reset))
    }.

scaled(infinity, _) -> infinity;
scaled(Ms, Factor) -> max(1, round(Ms * Factor)).

force_reset({ok, Reset}) -> {force, Reset};
force_reset(undefined) -> none.

%% What cannot be judged option by option.
together(#{so := none, c_src := []}) ->
    {error, {missing_option, [so, c_src]}};
together(#{so := So, c_src := [_ | _]}) when So =/= none ->
    {error, {bad_option, {so, So}, "either so or c_src, not both"}};
together(#{so := So, stubs := [_ | _]}) when So =/= none ->
    {error, {bad_option, {so, So}, "c_src: stubs are compiled together with the sources"}};
together(#{transport := nif, sanitize := [_ | _] = Kinds}) ->
    {error, {needs_port, {sanitize, Kinds}}};
together(#{transport := nif, stubs := Stubs} = Options) ->
    case [Function || {Function, Value} <- Stubs, is_function(Value)] of
        [] -> {ok, Options};
        Functions -> {error, {needs_port, {stubs, Functions}}}
    end;
together(Options) ->
    {ok, Options}.

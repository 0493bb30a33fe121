%% @doc Calls C and C++ code: any function, any global, without hand-written stubs.
%%
%% ```
%% {ok, Lib} = cb:start(counter, [{c_src, "counter.c"}]),
%% 3 = cb:call(Lib, add, [1, 2]),
%% ok = cb:set(Lib, [limits, max], 10),
%% 10 = cb:value_of(Lib, [limits, max]),
%% ok = cb:restart(Lib),
%% ok = cb:stop(Lib).
%% '''
%% Types come from the debug information of the library, so it must have been built with -g.
%% What goes wrong in a call is raised as `error:{cb, Reason}'; `cb_error:format/1' says any
%% reason in one line. Functions that take a library also take the name given to start/2, for the
%% library that this process started (or attached); so does the module of that name, which has a
%% function for each C function: `counter:add(1, 2)'.
%%
%% With transport `port' (the default) the C code runs in an OS process of its own and may crash,
%% hang or exit; with `nif' it runs in this VM, about a hundred times faster, and ends it if it
%% crashes.
%%
%% The environment of the application overrides what the caller of start/2 asks for:
%% `force_transport' (nif, port), `force_reset' (see cb_reset), `timeout_factor' (a number that
%% multiplies the timeouts of calls).
-module(cb).

-export([start/2, stop/1, restart/1, attach/1, info/1]).
-export([call/3, call_batch/2, resolve/2]).
-export([value_of/2, set/3, address_of/2]).
-export([create_array/3, free/2, cstring/1, cstring/2, read/2, read/3, read_bytes/2, read_bytes/3]).
-export([functions/1, globals/1, flush_coverage/1, last_crash/1]).
-export_type([lib/0, library/0, fname/0, fn/0, ctype/0, path/0, ptr/0, reason/0]).

-record(lib, {
    name :: atom(),
    transport :: nif | port,
    at :: cb_nif:session() | cb_port:at(),
    %% what goes to a dirty scheduler, `nif' only
    dirty = false :: boolean() | #{binary() => true},
    info :: map(),
    coverage :: none | file:filename()
}).
-record(fn, {name :: fname(), handle :: non_neg_integer()}).

-opaque lib() :: #lib{}.
-opaque fn() :: #fn{}.
%% The atom is the name given to start/2.
-type library() :: lib() | atom().
-type fname() :: atom() | string() | binary().
%% A C type as it is spelt in C: 'unsigned char', "struct point *"; also unsigned_char.
-type ctype() :: atom() | string() | binary().
-type ptr() :: null | {ptr, ctype(), Reference :: non_neg_integer()}.
%% A variable, then members and indexes; or a pointer, then members and indexes.
-type path() :: fname() | [fname() | non_neg_integer() | ptr()].
-type reason() :: cb_error:reason().

-define(LIBRARIES, '$c_bridge').

%% ---- start and stop --------------------------------------------------------------------------

%% @doc Loads a library, or compiles sources to one. A library that this process started under the
%% same name is stopped first. The options are told in cb_options.
-spec start(Name :: atom(), [cb_options:option()]) -> {ok, lib()} | {error, reason()}.
start(Name, Options) when is_atom(Name) ->
    ok = stop_earlier(Name),
    case cb_options:parse(Options) of
        {ok, Parsed} -> build(Name, Parsed);
        {error, _} = Error -> Error
    end.

stop_earlier(Name) ->
    case find(Name) of
        {ok, Lib} -> stop(Lib);
        error -> ok
    end.

build(Name, Options) ->
    case cb_compile:library(Name, Options) of
        {ok, Build} -> load(Name, Options, Build);
        {error, _} = Error -> Error
    end.

load(Name, #{transport := port} = Options, Build) ->
    #{file := File, load_options := LoadOptions, env := Env} = Build,
    Keys = [log, reset, force_reset, timeout, slow_timeout, sanitize],
    Config = (maps:with(Keys, Options))#{
        file => File,
        load_options => LoadOptions,
        env => maps:get(env, Options) ++ Env,
        stubs => maps:from_list([S || {_, F} = S <- maps:get(stubs, Options), is_function(F)])
    },
    case cb_port:start(Config, maps:get(owner, Options)) of
        {ok, At, Info} -> started(Name, Options, At, false, Info);
        {error, _} = Error -> Error
    end;
load(Name, #{transport := nif} = Options, Build) ->
    case cb_session:start(maps:merge(Options, Build)) of
        {ok, Session, Info} -> started(Name, Options, Session, dirty(Options), Info);
        {error, _} = Error -> Error
    end.

dirty(#{dirty := Names}) when is_list(Names) ->
    maps:from_list([{atom_to_binary(Name), true} || Name <- Names]);
dirty(#{dirty := Dirty}) -> Dirty.

started(Name, #{transport := Transport} = Options, At, Dirty, Info) ->
    Lib = #lib{
        name = Name,
        transport = Transport,
        at = At,
        dirty = Dirty,
        info = Info#{transport => Transport},
        coverage = maps:get(coverage, Options)
    },
    _ = [warn(Name, Warning) || Warning <- maps:get(warnings, Info)],
    case make_module(Lib, Options) of
        ok ->
            ok = attach(Lib),
            {ok, Lib};
        {error, _} = Error ->
            ok = stop(Lib),
            Error
    end.

warn(Name, Warning) -> logger:warning("c_bridge: ~ts: ~ts", [Name, Warning]).

make_module(_Lib, #{module := false}) -> ok;
make_module(#lib{name = Name} = Lib, _) -> cb_module:load(Name, functions(Lib)).

%% @doc Makes the library known to this process by its name.
-spec attach(lib()) -> ok.
attach(#lib{name = Name} = Lib) ->
    _ = put(?LIBRARIES, (attached())#{Name => Lib}),
    ok.

attached() ->
    case get(?LIBRARIES) of
        undefined -> #{};
        Libs -> Libs
    end.

find(Name) -> maps:find(Name, attached()).

%% @doc Ends the system under test. What it allocated and all pointers to it are gone.
-spec stop(library()) -> ok.
stop(#lib{name = Name, transport = Transport, at = At} = Lib) ->
    case stop(Transport, At) of
        ok -> ok;
        {error, Reason} -> fail(Reason)
    end,
    _ = [put(?LIBRARIES, maps:remove(Name, attached())) || find(Name) =:= {ok, Lib}],
    collect_coverage(Lib);
stop(Name) ->
    stop(library(Name)).

stop(port, At) -> cb_port:stop(At);
stop(nif, Session) -> cb_session:stop(Session).

%% @doc State as after start, by the chosen reset; a system under test that crashed is started
%% again.
-spec restart(library()) -> ok | {error, reason()}.
restart(#lib{transport = port, at = At}) -> cb_port:restart(At);
restart(#lib{transport = nif, at = Session, info = Choice}) -> cb_session:restart(Session, Choice);
restart(Name) -> restart(library(Name)).

%% @doc What is known about the library: file, libraries, transport, method of reset, warnings.
-spec info(library()) -> map().
info(#lib{info = Info}) -> Info;
info(Name) -> info(library(Name)).

%% ---- calls -----------------------------------------------------------------------------------

%% @doc Calls a C function.
-spec call(library(), fname() | fn(), [term()]) -> term().
call(#lib{transport = nif, at = Session, dirty = false}, Function, Args) ->
    case cb_nif:call(Session, native(Function), Args) of
        {ok, Value} -> Value;
        {error, Reason} -> fail(Reason)
    end;
call(#lib{transport = port} = Lib, Function, Args) ->
    request(Lib, {call, name(Function), Args}, {name(Function), Args});
call(#lib{} = Lib, Function, Args) ->
    call_dirty(Lib, Function, Args);
call(Name, Function, Args) ->
    call(library(Name), Function, Args).

call_dirty(#lib{dirty = true, at = Session}, Function, Args) ->
    value(cb_nif:call_dirty(Session, native(Function), Args));
call_dirty(#lib{dirty = Names} = Lib, Function, Args) ->
    case is_map_key(text(name(Function)), Names) of
        true -> call(Lib#lib{dirty = true}, Function, Args);
        false -> call(Lib#lib{dirty = false}, Function, Args)
    end.

%% @doc Calls one after the other, in one message. Stops at the first that fails; then
%% `{batch, Position, Results, Reason}' is raised.
-spec call_batch(library(), [{fname() | fn(), [term()]}]) -> [term()].
call_batch(#lib{transport = nif, at = Session, dirty = false}, Calls) ->
    value(cb_nif:batch(Session, [{native(Function), Args} || {Function, Args} <- Calls]));
call_batch(#lib{} = Lib, Calls) ->
    Named = [{name(Function), Args} || {Function, Args} <- Calls],
    request(Lib, {batch, Named}, {call_batch, Named});
call_batch(Name, Calls) ->
    call_batch(library(Name), Calls).

%% @doc Looks a function up once; calls with what is returned save the search.
-spec resolve(library(), fname()) -> {ok, fn()} | {error, reason()}.
resolve(#lib{} = Lib, Function) ->
    case ask(Lib, {resolve, Function}, {resolve, Function}) of
        {ok, Handle} -> {ok, #fn{name = Function, handle = Handle}};
        {error, _} = Error -> Error
    end;
resolve(Name, Function) ->
    resolve(library(Name), Function).

%% A handle is valid in the process that gave it: through the port, where a reset may be another
%% process, functions go by name.
name(#fn{name = Name}) -> Name;
name(Name) -> Name.

native(#fn{handle = Handle}) -> Handle;
native(Name) -> Name.

text(Name) when is_atom(Name) -> atom_to_binary(Name);
text(Name) -> unicode:characters_to_binary(Name).

%% ---- variables and memory ----------------------------------------------------------------------

-spec value_of(library(), path()) -> term().
value_of(Lib, Path) -> request(Lib, {get, path(Path)}, {value_of, Path}).

-spec set(library(), path(), term()) -> ok.
set(Lib, Path, Value) -> request(Lib, {set, path(Path), Value}, {set, Path, Value}).

-spec address_of(library(), path()) -> ptr().
address_of(Lib, Path) -> request(Lib, {address_of, path(Path)}, {address_of, Path}).

%% A string is one name, a list of anything else is a path.
path([Character | _] = Name) when is_integer(Character) -> [Name];
path(Path) when is_list(Path) -> Path;
path(Name) -> [Name].

%% @doc Memory that lives until the library is reset or stopped, or free/2 is called.
-spec create_array(library(), ctype(), [term()] | binary()) -> ptr().
create_array(Lib, Type, Values) ->
    request(Lib, {alloc, Type, Values}, {create_array, Type, Values}).

-spec free(library(), ptr()) -> ok.
free(Lib, Pointer) -> request(Lib, {free, Pointer}, {free, Pointer}).

%% @doc The bytes up to the first zero.
-spec cstring(library(), ptr()) -> binary().
cstring(Lib, Pointer) -> request(Lib, {cstring, Pointer}, {cstring, Pointer}).

%% @doc The first Count elements.
-spec read(library(), ptr(), non_neg_integer()) -> [term()].
read(Lib, Pointer, Count) -> request(Lib, {read, Pointer, Count}, {read, Pointer, Count}).

-spec read_bytes(library(), ptr(), non_neg_integer()) -> binary().
read_bytes(Lib, Pointer, Count) ->
    request(Lib, {read_bytes, Pointer, Count}, {read_bytes, Pointer, Count}).

%% @doc The forms without a library are for a process that has started just one.
-spec cstring(ptr()) -> binary().
cstring(Pointer) -> cstring(only_library(), Pointer).

-spec read(ptr(), non_neg_integer()) -> [term()].
read(Pointer, Count) -> read(only_library(), Pointer, Count).

-spec read_bytes(ptr(), non_neg_integer()) -> binary().
read_bytes(Pointer, Count) -> read_bytes(only_library(), Pointer, Count).

%% ---- about the library -------------------------------------------------------------------------

-spec functions(library()) -> [{fname(), [{atom(), ctype()}], ctype()}].
functions(Lib) -> request(Lib, functions, functions).

-spec globals(library()) -> [{fname(), ctype()}].
globals(Lib) -> request(Lib, globals, globals).

%% @doc Writes the coverage counts to the directory given to start/2, with the notes that gcov
%% needs beside them.
-spec flush_coverage(library()) -> ok.
flush_coverage(#lib{} = Lib) ->
    _ = request(Lib, flush_coverage, flush_coverage),
    collect_coverage(Lib);
flush_coverage(Name) ->
    flush_coverage(library(Name)).

collect_coverage(#lib{coverage = none}) -> ok;
collect_coverage(#lib{coverage = Dir}) -> cb_coverage:collect(Dir).

%% @doc The last crash, timeout, exit or sanitizer report since start.
-spec last_crash(library()) -> none | cb_crash:crash().
last_crash(#lib{transport = port, at = At}) -> cb_port:last_crash(At);
last_crash(#lib{transport = nif}) -> none;
last_crash(Name) -> last_crash(library(Name)).

%% ---- requests ----------------------------------------------------------------------------------

request(#lib{} = Lib, Request, In) -> value(ask(Lib, Request, In));
request(Name, Request, In) -> request(library(Name), Request, In).

ask(#lib{transport = port, at = At}, Request, In) -> cb_port:request(At, Request, In);
ask(#lib{at = Session, dirty = true}, Request, _) -> cb_nif:request_dirty(Session, Request);
ask(#lib{at = Session}, Request, _) -> cb_nif:request(Session, Request).

value({ok, Value}) -> Value;
value({error, Reason}) -> fail(Reason).

-spec fail(reason()) -> no_return().
fail(Reason) -> erlang:error({cb, Reason}).

library(#lib{} = Lib) ->
    Lib;
library(Name) ->
    case find(Name) of
        {ok, Lib} -> Lib;
        error -> fail({not_started, Name})
    end.

only_library() ->
    case maps:values(attached()) of
        [Lib] -> Lib;
        Libs -> fail({which_library, [Name || #lib{name = Name} <- Libs]})
    end.

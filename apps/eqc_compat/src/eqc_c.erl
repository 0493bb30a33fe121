%% @doc Quviq's eqc_c, by c_bridge.
%%
%% ```
%% ok = eqc_c:start(c_call, [{c_src, "airbag.c"}, {cppflags, "-Iinclude -Llib -lfaultcheck"}]),
%% P = eqc_c:create_array(unsigned_char, [85, 170]),
%% c_call:sensor(P),
%% 0 = eqc_c:value_of(airbag_active).
%% '''
%% There is one C program at a time; it belongs to the process that started it. `cb:start/2' says
%% what else it can do: `transport', `timeout', `sanitize' and its other options are passed on.
%% The command line option `--transport' of `rebar3 proper' wins over the model.
-module(eqc_c).

-export([start/1, start/2, stop/0, restart/0]).
-export([create_array/2, create_string/1, free/1, array_index/2, read_array/2, read_string/1]).
-export([value_of/1, set_value/2, address_of/1]).

-define(CURRENT, '$eqc_c').

-type c_type() :: cb:ctype().
-type ptr() :: cb:ptr().

%% @doc Compiles and loads Mod.c.
-spec start(module()) -> ok.
start(Mod) ->
    start(Mod, []).

%% @doc Compiles and loads C code; Mod has a function for each C function afterwards.
%%
%% `c_src' is a file name, several with blanks between them, or a list of names. `cppflags' and
%% `cflags' are one string each with any options of the compiler and linker.
-spec start(module(), [{atom(), term()}]) -> ok.
start(Mod, Options) ->
    case eqc_c_flags:options(Mod, Options) of
        {ok, Converted} ->
            case cb:start(Mod, Converted) of
                {ok, Lib} ->
                    _ = put(?CURRENT, Lib),
                    ok;
                {error, Reason} ->
                    error({cb, Reason})
            end;
        {error, Reason} ->
            error({cb, Reason})
    end.

-spec stop() -> ok.
stop() ->
    ok = cb:stop(current()),
    _ = erase(?CURRENT),
    ok.

%% @doc All C state as it was after start.
-spec restart() -> ok.
restart() ->
    case cb:restart(current()) of
        ok -> ok;
        {error, Reason} -> error({cb, Reason})
    end.

%% @doc An array in C memory, until the next restart.
-spec create_array(c_type(), [term()]) -> ptr().
create_array(Type, Values) ->
    cb:create_array(current(), Type, Values).

%% @doc A string in C memory, with the zero at its end.
-spec create_string(string() | binary()) -> ptr().
create_string(Text) ->
    Bytes = unicode:characters_to_binary(Text),
    cb:create_array(current(), char, <<Bytes/binary, 0>>).

-spec free(ptr()) -> ok.
free(Pointer) -> cb:free(current(), Pointer).

%% @doc The element of an array, counted from 0.
-spec array_index(ptr(), non_neg_integer()) -> term().
array_index(Pointer, Index) ->
    cb:value_of(current(), [Pointer, Index]).

%% @doc The first elements of an array.
-spec read_array(ptr(), non_neg_integer()) -> [term()].
read_array(Pointer, Count) ->
    cb:read(current(), Pointer, Count).

-spec read_string(ptr()) -> string().
read_string(Pointer) ->
    unicode:characters_to_list(cb:cstring(current(), Pointer)).

%% @doc The value of a global variable.
-spec value_of(atom()) -> term().
value_of(Variable) ->
    cb:value_of(current(), Variable).

-spec set_value(atom(), term()) -> ok.
set_value(Variable, Value) ->
    cb:set(current(), Variable, Value).

-spec address_of(atom()) -> ptr().
address_of(Variable) ->
    cb:address_of(current(), Variable).

current() ->
    case get(?CURRENT) of
        undefined -> error({cb, {not_started, eqc_c}});
        Lib -> Lib
    end.

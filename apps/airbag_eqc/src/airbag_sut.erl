%% @doc The airbag as the system under test of the calling process.
%%
%% Each process has one instance: begin_test/1 starts it when there is none, and from then on
%% resets it by calls of its own initialisers. It ends with its process.
%%
%% Environment of the application: `transport', and `library', the file where it is not to be
%% searched for.
-module(airbag_sut).

-export([begin_test/1, calls/1, value_of/1, flush_coverage/0, stop/0]).
-export([default_transport/1, library/0]).
-export_type([call/0]).

-type call() :: {atom(), [term()]}.

-define(LIBRARY, "libairbag.so").

%% @doc Brings the airbag that the options describe into its state before the first message.
-spec begin_test(airbag_options:options()) -> ok.
begin_test(#{configuration := Configuration, needed := Needed}) ->
    Wanted = {Configuration, Needed},
    case get(?MODULE) of
        undefined ->
            start(Wanted);
        {Wanted, Sut} ->
            restarted(cb:restart(Sut));
        {_AtStart, Sut} ->
            ok = restarted(cb:restart(Sut)),
            [0, _] = cb:call_batch(Sut, configure(Wanted)),
            ok
    end.

restarted(ok) -> ok;
restarted({error, Reason}) -> error({cb, Reason}).

start(Wanted) ->
    Start = [
        {so, library()},
        {transport, application:get_env(airbag_eqc, transport, nif)},
        {reset, {calls, reset() ++ configure(Wanted)}},
        {module, false}
    ],
    case cb:start(airbag, Start) of
        {ok, Sut} ->
            _ = put(?MODULE, {Wanted, Sut}),
            ok;
        {error, Reason} ->
            error({cb, Reason})
    end.

%% The iteration takes out what an earlier test may have left in the channel.
reset() ->
    [
        {faultcheck_removeAllFaults, []},
        {faultcheck_packet_removeAllFaults, []},
        {airbag_iteration, []}
    ].

configure({Configuration, Needed}) ->
    [{airbag_configure, [configuration(Configuration), Needed]}, {application_init, []}].

configuration(thesis) -> 'AIRBAG_THESIS';
configuration(recommended) -> 'AIRBAG_RECOMMENDED'.

%% @doc Makes the calls in one message; their values in order.
-spec calls([call()]) -> [term()].
calls(Calls) ->
    {_, Sut} = get(?MODULE),
    cb:call_batch(Sut, Calls).

%% @doc A global of the airbag.
-spec value_of(atom()) -> term().
value_of(Name) ->
    {_, Sut} = get(?MODULE),
    cb:value_of(Sut, Name).

%% @doc Writes the line counts of a library built for coverage.
-spec flush_coverage() -> ok.
flush_coverage() ->
    {_, Sut} = get(?MODULE),
    cb:flush_coverage(Sut).

%% @doc Ends the calling process's instance.
-spec stop() -> ok.
stop() ->
    case erase(?MODULE) of
        undefined -> ok;
        {_, Sut} -> cb:stop(Sut)
    end.

%% @doc The transport where no runner asks for one. The shipped models ask for nif.
-spec default_transport(nif | port) -> ok.
default_transport(Transport) ->
    application:set_env(airbag_eqc, transport, Transport).

%% @doc The library file: of FAULTCHECK_LIB_DIR, of the clone, or of an installation.
-spec library() -> file:filename().
library() ->
    case application:get_env(airbag_eqc, library) of
        {ok, File} -> File;
        undefined -> search()
    end.

search() ->
    Places = places(os:getenv("FAULTCHECK_LIB_DIR")),
    case [File || Dir <- Places, File <- [filename:join(Dir, ?LIBRARY)], filelib:is_file(File)] of
        [File | _] -> File;
        [] -> error({cb, {load, ?LIBRARY, {dlerror, nowhere(Places)}}})
    end.

places(Dir) when is_list(Dir), Dir =/= "" ->
    [Dir];
places(_) ->
    %% PREFIX/lib/faultcheck/airbag_eqc-VERSION, or _build/PROFILE/lib/airbag_eqc
    App = filename:dirname(filename:dirname(filename:absname(code:which(?MODULE)))),
    Up = filename:dirname(filename:dirname(App)),
    [Up, filename:join([filename:dirname(Up), "native", "lib"]), "_build/native/lib"].

nowhere(Places) ->
    unicode:characters_to_binary([
        "not in ",
        lists:join(", ", Places),
        "; run `make native` or set FAULTCHECK_LIB_DIR to its directory"
    ]).

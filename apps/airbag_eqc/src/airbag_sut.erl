%% @doc The airbag as the system under test of the calling process.
%%
%% Each process has one instance: begin_test/1 starts it when there is none, and from then on
%% resets it by calls of its own initialisers. It ends with its process.
%%
%% Environment of the application: `transport', and `library', the file where it is not to be
%% searched for.
-module(airbag_sut).

-export([begin_test/1, calls/1, value_of/1, recorded/0, record/0, flush_coverage/0, stop/0]).
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

%% @doc Records all packets from now on.
-spec record() -> ok.
record() ->
    {_, Sut} = get(?MODULE),
    ok = faultcheck_record:start(Sut, null).

%% @doc What was recorded; the recording ends.
-spec recorded() -> [faultcheck_record:call()].
recorded() ->
    {_, Sut} = get(?MODULE),
    {ok, Recording} = faultcheck_record:stop(Sut, null),
    {ok, Calls} = faultcheck_record:calls(Recording),
    Calls.

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
        undefined -> cb_library:find(?LIBRARY, ?MODULE)
    end.

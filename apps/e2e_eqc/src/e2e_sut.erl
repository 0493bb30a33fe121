%% @doc libe2e as the system under test of the calling process: a sender and a receiver of one
%% profile and a state machine behind them, in memory of the library.
%%
%% Return values, statuses and verdicts come as the atoms of e2e_receiver.
%%
%% Environment of the application: `transport', and `library', the file where it is not to be
%% searched for.
-module(e2e_sut).

-export([prepare/0, open/3, stop/0, library/0]).
-export([protect/1, check/1, judge/2, map_status/4, step_machine/1]).
-export([sender/0, receiver/0, machine/0, set_counter/1, set_machine_state/1]).
-export([initialise/1, initialise_null/1, misuse_protect/3, misuse_check/3, misuse_machine/1]).
-export([check_config/2, crc/2, crc/3]).
-export_type([null/0]).

-type null() :: config | state | data.

-define(LIBRARY, "libe2e.so").

%% @doc Loads the library, or frees what an earlier test left in it.
-spec prepare() -> ok.
prepare() ->
    case get(?MODULE) of
        undefined -> start();
        Sut -> restarted(cb:restart(lib(Sut)))
    end.

restarted(ok) -> ok;
restarted({error, Reason}) -> error({cb, Reason}).

start() ->
    Options = [
        {so, library()},
        {transport, application:get_env(e2e_eqc, transport, nif)},
        {reset, {calls, []}},
        {module, false}
    ],
    case cb:start(e2e, Options) of
        {ok, Lib} ->
            _ = put(?MODULE, #{lib => Lib}),
            ok;
        {error, Reason} ->
            error({cb, Reason})
    end.

-spec stop() -> ok.
stop() ->
    case erase(?MODULE) of
        undefined -> ok;
        Sut -> cb:stop(lib(Sut))
    end.

lib(#{lib := Lib}) -> Lib.

%% @doc A sender and a receiver of this configuration, and a state machine, each initialised: what
%% the three initialisers returned.
-spec open(e2e_packet:profile(), e2e_packet:config(), e2e_machine:config()) ->
    [e2e_receiver:answer()].
open(P, Config, Machine) ->
    Sut = #{lib := Lib} = get(?MODULE),
    #{'WindowSizeValid' := Size} = Machine,
    One = fun(Type, Value) -> cb:create_array(Lib, Type, [Value]) end,
    Window = cb:create_array(Lib, 'unsigned char', lists:duplicate(Size, 16#AA)),
    Open = Sut#{
        profile => P,
        config => One(type(P, "ConfigType"), Config),
        bytes => zeros(P, Config),
        sender => One(type(P, "ProtectStateType"), dirty_sender()),
        receiver => One(type(P, "CheckStateType"), dirty_receiver(P)),
        window => {Window, Size},
        machine_config => One('E2E_SMConfigType', Machine),
        machine => One('E2E_SMCheckStateType', #{
            'ProfileStatusWindow' => Window, 'WindowTopIndex' => 99, 'SMState' => 1
        })
    },
    _ = put(?MODULE, Open),
    #{machine := State, machine_config := MachineConfig} = Open,
    [
        initialise(sender),
        initialise(receiver),
        answer(cb:call(Lib, 'E2E_SMCheckInit', [State, MachineConfig]))
    ].

%% So that an initialiser that forgets a member is seen.
dirty_sender() -> #{'Counter' => 7}.

dirty_receiver(P) when P =:= p01; P =:= p02 ->
    Members = ['LastValidCounter', 'MaxDeltaCounter', 'WaitForFirstData', 'NewDataAvailable',
        'LostData', 'SyncCounter', 'NoNewOrRepeatedDataCounter'],
    maps:from_list([{'Status', 16#40} | [{M, 9} || M <- Members]]);
dirty_receiver(_) ->
    #{'Counter' => 7, 'Status' => 16#40}.

%% What profiles 1 and 2 are given when nothing was received.
zeros(P, Config) ->
    case e2e_packet:lengths(P, Config) of
        {_, Bytes} -> <<0:Bytes/unit:8>>;
        none -> <<0>>
    end.

type(P, What) -> list_to_atom("E2E_" ++ upper(P) ++ What).

upper(P) -> string:uppercase(atom_to_list(P)).

%% ---- the way of a packet ----------------------------------------------------------------------

%% @doc ProtectInit or CheckInit once more.
-spec initialise(sender | receiver) -> e2e_receiver:answer().
initialise(Side) ->
    #{lib := Lib, profile := P, Side := State} = get(?MODULE),
    answer(cb:call(Lib, type(P, init(Side)), [State])).

init(sender) -> "ProtectInit";
init(receiver) -> "CheckInit".

%% @doc Protects the bytes: what was returned, and the bytes then.
-spec protect(binary()) -> {e2e_receiver:answer(), binary()}.
protect(Bytes) ->
    #{config := Config, sender := State} = get(?MODULE),
    with_buffer(Bytes, fun(Buffer) -> {Config, State, Buffer, byte_size(Bytes)} end).

with_buffer(Bytes, Arguments) ->
    #{lib := Lib, profile := P} = get(?MODULE),
    Buffer = cb:create_array(Lib, 'unsigned char', Bytes),
    Returned = cb:call(Lib, type(P, "Protect"), arguments(P, Arguments(Buffer))),
    After = cb:read_bytes(Lib, Buffer, byte_size(Bytes)),
    ok = cb:free(Lib, Buffer),
    {answer(Returned), After}.

arguments(P, {Config, State, Data, Length}) ->
    [Config, State, Data | [Length || e2e_packet:has_length(P)]].

%% @doc Checks what was received: what was returned. Profiles 1 and 2 see a packet that is too
%% short as if zeros followed, since their buffer has a fixed size.
-spec check(binary() | none) -> e2e_receiver:answer().
check(Packet) ->
    #{lib := Lib, profile := P, config := Config, receiver := State} = Sut = get(?MODULE),
    {Data, Length} = received(P, Packet, Sut),
    answer(cb:call(Lib, type(P, "Check"), arguments(P, {Config, State, Data, Length}))).

received(P, Packet, #{bytes := Zeros} = Sut) when P =:= p01; P =:= p02 ->
    ok = announce(Packet =/= none, Sut),
    case Packet of
        none -> {Zeros, 0};
        _ -> {fixed(Packet, byte_size(Zeros)), 0}
    end;
received(_, none, _) ->
    {null, 0};
received(_, Packet, _) ->
    {Packet, byte_size(Packet)}.

announce(Arrived, #{lib := Lib, receiver := State}) ->
    cb:set(Lib, [State, 0, 'NewDataAvailable'], number(Arrived)).

number(true) -> 1;
number(false) -> 0.

fixed(Packet, Size) when byte_size(Packet) >= Size -> binary:part(Packet, 0, Size);
fixed(Packet, Size) -> <<Packet/binary, 0:(Size - byte_size(Packet))/unit:8>>.

%% @doc What the state machine is told of a check of this answer and the status it left.
-spec judge(e2e_receiver:answer(), Behaviour :: boolean()) -> e2e_receiver:verdict().
judge(Answer, Behaviour) ->
    #{profile := P} = get(?MODULE),
    #{'Status' := Status} = receiver(),
    map_status(P, Answer, list_to_atom(type_text(P, "STATUS_") ++ atom_to_list(Status)), Behaviour).

type_text(P, What) -> "E2E_" ++ upper(P) ++ What.

%% @doc MapStatusToSM of a profile; the status as its number or its name in C.
-spec map_status(
    e2e_packet:profile(), e2e_receiver:answer() | 0..255, atom() | integer(), boolean()
) -> e2e_receiver:verdict() | integer().
map_status(P, Answer, Status, Behaviour) ->
    Last = [number(Behaviour) || not e2e_packet:has_length(P)],
    Function = type(P, "MapStatusToSM"),
    verdict(cb:call(lib(get(?MODULE)), Function, [code(Answer), Status | Last])).

%% @doc Tells the state machine; what it returned.
-spec step_machine(e2e_receiver:verdict()) -> e2e_receiver:answer().
step_machine(Verdict) ->
    #{lib := Lib, machine := State, machine_config := Config} = get(?MODULE),
    answer(cb:call(Lib, 'E2E_SMCheck', [verdict_in_c(Verdict), Config, State])).

%% ---- the states -------------------------------------------------------------------------------

%% @doc The sender's Counter.
-spec sender() -> non_neg_integer().
sender() ->
    #{lib := Lib, sender := State} = get(?MODULE),
    [#{'Counter' := Counter}] = cb:read(Lib, State, 1),
    Counter.

-spec set_counter(non_neg_integer()) -> ok.
set_counter(Counter) ->
    #{lib := Lib, sender := State} = get(?MODULE),
    cb:set(Lib, [State, 0, 'Counter'], Counter).

%% @doc The receiver's state as the reference has it.
-spec receiver() -> e2e_receiver:state().
receiver() ->
    #{lib := Lib, profile := P, receiver := State} = get(?MODULE),
    [Members] = cb:read(Lib, State, 1),
    maps:update_with('Status', fun(S) -> status(P, S) end,
        maps:remove('NewDataAvailable', Members)).

%% @doc The state machine as the reference has it.
-spec machine() -> e2e_machine:machine().
machine() ->
    #{lib := Lib, machine := State, window := {Window, Size}} = get(?MODULE),
    [Members] = cb:read(Lib, State, 1),
    #{'WindowTopIndex' := Top, 'SMState' := Name} = Members,
    #{'OkCount' := Ok, 'ErrorCount' := Errors} = Members,
    Entries = [verdict_of(N) || N <- cb:read(Lib, Window, Size)],
    {Newest, Older} = lists:split(min(Top, Size), Entries),
    #{
        state => without("E2E_SM_", Name),
        window => lists:reverse(Newest) ++ lists:reverse(Older),
        top => Top,
        ok => Ok,
        errors => Errors
    }.

-spec set_machine_state(e2e_machine:name()) -> ok.
set_machine_state(Name) ->
    #{lib := Lib, machine := State} = get(?MODULE),
    cb:set(Lib, [State, 0, 'SMState'], list_to_atom("E2E_SM_" ++ atom_to_list(Name))).

%% ---- wrong calls ------------------------------------------------------------------------------

%% @doc An initialiser with NULL.
-spec initialise_null(sender | receiver) -> e2e_receiver:answer().
initialise_null(Side) ->
    #{lib := Lib, profile := P} = get(?MODULE),
    answer(cb:call(Lib, type(P, init(Side)), [null])).

%% @doc Protect with some arguments NULL and any Length.
-spec misuse_protect([null()], binary(), Length :: non_neg_integer()) ->
    {e2e_receiver:answer(), binary()}.
misuse_protect(Nulls, Bytes, Length) ->
    #{config := Config, sender := State} = get(?MODULE),
    with_buffer(Bytes, fun(Buffer) -> nulled(Nulls, {Config, State, Buffer, Length}) end).

%% @doc Check with some arguments NULL and any Length.
-spec misuse_check([null()], binary(), Length :: non_neg_integer()) -> e2e_receiver:answer().
misuse_check(Nulls, Bytes, Length) ->
    #{lib := Lib, profile := P, config := Config, receiver := State} = get(?MODULE),
    Arguments = arguments(P, nulled(Nulls, {Config, State, Bytes, Length})),
    answer(cb:call(Lib, type(P, "Check"), Arguments)).

nulled(Nulls, {Config, State, Data, Length}) ->
    Or = fun(Name, Value) ->
        case lists:member(Name, Nulls) of
            true -> null;
            false -> Value
        end
    end,
    {Or(config, Config), Or(state, State), Or(data, Data), Length}.

%% @doc SMCheck as it must not be called.
-spec misuse_machine({null, config | state} | {verdict, 6..255} | init_null) ->
    e2e_receiver:answer().
misuse_machine(How) ->
    #{lib := Lib, machine := State, machine_config := Config} = get(?MODULE),
    Call = fun(F, Arguments) -> answer(cb:call(Lib, F, Arguments)) end,
    case How of
        {null, config} -> Call('E2E_SMCheck', [0, null, State]);
        {null, state} -> Call('E2E_SMCheck', [0, Config, null]);
        {verdict, N} -> Call('E2E_SMCheck', [N, Config, State]);
        init_null -> Call('E2E_SMCheckInit', [null, Config])
    end.

%% ---- functions without state ------------------------------------------------------------------

%% @doc CheckConfig of a profile.
-spec check_config(e2e_packet:profile(), e2e_packet:config()) -> e2e_receiver:answer().
check_config(P, Config) ->
    answer(cb:call(lib(get(?MODULE)), type(P, "CheckConfig"), [Config])).

%% @doc The checksum of all the data.
-spec crc(e2e_crc:algorithm(), binary()) -> non_neg_integer().
crc(Algorithm, Data) ->
    cb:call(lib(get(?MODULE)), crc_name(Algorithm), [Data, byte_size(Data), 0, 1]).

%% @doc The checksum of what gave Earlier, followed by the data.
-spec crc(e2e_crc:algorithm(), Earlier :: non_neg_integer(), binary()) -> non_neg_integer().
crc(Algorithm, Earlier, Data) ->
    cb:call(lib(get(?MODULE)), crc_name(Algorithm), [Data, byte_size(Data), Earlier, 0]).

crc_name(Algorithm) ->
    list_to_atom("Crc_Calculate" ++ string:uppercase(atom_to_list(Algorithm))).

%% ---- what values mean -------------------------------------------------------------------------

answer(0) -> ok;
answer(16#13) -> input_null;
answer(16#17) -> input_wrong;
answer(16#19) -> internal;
answer(16#1A) -> wrong_state;
answer(Other) -> {unknown, Other}.

code(N) when is_integer(N) -> N;
code(ok) -> 0;
code(input_null) -> 16#13;
code(input_wrong) -> 16#17;
code(internal) -> 16#19;
code(wrong_state) -> 16#1A.

status(P, Name) -> without(type_text(P, "STATUS_"), Name).

verdict(Name) -> without("E2E_P_", Name).

verdict_in_c(Verdict) -> list_to_atom("E2E_P_" ++ atom_to_list(Verdict)).

verdict_of(N) when N =< 5 ->
    element(N + 1, {'OK', 'REPEATED', 'WRONGSEQUENCE', 'ERROR', 'NOTAVAILABLE', 'NONEWDATA'});
verdict_of(N) ->
    N.

%% A value that has no name in C stays a number.
without(Prefix, Name) when is_atom(Name) ->
    case string:prefix(atom_to_list(Name), Prefix) of
        nomatch -> Name;
        Rest -> list_to_atom(Rest)
    end;
without(_, Number) ->
    Number.

%% ---- where the library is -----------------------------------------------------------------------

%% @doc The library file: of FAULTCHECK_LIB_DIR, of the clone, or of an installation.
-spec library() -> file:filename().
library() ->
    case application:get_env(e2e_eqc, library) of
        {ok, File} -> File;
        undefined -> cb_library:find(?LIBRARY, ?MODULE)
    end.

%% @doc A whole communication, in the calling process: the sender of libe2e, a channel with faults,
%% the receiver of libe2e and the state machine that judges what it finds.
-module(e2e_link).

-export([open/4, send/1, fault/1, deliver/0, silence/0, clear/0]).
-export_type([delivery/0]).

%% One check and what it did: packet, answer, state, verdict for the state machine, its answer and
%% its state.
-type delivery() :: #{
    packet := binary() | none,
    answer := e2e_receiver:answer(),
    receiver := e2e_receiver:state(),
    verdict := e2e_receiver:verdict(),
    machine_answer := e2e_receiver:answer(),
    machine := e2e_machine:machine()
}.

%% @doc Everything as after the initialisers, whose answers are given.
-spec open(e2e_packet:profile(), e2e_packet:config(), e2e_machine:config(), boolean()) ->
    [e2e_receiver:answer()].
open(Profile, Config, Machine, Behaviour) ->
    _ = put(?MODULE, {Profile, Config, Behaviour}),
    ok = set_channel(e2e_channel:new()),
    e2e_sut:open(Profile, Config, Machine).

set_channel(Channel) ->
    _ = put({?MODULE, channel}, Channel),
    ok.

channel() -> get({?MODULE, channel}).

%% @doc Protects the data and puts it into the channel; the packet, and the sender's Counter then.
-spec send(binary()) -> {e2e_receiver:answer(), binary(), non_neg_integer()}.
send(Data) ->
    {Answer, Packet} = e2e_sut:protect(Data),
    ok = set_channel(e2e_channel:put(Packet, channel())),
    {Answer, Packet, e2e_sut:sender()}.

-spec fault(e2e_channel:fault()) -> ok.
fault(Fault) ->
    {Profile, Config, _} = get(?MODULE),
    set_channel(e2e_channel:apply(Fault, Profile, Config, channel())).

%% @doc Lets the receiver check what the channel delivers.
-spec deliver() -> delivery().
deliver() ->
    case e2e_channel:take(channel()) of
        {none, Channel} ->
            ok = set_channel(Channel),
            check(none);
        {{Packet, _}, Channel} ->
            ok = set_channel(Channel),
            check(Packet)
    end.

%% @doc Lets the receiver check while nothing is delivered.
-spec silence() -> delivery().
silence() -> check(none).

-spec clear() -> ok.
clear() -> set_channel(e2e_channel:clear(channel())).

check(Packet) ->
    {_, _, Behaviour} = get(?MODULE),
    Answer = e2e_sut:check(Packet),
    Receiver = e2e_sut:receiver(),
    Verdict = e2e_sut:judge(Answer, Behaviour),
    MachineAnswer = e2e_sut:step_machine(Verdict),
    #{
        packet => Packet,
        answer => Answer,
        receiver => Receiver,
        verdict => Verdict,
        machine_answer => MachineAnswer,
        machine => e2e_sut:machine()
    }.

%% @doc The model of a protected communication: a sender, a channel in which everything may happen
%% that ISO 26262 and AUTOSAR name, a receiver and its state machine, for any profile.
%%
%% Each answer and each state of libe2e is compared with the reference (e2e_packet, e2e_receiver,
%% e2e_machine). Two promises are stated beside it: a packet with fewer flipped bits than its
%% checksum's Hamming distance is not accepted, and fault-free packets bring the receiver back.
-module(e2e_eqc).
-include_lib("faultcheck/include/faultcheck.hrl").

%% PropEr 1.5 calls its property types opaque, though a plain boolean is one of them.
-dialyzer({[no_opaque, no_return], [agrees/1]}).

-export([use/1, agrees/1, recovery/2, next_counter/2, counter_sent/2]).

-record(state, {
    profile :: e2e_packet:profile(),
    config = none :: none | e2e_packet:config(),
    behaviour = true :: boolean(),
    machine_config = #{} :: e2e_machine:config(),
    %% the reference: the sender's Counter, the channel, the receiver, the state machine
    counter = 0 :: non_neg_integer(),
    channel = e2e_channel:new() :: e2e_channel:channel(),
    receiver = #{} :: e2e_receiver:state(),
    machine = #{} :: e2e_machine:machine() | #{}
}).

initial_state() ->
    #state{profile = get(?MODULE)}.

faults() -> [fault].

%% More deliveries than packets, so that repeated and inserted ones arrive; few when there are none.
weight(_S, send) -> 8;
weight(#state{channel = Channel}, deliver) -> min(3, 1 + e2e_channel:depth(Channel)) * 4;
weight(_S, fault) -> 6;
weight(_S, misuse) -> 2;
weight(_S, _) -> 1.

running(#state{config = Config}) -> Config =/= none.

%% ---- start: sender, receiver and state machine are initialised --------------------------------
start_pre(S) -> not running(S).
start_args(#state{profile = P}) ->
    [e2e_configuration:config(P), e2e_configuration:machine(), boolean()].
start_pre(#state{profile = P} = S, [Config, Machine, _]) ->
    start_pre(S) andalso e2e_configuration:usable(P, Config) andalso
        e2e_configuration:machine_usable(Machine).
start(Config, Machine, Behaviour) ->
    _ = put({?MODULE, running}, Config),
    Answers = e2e_link:open(get(?MODULE), Config, Machine, Behaviour),
    {Answers, e2e_sut:sender(), e2e_sut:receiver(), e2e_sut:machine()}.
start_next(#state{profile = P} = S, _Result, [Config, Machine, Behaviour]) ->
    S#state{
        config = Config,
        behaviour = Behaviour,
        machine_config = Machine,
        receiver = e2e_receiver:initial(P),
        machine = e2e_machine:initial(Machine)
    }.
start_post(#state{profile = P}, [_, Machine, _], Result) ->
    Expected = {[ok, ok, ok], 0, e2e_receiver:initial(P), e2e_machine:initial(Machine)},
    e2e_difference:same(Expected, Result).

%% ---- send: data is protected and goes into the channel ----------------------------------------
send_pre(S) -> running(S).
send_args(S) -> [payload(S)].
send_pre(S, [Data]) -> running(S) andalso fits(S, Data).
send(Data) -> e2e_link:send(Data).
send_next(#state{profile = P, counter = Counter, channel = Channel} = S, _Result, [Data]) ->
    S#state{
        counter = next_counter(P, Counter),
        channel = e2e_channel:put(packet(S, Data), Channel)
    }.
send_post(#state{profile = P, counter = Counter} = S, [Data], Result) ->
    e2e_difference:same({ok, packet(S, Data), next_counter(P, Counter)}, Result).

%% ---- fault: something happens in the channel --------------------------------------------------
fault_pre(S) -> running(S) andalso e2e_channel:sent(S#state.channel) > 0.
fault_args(S) -> [channel_fault(S)].
fault_pre(S, [Fault]) -> running(S) andalso e2e_channel:possible(Fault, S#state.channel).
fault(Fault) -> e2e_link:fault(Fault).
fault_next(#state{profile = P, config = Config, channel = Channel} = S, _Result, [Fault]) ->
    S#state{channel = e2e_channel:apply(Fault, P, Config, Channel)}.
fault_req(#state{profile = P}, [Fault], _Result) -> [{P, fault, element(1, Fault)}].

%% ---- deliver: the receiver checks what the channel gives --------------------------------------
deliver_pre(S) -> running(S).
deliver_args(_S) -> [].
deliver() -> e2e_link:deliver().
deliver_next(S, _Result, []) -> element(2, delivered(S)).
deliver_post(#state{profile = P, config = Config, channel = Channel} = S, [], Result) ->
    {Expected, _} = delivered(S),
    case {e2e_difference:same(Expected, Result), e2e_channel:take(Channel)} of
        {true, {{Bytes, Flipped}, _}} when is_list(Flipped), Flipped =/= [] ->
            seen(P, Config, byte_size(Bytes), length(Flipped), Result);
        {Same, _} ->
            Same
    end.
deliver_req(#state{profile = P, machine = #{state := Before}}, [], Result) ->
    #{answer := Answer, receiver := #{'Status' := Status}, machine := #{state := After}} = Result,
    [{P, status, Status} || Answer =:= ok] ++ [{P, answer, Answer} || Answer =/= ok] ++
        [{machine, Before, After}].

%% Fewer flipped bits than the Hamming distance: the packet is not accepted.
seen(P, Config, Bytes, Flips, #{answer := Answer, receiver := #{'Status' := Status}}) ->
    Refused = Answer =/= ok orelse Status =:= 'ERROR' orelse Status =:= 'WRONGCRC',
    case Refused orelse not e2e_distance:exceeds(Flips, P, Config, Bytes) of
        true -> true;
        false -> {accepted_with_flips, Flips, Status}
    end.

%% ---- silence: checks while nothing arrives ----------------------------------------------------
silence_pre(S) -> running(S).
%% Up to more than any counter of checks counts.
silence_args(_S) -> [integer(1, 20)].
silence_pre(S, [_N]) -> running(S).
silence(N) -> [e2e_link:silence() || _ <- lists:seq(1, N)].
silence_next(S, _Result, [N]) -> element(2, silent(N, S)).
silence_post(S, [N], Result) -> e2e_difference:same(element(1, silent(N, S)), Result).
silence_req(#state{profile = P}, _Args, _Result) -> [{P, status, 'NONEWDATA'}].

silent(N, S) -> repeatedly(N, S, fun(At) -> checked(none, At) end).

%% ---- sender_at: a sender that has been sending for long ---------------------------------------
sender_at_pre(S) -> running(S).
sender_at_args(#state{profile = P}) ->
    Top = e2e_packet:counters(P) - 1,
    [oneof([uniform(0, Top), integer(Top - 3, Top), min(Top, 255), min(Top, 65534)])].
sender_at_pre(#state{profile = P} = S, [Counter]) ->
    running(S) andalso Counter < e2e_packet:counters(P).
sender_at(Counter) -> e2e_sut:set_counter(Counter).
sender_at_next(S, _Result, [Counter]) -> S#state{counter = Counter}.

%% ---- restart: one side is initialised again ---------------------------------------------------
restart_pre(S) -> running(S).
restart_args(_S) -> [oneof([sender, receiver])].
restart_pre(S, [_Side]) -> running(S).
restart(Side) -> {e2e_sut:initialise(Side), e2e_sut:sender(), e2e_sut:receiver()}.
restart_next(S, _Result, [sender]) -> S#state{counter = 0};
restart_next(#state{profile = P} = S, _Result, [receiver]) ->
    S#state{receiver = e2e_receiver:initial(P)}.
restart_post(S, [Side], Result) ->
    #state{counter = Counter, receiver = Receiver} = restart_next(S, Result, [Side]),
    e2e_difference:same({ok, Counter, Receiver}, Result).

%% ---- recover: fault-free packets bring the receiver back --------------------------------------
recover_pre(S) -> running(S).
recover_args(S) -> [payload(S)].
recover_pre(S, [Data]) -> running(S) andalso fits(S, Data).
recover(Data) ->
    Packets = recovery(get(?MODULE), get({?MODULE, running})),
    ok = e2e_link:clear(),
    Step = fun(_) ->
        {_, _, _} = e2e_link:send(Data),
        e2e_link:deliver()
    end,
    lists:map(Step, lists:seq(1, Packets)).
recover_next(S, _Result, [Data]) -> element(2, recovered(S, Data)).
recover_post(#state{config = Config} = S, [Data], Result) ->
    {Expected, _} = recovered(S, Data),
    #{receiver := #{'Status' := Last}} = lists:last(Result),
    case e2e_difference:same(Expected, Result) of
        true when Last =:= 'OK' -> true;
        %% a receiver that accepts no step at all never says OK
        true -> maps:get('MaxDeltaCounter', Config, 1) =:= 0 orelse {not_recovered, Last};
        Different -> Different
    end.
recover_req(#state{profile = P}, _Args, _Result) -> [{P, recovered}].

recovered(#state{profile = P, config = Config, channel = Channel} = S, Data) ->
    Step = fun(At) -> delivered(send_next(At, sent, [Data])) end,
    repeatedly(recovery(P, Config), S#state{channel = e2e_channel:clear(Channel)}, Step).

%% @doc After so many fault-free packets the status is OK, whatever was before. One packet
%% resynchronises the later profiles. Profiles 1 and 2 may have to wait until the counter has
%% wrapped, and then for SYNC to end.
-spec recovery(e2e_packet:profile(), e2e_packet:config()) -> pos_integer().
recovery(P, #{'SyncCounterInit' := Sync}) -> e2e_packet:counters(P) + Sync + 3;
recovery(_, _) -> 2.

%% ---- misuse: calls that must be refused and change nothing ------------------------------------
misuse_pre(S) -> running(S).
misuse_args(S) -> [wrong_call(S)].
misuse_pre(S, [Call]) -> running(S) andalso refusal(Call, S) =/= none.
misuse(Call) -> {wrong(Call), e2e_sut:sender(), e2e_sut:receiver(), e2e_sut:machine()}.
misuse_post(S, [Call], Result) ->
    #state{counter = Counter, receiver = Receiver, machine = Machine} = S,
    e2e_difference:same({refusal(Call, S), Counter, Receiver, Machine}, Result).
misuse_req(#state{profile = P} = S, [Call], _Result) -> [{P, refused, refusal(Call, S)}].

wrong_call(#state{profile = P, config = Config}) ->
    {Min, Max} = e2e_packet:lengths(P, Config),
    Nulls = oneof([[config], [state], [data], [config, state, data]]),
    Length = oneof([0, 1, Min - 1, Max + 1, integer(1, Max + 8)]),
    Lengths = case e2e_packet:has_length(P) of true -> 4; false -> 0 end,
    Machine = oneof([{null, config}, {null, state}, init_null, {verdict, integer(6, 255)}]),
    frequency([
        {3, {protect, Nulls, Max, Max}},
        {3, {check, Nulls, Max, Max}},
        {Lengths, {protect, [], Max + 8, Length}},
        {Lengths, {check, [], Max + 8, Length}},
        {1, {initialise, oneof([sender, receiver])}},
        {2, {machine, Machine}},
        {1, {machine, deinit}}
    ]).

wrong({protect, Nulls, Bytes, Length}) ->
    Data = <<16#5A:8, 0:(Bytes - 1)/unit:8>>,
    case e2e_sut:misuse_protect(Nulls, Data, Length) of
        {Answer, Data} -> Answer;
        {Answer, Other} -> {Answer, changed, Other}
    end;
wrong({check, Nulls, Bytes, Length}) ->
    e2e_sut:misuse_check(Nulls, <<0:Bytes/unit:8>>, Length);
wrong({initialise, Side}) ->
    e2e_sut:initialise_null(Side);
wrong({machine, deinit}) ->
    #{state := Name} = e2e_sut:machine(),
    ok = e2e_sut:set_machine_state('DEINIT'),
    Answer = e2e_sut:step_machine('OK'),
    ok = e2e_sut:set_machine_state(Name),
    Answer;
wrong({machine, How}) ->
    e2e_sut:misuse_machine(How).

%% What a wrong call must answer; none when it is not wrong.
refusal({initialise, _}, _) -> input_null;
refusal({machine, deinit}, _) -> wrong_state;
refusal({machine, {verdict, _}}, _) -> input_wrong;
refusal({machine, _}, _) -> input_null;
refusal({check, [data], _, Length}, #state{profile = P}) when P =/= p01, P =/= p02, Length > 0 ->
    input_wrong;
refusal({_, [_ | _], _, _}, _) -> input_null;
refusal({_, [], _, _}, #state{profile = P}) when P =:= p01; P =:= p02 -> none;
refusal({_, [], Bytes, Length}, #state{profile = P, config = Config}) when Length =< Bytes ->
    case e2e_packet:length_fits(P, Config, Length) of
        true -> none;
        false -> input_wrong
    end;
refusal({_, [], _, _}, _) -> none.

%% ---- the reference ------------------------------------------------------------------------------

packet(#state{profile = P, config = Config, counter = Counter}, Data) ->
    e2e_packet:protect(P, Config, counter_sent(P, Counter), Data).

%% @doc The counter in the packet that a sender with this Counter makes.
-spec counter_sent(e2e_packet:profile(), non_neg_integer()) -> non_neg_integer().
counter_sent(P, Counter) ->
    (Counter + e2e_packet:first_counter(P)) rem e2e_packet:counters(P).

%% @doc The sender's Counter afterwards.
-spec next_counter(e2e_packet:profile(), non_neg_integer()) -> non_neg_integer().
next_counter(P, Counter) -> (Counter + 1) rem e2e_packet:counters(P).

delivered(#state{channel = Channel} = S) ->
    case e2e_channel:take(Channel) of
        {none, Rest} -> checked(none, S#state{channel = Rest});
        {{Packet, _}, Rest} -> checked(Packet, S#state{channel = Rest})
    end.

checked(Packet, #state{profile = P, config = Config, receiver = Receiver} = S) ->
    {Answer, Checked} = e2e_receiver:check(P, Config, Receiver, in_buffer(P, Config, Packet)),
    #{'Status' := Status} = Checked,
    Verdict = e2e_receiver:to_machine(P, Answer, Status, S#state.behaviour),
    {MachineAnswer, Machine} = e2e_machine:check(S#state.machine_config, S#state.machine, Verdict),
    Delivery = #{
        packet => Packet,
        answer => Answer,
        receiver => Checked,
        verdict => Verdict,
        machine_answer => MachineAnswer,
        machine => Machine
    },
    {Delivery, S#state{receiver = Checked, machine = Machine}}.

%% Profiles 1 and 2 look at a buffer of fixed size, zeros where the packet is too short.
in_buffer(P, Config, Packet) when is_binary(Packet), P =:= p01 orelse P =:= p02 ->
    {_, Size} = e2e_packet:lengths(P, Config),
    <<Buffer:Size/binary, _/binary>> = <<Packet/binary, 0:Size/unit:8>>,
    Buffer;
in_buffer(_, _, Packet) ->
    Packet.

repeatedly(N, S, Step) ->
    lists:mapfoldl(fun(_, At) -> Step(At) end, S, lists:seq(1, N)).

%% ---- generators ---------------------------------------------------------------------------------

payload(#state{profile = P, config = Config}) ->
    {Min, Max} = e2e_packet:lengths(P, Config),
    ?LET(Length, integer(Min, Max), oneof([binary(Length), <<0:Length/unit:8>>])).

fits(#state{profile = P, config = Config}, Data) ->
    e2e_packet:length_fits(P, Config, byte_size(Data)).

%% What can happen to the queue as it is. Corruption in half of the cases, of few bits mostly:
%% that is where the checksum's promise holds.
channel_fault(#state{channel = Channel} = S) ->
    Depth = e2e_channel:depth(Channel),
    Insert = {2, {insert, integer(0, e2e_channel:sent(Channel) - 1)}},
    case e2e_channel:head(Channel) of
        none -> frequency([Insert, {1, {delay, integer(1, 3)}}]);
        {Bytes, _} -> frequency([
            Insert,
            {1, {delay, integer(1, 3)}},
            {2, {lose, integer(1, Depth)}},
            {2, {repeat, integer(1, 3)}},
            {if Depth > 1 -> 2; true -> 0 end, {resequence, integer(1, max(1, Depth - 1))}},
            {6, {corrupt, flips(bit_size(Bytes))}},
            {1, {truncate, integer(1, max(1, byte_size(Bytes) - 1))}},
            {1, {extend, ?LET(N, integer(1, 3), binary(N))}},
            {4, {forge, change(S)}}
        ])
    end.

flips(Bits) ->
    ?LET(
        N,
        frequency([{8, integer(1, 4)}, {1, integer(5, 12)}]),
        ?LET(Flips, vector(min(N, Bits), uniform(0, Bits - 1)), lists:usort(Flips))
    ).

change(#state{profile = P, config = Config, counter = Counter}) ->
    N = e2e_packet:counters(P),
    Near = ?LET(Step, integer(-3, 3), (Counter + Step + N) rem N),
    Room = if N =:= 15 -> 15; true -> N - 1 end,
    oneof([
        {counter, oneof([Near, uniform(0, Room), Room])},
        {id, other_id(Config)},
        {length, length_field(P, Config)}
    ]).

%% Also one with the same low byte, which is all that some modes put into the checksum.
other_id(#{'DataID' := Id}) ->
    oneof([uniform(0, 16#FFF), ?LET(High, integer(1, 15), Id bxor (High bsl 8))]);
other_id(_) ->
    uniform(0, 16#FFF).

length_field(P, Config) ->
    {Min, Max} = e2e_packet:lengths(P, Config),
    integer(Min - 1, Max + 1).

%% ---- the property -----------------------------------------------------------------------------

%% @doc Chooses the profile that the model is of, in the calling process.
-spec use(e2e_packet:profile()) -> ok.
use(Profile) ->
    _ = put(?MODULE, Profile),
    ok.

%% @doc The property: libe2e and the reference agree on every step of every sequence.
-spec agrees(e2e_packet:profile()) -> proper:outer_test().
agrees(Profile) ->
    ?SETUP(
        fun() ->
            ok = use(Profile),
            fun() -> ok end
        end,
        ?FORALL(Commands, more_commands(2, commands(?MODULE)), begin
            ok = use(Profile),
            ok = e2e_sut:prepare(),
            {_, _, Result} = Run = run_commands(?MODULE, Commands),
            ?WHENFAIL(
                io:put_chars(faultcheck_statem:pretty(?MODULE, Commands, Run)),
                aggregate(command_names(Commands), Result =:= ok)
            )
        end)
    ).

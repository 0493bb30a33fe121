%% @doc A run of the airbag's commands, packet by packet: what was sent, what arrived, and what the
%% airbag made of it.
%%
%% The commands run on the real library, each with a recording of libfaultcheck: packets as they
%% were put into the channel and as they came out of it, and behind each what the airbag says of
%% itself (airbag.h).
-module(airbag_trace).

-export([run/2, flipped/1, packets/1, failed_at/1]).
-export_type([trace/0, step/0, packet/0, status/0]).

-type command() :: faultcheck_statem:command().
-type status() ::
    ok
    | no_new_data
    | wrong_crc
    | sync
    | initial
    | repeated
    | ok_some_lost
    | wrong_sequence
    | rejected.
-type packet() :: #{
    %% as it arrived
    bytes := binary(),
    %% as it was sent; unknown when it cannot be told which one it was
    sent := binary() | unknown,
    %% of E2E_P01Check; none for a bare packet, or one of a wrong length
    status := status() | none,
    %% behind it: messages that fire, counted in succession; whether the airbag has fired
    activations := non_neg_integer(),
    fired := boolean()
}.
-type step() :: #{
    command := command(),
    name := atom(),
    args := [term()],
    %% while it ran, or from it on, in the order of arming; nothing when it was not run
    armed := [airbag_eqc:fault()],
    sent := [binary()],
    received := [packet()],
    %% none: not run
    value := {value, term()} | none
}.
-type trace() :: #{
    options := airbag_options:options(),
    steps := [step()],
    result := faultcheck_run:result(),
    %% bytes at the beginning of a protected packet that its checksum covers, with the checksum in
    %% byte 0; 0 for bare packets
    covered := non_neg_integer()
}.

%% @doc Runs commands up to the end, or the one that fails.
-spec run(airbag_options:options(), [command()]) -> trace().
run(Options, Commands) ->
    ok = airbag_eqc:begin_test(Options),
    Key = make_ref(),
    ok = airbag_sut:record(),
    Observe = fun(_) ->
        self() ! {Key, airbag_sut:recorded()},
        airbag_sut:record()
    end,
    {History, _, Result} = faultcheck_run:commands(airbag_eqc, Commands, [], Observe),
    Recordings = recordings(Key) ++ [airbag_sut:recorded() || is_alive(Result)],
    Values = [{value, Value} || {_, Value} <- History],
    #{
        options => Options,
        steps => steps(Commands, Values, Recordings, []),
        result => Result,
        covered => covered(Options)
    }.

recordings(Key) ->
    receive
        {Key, Calls} -> [Calls | recordings(Key)]
    after 0 -> []
    end.

%% Of a crash there is no recording.
is_alive({exception, _, _, _}) -> false;
is_alive(_) -> true.

covered(#{protection := plain}) ->
    0;
covered(#{protection := e2e}) ->
    #{'DataLength' := Bits} = airbag_sut:value_of(config),
    Bits div 8.

steps([], _, _, _) ->
    [];
steps([{set, _, {call, _, Name, Args}} = Command | Commands], Values, Recordings, Before) ->
    {Value, OtherValues} = next(Values, none),
    {Calls, OtherRecordings} = next(Recordings, []),
    Armed = armed(Name, Args, Value, Before),
    Sent = [Bytes || #{kind := put, before := Bytes} <- Calls],
    Received = origins(Sent, received(Calls)),
    Step = #{
        command => Command,
        name => Name,
        args => Args,
        armed => Armed,
        sent => Sent,
        received => Received,
        value => Value
    },
    [Step | steps(Commands, OtherValues, OtherRecordings, still_armed(Armed, Received))].

next([], Default) -> {Default, []};
next([Head | Tail], _) -> {Head, Tail}.

armed(_, _, none, _) -> [];
armed(bit_flip, [Byte, Bit], _, Before) -> Before ++ [{bitflip, Byte, Bit}];
armed(repetition, [Num], _, Before) -> Before ++ [{repetition, Num}];
armed(explosion, _, _, _) -> [];
armed(_, _, _, Before) -> Before.

%% A repetition is for one packet.
still_armed(Armed, []) -> Armed;
still_armed(Armed, [_ | _]) -> [Fault || {bitflip, _, _} = Fault <- Armed].

%% What follows a packet, up to the next one, belongs to it.
received([]) ->
    [];
received([#{kind := get, 'after' := Bytes} | Rest]) ->
    {Monitored, Others} = lists:splitwith(fun(#{kind := Kind}) -> Kind =:= monitor end, Rest),
    Said = maps:from_list([{Id, Value} || #{id := Id, 'after' := Value} <- Monitored]),
    Packet = #{
        bytes => Bytes,
        sent => unknown,
        status => status(maps:get(<<"airbag_status">>, Said, none)),
        activations => maps:get(<<"activations">>, Said),
        fired => maps:get(<<"airbag_fired">>, Said) =:= 1
    },
    [Packet | received(Others)];
received([_ | Rest]) ->
    received(Rest).

%% Of one message all copies are; otherwise there must be one packet for each, in order.
origins([Sent], Received) ->
    [Packet#{sent := Sent} || Packet <- Received];
origins(Sent, Received) when length(Sent) =:= length(Received) ->
    [Packet#{sent := Bytes} || {Bytes, Packet} <- lists:zip(Sent, Received)];
origins(_, Received) ->
    Received.

%% As E2E_P01.h numbers them; -1 is the airbag's own.
status(none) -> none;
status(-1) -> rejected;
status(16#00) -> ok;
status(16#01) -> no_new_data;
status(16#02) -> wrong_crc;
status(16#03) -> sync;
status(16#04) -> initial;
status(16#08) -> repeated;
status(16#20) -> ok_some_lost;
status(16#40) -> wrong_sequence.

%% @doc The bits of a packet that were inverted on the way, by byte and bit.
-spec flipped(packet()) -> [{Byte :: non_neg_integer(), Bit :: 0..7}].
flipped(#{sent := Sent, bytes := Bytes}) when
    is_binary(Sent), byte_size(Sent) =:= byte_size(Bytes)
->
    [
        {Byte, Bit}
     || {Byte, A, B} <- lists:zip3(
            lists:seq(0, byte_size(Sent) - 1), binary_to_list(Sent), binary_to_list(Bytes)
        ),
        Bit <- lists:seq(0, 7),
        (A bxor B) band (1 bsl Bit) =/= 0
    ];
flipped(_) ->
    [].

%% @doc The number of the command that failed; of a precondition that is the first one not run.
-spec failed_at(trace()) -> pos_integer() | none.
failed_at(#{result := ok}) ->
    none;
failed_at(#{result := Result, steps := Steps}) ->
    Ran = length([ran || #{value := {value, _}} <- Steps]),
    case Result of
        {precondition, _} -> Ran + 1;
        _ -> Ran
    end.

%% @doc All packets that arrived, numbered from 1, each with the number of its command.
-spec packets(trace()) -> [{pos_integer(), Command :: pos_integer(), packet()}].
packets(#{steps := Steps}) ->
    All = [
        {Number, Packet}
     || {Number, #{received := Received}} <- lists:zip(lists:seq(1, length(Steps)), Steps),
        Packet <- Received
    ],
    [{N, Step, P} || {N, {Step, P}} <- lists:zip(lists:seq(1, length(All)), All)].

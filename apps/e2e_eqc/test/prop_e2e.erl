%% @doc Properties of libe2e: every profile against the reference, the state machine, the checksums
%% and the functions without state.
-module(prop_e2e).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([
    prop_p01/0, prop_p01/1, prop_p02/0, prop_p02/1, prop_p04/0, prop_p04/1,
    prop_p05/0, prop_p05/1, prop_p06/0, prop_p06/1, prop_p07/0, prop_p07/1,
    prop_p08/0, prop_p08/1, prop_p11/0, prop_p11/1, prop_p22/0, prop_p22/1,
    prop_p44/0, prop_p44/1,
    prop_machine/0, prop_machine/1,
    prop_checksums/0, prop_checksums/1,
    prop_map_status/0, prop_map_status/1,
    prop_p01_check_config/0, prop_p01_check_config/1
]).

-define(SETTINGS, [{numtests, 100}, {transport, nif}]).

%% ---- the profiles -----------------------------------------------------------------------------

prop_p01() -> e2e_eqc:agrees(p01).
prop_p01(doc) -> "Profile 1 does what the standard says, whatever happens in the channel";
prop_p01(opts) -> ?SETTINGS.

prop_p02() -> e2e_eqc:agrees(p02).
prop_p02(doc) -> "Profile 2, in the same way";
prop_p02(opts) -> ?SETTINGS.

prop_p04() -> e2e_eqc:agrees(p04).
prop_p04(doc) -> "Profile 4, in the same way";
prop_p04(opts) -> ?SETTINGS.

prop_p05() -> e2e_eqc:agrees(p05).
prop_p05(doc) -> "Profile 5, in the same way";
prop_p05(opts) -> ?SETTINGS.

prop_p06() -> e2e_eqc:agrees(p06).
prop_p06(doc) -> "Profile 6, in the same way";
prop_p06(opts) -> ?SETTINGS.

prop_p07() -> e2e_eqc:agrees(p07).
prop_p07(doc) -> "Profile 7, in the same way";
prop_p07(opts) -> ?SETTINGS.

prop_p08() -> e2e_eqc:agrees(p08).
prop_p08(doc) -> "Profile 8, in the same way";
prop_p08(opts) -> ?SETTINGS.

prop_p11() -> e2e_eqc:agrees(p11).
prop_p11(doc) -> "Profile 11, in the same way";
prop_p11(opts) -> ?SETTINGS.

prop_p22() -> e2e_eqc:agrees(p22).
prop_p22(doc) -> "Profile 22, in the same way";
prop_p22(opts) -> ?SETTINGS.

prop_p44() -> e2e_eqc:agrees(p44).
prop_p44(doc) -> "Profile 44, in the same way";
prop_p44(opts) -> ?SETTINGS.

%% ---- the state machine --------------------------------------------------------------------------

%% Verdicts of its own, not only those that a channel brings about.
prop_machine() ->
    ?FORALL(
        {Config, Verdicts},
        {e2e_configuration:machine(), list(verdict())},
        begin
            ok = e2e_sut:prepare(),
            [ok, ok, ok] = e2e_sut:open(p05, e2e_configuration:example(p05), Config),
            {Real, _} = lists:mapfoldl(fun step/2, sut, Verdicts),
            Start = e2e_machine:initial(Config),
            {Reference, _} = lists:mapfoldl(
                fun(V, Machine) ->
                    {_, Next} = Result = e2e_machine:check(Config, Machine, V),
                    {Result, Next}
                end,
                Start,
                Verdicts
            ),
            ?WHENFAIL(
                io:format("reference ~0p~nlibe2e    ~0p~n", [Reference, Real]),
                Real =:= Reference
            )
        end
    ).

prop_machine(doc) -> "The state machine's states, counts and window, for any verdicts";
prop_machine(opts) -> [{numtests, 500}, {max_size, 60}, {transport, nif}].

step(Verdict, sut) -> {{e2e_sut:step_machine(Verdict), e2e_sut:machine()}, sut}.

%% OK and ERROR move it; the others mostly show that they do not.
verdict() ->
    frequency([
        {6, 'OK'},
        {3, 'ERROR'},
        {1, oneof(['REPEATED', 'WRONGSEQUENCE', 'NOTAVAILABLE', 'NONEWDATA'])}
    ]).

%% ---- checksums ----------------------------------------------------------------------------------

%% Lengths around the eight bytes that are taken at a time, and longer.
prop_checksums() ->
    ?FORALL(
        {Algorithm, Data},
        {oneof(e2e_crc:algorithms()), oneof([binary(), ?LET(N, integer(0, 300), binary(N))])},
        ?FORALL(At, integer(0, byte_size(Data)), begin
            ok = e2e_sut:prepare(),
            <<Before:At/binary, After/binary>> = Data,
            Whole = e2e_crc:calculate(Algorithm, Data),
            First = e2e_crc:calculate(Algorithm, Before),
            Whole =:= e2e_sut:crc(Algorithm, Data) andalso
                Whole =:= e2e_sut:crc(Algorithm, First, After) andalso
                Whole =:= e2e_crc:continue(Algorithm, First, After)
        end)
    ).

prop_checksums(doc) -> "Every checksum is the remainder of a division, in one or in two calls";
prop_checksums(opts) -> [{numtests, 500}, {transport, nif}].

%% ---- functions without state --------------------------------------------------------------------

prop_map_status() ->
    ?FORALL(
        {P, Answer, Status, Behaviour},
        {oneof(e2e_packet:profiles()), oneof([0, 0, 0, 16#13, 16#17, 1, byte()]),
            oneof([0, 1, 2, 3, 4, 7, 8, 16#20, 16#40, byte()]), boolean()},
        begin
            ok = e2e_sut:prepare(),
            Known = if Answer =:= 0 -> ok; true -> internal end,
            Expected = e2e_receiver:to_machine(P, Known, named(P, Status), Behaviour),
            e2e_sut:map_status(P, Answer, Status, Behaviour) =:= Expected
        end
    ).

prop_map_status(doc) -> "MapStatusToSM for any value of status and return";
prop_map_status(opts) -> [{numtests, 1000}, {transport, nif}].

%% The numbers of e2e.md section 1.
named(_, 16#00) -> 'OK';
named(_, 16#01) -> 'NONEWDATA';
named(P, 16#03) when P =:= p01; P =:= p02 -> 'SYNC';
named(P, 16#04) when P =:= p01; P =:= p02 -> 'INITIAL';
named(_, 16#08) -> 'REPEATED';
named(_, 16#20) -> 'OKSOMELOST';
named(_, 16#40) -> 'WRONGSEQUENCE';
named(_, _) -> 'ERROR'.

%% Section 4, last paragraph.
prop_p01_check_config() ->
    ?FORALL(
        Config,
        ?LET(
            {C, Changes},
            {e2e_configuration:config(p01), list(change())},
            maps:merge(C, maps:from_list(Changes))
        ),
        begin
            ok = e2e_sut:prepare(),
            Expected = case sound(Config) of true -> ok; false -> input_wrong end,
            ?WHENFAIL(
                io:format("expected ~p~n", [Expected]),
                e2e_sut:check_config(p01, Config) =:= Expected
            )
        end
    ).

prop_p01_check_config(doc) -> "P01CheckConfig accepts what the standard describes, and no more";
prop_p01_check_config(opts) -> [{numtests, 500}, {max_size, 4}, {transport, nif}].

change() ->
    oneof([
        {oneof(['CRCOffset', 'CounterOffset', 'DataIDNibbleOffset']), oneof([
            uniform(0, 260), ?LET(N, uniform(0, 63), 4 * N)
        ])},
        {'DataLength', oneof([0, 8, 16, 24, 232, 240, 248, uniform(0, 300)])},
        {'DataID', oneof([255, 256, 16#FFF, 16#1000, 16#FFFF])},
        {oneof(['MaxDeltaCounterInit', 'MaxNoNewOrRepeatedData', 'SyncCounterInit']),
            oneof([0, 14, 15])}
    ]).

sound(#{'DataLength' := Bits, 'CRCOffset' := Crc, 'CounterOffset' := Counter} = Config) ->
    #{'DataIDMode' := Mode, 'DataID' := Id, 'DataIDNibbleOffset' := Nibble} = Config,
    Counts = ['MaxDeltaCounterInit', 'MaxNoNewOrRepeatedData', 'SyncCounterInit'],
    Limits = maps:with(Counts, Config),
    Bits >= 16 andalso Bits =< 240 andalso Bits rem 8 =:= 0 andalso
        Crc rem 8 =:= 0 andalso Crc < Bits andalso
        Counter rem 4 =:= 0 andalso Counter < Bits andalso
        Counter div 8 =/= Crc div 8 andalso
        lists:all(fun(N) -> N =< 14 end, maps:values(Limits)) andalso
        (Mode =/= 2 orelse Id =< 16#FF) andalso
        (Mode =/= 3 orelse
            (Id =< 16#FFF andalso Nibble rem 4 =:= 0 andalso Nibble < Bits andalso
                Nibble div 8 =/= Crc div 8 andalso Nibble =/= Counter)).

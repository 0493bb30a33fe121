%% @doc Configurations of the profiles and of the state machine, as generators, and which of them
%% the models can use.
-module(e2e_configuration).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([config/1, machine/0, usable/2, machine_usable/1, example/1, max_delta/1]).

%% @doc Configurations of a profile. Small limits are frequent, since they are passed often.
-spec config(e2e_packet:profile()) -> proper_types:type().
config(P) ->
    ?SUCHTHAT(Config, frequency([{9, any_config(P)}, {1, example(P)}]), usable(P, Config)).

any_config(P) when P =:= p01; P =:= p11 ->
    Modes = if P =:= p01 -> [0, 1, 2, 3]; true -> [0, 3] end,
    ?LET(
        {Bytes, Mode},
        {integer(3, 16), oneof(Modes)},
        ?LET(
            {Id, Crc, Counter, Nibble, Limits},
            {id(Mode), oneof([0, integer(0, Bytes - 1)]), nibble(8, Bytes), nibble(12, Bytes),
                limits(P)},
            maps:merge(Limits, #{
                'CRCOffset' => 8 * Crc,
                'CounterOffset' => Counter,
                'DataIDNibbleOffset' => Nibble,
                'DataIDMode' => Mode,
                'DataID' => Id,
                'DataLength' => 8 * Bytes
            })
        )
    );
any_config(P) when P =:= p02; P =:= p22 ->
    ?LET(
        {Offset, Extra, Ids, Limits},
        {offset(), integer(0, 14), vector(16, byte()), limits(P)},
        maps:merge(Limits, #{
            'Offset' => 8 * Offset, 'DataLength' => 8 * (Offset + 2 + Extra), 'DataIDList' => Ids
        })
    );
any_config(p05) ->
    ?LET(
        {Offset, Extra, Id, Limits},
        {offset(), integer(0, 14), uniform(0, 16#FFFF), limits(p05)},
        maps:merge(Limits, #{
            'Offset' => 8 * Offset, 'DataLength' => 8 * (Offset + 3 + Extra), 'DataID' => Id
        })
    );
any_config(P) ->
    Header = e2e_packet:header_bytes(P),
    ?LET(
        {Offset, Id, Limits},
        {offset(), uniform(0, largest_id(P)), limits(P)},
        ?LET(
            {Min, Extra},
            {oneof([8 * (Header + Offset), integer(8, 8 * (Header + Offset + 4))]), integer(4, 20)},
            maps:merge(Limits, #{
                'Offset' => 8 * Offset,
                'DataID' => Id,
                'MinDataLength' => Min,
                'MaxDataLength' => 8 * (Header + Offset + Extra)
            })
        )
    ).

%% The standard's place, or any other.
nibble(Standard, Bytes) ->
    oneof([Standard, ?LET(N, integer(0, 2 * Bytes - 1), 4 * N)]).

offset() -> frequency([{2, 0}, {1, integer(1, 5)}]).

id(2) -> byte();
id(3) -> uniform(0, 16#0FFF);
id(_) -> uniform(0, 16#FFFF).

largest_id(p06) -> 16#FFFF;
largest_id(_) -> 16#FFFFFFFF.

limits(P) when P =:= p01; P =:= p02 ->
    Top = e2e_packet:counters(P) - 1,
    ?LET(
        {Delta, NoNew, Sync},
        {limit(0, Top), limit(0, Top), limit(0, Top)},
        #{
            'MaxDeltaCounterInit' => Delta,
            'MaxNoNewOrRepeatedData' => NoNew,
            'SyncCounterInit' => Sync
        }
    );
limits(P) ->
    ?LET(Delta, limit(0, max_delta(P)), #{'MaxDeltaCounter' => Delta}).

limit(Least, Most) ->
    frequency([{4, integer(Least, min(4, Most))}, {1, uniform(Least, Most)}, {1, Most}]).

%% @doc The largest MaxDeltaCounter that the configuration can hold and the counter can reach.
-spec max_delta(e2e_packet:profile()) -> pos_integer().
max_delta(P) -> e2e_packet:counters(P) - 1.

%% @doc A plain configuration: header in front, few limits. Profile 1's is the airbag's of e2e.md
%% section 9 (recommended).
-spec example(e2e_packet:profile()) -> e2e_packet:config().
example(p01) ->
    #{
        'CRCOffset' => 0,
        'CounterOffset' => 24,
        'DataIDNibbleOffset' => 12,
        'DataIDMode' => 0,
        'DataID' => 16#0123,
        'DataLength' => 32,
        'MaxDeltaCounterInit' => 3,
        'MaxNoNewOrRepeatedData' => 14,
        'SyncCounterInit' => 0
    };
example(p02) ->
    #{
        'Offset' => 0,
        'DataLength' => 64,
        'DataIDList' => ids(),
        'MaxDeltaCounterInit' => 3,
        'MaxNoNewOrRepeatedData' => 15,
        'SyncCounterInit' => 0
    };
example(p05) ->
    #{'Offset' => 0, 'DataLength' => 64, 'DataID' => 16#1234, 'MaxDeltaCounter' => 3};
example(p11) ->
    #{
        'CRCOffset' => 0,
        'CounterOffset' => 8,
        'DataIDNibbleOffset' => 12,
        'DataIDMode' => 3,
        'DataID' => 16#0123,
        'DataLength' => 64,
        'MaxDeltaCounter' => 3
    };
example(p22) ->
    #{'Offset' => 0, 'DataLength' => 64, 'DataIDList' => ids(), 'MaxDeltaCounter' => 3};
example(P) ->
    Header = e2e_packet:header_bytes(P),
    Id = if P =:= p06 -> 16#1234; true -> 16#0A0B0C0D end,
    #{
        'Offset' => 0,
        'DataID' => Id,
        'MinDataLength' => 8 * Header,
        'MaxDataLength' => 8 * (Header + 16),
        'MaxDeltaCounter' => 3
    }.

%% Those of the protocol specification's worked example.
ids() -> lists:seq(1, 16).

%% @doc Is this one that the generator promises? Asked again after shrinking.
-spec usable(e2e_packet:profile(), e2e_packet:config()) -> boolean().
usable(P, Config) when P =:= p01; P =:= p11 ->
    #{crc := {Crc, _, _}, counter := {Counter, _, _}} = Fields = e2e_packet:fields(P, Config),
    Nibble = maps:get(nibble, Fields, none),
    e2e_packet:lengths(P, Config) =/= none andalso
        Crc < maps:get('DataLength', Config) andalso
        Crc div 8 =/= Counter div 8 andalso
        apart(Nibble, Crc, Counter);
usable(P, Config) ->
    e2e_packet:lengths(P, Config) =/= none.

apart(none, _, _) -> true;
apart({At, _, _}, Crc, Counter) -> At div 8 =/= Crc div 8 andalso At =/= Counter.

%% ---- state machine ----------------------------------------------------------------------------

%% @doc Configurations of the state machine: mostly as the standard constrains them, now and then
%% with any limits.
-spec machine() -> proper_types:type().
machine() ->
    ?LET(
        {Valid, Init, Invalid, Oks, Errors, Clear},
        {integer(1, 8), integer(0, 8), integer(0, 8), vector(3, integer(0, 5)),
            vector(3, integer(0, 4)), integer(0, 1)},
        machine(Valid, min(Init, Valid), min(Invalid, Valid), limits(Oks, Errors), Clear)
    ).

%% Three in four are sorted as the standard wants them.
limits([First | _] = Oks, Errors) when First < 4 ->
    {[max(1, N) || N <- lists:sort(Oks)], lists:reverse(lists:sort(Errors))};
limits(Oks, Errors) ->
    {Oks, Errors}.

machine(Valid, Init, Invalid, {[OkV, OkI, OkN], [ErrorV, ErrorI, ErrorN]}, Clear) ->
    #{
        'WindowSizeValid' => Valid,
        'WindowSizeInit' => Init,
        'WindowSizeInvalid' => Invalid,
        'MinOkStateValid' => OkV,
        'MinOkStateInit' => OkI,
        'MinOkStateInvalid' => OkN,
        'MaxErrorStateValid' => ErrorV,
        'MaxErrorStateInit' => ErrorI,
        'MaxErrorStateInvalid' => ErrorN,
        'ClearToInvalid' => Clear
    }.

%% @doc No state looks at more verdicts than the window holds.
-spec machine_usable(e2e_machine:config()) -> boolean().
machine_usable(#{'WindowSizeValid' := Valid, 'WindowSizeInit' := I, 'WindowSizeInvalid' := N}) ->
    Valid >= 1 andalso I =< Valid andalso N =< Valid.

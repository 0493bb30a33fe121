%% @doc The receiver of each profile as e2e.md sections 4 to 7 describe it: what a check answers,
%% and what it leaves in the state.
-module(e2e_receiver).

-export([initial/1, check/4, judge/4, to_machine/4, accepted/1]).
-export_type([state/0, status/0, answer/0, verdict/0]).

-type status() ::
    'OK' | 'NONEWDATA' | 'WRONGCRC' | 'SYNC' | 'INITIAL' | 'ERROR' | 'REPEATED' | 'OKSOMELOST'
    | 'WRONGSEQUENCE'.
%% Members of the check state by their AUTOSAR names, without NewDataAvailable, which is the
%% caller's.
-type state() :: #{atom() => status() | non_neg_integer()}.
-type answer() :: ok | input_null | input_wrong | internal | wrong_state.
-type verdict() :: 'OK' | 'REPEATED' | 'WRONGSEQUENCE' | 'ERROR' | 'NOTAVAILABLE' | 'NONEWDATA'.

%% @doc The state after CheckInit.
-spec initial(e2e_packet:profile()) -> state().
initial(P) when P =:= p01; P =:= p02 ->
    #{
        'LastValidCounter' => 0,
        'MaxDeltaCounter' => 0,
        'WaitForFirstData' => 1,
        'LostData' => 0,
        'Status' => 'NONEWDATA',
        'SyncCounter' => 0,
        'NoNewOrRepeatedDataCounter' => 0
    };
initial(P) ->
    #{'Status' => 'ERROR', 'Counter' => e2e_packet:counters(P) - 1}.

%% @doc One check of a packet, or of nothing received.
-spec check(e2e_packet:profile(), e2e_packet:config(), state(), binary() | none) ->
    {answer(), state()}.
check(P, Config, State, none) ->
    judge(P, Config, State, none);
check(P, Config, State, Packet) ->
    case e2e_packet:length_fits(P, Config, byte_size(Packet)) of
        true -> judge(P, Config, State, e2e_packet:inspect(P, Config, Packet));
        false -> {input_wrong, State}
    end.

%% @doc The same where the counter received, and whether the packet is intact, are known.
-spec judge(
    e2e_packet:profile(), e2e_packet:config(), state(), none | {non_neg_integer(), boolean()}
) -> {answer(), state()}.
judge(P, Config, State, Found) when P =:= p01; P =:= p02 ->
    early(P, Config, count_up('MaxDeltaCounter', P, State), Found);
judge(_, _, State, none) ->
    {ok, State#{'Status' := 'NONEWDATA'}};
judge(P, Config, State, Found) ->
    {ok, later(P, Config, State, Found)}.

%% ---- profiles 1 and 2 -----------------------------------------------------------------------

early(P, _, State, none) ->
    {ok, (count_up('NoNewOrRepeatedDataCounter', P, State))#{'Status' := 'NONEWDATA'}};
early(p01, _, State, {15, _}) ->
    {input_wrong, State};
early(_, _, State, {_, false}) ->
    {ok, State#{'Status' := 'WRONGCRC'}};
early(P, Config, State, {Counter, true}) ->
    {ok, valid(P, Config, State, Counter)}.

valid(_, Config, #{'WaitForFirstData' := 1} = State, Counter) ->
    (follow(Config, Counter, State))#{'WaitForFirstData' := 0, 'Status' := 'INITIAL'};
valid(P, Config, #{'LastValidCounter' := Last, 'MaxDeltaCounter' := Most} = State, Counter) ->
    N = e2e_packet:counters(P),
    case (Counter - Last + 2 * N) rem N of
        0 -> (count_up('NoNewOrRepeatedDataCounter', P, State))#{'Status' := 'REPEATED'};
        Delta when Delta =< Most -> in_sequence(Config, Delta, follow(Config, Counter, State));
        _ -> out_of_sequence(Config, Counter, State)
    end.

follow(#{'MaxDeltaCounterInit' := Most}, Counter, State) ->
    State#{'MaxDeltaCounter' := Most, 'LastValidCounter' := Counter}.

in_sequence(Config, Delta, #{'NoNewOrRepeatedDataCounter' := Missing} = State) ->
    Lost = State#{'LostData' := Delta - 1, 'NoNewOrRepeatedDataCounter' := 0},
    case {Config, Lost} of
        {#{'MaxNoNewOrRepeatedData' := Most, 'SyncCounterInit' := Sync}, _} when Missing > Most ->
            Lost#{'SyncCounter' := Sync, 'Status' := 'SYNC'};
        {_, #{'SyncCounter' := Left}} when Left > 0 ->
            Lost#{'SyncCounter' := Left - 1, 'Status' := 'SYNC'};
        _ ->
            Lost#{'Status' := in_order(Delta)}
    end.

in_order(1) -> 'OK';
in_order(_) -> 'OKSOMELOST'.

out_of_sequence(#{'SyncCounterInit' := Sync} = Config, Counter, State) ->
    Wrong = State#{
        'Status' := 'WRONGSEQUENCE', 'SyncCounter' := Sync, 'NoNewOrRepeatedDataCounter' := 0
    },
    case Sync of
        0 -> Wrong;
        _ -> follow(Config, Counter, Wrong)
    end.

count_up(Member, P, State) ->
    maps:update_with(Member, fun(N) -> min(N + 1, e2e_packet:counters(P) - 1) end, State).

%% ---- the later profiles ---------------------------------------------------------------------

later(p11, _, State, {15, _}) -> State#{'Status' := 'ERROR'};
later(_, _, State, {_, false}) -> State#{'Status' := 'ERROR'};
later(P, #{'MaxDeltaCounter' := Most}, #{'Counter' := Last} = State, {Counter, true}) ->
    N = e2e_packet:counters(P),
    Status =
        case (Counter - Last + N) rem N of
            Delta when Delta > Most -> 'WRONGSEQUENCE';
            0 -> 'REPEATED';
            Delta -> in_order(Delta)
        end,
    State#{'Status' := Status, 'Counter' := Counter}.

%% ---- what others make of a status -----------------------------------------------------------

%% @doc MapStatusToSM; Behaviour is profileBehavior, which only profiles 1 and 2 have.
-spec to_machine(e2e_packet:profile(), answer(), status(), Behaviour :: boolean()) -> verdict().
to_machine(P, ok, Status, Behaviour) when P =:= p01; P =:= p02 ->
    case {Status, Behaviour} of
        {'SYNC', true} -> 'OK';
        {'SYNC', false} -> 'WRONGSEQUENCE';
        {'INITIAL', true} -> 'WRONGSEQUENCE';
        {'INITIAL', false} -> 'OK';
        _ -> verdict(Status)
    end;
to_machine(_, ok, Status, _) ->
    verdict(Status);
to_machine(_, _, _, _) ->
    'ERROR'.

verdict('OK') -> 'OK';
verdict('OKSOMELOST') -> 'OK';
verdict(Same) when Same =:= 'REPEATED'; Same =:= 'NONEWDATA'; Same =:= 'WRONGSEQUENCE' -> Same;
verdict(_) -> 'ERROR'.

%% @doc Does an application that follows the standard use the data of a packet with this status?
-spec accepted(status()) -> boolean().
accepted(Status) -> lists:member(Status, ['OK', 'OKSOMELOST', 'SYNC', 'INITIAL']).

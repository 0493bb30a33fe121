%% @doc What a fault shrinks to: weaker, shorter, later and simpler faults.
%%
%% Weaker: each number nearer to the one without effect (1 for a factor, 0 for an offset).
%% Shorter: fewer affected calls. Later: the first affected call comes later, up to the 65th.
%% Simpler: a condition beside the window is left out. rank/1 measures all four; no candidate is
%% worse in any of them but one that is simpler, so shrinking comes to an end.
-module(faultcheck_fault_weaker).

-export([faults/1, triggers/1, rank/1]).
-export_type([rank/0]).

-type rank() :: #{
    conditions := non_neg_integer(),
    length := non_neg_integer() | inf,
    earliness := non_neg_integer(),
    strength := [number() | inf]
}.

-define(LATEST, 64).

%% @doc The next candidates, the boldest first.
-spec faults(faultcheck_fault:fault()) -> [faultcheck_fault:fault()].
faults(Fault) ->
    {Model, Trigger} = faultcheck_fault:normal(Fault),
    Candidates =
        [plain(M, Trigger) || M <- models(Model)] ++ [plain(Model, T) || T <- triggers(Trigger)],
    [F || F <- Candidates, faultcheck_fault:validate(F) =:= ok].

plain(Model, []) -> Model;
plain(Model, Trigger) -> {Model, Trigger}.

%% @doc How much of everything a fault has.
-spec rank(faultcheck_fault:fault()) -> rank().
rank(Fault) ->
    {Model, Trigger} = faultcheck_fault:normal(Fault),
    #{
        conditions => length(others(Trigger)),
        length => proplists:get_value(for, Trigger, inf),
        earliness => max(0, ?LATEST - proplists:get_value(from, Trigger, 0)),
        strength =>
            lists:flatten([sizes(C) || C <- lists:sort(others(Trigger))] ++ model_sizes(Model))
    }.

others(Trigger) -> [C || C <- Trigger, not lists:member(element(1, C), [from, for])].

sizes({random, P}) -> [P];
sizes({periodic, _Period, Active}) -> [Active];
sizes({time, _Delay, forever}) -> [inf];
sizes({time, _Delay, Duration}) -> [Duration];
sizes(_) -> [].

%% ---- triggers -------------------------------------------------------------------------------

%% @doc The candidates of a trigger alone.
-spec triggers(faultcheck_fault:trigger()) -> [faultcheck_fault:trigger()].
triggers(Trigger) ->
    [Trigger -- [C] || C <- others(Trigger)] ++
        [set(for, N, Trigger) || N <- shorter(proplists:get_value(for, Trigger, inf))] ++
        [set(from, N, Trigger) || N <- later(proplists:get_value(from, Trigger, 0))] ++
        [replace(C, D, Trigger) || C <- others(Trigger), D <- lesser(C)].

set(from, N, Trigger) -> [{from, N} | lists:keydelete(from, 1, Trigger)];
set(for, N, Trigger) ->
    {From, Others} = lists:partition(fun(C) -> element(1, C) =:= from end,
                                     lists:keydelete(for, 1, Trigger)),
    From ++ [{for, N} | Others].

replace(C, D, Trigger) ->
    [case X of C -> D; _ -> X end || X <- Trigger].

shorter(inf) -> [1, 8, 64];
shorter(N) -> [M || M <- toward(1, N), M > 0, M < N].

later(N) -> lists:usort([M || M <- [N + (?LATEST - N + 1) div 2, N + 1], M > N, M =< ?LATEST]).

lesser({random, P}) -> [{random, P / 2} || P > 0.01];
lesser({periodic, Period, Active}) -> [{periodic, Period, A} || A <- toward(0, Active)];
lesser({time, Delay, forever}) -> [{time, Delay, 1000000000}];
lesser({time, Delay, Duration}) -> [{time, Delay, D} || D <- toward(0, Duration)];
lesser(_) -> [].

%% ---- models ---------------------------------------------------------------------------------

models(Model) when is_tuple(Model) ->
    [Name | Values] = tuple_to_list(Model),
    [
        list_to_tuple([Name | replace_nth(At, Weaker, Values)])
     || {At, Value, Parameter, Kind} <- parameters(Name, Values),
        Weaker <- weaker(Kind, {Name, Parameter}, Value)
    ];
models(_) ->
    [].

model_sizes(Model) when is_tuple(Model) ->
    [Name | Values] = tuple_to_list(Model),
    [size(Kind, {Name, P}, Value) || {_, Value, P, Kind} <- parameters(Name, Values)];
model_sizes(_) ->
    [].

parameters(Name, Values) ->
    [Kinds | _] = [
        Kinds
     || #{parameters := Kinds} <- faultcheck_fault_catalogue:find(Name),
        length(Kinds) =:= length(Values)
    ],
    [
        {At, Value, Parameter, kind_of(Kind, Value)}
     || {At, Value, {Parameter, Kind}} <- lists:zip3(lists:seq(1, length(Kinds)), Values, Kinds)
    ].

%% The two delays.
kind_of(delay, {_, _}) -> amount;
kind_of(channel_delay, _) -> amount;
kind_of(Kind, _) -> Kind.

replace_nth(At, New, List) ->
    {Before, [_ | After]} = lists:split(At - 1, List),
    Before ++ [New | After].

%% To be weaker, limits have to be wide.
neutral({amplification, _}) -> 1;
neutral({saturate, 'Low'}) -> -1000;
neutral({saturate, 'High'}) -> 1000;
neutral(_) -> 0.

weaker(Kind, At, V) when Kind =:= any_real; Kind =:= real -> weaker_real(At, V);
weaker(limit, _, none) -> [1000.0];
weaker(limit, At, V) -> weaker_real(At, V);
weaker(positive, _, inf) -> [1.0];
weaker(positive, _, V) -> [1.0 || V > 1] ++ [V / 2 || V > 0.01];
weaker(probability, _, P) -> [P / 2 || P > 0.01];
weaker(count, _, N) -> toward(1, N);
weaker(amount, _, {Unit, N}) -> [{Unit, M} || M <- toward(0, N)];
weaker(Kind, _, N) when Kind =:= bit; Kind =:= bit_of_byte; Kind =:= natural; Kind =:= byte ->
    toward(0, N);
weaker(dropout_mode, _, nan) -> [hold, zero];
weaker(dropout_mode, _, zero) -> [hold];
weaker(data, _, Data) -> [binary:part(Data, 0, N) || N <- toward(0, byte_size(Data))];
weaker(receivers, _, [_, _ | _] = Names) -> [Names -- [N] || N <- Names];
weaker(Kind, _, Part) when Kind =:= field; Kind =:= part -> weaker_field(Part);
weaker(model, _, Model) -> models(Model);
weaker(_, _, _) -> [].

weaker_field({Offset, Type, Last}) -> [{O, Type, Last} || O <- toward(0, Offset)];
weaker_field(whole) -> [].

%% Widening a limit that is wide enough would make it stronger.
weaker_real({saturate, 'Low'}, V) when V =:= neg_inf; is_number(V), V =< -1000 -> [];
weaker_real({saturate, 'High'}, V) when V =:= inf; is_number(V), V >= 1000 -> [];
weaker_real(At, V) when is_atom(V) -> [float(neutral(At)), 1.0e6];
weaker_real(At, V) ->
    Neutral = neutral(At),
    Middle = [middle(Neutral, V) || is_far(Neutral, V)],
    Candidates = [float(Neutral)] ++ whole(V, Neutral) ++ Middle,
    [C || C <- Candidates, distance(Neutral, C) < distance(Neutral, V)].

%% The whole number next to it on the side of the neutral one.
whole(V, _) when abs(V) > 1.0e15 -> [];
whole(V, Neutral) when V > Neutral -> [float(floor(V))];
whole(V, _) -> [float(ceil(V))].

middle(Neutral, V) -> float(Neutral) + (V / 2 - Neutral / 2).

is_far(Neutral, V) -> distance(Neutral, V) > 0.01.

distance(Neutral, V) -> abs(V / 2 - Neutral / 2).

%% Smaller numbers nearer to one that is not larger. A large number goes down by parts of itself.
toward(Least, N) when N > Least ->
    Step = max(1, (N - Least) div 16),
    lists:usort([Least, Least + (N - Least) div 2, N - Step]);
toward(_, _) -> [].

size(_, {saturate, 'Low'}, neg_inf) -> 0;
size(_, {saturate, 'High'}, inf) -> 0;
size(_, {saturate, 'Low'}, V) when is_number(V) -> max(0, distance_above(-1000, V));
size(_, {saturate, 'High'}, V) when is_number(V) -> max(0, -distance_above(1000, V));
size(_, _, {_, N}) when is_integer(N) -> N;
size(_, _, {Offset, _, _}) when is_integer(Offset) -> Offset;
size(model, _, Model) -> model_sizes(Model);
size(data, _, Data) -> byte_size(Data);
size(receivers, _, Names) -> length(Names);
size(dropout_mode, _, Mode) -> maps:get(Mode, #{hold => 0, zero => 1, nan => 2});
size(_, _, V) when is_atom(V), V =/= whole -> inf;
size(Kind, At, V) when is_number(V), Kind =/= bit_value -> distance(neutral(At), V);
size(_, _, _) -> 0.

distance_above(Neutral, V) -> V / 2 - Neutral / 2.

%% @doc Moves the arguments of a command a little: what the guided search does to a command whose
%% model has no X_mutate.
%%
%% A number with limits (faultcheck_range) moves by a Gaussian step, Scale times half its range
%% wide, and is clamped; in one of ten cases it becomes a limit. What has no order (a choice, a bit
%% index, a seed) is drawn again. All numbers of a command move together; only a command without
%% any has one of its other arguments drawn again.
-module(faultcheck_perturb).

-export([arguments/3, number/3]).
-export_type([scale/0]).

%% In halves of a range.
-type scale() :: float().

-define(LIMIT_SHARE, 0.1).

%% @doc New arguments near the given ones; Types is what X_args gives for them.
-spec arguments([term()], scale(), faultcheck_proper:type()) -> [term()].
arguments([], _Scale, _Types) ->
    [];
arguments(Args, Scale, Types) when is_list(Types), length(Types) =:= length(Args) ->
    Moved = [move(Value, Scale, Type) || {Value, Type} <- lists:zip(Args, Types)],
    case lists:member(true, [Moves || {Moves, _} <- Moved]) of
        true -> [Value || {_, Value} <- Moved];
        false -> redraw_one(Args, Types)
    end;
arguments(Args, _Scale, Type) ->
    redraw(Args, Type).

%% Whether there was a number in it, and the value then. Types may be tuples and lists of types.
move(Value, Scale, Type) when
    is_tuple(Type), tuple_size(Type) =:= tuple_size(Value), element(1, Type) =/= '$type'
->
    {Moves, Values} = move(tuple_to_list(Value), Scale, tuple_to_list(Type)),
    {Moves, list_to_tuple(Values)};
move([Value | Values], Scale, [Type | Types]) ->
    {Head, NewValue} = move(Value, Scale, Type),
    {Tail, NewValues} = move(Values, Scale, Types),
    {Head orelse Tail, [NewValue | NewValues]};
move(Value, Scale, Type) when is_number(Value) ->
    case faultcheck_range:limits(Type) of
        {ok, #{min := Limit, max := Limit}} -> {false, Value};
        {ok, #{ordered := false}} -> {false, Value};
        {ok, Limits} -> {true, number(Value, Scale, Limits)};
        none -> {false, Value}
    end;
move(Value, _Scale, _Type) ->
    {false, Value}.

redraw_one(Args, Types) ->
    N = rand:uniform(length(Args)),
    {Front, [Value | Back]} = lists:split(N - 1, Args),
    Front ++ [redraw(Value, lists:nth(N, Types)) | Back].

redraw(Value, Type) ->
    case faultcheck_proper:fast_generate(Type) of
        {ok, Imm} -> faultcheck_proper:clean(Imm);
        error -> Value
    end.

%% @doc A number near another, within its limits.
-spec number(number(), scale(), faultcheck_range:limits()) -> number().
number(Value, Scale, #{min := Min, max := Max} = Limits) ->
    case rand:uniform() < ?LIMIT_SHARE of
        true -> lists:nth(rand:uniform(2), [Min, Max]);
        false -> faultcheck_range:clamp(moved(Value, Scale * (Max - Min) / 2, Limits), Limits)
    end.

%% An integer that would stay moves by one.
moved(Value, Sigma, #{kind := int}) ->
    case round(Value + Sigma * rand:normal()) of
        Value -> Value + lists:nth(rand:uniform(2), [-1, 1]);
        Other -> Other
    end;
moved(Value, Sigma, #{kind := real}) ->
    Value + Sigma * rand:normal().

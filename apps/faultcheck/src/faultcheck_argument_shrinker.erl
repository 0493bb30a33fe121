%% @doc Shrinks the arguments of one command of a failing sequence.
%%
%% Candidates come from PropEr's own shrinkers, for the types that X_args gives in the state
%% in front of the command. PropEr tries numbers one by one from the simplest; here it is
%% made to bisect after the first few, so that large ones take as many runs as they have bits.
-module(faultcheck_argument_shrinker).

-export([command/4, generated/3]).

%% Steps of PropEr's shrinkers for one command, before it is left as it is.
-define(MAX_STEPS, 5000).
%% Neighbours of a midpoint that are tried when a constraint of the type forbids it.
-define(NEIGHBOURS, 8).

-record(arg, {var :: pos_integer(),
              name :: atom(),
              type :: faultcheck_proper:type(),
              imm :: faultcheck_proper:imm(),
              linear :: pos_integer(),
              values = 0 :: non_neg_integer(), % of the present number, tried one by one
              steps = 0 :: non_neg_integer(),
              changed = false :: boolean()}).

-type then() :: fun((faultcheck_shrinker:state()) -> faultcheck_shrinker:step()).

%% @doc Shrinks the command that sets a variable until none of its arguments can be shrunk
%% any more; at once when the command is no longer there.
-spec command(pos_integer(), pos_integer(), faultcheck_shrinker:state(), then()) ->
          faultcheck_shrinker:step().
command(Var, Linear, Shrinker, Then) ->
    {Mod, Commands, Side} = faultcheck_shrinker:best(Shrinker),
    case lists:keyfind({var, Var}, 2, Commands) of
        false ->
            Then(Shrinker);
        {set, _, {call, _, Name, Args}} ->
            Arg = #arg{var = Var, name = Name, linear = Linear,
                       type = type(Mod, Var, Name, Commands),
                       imm = maps:get(Var, Side, Args)},
            next(init, Arg, Shrinker, Then)
    end.

%% @doc Whether the generators of a command could give these arguments at this place.
-spec generated(module(), faultcheck_generator:command(), [faultcheck_generator:command()]) ->
          boolean().
generated(Mod, {set, {var, Var}, {call, _, Name, Args}}, Commands) ->
    try
        faultcheck_proper:is_instance(Args, type(Mod, Var, Name, Commands))
    catch
        error:_ -> false % X_args does not know the state that the change leads to
    end.

type(Mod, Var, Name, Commands) ->
    State = faultcheck_repair:state_before(Mod, Var, Commands),
    Model = {Mod, faultcheck_model:info(Mod)},
    faultcheck_proper:cook(faultcheck_model:args(Model, State, Name)).

%% The shrinkers are asked for the next candidates.
next(_State, #arg{steps = ?MAX_STEPS}, Shrinker, Then) ->
    Then(Shrinker);
next(State, #arg{steps = Steps} = Arg, Shrinker, Then) ->
    {Candidates, NewState} = shrink(Arg, State),
    case {Candidates, NewState} of
        {[], done} -> finished(Arg, Shrinker, Then);
        _ -> candidates(Candidates, 1, NewState, Arg#arg{steps = Steps + 1}, Shrinker, Then)
    end.

%% From the start again as long as something changes.
finished(#arg{changed = false}, Shrinker, Then) ->
    Then(Shrinker);
finished(#arg{var = Var, linear = Linear}, Shrinker, Then) ->
    command(Var, Linear, Shrinker, Then).

candidates([], _, State, Arg, Shrinker, Then) ->
    none_accepted(State, Arg, Shrinker, Then);
candidates([Imm | Rest], Position, State, Arg, Shrinker, Then) ->
    try_value(Imm, Arg, Shrinker,
              fun(true, Next) ->
                      next({shrunk, Position, State}, accepted(Imm, Arg), Next, Then);
                 (false, Next) ->
                      candidates(Rest, Position + 1, State, Arg, Next, Then)
              end).

accepted(Imm, Arg) ->
    Arg#arg{imm = Imm, changed = true, values = 0}.

none_accepted(State, #arg{values = Values, linear = Linear} = Arg, Shrinker, Then) ->
    case faultcheck_proper:number_state(State) of
        none ->
            next(State, Arg#arg{values = 0}, Shrinker, Then);
        {_, _, Left} when Values + 1 < Linear; Left < 2 ->
            next(State, Arg#arg{values = Values + 1}, Shrinker, Then);
        {Last, Step, Left} ->
            Value = fun(K) -> Last + K * Step end,
            far_end(Value, Left, State, Arg, Shrinker, Then)
    end.

%%% Bisecting a number: Value(0) passes, Value(Left) is the present one or, for a float,
%%% its whole part.

far_end(Value, Left, State, Arg, Shrinker, Then) ->
    case number(Value(Left), State, Arg) of
        {ok, Imm} ->
            try_value(Imm, Arg, Shrinker,
                      fun(true, Next) ->
                              bisect(Value, 0, Left, State, accepted(Imm, Arg), Next, Then);
                         (false, Next) when Imm =:= Arg#arg.imm ->
                              bisect(Value, 0, Left, State, Arg, Next, Then);
                         (false, Next) ->
                              end_number(State, Arg, Next, Then)
                      end);
        none ->
            bisect(Value, 0, Left, State, Arg, Shrinker, Then)
    end.

bisect(_Value, Low, High, State, Arg, Shrinker, Then) when High - Low < 2 ->
    end_number(State, Arg, Shrinker, Then);
bisect(Value, Low, High, State, Arg, Shrinker, Then) ->
    case allowed_near((Low + High) div 2, Low, High, Value, State, Arg) of
        {K, Imm} ->
            try_value(Imm, Arg, Shrinker,
                      fun(true, Next) ->
                              bisect(Value, Low, K, State, accepted(Imm, Arg), Next, Then);
                         (false, Next) ->
                              bisect(Value, K, High, State, Arg, Next, Then)
                      end);
        none ->
            end_number(State, Arg, Shrinker, Then)
    end.

%% The middle, or the nearest value to it that the type's constraints let through.
allowed_near(Middle, Low, High, Value, State, Arg) ->
    Near = [Middle | lists:append([[Middle - D, Middle + D] || D <- lists:seq(1, ?NEIGHBOURS)])],
    first_allowed([K || K <- Near, Low < K, K < High], Value, State, Arg).

first_allowed([], _Value, _State, _Arg) ->
    none;
first_allowed([K | Ks], Value, State, Arg) ->
    case number(Value(K), State, Arg) of
        {ok, Imm} -> {K, Imm};
        none -> first_allowed(Ks, Value, State, Arg)
    end.

%% The arguments with this value in the place of the number.
number(Value, State, Arg) ->
    case shrink(Arg, faultcheck_proper:set_number(State, Value)) of
        {[Imm], _} -> {ok, Imm};
        {[], _} -> none
    end.

end_number(State, Arg, Shrinker, Then) ->
    next(faultcheck_proper:end_number(State), Arg#arg{values = 0}, Shrinker, Then).

%%% Candidates

%% PropEr generates alternatives of a union afresh. With a seed of their own they are the
%% same in each shrinking of a failure.
shrink(#arg{imm = Imm, type = Type, var = Var, steps = Steps}, State) ->
    faultcheck_proper:preserving_random(
      {Var, Steps}, fun() -> faultcheck_proper:shrink(Imm, Type, State) end).

try_value(Imm, #arg{var = Var, name = Name}, Shrinker, Continue) ->
    {Mod, Commands, Side} = faultcheck_shrinker:best(Shrinker),
    Args = faultcheck_proper:clean(Imm),
    Command = {set, {var, Var}, {call, Mod, Name, Args}},
    case still_allowed(Mod, Command, Commands) of
        true ->
            NewSide = case Imm of
                          Args -> maps:remove(Var, Side);
                          _ -> Side#{Var => Imm}
                      end,
            Changed = lists:keyreplace({var, Var}, 2, Commands, Command),
            faultcheck_shrinker:attempt(Changed, NewSide, Shrinker, Continue);
        false ->
            Continue(false, Shrinker)
    end.

%% Repair would drop the command itself: that is no way to shrink an argument.
still_allowed(Mod, {set, {var, Var}, {call, _, Name, Args}}, Commands) ->
    State = faultcheck_repair:state_before(Mod, Var, Commands),
    try
        faultcheck_model:allowed({Mod, faultcheck_model:info(Mod)}, State, Name, Args)
    catch
        error:_ -> false
    end.

%% @doc Command sequences from a grouped model.
%%
%% The length is uniform on 0..Size. Each step chooses among the commands whose X_pre/1
%% holds, by weight, and generates arguments from X_args; if X_pre/2 rejects them, command
%% and arguments are chosen again. All randomness comes from the process's rand state.
-module(faultcheck_generator).

-export([generate/2, mutate/2, fill/5, insert/4, fresh_arguments/3]).
-export_type([command/0, side/0]).

-type command() :: {set, {var, pos_integer()}, {call, module(), atom(), [term()]}}.

%% Arguments as PropEr generated them, by variable number, where they differ from their
%% values: a ?LET keeps its parts there, and only with them can it be shrunk.
-type side() :: #{pos_integer() => faultcheck_proper:imm()}.

%% Attempts to choose a command and arguments that X_pre/2 accepts, before the sequence
%% ends early.
-define(ATTEMPTS, 50).

-record(gen, {model :: {module(), faultcheck_model:info()},
              state :: faultcheck_model:state(),
              var = 1 :: pos_integer(),
              commands = [] :: [command()],     % newest first
              side = #{} :: side()}).

%% @doc A random sequence of at most Size commands.
-spec generate(module(), Size :: non_neg_integer()) -> {[command()], side()}.
generate(Mod, Size) ->
    finish(extend(rand:uniform(Size + 1) - 1, start(Mod))).

%% @doc A neighbour of a sequence: a random part of its front and a fresh tail.
-spec mutate(module(), [command()]) -> {[command()], side()}.
mutate(Mod, Commands) ->
    Length = length(Commands),
    Kept = lists:sublist(Commands, rand:uniform(Length + 1) - 1),
    Start = lists:foldl(fun replay/2, start(Mod), Kept),
    %% Up to the size of the test: a search that wants long sequences can make them longer.
    Fresh = rand:uniform(max(faultcheck_proper:size(), Length - length(Kept)) + 1) - 1,
    finish(extend(Fresh, Start)).

%% @doc The beginning of a sequence, completed at random: up to a simulated time, at most to a
%% number of commands.
-spec fill(module(), [command()], side(), Time :: number(), Most :: pos_integer()) ->
          {[command()], side()}.
fill(Mod, Commands, Side, Time, Most) ->
    #gen{model = Model} = Start = start(Mod),
    Gen = lists:foldl(fun replay/2, Start#gen{side = Side}, Commands),
    finish(until(Time - duration(Model, Commands), Most - length(Commands), Gen)).

until(Left, Most, Gen) when Left =< 0; Most =< 0 ->
    Gen;
until(Left, Most, #gen{model = Model} = Gen) ->
    case extend(1, Gen) of
        #gen{commands = [Command | _] = More} = Next when More =/= Gen#gen.commands ->
            until(Left - duration(Model, [Command]), Most - 1, Next);
        _ ->
            Gen
    end.

duration(Model, Commands) ->
    lists:sum([faultcheck_model:duration(Model, Name, Args)
               || {set, _, {call, _, Name, Args}} <- Commands]).

%% @doc A sequence with fresh commands behind its first ones: those listed, with the types of their
%% arguments, or, for `any', some of the commands named, up to the first that takes time, at most
%% Most. Focus gives the state that arguments are drawn in. What follows may have become illegal.
-spec insert(module(), {Before :: [command()], Behind :: [command()], side()},
             [{atom(), faultcheck_proper:type()}] | {any, [atom()], Most :: pos_integer()},
             fun((faultcheck_model:state()) -> faultcheck_model:state())) ->
          {[command()], side()}.
insert(Mod, {Before, Behind, Side}, What, Focus) ->
    Gen = lists:foldl(fun replay/2, (start(Mod))#gen{side = Side}, Before),
    Free = lists:max([0 | [N || {set, {var, N}, _} <- Behind]]) + 1,
    {Commands, NewSide} = finish(add(What, Focus, Gen#gen{var = max(Free, Gen#gen.var)})),
    {Commands ++ Behind, NewSide}.

add([], _Focus, Gen) ->
    Gen;
add([{Name, Types} | Rest], Focus, #gen{model = Model, state = State} = Gen) ->
    case arguments(Types) of
        {ok, Imm, Args} ->
            case faultcheck_model:allowed(Model, State, Name, Args) of
                true -> add(Rest, Focus, append(Name, Imm, Args, Gen));
                false -> add(Rest, Focus, Gen)
            end;
        error ->
            add(Rest, Focus, Gen)
    end;
add({any, Names, Most}, Focus, Gen) ->
    fresh(Most, Names, Focus, Gen).

fresh(0, _Names, _Focus, Gen) ->
    Gen;
fresh(Left, Names, Focus, #gen{model = Model, state = State} = Gen) ->
    Enabled = [E || {_, Name} = E <- faultcheck_model:enabled(Model, State),
                    lists:member(Name, Names)],
    case choose(Enabled, total(Enabled, 0), Gen, Focus, ?ATTEMPTS) of
        {ok, Name, Imm, Args} ->
            Next = append(Name, Imm, Args, Gen),
            case faultcheck_model:duration(Model, Name, Args) > 0 of
                true -> Next;
                false -> fresh(Left - 1, Names, Focus, Next)
            end;
        none ->
            Gen
    end.

%% @doc Fresh arguments of a command in a state; error when PropEr cannot make any.
-spec fresh_arguments({module(), faultcheck_model:info()}, faultcheck_model:state(), atom()) ->
          {ok, faultcheck_proper:imm(), [term()]} | error.
fresh_arguments(Model, State, Name) ->
    arguments(faultcheck_model:args(Model, State, Name)).

start(Mod) ->
    Info = faultcheck_model:info(Mod),
    #gen{model = {Mod, Info}, state = Mod:initial_state()}.

finish(#gen{commands = Commands, side = Side}) ->
    {lists:reverse(Commands), Side}.

replay({set, {var, N} = Var, {call, _, Name, Args}} = Command,
       #gen{model = Model, state = State, var = Next, commands = Commands} = Gen) ->
    Gen#gen{state = faultcheck_model:next(Model, State, Name, Args, Var),
            var = max(Next, N + 1), commands = [Command | Commands]}.

extend(0, Gen) ->
    Gen;
extend(N, #gen{model = Model, state = State} = Gen) ->
    Enabled = faultcheck_model:enabled(Model, State),
    case choose(Enabled, total(Enabled, 0), Gen, fun(S) -> S end, ?ATTEMPTS) of
        {ok, Name, Imm, Args} -> extend(N - 1, append(Name, Imm, Args, Gen));
        none -> Gen
    end.

total([{Weight, _} | Rest], Sum) -> total(Rest, Sum + Weight);
total([], Sum) -> Sum.

choose([], _Total, _Gen, _Focus, _Attempts) ->
    none;
choose(_Enabled, _Total, _Gen, _Focus, 0) ->
    none;
choose(Enabled, Total, #gen{model = Model, state = State} = Gen, Focus, Attempts) ->
    Name = pick(Enabled, rand:uniform(Total)),
    case arguments(faultcheck_model:args(Model, Focus(State), Name)) of
        {ok, Imm, Args} ->
            case faultcheck_model:allowed(Model, State, Name, Args) of
                true ->
                    {ok, Name, Imm, Args};
                false ->
                    faultcheck_stats:rejected(Name),
                    choose(Enabled, Total, Gen, Focus, Attempts - 1)
            end;
        error ->
            %% As PropEr does when a constraint cannot be met, but without giving up the run.
            faultcheck_stats:rejected(Name),
            choose(Enabled, Total, Gen, Focus, Attempts - 1)
    end.

pick([{Weight, Name} | _], Dice) when Dice =< Weight -> Name;
pick([{Weight, _} | Rest], Dice) -> pick(Rest, Dice - Weight).

append(Name, Imm, Args, #gen{model = {Mod, _} = Model, state = State, var = N} = Gen) ->
    Var = {var, N},
    Gen#gen{state = faultcheck_model:next(Model, State, Name, Args, Var),
            var = N + 1,
            commands = [{set, Var, {call, Mod, Name, Args}} | Gen#gen.commands],
            side = case Imm of
                       Args -> Gen#gen.side;
                       _ -> (Gen#gen.side)#{N => Imm}
                   end}.

%% X_args usually writes out a list; it may also be one type whose values are lists.
arguments(Types) when is_list(Types) ->
    arguments(Types, [], []);
arguments(Type) ->
    case faultcheck_proper:generate(Type) of
        {ok, Imm} -> {ok, Imm, faultcheck_proper:clean(Imm)};
        error -> error
    end.

arguments([], Imms, Args) ->
    {ok, lists:reverse(Imms), lists:reverse(Args)};
arguments([Type | Types], Imms, Args) ->
    case faultcheck_proper:fast_generate(Type) of
        {ok, Imm} -> arguments(Types, [Imm | Imms], [faultcheck_proper:clean(Imm) | Args]);
        error -> error
    end.

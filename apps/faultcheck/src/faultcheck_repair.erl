%% @doc Makes an edited command sequence legal again: for shrinking, enumeration, search and
%% cases edited by hand.
%%
%% The model is replayed with symbolic results. A command is dropped when its precondition is
%% false by then, or when it uses the result of a command that is gone, unless an earlier
%% command of the same name was kept: then it uses that one's result instead. Nothing is run.
-module(faultcheck_repair).

-export([repair/2, repair/4, names/1, renumber/2, state_before/3, variables/1]).
-export_type([names/0]).

%% Which command set a variable, also for commands that are gone by now.
-type names() :: #{pos_integer() => atom()}.

-record(repair, {model :: {module(), faultcheck_model:info()},
                 state :: faultcheck_model:state(),
                 names :: names(),
                 latest = #{} :: #{atom() => pos_integer()}, % kept, by command name
                 kept = #{} :: #{pos_integer() => true},
                 commands = [] :: [faultcheck_generator:command()]}).

%% @doc The longest legal part of a sequence that keeps the order.
-spec repair(module(), [faultcheck_generator:command()]) -> [faultcheck_generator:command()].
repair(Mod, Commands) ->
    {Repaired, _} = repair(Mod, Commands, #{}, names(Commands)),
    Repaired.

%% @doc The same for a sequence with side data, part of one whose names are given.
-spec repair(module(), [faultcheck_generator:command()], faultcheck_generator:side(), names()) ->
          {[faultcheck_generator:command()], faultcheck_generator:side()}.
repair(Mod, Commands, Side, Names) ->
    Start = #repair{model = {Mod, faultcheck_model:info(Mod)}, state = Mod:initial_state(),
                    names = Names},
    {#repair{commands = Repaired, kept = Kept}, NewSide} =
        lists:foldl(fun keep/2, {Start, Side}, Commands),
    {lists:reverse(Repaired), maps:with(maps:keys(Kept), NewSide)}.

%% @doc Which command sets each variable of a sequence.
-spec names([faultcheck_generator:command()]) -> names().
names(Commands) ->
    maps:from_list([{N, Name} || {set, {var, N}, {call, _, Name, _}} <- Commands]).

keep({set, {var, N} = Var, {call, Mod, Name, Args}} = Command, {Repair, Side}) ->
    case replacements(Args, Repair) of
        undefined ->
            {Repair, Side};
        Changes when map_size(Changes) =:= 0 ->
            keep(Command, Repair, Side);
        Changes ->
            NewArgs = replace(Args, Changes),
            NewSide = case Side of
                          #{N := Imm} -> Side#{N => replace(Imm, Changes)};
                          #{} -> Side
                      end,
            keep({set, Var, {call, Mod, Name, NewArgs}}, Repair, NewSide)
    end.

keep({set, {var, N} = Var, {call, _, Name, Args}} = Command,
     #repair{model = Model, state = State, latest = Latest, kept = Kept} = Repair, Side) ->
    %% A model may have no clause for a state that generation never reaches: not legal either.
    try faultcheck_model:allowed(Model, State, Name, Args)
             andalso {next, faultcheck_model:next(Model, State, Name, Args, Var)} of
        {next, Next} ->
            {Repair#repair{state = Next, latest = Latest#{Name => N}, kept = Kept#{N => true},
                           commands = [Command | Repair#repair.commands]}, Side};
        false ->
            {Repair, Side}
    catch
        error:_ -> {Repair, Side}
    end.

%% New variables for those whose commands are gone; undefined when there is none to take.
replacements(Args, #repair{names = Names, latest = Latest, kept = Kept}) ->
    Gone = [N || N <- variables(Args), not is_map_key(N, Kept)],
    lists:foldl(fun(_, undefined) ->
                        undefined;
                   (N, Changes) ->
                        case Names of
                            #{N := Name} when is_map_key(Name, Latest) ->
                                Changes#{N => maps:get(Name, Latest)};
                            #{} ->
                                undefined
                        end
                end, #{}, Gone).

%% @doc The variables in a term.
-spec variables(term()) -> [pos_integer()].
variables(Term) -> variables(Term, []).

variables({var, N}, Acc) when is_integer(N) -> [N | Acc];
variables([Head | Tail], Acc) -> variables(Tail, variables(Head, Acc));
variables(Tuple, Acc) when is_tuple(Tuple) -> variables(tuple_to_list(Tuple), Acc);
variables(_, Acc) -> Acc.

replace({var, N} = Var, Changes) when is_integer(N) ->
    case Changes of
        #{N := New} -> {var, New};
        #{} -> Var
    end;
replace([Head | Tail], Changes) ->
    [replace(Head, Changes) | replace(Tail, Changes)];
replace(Tuple, Changes) when is_tuple(Tuple) ->
    list_to_tuple(replace(tuple_to_list(Tuple), Changes));
replace(Other, _Changes) ->
    Other.

%% @doc The same sequence with variables 1, 2, 3, ...
-spec renumber([faultcheck_generator:command()], faultcheck_generator:side()) ->
          {[faultcheck_generator:command()], faultcheck_generator:side()}.
renumber(Commands, Side) ->
    Old = [N || {set, {var, N}, _} <- Commands],
    Changes = maps:from_list(lists:zip(Old, lists:seq(1, length(Old)))),
    {replace(Commands, Changes),
     maps:from_list([{maps:get(N, Changes), replace(Imm, Changes)}
                     || {N, Imm} <- maps:to_list(Side)])}.

%% @doc The model's symbolic state in front of the command that sets a variable.
-spec state_before(module(), pos_integer(), [faultcheck_generator:command()]) ->
          faultcheck_model:state().
state_before(Mod, N, Commands) ->
    Model = {Mod, faultcheck_model:info(Mod)},
    Front = lists:takewhile(fun({set, {var, V}, _}) -> V =/= N end, Commands),
    lists:foldl(fun({set, Var, {call, _, Name, Args}}, State) ->
                        faultcheck_model:next(Model, State, Name, Args, Var)
                end, Mod:initial_state(), Front).

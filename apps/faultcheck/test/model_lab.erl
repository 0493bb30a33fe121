%% What the tests of generator and shrinker share: runs, failing sequences, and a brute
%% force check of minimality that knows nothing of the shrinker.
-module(model_lab).

-export([run/2, verdict/2, failing/3, not_minimal/2, isolated/1, property/2, quickcheck/2]).

-include_lib("proper/include/proper_common.hrl").

%% Enough for every argument of the test models.
-define(MAX_CANDIDATES, 5000).

run(Mod, Commands) ->
    Mod:reset(),
    faultcheck_statem:run_commands(Mod, Commands).

%% As the shrinker wants it.
verdict(Mod, Commands) ->
    case run(Mod, Commands) of
        {_, _, ok} -> passes;
        {_, _, _} -> {fails, maps:get(kind, faultcheck_run:failure(Commands))}
    end.

%% The first failing sequence of a seed, with its side data.
failing(Mod, Size, Seed) ->
    faultcheck_proper:with_state(Size, {Seed, 1, 2}, fun() -> search(Mod, Size, 20000) end).

search(Mod, Size, Left) when Left > 0 ->
    {Commands, Side} = faultcheck_generator:generate(Mod, Size),
    case verdict(Mod, Commands) of
        passes -> search(Mod, Size, Left - 1);
        {fails, _} -> {Commands, Side}
    end.

%% A sequence that is smaller by one step and still fails, or none.
not_minimal(Mod, Commands) ->
    Candidates = removals(Commands) ++ lists:append([arguments(Mod, N, Commands)
                                                     || {set, {var, N}, _} <- Commands]),
    Smaller = [C || C <- Candidates, C =/= Commands, legal(Mod, C), verdict(Mod, C) =/= passes],
    case Smaller of
        [] -> none;
        [First | _] -> First
    end.

removals(Commands) ->
    [lists:delete(C, Commands) || C <- Commands].

legal(Mod, Commands) ->
    faultcheck_repair:repair(Mod, Commands) =:= Commands.

%% Every candidate PropEr's shrinkers have for the arguments of one command.
arguments(Mod, N, Commands) ->
    {set, Var, {call, Mod, Name, Args}} = lists:keyfind({var, N}, 2, Commands),
    State = faultcheck_repair:state_before(Mod, N, Commands),
    Type = proper_types:cook_outer(Mod:(list_to_atom(atom_to_list(Name) ++ "_args"))(State)),
    [lists:keyreplace(Var, 2, Commands, {set, Var, {call, Mod, Name, Smaller}})
     || Smaller <- candidates(Args, Type, init, ?MAX_CANDIDATES)].

candidates(_Args, _Type, _State, 0) ->
    [];
candidates(Args, Type, State, Left) ->
    case proper_shrink:shrink(Args, Type, State) of
        {[], done} -> [];
        {Imms, Next} -> [proper_gen:clean_instance(I) || I <- Imms]
                            ++ candidates(Args, Type, Next, Left - 1)
    end.

%% Runs Fun in a process of its own: PropEr keeps its state in the process dictionary.
isolated(Fun) ->
    {Pid, Ref} = spawn_monitor(fun() -> exit({result, Fun()}) end),
    receive
        {'DOWN', Ref, process, Pid, {result, Result}} -> Result;
        {'DOWN', Ref, process, Pid, Reason} -> error(Reason)
    end.

%% A property over a model, as a user writes it.
property(Mod, Options) ->
    ?FORALL(Commands, faultcheck_statem:commands(Mod, Options),
            begin
                {_, _, Result} = run(Mod, Commands),
                Result =:= ok
            end).

%% {Result, counterexample, last shrink}, in a process of its own.
quickcheck(Property, Options) ->
    isolated(fun() ->
                     Result = proper:quickcheck(Property, [quiet | Options]),
                     {Result, proper:counterexample(), faultcheck_statem:last_shrink()}
             end).

%% What the shrinker promises: its result fails, is legal, and is minimal.
-module(prop_faultcheck_shrinker).

-include_lib("proper/include/proper.hrl").

-export([prop_result_is_minimal/0, prop_same_failure_same_result/0,
         prop_repair_gives_legal_sequences/0]).

%% Sizes beyond PropEr's usual 42 for chain, whose failures are the longest.
size_of(chain_model) -> integer(20, 100);
size_of(_) -> integer(20, 60).

failure() ->
    ?LET(Mod, elements([syn_model, chain_model, bag_model]),
         {Mod, ?LET(Size, size_of(Mod), noshrink(Size)), noshrink(integer(1, 1 bsl 15))}).

minimised({Mod, Size, Seed}) ->
    {Commands, Side} = model_lab:failing(Mod, Size, Seed),
    Failure = #{kind => unknown, at => unknown},
    faultcheck_proper:with_state(
      Size, {Seed, 3, 4},
      fun() ->
              Run = fun(C) -> model_lab:verdict(Mod, C) end,
              Options = faultcheck_shrinker:options(#{max_ms => 600000}),
              faultcheck_shrinker:minimise(Mod, Commands, Side, Run, {Options, Failure})
      end).

prop_result_is_minimal() ->
    ?FORALL({Mod, _, _} = Failure, failure(),
            model_lab:isolated(
              fun() ->
                      #{shrunk := Shrunk, minimal := true} = Summary = minimised(Failure),
                      Smaller = faultcheck_proper:with_state(
                                  10, {1, 2, 3}, fun() -> model_lab:not_minimal(Mod, Shrunk) end),
                      ?WHENFAIL(io:format("~p~nis smaller than~n~p~n", [Smaller, Summary]),
                                Smaller =:= none
                                andalso model_lab:verdict(Mod, Shrunk) =/= passes
                                andalso faultcheck_repair:repair(Mod, Shrunk) =:= Shrunk)
              end)).

prop_same_failure_same_result() ->
    ?FORALL(Failure, failure(),
            begin
                Once = model_lab:isolated(fun() -> minimised(Failure) end),
                Again = model_lab:isolated(fun() -> minimised(Failure) end),
                maps:remove(ms, Once) =:= maps:remove(ms, Again)
            end).

%% Any part of a sequence, in its order, becomes legal, and what is legal stays as it is.
prop_repair_gives_legal_sequences() ->
    ?FORALL({Mod, Keep}, {elements([chain_model, bag_model]), list(boolean())},
            ?FORALL(Commands, faultcheck_statem:commands(Mod),
                    begin
                        Part = [C || {C, true} <- lists:zip(Commands, padded(Keep, Commands))],
                        Names = faultcheck_repair:names(Commands),
                        {Legal, #{}} = faultcheck_repair:repair(Mod, Part, #{}, Names),
                        faultcheck_repair:repair(Mod, Commands) =:= Commands
                            andalso faultcheck_repair:repair(Mod, Legal) =:= Legal
                            andalso legal_when_run(Mod, Legal)
                    end)).

padded(Keep, Commands) ->
    lists:sublist(Keep ++ lists:duplicate(length(Commands), true), length(Commands)).

legal_when_run(Mod, Commands) ->
    case model_lab:run(Mod, Commands) of
        {_, _, {precondition, _}} -> false;
        _ -> true
    end.

%% @doc Generated faults are valid, and shrink to weaker, shorter, later and simpler ones.
-module(prop_faultcheck_fault).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([prop_generated_faults_are_valid/0, prop_generated_faults_are_valid/1]).
-export([prop_faults_shrink_downwards/0, prop_faults_shrink_downwards/1]).
-export([prop_shrinking_ends/0, prop_shrinking_ends/1]).

prop_generated_faults_are_valid() ->
    ?FORALL(
        {Class, Fault},
        oneof([
            {probe, faultcheck_fault_gen:probe()},
            {probe, faultcheck_fault_gen:probe(oneof([bool, u8, i16, f32, u64, bytes]))},
            {sensor, faultcheck_fault_gen:sensor()},
            {sensor, faultcheck_fault_gen:sensor(u8)},
            {communication, faultcheck_fault_gen:communication()}
        ]),
        aggregate(
            [model_name(Fault)],
            faultcheck_fault:validate(Fault) =:= ok andalso
                faultcheck_fault:class(Fault) =:= Class andalso
                is_list(faultcheck_fault:describe(Fault))
        )
    ).

prop_generated_faults_are_valid(doc) -> "Generated faults are valid and of the class asked for";
prop_generated_faults_are_valid(opts) -> [{numtests, 500}].

prop_faults_shrink_downwards() ->
    ?FORALL(
        Fault,
        faultcheck_fault_gen:fault(),
        begin
            Rank = faultcheck_fault_weaker:rank(Fault),
            Bad = [
                Candidate
             || Candidate <- faultcheck_fault_weaker:faults(Fault),
                faultcheck_fault:validate(Candidate) =/= ok orelse
                    faultcheck_fault:class(Candidate) =/= faultcheck_fault:class(Fault) orelse
                    not below(faultcheck_fault_weaker:rank(Candidate), Rank)
            ],
            ?WHENFAIL(io:format("not weaker than ~p: ~p~n", [Fault, Bad]), Bad =:= [])
        end
    ).

prop_faults_shrink_downwards(doc) -> "No candidate is stronger, longer, earlier or less simple";
prop_faults_shrink_downwards(opts) -> [{numtests, 500}].

%% Simpler, or nothing worse and something better.
below(#{conditions := C, length := Length}, #{conditions := D, length := Before}) when C < D ->
    Length =:= Before;
below(New, Old) ->
    Pairs = lists:zip(measures(New), measures(Old)),
    lists:all(fun({N, O}) -> N =< O end, Pairs) andalso
        lists:any(fun({N, O}) -> N < O end, Pairs).

measures(#{conditions := C, length := L, earliness := E, strength := S}) -> [C, L, E | S].

%% Always the boldest candidate, then always the most timid.
prop_shrinking_ends() ->
    ?FORALL(
        {Fault, Pick},
        {faultcheck_fault_gen:fault(), oneof([boldest, most_timid])},
        steps(Fault, Pick, 0) < 2000
    ).

prop_shrinking_ends(doc) -> "Shrinking a fault comes to an end";
prop_shrinking_ends(opts) -> [{numtests, 50}].

steps(_, _, N) when N >= 2000 -> N;
steps(Fault, Pick, N) ->
    case {faultcheck_fault_weaker:faults(Fault), Pick} of
        {[], _} -> N;
        {[First | _], boldest} -> steps(First, Pick, N + 1);
        {Candidates, most_timid} -> steps(lists:last(Candidates), Pick, N + 1)
    end.

model_name(Fault) ->
    case faultcheck_fault:model(Fault) of
        Name when is_atom(Name) -> Name;
        Model -> element(1, Model)
    end.

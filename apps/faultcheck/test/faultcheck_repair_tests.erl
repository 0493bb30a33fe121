-module(faultcheck_repair_tests).

-include_lib("eunit/include/eunit.hrl").

set(N, Name, Args) -> {set, {var, N}, {call, chain_model, Name, Args}}.

legal_sequences_stay_as_they_are_test() ->
    Commands = [set(1, open, []), set(2, login, [ann]), set(3, start, []),
                set(4, incr, [{var, 2}, 7]), set(5, commit, [])],
    ?assertEqual(Commands, faultcheck_repair:repair(chain_model, Commands)).

what_became_illegal_is_dropped_test() ->
    ?assertEqual([set(1, open, [])],
                 faultcheck_repair:repair(chain_model, [set(1, open, []), set(3, start, []),
                                                        set(5, commit, [])])).

a_lost_variable_is_replaced_by_the_latest_of_the_same_command_test() ->
    Kept = [set(1, open, []), set(2, login, [ann]), set(6, start, []),
            set(7, incr, [{var, 5}, 7])],
    Names = #{1 => open, 2 => login, 5 => login, 6 => start, 7 => incr},
    ?assertEqual({lists:sublist(Kept, 3) ++ [set(7, incr, [{var, 2}, 7])],
                  #{7 => [{var, 2}, imm]}},
                 faultcheck_repair:repair(chain_model, Kept, #{7 => [{var, 5}, imm]}, Names)).

side_data_of_dropped_commands_is_dropped_test() ->
    ?assertEqual({[], #{}},
                 faultcheck_repair:repair(chain_model, [set(3, start, [])], #{3 => [x]}, #{})).

a_model_without_a_clause_for_the_state_forbids_the_command_test() ->
    ?assertEqual([], faultcheck_repair:repair(odd_model, [{set, {var, 1}, {call, odd_model, crash,
                                                                           [pre_raises]}}])).

variables_are_renumbered_everywhere_test() ->
    ?assertEqual({[set(1, login, [ann]), set(2, incr, [{var, 1}, 7])], #{2 => [{var, 1}, imm]}},
                 faultcheck_repair:renumber([set(4, login, [ann]), set(9, incr, [{var, 4}, 7])],
                                            #{9 => [{var, 4}, imm]})).

the_state_before_a_command_is_symbolic_test() ->
    Commands = [set(1, open, []), set(2, login, [ann]), set(3, start, [])],
    ?assertEqual({st, true, {var, 2}, false},
                 faultcheck_repair:state_before(chain_model, 3, Commands)).

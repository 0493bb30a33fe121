-module(faultcheck_parallel_tests).

-include_lib("proper/include/proper.hrl").
-include_lib("eunit/include/eunit.hrl").

-define(MODEL, counter_model).

set(N, Name) -> set(N, Name, []).
set(N, Name, Args) -> {set, {var, N}, {call, ?MODEL, Name, Args}}.

explain(Case, Results) -> explain(Case, Results, #{}).
explain(Case, Results, Times) ->
    case faultcheck_linear:explain(?MODEL, Case, {maps:from_list(Results), Times}) of
        {Verdict, Calls} -> {Verdict, [N || {N, _, _, _} <- Calls]}
    end.

%% ---- orders

two_counts() -> {parallel, [set(1, count)], [[set(2, count)], [set(3, count)]], [set(4, read)]}.

an_order_is_found_test() ->
    Results = [{1, 1}, {2, 3}, {3, 2}, {4, 3}],
    ?assertEqual({explained, [1, 3, 2, 4]}, explain(two_counts(), Results)).

a_lost_count_has_no_order_test() ->
    Lost = [{1, 1}, {2, 2}, {3, 2}, {4, 2}],
    ?assertEqual({unexplained, [1, 2]}, explain(two_counts(), Lost)).

%% Only what runs afterwards tells.
a_wrong_end_has_no_order_test() ->
    Results = [{1, 1}, {2, 2}, {3, 3}, {4, 2}],
    ?assertEqual({unexplained, [1, 2, 3]}, explain(two_counts(), Results)).

the_order_inside_a_branch_stays_test() ->
    Case = {parallel, [], [[set(1, read), set(2, count)], [set(3, read)]], []},
    ?assertMatch({explained, _}, explain(Case, [{1, 0}, {2, 1}, {3, 1}])),
    ?assertMatch({unexplained, _}, explain(Case, [{1, 1}, {2, 1}, {3, 1}])).

what_had_ended_comes_before_test() ->
    Case = {parallel, [], [[set(1, count)], [set(2, read)]], []},
    Results = [{1, 1}, {2, 0}],
    ?assertEqual({explained, [2, 1]}, explain(Case, Results, #{1 => {1, 4}, 2 => {2, 3}})),
    ?assertEqual({explained, [2, 1]}, explain(Case, Results, #{1 => {3, 4}, 2 => {1, 2}})),
    ?assertEqual({unexplained, [1]}, explain(Case, Results, #{1 => {1, 2}, 2 => {3, 4}})).

an_exception_has_no_order_test() ->
    Case = {parallel, [set(1, read)], [], []},
    ?assertEqual({unexplained, []}, explain(Case, [{1, {exception, error, oops, []}}])).

%% 10 commands in each of 3 branches have 5.5e12 orders.
states_are_not_searched_twice_test() ->
    Branch = fun(From) -> [set(N, count) || N <- lists:seq(From, From + 9)] end,
    Branches = [Branch(1), Branch(11), Branch(21)],
    Results = [{N, N} || N <- lists:seq(1, 29)] ++ [{30, 99}],
    ?assertMatch({unexplained, _}, explain({parallel, [], Branches, []}, Results)).

%% ---- legal cases

legal(Case) -> faultcheck_parallel_case:legal(?MODEL, Case).

results_do_not_cross_branches_test() ->
    Use = set(2, known, [{var, 1}]),
    ?assert(legal({parallel, [set(1, count)], [[Use]], []})),
    ?assert(legal({parallel, [], [[set(1, count), Use]], []})),
    ?assert(legal({parallel, [], [[set(1, count)]], [Use]})),
    ?assertNot(legal({parallel, [], [[set(1, count)], [Use]], []})),
    ?assertNot(legal({parallel, [Use], [], [set(1, count)]})).

every_order_must_be_legal_test() ->
    ?assert(legal({parallel, [], [[set(1, take)], [set(2, read)]], []})),
    ?assertNot(legal({parallel, [], [[set(1, take)], [set(2, take)]], []})),
    ?assertNot(legal({parallel, [], [[set(1, take)]], [set(2, take)]})).

generated_cases_are_legal_test() ->
    Branches = faultcheck_proper:with_state(30, {1, 2, 3}, fun() ->
        [
            begin
                Limits = #{branches => 3, length => 3},
                {{parallel, _, Bs, _} = Case, _} =
                    faultcheck_parallel_case:generate(?MODEL, 30, Limits),
                ?assert(legal(Case)),
                ?assert(lists:all(fun(B) -> length(B) =< 3 end, Bs)),
                length([B || B <- Bs, B =/= []])
            end
         || _ <- lists:seq(1, 100)
        ]
    end),
    ?assert(lists:member(3, Branches)).

the_flat_form_holds_everything_test() ->
    Case = {parallel, [set(1, count)], [[set(2, count)], [set(3, read)]], [set(4, read)]},
    ?assertEqual(
        Case, faultcheck_parallel_case:unflatten(?MODEL, faultcheck_parallel_case:flatten(Case))).

%% ---- properties

property(Kind, Repetitions) ->
    ?FORALL(
        Case,
        faultcheck_parallel:commands(?MODEL),
        begin
            Options = #{setup => fun() -> counter_model:reset(Kind) end,
                        repetitions => Repetitions},
            Result = faultcheck_parallel:run_commands(?MODEL, Case, Options),
            aggregate(faultcheck_parallel:command_names(Case), faultcheck_parallel:is_ok(Result))
        end
    ).

atomic_counts_pass_test() ->
    ?assert(proper:quickcheck(property(atomic, 5), [quiet, {numtests, 50}])).

%% What is left: two counts at once, and perhaps one command that shows what came of them.
torn_counts_fail_and_shrink_test() ->
    false = proper:quickcheck(property(torn, 50), [quiet, {numtests, 200}]),
    [{parallel, First, Branches, Last}] = proper:counterexample(),
    ?assertEqual([count, count],
                 [Name || {set, _, {call, _, Name, _}} <- lists:append(Branches)]),
    ?assertEqual([1, 1], [length(B) || B <- Branches]),
    ?assertEqual([], First ++ Last).

the_same_seed_gives_the_same_cases_test() ->
    Cases = fun() ->
        faultcheck_proper:with_state(20, {4, 5, 6}, fun() ->
            [faultcheck_proper:clean(Imm)
             || _ <- lists:seq(1, 20),
                {ok, Imm} <- [faultcheck_proper:generate(faultcheck_parallel:commands(?MODEL))]]
        end)
    end,
    ?assertEqual(Cases(), Cases()).

%% What failed is run more often from then on, what was generated is not.
a_case_is_run_again_more_often_test() ->
    Caller = self(),
    Execute = fun(_, N) -> Caller ! {times, N}, [] end,
    Times = fun(Case) ->
        _ = faultcheck_parallel:run_commands(?MODEL, Case, #{repetitions => 7, execute => Execute}),
        receive {times, N} -> N after 0 -> none end
    end,
    Fresh = faultcheck_proper:with_state(20, {1, 1, 1}, fun() ->
        {ok, Imm} = faultcheck_proper:generate(faultcheck_parallel:commands(?MODEL)),
        faultcheck_proper:clean(Imm)
    end),
    ?assertEqual([7, 70, 70], [Times(Fresh), Times(Fresh), Times(two_counts())]).

%% ---- words

a_failure_in_words_test() ->
    _ = counter_model:reset(atomic),
    Lost = {#{1 => 1, 2 => 2, 3 => 2, 4 => 2}, #{}},
    Options = #{execute => fun(_, _) -> [Lost] end},
    Result = faultcheck_parallel:run_commands(?MODEL, two_counts(), Options),
    ?assertNot(faultcheck_parallel:is_ok(Result)),
    ?assertEqual(
        "no order of the commands gives what repetition 1 gave:\n"
        "first:\n  V1: counter_model:count() -> 1\n"
        "thread 1:\n  V2: counter_model:count() -> 2\n"
        "thread 2:\n  V3: counter_model:count() -> 2\n"
        "last:\n  V4: counter_model:read() -> 2\n"
        "the longest order that does: V2; not: V3, V4\n",
        lists:flatten(faultcheck_parallel:pretty(Result))),
    ?assertMatch({ok, _}, faultcheck_parallel:why([17, two_counts()])),
    ?assertEqual(none, faultcheck_parallel:why([17])),
    ?assertEqual("first:", lists:flatten(hd(faultcheck_parallel:lines(two_counts())))).

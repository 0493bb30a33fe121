%% Also the tests of what faultcheck_instrument relies on in PropEr.
-module(faultcheck_instrument_tests).
-include_lib("proper/include/proper.hrl").
-include_lib("eunit/include/eunit.hrl").

outer_wrappers_are_taken_off_test() ->
    Print = fun(_, _) -> ok end,
    Setup = fun() -> fun() -> ok end end,
    Test = ?FORALL(_, integer(), true),
    {Test, Outer} = faultcheck_instrument:peel(
        proper:numtests(7, proper:fails(proper:on_output(Print, ?SETUP(Setup, Test))))
    ),
    ?assertEqual(#{numtests => 7, fails => true, on_output => Print, setup => [Setup]}, Outer).

set_up_runs_once_test() ->
    put(setups, []),
    Note = fun(What) -> put(setups, [What | get(setups)]) end,
    Property = ?SETUP(
        fun() ->
            _ = Note(first),
            fun() -> _ = Note(last), ok end
        end,
        ?FORALL(_, integer(), true)
    ),
    true = quickcheck(Property, 1, [{numtests, 5}]),
    ?assertEqual([last, first], get(setups)).

%% The same number and seed draw the same values, wherever the run begins.
values_depend_on_seed_and_number_test() ->
    Drawn = fun(Seed, First) ->
        put(drawn, []),
        Property = ?FORALL(L, list(integer()), begin put(drawn, [L | get(drawn)]), true end),
        Sizes = [{numtests, 10}, {start_size, 8}, {max_size, 8}],
        true = quickcheck(Property, Seed, First, Sizes),
        lists:reverse(get(drawn))
    end,
    All = Drawn(3, 1),
    ?assertEqual(All, Drawn(3, 1)),
    ?assertNotEqual(All, Drawn(4, 1)),
    ?assertEqual(lists:nthtail(4, All), lists:sublist(Drawn(3, 5), 6)).

the_counterexample_keeps_its_shape_test() ->
    Property = ?FORALL(X, integer(), ?FORALL(Y, integer(), X + Y < 10)),
    [X, Y] = quickcheck(Property, 1, [{numtests, 1000}]),
    ?assert(X + Y >= 10),
    ?assertEqual(false, proper:check(Property, [X, Y], [quiet])).

conjunctions_keep_their_tags_test() ->
    Inner = ?FORALL(Y, integer(), Y < 5),
    Property = ?FORALL(_, integer(), proper:conjunction([{fine, true}, {also, Inner}])),
    [X, [{also, [Y]}]] = quickcheck(Property, 1, [{numtests, 1000}]),
    ?assert(is_integer(X) andalso Y >= 5),
    ?assertEqual(false, proper:check(Property, [X, [{also, [Y]}]], [quiet])).

exceptions_are_kept_test_() ->
    [
        {Title, fun() ->
            Table = ets:new(exceptions, [public]),
            Result = quickcheck(Property, 1, 1, Table, [{numtests, 300}]),
            ?assertNotEqual(true, Result),
            ?assertMatch({error, {too, big}, [_ | _]}, faultcheck_instrument:exception(Table))
        end}
     || {Title, Property} <- [
            {"in the body", ?FORALL(X, integer(), raise(X))},
            {"in an inner ?FORALL", ?FORALL(_, integer(), ?FORALL(X, integer(), raise(X)))},
            {"behind ?IMPLIES", ?FORALL(X, integer(), ?IMPLIES(X > 0, raise(X)))},
            {"behind ?WHENFAIL", ?FORALL(X, integer(), ?WHENFAIL(ok, raise(X)))},
            {"behind collect",
                ?FORALL(X, integer(), proper:collect(X, ?WHENFAIL(ok, raise(X))))},
            {"in ?TIMEOUT", ?FORALL(X, integer(), ?TIMEOUT(1000, raise(X)))},
            {"in ?TRAPEXIT", ?FORALL(X, integer(), ?TRAPEXIT(raise(X)))}
        ]
    ].

raise(X) when X > 3 -> error({too, big});
raise(_) -> true.

no_exception_is_none_test() ->
    ?assertEqual(none, faultcheck_instrument:exception(ets:new(exceptions, []))).

generators_may_give_up_test() ->
    Property = ?FORALL(X, ?SUCHTHAT(N, integer(), N > 1000000), X > 0),
    ?assertMatch({error, _}, quickcheck(Property, 1, [{constraint_tries, 3}])).

an_empty_rest_of_a_run_passes_test() ->
    put(runs, 0),
    Property = ?FORALL(_, integer(), begin put(runs, get(runs) + 1), true end),
    Table = ets:new(exceptions, [public]),
    Plan = (plan(1, Table, 1))#{next := fun() ->
        case get(runs) of
            3 -> stop;
            N -> N + 1
        end
    end},
    Test = faultcheck_instrument:test(faultcheck_instrument:peel(Property), Plan),
    true = proper:quickcheck(Test, [quiet, {numtests, 50}]),
    ?assertEqual(3, get(runs)).

values_without_running_test() ->
    Table = ets:new(exceptions, [public]),
    Self = self(),
    Instead = fun(V) -> Self ! {value, V}, ok end,
    Plan = (plan(1, Table, 1))#{instead => Instead},
    Property = ?FORALL(_, integer(), error(not_to_be_run)),
    Test = faultcheck_instrument:test(faultcheck_instrument:peel(Property), Plan),
    true = proper:quickcheck(Test, [quiet, {numtests, 1}]),
    receive {value, V} -> ?assert(is_integer(V)) end.

size_is_that_of_proper_test() ->
    put(sizes, []),
    Property = ?FORALL(_, integer(), begin
        put(sizes, [faultcheck_instrument:size() | get(sizes)]),
        true
    end),
    true = quickcheck(Property, 1, [{numtests, 5}, {start_size, 3}, {max_size, 7}]),
    ?assertEqual([3, 4, 5, 6, 7], lists:reverse(get(sizes))).

%% ---- help ---------------------------------------------------------------------------------

quickcheck(Property, Seed, Options) -> quickcheck(Property, Seed, 1, Options).

quickcheck(Property, Seed, First, Options) ->
    quickcheck(Property, Seed, First, ets:new(exceptions, [public]), Options).

quickcheck(Property, Seed, First, Table, Options) ->
    Plan = plan(Seed, Table, First),
    Test = faultcheck_instrument:test(faultcheck_instrument:peel(Property), Plan),
    proper:quickcheck(Test, [quiet, long_result, noshrink | Options]).

plan(Seed, Table, First) ->
    Counter = counters:new(1, []),
    counters:put(Counter, 1, First - 1),
    #{
        property => {?MODULE, prop_x},
        seed => Seed,
        exceptions => Table,
        next => fun() ->
            counters:add(Counter, 1, 1),
            counters:get(Counter, 1)
        end
    }.

-module(airbag_experiment_tests).
-include_lib("eunit/include/eunit.hrl").

experiment_test_() ->
    {setup, fun airbag_test_sut:port/0, fun(_) -> ok end, [
        {"first failures do not depend on the workers", {timeout, 60, fun first_failures/0}},
        {"a long run counts what it reached", {timeout, 60, fun long_run/0}},
        {"a failure is listed with its flips", {timeout, 60, fun failure/0}}
    ]}.

focused() -> airbag_options:new(#{protection => plain, generator => focused}).

first_failures() ->
    {ok, One} = airbag_experiment:first_failures(focused(), 6, #{workers => 1}),
    {ok, Two} = airbag_experiment:first_failures(focused(), 6, #{workers => 2}),
    ?assertEqual(One, Two),
    ?assertEqual([1, 2, 3, 4, 5, 6], [Seed || {Seed, _} <- One]),
    ?assertEqual([], [N || {_, N} <- One, not is_integer(N)]),
    %% the paper: most of the time fewer than 50
    ?assert(lists:sum([N || {_, N} <- One]) < 6 * 200).

long_run() ->
    Airbag = airbag_options:new(#{max_flips => 2}),
    {ok, #{counts := Counts, found := [], done := 420}} =
        airbag_experiment:long_run(Airbag, 1, 420, #{workers => 2, chunk => 50}),
    Sum = fun(Kind, Weigh) ->
        lists:sum([Weigh(K) * N || {{T, K}, N} <- maps:to_list(Counts), T =:= Kind])
    end,
    One = fun(_) -> 1 end,
    ?assertEqual(420, Sum(length, One)),
    ?assertEqual(420, Sum(faults, One)),
    Same = fun(N) -> N end,
    ?assertEqual(Sum(length, Same), Sum(command, One)),
    %% an iteration ends with a check without data, and sensor and explosion make one each
    #{{command, sensor} := Sensor, {command, explosion} := Explosion} = Counts,
    ?assertEqual(Sensor + Explosion, maps:get({status, no_new_data}, Counts)).

failure() ->
    {ok, [{1, Number}]} = airbag_experiment:first_failures(focused(), 1, #{}),
    {ok, #{found := [First | _]}} = airbag_experiment:long_run(focused(), 1, Number, #{}),
    #{test := Number, flips := Flips, commands := Commands} = First,
    ?assertNotEqual([], Flips),
    ?assertMatch({set, _, {call, airbag_eqc, sensor, [[_, 170]]}}, lists:last(Commands)).

%% The reference model against the examples of the document and known numbers: what it says is
%% what the library is measured by.
-module(faultcheck_ref_tests).

-include_lib("eunit/include/eunit.hrl").

with(Models) ->
    lists:foldl(
        fun({N, Model}, C) ->
            {'FC_OK', Next} = faultcheck_ref:add({probe, <<"p">>}, Model, N, C),
            Next
        end,
        faultcheck_ref:new(1),
        lists:zip(lists:seq(1, length(Models)), Models)).

trigger(Id, Change, C) ->
    {'FC_OK', Next} = faultcheck_ref:trigger(Id, Change, C),
    Next.

probes(Type, Values, C) ->
    {Results, _} = lists:mapfoldl(
        fun(Value, Sofar) ->
            {_, Result, Next} = faultcheck_ref:probe(<<"p">>, Type, Value, Sofar),
            {Result, Next}
        end,
        C,
        Values),
    Results.

code(Type, Value, C) -> element(1, faultcheck_ref:probe(<<"p">>, Type, Value, C)).

%% Section 2.
faults_apply_in_the_order_of_adding_test() ->
    ?assertEqual([2075], probes(i32, [0], with([{bitflip, 2}, {offset, 23}, {bitflip, 11}]))).

conversion_truncates_toward_zero_test() ->
    ?assertEqual([0], probes(i32, [-1], with([{offset, 0.5}]))),
    ?assertEqual([-4], probes(i32, [3], with([{amplification, -1.5}]))),
    ?assertEqual([-1], probes(i32, [7], with([{set_to, -1.9}]))).

a_negative_zero_stays_test() ->
    Word = faultcheck_ref_value:new(f64, -0.0),
    ?assertEqual([Word], probes(f64, [Word], with([{amplification, 2.0}]))).

%% Section 3: the example of three windows.
windows_test() ->
    Windows = [{1, 120, 45, 121, 165}, {2, 45, 200, 46, 245}, {3, 130, 10, 131, 140}],
    [
        begin
            C = trigger(1, {for, For}, trigger(1, {from, From}, with([{set_to, 1}]))),
            Affected = [N || {N, 1} <- lists:zip(lists:seq(1, 300), probes(u8, zeros(300), C))],
            ?assertEqual(lists:seq(First, Last), Affected)
        end
     || {_, From, For, First, Last} <- Windows
    ].

zeros(N) -> lists:duplicate(N, 0).

an_exhausted_fault_is_revived_by_a_duration_test() ->
    C = trigger(1, {once, 0}, with([{set_to, 1}])),
    {_, 1, Used} = faultcheck_ref:probe(<<"p">>, u8, 0, C),
    ?assertEqual([0, 0], probes(u8, [0, 0], Used)),
    ?assertEqual([1, 1, 0], probes(u8, [0, 0, 0], trigger(1, {for, 2}, Used))).

%% Section 5.
saturation_test() ->
    ?assertEqual([16#7FFFFFFF], probes(i32, [1], with([{offset, 1.0e10}]))),
    ?assertEqual([0], probes(u64, [1], with([{offset, neg_inf}]))),
    ?assertEqual('FC_E_VALUE', code(i32, 1, with([{set_to, nan}]))),
    ?assertEqual([1], probes(i32, [1], with([{set_to, nan}]))).

bits_the_type_does_not_have_test() ->
    ?assertEqual('FC_E_BIT', code(i32, 1, with([{bitflip, 32}]))),
    ?assertEqual('FC_OK', code(f64, 1, with([{bitflip, 63}]))).

stuck_holds_the_first_value_of_a_window_test() ->
    C = trigger(1, {periodic, 3, 2}, with([stuck])),
    ?assertEqual([1, 1, 3, 4, 4, 6], probes(u8, [1, 2, 3, 4, 5, 6], C)).

%% 64-bit integers are computed exactly (7.2), also where a double is not.
exact_integers_test() ->
    ?assertEqual([(1 bsl 63) - 2], probes(i64, [-2], with([{offset, 9223372036854775808.0}]))).

%% The numbers of SplitMix64 seeded with 1234567, as published with the algorithm.
stream_test() ->
    %% FNV-1a-64 of "a" is known; it and the seed cancel.
    Stream = faultcheck_ref_stream:new(16#AF63DC4C8601EC8C bxor 1234567, <<"a">>, 0),
    {First, Next} = faultcheck_ref_stream:below(1 bsl 64, Stream),
    {Second, _} = faultcheck_ref_stream:below(1 bsl 64, Next),
    ?assertEqual([6457827717110365317, 3203168211198807973], [First, Second]).

%% ---- 7.6 by hand ------------------------------------------------------------------------------

sensors_test_() ->
    [
        ?_assertEqual(Expected, probes(i32, Values, with([Model])))
     || {Model, Values, Expected} <- [
            {{drift, 2, 5}, [0, 0, 0, 0], [2, 4, 5, 5]},
            {{ramp, 10, 4}, [2, 0, 0, 0, 0], [4, 6, 8, 10, 10]},
            {{delay, {calls, 2}}, [1, 2, 3, 4], [1, 1, 1, 2]},
            {{quantise, 5}, [2, 3, -3], [0, 5, -5]},
            {{dead_zone, 10, 3}, [7, 8, 12, 13], [7, 10, 10, 13]},
            {{saturate, -1, 1}, [-5, 0, 5], [-1, 0, 1]}
        ]
    ].

%% ---- section 4 --------------------------------------------------------------------------------

channel(Models, Packets) ->
    Armed = lists:foldl(
        fun({N, Model}, C) ->
            {'FC_OK', Next} = faultcheck_ref:add({channel, <<"c">>}, Model, N, C),
            Next
        end,
        faultcheck_ref:new(1),
        lists:zip(lists:seq(1, length(Models)), Models)),
    lists:foldl(
        fun(P, C) ->
            {'FC_OK', Next} = faultcheck_ref:put(<<"c">>, P, C),
            Next
        end,
        Armed,
        Packets).

gets(N, C) ->
    {Results, _} = lists:mapfoldl(
        fun(_, Sofar) -> faultcheck_ref:get(<<"c">>, <<>>, 64, Sofar) end, C, lists:seq(1, N)),
    [case R of {packet, P} -> P; Other -> Other end || R <- Results].

a_drop_keeps_the_rest_of_its_budget_test() ->
    C = channel([{drop, 3}], [<<1>>]),
    {nothing, Dropped} = faultcheck_ref:get(<<"c">>, <<>>, 64, C),
    More = lists:foldl(fun(P, S) -> element(2, faultcheck_ref:put(<<"c">>, P, S)) end, Dropped,
                       [<<2>>, <<3>>, <<4>>, <<5>>]),
    ?assertEqual([<<4>>, <<5>>], gets(2, More)).

repeat_and_corruption_test() ->
    C = channel([{repeat, 1}, {corruption, 0, 0}], [<<4>>, <<6>>]),
    ?assertEqual([<<5>>, <<5>>, <<7>>, nothing], gets(4, C)).

%% 5.14
drop_before_repeat_test() ->
    ?assertEqual([<<"B">>, <<"B">>, <<"C">>],
                 gets(3, channel([{drop, 1}, {repeat, 1}], [<<"A">>, <<"B">>, <<"C">>]))),
    ?assertEqual([<<"A">>, <<"B">>],
                 gets(2, channel([{repeat, 1}, {drop, 1}], [<<"A">>, <<"B">>]))).

what_does_not_fit_stays_test() ->
    C = channel([{drop, 1}], [<<1>>, <<1, 2>>]),
    ?assertMatch({{'FC_E_SPACE', 2}, _}, faultcheck_ref:get(<<"c">>, <<>>, 1, C)),
    {_, Same} = faultcheck_ref:get(<<"c">>, <<>>, 1, C),
    ?assertEqual(gets(3, C), gets(3, Same)).

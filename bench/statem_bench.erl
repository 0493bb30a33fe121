%% @doc What generating and running a command sequence costs without a system under test, beside
%% PropEr's own proper_statem with the same commands.
-module(statem_bench).

-export([main/0]).

-define(TESTS, 200).

-spec main() -> no_return().
main() ->
    Proper = fun(Seen) -> noop_statem:property(1.0, Seen) end,
    Own = fun grouped_noop:property/1,
    ProperRate = ?TESTS / seconds(Proper),
    OwnRate = ?TESTS / seconds(Own),
    Baseline = lists:concat(["proper_statem, same commands, tests/s, mean length ",
                             short(mean_length(Proper)), " against ", short(mean_length(Own))]),
    bench_time:print(statem_vs_proper, OwnRate / ProperRate, "ratio", with, Baseline, ProperRate),
    bench_time:print(statem_tests_s, OwnRate, "tests/s", none),
    halt(0).

%% Seconds that ?TESTS tests take.
seconds(Property) ->
    Run = fun() -> holds(Property(fun(_) -> ok end), ?TESTS) end,
    bench_time:nanoseconds(Run, 1) / 1.0e9.

holds(Property, Tests) ->
    true = proper:quickcheck(Property, [quiet, {numtests, Tests}, {max_size, 42}]).

mean_length(Property) ->
    Me = self(),
    Ref = make_ref(),
    holds(Property(fun(N) -> Me ! {Ref, N} end), 2000),
    Lengths = received(Ref, []),
    lists:sum(Lengths) / length(Lengths).

received(Ref, Lengths) ->
    receive {Ref, N} -> received(Ref, [N | Lengths]) after 0 -> Lengths end.

short(Number) -> float_to_list(Number, [{decimals, 1}]).

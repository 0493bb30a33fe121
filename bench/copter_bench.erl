%% @doc Tests of ten quadcopters that a core runs in a second, and the simulated time of one.
-module(copter_bench).

-export([main/0]).

-define(TESTS, 60).
-define(ROUNDS, 5).

-spec main() -> no_return().
main() ->
    %% The shipped property over the crowded box, with the configuration that survives it.
    Options = copter_options:new(#{
        min_copters => 10, max_faults => 0, configuration => hardened
    }),
    Rates = [round(Options, Round) || Round <- lists:seq(1, ?ROUNDS)],
    {Rate, Simulated} = lists:nth((?ROUNDS + 1) div 2, lists:sort(Rates)),
    bench_time:print(copter_tests_per_s, Rate, "1/s", none),
    bench_time:print(copter_test_simulated_s, Simulated, "s", none),
    ok = copter_sut:stop(),
    halt(0).

%% Tests a second and the mean of their simulated seconds.
round(Options, Round) ->
    Count = counters:new(1, []),
    Property = proper:forall(
        faultcheck_statem:more_commands(2, faultcheck_statem:commands(copter_eqc)),
        fun(Commands) ->
            ok = copter_eqc:begin_test(Options),
            _ = faultcheck_statem:run_commands(copter_eqc, Commands),
            counters:add(Count, 1, copter_sut:time_us()),
            true
        end
    ),
    ok = copter_options:use(Options),
    Sizes = [{numtests, ?TESTS}, {start_size, 20}, {max_size, 42}],
    Seeded = proper:setup(
        fun() ->
            _ = rand:seed(exsss, Round),
            fun() -> ok end
        end,
        Property
    ),
    Start = erlang:monotonic_time(microsecond),
    true = proper:quickcheck(Seeded, [quiet | Sizes]),
    Us = erlang:monotonic_time(microsecond) - Start,
    {?TESTS * 1.0e6 / Us, counters:get(Count, 1) / 1.0e6 / ?TESTS}.

%% @doc What a test of the airbag costs, beside PropEr's own cost for sequences of the same commands
%% and length; how long 100 000 tests take; and whether memory grows meanwhile.
-module(airbag_bench).

-export([main/0]).

-define(TESTS, 200).

-spec main() -> no_return().
main() ->
    Length = mean_length(fun airbag/1),
    Scale = scale(1.0, Length, 5),
    Noop = seconds(fun(Seen) -> noop_statem:property(Scale, Seen) end),
    Baseline = lists:concat(["PropEr no-op of the same mix, tests/s, mean length ",
                             short(mean_length(fun(Seen) -> noop_statem:property(Scale, Seen) end)),
                             " against ", short(Length)]),
    compare(airbag_nif_vs_noop, nif, Noop, Baseline),
    compare(airbag_port_vs_noop, port, Noop, Baseline),
    ok = airbag_sut:default_transport(nif),
    hundred_thousand(),
    halt(0).

compare(Key, Transport, Noop, Baseline) ->
    ok = airbag_sut:default_transport(Transport),
    Airbag = seconds(fun airbag/1),
    ok = airbag_sut:stop(),
    bench_time:print(Key, Noop / Airbag, "ratio", with, Baseline, ?TESTS / Noop).

%% The shipped property: profile 1, at most two bit flips, with which it holds.
airbag(Seen) ->
    Options = airbag_options:new(#{configuration => thesis, max_flips => 2}),
    proper:forall(faultcheck_statem:commands(airbag_eqc), fun(Commands) ->
        Seen(length(Commands)),
        ok = airbag_eqc:begin_test(Options),
        {_, _, Result} = faultcheck_statem:run_commands(airbag_eqc, Commands),
        Result =:= ok
    end).

%% Seconds that ?TESTS tests take.
seconds(Property) ->
    Run = fun() -> holds(Property(fun(_) -> ok end), ?TESTS) end,
    bench_time:nanoseconds(Run, 1) / 1.0e9.

holds(Property, Tests) ->
    true = proper:quickcheck(Property, [quiet, {numtests, Tests}, {max_size, 42}]).

mean_length(Property) ->
    Me = self(),
    holds(Property(fun(N) -> Me ! {length, N} end), 2000),
    Lengths = received([]),
    lists:sum(Lengths) / length(Lengths).

received(Lengths) ->
    receive {length, N} -> received([N | Lengths]) after 0 -> Lengths end.

%% How much to stretch the no-op's sequences so that they are as long as the airbag's.
scale(Scale, _Length, 0) -> Scale;
scale(Scale, Length, Tries) ->
    Noop = mean_length(fun(Seen) -> noop_statem:property(Scale, Seen) end),
    scale(Scale * Length / Noop, Length, Tries - 1).

hundred_thousand() ->
    Source = filename:join(os:getenv("FC_ROOT"), "bench/call_target.c"),
    {ok, Lib} = cb:start(bench_heap, [{c_src, [Source]}, {transport, nif}, {reset, none}]),
    Count = counters:new(1, []),
    Me = self(),
    Seen = fun(_) ->
        counters:add(Count, 1, 1),
        counters:get(Count, 1) =:= 1000 andalso (Me ! {memory, memory(Lib)})
    end,
    Start = erlang:monotonic_time(millisecond),
    holds(airbag(Seen), 100000),
    Seconds = (erlang:monotonic_time(millisecond) - Start) / 1000,
    After = memory(Lib),
    Before = receive {memory, Bytes} -> Bytes end,
    bench_time:print(airbag_100k_s, Seconds, "s", none),
    bench_time:print(mem_growth_100k_mib, (After - Before) / 1048576, "MiB", none),
    cb:stop(Lib).

memory(Lib) ->
    _ = [erlang:garbage_collect(P) || P <- processes()],
    erlang:memory(total) + cb:call(Lib, heap_in_use, []).

short(Number) -> float_to_list(Number, [{decimals, 1}]).

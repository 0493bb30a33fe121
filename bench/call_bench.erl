%% @doc What a call of a C function costs in both transports, and what resetting its library costs.
-module(call_bench).

-export([main/0]).

-define(ARGS, [[85, 170]]).

-spec main() -> no_return().
main() ->
    Source = filename:join(os:getenv("FC_ROOT"), "bench/call_target.c"),
    with_library(bench_nif, [{c_src, [Source]}, {transport, nif}, {reset, snapshot}], fun nif/1),
    with_library(bench_port, [{c_src, [Source]}, {transport, port}, {reset, fork}], fun port/1),
    halt(0).

with_library(Name, Options, Measure) ->
    {ok, Lib} = cb:start(Name, Options),
    try Measure(Lib) after cb:stop(Lib) end.

nif(Lib) ->
    {ok, Handle} = cb:resolve(Lib, sum_of_two),
    255 = cb:call(Lib, Handle, ?ARGS),
    bench_time:print(call_nif_handle_ns,
                     bench_time:nanoseconds(fun() -> cb:call(Lib, Handle, ?ARGS) end, 20000),
                     "ns", none),
    bench_time:print(call_nif_name_ns,
                     bench_time:nanoseconds(fun() -> cb:call(Lib, sum_of_two, ?ARGS) end, 20000),
                     "ns", none),
    bench_time:print(reset_snapshot_us,
                     bench_time:nanoseconds(fun() -> cb:restart(Lib) end, 5000) / 1000, "us", none).

port(Lib) ->
    {ok, Handle} = cb:resolve(Lib, sum_of_two),
    Call = bench_time:nanoseconds(fun() -> cb:call(Lib, Handle, ?ARGS) end, 500),
    Echo = echo(),
    bench_time:print(call_port_vs_echo, Call / Echo, "ratio",
                     with, "bare port echo, us", Echo / 1000),
    Batch = lists:duplicate(100, {sum_of_two, ?ARGS}),
    bench_time:print(call_port_batch_us,
                     bench_time:nanoseconds(fun() -> cb:call_batch(Lib, Batch) end, 50) / 100000,
                     "us", none),
    %% A test that calls nothing would find the child of the last reset unused.
    Test = fun() -> ok = cb:restart(Lib), cb:call(Lib, Handle, ?ARGS) end,
    bench_time:print(reset_fork_ms, (bench_time:nanoseconds(Test, 20) - Call) / 1.0e6, "ms", none).

%% The same bytes there and back through a program that only copies.
echo() ->
    Port = open_port({spawn_executable, os:find_executable("cat")}, [{packet, 4}, binary]),
    Message = term_to_binary({1, {call, 12345, ?ARGS}}),
    Echo = fun() ->
        true = port_command(Port, Message),
        receive {Port, {data, Reply}} -> binary_to_term(Reply) end
    end,
    Time = bench_time:nanoseconds(Echo, 500),
    port_close(Port),
    Time.

%% @doc How everything is timed, and how a figure is printed.
%%
%% A figure is the fastest of 16 short slices, and the median of five such: the machine only ever
%% makes code slower, so the fastest slice is the nearest to what the code costs.
-module(bench_time).

-export([nanoseconds/2, print/4, print/6]).

-define(SLICES, 16).
-define(ROUNDS, 5).

%% @doc Nanoseconds that one call of `Fun' takes, when called `Calls' times in a slice.
-spec nanoseconds(fun(() -> term()), pos_integer()) -> float().
nanoseconds(Fun, Calls) ->
    repeat(Fun, Calls),
    Rounds = [lists:min([slice(Fun, Calls) || _ <- lists:seq(1, ?SLICES)])
              || _ <- lists:seq(1, ?ROUNDS)],
    lists:nth(?ROUNDS div 2 + 1, lists:sort(Rounds)) / Calls.

-spec print(atom(), number(), string(), none) -> ok.
print(Key, Value, Unit, none) ->
    io:format("{\"key\":\"~s\",\"value\":~s,\"unit\":\"~s\",\"baseline\":null,"
              "\"baseline_value\":null}~n",
              [Key, number(Value), Unit]).

%% @doc With what it is compared with: `Baseline' says what that is.
-spec print(atom(), number(), string(), with, string(), number()) -> ok.
print(Key, Value, Unit, with, Baseline, BaselineValue) ->
    io:format("{\"key\":\"~s\",\"value\":~s,\"unit\":\"~s\",\"baseline\":\"~s\","
              "\"baseline_value\":~s}~n",
              [Key, number(Value), Unit, Baseline, number(BaselineValue)]).

slice(Fun, Calls) ->
    Start = erlang:monotonic_time(nanosecond),
    repeat(Fun, Calls),
    erlang:monotonic_time(nanosecond) - Start.

repeat(_Fun, 0) -> ok;
repeat(Fun, N) -> _ = Fun(), repeat(Fun, N - 1).

number(Value) -> io_lib:format("~.6e", [float(Value)]).

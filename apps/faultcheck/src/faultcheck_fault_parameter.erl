%% @doc The kinds of parameters of fault models: what is allowed, and how to say so.
-module(faultcheck_fault_parameter).

-export([check/2, expected/1, is_type/1]).

-define(INT_MAX, 16#7FFFFFFF).
-define(INT64_MAX, 16#7FFFFFFFFFFFFFFF).

%% @doc Is this a value of that kind? Models inside models are the business of faultcheck_fault.
-spec check(faultcheck_fault_catalogue:kind(), term()) -> boolean().
check(bit, V) -> within(V, 0, ?INT_MAX);
check(bit_of_byte, V) -> within(V, 0, 7);
check(bit_value, V) -> within(V, 0, 1);
check(any_real, V) -> V =:= nan orelse check(real, V);
check(real, V) -> is_double(V) orelse V =:= inf orelse V =:= neg_inf;
check(limit, V) -> V =:= none orelse V =:= inf orelse (is_double(V) andalso V >= 0);
check(positive, V) -> V =:= inf orelse (is_double(V) andalso V > 0);
check(probability, V) -> is_double(V) andalso V >= 0 andalso V =< 1;
check(natural, V) -> within(V, 0, ?INT_MAX);
check(count, V) -> within(V, 1, ?INT64_MAX);
check(byte, V) -> within(V, 0, 255);
check(dropout_mode, V) -> lists:member(V, [hold, zero, nan]);
check(name, V) -> is_name(V);
check(data, V) -> is_binary(V);
check(delay, {calls, N}) -> within(N, 0, ?INT64_MAX);
check(channel_delay, {Unit, N}) ->
    lists:member(Unit, [gets, ns]) andalso within(N, 0, ?INT64_MAX);
check(receivers, [_ | _] = Names) -> lists:all(fun is_name/1, Names);
check(field, {Offset, bytes, Length}) -> natural(Offset) andalso natural(Length);
check(field, {Offset, Type, Order}) ->
    natural(Offset) andalso is_type(Type) andalso Type =/= bytes andalso
        lists:member(Order, [little, big]);
check(part, V) -> V =:= whole orelse check(field, V);
check(_, _) -> false.

%% @doc What would be right.
-spec expected(faultcheck_fault_catalogue:kind()) -> string().
expected(bit) -> "an integer from 0 up";
expected(bit_of_byte) -> "an integer 0..7";
expected(bit_value) -> "0 or 1";
expected(any_real) -> "a number, inf, neg_inf or nan";
expected(real) -> "a number, inf or neg_inf";
expected(limit) -> "a number from 0 up or none";
expected(positive) -> "a number above 0";
expected(probability) -> "a number 0..1";
expected(natural) -> "an integer 0..2147483647";
expected(count) -> "an integer from 1 up";
expected(byte) -> "an integer 0..255";
expected(dropout_mode) -> "hold, zero or nan";
expected(name) -> "a binary without zero bytes";
expected(data) -> "a binary";
expected(delay) -> "{calls, N} with N from 0 up";
expected(channel_delay) -> "{gets, N} or {ns, N} with N from 0 up";
expected(receivers) -> "a list of names of receivers, not empty";
expected(field) -> "{Offset, Type, little | big} or {Offset, bytes, Length}";
expected(part) -> "whole or a field";
expected(model) -> "a model of a probe or sensor".

%% @doc The types that probes and fields have.
-spec is_type(term()) -> boolean().
is_type(Type) ->
    lists:member(Type, [f32, f64, i8, i16, i32, i64, u8, u16, u32, u64, bool, bytes]).

natural(V) -> check(natural, V).

within(V, Low, High) -> is_integer(V) andalso V >= Low andalso V =< High.

is_name(V) -> is_binary(V) andalso binary:match(V, <<0>>) =:= nomatch.

%% An integer beyond the range of a double has no such value.
is_double(V) when is_float(V) -> true;
is_double(V) when is_integer(V) ->
    try is_float(float(V))
    catch error:badarg -> false
    end;
is_double(_) -> false.

%% @doc Faults in words: `add 2.5, from call 101 on, 20 times'.
-module(faultcheck_fault_words).

-export([model/1, trigger/1]).

-spec model(faultcheck_fault:model()) -> unicode:chardata().
model({bitflip, Bit}) -> f("invert bit ~b", [Bit]);
model(bitflip_random) -> "invert a bit drawn anew each time";
model(stuck) -> "hold the first value";
model({stuck_bit, Bit, Value}) -> f("force bit ~b to ~b", [Bit, Value]);
model({amplification, K}) -> ["multiply by ", real(K)];
model({offset, C}) -> ["add ", real(C)];
model({set_to, V}) -> ["set to ", real(V)];
model({noise_uniform, A}) -> ["add even noise of at most ", real(A)];
model({noise_gauss, S}) -> ["add normal noise with deviation ", real(S)];
model({random_offset, Low, High}) -> ["add a number drawn from ", range(Low, High)];
model({held_offset, Low, High, Ns}) ->
    ["add a number drawn from ", range(Low, High), " every ", time(Ns)];
model({drift, Rate, Limit}) -> ["drift by ", real(Rate), " each call", limit(Limit)];
model({drift_timed, Rate, Limit}) -> ["drift by ", real(Rate), " each second", limit(Limit)];
model({ramp, V, N}) -> ["ramp to ", real(V), " in ", count(N, "call")];
model({delay, {calls, N}}) -> ["delay by ", count(N, "call")];
model({quantise, Q}) -> ["round to multiples of ", real(Q)];
model({dead_zone, C, W}) -> ["give ", real(C), " for all within ", real(W), " of it"];
model({saturate, Low, High}) -> ["limit to ", range(Low, High)];
model({oscillate, A, N}) -> ["add a sine of ", real(A), " with a period of ", count(N, "call")];
model({dropout, P, Mode}) -> [dropout(Mode), probability(P)];
model({spike, P, A}) -> ["spike by ", real(A), " up or down", probability(P)];
model({corruption, Byte, Bit}) -> f("invert bit ~b of byte ~b", [Bit, Byte]);
model({field, Field, Model}) -> [model(Model), " in the ", field(Field)];
model({truncate, N}) -> ["cut to ", count(N, "byte")];
model({extend, N, Byte}) -> ["append ", count(N, "byte"), f(" of value ~b", [Byte])];
model({drop, N}) -> ["drop ", count(N, "packet")];
model(lose) -> "drop a packet each time";
model({repeat, N}) -> ["deliver a packet ", count(N, "more time")];
model(repeat_last) -> "deliver the packet before again";
model({insert, Data, N}) -> ["insert ", data(Data), " ", count(N, "time")];
model({masquerade, From}) -> ["deliver a packet of channel ", name(From), " instead"];
model({resequence, N}) -> f("deliver the packet at position ~b", [N]);
model(block_get) -> "deliver nothing";
model({delay, {gets, N}}) -> ["delay by ", count(N, "get")];
model({delay, {ns, N}}) -> ["delay by ", time(N)];
model({misroute, To}) -> ["send to channel ", name(To), " instead"];
model({asymmetric, Receivers, whole, Model}) -> [model(Model), " for ", names(Receivers), " only"];
model({asymmetric, Receivers, Field, Model}) ->
    [model(Model), " in the ", field(Field), " for ", names(Receivers), " only"];
model({subset, Receivers}) -> ["send to ", names(Receivers), " only"];
model(block_put) -> "refuse the packet".

dropout(hold) -> "keep the value before";
dropout(zero) -> "give 0";
dropout(nan) -> "give no number".

%% The window first, in its own words; then the other conditions as they stand. A window that is
%% always open says nothing beside another condition.
-spec trigger(faultcheck_fault:trigger()) -> unicode:chardata().
trigger(Trigger) ->
    Window = window(proplists:get_value(from, Trigger, 0), proplists:get_value(for, Trigger)),
    Others = [condition(C) || C <- Trigger, not lists:member(element(1, C), [from, for])],
    lists:join(", ", [Window || Window =/= "always" orelse Others =:= []] ++ Others).

window(0, undefined) -> "always";
window(N, undefined) -> f("from call ~b on", [N + 1]);
window(_, 0) -> "never";
window(N, 1) -> f("once, at call ~b", [N + 1]);
window(0, D) -> f("~b times", [D]);
window(N, D) -> f("~b times from call ~b on", [D, N + 1]).

condition({time, Delay, forever}) -> ["after ", time(Delay)];
condition({time, Delay, Duration}) -> ["after ", time(Delay), " for ", time(Duration)];
condition({random, P}) -> ["with probability ", real(P)];
condition({periodic, Period, Active}) -> f("~b of every ~b calls", [Active, Period]);
condition({predicate, Function}) -> f("while ~ts() says so", [Function]).

field({Offset, bytes, 0}) -> f("bytes from ~b on", [Offset]);
field({Offset, bytes, Length}) -> [count(Length, "byte"), f(" from ~b on", [Offset])];
field({Offset, Type, little}) -> f("~s at byte ~b", [Type, Offset]);
field({Offset, Type, big}) -> f("big-endian ~s at byte ~b", [Type, Offset]).

limit(none) -> "";
limit(inf) -> "";
limit(Limit) -> [", at most ", real(Limit)].

range(Low, High) -> [real(Low), " to ", real(High)].

probability(P) -> [" with probability ", real(P)].

names(Receivers) -> lists:join(", ", [name(R) || R <- Receivers]).

name(Name) -> f("~tp", [unicode_or_latin1(Name)]).

unicode_or_latin1(Name) ->
    case unicode:characters_to_list(Name) of
        Text when is_list(Text) -> Text;
        _ -> binary_to_list(Name)
    end.

data(Data) -> ["a packet of ", count(byte_size(Data), "byte")].

time(Ns) when Ns rem 1000000000 =:= 0 -> f("~b s", [Ns div 1000000000]);
time(Ns) when Ns rem 1000000 =:= 0 -> f("~b ms", [Ns div 1000000]);
time(Ns) when Ns rem 1000 =:= 0 -> f("~b us", [Ns div 1000]);
time(Ns) -> f("~b ns", [Ns]).

real(inf) -> "infinity";
real(neg_inf) -> "-infinity";
real(nan) -> "not-a-number";
real(N) when is_integer(N) -> integer_to_list(N);
real(F) -> io_lib:format("~p", [F]).

count(1, What) -> ["1 ", What];
count(N, What) -> f("~b ~ss", [N, What]).

f(Format, Values) -> io_lib:format(Format, Values).

%% An airbag in plain Erlang, without end-to-end protection: bit flips and repetitions of
%% packets must not make it fire. It fires on two [85,170] in a row.
-module(bag_model).

-include("faultcheck.hrl").

-export([reset/0]).

-record(st, {faults = []}).

reset() ->
    put(bag, #{flips => [], repeat => 1, count => 0, active => 0}),
    ok.

initial_state() -> #st{}.

weight(_, sensor) -> 10;
weight(_, _) -> 1.

faults() -> [bit_flip, repetition].

%% ---- sensor: any reading but the one that means a crash
sensor_args(_) -> [[byte(), 170]].
sensor_pre(_, [Bytes]) -> Bytes =/= [85, 170].
sensor(Bytes) ->
    #{flips := Flips, repeat := Repeat} = Bag = get(bag),
    Seen = lists:foldl(fun flip/2, Bytes, Flips),
    put(bag, lists:foldl(fun receive_packet/2, Bag, lists:duplicate(Repeat, Seen))),
    maps:get(active, get(bag)).
sensor_post(_, [_], Active) -> Active =:= 0.
sensor_req(_, [_], _) -> ['REQ-SAFE'].

%% ---- bit_flip: one bit of a byte of each packet
bit_flip_pre(#st{faults = Faults}) -> length(Faults) < 4.
bit_flip_args(_) -> [integer(0, 1), integer(0, 7)].
bit_flip_pre(#st{faults = Faults}, [Byte, Bit]) -> not lists:member({bit_flip, Byte, Bit}, Faults).
bit_flip(Byte, Bit) ->
    #{flips := Flips} = Bag = get(bag),
    put(bag, Bag#{flips => [{Byte, Bit} | Flips]}),
    ok.
bit_flip_next(#st{faults = Faults} = S, _, [Byte, Bit]) ->
    S#st{faults = [{bit_flip, Byte, Bit} | Faults]}.

%% ---- repetition: each packet arrives N more times
repetition_pre(#st{faults = Faults}) -> length(Faults) < 4.
repetition_args(_) -> [integer(1, 3)].
repetition_pre(#st{faults = Faults}, [N]) -> not lists:member({repetition, N}, Faults).
repetition(N) ->
    Bag = get(bag),
    put(bag, Bag#{repeat => N + 1}),
    ok.
repetition_next(#st{faults = Faults} = S, _, [N]) -> S#st{faults = [{repetition, N} | Faults]}.

%% ---- explosion: without faults, two crash readings fire it
explosion_args(_) -> [[85, 170]].
explosion(Bytes) ->
    Bag = lists:foldl(fun receive_packet/2, get(bag), [Bytes, Bytes]),
    reset(),
    maps:get(active, Bag).
explosion_next(_, _, [_]) -> #st{}.
explosion_post(_, [_], Active) -> Active =:= 1.

flip({Byte, Bit}, Bytes) ->
    [case Index of Byte -> Value bxor (1 bsl Bit); _ -> Value end
     || {Index, Value} <- lists:zip([0, 1], Bytes)].

receive_packet([85, 170], #{count := 1} = Bag) -> Bag#{count => 2, active => 1};
receive_packet([85, 170], #{count := Count} = Bag) -> Bag#{count => Count + 1};
receive_packet(_, Bag) -> Bag#{count => 0}.

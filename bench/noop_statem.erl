%% @doc The airbag's command mix as a plain proper_statem that does nothing: PropEr's own cost.
-module(noop_statem).
-behaviour(proper_statem).
-include_lib("proper/include/proper.hrl").

-export([property/2]).
-export([initial_state/0, command/1, precondition/2, next_state/3, postcondition/3]).
-export([sensor/1, bit_flip/2, repetition/1, explosion/1]).

%% @doc `Scale' stretches the sequences, `Seen' is called with the length of each.
-spec property(float(), fun((non_neg_integer()) -> term())) -> proper:outer_test().
property(Scale, Seen) ->
    Plain = proper_statem:commands(?MODULE),
    Longer = ?SIZED(Size, proper_types:resize(round(Size * Scale), Plain)),
    ?FORALL(Commands, Longer,
            begin
                Seen(length(Commands)),
                {_, _, Result} = proper_statem:run_commands(?MODULE, Commands),
                Result =:= ok
            end).

-spec initial_state() -> [].
initial_state() -> [].

-spec command(list()) -> proper_types:type().
command(_Faults) ->
    frequency([{10, {call, ?MODULE, sensor, [[byte(), 170]]}},
               {1, {call, ?MODULE, bit_flip, [integer(0, 3), integer(0, 7)]}},
               {1, {call, ?MODULE, repetition, [integer(1, 3)]}},
               {1, {call, ?MODULE, explosion, [[85, 170]]}}]).

-spec precondition(list(), tuple()) -> boolean().
precondition(_Faults, {call, _, sensor, [Data]}) -> Data =/= [85, 170];
precondition(Faults, {call, _, explosion, _}) -> is_list(Faults);
precondition(Faults, {call, _, Name, Args}) ->
    length(Faults) < 4 andalso not lists:member({Name, Args}, Faults).

-spec next_state(list(), term(), tuple()) -> list().
next_state(Faults, _Result, {call, _, sensor, _}) -> Faults;
next_state(_Faults, _Result, {call, _, explosion, _}) -> [];
next_state(Faults, _Result, {call, _, Name, Args}) -> Faults ++ [{Name, Args}].

-spec postcondition(list(), tuple(), term()) -> boolean().
postcondition(_Faults, _Call, Result) -> Result =:= 0.

-spec sensor([byte()]) -> 0.
sensor(_Data) -> 0.
-spec bit_flip(0..3, 0..7) -> 0.
bit_flip(_Byte, _Bit) -> 0.
-spec repetition(1..3) -> 0.
repetition(_Num) -> 0.
-spec explosion([byte()]) -> 0.
explosion(_Data) -> 0.

%% The commands of noop_statem as a grouped model: what generating and running costs here.
-module(grouped_noop).

-include_lib("faultcheck/include/faultcheck.hrl").

-export([property/1]).

%% @doc `Seen' is called with the length of each sequence.
-spec property(fun((non_neg_integer()) -> term())) -> proper:outer_test().
property(Seen) ->
    ?FORALL(Commands, commands(?MODULE),
            begin
                Seen(length(Commands)),
                {_, _, Result} = run_commands(?MODULE, Commands),
                Result =:= ok
            end).

initial_state() -> [].

weight(_Faults, sensor) -> 10;
weight(_Faults, _) -> 1.

sensor_args(_Faults) -> [[byte(), 170]].
sensor_pre(_Faults, [Data]) -> Data =/= [85, 170].
sensor(_Data) -> 0.
sensor_post(_Faults, [_Data], Result) -> Result =:= 0.

bit_flip_args(_Faults) -> [integer(0, 3), integer(0, 7)].
bit_flip_pre(Faults, Args) -> fits(bit_flip, Args, Faults).
bit_flip(_Byte, _Bit) -> 0.
bit_flip_next(Faults, _Result, Args) -> Faults ++ [{bit_flip, Args}].
bit_flip_post(_Faults, _Args, Result) -> Result =:= 0.

repetition_args(_Faults) -> [integer(1, 3)].
repetition_pre(Faults, Args) -> fits(repetition, Args, Faults).
repetition(_Num) -> 0.
repetition_next(Faults, _Result, Args) -> Faults ++ [{repetition, Args}].
repetition_post(_Faults, _Args, Result) -> Result =:= 0.

explosion_args(_Faults) -> [[85, 170]].
explosion(_Data) -> 0.
explosion_next(_Faults, _Result, _Args) -> [].
explosion_post(_Faults, _Args, Result) -> Result =:= 0.

fits(Name, Args, Faults) ->
    length(Faults) < 4 andalso not lists:member({Name, Args}, Faults).

%% @doc What a pilot asks for, in the simulator's commands of -1..1.
-module(copter_pilot).

-export([command/3, limits/0]).
-export_type([tilt/0, turn/0]).

%% Tenths of a degree, and of a degree per second.
-type tilt() :: -150..150.
-type turn() :: -900..900.

-define(TILT, 150).
-define(TURN, 900).
%% A lasting command of this much tilts by 15 degrees at steps of 5 ms, and turns by 90 degrees/s.
-define(COMMAND_OF_TILT, 0.609).
-define(COMMAND_OF_TURN, 0.6).

%% @doc The largest tilt and turn that a pilot asks for.
-spec limits() -> {tilt(), turn()}.
limits() -> {?TILT, ?TURN}.

%% @doc The simulator's command for attitudes in tenths of degrees, and a yaw rate.
-spec command(tilt(), tilt(), turn()) -> {Roll :: float(), Pitch :: float(), Yaw :: float()}.
command(Roll, Pitch, Turn) -> {tilt(Roll), tilt(Pitch), Turn / ?TURN * ?COMMAND_OF_TURN}.

tilt(Tenths) -> Tenths / ?TILT * ?COMMAND_OF_TILT.

%% @doc What a pilot asks for, in the simulator's commands of -1..1; and a simple pilot that holds a
%% position.
-module(copter_pilot).

-export([command/3, limits/0]).
-export([start/0, hold/3]).
-export_type([tilt/0, turn/0, pilot/0]).

%% Tenths of a degree, and of a degree per second.
-type tilt() :: -150..150.
-type turn() :: -900..900.
%% The integrals of the position's error, m s.
-type pilot() :: {X :: float(), Y :: float()}.

-define(TILT, 150).
-define(TURN, 900).
%% A lasting command of this much tilts by 15 degrees at steps of 5 ms, and turns by 90 degrees/s.
-define(COMMAND_OF_TILT, 0.609).
-define(COMMAND_OF_TURN, 0.6).

%% Of the position hold: 1/s^2, 1/s^3, 1/s; and the integral's limit, m s.
-define(P, 1.2).
-define(I, 0.1).
-define(D, 1.6).
-define(I_LIMIT, 1.0).
-define(GRAVITY, 9.82).

%% @doc The largest tilt and turn that a pilot asks for.
-spec limits() -> {tilt(), turn()}.
limits() -> {?TILT, ?TURN}.

%% @doc The simulator's command for attitudes in tenths of degrees, and a yaw rate.
-spec command(tilt(), tilt(), turn()) -> {Roll :: float(), Pitch :: float(), Yaw :: float()}.
command(Roll, Pitch, Turn) -> {tilt(Roll), tilt(Pitch), Turn / ?TURN * ?COMMAND_OF_TURN}.

tilt(Tenths) -> Tenths / ?TILT * ?COMMAND_OF_TILT.

%% @doc A pilot who begins.
-spec start() -> pilot().
start() -> {0.0, 0.0}.

%% @doc PID towards the origin, for a copter that looks along x: roll accelerates along x, pitch
%% against y.
-spec hold(copter_sut:state(), Seconds :: float(), pilot()) ->
    {{Roll :: float(), Pitch :: float()}, pilot()}.
hold(#{px := X, py := Y, vx := Vx, vy := Vy}, Seconds, {Ix, Iy}) ->
    NextX = limited(Ix + X * Seconds, ?I_LIMIT),
    NextY = limited(Iy + Y * Seconds, ?I_LIMIT),
    Roll = of_acceleration(-?P * X - ?I * NextX - ?D * Vx),
    Pitch = -of_acceleration(-?P * Y - ?I * NextY - ?D * Vy),
    {{Roll, Pitch}, {NextX, NextY}}.

of_acceleration(MetresPerS2) ->
    Degrees = math:atan(MetresPerS2 / ?GRAVITY) * 180 / math:pi(),
    limited(Degrees * 10 / ?TILT * ?COMMAND_OF_TILT, ?COMMAND_OF_TILT).

limited(Value, Limit) -> max(-Limit, min(Limit, Value)).

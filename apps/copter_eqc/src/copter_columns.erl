%% @doc All copters at one moment, by few calls: the columns of the simulator as they stand in
%% memory, made into the objects of a frame (docs/visualizer.md).
-module(copter_columns).

-export([objects/2, real/1, radians/1]).
-export_type([marks/0, comfort/0]).

%% Which copters have a flag, ascending.
-type marks() :: #{
    collided := [replay_source:id()],
    faulted := [replay_source:id()],
    manual := [replay_source:id()]
}.
%% m, radius of a copter's comfort zone
-type comfort() :: fun((replay_source:id()) -> number()).

-define(COLLIDED, 1).
-define(AVOIDING, 2).
-define(FAULTED, 4).
-define(MANUAL, 16).
-define(COPTER, 0).
-define(RADIANS, 0.017453292519943295).
%% A lasting command of so much tilts by so many degrees (copter_pilot).
-define(COMMAND_OF_TILT, 0.609).
-define(TILT, 15.0).

%% @doc The copters of the calling process's simulation, in ascending order of id.
-spec objects(marks(), comfort()) -> [replay_source:object()].
objects(Marks, Comfort) ->
    #{lib := Lib} = Sut = copter_sut:instance(),
    case view('CSIM_TRUE', Sut) of
        #{count := 0} ->
            [];
        #{count := Count, id := Ids, override_active := Active} = View ->
            Perceived = view('CSIM_PERCEIVED', Sut),
            Read = fun(Name, From) -> cb:read_bytes(Lib, maps:get(Name, From), 8 * Count) end,
            Id = cb:read_bytes(Lib, Ids, 4 * Count),
            Override = cb:read_bytes(Lib, Active, Count),
            Names = [px, py, pz, vx, vy, roll, pitch, yaw, set_roll, set_pitch],
            True = [Read(N, View) || N <- Names],
            Believed = [Read(N, Perceived) || N <- [px, py, pz, vx, vy]],
            rows(Id, Override, True ++ Believed, {Marks, Comfort})
    end.

view(Which, #{lib := Lib, sim := Sim, columns := Buffer}) ->
    0 = cb:call(Lib, csim_columns, [Sim, Which, Buffer]),
    [View] = cb:read(Lib, Buffer, 1),
    View.

%% All columns at once; those with a value that is not finite go the slower way.
rows(Ids, Active, [Px, Py, Pz, Vx, Vy, R, P, Y, Sr, Sp, Ex, Ey, Ez, Ew, Ev] = Columns, Given) ->
    try
        rows(Ids, Active, Px, Py, Pz, Vx, Vy, R, P, Y, Sr, Sp, Ex, Ey, Ez, Ew, Ev, Given)
    catch
        error:function_clause ->
            Lists = [[real(Bits) || <<Bits:8/binary>> <= Column] || Column <- Columns],
            slow_rows(Ids, Active, Lists, Given)
    end.

rows(<<>>, <<>>, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _) ->
    [];
rows(
    <<Id:32/signed-native, Ids/binary>>, <<Active, Actives/binary>>,
    <<Px:64/float-native, Pxs/binary>>, <<Py:64/float-native, Pys/binary>>,
    <<Pz:64/float-native, Pzs/binary>>, <<Vx:64/float-native, Vxs/binary>>,
    <<Vy:64/float-native, Vys/binary>>, <<R:64/float-native, Rs/binary>>,
    <<P:64/float-native, Ps/binary>>, <<Y:64/float-native, Ys/binary>>,
    <<Sr:64/float-native, Srs/binary>>, <<Sp:64/float-native, Sps/binary>>,
    <<Ex:64/float-native, Exs/binary>>, <<Ey:64/float-native, Eys/binary>>,
    <<Ez:64/float-native, Ezs/binary>>, <<Ew:64/float-native, Ews/binary>>,
    <<Ev:64/float-native, Evs/binary>>, {Marks, Comfort}
) ->
    {Flags, Left} = flags(Id, Active, Marks),
    [
        object(Id, Flags, Comfort(Id), [Px, Py, Pz, Vx, Vy, R, P, Y, Sr, Sp, Ex, Ey, Ez, Ew, Ev])
        | rows(Ids, Actives, Pxs, Pys, Pzs, Vxs, Vys, Rs, Ps, Ys, Srs, Sps, Exs, Eys, Ezs, Ews,
               Evs, {Left, Comfort})
    ].

slow_rows(<<>>, <<>>, _, _) ->
    [];
slow_rows(<<Id:32/signed-native, Ids/binary>>, <<Active, Actives/binary>>, Columns, Given) ->
    {Marks, Comfort} = Given,
    {Flags, Left} = flags(Id, Active, Marks),
    {Values, Rest} = lists:unzip([{Head, Tail} || [Head | Tail] <- Columns]),
    [
        object(Id, Flags, Comfort(Id), Values)
        | slow_rows(Ids, Actives, Rest, {Left, Comfort})
    ].

%% @doc A number as it stands in memory. Those that are not finite, which a fault can make, have
%% names.
-spec real(binary()) -> replay_lcm:real().
real(<<Value:64/float-native>>) -> Value;
real(<<Bits:64/native>>) -> not_finite(<<Bits:64>>).

not_finite(<<0:1, 16#7FF:11, 0:52>>) -> inf;
not_finite(<<1:1, 16#7FF:11, 0:52>>) -> neg_inf;
not_finite(_) -> nan.

%% Those of one copter; and the marks of the copters after it.
flags(Id, Active, Marks) ->
    flag(Id, manual, ?MANUAL,
         flag(Id, faulted, ?FAULTED,
              flag(Id, collided, ?COLLIDED, {Active * ?AVOIDING, Marks}))).

flag(Id, Key, Flag, {Sum, Marks}) ->
    case Marks of
        #{Key := [Id | Rest]} -> {Sum bor Flag, Marks#{Key := Rest}};
        _ -> {Sum, Marks}
    end.

object(Id, Flags, Comfort, [
    Px, Py, Pz, Vx, Vy, Roll, Pitch, Yaw, SetRoll, SetPitch, EstX, EstY, EstZ, EstVx, EstVy
]) ->
    #{
        id => Id,
        kind => ?COPTER,
        flags => Flags,
        pos => [Px, Py, Pz],
        vel => [Vx, Vy, 0.0],
        yaw => radians(Yaw),
        roll => radians(Roll),
        pitch => radians(Pitch),
        pos_est => [EstX, EstY, EstZ],
        vel_est => [EstVx, EstVy, 0.0],
        comfort => Comfort,
        steer => [tilt(SetRoll), tilt(SetPitch)]
    }.

%% @doc Of degrees.
-spec radians(replay_lcm:real()) -> replay_lcm:real().
radians(Degrees) when is_float(Degrees) -> Degrees * ?RADIANS;
radians(NotFinite) -> NotFinite.

tilt(Command) when is_float(Command) -> radians(Command / ?COMMAND_OF_TILT * ?TILT);
tilt(NotFinite) -> NotFinite.

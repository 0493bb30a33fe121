%% @doc All copters at one moment, by few calls: the columns of the simulator as they stand in
%% memory, made into the objects of a frame (docs/visualizer.md).
-module(copter_columns).

-export([objects/2]).
-export_type([marks/0, comfort/0]).

%% Which copters have a flag, ascending.
-type marks() :: #{
    collided := [replay_source:id()], faulted := [replay_source:id()], manual := [replay_source:id()]
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
            Read = fun(Names, From) -> [reals(Lib, Count, maps:get(N, From)) || N <- Names] end,
            True = Read([px, py, pz, vx, vy, roll, pitch, yaw, set_roll, set_pitch], View),
            Perceived = Read([px, py, pz, vx, vy], view('CSIM_PERCEIVED', Sut)),
            rows(
                cb:read(Lib, Ids, Count),
                binary_to_list(cb:read_bytes(Lib, Active, Count)),
                True ++ Perceived,
                {Marks, Comfort}
            )
    end.

view(Which, #{lib := Lib, sim := Sim, columns := Buffer}) ->
    0 = cb:call(Lib, csim_columns, [Sim, Which, Buffer]),
    [View] = cb:read(Lib, Buffer, 1),
    View.

%% Those that are not finite, which a fault can make, have names.
reals(Lib, Count, Column) ->
    [real(Bits) || <<Bits:8/binary>> <= cb:read_bytes(Lib, Column, 8 * Count)].

real(<<Value:64/float-native>>) -> Value;
real(<<Bits:64/native>>) -> not_finite(<<Bits:64>>).

not_finite(<<0:1, 16#7FF:11, 0:52>>) -> inf;
not_finite(<<1:1, 16#7FF:11, 0:52>>) -> neg_inf;
not_finite(_) -> nan.

rows([], [], _, _) ->
    [];
rows([Id | Ids], [Active | Actives], Columns, {Marks, Comfort}) ->
    {Values, Rest} = heads(Columns),
    {Own, Others} = marks(Id, Marks),
    [
        object(Id, Own bor (Active * ?AVOIDING), Comfort(Id), Values)
        | rows(Ids, Actives, Rest, {Others, Comfort})
    ].

heads(Columns) -> lists:unzip([{Head, Tail} || [Head | Tail] <- Columns]).

%% The marks of one copter; and those of the copters after it.
marks(Id, Marks) ->
    Flags = [{collided, ?COLLIDED}, {faulted, ?FAULTED}, {manual, ?MANUAL}],
    lists:foldl(
        fun({Key, Flag}, {Sum, Left}) ->
            case Left of
                #{Key := [Id | Rest]} -> {Sum + Flag, Left#{Key := Rest}};
                _ -> {Sum, Left}
            end
        end,
        {0, Marks},
        Flags
    ).

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

radians(Degrees) when is_float(Degrees) -> Degrees * ?RADIANS;
radians(NotFinite) -> NotFinite.

tilt(Command) when is_float(Command) -> radians(Command / ?COMMAND_OF_TILT * ?TILT);
tilt(NotFinite) -> NotFinite.

%% @doc Frames by hand: the message that is sent 60 times a second, several times as fast as by the
%% schema. Answers `unusual' for what the general way must judge: anything wrong, and reals that
%% are not finite.
-module(replay_lcm_frame).

-export([encode/1, decode/1]).

-define(OBJECT_BYTES, 78).

%% @doc With the fingerprint.
-spec encode(replay_lcm:message()) -> {ok, binary()} | unusual.
encode(#{t_us := T, run := Run, seq := Seq, objects := Objects}) when
    is_integer(T), T >= -(1 bsl 63), T < 1 bsl 63,
    is_integer(Run), Run >= -(1 bsl 31), Run < 1 bsl 31,
    is_integer(Seq), Seq >= -(1 bsl 31), Seq < 1 bsl 31,
    is_list(Objects)
->
    #{fingerprint := Fingerprint} = replay_lcm_type:struct(frame),
    Head = <<Fingerprint:64, T:64, Run:32, Seq:32, (length(Objects)):32>>,
    try {ok, put_objects(Objects, Head)}
    catch error:_ -> unusual
    end;
encode(_) ->
    unusual.

put_objects([], Bytes) ->
    Bytes;
put_objects([Object | Rest], Bytes) ->
    #{
        id := Id, kind := Kind, flags := Flags,
        pos := [Px, Py, Pz], vel := [Vx, Vy, Vz], yaw := Yaw, roll := Roll, pitch := Pitch,
        pos_est := [Ex, Ey, Ez], vel_est := [Wx, Wy, Wz],
        comfort := Comfort, steer := [S1, S2]
    } = Object,
    true = is_integer(Id) andalso Id >= -(1 bsl 31) andalso Id < 1 bsl 31 andalso
        is_integer(Kind) andalso Kind >= -128 andalso Kind < 128 andalso
        is_integer(Flags) andalso Flags >= -128 andalso Flags < 128,
    put_objects(Rest,
        <<Bytes/binary, Id:32, Kind, Flags,
          Px:32/float, Py:32/float, Pz:32/float, Vx:32/float, Vy:32/float, Vz:32/float,
          Yaw:32/float, Roll:32/float, Pitch:32/float,
          Ex:32/float, Ey:32/float, Ez:32/float, Wx:32/float, Wy:32/float, Wz:32/float,
          Comfort:32/float, S1:32/float, S2:32/float>>).

%% @doc What follows the fingerprint.
-spec decode(binary()) -> {ok, replay_lcm:message()} | unusual.
decode(<<T:64/signed, Run:32/signed, Seq:32/signed, N:32/signed, Body/binary>>) when
    byte_size(Body) =:= N * ?OBJECT_BYTES
->
    case get_objects(Body, []) of
        unusual -> unusual;
        Objects -> {ok, #{t_us => T, run => Run, seq => Seq, n => N, objects => Objects}}
    end;
decode(_) ->
    unusual.

get_objects(
    <<Id:32/signed, Kind:8/signed, Flags:8/signed,
      Px:32/float, Py:32/float, Pz:32/float, Vx:32/float, Vy:32/float, Vz:32/float,
      Yaw:32/float, Roll:32/float, Pitch:32/float,
      Ex:32/float, Ey:32/float, Ez:32/float, Wx:32/float, Wy:32/float, Wz:32/float,
      Comfort:32/float, S1:32/float, S2:32/float, Rest/binary>>,
    Objects
) ->
    Object = #{
        id => Id, kind => Kind, flags => Flags,
        pos => [Px, Py, Pz], vel => [Vx, Vy, Vz], yaw => Yaw, roll => Roll, pitch => Pitch,
        pos_est => [Ex, Ey, Ez], vel_est => [Wx, Wy, Wz],
        comfort => Comfort, steer => [S1, S2]
    },
    get_objects(Rest, [Object | Objects]);
get_objects(<<>>, Objects) ->
    lists:reverse(Objects);
get_objects(_, _) ->
    unusual.

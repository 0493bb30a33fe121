%% @doc A recording as CSV (RFC 4180): a line for each frame and object, with the curves of the page
%% as further columns. Numbers have a point and at most six decimals; a field is empty where there
%% is nothing to tell.
-module(replay_csv).

-export([format/1]).

%% @doc The lines, the header first: names with units.
-spec format(replay_flight:flight()) -> iodata().
format(#{frames := Frames}) ->
    [
        record([Name || {Name, _} <- columns()])
        | [
            record([field(Value(Object, Frame)) || {_, Value} <- columns()])
         || #{objects := Objects} = Frame <- Frames, Object <- Objects
        ]
    ].

%% Positions are east, north, up; angles counter-clockwise from east.
columns() ->
    [
        {"t_s", fun(_, #{t_us := T}) -> {decimals, T, 1000000} end},
        {"object", fun(#{id := Id}, _) -> Id end},
        {"x_m", part(pos, 1)}, {"y_m", part(pos, 2)}, {"z_m", part(pos, 3)},
        {"vx_m_s", part(vel, 1)}, {"vy_m_s", part(vel, 2)}, {"vz_m_s", part(vel, 3)},
        {"yaw_rad", value(yaw)}, {"roll_rad", value(roll)}, {"pitch_rad", value(pitch)},
        {"x_est_m", part(pos_est, 1)}, {"y_est_m", part(pos_est, 2)}, {"z_est_m", part(pos_est, 3)},
        {"vx_est_m_s", part(vel_est, 1)}, {"vy_est_m_s", part(vel_est, 2)},
        {"vz_est_m_s", part(vel_est, 3)},
        {"steer_roll_rad", part(steer, 1)}, {"steer_pitch_rad", part(steer, 2)},
        {"collided", flag(1)}, {"avoiding", flag(2)}, {"faulted", flag(4)}, {"stale", flag(8)},
        {"by_hand", flag(16)},
        {"comfort_m", value(comfort)},
        {"position_error_m", fun(O, _) -> replay_flight:position_error(O) end},
        {"velocity_error_m_s", fun(O, _) -> replay_flight:velocity_error(O) end},
        {"nearest_object", fun(O, F) -> nearest(1, O, F) end},
        {"nearest_m", fun(O, F) -> nearest(2, O, F) end}
    ].

part(Key, N) -> fun(Object, _) -> lists:nth(N, maps:get(Key, Object)) end.

value(Key) -> fun(Object, _) -> maps:get(Key, Object) end.

flag(Bit) -> fun(#{flags := Flags}, _) -> min(1, Flags band Bit) end.

nearest(Which, Object, #{objects := Objects}) ->
    case replay_flight:nearest(Object, Objects) of
        none -> none;
        Nearest -> element(Which, Nearest)
    end.

field({decimals, N, Of}) -> float_to_binary(N / Of, [{decimals, 6}]);
field(N) when is_integer(N) -> integer_to_binary(N);
field(F) when is_float(F) -> float_to_binary(F, [{decimals, 6}, compact]);
field(_) -> "".

record(Fields) -> [lists:join($,, Fields), "\r\n"].

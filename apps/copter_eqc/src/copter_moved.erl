%% @doc The same flight in a world that was turned by quarters and shifted.
-module(copter_moved).

-export([difference/3]).

%% @doc The largest difference between the states at the end of a sequence, and of the same
%% sequence in the moved world, turned back: m, m/s and degrees alike. infinity when one of them
%% ended with a collision and the other did not.
-spec difference(copter_options:options(), [faultcheck_generator:command()], copter_world:move()) ->
    float() | infinity.
difference(#{world := World} = Options, Commands, Move) ->
    Here = copter_trial:rerun(Options, Commands),
    Still = states(),
    There = moved(Options#{world := {moved, World, Move}}, Commands, Move),
    case ended(Here) =:= ended(There) of
        true -> lists:max([0.0 | differences(Move, Still, states())]);
        false -> infinity
    end.

ended(safe) -> safe;
ended({collision, #{kind := Kind, ids := Ids}}) -> {Kind, Ids}.

states() ->
    Ids = copter_sut:copters(),
    [{View, Id, copter_sut:state(Id, View)} || View <- [true, perceived], Id <- Ids].

%% Copters are added where they are in the moved world, and look the way that it was turned.
moved(Options, Commands, {_, _, Turns} = Move) ->
    ok = copter_eqc:begin_test(Options),
    {Copters, Rest} = lists:splitwith(
        fun({set, _, {call, _, Name, _}}) -> Name =:= add_copter end, Commands
    ),
    [
        begin
            {MovedX, MovedY} = copter_world:move(Move, {X / 100, Y / 100}),
            ok = copter_sut:add_copter(Id, MovedX, MovedY, yaw(90.0 * Turns))
        end
     || {set, _, {call, _, _, [Id, X, Y]}} <- Copters
    ],
    copter_trial:continue(Rest).

yaw(Degrees) when Degrees > 180.0 -> Degrees - 360.0;
yaw(Degrees) -> Degrees.

differences(Move, Still, Moved) ->
    lists:append([
        apart(Move, Here, There)
     || {{View, Id, Here}, {View, Id, There}} <- lists:zip(Still, Moved)
    ]).

apart({_, _, Turns} = Move, Here, There) ->
    #{px := X, py := Y, vx := Vx, vy := Vy, yaw := Yaw} = Here,
    {WantedX, WantedY} = copter_world:move(Move, {X, Y}),
    {WantedVx, WantedVy} = copter_world:move({0.0, 0.0, Turns}, {Vx, Vy}),
    Turned = maps:get(yaw, There) - Yaw - 90.0 * Turns,
    Of = fun(Name, Wanted) -> abs(maps:get(Name, There) - Wanted) end,
    Same = [abs(maps:get(N, There) - maps:get(N, Here)) || N <- [pz, roll, pitch, e_r, e_p]],
    Moves = [Of(px, WantedX), Of(py, WantedY), Of(vx, WantedVx), Of(vy, WantedVy)],
    [off_circle(Turned) | Moves] ++ Same.

%% From a whole number of turns, degrees.
off_circle(Degrees) -> abs(Degrees - 360.0 * round(Degrees / 360.0)).

%% @doc What copters of the calling process's simulation know of what is around them: comfort zones,
%% risk contours, measured ranges; as the visualizer's messages say it (docs/visualizer.md).
-module(copter_surroundings).

-export([comfort/0, risk/3, ranges/1]).

-define(RADIANS, 0.017453292519943295).
-define(NO_SPACE, -5).
-define(NO_ID, -3).
%% Not less than the structures have.
-define(ENTRY_BYTES, 96).
-define(RANGE_BYTES, 40).
%% Entries that are asked for at first.
-define(ROOM, 64).

%% @doc The radius of each copter's comfort zone, m: the same for all unless it follows the
%% position's error.
-spec comfort() -> copter_columns:comfort().
comfort() ->
    case copter_sut:value_of(comfort_error_gain) == 0 of
        true ->
            Radius = copter_sut:value_of(comfort_radius),
            fun(_) -> Radius end;
        false ->
            fun(Id) ->
                [#{along := Radius} | _] = first(csim_ldm, csim_ldm_entry, ?ENTRY_BYTES, Id, 1),
                Radius
            end
    end.

%% @doc The contours that a copter reckons with; Lines are the ids of the world's, in its order.
-spec risk(replay_source:id(), replay_source:t_us(), [non_neg_integer()]) ->
    [replay_source:ellipse()].
risk(Id, Now, Lines) ->
    Places = maps:from_list(lists:zip(Lines, lists:seq(0, length(Lines) - 1))),
    [
        ellipse(Entry, Now, Places)
     || #{kind := Kind} = Entry <- all(csim_ldm, csim_ldm_entry, ?ENTRY_BYTES, Id),
        Kind =/= 'CSIM_ENTRY_COMFORT'
    ].

ellipse(#{kind := Kind, id := Id, stamp_us := Stamp} = Entry, Now, Places) ->
    #{cx := X, cy := Y, along := Along, across := Across, angle := Angle} = Entry,
    Of =
        case Kind of
            'CSIM_ENTRY_LINE' -> #{about => maps:get(Id, Places), kind => 1, age => 0.0};
            'CSIM_ENTRY_COPTER' -> #{about => Id, kind => 0, age => (Now - Stamp) / 1.0e6}
        end,
    Of#{
        overlap => flag(maps:get(overlap, Entry)),
        x => X,
        y => Y,
        rx => Along,
        ry => Across,
        theta => radians(Angle)
    }.

%% @doc The latest distance that a copter measured to each anchor.
-spec ranges(replay_source:id()) -> [replay_source:range()].
ranges(Id) ->
    [
        #{anchor => Anchor, measured => Measured, expected => Expected, used => flag(Used)}
     || #{anchor := Anchor, measured := Measured, expected := Expected, used := Used} <-
            all(csim_ranges, csim_range, ?RANGE_BYTES, Id)
    ].

radians(Degrees) when is_float(Degrees) -> Degrees * ?RADIANS;
radians(NotFinite) -> NotFinite.

flag(true) -> 1;
flag(false) -> 0.

%% Of a copter that there is not: nothing.
all(Function, Type, Bytes, Id) -> first(Function, Type, Bytes, Id, none).

%% The first ones, or all when Most is none.
first(Function, Type, Bytes, Id, Most) ->
    #{lib := Lib} = copter_sut:instance(),
    Room =
        case Most of
            none -> ?ROOM;
            _ -> Most
        end,
    read(Function, {Lib, Type, Bytes}, Id, Room, Most).

read(Function, {Lib, Type, Bytes} = Kind, Id, Room, Most) ->
    {ptr, _, At} = Array = cb:create_array(Lib, 'unsigned char', binary:copy(<<0>>, Bytes * Room)),
    try called(Function, Lib, Id, {ptr, Type, At}, Room) of
        {?NO_SPACE, Count} when Most =:= none -> read(Function, Kind, Id, Count, Most);
        {?NO_ID, _} -> [];
        {_, Count} -> cb:read(Lib, {ptr, Type, At}, min(Count, Room))
    after
        cb:free(Lib, Array)
    end.

called(Function, Lib, Id, Buffer, Room) ->
    #{sim := Sim, count := Count} = copter_sut:instance(),
    ok = cb:set(Lib, [Count, 0], Room),
    Code = cb:call(Lib, Function, [Sim, Id, Buffer, Count]),
    [Given] = cb:read(Lib, Count, 1),
    {Code, Given}.

%% @doc What copters of the calling process's simulation know of what is around them: comfort zones,
%% risk contours, measured ranges; as the visualizer's messages say it (docs/visualizer.md).
-module(copter_surroundings).

-export([comfort/0, risk/3, ranges/1]).

%% csim_entry_kind
-define(ENTRY_COPTER, 0).
-define(ENTRY_LINE, 1).
-define(ENTRY_COMFORT, 2).
-define(NO_SPACE, -5).
-define(NO_ID, -3).
%% The sizes of the structures.
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
                [{?ENTRY_COMFORT, _, _, _, _, Radius, _, _, _} | _] = entries(Id, 1),
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
     || Entry <- entries(Id, none), element(1, Entry) =/= ?ENTRY_COMFORT
    ].

ellipse({Kind, Id, Stamp, X, Y, Along, Across, Angle, Overlap}, Now, Places) ->
    {About, Age} =
        case Kind of
            ?ENTRY_LINE -> {maps:get(Id, Places), 0.0};
            ?ENTRY_COPTER -> {Id, (Now - Stamp) / 1.0e6}
        end,
    #{
        about => About,
        kind => Kind,
        overlap => Overlap,
        x => X,
        y => Y,
        rx => Along,
        ry => Across,
        theta => copter_columns:radians(Angle),
        age => Age
    }.

%% As they stand in memory: csim_ldm_entry.
entries(Id, Most) ->
    Bytes = first(csim_ldm, ?ENTRY_BYTES, Id, Most),
    [
        entry(Entry)
     || <<Entry:?ENTRY_BYTES/binary>> <= Bytes
    ].

entry(<<
    Kind:32/native, Id:32/signed-native, Stamp:64/native, _Place:16/binary, _Speed:16/binary,
    X:64/float-native, Y:64/float-native, Along:64/float-native, Across:64/float-native,
    Angle:64/float-native, Overlap, _/binary
>>) ->
    {Kind, Id, Stamp, X, Y, Along, Across, Angle, Overlap};
entry(<<
    Kind:32/native, Id:32/signed-native, Stamp:64/native, _Place:16/binary, _Speed:16/binary,
    X:8/binary, Y:8/binary, Along:8/binary, Across:8/binary, Angle:8/binary, Overlap, _/binary
>>) ->
    [Rx, Ry, Ra, Rb, Rt] = [copter_columns:real(B) || B <- [X, Y, Along, Across, Angle]],
    {Kind, Id, Stamp, Rx, Ry, Ra, Rb, Rt, Overlap}.

%% @doc The latest distance that a copter measured to each anchor.
-spec ranges(replay_source:id()) -> [replay_source:range()].
ranges(Id) ->
    [
        #{
            anchor => Anchor,
            measured => copter_columns:real(Measured),
            expected => copter_columns:real(Expected),
            used => Used
        }
     || <<Anchor:32/signed-native, _:32, Measured:8/binary, Expected:8/binary, Used, _:7/binary,
          _Time:8/binary>> <= first(csim_ranges, ?RANGE_BYTES, Id, none)
    ].

%% The bytes of the first ones, or of all when Most is none; nothing of a copter that there is not.
first(Function, Bytes, Id, Most) ->
    #{lib := Lib} = copter_sut:instance(),
    Room =
        case Most of
            none -> ?ROOM;
            _ -> Most
        end,
    read(Function, {Lib, Bytes}, Id, Room, Most).

read(Function, {Lib, Bytes} = Kind, Id, Room, Most) ->
    Array = cb:create_array(Lib, 'unsigned char', binary:copy(<<0>>, Bytes * Room)),
    try called(Function, Lib, Id, Array, Room) of
        {?NO_SPACE, Count} when Most =:= none -> read(Function, Kind, Id, Count, Most);
        {?NO_ID, _} -> <<>>;
        {_, Count} -> cb:read_bytes(Lib, Array, Bytes * min(Count, Room))
    after
        cb:free(Lib, Array)
    end.

called(Function, Lib, Id, {ptr, _, At}, Room) ->
    #{sim := Sim, count := Count} = copter_sut:instance(),
    Type = maps:get(Function, #{csim_ldm => csim_ldm_entry, csim_ranges => csim_range}),
    ok = cb:set(Lib, [Count, 0], Room),
    Code = cb:call(Lib, Function, [Sim, Id, {ptr, Type, At}, Count]),
    [Given] = cb:read(Lib, Count, 1),
    {Code, Given}.

%% @doc A recording as the messages that Foxglove, Lichtblick and Rerun draw: JSON by their
%% well-known schemas, and plain numbers for curves (replay_mcap writes them).
%%
%% One frame of reference, `world': x east, y north, z up, metres.
-module(replay_foxglove).

-export([content/1]).

%% Ids of schemas, and of the channels that do not belong to one object.
-define(POSES, 1).
-define(SCENE, 2).
-define(LOG, 3).
-define(NUMBER, 4).
-define(TRUE, 1).
-define(PERCEIVED, 2).
-define(WORLD, 3).
-define(OBJECTS, 4).
-define(EVENTS, 5).
-define(FIRST_CURVE, 10).

-define(FRAME_ID, <<"world">>).
-define(SCENE_US, 50000).

%% @doc What goes into the file.
-spec content(replay_flight:flight()) -> replay_mcap:content().
content(#{frames := Frames} = Flight) ->
    Curves = curves(Frames),
    Channels = maps:from_list([{{Of, Name}, Id} || {Id, Of, Name} <- Curves]),
    #{
        schemas => [{Id, Name, faultcheck_json:encode(S)} || {Id, Name, S} <- schemas()],
        channels => [
            {?TRUE, ?POSES, <<"/poses">>},
            {?PERCEIVED, ?POSES, <<"/poses_perceived">>},
            {?WORLD, ?SCENE, <<"/world">>},
            {?OBJECTS, ?SCENE, <<"/scene">>},
            {?EVENTS, ?LOG, <<"/log">>}
            | [{Id, ?NUMBER, topic(Of, Name)} || {Id, Of, Name} <- Curves]
        ],
        messages => lists:keysort(2, messages(Flight, Channels))
    }.

%% Each object that is ever there has its curves.
curves(Frames) ->
    Ids = lists:usort([Id || #{objects := Objects} <- Frames, #{id := Id} <- Objects]),
    All = [{Id, Name} || Id <- Ids, {Name, _} <- quantities()],
    [
        {N, Id, Name}
     || {N, {Id, Name}} <- lists:zip(lists:seq(?FIRST_CURVE, ?FIRST_CURVE + length(All) - 1), All)
    ].

quantities() ->
    [
        {position_error, fun(Object, _) -> replay_flight:position_error(Object) end},
        {velocity_error, fun(Object, _) -> replay_flight:velocity_error(Object) end},
        {comfort, fun(#{comfort := Comfort}, _) -> Comfort end},
        {nearest, fun nearest/2}
    ].

nearest(Object, Objects) ->
    case replay_flight:nearest(Object, Objects) of
        none -> none;
        {_, Distance} -> Distance
    end.

topic(Id, Name) -> iolist_to_binary(io_lib:format("/objects/~b/~s", [Id, Name])).

messages(#{frames := Frames, risks := Risks, events := Events, worlds := Worlds}, Channels) ->
    lists:append([
        [message(?WORLD, T, scene(T, world(World))) || {T, World} <- Worlds],
        lists:append([frame(Frame, Channels) || Frame <- Frames]),
        [
            message(?OBJECTS, T, scene(T, [comfort(Objects)]))
         || #{t_us := T, objects := Objects} <- thinned(Frames)
        ],
        [message(?OBJECTS, T, scene(T, [risk(Risk)])) || #{t_us := T} = Risk <- thinned(Risks)],
        [message(?EVENTS, T, log(Event)) || #{t_us := T} = Event <- Events]
    ]).

%% Scenes are large: the first of each slot, and the last of all.
thinned([]) ->
    [];
thinned(Messages) ->
    Slots = [{T div ?SCENE_US, Message} || #{t_us := T} = Message <- Messages],
    Firsts = [Message || {_, Message} <- lists:ukeysort(1, Slots)],
    Last = lists:last(Messages),
    Firsts ++ [Last || lists:last(Firsts) =/= Last].

message(Channel, T, Json) -> {Channel, 1000 * T, faultcheck_json:encode(Json)}.

frame(#{t_us := T, objects := Objects}, Channels) ->
    Values = [
        {Id, Name, Value(Object, Objects)}
     || #{id := Id} = Object <- Objects, {Name, Value} <- quantities()
    ],
    [
        message(?TRUE, T, poses(T, [pose(O, pos) || O <- Objects])),
        message(?PERCEIVED, T, poses(T, [pose(O, pos_est) || O <- Objects]))
        | [
            message(maps:get({Id, Name}, Channels), T, #{value => real(Value)})
         || {Id, Name, Value} <- Values, is_float(Value)
        ]
    ].

poses(T, Poses) -> #{timestamp => time(T), frame_id => ?FRAME_ID, poses => Poses}.

log(#{t_us := T, kind := Kind, text := Text}) ->
    #{
        timestamp => time(T), level => level(Kind), message => Text, name => Kind, file => <<>>,
        line => 0
    }.

%% Of foxglove.Log: 2 information, 3 warning, 4 error.
level(<<"fault">>) -> 3;
level(<<"collision">>) -> 4;
level(_) -> 2.

%% ---- scenes -----------------------------------------------------------------------------------

scene(T, Entities) ->
    #{deletions => [], entities => [Entity#{timestamp => time(T)} || Entity <- Entities]}.

%% What does not move: lines, anchors, areas.
world(#{seg := Segments, anchors := Anchors, polys := Polys}) ->
    [
        entity(<<"terrain">>, #{lines => [
            line([[X1, Y1, 0.0], [X2, Y2, 0.0]], 0, 0.08, [0.35, 0.39, 0.46])
         || [X1, Y1, X2, Y2] <- Segments
        ]}),
        entity(<<"anchors">>, #{
            cubes => [
                #{pose => placed(Pos, 0.0), size => vector([0.2, 0.2, 0.2]),
                  color => colour([0.0, 0.6, 0.42], 1.0)}
             || #{pos := Pos} <- Anchors
            ],
            texts => [
                label(above(Pos, 0.3), io_lib:format("anchor ~b", [Id]))
             || #{id := Id, pos := Pos} <- Anchors
            ]
        })
        | [
            entity(<<"area ", Name/binary>>, #{lines => [line(Points, 1, 0.05, role(Role))]})
         || #{name := Name, role := Role, pt := Points} <- Polys
        ]
    ].

role(0) -> [0.1, 0.55, 0.3];
role(1) -> [0.75, 0.1, 0.15];
role(2) -> [0.1, 0.4, 0.75];
role(_) -> [0.6, 0.45, 0.0].

comfort(Objects) ->
    entity(<<"objects">>, #{
        cylinders => [
            cylinder(Pos, [2 * Comfort, 2 * Comfort, 0.02], 0.0, zone(Flags))
         || #{pos := Pos, comfort := Comfort, flags := Flags} <- Objects, is_float(Comfort)
        ],
        texts => [
            label(above(Pos, 0.4), integer_to_list(Id)) || #{id := Id, pos := Pos} <- Objects
        ]
    }).

%% Collided, avoiding, or neither.
zone(Flags) when Flags band 1 =/= 0 -> [0.75, 0.1, 0.15];
zone(Flags) when Flags band 2 =/= 0 -> [0.85, 0.45, 0.0];
zone(_) -> [0.1, 0.4, 0.75].

risk(#{ellipses := Ellipses}) ->
    entity(<<"risk">>, #{
        cylinders => [
            cylinder([X, Y, 0.0], [2 * Rx, 2 * Ry, 0.02], Theta, overlap(Overlap))
         || #{x := X, y := Y, rx := Rx, ry := Ry, theta := Theta, overlap := Overlap} <- Ellipses,
            lists:all(fun is_float/1, [X, Y, Rx, Ry, Theta])
        ]
    }).

overlap(0) -> [0.9, 0.75, 0.25];
overlap(_) -> [0.85, 0.2, 0.25].

%% An entity stays until the next one of its name.
entity(Id, Parts) ->
    Empty = maps:from_list([
        {Kind, []}
     || Kind <- [arrows, cubes, spheres, cylinders, lines, triangles, texts, models, metadata]
    ]),
    maps:merge(Empty, Parts#{
        frame_id => ?FRAME_ID, id => Id, lifetime => time(0),
        frame_locked => false
    }).

line(Points, Type, Thickness, Colour) ->
    #{
        type => Type, pose => placed([0.0, 0.0, 0.0], 0.0), thickness => Thickness,
        scale_invariant => false, points => [vector(P) || P <- Points],
        color => colour(Colour, 1.0), colors => [], indices => []
    }.

cylinder(Pos, Size, Yaw, Colour) ->
    #{
        pose => placed(Pos, Yaw), size => vector(Size), bottom_scale => 1.0, top_scale => 1.0,
        color => colour(Colour, 0.3)
    }.

label(Pos, Text) ->
    #{
        pose => placed(Pos, 0.0), billboard => true, font_size => 0.3, scale_invariant => false,
        color => colour([0.5, 0.5, 0.5], 1.0), text => iolist_to_binary(Text)
    }.

above([X, Y, Z], Metres) -> [X, Y, sum(Z, Metres)].

sum(Z, Metres) when is_float(Z) -> Z + Metres;
sum(Z, _) -> Z.

%% ---- parts of messages ------------------------------------------------------------------------

time(Us) -> #{sec => Us div 1000000, nsec => Us rem 1000000 * 1000}.

pose(#{yaw := Yaw, pitch := Pitch, roll := Roll} = Object, Which) ->
    #{position => vector(maps:get(Which, Object)), orientation => turned(Yaw, Pitch, Roll)}.

placed(Pos, Yaw) -> #{position => vector(Pos), orientation => turned(Yaw, 0.0, 0.0)}.

vector([X, Y, Z]) -> #{x => real(X), y => real(Y), z => real(Z)}.

%% Roll about the x axis, then pitch about y, then yaw about z.
turned(Yaw, Pitch, Roll) when is_float(Yaw), is_float(Pitch), is_float(Roll) ->
    [{CY, SY}, {CP, SP}, {CR, SR}] =
        [{math:cos(A / 2), math:sin(A / 2)} || A <- [Yaw, Pitch, Roll]],
    #{
        w => real(CR * CP * CY + SR * SP * SY),
        x => real(SR * CP * CY - CR * SP * SY),
        y => real(CR * SP * CY + SR * CP * SY),
        z => real(CR * CP * SY - SR * SP * CY)
    };
turned(_, _, _) ->
    turned(0.0, 0.0, 0.0).

colour([R, G, B], Alpha) -> #{r => R, g => G, b => B, a => Alpha}.

%% Micrometres are enough. JSON has nothing for what is no number.
real(Value) when is_float(Value), abs(Value) < 1.0e9 -> round(Value * 1.0e6) / 1.0e6;
real(Value) when is_number(Value) -> Value;
real(_) -> null.

%% ---- schemas ----------------------------------------------------------------------------------

schemas() ->
    [
        {?POSES, <<"foxglove.PosesInFrame">>, object([
            {timestamp, moment()}, {frame_id, string}, {poses, {list, pose_schema()}}
        ])},
        {?SCENE, <<"foxglove.SceneUpdate">>, object([
            {deletions, {list, object([{timestamp, moment()}, {type, integer}, {id, string}])}},
            {entities, {list, entity_schema()}}
        ])},
        {?LOG, <<"foxglove.Log">>, object([
            {timestamp, moment()}, {level, integer}, {message, string}, {name, string},
            {file, string}, {line, integer}
        ])},
        {?NUMBER, <<"viz.Number">>, object([{value, number}])}
    ].

object(Members) ->
    #{
        type => object,
        properties => {object, [{Name, typed(Type)} || {Name, Type} <- Members]}
    }.

typed(Type) when is_atom(Type) -> #{type => Type};
typed({list, Type}) -> #{type => array, items => typed(Type)};
typed(Schema) when is_map(Schema) -> Schema.

moment() -> object([{sec, integer}, {nsec, integer}]).

vector_schema() -> object([{x, number}, {y, number}, {z, number}]).

pose_schema() ->
    Turn = object([{x, number}, {y, number}, {z, number}, {w, number}]),
    object([{position, vector_schema()}, {orientation, Turn}]).

colour_schema() -> object([{r, number}, {g, number}, {b, number}, {a, number}]).

entity_schema() ->
    Solid = [{pose, pose_schema()}, {size, vector_schema()}, {color, colour_schema()}],
    Line = [
        {type, integer}, {pose, pose_schema()}, {thickness, number}, {scale_invariant, boolean},
        {points, {list, vector_schema()}}, {color, colour_schema()},
        {colors, {list, colour_schema()}}, {indices, {list, integer}}
    ],
    Text = [
        {pose, pose_schema()}, {billboard, boolean}, {font_size, number},
        {scale_invariant, boolean}, {color, colour_schema()}, {text, string}
    ],
    object([
        {timestamp, moment()}, {frame_id, string}, {id, string}, {lifetime, moment()},
        {frame_locked, boolean},
        {metadata, {list, object([{key, string}, {value, string}])}},
        {cubes, {list, object(Solid)}},
        {cylinders, {list, object(Solid ++ [{bottom_scale, number}, {top_scale, number}])}},
        {lines, {list, object(Line)}},
        {texts, {list, object(Text)}}
        | [{Kind, {list, object([])}} || Kind <- [arrows, spheres, triangles, models]]
    ]).

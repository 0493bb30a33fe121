%% @doc The map of a recording at one moment as an SVG picture that stands alone: terrain, anchors,
%% areas, what the observer reckons with, each object with its zone, its way so far and where it
%% believes itself to be.
%%
%% Colour is never the only sign: collided objects have a cross and a ring, faulted ones the word,
%% contours that reach into the zone a thick outline.
-module(replay_map).

-export([svg/2]).

-define(WIDTH, 960).
-define(MARGIN, 24).
-define(HEAD, 44).
%% m of room around everything
-define(ROOM, 1.0).
%% s of the way that is shown
-define(TRAIL_US, 10000000).

%% Metres to user units; y points down in pictures.
-record(view, {left :: float(), top :: float(), scale :: float()}).

%% @doc The picture at a time, or the nearest frame before it.
-spec svg(replay_source:t_us(), replay_flight:flight()) -> iodata().
svg(T, #{frames := Frames, risks := Risks} = Flight) ->
    #{objects := Objects, t_us := At} = replay_flight:at(T, Frames),
    World = replay_flight:world_at(At, Flight),
    {View, Height} = view(World, Frames),
    Risk = [R || [_ | _] <- [Risks], R <- [replay_flight:at(At, Risks)]],
    document(title(At, Flight), Height, [
        terrain(World, View),
        [contours(R, View) || R <- Risk],
        [trail(Object, At, Frames, View) || Object <- Objects],
        [object(Object, View) || Object <- Objects],
        scale_bar(View, Height)
    ]).

title(At, #{'case' := Case}) ->
    Name =
        case Case of
            #{case_id := Id} -> Id;
            none -> <<"recording">>
        end,
    [Name, io_lib:format(", t = ~.3f s", [At / 1000000])].

%% All that is ever shown has room.
view(#{seg := Segments, anchors := Anchors, polys := Polys}, Frames) ->
    Points =
        lists:append([[{X1, Y1}, {X2, Y2}] || [X1, Y1, X2, Y2] <- Segments]) ++
            [{X, Y} || #{pos := [X, Y, _]} <- Anchors] ++
            [{X, Y} || #{pt := Pts} <- Polys, [X, Y, _] <- Pts] ++
            [{X, Y} || #{objects := Os} <- Frames, #{pos := [X, Y, _]} <- Os],
    Known = [{X, Y} || {X, Y} <- Points, is_float(X), is_float(Y)] ++ [{0.0, 0.0}],
    {Xs, Ys} = lists:unzip(Known),
    {Left, Right} = {lists:min(Xs) - ?ROOM, lists:max(Xs) + ?ROOM},
    {Bottom, Top} = {lists:min(Ys) - ?ROOM, lists:max(Ys) + ?ROOM},
    Scale = (?WIDTH - 2 * ?MARGIN) / (Right - Left),
    {#view{left = Left, top = Top, scale = Scale},
        round(?HEAD + (Top - Bottom) * Scale + ?MARGIN)}.

x(X, #view{left = Left, scale = Scale}) -> ?MARGIN + (X - Left) * Scale.
y(Y, #view{top = Top, scale = Scale}) -> ?HEAD + (Top - Y) * Scale.

%% ---- what does not move -----------------------------------------------------------------------

terrain(#{seg := Segments, anchors := Anchors, polys := Polys}, View) ->
    [
        [path(Points, "Z", role(Role), View) || #{role := Role, pt := Points} <- Polys],
        [
            path([[X1, Y1, 0.0], [X2, Y2, 0.0]], "", "stroke=\"#5b6474\" stroke-width=\"4\"", View)
         || [X1, Y1, X2, Y2] <- Segments
        ],
        [anchor(Anchor, View) || Anchor <- Anchors]
    ].

role(0) -> "stroke=\"#2a8f6a\" stroke-width=\"2\"";
role(1) -> "stroke=\"#b01226\" stroke-width=\"2\" stroke-dasharray=\"8 4\"";
role(2) -> "stroke=\"#1f6fb4\" stroke-width=\"2\" stroke-dasharray=\"2 4\"";
role(_) -> "stroke=\"#8a5fb0\" stroke-width=\"2\" stroke-dasharray=\"8 3 2 3\"".

%% Of what is no number nothing is drawn.
path(Points, End, Paint, View) ->
    Places = [
        [number(x(X, View)), " ", number(y(Y, View))]
     || [X, Y, _] <- Points, is_float(X), is_float(Y)
    ],
    case Places of
        [_, _ | _] ->
            ["<path d=\"M", lists:join("L", Places), End, "\" fill=\"none\" ", Paint, "/>\n"];
        _ ->
            []
    end.

anchor(#{id := Id, pos := [X, Y, _]}, View) when is_float(X), is_float(Y) ->
    {Px, Py} = {x(X, View), y(Y, View)},
    [
        ["<path d=\"M", number(Px), " ", number(Py - 7), "l7 12h-14z\" fill=\"#2a8f6a\"/>\n"],
        text(Px + 10, Py + 5, "#3c4656", "12", io_lib:format("anchor ~b", [Id]))
    ];
anchor(_, _) ->
    [].

%% ---- what moves -------------------------------------------------------------------------------

contours(#{ellipses := Ellipses}, View) ->
    [
        contour([x(X, View), y(Y, View)], [Rx, Ry, Theta], Overlap, View)
     || #{x := X, y := Y, rx := Rx, ry := Ry, theta := Theta, overlap := Overlap} <- Ellipses,
        lists:all(fun is_float/1, [X, Y, Rx, Ry, Theta])
    ].

contour([Px, Py], [Rx, Ry, Theta], Overlap, #view{scale = Scale}) ->
    Paint =
        case Overlap of
            0 -> "fill=\"#e7b93a\" fill-opacity=\".18\" stroke=\"#8a6d00\"";
            _ -> "fill=\"#d23b4a\" fill-opacity=\".22\" stroke=\"#b01226\" stroke-width=\"3\""
        end,
    [
        "<ellipse rx=\"", number(Rx * Scale), "\" ry=\"", number(Ry * Scale), "\" ", Paint,
        " transform=\"translate(", number(Px), " ", number(Py), ") rotate(",
        number(-Theta * 180 / math:pi()), ")\"/>\n"
    ].

trail(#{id := Id}, At, Frames, View) ->
    Way = [
        Pos
     || #{t_us := T, objects := Objects} <- Frames, T =< At, T >= At - ?TRAIL_US,
        #{id := Other, pos := Pos} <- Objects, Other =:= Id
    ],
    path(Way, "", ["stroke=\"", colour(Id), "\" stroke-opacity=\".6\""], View).

object(#{pos := [X, Y, _], pos_est := [Ex, Ey, _]} = Object, View) when is_float(X), is_float(Y) ->
    #{id := Id, flags := Flags, yaw := Yaw, kind := Kind} = Object,
    {Px, Py} = {x(X, View), y(Y, View)},
    [
        "<g>", zone(Object, Px, Py, View),
        [ghost({Px, Py}, {x(Ex, View), y(Ey, View)}) || is_float(Ex), is_float(Ey)],
        glyph(Kind, Px, Py, Yaw, colour(Id), View),
        [collided(Px, Py) || Flags band 1 =/= 0],
        text(Px + 14, Py - 12, "#111827", "13", [
            integer_to_list(Id), [" faulted" || Flags band 4 =/= 0]
        ]),
        "</g>\n"
    ];
object(_, _) ->
    [].

zone(#{comfort := Comfort}, Px, Py, #view{scale = Scale}) when is_float(Comfort) ->
    circle(Px, Py, Comfort * Scale, "fill=\"#1f6fb4\" fill-opacity=\".12\" stroke=\"#1f6fb4\"");
zone(_, _, _, _) ->
    [].

%% Where it believes itself to be, and how far that is.
ghost({Px, Py}, {Ex, Ey}) ->
    [
        "<path d=\"M", number(Px), " ", number(Py), "L", number(Ex), " ", number(Ey),
        "\" stroke=\"#8f4400\" stroke-width=\"1.5\"/>",
        circle(Ex, Ey, 8, "fill=\"none\" stroke=\"#8f4400\" stroke-dasharray=\"4 3\"")
    ].

%% A copter: four rotors on a cross, the front one filled dark. Anything else: an arrow.
glyph(0, Px, Py, Yaw, Colour, #view{scale = Scale}) ->
    Arm = max(7, 0.3 * Scale),
    Rotors = [
        {Px + Arm * math:cos(real(Yaw) + A), Py - Arm * math:sin(real(Yaw) + A), Fill}
     || {A, Fill} <- [{0, "#111827"}, {math:pi() / 2, Colour}, {math:pi(), Colour},
                      {-math:pi() / 2, Colour}]
    ],
    [
        [
            ["<path d=\"M", number(Px), " ", number(Py), "L", number(Rx), " ", number(Ry),
                "\" stroke=\"#111827\" stroke-width=\"2\"/>"]
         || {Rx, Ry, _} <- Rotors
        ],
        [
            circle(Rx, Ry, Arm * 0.42, ["fill=\"", Fill, "\" stroke=\"#111827\""])
         || {Rx, Ry, Fill} <- Rotors
        ]
    ];
glyph(_, Px, Py, Yaw, Colour, #view{scale = Scale}) ->
    Size = max(8, 0.3 * Scale),
    [
        "<path d=\"M", number(Size), " 0L", number(-Size), " ", number(Size * 0.6), "V",
        number(-Size * 0.6), "Z\" fill=\"", Colour, "\" stroke=\"#111827\" transform=\"translate(",
        number(Px), " ", number(Py), ") rotate(", number(-real(Yaw) * 180 / math:pi()), ")\"/>"
    ].

real(Yaw) when is_float(Yaw) -> Yaw;
real(_) -> 0.0.

collided(Px, Py) ->
    [
        circle(Px, Py, 20, "fill=\"none\" stroke=\"#b01226\" stroke-width=\"3\""),
        "<path d=\"M", number(Px - 13), " ", number(Py - 13),
        "l26 26m0 -26l-26 26\" stroke=\"#b01226\" stroke-width=\"3\"/>"
    ].

%% ---- SVG --------------------------------------------------------------------------------------

document(Title, Height, Body) ->
    [
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" font-family=\"system-ui, "
        "'DejaVu Sans', Arial, sans-serif\"",
        io_lib:format(" width=\"~b\" height=\"~b\" viewBox=\"0 0 ~b ~b\">\n",
            [?WIDTH, Height, ?WIDTH, Height]),
        ["<title>", faultcheck_html:escape(Title), "</title>\n"],
        "<rect width=\"100%\" height=\"100%\" fill=\"#fdfdfc\"/>\n",
        text(?MARGIN, 27, "#111827", "15", Title),
        Body,
        "</svg>\n"
    ].

scale_bar(#view{scale = Scale}, Height) ->
    Metres = hd([M || M <- [50, 20, 10, 5, 2, 1, 0.5], M * Scale =< ?WIDTH / 4] ++ [0.2]),
    {Right, Y} = {?WIDTH - ?MARGIN, Height - 10},
    [
        ["<path d=\"M", number(Right - Metres * Scale), " ", number(Y - 6), "v6H", number(Right),
            "v-6\" fill=\"none\" stroke=\"#111827\" stroke-width=\"2\"/>\n"],
        text(Right - Metres * Scale + 4, Y - 6, "#111827", "12", io_lib:format("~w m", [Metres]))
    ].

circle(X, Y, Radius, Paint) ->
    [
        "<circle cx=\"", number(X), "\" cy=\"", number(Y), "\" r=\"", number(Radius), "\" ", Paint,
        "/>"
    ].

text(X, Y, Colour, Size, Text) ->
    [
        "<text x=\"", number(X), "\" y=\"", number(Y), "\" fill=\"", Colour, "\" font-size=\"",
        Size, "\">", faultcheck_html:escape(Text), "</text>\n"
    ].

colour(Id) ->
    element(abs(Id) rem 5 + 1, {"#1f6fb4", "#d9722e", "#2a8f6a", "#8a5fb0", "#6b7280"}).

number(N) when is_integer(N) -> integer_to_list(N);
number(F) -> float_to_list(F, [{decimals, 1}, compact]).

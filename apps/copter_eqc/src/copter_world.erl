%% @doc Where the copters fly: lines that must not be touched, anchors to range to.
%%
%% The reference world is that of Paper III; boxes are for more copters. Both are convex, so a
%% place is inside when it lies left of each edge. Metres; x right, y up on the map, z height.
-module(copter_world).

-export([lines/1, anchors/1, bounds/1, clearance/2, free/3, grid/2]).
-export([move/2]).
-export_type([world/0, line/0, anchor/0, place/0, move/0]).

%% {box, N}: made for N copters, 4 + 4 ceil(sqrt N) wide. open: the reference world without lines.
%% {moved, World, Move}: turned about the origin, then shifted.
-type world() :: reference | open | {box, pos_integer()} | {moved, world(), move()}.
-type move() :: {Dx :: float(), Dy :: float(), QuarterTurns :: 0..3}.
-type place() :: {X :: float(), Y :: float()}.
-type line() :: {Id :: non_neg_integer(), place(), place()}.
-type anchor() :: {Id :: non_neg_integer(), X :: float(), Y :: float(), Z :: float()}.

%% m: of a starting copter to other copters, and to lines.
-define(APART, 2.6).
-define(FROM_LINES, 1.5).

-define(FIRST_LINE, 1000).
%% m: between the copters of a grid, and by how much each may stand elsewhere
-define(GRID, 4.0).
-define(JITTER, 0.5).

%% @doc The lines, in the order of the paper.
-spec lines(world()) -> [line()].
lines(World) ->
    Ends = ends(World),
    Ids = lists:seq(?FIRST_LINE, ?FIRST_LINE + length(Ends) - 1),
    [{Id, From, To} || {Id, {From, To}} <- lists:zip(Ids, Ends)].

ends(reference) ->
    [
        {{-5.0, -5.0}, {5.0, -5.0}},
        {{5.0, -5.0}, {8.0, 0.0}},
        {{8.0, 0.0}, {5.0, 5.0}},
        {{-5.0, 5.0}, {5.0, 5.0}},
        {{-5.0, -5.0}, {-8.0, 0.0}},
        {{-8.0, 0.0}, {-5.0, 5.0}}
    ];
ends(open) ->
    [];
ends({box, _} = Box) ->
    edges(corners(Box));
ends({moved, World, Move}) ->
    [{move(Move, From), move(Move, To)} || {From, To} <- ends(World)].

%% @doc The anchors; the order is that of their use.
-spec anchors(world()) -> [anchor()].
anchors(reference) ->
    [{0, -8.0, -5.0, 1.0}, {1, -8.0, 5.0, 1.0}, {2, 8.0, 5.0, 1.0}, {3, 8.0, -5.0, 1.0}];
anchors(open) ->
    anchors(reference);
anchors({moved, World, Move}) ->
    [
        begin
            {MovedX, MovedY} = move(Move, {X, Y}),
            {Id, MovedX, MovedY, Z}
        end
     || {Id, X, Y, Z} <- anchors(World)
    ];
anchors({box, _} = Box) ->
    In = half(Box) - 1.0,
    Places = [{-In, -In}, {In, -In}, {In, In}, {-In, In}],
    [{Id, X, Y, 2.0} || {Id, {X, Y}} <- lists:zip([0, 1, 2, 3], Places)].

%% Counter-clockwise.
corners(reference) ->
    [{-5.0, -5.0}, {5.0, -5.0}, {8.0, 0.0}, {5.0, 5.0}, {-5.0, 5.0}, {-8.0, 0.0}];
corners(open) ->
    corners(reference);
corners({moved, World, Move}) ->
    [move(Move, Corner) || Corner <- corners(World)];
corners({box, _} = Box) ->
    H = half(Box),
    [{-H, -H}, {H, -H}, {H, H}, {-H, H}].

half({box, N}) -> 2.0 + 2.0 * math:ceil(math:sqrt(N)).

edges([First | Rest] = Corners) -> lists:zip(Corners, Rest ++ [First]).

%% @doc A place of a moved world.
-spec move(move(), place()) -> place().
move({Dx, Dy, Turns}, Place) ->
    {X, Y} = turn(Turns, Place),
    {X + Dx, Y + Dy}.

turn(0, Place) -> Place;
turn(N, {X, Y}) -> turn(N - 1, {-Y, X}).

%% @doc The smallest rectangle around the world.
-spec bounds(world()) -> {MinX :: float(), MinY :: float(), MaxX :: float(), MaxY :: float()}.
bounds(World) ->
    {Xs, Ys} = lists:unzip(corners(World)),
    {lists:min(Xs), lists:min(Ys), lists:max(Xs), lists:max(Ys)}.

%% @doc How far a place is from the nearest line; below 0 outside.
-spec clearance(world(), place()) -> float().
clearance(World, Place) ->
    lists:min([left_of(Edge, Place) || Edge <- edges(corners(World))]).

left_of({{X1, Y1}, {X2, Y2}}, {X, Y}) ->
    {Dx, Dy} = {X2 - X1, Y2 - Y1},
    (Dx * (Y - Y1) - Dy * (X - X1)) / math:sqrt(Dx * Dx + Dy * Dy).

%% @doc Whether a copter may start at a place, beside the places of others.
-spec free(world(), place(), [place()]) -> boolean().
free(World, {X, Y} = Place, Others) ->
    lists:all(fun({Ox, Oy}) -> squared(X - Ox, Y - Oy) >= ?APART * ?APART end, Others) andalso
        clearance(World, Place) >= ?FROM_LINES.

squared(A, B) -> A * A + B * B.

%% @doc N copters with their ids, in rows of a square around the origin.
-spec grid(pos_integer(), Seed :: non_neg_integer()) -> [{non_neg_integer(), place()}].
grid(N, Seed) ->
    Side = ceil(math:sqrt(N)),
    First = -?GRID * (Side - 1) / 2,
    {Copters, _} = lists:mapfoldl(
        fun(Id, State0) ->
            {X, State1} = jitter(First + ?GRID * (Id rem Side), State0),
            {Y, State2} = jitter(First + ?GRID * (Id div Side), State1),
            {{Id, {X, Y}}, State2}
        end,
        rand:seed_s(exsss, Seed),
        lists:seq(0, N - 1)
    ),
    Copters.

jitter(At, State) ->
    {Unit, Next} = rand:uniform_s(State),
    {At + ?JITTER * (2 * Unit - 1), Next}.

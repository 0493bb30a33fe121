%% @doc A trace of the airbag as a picture (SVG): commands, faults in force, packets as sent and as
%% received, and how many activation messages were counted, from left to right in the order of
%% what happened.
%%
%% Colours are classes of the page's style sheet, so that a dark page has a dark picture.
-module(airbag_timeline).

-export([svg/1]).

%% Places in SVG user units (CSS pixels at 100 %).
-define(LEFT, 132).
-define(RIGHT, 24).
-define(TOP, 12).
-define(COMMANDS, 44).
-define(FAULT, 26).
-define(PACKET, 44).
-define(CURVE, 96).
-define(WIDTH, 940).
-define(SLOT, 78).
%% average width of a character of the bytes
-define(CHAR, 8.5).

%% A slot is a place on the time line: a packet that arrives, or a command without any.
-record(slot, {step :: pos_integer(), packet = none :: none | airbag_trace:packet()}).

%% @doc The picture.
-spec svg(airbag_trace:trace()) -> iodata().
svg(#{steps := Steps} = Trace) ->
    Slots = slots(Steps),
    Width = max(narrowest(Slots), min(220, (?WIDTH - ?LEFT - ?RIGHT) div length(Slots))),
    X = fun(Slot) -> ?LEFT + Width * (Slot - 1) end,
    Bars = bars(Steps, Slots),
    Faults = ?TOP + ?COMMANDS + 8,
    Packets = Faults + ?FAULT * max(1, length(Bars)) + 8,
    Curve = Packets + 2 * ?PACKET + 22,
    Right = X(length(Slots) + 1),
    document(Right + ?RIGHT, Curve + ?CURVE + 34, Trace, [
        label(?TOP + 27, "commands"),
        [command(Step, Slots, X) || Step <- numbered(Steps)],
        label(Faults + 17, "faults"),
        [bar(Row, Faults, Bar, X) || {Row, Bar} <- numbered(Bars)],
        [label(Faults + 17, ?LEFT, "quiet", "none") || Bars =:= []],
        label(Packets + 20, "sent"),
        label(Packets + ?PACKET + 20, "received"),
        [packet(X(N), Width, Packets, Slot) || {N, Slot} <- numbered(Slots)],
        label(Curve + 20, "activation"),
        label(Curve + 36, "messages counted"),
        curve(Slots, X, Width, Curve, Trace)
    ]).

document(Width, Height, Trace, Body) ->
    [
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"tl-t tl-d\"",
        attributes([{width, Width}, {height, Height}]),
        io_lib:format(" viewBox=\"0 0 ~w ~w\">\n", [Width, Height]),
        ["<title id=\"tl-t\">Time line: ", text(airbag_story:headline(Trace)), "</title>\n"],
        ["<desc id=\"tl-d\">", text(description(Trace)), "</desc>\n"],
        [Body, "</svg>\n"]
    ].

description(#{steps := Steps} = Trace) ->
    Packets = airbag_trace:packets(Trace),
    Flipped = [P || {_, _, P} <- Packets, airbag_trace:flipped(P) =/= []],
    io_lib:format("~b commands, ~b packets received, ~b of them altered on the way. The tables "
        "below hold the same.", [length(Steps), length(Packets), length(Flipped)]).

%% The bytes of each packet have room.
narrowest(Slots) ->
    Bytes = lists:max([0 | [byte_size(B) || #slot{packet = #{bytes := B}} <- Slots]]),
    max(?SLOT, round(?CHAR * (3 * Bytes - 1)) + 18).

slots(Steps) ->
    lists:append([slots_of(Number, Step) || {Number, Step} <- numbered(Steps)]).

slots_of(Number, #{received := []}) -> [#slot{step = Number}];
slots_of(Number, #{received := Packets}) -> [#slot{step = Number, packet = P} || P <- Packets].

%% First and last slot of a step.
extent(Step, Slots) ->
    Own = [N || {N, #slot{step = S}} <- numbered(Slots), S =:= Step],
    {hd(Own), lists:last(Own)}.

%% ---- commands ---------------------------------------------------------------------------------

command({Number, #{name := Name, args := Args, value := Value}}, Slots, X) ->
    {First, Last} = extent(Number, Slots),
    {Left, Right} = {X(First) + 2, X(Last + 1) - 2},
    Kind = [kind(Name), [" notrun" || Value =:= none]],
    [
        "<g class=\"", Kind, "\"><title>", text(airbag_story:call(Name, Args)), "</title>",
        rect(Left, ?TOP, Right - Left, ?COMMANDS, "box", 6),
        write(Left + 8, ?TOP + 18, "strong", [integer_to_list(Number), " ", word(Name)]),
        write(Left + 8, ?TOP + 35, "small", cut(arguments(Args), Right - Left - 12)),
        "</g>\n"
    ].

kind(bit_flip) -> "fault";
kind(repetition) -> "fault";
kind(_) -> "command".

word(bit_flip) -> "flip";
word(repetition) -> "repeat";
word(Name) -> atom_to_list(Name).

arguments(Args) -> lists:join(", ", [io_lib:format("~0lp", [A]) || A <- Args]).

%% About 6.2 units a character.
cut(Text, Room) ->
    Flat = lists:flatten(Text),
    Most = max(1, trunc(Room / 6.2)),
    case string:length(Flat) > Most of
        true -> [string:slice(Flat, 0, Most - 1), 16#2026];
        false -> Flat
    end.

%% ---- faults -----------------------------------------------------------------------------------

%% Each fault from the slot of its command to the last one in which it is in force.
bars(Steps, Slots) ->
    Armed = [Faults || #{armed := Faults} <- Steps],
    Before = [[] | Armed],
    Ends = lists:seq(1, length(Steps)),
    [
        {Fault, element(1, extent(From, Slots)), element(2, extent(To, Slots))}
     || {From, Now, Earlier} <- lists:zip3(Ends, Armed, lists:sublist(Before, length(Steps))),
        Fault <- Now -- Earlier,
        To <- [until(From, Fault, lists:nthtail(From, Armed))]
    ].

until(At, Fault, [Next | Rest]) ->
    case lists:member(Fault, Next) of
        true -> until(At + 1, Fault, Rest);
        false -> At
    end;
until(At, _, []) ->
    At.

bar(Row, Top, {Fault, First, Last}, X) ->
    Y = Top + ?FAULT * (Row - 1),
    {Left, Right} = {X(First) + 2, X(Last + 1) - 2},
    [
        "<g class=\"fault\"><title>", text(airbag_story:fault(Fault)), "</title>",
        rect(Left, Y, Right - Left, ?FAULT - 6, "box", 4),
        write(Left + 8, Y + 15, "small", cut(airbag_story:fault(Fault), Right - Left - 12)),
        "</g>\n"
    ].

%% ---- packets ----------------------------------------------------------------------------------

packet(_, _, _, #slot{packet = none}) ->
    [];
packet(Left, Width, Top, #slot{packet = #{bytes := Bytes, sent := Sent} = Packet}) ->
    Middle = Left + Width / 2,
    Altered = airbag_trace:flipped(Packet) =/= [],
    [
        "<g class=\"packet", [" altered" || Altered], "\">",
        [[bytes(Middle, Top + 20, Sent, []), arrow(Middle, Top + 27)] || is_binary(Sent)],
        rect(Left + 3, Top + ?PACKET, Width - 6, ?PACKET, "box", 4),
        bytes(Middle, Top + ?PACKET + 19, Bytes, airbag_trace:flipped(Packet)),
        write_middle(Middle, Top + ?PACKET + 36, "small", status(Packet, Altered)),
        "</g>\n"
    ].

bytes(Middle, Y, Bytes, Flips) ->
    Marked = [Byte || {Byte, _} <- Flips],
    Parts = [
        case lists:member(N - 1, Marked) of
            true -> ["<tspan class=\"flip\">", airbag_story:hex(<<Byte>>), "</tspan>"];
            false -> airbag_story:hex(<<Byte>>)
        end
     || {N, Byte} <- numbered(binary_to_list(Bytes))
    ],
    [
        "<text class=\"hex\" text-anchor=\"middle\"", attributes([{x, Middle}, {y, Y}]), ">",
        lists:join(" ", Parts), "</text>"
    ].

arrow(X, Y) ->
    path(["M", number(X), " ", number(Y), "v11m-4 -5l4 5l4 -5"], "arrow").

status(#{status := none}, true) -> "altered";
status(#{status := none}, false) -> "";
status(#{status := Status}, _) -> airbag_coverage:status(Status).

%% ---- the count --------------------------------------------------------------------------------

curve(Slots, X, Width, Top, #{options := #{needed := Needed}} = Trace) ->
    Counts = [{N, C} || {N, #slot{packet = #{activations := C}}} <- numbered(Slots)],
    Most = lists:max([Needed + 1 | [C || {_, C} <- Counts]]),
    Y = fun(Count) -> Top + ?CURVE - ?CURVE * Count / Most end,
    Right = X(length(Slots) + 1),
    Points = [{X(N) + Width / 2, Y(C)} || {N, C} <- Counts],
    Limit = io_lib:format("~b fire", [Needed]) ++ [$s || Needed =:= 1] ++ " it",
    [
        line(?LEFT, Y(0), Right, Y(0), "axis"),
        line(?LEFT, Y(Needed), Right, Y(Needed), "limit"),
        write(?LEFT + 6, Y(Needed) - 6, "small limit-text", Limit),
        steps([{?LEFT, Y(0)} | lists:sort(Points ++ [{X(N), Y(0)} || N <- starts(Trace, Slots)])]),
        [
            [dot(PX, PY), write(PX + 16, PY + 16, "small", integer_to_list(C))]
         || {{PX, PY}, {_, C}} <- lists:zip(Points, Counts)
        ],
        [
            fired(Slot, {X(N) + Width / 2, Y(C)}, Trace)
         || {N, #slot{packet = #{activations := C}} = Slot} <- firings(Slots)
        ]
    ].

%% The slots behind explosions, which end with a start of the airbag.
starts(#{steps := Steps}, Slots) ->
    [
        element(2, extent(Number, Slots)) + 1
     || {Number, #{name := explosion, received := [_ | _]}} <- numbered(Steps)
    ].

%% The first packet of each command behind which the airbag has fired.
firings(Slots) ->
    Fired = [
        {Step, Slot}
     || {_, #slot{step = Step, packet = #{fired := true}}} = Slot <- numbered(Slots)
    ],
    [Slot || {_, Slot} <- lists:ukeysort(1, Fired)].

steps([{X0, Y0} | Points]) ->
    Steps = [["H", number(X), "V", number(Y)] || {X, Y} <- Points],
    path(["M", number(X0), " ", number(Y0), Steps], "count").

dot(X, Y) ->
    ["<circle class=\"dot\"", attributes([{cx, X}, {cy, Y}, {r, 4}]), "/>"].

%% As it should, or a cross in a ring: told without colour.
fired(#slot{step = Step, packet = Packet}, {X, Y}, Trace) ->
    case airbag_story:unasked({Step, Packet}, Trace) of
        false -> write_middle(X, Y - 10, "small", "fired, as told");
        true -> unasked(X, Y)
    end.

unasked(X, Y) ->
    [
        "<g class=\"fired\"><circle", attributes([{cx, X}, {cy, Y}, {r, 11}]), "/>",
        path(["M", number(X - 6), " ", number(Y - 6), "l12 12m0 -12l-12 12"], "cross"),
        write_middle(X, Y - 17, "strong", "FIRED"), "</g>\n"
    ].

%% ---- SVG --------------------------------------------------------------------------------------

label(Y, Text) -> label(Y, 8, "label", Text).

label(Y, X, Class, Text) -> [write(X, Y, Class, Text), "\n"].

write(X, Y, Class, Text) -> written(X, Y, Class, "start", Text).

write_middle(X, Y, Class, Text) -> written(X, Y, Class, "middle", Text).

written(X, Y, Class, Anchor, Text) ->
    [
        "<text class=\"", Class, "\" text-anchor=\"", Anchor, "\"", attributes([{x, X}, {y, Y}]),
        ">", text(Text), "</text>"
    ].

rect(X, Y, Width, Height, Class, Radius) ->
    [
        "<rect class=\"", Class, "\"",
        attributes([{x, X}, {y, Y}, {width, Width}, {height, Height}, {rx, Radius}]), "/>"
    ].

line(X1, Y1, X2, Y2, Class) ->
    [
        "<line class=\"", Class, "\"", attributes([{x1, X1}, {y1, Y1}, {x2, X2}, {y2, Y2}]),
        "/>\n"
    ].

path(Path, Class) -> ["<path class=\"", Class, "\" d=\"", Path, "\"/>"].

attributes(List) -> [[" ", atom_to_list(Name), "=\"", number(V), "\""] || {Name, V} <- List].

number(N) when is_integer(N) -> integer_to_list(N);
number(F) -> float_to_list(F, [{decimals, 1}, compact]).

text(Text) -> faultcheck_html:escape(Text).

numbered(List) -> lists:zip(lists:seq(1, length(List)), List).

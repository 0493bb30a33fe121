%% @doc SVG charts for reports: small files, light background, labelled axes.
%%
%% ```
%% Svg = faultcheck_chart:bars(#{title => "Commands", x_label => "share (%)",
%%                               bars => [{"sensor", 77.1}, {"bit_flip", 7.6}]}),
%% ok = file:write_file("commands.svg", Svg).
%% '''
%%
%% Four kinds: bars (one bar a name, horizontal), histogram (counts over a whole-number axis), steps
%% (one or more cumulative curves, with a linear or logarithmic x axis) and lines (one or more
%% quantities over a linear axis). The same input gives the same bytes.
-module(faultcheck_chart).

-export([bars/1, histogram/1, steps/1, lines/1]).
-export_type([bars/0, histogram/0, steps/0, lines/0]).

-type text() :: unicode:chardata().
-type bars() :: #{title := text(), x_label := text(), bars := [{text(), number()}]}.
-type histogram() :: #{
    title := text(), x_label := text(), y_label := text(), counts := [{integer(), number()}]
}.
-type steps() :: #{
    title := text(),
    x_label := text(),
    y_label := text(),
    x_scale => linear | log,
    %% points in ascending x; the curve keeps its y until the next point and ends at the last
    series := [{text(), [{number(), number()}]}]
}.

-type lines() :: #{
    title := text(),
    x_label := text(),
    y_label := text(),
    %% points in ascending x, none below 0
    series := [{text(), [{number(), number()}, ...]}, ...]
}.

%% Sizes in SVG user units (CSS pixels at 100 %).
-define(WIDTH, 640).
-define(HEIGHT, 340).
-define(LEFT, 64).
-define(RIGHT, 32).
-define(TOP, 40).
-define(BOTTOM, 52).
-define(ROW, 24).
%% average width of a character at 12 px
-define(CHAR, 6.6).

%% @doc One horizontal bar a name, its value beside it.
-spec bars(bars()) -> iodata().
bars(#{title := Title, x_label := XLabel, bars := Bars}) when Bars =/= [] ->
    Left = 24 + ?CHAR * lists:max([string:length(Name) || {Name, _} <- Bars]),
    Height = ?TOP + ?ROW * length(Bars) + ?BOTTOM,
    {Low, High, Step} = axis(0, lists:max([V || {_, V} <- Bars])),
    X = scale(linear, {Low, High}, {Left, ?WIDTH - ?RIGHT - 36}),
    Bottom = ?TOP + ?ROW * length(Bars),
    document(Title, Height, [
        [x_tick(X(T), ?TOP, Bottom, tick_text(T, Step)) || T <- ticks(Low, High, Step)],
        [
            bar_row(X(Low), X(V), ?TOP + ?ROW * I, Name, V)
         || {I, {Name, V}} <- numbered(Bars)
        ],
        x_title((X(Low) + X(High)) / 2, Height, XLabel)
    ]).

bar_row(X0, X1, Y, Name, Value) ->
    Middle = Y + ?ROW / 2 + 4,
    [
        rect(X0, Y + 4, max(X1 - X0, 0), ?ROW - 8, colour(0)),
        text(X0 - 8, Middle, "end", Name),
        text(X1 + 6, Middle, "start", value_text(Value))
    ].

%% @doc Counts over whole numbers, one narrow bar each.
-spec histogram(histogram()) -> iodata().
histogram(#{title := Title, x_label := XLabel, y_label := YLabel, counts := Counts}) when
    Counts =/= []
->
    Numbers = [N || {N, _} <- Counts],
    {Min, Max} = {lists:min(Numbers), lists:max(Numbers)},
    X = scale(linear, {Min - 0.5, Max + 0.5}, {?LEFT, ?WIDTH - ?RIGHT}),
    {Low, High, Step} = axis(0, lists:max([V || {_, V} <- Counts])),
    Y = scale(linear, {Low, High}, {?HEIGHT - ?BOTTOM, ?TOP}),
    Gap = min(2, (X(1) - X(0)) / 5),
    XStep = max(1, nice_step(Max - Min, 10)),
    document(Title, ?HEIGHT, [
        y_axis(Y, Low, High, Step, YLabel),
        [
            rect(X(N - 0.5) + Gap / 2, Y(V), X(1) - X(0) - Gap, Y(0) - Y(V), colour(0))
         || {N, V} <- Counts, V > 0
        ],
        [
            x_mark(X(T), tick_text(T, XStep))
         || T <- ticks(ceiling(Min, XStep), Max, XStep)
        ],
        x_title((?LEFT + ?WIDTH - ?RIGHT) / 2, ?HEIGHT, XLabel)
    ]).

%% @doc Cumulative curves that rise in steps, each with its name in the legend.
-spec steps(steps()) -> iodata().
steps(#{title := Title, x_label := XLabel, y_label := YLabel, series := Series} = Chart) when
    Series =/= []
->
    Scale = maps:get(x_scale, Chart, linear),
    Points = lists:append([P || {_, P} <- Series]),
    {XTicks, XLow, XHigh} = x_ticks(Scale, [X || {X, _} <- Points]),
    X = scale(Scale, {XLow, XHigh}, {?LEFT, ?WIDTH - ?RIGHT}),
    {Low, High, Step} = axis(0, lists:max([V || {_, V} <- Points])),
    Y = scale(linear, {Low, High}, {?HEIGHT - ?BOTTOM, ?TOP + ?ROW}),
    document(Title, ?HEIGHT, [
        y_axis(Y, Low, High, Step, YLabel),
        [x_tick(X(T), ?TOP + ?ROW, ?HEIGHT - ?BOTTOM, Text) || {T, Text} <- XTicks],
        [curve(X, Y, Ps, colour(I)) || {I, {_, Ps}} <- numbered(Series)],
        legend([Name || {Name, _} <- Series]),
        x_title((?LEFT + ?WIDTH - ?RIGHT) / 2, ?HEIGHT, XLabel)
    ]).

curve(X, Y, [{X0, Y0} | Points], Colour) ->
    Step = fun({Px, Py}) -> [" H", number(X(Px)), " V", number(Y(Py))] end,
    [
        ["<path d=\"M", number(X(X0)), " ", number(Y(0)), " V", number(Y(Y0))],
        [Step(P) || P <- Points],
        ["\" fill=\"none\" stroke=\"", Colour],
        "\" stroke-width=\"2\" stroke-linejoin=\"round\"/>\n"
    ].

%% @doc Quantities that are not below 0, joined by straight lines, each with its name in the legend.
-spec lines(lines()) -> iodata().
lines(#{title := Title, x_label := XLabel, y_label := YLabel, series := Series}) ->
    Points = lists:append([P || {_, P} <- Series]),
    {XTicks, XLow, XHigh} = x_ticks(linear, [X || {X, _} <- Points]),
    X = scale(linear, {XLow, XHigh}, {?LEFT, ?WIDTH - ?RIGHT}),
    {Low, High, Step} = axis(0, lists:max([V || {_, V} <- Points])),
    Y = scale(linear, {Low, High}, {?HEIGHT - ?BOTTOM, ?TOP + ?ROW}),
    document(Title, ?HEIGHT, [
        y_axis(Y, Low, High, Step, YLabel),
        [x_tick(X(T), ?TOP + ?ROW, ?HEIGHT - ?BOTTOM, Text) || {T, Text} <- XTicks],
        [polyline(X, Y, Ps, I) || {I, {_, Ps}} <- numbered(Series)],
        legend([Name || {Name, _} <- Series]),
        x_title((?LEFT + ?WIDTH - ?RIGHT) / 2, ?HEIGHT, XLabel)
    ]).

%% Told apart by dashes too.
polyline(X, Y, Points, I) ->
    [
        "<polyline points=\"",
        lists:join(" ", [[number(X(Px)), ",", number(Y(Py))] || {Px, Py} <- Points]),
        ["\" fill=\"none\" stroke=\"", colour(I), "\" stroke-width=\"2\" stroke-dasharray=\""],
        [element(I rem 5 + 1, {"none", "7 3", "2 3", "9 3 2 3", "12 5"}), "\"/>\n"]
    ].

legend(Names) ->
    {Items, _} = lists:mapfoldl(
        fun({I, Name}, X) ->
            Item = [rect(X, ?TOP - 6, 14, 4, colour(I)), text(X + 20, ?TOP, "start", Name)],
            {Item, X + 40 + ?CHAR * string:length(Name)}
        end,
        ?LEFT,
        numbered(Names)
    ),
    Items.

%% ---- axes -----------------------------------------------------------------------------------

%% From a value to a place; From and To are places, so To may be the smaller one.
scale(linear, {Low, High}, {From, To}) ->
    fun(V) -> From + (V - Low) / (High - Low) * (To - From) end;
scale(log, {Low, High}, Places) ->
    Linear = scale(linear, {math:log10(Low), math:log10(High)}, Places),
    fun(V) -> Linear(math:log10(V)) end.

axis(Low, High) when High > Low ->
    Step = nice_step(High - Low, 5),
    {Low, ceiling(High, Step), Step};
axis(Low, _High) ->
    {Low, Low + 1, 1}.

%% The smallest of 1, 2, 5 times a power of ten that gives at most about Count steps.
nice_step(Span, Count) when Span > 0 ->
    Raw = Span / Count,
    Power = math:pow(10, math:floor(math:log10(Raw))),
    Factor = hd([F || F <- [1, 2, 5, 10], F * Power >= Raw * 0.9999999]),
    case Factor * Power of
        Step when Step >= 1 -> round(Step);
        Step -> Step
    end;
nice_step(_Span, _Count) ->
    1.

ceiling(Value, Step) -> ceil(Value / Step - 1.0e-9) * Step.

ticks(Low, High, Step) ->
    [Low + I * Step || I <- lists:seq(0, floor((High - Low) / Step + 1.0e-9))].

x_ticks(linear, Values) ->
    {Low, High, Step} = axis(0, lists:max(Values)),
    {[{T, tick_text(T, Step)} || T <- ticks(Low, High, Step)], Low, High};
x_ticks(log, Values) ->
    Low = floor(math:log10(lists:min(Values))),
    High = max(Low + 1, ceil(math:log10(lists:max(Values)) - 1.0e-9)),
    Ticks = [round(math:pow(10, E)) || E <- lists:seq(Low, High), E >= 0],
    {[{T, tick_text(T, 1)} || T <- Ticks], math:pow(10, Low), math:pow(10, High)}.

y_axis(Y, Low, High, Step, Label) ->
    Middle = (Y(Low) + Y(High)) / 2,
    [
        [y_tick(Y(T), tick_text(T, Step)) || T <- ticks(Low, High, Step)],
        ["<text transform=\"translate(14 ", number(Middle), ") rotate(-90)\""],
        [" text-anchor=\"middle\">", escape(Label), "</text>\n"]
    ].

y_tick(Y, Text) ->
    [line(?LEFT, Y, ?WIDTH - ?RIGHT, Y), text(?LEFT - 8, Y + 4, "end", Text)].

x_tick(X, Top, Bottom, Text) ->
    [line(X, Top, X, Bottom), text(X, Bottom + 18, "middle", Text)].

x_mark(X, Text) ->
    text(X, ?HEIGHT - ?BOTTOM + 18, "middle", Text).

x_title(X, Height, Label) ->
    text(X, Height - 12, "middle", Label).

tick_text(T, Step) when Step >= 1 -> grouped(round(T));
tick_text(T, Step) -> io_lib:format("~.*f", [-floor(math:log10(Step) + 1.0e-9), float(T)]).

value_text(V) when is_integer(V) -> grouped(V);
value_text(V) -> io_lib:format("~.1f", [V]).

%% 1234567 as "1 234 567"
grouped(N) when N < 0 -> ["-", grouped(-N)];
grouped(N) when N < 1000 -> integer_to_list(N);
grouped(N) -> [grouped(N div 1000), " ", io_lib:format("~3..0b", [N rem 1000])].

%% ---- SVG ------------------------------------------------------------------------------------

document(Title, Height, Body) ->
    [
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"",
        [number(?WIDTH), "\" height=\"", number(Height), "\" viewBox=\"0 0 "],
        [number(?WIDTH), " ", number(Height), "\" font-size=\"12\" fill=\"#333\"\n"],
        "     font-family=\"system-ui, 'DejaVu Sans', Arial, sans-serif\">\n",
        ["<title>", escape(Title), "</title>\n"],
        "<rect width=\"100%\" height=\"100%\" fill=\"#fdfdfc\"/>\n",
        ["<text x=\"16\" y=\"22\" font-size=\"14\" font-weight=\"600\" fill=\"#111\">"],
        [escape(Title), "</text>\n"],
        Body,
        "</svg>\n"
    ].

%% Blue, orange, green, violet, grey: told apart also with red-green colour blindness.
colour(I) ->
    element(I rem 5 + 1, {"#1f6fb4", "#d9722e", "#2a8f6a", "#8a5fb0", "#6b7280"}).

rect(X, Y, Width, Height, Colour) ->
    ["<rect", attributes([{"x", X}, {"y", Y}, {"width", Width}, {"height", Height}]),
        " fill=\"", Colour, "\"/>\n"].

line(X1, Y1, X2, Y2) ->
    ["<line", attributes([{"x1", X1}, {"y1", Y1}, {"x2", X2}, {"y2", Y2}]),
        " stroke=\"#e3e3e0\"/>\n"].

text(X, Y, Anchor, Text) ->
    ["<text", attributes([{"x", X}, {"y", Y}]), " text-anchor=\"", Anchor, "\">",
        escape(Text), "</text>\n"].

attributes(List) ->
    [[" ", Name, "=\"", number(Value), "\""] || {Name, Value} <- List].

number(N) when is_integer(N) -> integer_to_list(N);
number(F) -> float_to_list(float(F), [{decimals, 1}, compact]).

escape(Text) ->
    unicode:characters_to_binary([escaped(C) || C <- unicode:characters_to_list(Text)]).

escaped($<) -> "&lt;";
escaped($>) -> "&gt;";
escaped($&) -> "&amp;";
escaped($") -> "&quot;";
escaped(C) -> C.

numbered(List) -> lists:zip(lists:seq(0, length(List) - 1), List).

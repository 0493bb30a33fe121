%% @doc Figures 8 to 13 of Paper III and Figure 4 of Paper II, flown again: `make copter-figures'.
%%
%% Writes copter_figures.md with its charts. The papers do not give every gain, so what is required
%% are the orderings that docs/coptersim.md section 11 states; each is checked, and one that does
%% not hold is exit status 1.
-module(copter_figures).

-export([main/1, run/1, figures/0]).
-export_type([figure/0]).

-type check() :: {Sentence :: string(), boolean()}.
-type figure() :: #{
    name := string(),
    title := string(),
    curves := [{string(), [{number(), number()}]}],
    y_label := string(),
    %% what was read off
    numbers := [{string(), Value :: string()}],
    checks := [check()]
}.

-define(SETTLED, 0.1).
-define(JUMP, 1.5).

%% @doc Writes the report into a directory and ends the VM.
-spec main([file:filename()]) -> no_return().
main([Dir]) -> faultcheck_written:halt("copter-figures", fun() -> run(Dir) end).

%% @doc Writes the report; whether every ordering holds.
-spec run(file:filename()) -> boolean().
run(Dir) ->
    {ok, _} = application:ensure_all_started(c_bridge),
    Charts = filename:join(Dir, "copter_figures"),
    ok = filelib:ensure_dir(filename:join(Charts, "x")),
    Figures = figures(),
    ok = copter_sut:stop(),
    ok = file:write_file(filename:join(Dir, "copter_figures.md"), [
        "# Errors of position and velocity under faults\n\n",
        "Made by `make copter-figures`: the flights of Papers II and III, with the orderings that\n"
        "must hold. Steps of 10 ms, one of four anchors every 50 ms.\n\n",
        [section(Figure, Charts) || Figure <- Figures]
    ]),
    Wrong = [{N, Text} || #{name := N, checks := Checks} <- Figures, {Text, false} <- Checks],
    [io:format(standard_error, "copter-figures: ~ts: not so: ~ts~n", [N, T]) || {N, T} <- Wrong],
    Wrong =:= [].

section(#{name := Name, title := Title} = Figure, Charts) ->
    #{curves := Curves, y_label := YLabel, numbers := Numbers, checks := Checks} = Figure,
    Svg = faultcheck_chart:steps(#{
        title => Title, x_label => "time (s)", y_label => YLabel, series => Curves
    }),
    ok = file:write_file(filename:join(Charts, Name ++ ".svg"), Svg),
    [
        io_lib:format("## ~ts\n\n![~ts](copter_figures/~s.svg)\n\n", [Title, Title, Name]),
        "| figure | value |\n|---|---:|\n",
        [["| ", What, " | ", Value, " |\n"] || {What, Value} <- Numbers],
        "\n",
        [["* ", Text, ": ", holds(Holds), "\n"] || {Text, Holds} <- Checks],
        "\n"
    ].

holds(true) -> "holds";
holds(false) -> "**does not hold**".

%% @doc All figures, flown.
-spec figures() -> [figure()].
figures() ->
    [position_hold(), figure8(), figure9(), figure10(), figure11(), figure12(), figure13()].

%% ---- Paper II -----------------------------------------------------------------------------------

position_hold() ->
    Held = copter_flight:hold(0.05, 1, 60000),
    Largest = lists:max([True || {_, True, _} <- Held]),
    Curve = fun(Of) -> [{element(1, H) / 1000, element(Of, H)} || H <- Held] end,
    #{
        name => "paper2_figure4",
        title => "Paper II, Figure 4: holding a position for 60 s, ranges with 5 cm of noise",
        y_label => "distance from the position (m)",
        curves => [{"true", Curve(2)}, {"perceived", Curve(3)}],
        numbers => [{"largest deviation, true", metres(Largest)}],
        checks => [{"the copter stays within 0.2 m", Largest < 0.2}]
    }.

%% ---- Paper III ----------------------------------------------------------------------------------

%% Two parts with other gains, as the papers' figures have them.
figure8() ->
    Samples = copter_flight:samples(#{pos_p => 0.2, vel_p => 0.3}, [
        {2000, jump()}, {11000, {set, pos_p, 1.0}}, {12000, jump()}
    ], 20000),
    Slow = settled(Samples, 2000, 10980),
    Fast = settled(Samples, 12000, 20000),
    drawn("figure8", "Figure 8: a jump of 1.5 m, pos_p 0.2 and then 1.0", Samples, [
        {"settles below 0.1 m, pos_p 0.2", time(Slow)},
        {"settles below 0.1 m, pos_p 1.0", time(Fast)}
    ], [{"the larger gain settles sooner", sooner(Fast, Slow)}]).

figure9() ->
    Samples = copter_flight:samples(#{vel_p => 0.0}, [
        {1000, {fault, 6000, [pitch({offset, 5.0})]}},
        {8000, {set, vel_p, 0.5}},
        {12000, {fault, 8000, [pitch({offset, 5.0})]}},
        {21000, {set, vel_p, 2.0}},
        {24000, {fault, 8000, [pitch({offset, 5.0})]}}
    ], 34000),
    Residual = fun(From, Until) -> copter_flight:mean_error(Samples, From, Until) end,
    [None, Low, High] = [Residual(5000, 7000), Residual(16000, 20000), Residual(28000, 32000)],
    drawn("figure9", "Figure 9: a pitch offset of 5 degrees, vel_p 0, 0.5 and 2.0", Samples, [
        {"mean position error, vel_p 0", metres(None)},
        {"mean position error, vel_p 0.5", metres(Low)},
        {"mean position error, vel_p 2.0", metres(High)}
    ], [
        {"without velocity gain the error does not settle", None > 2 * Low},
        {"the larger velocity gain leaves less", High < Low}
    ]).

figure10() ->
    Samples = copter_flight:samples(#{pos_p => 2.0, vel_p => 0.3}, [{2000, jump()}], 12000),
    Settled = settled(Samples, 2000, 12000),
    drawn("figure10", "Figure 10: a jump of 1.5 m, pos_p 2.0", Samples, [
        {"settles below 0.1 m", time(Settled)}
    ], [{"a gain that is too large never settles", Settled =:= never}]).

figure11() ->
    Samples = copter_flight:samples(#{pos_p => 0.8, vel_p => 0.0}, [
        {2000, jump()}, {12000, {set, vel_p, 2.0}}, {13000, jump()}
    ], 24000),
    Without = settled(Samples, 2000, 11980),
    With = settled(Samples, 13000, 24000),
    drawn("figure11", "Figure 11: a jump of 1.5 m, vel_p 0 and then 2.0", Samples, [
        {"settles below 0.1 m, vel_p 0", time(Without)},
        {"settles below 0.1 m, vel_p 2.0", time(With)}
    ], [{"the velocity gain makes no difference to a jump", alike(Without, With)}]).

%% A range that is too long, then a pitch offset, with either gain.
figure12() ->
    Faults = fun(At) ->
        [
            {At, {fault, 1000, [{{probe, <<"RangeId0Anch1">>}, {offset, 1.0}}]}},
            {At + 7000, {fault, 6000, [pitch({offset, 5.0})]}}
        ]
    end,
    Samples = copter_flight:samples(
        #{pos_p => 0.8, vel_p => 0.2},
        Faults(1000) ++ [{17000, {set, vel_p, 2.0}}] ++ Faults(20000),
        35000
    ),
    [RangeLow, RangeHigh] = [settled(Samples, At + 1000, At + 6980) || At <- [1000, 20000]],
    [PitchLow, PitchHigh] =
        [copter_flight:mean_error(Samples, At + 10000, At + 13000) || At <- [1000, 20000]],
    drawn("figure12", "Figure 12: a range 1 m too long, then 5 degrees of pitch; vel_p 0.2 and 2.0",
        Samples, [
            {"settles below 0.1 m after the range, vel_p 0.2", time(RangeLow)},
            {"settles below 0.1 m after the range, vel_p 2.0", time(RangeHigh)},
            {"mean position error under the pitch offset, vel_p 0.2", metres(PitchLow)},
            {"mean position error under the pitch offset, vel_p 2.0", metres(PitchHigh)}
        ], [
            {"from the range both gains recover alike", alike(RangeLow, RangeHigh)},
            {"the pitch offset needs the larger gain", 2 * PitchHigh < PitchLow}
        ]).

figure13() ->
    Pitch = fun(U) -> {command, 0.0, U, 0.0} end,
    Moving = fun(At) ->
        [{At + 1000, {fault, 18000, [pitch({amplification, 0.95})]}}] ++
            [
                {At + 2000 * I, Pitch(U)}
             || {I, U} <- [{1, 0.3}, {2, -0.3}, {4, 0.3}, {6, -0.3}, {8, 0.3}, {9, 0.0}]
            ]
    end,
    Samples = copter_flight:samples(
        #{pos_p => 0.3}, Moving(0) ++ [{20000, {set, pos_p, 1.0}}] ++ Moving(20000), 40000
    ),
    Low = copter_flight:mean_error(Samples, 2000, 18000),
    High = copter_flight:mean_error(Samples, 22000, 38000),
    drawn("figure13", "Figure 13: a pitch gain of 0.95 in motion, pos_p 0.3 and 1.0", Samples, [
        {"mean position error, pos_p 0.3", metres(Low)},
        {"mean position error, pos_p 1.0", metres(High)}
    ], [{"the larger gain leaves less", High < Low}]).

jump() -> {fault, 10, [{{probe, <<"PxId0">>}, {offset, ?JUMP}}]}.

pitch(Model) -> {{probe, <<"PitchId0">>}, Model}.

settled(Samples, From, Until) -> copter_flight:settled(Samples, From, Until, ?SETTLED).

sooner(never, _) -> false;
sooner(_, never) -> true;
sooner(A, B) -> A < B.

alike(A, B) when is_integer(A), is_integer(B) -> max(A, B) =< 2 * min(A, B);
alike(_, _) -> false.

drawn(Name, Title, Samples, Numbers, Checks) ->
    Curve = fun(Of) -> [{element(1, S) / 1000, element(Of, S)} || S <- Samples] end,
    #{
        name => Name,
        title => Title,
        y_label => "error (m, m/s); faults active",
        curves => [{"position", Curve(2)}, {"velocity", Curve(3)}, {"faults", Curve(4)}],
        numbers => Numbers,
        checks => Checks
    }.

metres(M) -> io_lib:format("~.4f m", [M]).

time(never) -> "never";
time(Ms) -> io_lib:format("~.2f s", [Ms / 1000]).

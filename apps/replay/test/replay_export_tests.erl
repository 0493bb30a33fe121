-module(replay_export_tests).
-include_lib("eunit/include/eunit.hrl").

%% What independent programs read of exports: visualizer/codec/exports.test.ts.

export_test_() ->
    {foreach, fun folder/0, fun file:del_dir_r/1, [
        fun(Dir) -> {Title, fun() -> Test(Dir) end} end
     || {Title, Test} <- [
            {"without a recording a line says how to get one", fun missing/1},
            {"a damaged recording is told with its place", fun damaged/1},
            {"times that cannot be are refused", fun impossible/1},
            {"numbers that are none leave empty fields and no curve", fun no_numbers/1},
            {"the user chooses the place, further files stand beside it", fun out/1},
            {"a place that is not there is told", fun nowhere/1},
            {"the map shows the moment asked for", fun moment/1},
            {"a moment after the end is refused with the length", fun after_the_end/1},
            {"text stays text in pictures", fun hostile/1},
            {"the same recording gives the same bytes", fun again/1}
        ]
    ]}.

folder() ->
    Dir = cb_files:fresh_name("export", ""),
    ok = file:make_dir(Dir),
    Dir.

%% An object at 3 east, 4 north that believes itself at the origin.
object(Id, Flags) ->
    #{
        id => Id, kind => 0, flags => Flags, pos => [3.0, 4.0, 0.0], vel => [1.0, 0.0, 0.0],
        yaw => 0.0, roll => 0.0, pitch => 0.0, pos_est => [0.0, 0.0, 0.0],
        vel_est => [1.0, 0.0, 0.5], comfort => 0.5, steer => [0.25, -0.25]
    }.

frame(T, Objects) -> {frame, T, #{t_us => T, run => 1, seq => 0, objects => Objects}}.

record(Dir, Messages) ->
    ok = file:write_file(filename:join(Dir, "run.lcm"), [
        replay_lcm_log:bytes(#{
            number => N, t_us => T, channel => replay_lcm:channel(Type),
            data => replay_lcm:encode(Type, Message)
        })
     || {N, {Type, T, Message}} <- lists:zip(lists:seq(0, length(Messages) - 1), Messages)
    ]).

read(File) ->
    {ok, Text} = file:read_file(File),
    unicode:characters_to_list(Text).

has(Part, Text) -> ?assertNotEqual({Part, nomatch}, {Part, string:find(Text, Part)}).

missing(Dir) ->
    {error, Line} = replay_export:write(Dir, #{format => csv}),
    has("run.lcm is missing; faultcheck report " ++ Dir, Line).

damaged(Dir) ->
    record(Dir, [frame(0, []), frame(1, [])]),
    File = filename:join(Dir, "run.lcm"),
    {ok, Log} = file:read_file(File),
    ok = file:write_file(File, binary:part(Log, 0, byte_size(Log) - 3)),
    {error, Line} = replay_export:write(Dir, #{format => mcap}),
    has("truncated: event 1", Line).

impossible(Dir) ->
    [
        begin
            record(Dir, [{frame, 0, #{t_us => T, run => 1, seq => 0, objects => []}}]),
            {error, Line} = replay_export:write(Dir, #{format => mcap}),
            has(lists:concat(["event 0: a time of ", T, " us"]), Line)
        end
     || T <- [-45, 1 bsl 60]
    ].

%% Lines by hand: the errors are 5 m and 0.5 m/s; the second object is 12 m above the first, at
%% the same place otherwise.
no_numbers(Dir) ->
    Broken = (object(7, 5))#{pos := [nan, 4.0, 0.0], comfort := inf},
    High = (object(2, 1))#{pos := [3.0, 4.0, 12.0]},
    record(Dir, [frame(0, [object(1, 0), High]), frame(20000, [object(1, 16), Broken])]),
    {ok, [File]} = replay_export:write(Dir, #{format => csv}),
    [_, First, _, Third, Fourth, ""] = string:split(read(File), "\r\n", all),
    ?assertEqual(
        "0.000000,1,3.0,4.0,0.0,1.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,1.0,0.0,0.5,0.25,-0.25,"
        "0,0,0,0,0,0.5,5.0,0.5,2,12.0",
        First
    ),
    ?assertEqual(",0,0,0,0,1,0.5,5.0,0.5,7,", string:slice(Third, string:length(Third) - 25)),
    ?assertEqual(
        "0.020000,7,,4.0,0.0,1.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,0.0,1.0,0.0,0.5,0.25,-0.25,"
        "1,0,1,0,0,,,0.5,1,",
        Fourth
    ),
    World = #{
        run => 1, version => 1, seg => [[nan, 0.0, 1.0, inf], [0.0, 0.0, 1.0, 1.0]],
        anchors => [#{id => 1, pos => [neg_inf, 0.0, nan]}],
        polys => [#{name => "p", role => 1, pt => [[nan, nan, nan], [1.0, 1.0, 1.0]]}]
    },
    Ellipse = #{
        about => 1, kind => 0, overlap => 1, x => nan, y => 0.0, rx => inf, ry => 1.0,
        theta => 0.0, age => 0.0
    },
    Risk = #{t_us => 0, run => 1, observer => 7, ellipses => [Ellipse]},
    record(Dir, [{world, 0, World}, {risk, 0, Risk}, frame(0, [Broken])]),
    {ok, [_]} = replay_export:write(Dir, #{format => mcap}),
    {ok, [Map | _]} = replay_export:write(Dir, #{format => svg}),
    {Svg, []} = xmerl_scan:file(Map, [{quiet, true}]),
    ?assertEqual(1, length(xmerl_xpath:string("//path[@stroke='#5b6474']", Svg))).

out(Dir) ->
    record(Dir, [frame(0, [object(1, 0), object(2, 0)]), frame(20000, [object(1, 0)])]),
    Map = filename:join(Dir, "picture.svg"),
    {ok, Files} = replay_export:write(Dir, #{format => svg, out => Map}),
    ?assertEqual(
        ["picture.svg", "picture-position-error.svg", "picture-nearest.svg"],
        [filename:basename(File) || File <- Files]
    ),
    [?assert(filelib:is_regular(File)) || File <- Files],
    Bare = filename:join(Dir, "of.v2"),
    {ok, Others} = replay_export:write(Dir, #{format => svg, out => Bare}),
    ?assertEqual(
        ["of.v2.svg", "of.v2-position-error.svg", "of.v2-nearest.svg"],
        [filename:basename(File) || File <- Others]
    ),
    Lines = filename:join(Dir, "lines"),
    ?assertEqual({ok, [Lines]}, replay_export:write(Dir, #{format => csv, out => Lines})).

%% No picture is written; the end as the map shows it, rounded to milliseconds, is the end.
after_the_end(Dir) ->
    record(Dir, [frame(0, [object(1, 0)]), frame(5679700, [object(1, 0)])]),
    [
        begin
            {error, Line} = replay_export:write(Dir, #{format => svg, at => At}),
            has("ends at 5.680 s", Line),
            ?assertEqual(["run.lcm"], filelib:wildcard("*", Dir))
        end
     || At <- [999, 5.682]
    ],
    {ok, [_ | _]} = replay_export:write(Dir, #{format => svg, at => 5.68}).

nowhere(Dir) ->
    record(Dir, [frame(0, [object(1, 0)])]),
    File = filename:join([Dir, "none", "x.csv"]),
    {error, Line} = replay_export:write(Dir, #{format => csv, out => File}),
    has("no such file or directory", Line).

moment(Dir) ->
    record(Dir, [frame(0, [object(1, 0)]), frame(1000000, [object(1, 1)])]),
    Map = fun(What) ->
        {ok, [File | _]} = replay_export:write(Dir, What#{format => svg}),
        read(File)
    end,
    has("t = 0.000 s", Map(#{at => 0.99})),
    has("t = 1.000 s", Map(#{at => 1})),
    %% the cross of a collision
    ?assertEqual(nomatch, string:find(Map(#{at => 0}), "l26 26")),
    has("l26 26", Map(#{})).

hostile(Dir) ->
    Case = #{
        case_id => <<"</text><script>alert(1)</script>">>, property => <<"p">>, seed => <<"1">>,
        code_version => <<>>, ncmd_original => 0, commands => [], params => <<"{}">>
    },
    record(Dir, [{case_info, 0, Case}, frame(0, [object(1, 0)])]),
    {ok, Files} = replay_export:write(Dir, #{format => svg}),
    [?assertEqual(nomatch, string:find(read(File), "<script")) || File <- Files].

again(Dir) ->
    record(Dir, [frame(0, [object(1, 0)]), frame(20000, [object(1, 1)])]),
    [
        begin
            {ok, Files} = replay_export:write(Dir, #{format => Format}),
            First = [file:read_file(File) || File <- Files],
            {ok, Files} = replay_export:write(Dir, #{format => Format}),
            ?assertEqual(First, [file:read_file(File) || File <- Files])
        end
     || Format <- [mcap, csv, svg]
    ].

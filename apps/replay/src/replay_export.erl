%% @doc A recorded case for other programs: MCAP, CSV, or pictures (faultcheck_export).
-module(replay_export).

-export([write/2]).

%% Objects with a curve in a picture: the chart has so many colours.
-define(MOST_CURVES, 5).
%% Times are shown in milliseconds: whoever asks for the end as it was shown gets it.
-define(ROUNDED_US, 1000).

%% @doc Writes what is asked for from run.lcm of a case's folder; the files written.
-spec write(file:filename(), faultcheck_export:what()) ->
    {ok, [file:filename()]} | {error, string()}.
write(Dir, #{format := Format} = What) ->
    Recording = filename:join(Dir, "run.lcm"),
    case filelib:is_regular(Recording) of
        true ->
            case replay_flight:read(Recording) of
                {ok, Flight} -> exported(Format, What, Flight, Dir);
                {error, _} = Error -> Error
            end;
        false ->
            {error, text("~ts is missing; faultcheck report ~ts writes it", [Recording, Dir])}
    end.

exported(Format, What, #{frames := Frames} = Flight, Dir) ->
    End = maps:get(t_us, lists:last(Frames)),
    case What of
        #{at := At} when At * 1000000 >= End + ?ROUNDED_US ->
            {error, text("--at ~tp: the flight ends at ~.3f s", [At, End / 1000000])};
        _ ->
            written(files(Format, What, Flight), Dir, What, [])
    end.

%% Names in the folder of the case.
files(mcap, _, Flight) ->
    [{"run.mcap", replay_mcap:format(replay_foxglove:content(Flight))}];
files(csv, _, Flight) ->
    [{"run.csv", replay_csv:format(Flight)}];
files(svg, What, #{frames := Frames} = Flight) ->
    At =
        case What of
            #{at := Seconds} -> round(Seconds * 1000000);
            _ -> maps:get(t_us, lists:last(Frames))
        end,
    Errors = curves(fun(O, _) -> replay_flight:position_error(O) end, Flight),
    Nearest = curves(fun nearest/2, Flight),
    [{"map.svg", replay_map:svg(At, Flight)}] ++
        chart("position-error.svg", "Position error", "m", Errors) ++
        chart("nearest.svg", "Distance to the nearest object", "m", Nearest).

chart(_, _, _, []) ->
    [];
chart(Name, Title, Unit, Series) ->
    Svg = faultcheck_chart:lines(#{
        title => Title, x_label => "simulated time (s)", y_label => Unit, series => Series
    }),
    [{Name, Svg}].

nearest(Object, Objects) ->
    case replay_flight:nearest(Object, Objects) of
        none -> nan;
        {_, Distance} -> Distance
    end.

%% Those who collided, then those who were most in error.
curves(Quantity, #{frames := Frames}) ->
    #{objects := AtEnd} = lists:last(Frames),
    Collided = [Id || #{id := Id, flags := Flags} <- AtEnd, Flags band 1 =/= 0],
    Worst = maps:to_list(lists:foldl(fun worst/2, #{}, Frames)),
    Others = [Id || {Id, _} <- lists:reverse(lists:keysort(2, Worst)),
                    not lists:member(Id, Collided)],
    [
        {text("object ~b", [Id]), Points}
     || Id <- lists:sort(lists:sublist(Collided ++ Others, ?MOST_CURVES)),
        [_ | _] = Points <- [points(Id, Quantity, Frames)]
    ].

worst(#{objects := Objects}, Worst) ->
    lists:foldl(
        fun(#{id := Id} = Object, Known) ->
            case replay_flight:position_error(Object) of
                nan -> Known;
                Error -> maps:update_with(Id, fun(E) -> max(E, Error) end, Error, Known)
            end
        end,
        Worst,
        Objects
    ).

points(Id, Quantity, Frames) ->
    [
        {T / 1000000, Value}
     || #{t_us := T, objects := Objects} <- Frames, #{id := Other} = Object <- Objects,
        Other =:= Id, Value <- [Quantity(Object, Objects)], is_float(Value)
    ].

written([], _, _, Done) ->
    {ok, lists:reverse(Done)};
written([{Name, Content} | Rest], Dir, What, Done) ->
    File = place(Name, Dir, What, Done),
    try faultcheck_case:add_file(filename:dirname(File), filename:basename(File), Content) of
        ok -> written(Rest, Dir, What, [File | Done])
    catch
        error:{not_written, Line} -> {error, Line}
    end.

%% The first file goes where the user wants it, further pictures beside it; all end in .svg.
place(Name, Dir, What, Done) ->
    case What of
        #{out := File, format := svg} when Done =:= [] -> filename:rootname(File, ".svg") ++ ".svg";
        #{out := File, format := svg} -> filename:rootname(File, ".svg") ++ "-" ++ Name;
        #{out := File} -> File;
        _ -> filename:join(Dir, Name)
    end.

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

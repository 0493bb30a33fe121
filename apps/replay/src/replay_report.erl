%% @doc The report of a case: the visualizer's built page with the case's recording in it, one file
%% that opens without a server and without a network (docs/visualizer.md, "A report").
%%
%% The recording is all that goes in, and the name of the case. The same recording and the same page
%% give the same bytes.
-module(replay_report).

-export([write/1, format/3, format/4, page/0]).

-define(REPORT, "report.html").
-define(RECORDING, "run.lcm").
-define(MOST_BYTES, 20000000).
%% Frames a second that are kept, one after the other, until the report is small enough.
-define(RATES, [20, 10, 5, 2, 1]).

%% @doc Writes report.html into the folder of a case that has run.lcm. Without the built page there
%% is none, and a note says what to run.
-spec write(file:filename()) -> faultcheck_case:told().
write(Dir) ->
    case {page(), file:read_file(filename:join(Dir, ?RECORDING))} of
        {{error, Line}, _} -> #{notes => ["no " ?REPORT ": " ++ Line]};
        {_, {error, Why}} -> #{notes => [unreadable(Dir, Why)]};
        {{ok, Page}, {ok, Log}} -> told(format(Page, Log, filename:basename(Dir)), Dir)
    end.

unreadable(Dir, Why) ->
    text("no " ?REPORT ": ~ts: ~ts", [filename:join(Dir, ?RECORDING), file:format_error(Why)]).

told({Html, Notes}, Dir) ->
    ok = faultcheck_case:add_file(Dir, ?REPORT, Html),
    #{report => ?REPORT, notes => Notes}.

%% @doc A page with a log in it, and what is to be said of that.
-spec format(Page :: binary(), Log :: binary(), Title :: unicode:chardata()) ->
    {iodata(), [string()]}.
format(Page, Log, Title) -> format(Page, Log, Title, ?MOST_BYTES).

%% @doc The same with another limit, in bytes.
-spec format(binary(), binary(), unicode:chardata(), Most :: pos_integer()) ->
    {iodata(), [string()]}.
format(Page, Log, Title, Most) ->
    Html = html(Page, Log, Title),
    case iolist_size(Html) =< Most of
        true -> {Html, []};
        false -> thinned(Page, Log, Title, Most, ?RATES)
    end.

thinned(Page, Log, Title, Most, [Rate | Rates]) ->
    Html = html(Page, thin(Log, Rate), Title),
    case iolist_size(Html) of
        Size when Size =< Most; Rates =:= [] ->
            Note = text(?REPORT " has ~b frames a second, ~b kB; " ?RECORDING " has all",
                        [Rate, Size div 1000]),
            {Html, [Note]};
        _ ->
            thinned(Page, Log, Title, Most, Rates)
    end.

%% In front of the end of the page: the last `</body>', for its scripts may hold that word.
html(Page, Log, Title) ->
    {At, _} = lists:last(binary:matches(Page, <<"</body>">>)),
    <<Front:At/binary, Back/binary>> = Page,
    Name = faultcheck_html:escape(Title),
    [
        Front, "<script type=\"application/gzip\" id=\"log\" data-name=\"", Name, "\">",
        base64:encode(zlib:gzip(Log)), "</script>\n", Back
    ].

%% What was recorded is whole; of many frames and contours so many a second are left, and the last.
thin(Log, Rate) ->
    {ok, Events} = replay_lcm_log:events(Log),
    Last = lists:last([T || #{t_us := T, channel := <<"VIZ_FRAME">>} <- Events]),
    {Kept, _} = lists:foldl(
        fun(Event, {Kept, Slots}) -> keep(Event, Last, Rate, Kept, Slots) end,
        {[], #{}},
        Events
    ),
    [replay_lcm_log:bytes(Event) || Event <- lists:reverse(Kept)].

keep(#{channel := Channel, t_us := T} = Event, Last, Rate, Kept, Slots) when
    Channel =:= <<"VIZ_FRAME">>; Channel =:= <<"VIZ_RISK">>
->
    case {T * Rate div 1000000, Slots} of
        {Slot, #{Channel := Slot}} when T =/= Last -> {Kept, Slots};
        {Slot, _} -> {[Event | Kept], Slots#{Channel => Slot}}
    end;
keep(Event, _, _, Kept, Slots) ->
    {[Event | Kept], Slots}.

%% @doc The built page: installed beside this application, or built in the clone.
-spec page() -> {ok, binary()} | {error, string()}.
page() ->
    App = filename:dirname(filename:dirname(filename:absname(code:which(?MODULE)))),
    Root = filename:join(App, "../../../.."),
    Places = [
        filename:join(App, "priv/page.html"),
        filename:join(Root, "visualizer/dist/page.html"),
        "visualizer/dist/page.html"
    ],
    case [File || File <- Places, filelib:is_regular(File)] of
        [File | _] -> checked(File, file:read_file(File));
        [] -> {error, "the page is not built; run: scripts/build_visualizer.sh"}
    end.

checked(File, {ok, Page}) ->
    case binary:match(Page, <<"</body>">>) of
        nomatch -> {error, text("~ts is no page; run: scripts/build_visualizer.sh", [File])};
        _ -> {ok, Page}
    end;
checked(File, {error, Why}) ->
    {error, text("~ts: ~ts", [File, file:format_error(Why)])}.

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

%% @doc What PropEr prints during a job, sorted: some is shown, some tells why a test failed, and
%% the rest is said better by the runner's own report.
%%
%% In a run everything up to the failure is shown. While a test is shrunk nothing is, until
%% PropEr reports the smallest failure: what the actions of its ?WHENFAIL print is shown then.
-module(faultcheck_transcript).

-export([printer/2, reasons/0, most_dots/0]).

-define(MOST_DOTS, 1000).

%% @doc From this many tests on a line of progress takes the place of PropEr's dots.
-spec most_dots() -> pos_integer().
most_dots() -> ?MOST_DOTS.

%% @doc Why the last test failed, as PropEr told it.
-spec reasons() -> [string()].
reasons() -> lists:reverse(get(printed)).

%% @doc What PropEr is given as on_output for a job of one kind.
-spec printer(run | share | shrink | mute | check, faultcheck_testing:run()) ->
    fun((string(), [term()]) -> ok).
printer(Mode, #{job := Job, property := {_, Outer}, numtests := N, tell := Tell} = Run) ->
    put(printed, []),
    put(dots, 0),
    Print = maps:get(on_output, Outer, fun(F, Args) -> Tell({show, utf8(F, Args)}) end),
    Show = #{print => Print, dots => faultcheck_property:dotted(Job, N), run => Run},
    fun(Format, Args) -> output(Mode, get(phase), Format, Args, Show) end.

output(run, testing, Dot, [], #{dots := Dots, print := Print}) when Dot =:= "."; Dot =:= "x" ->
    %% The search of an ?EXISTS has a dot for each step.
    Shown = get(dots),
    put(dots, Shown + 1),
    _ = Dots andalso Shown < ?MOST_DOTS andalso Print(Dot, []),
    ok;
output(share, testing, Dot, [], #{run := Run}) when Dot =:= "."; Dot =:= "x" ->
    %% Empty tests have dots, too.
    _ = get(running) andalso
        faultcheck_share:tested(maps:get(Dot, #{"." => passed, "x" => rejected}), Run),
    ok;
output(share, testing, "!", [], _) ->
    put(phase, failed),
    ok;
output(Mode, testing, "!", [], #{dots := Dots, print := Print, run := Run}) ->
    put(phase, failed),
    _ = Mode =:= run andalso Dots andalso Print("!~n", []),
    failing(Mode, Run);
output(run, testing, Format, Args, #{run := #{deadline := infinity}, print := Print}) ->
    _ = Print(Format, Args),
    ok;
output(shrink, failed, ".", [], _) ->
    put(shrinks, get(shrinks) + 1),
    ok;
output(_Mode, _Phase, "~w~n", [_], _) ->
    ok;
output(shrink, failed, Format, [N], #{run := #{tell := Tell}}) when is_integer(N) ->
    case string:find(Format, "time(s)") of
        nomatch -> ok;
        _ -> Tell({mute, false})
    end;
output(_Mode, _Phase, Format, Args, _) ->
    printed(string:trim(utf8(Format, Args))).

%% Nothing more of the property's own prints until the shrunk counterexample is reported.
failing(run, #{options := Options, fails := Fails, tell := Tell}) ->
    Tell({mute, Fails orelse not lists:member(noshrink, Options)});
failing(_Mode, _Run) ->
    ok.

%% The lines that tell why a test failed.
printed(Text) ->
    Said = ["Test execution", "A linked", "Sub-property", "An exception"],
    case [S || S <- Said, string:prefix(Text, S) =/= nomatch] of
        [] -> ok;
        _ -> put(printed, [unicode:characters_to_list(Text) | get(printed)])
    end,
    ok.

%% Without PropEr's colours.
utf8(Format, Args) ->
    Text = unicode:characters_to_binary(io_lib:format(Format, Args)),
    re:replace(Text, <<"\\e\\[[0-9;]*m">>, <<>>, [global, {return, binary}]).

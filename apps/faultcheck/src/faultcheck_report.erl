%% @doc What a run prints, as lines, and its report in JSON.
-module(faultcheck_report).

-export([title/1, failure/1, summary/1, progress/4, shrinking_progress/2, searching_progress/3]).
-export([told/2, json/2]).

%% @doc `"Testing prop_stack:prop_push()"'.
-spec title({module(), atom()}) -> string().
title({Module, Property}) -> text("===> Testing ~tp:~tp()", [Module, Property]).

%% @doc All there is to know about a property that did not pass.
-spec failure(faultcheck_runner:outcome()) -> [string()].
failure(#{status := Status, property := {M, F}} = Outcome) ->
    Where =
        case Outcome of
            #{test := Test, size := Size} -> text(" in test ~b (size ~b)", [Test, Size]);
            _ -> ""
        end,
    [text("~ts: ~tp:~tp()~ts", [word(Status), M, F, Where])] ++
        reasons(Outcome) ++ counterexample(Outcome) ++ shrinking(Outcome) ++ stored(Outcome) ++
        origin(Outcome).

word(failed) -> "Failed";
word(flaky) -> "Flaky";
word(unstarted) -> "Not started";
word(error) -> "Error".

reasons(Outcome) ->
    [["  " | R] || R <- maps:get(reasons, Outcome, [])] ++
        [["  note: " | N] || N <- maps:get(notes, Outcome, [])].

counterexample(#{shrunk := Shrunk} = Outcome) ->
    Heading =
        case faultcheck_case:commands(Shrunk) of
            {ok, Commands} -> commands_heading(length(Commands), Outcome);
            none -> "  counterexample:"
        end,
    [Heading | [["    " | Line] || Line <- faultcheck_case:lines(Shrunk)]];
counterexample(_) ->
    [].

commands_heading(Length, #{original := Original}) ->
    case faultcheck_case:commands(Original) of
        {ok, Longer} when length(Longer) > Length ->
            text("  ~s, shrunk from ~b:", [count(Length), length(Longer)]);
        _ ->
            text("  ~s:", [count(Length)])
    end;
commands_heading(Length, _) ->
    text("  ~s:", [count(Length)]).

count(1) -> "1 command";
count(N) -> integer_to_list(N) ++ " commands".

shrinking(#{flaky := {Failed, Runs}}) ->
    [text("  flaky: failed ~b of ~b times when run again; not shrunk", [Failed, Runs])];
shrinking(#{shrink := #{tries := Tries, accepted := Accepted} = Shrink}) ->
    Minimal =
        case Shrink of
            #{stopped := none, minimal := true} -> "minimal";
            #{stopped := none} -> "not minimal";
            #{stopped := Limit} -> text("not minimal: stopped at ~s", [Limit])
        end,
    [text("  shrinking: ~b candidates, ~b accepted, ~s", [Tries, Accepted, Minimal])];
shrinking(#{shrinks := Shrinks}) ->
    [text("  shrinking: ~b steps", [Shrinks])];
shrinking(_) ->
    [].

stored(#{'case' := Dir} = Outcome) ->
    ["  stored in " ++ Dir, text("  replay: ~ts ~ts", [maps:get(replay, Outcome), Dir])] ++
        told(maps:get(told, Outcome, #{}), Outcome);
stored(_) ->
    [].

%% @doc What a model's report/2 told: the page to open, and how to watch the case.
-spec told(faultcheck_case:told(), #{'case' := file:filename(), atom() => term()}) -> [string()].
told(Told, #{'case' := Dir} = Outcome) ->
    [text("  report: ~ts", [filename:join(Dir, F)]) || {ok, F} <- [maps:find(report, Told)]] ++
        [
            text("  watch: ~ts~ts", [Watch, Dir])
         || {ok, Watch} <- [maps:find(watch, Outcome)], maps:get(watch, Told, false)
        ].

origin(#{seed := Seed, versions := Versions} = Outcome) ->
    [text("  seed ~b with ~ts", [Seed, faultcheck_versions:text(Versions)])] ++
        [["  repeat: " | Repeat] || {ok, Repeat} <- [maps:find(repeat, Outcome)]];
origin(_) ->
    [].

%% @doc The last lines of a run.
-spec summary([faultcheck_runner:outcome()]) -> [string()].
summary(Outcomes) ->
    Bad = [O || #{status := S} = O <- Outcomes, S =/= passed],
    Total = length(Outcomes),
    First = text("===> ~b/~b properties passed", [Total - length(Bad), Total]),
    case Bad of
        [] -> [First];
        _ ->
            Counts = lists:append([First | rest(Bad)]),
            [Counts, "===> Failed test cases:" | [summary_line(O) || O <- Bad]]
    end.

rest(Bad) ->
    Counts = [
        {Word, length([1 || #{status := S} <- Bad, S =:= Status])}
     || {Status, Word} <- [
            {failed, "failed"},
            {flaky, "flaky"},
            {error, "with errors"},
            {unstarted, "not started"}
        ]
    ],
    [text(", ~b ~s", [N, Word]) || {Word, N} <- Counts, N > 0].

summary_line(#{property := {M, F}, status := Status} = Outcome) ->
    Doc =
        case maps:get(doc, Outcome, "") of
            "" -> "";
            Text -> text(" (~ts)", [Text])
        end,
    text("~tp:~tp() -> ~ts~ts", [M, F, result(Status, Outcome), Doc]).

result(failed, #{long_result := true, shrunk := Shrunk}) -> text("~0tp", [Shrunk]);
result(failed, _) -> "false";
result(Status, _) -> atom_to_list(Status).

%% @doc One line on how far a long run is. Ms is the time since its beginning; Goal the number of
%% tests, or the milliseconds that it is to take.
-spec progress(
    {module(), atom()},
    Tests :: non_neg_integer(),
    Ms :: non_neg_integer(),
    Goal :: {tests, pos_integer()} | {ms, pos_integer()}
) -> string().
progress({_, Property}, Tests, Ms, Goal) ->
    Rate = Tests * 1000 / max(1, Ms),
    Left =
        case Goal of
            {tests, N} when Rate > 0 -> round(max(0, N - Tests) / Rate);
            {tests, _} -> 0;
            {ms, Until} -> max(0, Until - Ms) div 1000
        end,
    Of =
        case Goal of
            {tests, All} -> text(" of ~b", [All]);
            {ms, _} -> ""
        end,
    text("~tp: ~b~ts tests, ~b/s, ~b s to go", [Property, Tests, Of, round(Rate), Left]).

%% @doc One line on how far shrinking is.
-spec shrinking_progress({module(), atom()}, #{atom() => non_neg_integer()}) -> string().
shrinking_progress({_, Property}, #{tries := Tries, original := Original, length := Length}) ->
    text("~tp: shrinking, ~b candidates, ~b commands of ~b", [Property, Tries, Length, Original]).

%% @doc How far the guided search of a test is.
-spec searching_progress({module(), atom()}, non_neg_integer(), #{atom() => number() | worst}) ->
    string().
searching_progress({_, Property}, Test, #{runs := Runs, most := Most, nearest := Nearest}) ->
    text("~tp: test ~b, search: ~b runs of ~b, nearest ~p", [Property, Test, Runs, Most, Nearest]).

%% @doc The report for machines.
-spec json(faultcheck_versions:versions(), [faultcheck_runner:outcome()]) -> binary().
json(Versions, Outcomes) ->
    faultcheck_json:pretty(
        {object, [
            {versions, maps:map(fun(_, V) -> {text, V} end, Versions)},
            {passed, length([1 || #{status := passed} <- Outcomes])},
            {total, length(Outcomes)},
            {properties, [property(O) || O <- Outcomes]}
        ]}
    ).

property(#{property := {M, F}, status := Status, tests := Tests, ms := Ms} = O) ->
    {object,
        [{module, M}, {property, F}, {status, Status}, {tests, Tests}, {ms, Ms}] ++
            [{K, V} || K <- [seed, test, size], {ok, V} <- [maps:find(K, O)]] ++
            [{reasons, [{text, R} || R <- maps:get(reasons, O, [])]}] ++
            [{flaky, [Failed, Runs]} || {ok, {Failed, Runs}} <- [maps:find(flaky, O)]] ++
            [{'case', {text, Dir}} || {ok, Dir} <- [maps:find('case', O)]] ++
            [
                {report, {text, filename:join(Dir, File)}}
             || #{'case' := Dir, told := #{report := File}} <- [O]
            ] ++
            [{repeat, {text, Repeat}} || {ok, Repeat} <- [maps:find(repeat, O)]] ++
            [
                {counterexample, [{text, L} || L <- faultcheck_case:lines(Shrunk)]}
             || {ok, Shrunk} <- [maps:find(shrunk, O)]
            ]}.

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

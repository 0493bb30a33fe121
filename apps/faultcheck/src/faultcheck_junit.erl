%% @doc A JUnit XML report: a suite per module, a test case per property.
-module(faultcheck_junit).

-export([format/1]).

%% @doc The report of the outcomes, in the order given.
-spec format([faultcheck_runner:outcome()]) -> binary().
format(Outcomes) ->
    Modules = modules(Outcomes),
    Suites = [{M, [O || #{property := {Of, _}} = O <- Outcomes, Of =:= M]} || M <- Modules],
    unicode:characters_to_binary([
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
        open("testsuites", counts(Outcomes)),
        [suite(Module, Of) || {Module, Of} <- Suites],
        "</testsuites>\n"
    ]).

modules(Outcomes) ->
    lists:foldl(
        fun(#{property := {M, _}}, Ms) -> Ms ++ [M || not lists:member(M, Ms)] end, [], Outcomes
    ).

suite(Module, Outcomes) ->
    [
        "  ",
        open("testsuite", [{name, atom_to_list(Module)} | counts(Outcomes)]),
        [test(O) || O <- Outcomes],
        "  </testsuite>\n"
    ].

counts(Outcomes) ->
    Count = fun(Statuses) ->
        integer_to_list(length([O || #{status := S} = O <- Outcomes, lists:member(S, Statuses)]))
    end,
    Ms = lists:sum([Ms || #{ms := Ms} <- Outcomes]),
    [
        {tests, integer_to_list(length(Outcomes))},
        {failures, Count([failed, flaky])},
        {errors, Count([error, unstarted])},
        {time, seconds(Ms)}
    ].

test(#{property := {Module, Property}, ms := Ms, status := Status} = Outcome) ->
    Attributes = [
        {classname, atom_to_list(Module)}, {name, atom_to_list(Property)}, {time, seconds(Ms)}
    ],
    [
        "    ",
        open("testcase", Attributes),
        verdict(Status, Outcome),
        "    </testcase>\n"
    ].

verdict(passed, _) ->
    [];
verdict(Status, Outcome) when Status =:= failed; Status =:= flaky ->
    element("failure", Status, Outcome);
verdict(Status, Outcome) ->
    element("error", Status, Outcome).

element(Name, Status, Outcome) ->
    Reasons = maps:get(reasons, Outcome, []),
    First = hd(Reasons ++ [atom_to_list(Status)]),
    [
        "      ",
        string:trim(open(Name, [{message, First}, {type, atom_to_list(Status)}]), trailing),
        escape(lists:join($\n, faultcheck_report:failure(Outcome))),
        ["</", Name, ">\n"]
    ].

open(Name, Attributes) ->
    [$<, Name, [[$\s, atom_to_list(K), "=\"", escape(V), $"] || {K, V} <- Attributes], ">\n"].

seconds(Ms) -> io_lib:format("~.3f", [Ms / 1000]).

%% Characters that XML 1.0 has no way to write become a question mark.
escape(Text) -> [char(C) || C <- unicode:characters_to_list(Text)].

char($&) -> "&amp;";
char($<) -> "&lt;";
char($>) -> "&gt;";
char($") -> "&quot;";
char($\n) -> "&#10;";
char($\t) -> "&#9;";
char(C) when C < 32; C =:= 16#FFFE; C =:= 16#FFFF -> $?;
char(C) -> C.

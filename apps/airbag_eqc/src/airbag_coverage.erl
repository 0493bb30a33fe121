%% @doc Which statuses of E2E_P01Check each class of faults reaches (figures 3 to 5 of Paper I).
%%
%% `make coverage' runs each class with a library built for line coverage and makes an lcov report
%% of it; the table of statuses comes from the airbag's own counters.
-module(airbag_coverage).

-export([classes/0, run/3, reached/3, table/1, status/1]).
-export_type([class/0, row/0]).

-type class() :: no_faults | bit_flips | repetitions.
-type row() :: {class(), thesis | recommended, #{atom() => non_neg_integer()}}.

-define(SEED, 1).
-define(TESTS, 1000).

%% @doc The fault classes: figure 3, 4 and 5.
-spec classes() -> [class()].
classes() -> [no_faults, bit_flips, repetitions].

%% @doc Runs a class with the library given, writes its line counts, and appends the class's rows
%% to the table in the file.
-spec run(class(), Library :: file:filename(), StatusFile :: file:filename()) -> ok.
run(Class, Library, StatusFile) ->
    {ok, _} = application:ensure_all_started(c_bridge),
    ok = application:set_env(airbag_eqc, library, Library),
    ok = airbag_sut:default_transport(port),
    Rows = [{Class, C, reached(Class, C, ?TESTS)} || C <- [thesis, recommended]],
    Head = [head() || not filelib:is_file(StatusFile)],
    Foot = [["\n", note()] || Class =:= lists:last(classes())],
    file:write_file(StatusFile, [Head, [row(R) || R <- Rows], Foot], [append]).

%% @doc How often each status was seen in so many tests.
-spec reached(class(), thesis | recommended, pos_integer()) -> #{atom() => non_neg_integer()}.
reached(Class, Configuration, Tests) ->
    Airbag = airbag_options:new(#{configuration => Configuration, faults => faults(Class)}),
    airbag_experiment:in_state(Airbag, fun() ->
        _ = [airbag_experiment:test(Airbag, ?SEED, N) || N <- lists:seq(1, Tests)],
        ok = airbag_sut:flush_coverage(),
        airbag_sut:value_of(airbag_seen)
    end).

faults(no_faults) -> [];
faults(bit_flips) -> [bit_flip];
faults(repetitions) -> [repetition].

%% ---- the table ------------------------------------------------------------------------------

%% @doc The rows as a Markdown table, with the one deviation from the paper explained.
-spec table([row()]) -> iodata().
table(Rows) -> [head(), [row(R) || R <- Rows], "\n", note()].

%% @doc The AUTOSAR name of a member of airbag_seen.
-spec status(atom()) -> string().
status(ok) -> "OK";
status(no_new_data) -> "NONEWDATA";
status(wrong_crc) -> "WRONGCRC";
status(sync) -> "SYNC";
status(initial) -> "INITIAL";
status(repeated) -> "REPEATED";
status(ok_some_lost) -> "OKSOMELOST";
status(wrong_sequence) -> "WRONGSEQUENCE";
status(rejected) -> "counter 15".

columns() ->
    [
        ok,
        no_new_data,
        wrong_crc,
        sync,
        initial,
        repeated,
        ok_some_lost,
        wrong_sequence,
        rejected
    ].

head() ->
    [
        ["| faults | configuration |", [[" ", status(S), " |"] || S <- columns()], "\n"],
        ["|---|---|", ["---:|" || _ <- columns()], "\n"]
    ].

row({Class, Configuration, Seen}) ->
    Cells = [[" ", cell(maps:get(S, Seen)), " |"] || S <- columns()],
    ["| ", class(Class), " | ", atom_to_list(Configuration), " |", Cells, "\n"].

cell(0) -> "-";
cell(N) -> integer_to_list(N).

class(no_faults) -> "none (figure 3)";
class(bit_flips) -> "bit flips (figure 4)";
class(repetitions) -> "repetitions (figure 5)".

note() ->
    [
        "REPEATED without faults is the one deviation from figure 3: with zeroed states the very\n",
        "first packet has counter 0, and the receiver's last valid counter is 0 as well. The\n",
        "recommended configuration starts with INITIAL instead.\n"
    ].

-module(airbag_coverage_tests).
-include_lib("eunit/include/eunit.hrl").

-define(TESTS, 200).

coverage_test_() ->
    {setup, fun airbag_test_sut:port/0, fun(_) -> ok end, [
        {"statuses of each class", {timeout, 60, fun statuses/0}},
        {"the table grows by each class", {timeout, 60, fun table/0}}
    ]}.

reached(Class, Configuration) ->
    Seen = airbag_coverage:reached(Class, Configuration, ?TESTS),
    lists:sort([Status || {Status, N} <- maps:to_list(Seen), N > 0]).

%% Figures 3 to 5 of the paper, with the first packet's REPEATED or INITIAL.
statuses() ->
    ?assertEqual([no_new_data, ok, repeated], reached(no_faults, thesis)),
    ?assertEqual([initial, no_new_data, ok], reached(no_faults, recommended)),
    ?assertEqual([no_new_data, ok, repeated], reached(repetitions, thesis)),
    ?assertEqual([initial, no_new_data, ok, repeated], reached(repetitions, recommended)),
    [?assert(lists:member(wrong_crc, reached(bit_flips, C))) || C <- [thesis, recommended]].

table() ->
    File = cb_files:fresh_name("airbag_coverage", ".md"),
    Library = airbag_sut:library(),
    try
        [ok = airbag_coverage:run(C, Library, File) || C <- airbag_coverage:classes()],
        {ok, Text} = file:read_file(File),
        {match, Rows} = re:run(Text, "^\\| [a-z ]+ \\(figure [345]\\)", [global, multiline]),
        ?assertEqual(6, length(Rows))
    after
        _ = file:delete(File),
        application:unset_env(airbag_eqc, library)
    end.

-module(e2e_report_tests).
-include_lib("eunit/include/eunit.hrl").

report_test_() -> {"a small report is complete", {timeout, 120, fun report/0}}.

report() ->
    Dir = cb_files:fresh_name("e2e_report", ""),
    try
        ok = e2e_report:run(Dir, #{trials => 60, seed => 1, flips => 4, long => false}),
        {ok, Text} = file:read_file(filename:join(Dir, "e2e.md")),
        Has = fun(Part) -> ?assertNotEqual(nomatch, binary:match(Text, Part)) end,
        %% e2e.md section 9
        Has(<<"| P01 | BOTH, ID 0x0123 | 4 | 3 | 18 | 4960 |">>),
        Has(<<"| P04 |  | 12 | above 4 | 0 |">>),
        %% a counter sees one repetition and one loss, whatever the profile
        Has(all_profiles(<<"repetition: the packet before comes again">>, <<"REPEATED">>)),
        Has(all_profiles(<<"loss of 1 packet">>, <<"OKSOMELOST">>)),
        Has(all_profiles(<<"loss of 5 packets">>, <<"WRONGSEQUENCE">>)),
        Has(all_profiles(<<"delay: nothing comes when a packet is due">>, <<"NONEWDATA">>)),
        Has(<<"in 60 trials each with seed 1.">>)
    after
        _ = file:del_dir_r(Dir)
    end.

all_profiles(Fault, Status) ->
    Cells = [[" | ", Status] || _ <- e2e_packet:profiles()],
    iolist_to_binary(["| ", Fault, Cells, " |"]).

%% The same seed gives the same counts, another seed others.
seeds_test() ->
    {ok, _} = application:ensure_all_started(c_bridge),
    Config = e2e_configuration:example(p01),
    Run = fun(Seed) -> e2e_fault_trial:run(random, {p01, Config, 4}, 2000, Seed) end,
    try
        #{statuses := Statuses} = First = Run(1),
        ?assertEqual(First, Run(1)),
        ?assertNotEqual(First, Run(2)),
        ?assertEqual(2000, lists:sum(maps:values(Statuses)))
    after
        e2e_sut:stop()
    end.

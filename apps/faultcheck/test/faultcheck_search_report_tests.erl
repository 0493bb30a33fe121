-module(faultcheck_search_report_tests).
-include_lib("eunit/include/eunit.hrl").

%% Two carts: one with rails short enough for chance, one so long that chance finds nothing.
worlds() ->
    [world("near", 60.0, 6, 200), world("far", 150.0, 4, 60)].

world(Name, End, Repetitions, Cap) ->
    Columns = faultcheck_search_trial:columns(),
    #{
        name => Name,
        label => "a cart, rails of " ++ float_to_list(End, [short]),
        model => cart_model,
        search => #{time => 20, begin_test => fun() -> cart_model:reset(End) end},
        caps => maps:from_list([{C, Cap} || C <- Columns]),
        repetitions => maps:from_list([{C, Repetitions} || C <- Columns])
    }.

settings(Workers) ->
    #{
        title => "Carts",
        unit => "runs of 20 s",
        first_seed => 5000,
        workers => Workers,
        start => fun() -> ok end,
        stop => fun() -> ok end,
        code => test,
        progress => fun(_) -> ok end
    }.

report(Dir, Workers) ->
    ok = faultcheck_search_report:run(Dir, worlds(), settings(Workers)),
    Read = fun(Name) ->
        {ok, Text} = file:read_file(filename:join(Dir, Name)),
        Text
    end,
    {ok, Json} = faultcheck_json:decode(Read("search.json")),
    {Read("search.md"), Json}.

report_test_() ->
    {timeout, 120, fun() ->
        Dir = cb_files:fresh_name("faultcheck-search", ""),
        Other = cb_files:fresh_name("faultcheck-search", ""),
        try
            {Text, Json} = report(Dir, 1),
            complete(Text, Json, Dir),
            {SameText, SameJson} = report(Other, 2),
            ?assertEqual(Text, SameText),
            ?assertEqual(without_times(Json), without_times(SameJson))
        after
            _ = file:del_dir_r(Dir),
            _ = file:del_dir_r(Other)
        end
    end}.

complete(Text, #{<<"trials">> := Trials, <<"worlds">> := [Near, Far]}, Dir) ->
    ?assertEqual(4 * 6 + 4 * 4, length(Trials)),
    Charts = filelib:wildcard("*", filename:join(Dir, "search")),
    ?assertEqual(["far.svg", "near.svg"], Charts),
    #{<<"columns">> := #{<<"uniform_random">> := Random}} = Near,
    ?assertMatch(#{<<"cap">> := 200, <<"repetitions">> := 6, <<"found">> := 6}, Random),
    %% the number of runs is that of the trials
    Runs = [R || #{<<"world">> := <<"near">>, <<"column">> := <<"uniform_random">>,
                   <<"runs">> := R} <- Trials],
    #{<<"runs">> := #{<<"mean">> := Mean}} = Random,
    ?assertEqual(lists:sum(Runs) / 6, Mean),
    #{<<"columns">> := #{<<"uniform_random">> := None}} = Far,
    ?assertMatch(#{<<"found">> := 0, <<"runs">> := #{<<"median">> := null}}, None),
    ?assertMatch(#{<<"chance_over_guided">> := #{<<"runs_mean">> := null}}, Far),
    Has = fun(Part) -> ?assertNotEqual(nomatch, binary:match(Text, Part)) end,
    Has(<<"| uniform random | 6 | 200 | 6 (0 % censored) |">>),
    Has(<<"uniform random: 0 failures in 240 runs, so one in infinitely many (95 %: 65.1 to">>),
    Has(<<"Shrunk failures:">>),
    Has(<<" roll">>),
    Has(<<"Seeds: 5000 + ">>),
    Has(<<"Aim: at most twice as slow as by chance (mean)">>).

without_times(#{<<"trials">> := Trials} = Json) ->
    Json#{<<"trials">> := [maps:remove(<<"ms">>, T) || T <- Trials]}.

seeds_are_stated_and_differ_test() ->
    Columns = faultcheck_search_trial:columns(),
    Seeds = [faultcheck_search_trial:seed({7, W}, C, R)
             || W <- [0, 1], C <- Columns, R <- [1, 2, 9999]],
    ?assertEqual(length(Seeds), length(lists:usort(Seeds))),
    ?assertEqual(7 + 100000 + 20000 + 3, faultcheck_search_trial:seed({7, 1}, uniform_guided, 3)).

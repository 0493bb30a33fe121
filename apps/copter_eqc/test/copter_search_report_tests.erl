-module(copter_search_report_tests).
-include_lib("eunit/include/eunit.hrl").

%% A world where chance needs a dozen tests, and one where it finds nothing in so few.
the_report_is_the_same_with_two_workers_test_() ->
    {timeout, 120, fun() ->
        Trials = [trials(Workers) || Workers <- [1, 2]],
        ?assertEqual(hd(Trials), lists:last(Trials)),
        Found = fun(World) -> [T || #{<<"world">> := W, <<"found">> := true} = T <- hd(Trials),
                                    W =:= World] end,
        ?assertNotEqual([], Found(<<"W2">>)),
        ?assertEqual([], Found(<<"W7">>))
    end}.

trials(Workers) ->
    Dir = cb_files:fresh_name("search_report", ""),
    try
        ok = copter_search_report:run(Dir, (copter_search_report:settings())#{
            worlds := [{'W2', [1, 0, 0, 1], 60, 60}, {'W7', [1, 0, 0, 1], 10, 10}],
            workers := Workers,
            progress := fun(_) -> ok end
        }),
        {ok, Text} = file:read_file(filename:join(Dir, "search.json")),
        {ok, #{<<"trials">> := Trials}} = faultcheck_json:decode(Text),
        [maps:remove(<<"ms">>, Trial) || Trial <- Trials]
    after
        file:del_dir_r(Dir)
    end.

-module(faultcheck_enumerate_tests).
-include_lib("eunit/include/eunit.hrl").

space() -> faultcheck_space:items(lists:seq(1, 1000)).

%% Multiples of 7 are findings; odd and even numbers are counted.
check(N, _Context) ->
    {#{N rem 2 => 1}, [N || N rem 7 =:= 0]}.

expected_found() -> lists:seq(7, 994, 7).

in_temporary_file(Test) ->
    Dir = cb_files:fresh_name("faultcheck_enumerate", ""),
    File = filename:join(Dir, integer_to_list(erlang:unique_integer([positive]))),
    try
        Test(File)
    after
        _ = file:delete(File),
        _ = file:del_dir(Dir)
    end.

every_item_is_checked_once_test() ->
    {ok, Result} = faultcheck_enumerate:run(space(), fun check/2, #{}),
    #{counts := Counts, found := Found, done := 1000, total := 1000} = Result,
    ?assertEqual(#{0 => 500, 1 => 500}, Counts),
    ?assertEqual(expected_found(), Found).

the_result_does_not_depend_on_the_number_of_workers_or_the_chunk_test() ->
    Run = fun(Workers, Chunk) ->
        {ok, Result} = faultcheck_enumerate:run(space(), fun check/2, #{
            workers => Workers, chunk => Chunk
        }),
        maps:with([counts, found], Result)
    end,
    One = Run(1, 64),
    [?assertEqual(One, Run(W, C)) || W <- [2, 3, 7], C <- [1, 64, 999, 5000]].

an_empty_space_is_done_at_once_test() ->
    {ok, #{counts := Counts, found := [], done := 0, total := 0}} =
        faultcheck_enumerate:run(faultcheck_space:items([]), fun check/2, #{workers => 3}),
    ?assertEqual(#{}, Counts).

each_worker_has_a_context_of_its_own_and_stops_it_test() ->
    Test = self(),
    Options = #{
        workers => 2,
        chunk => 10,
        start => fun() -> Test ! {started, self()}, self() end,
        stop => fun(Context) -> Test ! {stopped, Context} end
    },
    Check = fun(_, Context) -> {#{Context =:= self() => 1}, []} end,
    {ok, #{counts := Counts}} = faultcheck_enumerate:run(space(), Check, Options),
    ?assertEqual(#{true => 1000}, Counts),
    Started = collect(started),
    ?assertEqual(2, length(Started)),
    ?assertEqual(lists:sort(Started), lists:sort(collect(stopped))).

collect(Tag) ->
    receive
        {Tag, Pid} -> [Pid | collect(Tag)]
    after 0 -> []
    end.

progress_estimates_from_the_speed_of_this_run_test() ->
    Test = self(),
    Clock = fun() -> counter() end,
    Options = #{
        name => squares,
        chunk => 250,
        clock => Clock,
        progress_ms => 0,
        progress => fun(P) -> Test ! {progress, P} end
    },
    {ok, _} = faultcheck_enumerate:run(space(), fun check/2, Options),
    Reports = collect(progress),
    ?assertEqual([250, 500, 750, 1000], [D || #{done := D} <- Reports]),
    %% the clock goes on by 100 a reading: after the first quarter 100 ms, so 300 are left
    ?assertMatch([#{elapsed_ms := 100, remaining_ms := 300, name := squares} | _], Reports),
    ?assertMatch(#{remaining_ms := 0}, lists:last(Reports)).

counter() ->
    Now = case get(counter) of undefined -> 0; N -> N + 100 end,
    put(counter, Now),
    Now.

a_stopped_run_goes_on_from_its_state_file_test() ->
    in_temporary_file(fun(File) ->
        Options = #{name => t, state_file => File, chunk => 10},
        {stopped, #{done := 300}} =
            faultcheck_enumerate:run(space(), fun check/2, Options#{stop_after => 300}),
        Checked = counters:new(1, []),
        Counting = fun(N, C) -> counters:add(Checked, 1, 1), check(N, C) end,
        {ok, Result} = faultcheck_enumerate:run(space(), Counting, Options#{workers => 2}),
        ?assertEqual(700, counters:get(Checked, 1)),
        ?assertMatch(#{counts := #{0 := 500, 1 := 500}, done := 1000}, Result),
        ?assertEqual(expected_found(), maps:get(found, Result))
    end).

a_line_cut_short_by_a_kill_is_done_again_test() ->
    in_temporary_file(fun(File) ->
        Options = #{name => t, state_file => File, chunk => 100},
        {ok, Whole} = faultcheck_enumerate:run(space(), fun check/2, Options),
        {ok, Text} = file:read_file(File),
        ok = file:write_file(File, binary:part(Text, 0, byte_size(Text) - 7)),
        {ok, Again} = faultcheck_enumerate:run(space(), fun check/2, Options),
        ?assertEqual(maps:with([counts, found], Whole), maps:with([counts, found], Again))
    end).

a_state_file_of_another_enumeration_is_refused_test() ->
    in_temporary_file(fun(File) ->
        Options = #{name => one, state_file => File},
        {ok, _} = faultcheck_enumerate:run(space(), fun check/2, Options),
        {error, Reason} =
            faultcheck_enumerate:run(space(), fun check/2, Options#{name => other}),
        Line = lists:flatten(faultcheck_enumerate:format_error(Reason)),
        ?assertNotEqual(nomatch, string:find(Line, File)),
        ?assertNotEqual(nomatch, string:find(Line, "belongs to"))
    end).

a_damaged_state_file_is_refused_with_the_line_test() ->
    in_temporary_file(fun(File) ->
        Options = #{name => t, state_file => File},
        {ok, _} = faultcheck_enumerate:run(space(), fun check/2, Options),
        {ok, Text} = file:read_file(File),
        [First, Rest] = binary:split(Text, <<"\n">>),
        ok = file:write_file(File, [First, "\nnonsense\n", Rest]),
        ?assertEqual(
            {error, {state_file, File, {line, 2}}},
            faultcheck_enumerate:run(space(), fun check/2, Options)
        )
    end).

a_directory_as_state_file_is_an_error_test() ->
    Dir = cb_files:temporary_dir(),
    {error, Reason} = faultcheck_enumerate:run(space(), fun check/2, #{state_file => Dir}),
    ?assertEqual({state_file, Dir, eisdir}, Reason).

a_check_that_crashes_is_reported_with_its_item_test() ->
    Check = fun
        (500, _) -> error(oops);
        (N, C) -> check(N, C)
    end,
    {error, {check, 500, error, oops, _} = Reason} =
        faultcheck_enumerate:run(space(), Check, #{workers => 2}),
    ?assertEqual(
        "the check of item 500 ended with error oops",
        lists:flatten(faultcheck_enumerate:format_error(Reason))
    ).

a_worker_that_cannot_start_is_reported_test() ->
    Start = fun() -> throw(no_library) end,
    ?assertMatch(
        {error, {start, throw, no_library, _}},
        faultcheck_enumerate:run(space(), fun check/2, #{start => Start})
    ).

a_killed_worker_is_reported_and_the_others_end_test() ->
    Test = self(),
    Check = fun
        (1, _) ->
            exit(self(), kill),
            receive never -> ok end;
        (_, _) ->
            Test ! {worker, self()},
            {#{}, []}
    end,
    ?assertEqual(
        {error, {worker, killed}},
        faultcheck_enumerate:run(space(), Check, #{workers => 2, chunk => 1})
    ),
    ?assertEqual([], [P || P <- lists:usort(collect(worker)), is_process_alive(P)]).

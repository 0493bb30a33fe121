%% What only an OS process of its own can give: crashes, hangs, exits are errors.
-module(cb_port_tests).

-include_lib("eunit/include/eunit.hrl").

faulty(Options) -> cb_sut:start("faulty.c", [{timeout, 3000} | Options]).

with_faulty(Options, Test) ->
    Lib = faulty(Options),
    try
        Test(Lib)
    after
        cb:stop(Lib)
    end.

in_each_reset(Test) ->
    [
        {atom_to_list(Reset), {timeout, 30, fun() -> with_faulty([{reset, Reset}], Test) end}}
     || Reset <- [fork, respawn, snapshot, reload]
    ].

crashes_test_() -> in_each_reset(fun crashes/1).

crashes(L) ->
    {crash, Null} = cb_sut:reason(fun() -> cb:call(L, follow, [null]) end),
    ?assertMatch(#{signal := sigsegv, addr := 0, in := {follow, [null]}, coredump := none}, Null),
    ?assertMatch([{<<"follow">>, _, 14} | _], maps:get(frames, Null)),
    [{_, File, _} | _] = maps:get(frames, Null),
    ?assertEqual(<<"faulty.c">>, filename:basename(File)),
    ?assertEqual({crash, Null}, cb:last_crash(L)),
    %% There is nothing to call now; a restart brings it back.
    ?assertMatch({not_running, {crash, _}}, cb_sut:reason(fun() -> cb:call(L, step, []) end)),
    ok = cb:restart(L),
    ?assertEqual(1, cb:call(L, step, [])),
    ?assertMatch(
        {crash, #{signal := sigfpe}}, cb_sut:reason(fun() -> cb:call(L, divide, [1, 0]) end)
    ),
    ok = cb:restart(L),
    ?assertMatch(
        {crash, #{signal := sigabrt}}, cb_sut:reason(fun() -> cb:call(L, give_up, []) end)
    ),
    {crash, #{frames := Frames}} = cb:last_crash(L),
    ?assert(lists:keymember(<<"give_up">>, 1, Frames)),
    ok = cb:restart(L),
    ?assertEqual(1, cb:call(L, step, [])).

exits_test_() ->
    in_each_reset(fun(L) ->
        ?assertMatch(
            {exited, 3, #{in := {leave, [3]}}}, cb_sut:reason(fun() -> cb:call(L, leave, [3]) end)
        ),
        ok = cb:restart(L),
        ?assertMatch({exited, 0, _}, cb_sut:reason(fun() -> cb:call(L, leave, [0]) end)),
        ok = cb:restart(L),
        ?assertEqual(1, cb:call(L, step, []))
    end).

hangs_test_() ->
    [
        {atom_to_list(Reset), {timeout, 30, fun() -> hangs(Reset) end}}
     || Reset <- [fork, respawn, snapshot]
    ].

hangs(Reset) ->
    Lib = cb_sut:start("faulty.c", [{timeout, 100}, {reset, Reset}]),
    Process = cb:call(Lib, process, []),
    {timeout, 100, Details} = cb_sut:reason(fun() -> cb:call(Lib, hang, []) end),
    ?assertMatch(#{in := {hang, []}, frames := [_ | _]}, Details),
    #{frames := Frames} = Details,
    ?assert(lists:keymember(<<"spin">>, 1, Frames)),
    gone = cb_sut:await_gone(Process),
    ok = cb:restart(Lib),
    ?assertEqual(1, cb:call(Lib, step, [])),
    ok = cb:stop(Lib).

a_stack_overflow_is_a_crash_with_few_frames_test() ->
    with_faulty([], fun(L) ->
        {crash, #{signal := sigsegv, frames := Frames}} =
            cb_sut:reason(fun() -> cb:call(L, recurse, [1]) end),
        ?assert(length(Frames) < 1000),
        ?assertMatch([{<<"recurse">>, _, _} | _], Frames)
    end).

last_words_are_in_the_report_test() ->
    with_faulty([], fun(L) ->
        {crash, #{log := Log, addr := 16}} =
            cb_sut:reason(fun() -> cb:call(L, talk_and_crash, []) end),
        ?assertNotEqual(nomatch, binary:match(Log, <<"last words">>)),
        %% The words of one crash are not those of the next.
        ok = cb:restart(L),
        {crash, #{log := Next}} = cb_sut:reason(fun() -> cb:call(L, follow, [null]) end),
        ?assertEqual(nomatch, binary:match(Next, <<"last words">>))
    end).

a_crash_in_a_batch_is_reported_test() ->
    with_faulty([], fun(L) ->
        Calls = [{step, []}, {follow, [null]}],
        ?assertMatch(
            {crash, #{in := {call_batch, Calls}}},
            cb_sut:reason(fun() -> cb:call_batch(L, Calls) end)
        )
    end).

kill_in_mid_call_test_() ->
    [
        {atom_to_list(Reset), {timeout, 30, fun() -> kill_in_mid_call(Reset) end}}
     || Reset <- [fork, respawn]
    ].

%% kill -9 from outside, of whoever serves, while it is in a call.
kill_in_mid_call(Reset) ->
    Lib = cb_sut:start("faulty.c", [{reset, Reset}, {owner, none}]),
    Process = cb:call(Lib, process, []),
    Test = self(),
    Hang = fun() -> cb:call(Lib, hang, []) end,
    Caller = spawn_link(fun() -> Test ! {self(), cb_sut:reason(Hang)} end),
    await_running(Process),
    ok = cb_nif:kill(Process, 9),
    receive
        {Caller, Reason} ->
            ?assertMatch({crash, #{signal := sigkill, in := {hang, []}}}, Reason)
    end,
    ok = cb:restart(Lib),
    ?assertEqual(1, cb:call(Lib, step, [])),
    ok = cb:stop(Lib).

%% The C function spins: the process uses processor time.
await_running(Process) ->
    {ok, Stat} = file:read_file(["/proc/", integer_to_list(Process), "/stat"]),
    [_, Fields] = binary:split(Stat, <<") ">>),
    case binary:split(Fields, <<" ">>, [global]) of
        [<<"R">> | _] -> running;
        _ -> await_running(Process)
    end.

%% kill -9 of the program between two calls.
kill_between_calls_test() ->
    with_faulty([{reset, respawn}], fun(L) ->
        Process = cb:call(L, process, []),
        ok = cb_nif:kill(Process, 9),
        gone = cb_sut:await_gone(Process),
        ?assertMatch(
            {Tag, _} when Tag =:= crash orelse Tag =:= exited,
            setelement_2(cb_sut:reason(fun() -> cb:call(L, step, []) end))
        ),
        ok = cb:restart(L),
        ?assertEqual(1, cb:call(L, step, []))
    end).

setelement_2(Reason) -> {element(1, Reason), Reason}.

nothing_is_left_behind_test() ->
    Lib = faulty([{reset, fork}]),
    Child = cb:call(Lib, process, []),
    ok = cb:stop(Lib),
    gone = cb_sut:await_gone(Child),
    ?assertEqual({not_running, stopped}, cb_sut:reason(fun() -> cb:call(Lib, step, []) end)),
    ?assertEqual(ok, cb:stop(Lib)).

the_end_of_the_owner_stops_it_test() ->
    Test = self(),
    {Owner, Monitor} = spawn_monitor(fun() ->
        Lib = faulty([{reset, respawn}]),
        Test ! {process, cb:call(Lib, process, [])},
        receive
            finish -> ok
        end
    end),
    Process =
        receive
            {process, P} -> P
        end,
    ?assert(cb_sut:alive(Process)),
    Owner ! finish,
    receive
        {'DOWN', Monitor, process, Owner, normal} -> ok
    end,
    gone = cb_sut:await_gone(Process).

in_another_process(Fun) ->
    Test = self(),
    Process = spawn_link(fun() -> Test ! {self(), Fun()} end),
    receive
        {Process, Value} -> Value
    end.

a_library_without_an_owner_is_for_all_processes_test() ->
    with_faulty([{owner, none}], fun(L) ->
        Step = fun() ->
            ok = cb:attach(L),
            cb:call(sut_faulty, step, [])
        end,
        ?assertEqual(1, in_another_process(Step)),
        ?assertEqual(2, in_another_process(Step)),
        ?assertEqual(3, cb:call(L, step, []))
    end).

otherwise_it_is_for_the_process_that_started_it_test() ->
    Test = self(),
    with_faulty([], fun(L) ->
        Step = fun() -> cb_sut:reason(fun() -> cb:call(L, step, []) end) end,
        ?assertEqual({other_process, Test}, in_another_process(Step)),
        ?assertEqual(1, cb:call(L, step, []))
    end).

a_keeper_survives_a_crash_test() ->
    with_faulty([{owner, none}, {reset, respawn}], fun(L) ->
        ?assertMatch({crash, _}, cb_sut:reason(fun() -> cb:call(L, follow, [null]) end)),
        ?assertMatch({crash, _}, cb:last_crash(L)),
        ok = cb:restart(L),
        ?assertEqual(1, cb:call(L, step, []))
    end).

%% Whoever holds the port may be killed while the C code hangs.
a_killed_holder_leaves_nothing_behind_test_() ->
    [
        {lists:concat([Kind, " ", Reset]), fun() -> killed_holder(Kind, Reset) end}
     || Kind <- [own, shared], Reset <- [fork, respawn]
    ].

killed_holder(Kind, Reset) ->
    Test = self(),
    {Holder, Monitor} = spawn_monitor(fun() ->
        Owner = maps:get(Kind, #{own => self(), shared => none}),
        Lib = faulty([{reset, Reset}, {owner, Owner}, {timeout, infinity}]),
        Test ! {process, cb:call(Lib, process, []), holder(Kind, Lib)},
        cb_sut:reason(fun() -> cb:call(Lib, hang, []) end)
    end),
    receive
        {process, Process, Held} ->
            await_running(Process),
            exit(Held, kill),
            gone = cb_sut:await_gone(Process)
    end,
    receive
        {'DOWN', Monitor, process, Holder, _} -> ok
    end.

holder(own, _) -> self();
%% The keeper is the only process that talks to the port program.
holder(shared, Lib) -> element(4, Lib).

thread_local_state_can_be_read_and_set_test() ->
    Lib = cb_sut:start("state.c", []),
    _ = cb:call(Lib, touch, []),
    ?assertEqual(1, cb:value_of(Lib, in_thread)),
    ok = cb:set(Lib, in_thread, 5),
    ?assertEqual(5, cb:call(Lib, thread_value, [])),
    %% The dynamic linker knows only what is exported.
    ?assertEqual(
        {not_accessible, private_to_thread, thread_local},
        cb_sut:reason(fun() -> cb:value_of(Lib, private_to_thread) end)
    ),
    ok = cb:stop(Lib).

the_log_can_be_kept_test() ->
    Log = cb_files:fresh_name("cb_port_tests", ".log"),
    Lib = cb_sut:start("printer.c", [{log, Log}]),
    cb:call(Lib, say, [<<"kept">>]),
    ?assertEqual(2, cb:call(Lib, say_bytes, [])),
    ok = cb:stop(Lib),
    {ok, Text} = file:read_file(Log),
    ok = file:delete(Log),
    ?assertNotEqual(nomatch, binary:match(Text, <<"out: kept">>)),
    ?assertNotEqual(nomatch, binary:match(Text, <<"err: kept">>)).

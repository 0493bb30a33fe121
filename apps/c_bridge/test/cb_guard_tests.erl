-module(cb_guard_tests).

-include_lib("eunit/include/eunit.hrl").

shell(Command) -> shell(Command, #{log => "/dev/null"}).

shell(Command, Options) ->
    {ok, G} = cb_guard:start("/bin/sh", ["-c", Command], Options),
    G.

the_exit_status_is_told_test() ->
    G = shell("exit 7"),
    ?assertEqual({ended, {exit, 7}}, cb_guard:next_event(G, 5000)),
    ok = cb_guard:close(G).

a_signal_is_told_test() ->
    G = shell("kill -SEGV $$"),
    ?assertEqual({ended, {signal, 11}}, cb_guard:next_event(G, 5000)),
    ok = cb_guard:close(G).

what_is_printed_goes_to_the_log_test() ->
    Log = cb_files:fresh_name("cb_guard_tests", ".log"),
    G = shell("echo out; echo err >&2", #{log => Log}),
    ?assertEqual({ended, {exit, 0}}, cb_guard:next_event(G, 5000)),
    ?assertEqual({ok, <<"out\nerr\n">>}, file:read_file(Log)),
    ok = file:delete(Log).

%% cat copies the channel: what is sent comes back.
packets_pass_test() ->
    G = shell("exec cat <&3 >&4"),
    ok = cb_guard:send(G, <<"packet">>),
    ?assertEqual({data, <<"packet">>}, cb_guard:next_event(G, 5000)),
    ok = cb_guard:close(G).

kill_ends_the_process_and_its_children_test() ->
    G = shell("sleep 1000 & printf '\\000\\000\\000\\010%8d' $! >&4; sleep 1000"),
    {data, Text} = cb_guard:next_event(G, 5000),
    gone_after_kill(G, Text).

gone_after_kill(G, Text) ->
    Child = binary_to_integer(string:trim(Text)),
    ?assert(cb_sut:alive(Child)),
    ok = cb_guard:kill(G),
    ?assertEqual({ended, {signal, 9}}, cb_guard:next_event(G, 5000)),
    gone = cb_sut:await_gone(Child),
    %% Nothing happens to what has ended.
    ok = cb_guard:kill(G),
    ok = cb_guard:send(G, <<"late">>),
    ok = cb_guard:close(G).

%% kill -9 of the guard itself.
the_process_dies_with_its_guard_test() ->
    G = shell("printf '\\000\\000\\000\\010%8d' $$ >&4; exec sleep 1000"),
    {data, Text} = cb_guard:next_event(G, 5000),
    ok = cb_nif:kill(cb_guard:os_pid(G), 9),
    gone = cb_sut:await_gone(binary_to_integer(string:trim(Text))),
    ok = cb_guard:close(G).

the_environment_and_directory_are_those_asked_for_test() ->
    G = shell("test \"$CB_X:$(pwd)\" = yes:/", #{
        log => "/dev/null", env => [{"CB_X", "yes"}], cd => "/"
    }),
    ?assertEqual({ended, {exit, 0}}, cb_guard:next_event(G, 5000)).

a_missing_program_is_an_error_test() ->
    ?assertMatch(
        {error, {load, "/no/such/program", {dlerror, _}}},
        cb_guard:start("/no/such/program", [], #{})
    ).

%% A child VM answers over fds 3 and 4 while it prints on 1.
a_child_vm_has_a_channel_test_() ->
    {timeout, 30, fun() ->
        Program =
            "P = cb_guard:child_channel(), io:format(\"noise~n\"), "
            "receive {P, {data, D}} -> port_command(P, [<<\"got \">>, D]) end, "
            "receive {P, eof} -> ok end, halt(0).",
        Erl = filename:join([code:root_dir(), "bin", "erl"]),
        Ebin = filename:dirname(code:which(cb_guard)),
        Args = ["-noinput", "-pa", Ebin, "-eval", Program],
        {ok, G} = cb_guard:start(Erl, Args, #{log => "/dev/null"}),
        ok = cb_guard:send(G, <<"hello">>),
        ?assertEqual({data, <<"got hello">>}, cb_guard:next_event(G, 20000)),
        ok = cb_guard:close(G)
    end}.

-module(cb_crash_tests).

-include_lib("eunit/include/eunit.hrl").

log() ->
    <<"before\n"
      "@c_bridge signal 11 SIGSEGV code 1 addr 0x10 pc 0x7f0012341139\n"
      "@c_bridge frame /opt/my libs/libx.so 0x1139\n"
      "@c_bridge frame /opt/my libs/libx.so 0x1150\n"
      "@c_bridge skipped 12\n"
      "@c_bridge frame /usr/lib/x86_64-linux-gnu/libffi.so.8 0x7e2e\n"
      "@c_bridge frame /opt/priv/c_bridge_port 0x4444\n"
      "after\n">>.

a_signal_names_its_place_test() ->
    Finding = cb_crash:examine({signal, 11}, log()),
    %% Below the call there are only libffi and the port program.
    Module = <<"/opt/my libs/libx.so">>,
    ?assertEqual(
        [{Module, 16#1139, true}, {Module, 16#1150, false}], cb_crash:addresses(Finding)
    ),
    Frames = [{<<"follow">>, <<"faulty.c">>, 9}],
    ?assertEqual(
        {crash, #{
            signal => sigsegv,
            addr => 16,
            in => {follow, [null]},
            frames => Frames,
            log => <<"before\nafter\n">>,
            coredump => none
        }},
        cb_crash:reason(Finding, {follow, [null]}, Frames)
    ).

a_kill_from_outside_leaves_no_frames_test() ->
    Finding = cb_crash:examine({signal, 9}, <<>>),
    ?assertEqual([], cb_crash:addresses(Finding)),
    ?assertMatch(
        {crash, #{signal := sigkill, addr := unknown, frames := []}},
        cb_crash:reason(Finding, {f, []}, [])
    ).

an_abort_has_no_address_test() ->
    Log = <<"@c_bridge signal 6 SIGABRT code -6 addr 0x3e8 pc 0x7f00\n">>,
    ?assertMatch(
        {crash, #{signal := sigabrt, addr := unknown}},
        cb_crash:reason(cb_crash:examine({signal, 6}, Log), f, [])
    ).

an_exit_gives_its_status_test() ->
    Finding = cb_crash:examine({exit, 3}, <<"bye\n">>),
    ?assertEqual(
        {exited, 3, #{in => f, log => <<"bye\n">>}}, cb_crash:reason(Finding, f, [])
    ).

an_unseen_end_is_told_by_the_log_test() ->
    ?assertMatch(
        {crash, #{signal := sigsegv}},
        cb_crash:reason(cb_crash:examine(unknown, log()), f, [])
    ),
    ?assertMatch(
        {exited, unknown, _}, cb_crash:reason(cb_crash:examine(unknown, <<"x">>), f, [])
    ).

a_timeout_shows_where_it_hangs_test() ->
    Finding = cb_crash:examine({timeout, 200}, log()),
    ?assertEqual(2, length(cb_crash:addresses(Finding))),
    ?assertMatch(
        {timeout, 200, #{in := {hang, []}, frames := [], log := <<"before\nafter\n">>}},
        cb_crash:reason(Finding, {hang, []}, [])
    ).

%% Lines as AddressSanitizer of gcc 12 prints them.
an_address_sanitizer_report_is_recognised_test() ->
    Log =
        <<"noise\n"
          "=================================================================\n"
          "==77==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x602000000020\n"
          "READ of size 4 at 0x602000000020 thread T0\n"
          "SUMMARY: AddressSanitizer: heap-buffer-overflow unsound.c:10 in beyond\n">>,
    Finding = cb_crash:examine({signal, 6}, Log),
    {sanitizer, 'heap-buffer-overflow', Details} = cb_crash:reason(Finding, {beyond, [4]}, []),
    ?assertMatch(
        #{
            summary := <<"AddressSanitizer: heap-buffer-overflow unsound.c:10 in beyond">>,
            in := {beyond, [4]}
        },
        Details
    ).

undefined_behaviour_is_recognised_test() ->
    Line = <<"unsound.c:5:35: runtime error: signed integer overflow">>,
    ?assertEqual([Line], cb_crash:sanitizer_lines(<<"a\n", Line/binary, "\nb\n">>)),
    ?assertEqual([], cb_crash:sanitizer_lines(<<"all is well\n">>)),
    ?assertMatch(
        {sanitizer, undefined, #{summary := Line}},
        cb_crash:reason(cb_crash:examine({signal, 6}, <<Line/binary, "\n">>), f, [])
    ).

only_the_end_of_a_long_log_is_kept_test() ->
    Long = binary:copy(<<"0123456789\n">>, 10000),
    {exited, 0, #{log := Tail}} = cb_crash:reason(cb_crash:examine({exit, 0}, Long), f, []),
    ?assertEqual(4096, byte_size(Tail)).

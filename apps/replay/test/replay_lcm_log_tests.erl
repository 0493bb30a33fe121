-module(replay_lcm_log_tests).
-include_lib("eunit/include/eunit.hrl").

in_dir(Test) ->
    Dir = cb_files:fresh_name("replay_lcm_log", ""),
    ok = file:make_dir(Dir),
    try Test(Dir)
    after
        [ok = file:delete(filename:join(Dir, F)) || F <- element(2, file:list_dir_all(Dir))],
        ok = file:del_dir(Dir)
    end.

written(File, Events) ->
    {ok, W0} = replay_lcm_log:create(File),
    W = lists:foldl(
        fun({T, C, D}, W1) -> {ok, W2} = replay_lcm_log:write(W1, T, C, D), W2 end, W0, Events),
    replay_lcm_log:close(W).

a_log_of_liblcm_is_read_test() ->
    {ok, Events} = replay_lcm_log:read(replay_lcm_peer:data("viz_messages.lcm.gz")),
    Messages = replay_lcm_peer:messages(),
    Expected = [
        #{number => N, t_us => 1000 * N, channel => C, data => replay_lcm_peer:bytes(B)}
     || {N, #{<<"channel">> := C, <<"bytes">> := B}}
            <- lists:zip(lists:seq(0, length(Messages) - 1), Messages)
    ],
    ?assertEqual(Expected, Events).

a_log_is_written_as_liblcm_writes_it_test() ->
    in_dir(fun(Dir) ->
        {ok, Packed} = file:read_file(replay_lcm_peer:data("viz_messages.lcm.gz")),
        Theirs = zlib:gunzip(Packed),
        {ok, Events} = replay_lcm_log:events(Theirs),
        File = filename:join(Dir, "x.lcm"),
        ok = written(File, [{T, C, D} || #{t_us := T, channel := C, data := D} <- Events]),
        ?assertEqual({ok, Theirs}, file:read_file(File)),
        ?assertEqual({ok, ["x.lcm"]}, file:list_dir_all(Dir))
    end).

a_log_has_its_name_only_when_it_is_closed_test() ->
    in_dir(fun(Dir) ->
        File = filename:join(Dir, "x.lcm"),
        {ok, W} = replay_lcm_log:create(File),
        ?assertNot(filelib:is_file(File)),
        ok = replay_lcm_log:discard(W),
        ?assertEqual({ok, []}, file:list_dir_all(Dir))
    end).

what_cannot_be_opened_is_one_line_test() ->
    ?assertEqual({error, "/nowhere/x.lcm: no such file or directory"},
                 replay_lcm_log:read("/nowhere/x.lcm")),
    ?assertEqual({error, "/nowhere/x.lcm: no such file or directory"},
                 replay_lcm_log:create("/nowhere/x.lcm")).

two_events() ->
    First = <<16#eda1da01:32, 0:64, 5:64, 1:32, 2:32, "Cab">>,
    {First, <<First/binary, 16#eda1da01:32, 1:64, 6:64, 1:32, 3:32, "Dabc">>}.

every_truncation_gives_what_is_whole_test() ->
    {First, Both} = two_events(),
    Size = byte_size(First),
    lists:foreach(
        fun(N) ->
            Result = replay_lcm_log:events(binary:part(Both, 0, N)),
            case Result of
                {ok, []} -> ?assertEqual(0, N);
                {ok, [_]} -> ?assertEqual(Size, N);
                {ok, [_, _]} -> ?assertEqual(byte_size(Both), N);
                {truncated, "truncated: event 0 at byte 0 needs " ++ _, []} -> ?assert(N < Size);
                {truncated, "truncated: event 1 at byte 31 needs " ++ _, [_]} -> ?assert(N > Size)
            end
        end,
        lists:seq(0, byte_size(Both))
    ).

hostile_headers_are_one_line_test_() ->
    {First, _} = two_events(),
    Header = fun(C, D) -> <<16#eda1da01:32, 0:64, 0:64, C:32, D:32, 0:800>> end,
    [?_assertMatch({truncated, Line, [_]}, replay_lcm_log:events(<<First/binary, Bytes/binary>>))
     || {Line, Bytes} <- [
            {"event 1 at byte 31: begins with 00000000 instead of eda1da01: no LCM log", <<0:400>>},
            {"event 1 at byte 31: lengths 0 and 1, allowed are 1 to 63 for the channel and up to "
             "16777216 for the data", Header(0, 1)},
            {"event 1 at byte 31: lengths 4294967295 and 1, allowed are 1 to 63 for the channel "
             "and up to 16777216 for the data", Header(-1, 1)},
            {"event 1 at byte 31: lengths 1 and 4294967295, allowed are 1 to 63 for the channel "
             "and up to 16777216 for the data", Header(1, -1)},
            {"truncated: event 1 at byte 31 needs 16777245 bytes, 128 are left",
             Header(1, 16777216)}
        ]].

a_file_larger_than_what_is_read_at_once_is_read_test() ->
    in_dir(fun(Dir) ->
        File = filename:join(Dir, "x.lcm"),
        Data = binary:copy(<<"data">>, 30000),
        ok = written(File, [{N, <<"C">>, Data} || N <- lists:seq(1, 20)]),
        ?assertEqual({ok, 210}, replay_lcm_log:fold(File, fun(#{t_us := T}, S) -> S + T end, 0))
    end).

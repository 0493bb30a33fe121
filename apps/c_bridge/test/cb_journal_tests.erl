-module(cb_journal_tests).

-include_lib("eunit/include/eunit.hrl").

with_file(Test) ->
    File = cb_files:fresh_name("cb_journal_tests", ".journal"),
    try
        Test(File)
    after
        file:delete(File)
    end.

records_are_read_back_in_order_test() ->
    with_file(fun(File) ->
        {ok, J} = cb_journal:open(File, 4096),
        ?assertEqual({ok, []}, cb_journal:read(File)),
        ok = cb_journal:start(J, <<"head">>),
        ok = cb_journal:append(J, ["o", <<"ne">>]),
        ok = cb_journal:append(J, <<>>),
        ?assertEqual({ok, [<<"head">>, <<"one">>, <<>>]}, cb_journal:read(File)),
        ok = cb_journal:start(J, <<"next">>),
        ?assertEqual({ok, [<<"next">>]}, cb_journal:read(File))
    end).

a_full_journal_says_so_and_keeps_what_it_has_test() ->
    with_file(fun(File) ->
        {ok, J} = cb_journal:open(File, 64),
        ok = cb_journal:start(J, <<"head">>),
        ?assertEqual({error, full}, cb_journal:append(J, binary:copy(<<"x">>, 64))),
        ?assertEqual({ok, [<<"head">>]}, cb_journal:read(File))
    end).

%% The other VM is killed after its last record; nothing was flushed or closed.
records_survive_the_death_of_the_writer_test_() ->
    {timeout, 30, fun() ->
        with_file(fun(File) ->
            Program = [
                "{ok, J} = cb_journal:open(\"", File, "\", 4096), ",
                "ok = cb_journal:start(J, <<\"head\">>), ok = cb_journal:append(J, <<\"last\">>), ",
                "cb_nif:kill(list_to_integer(os:getpid()), 9)."
            ],
            Erl = filename:join([code:root_dir(), "bin", "erl"]),
            Ebin = filename:dirname(code:which(cb_journal)),
            Args = ["-noinput", "-pa", Ebin, "-eval", lists:flatten(Program)],
            {ok, G} = cb_guard:start(Erl, Args, #{log => "/dev/null"}),
            ?assertEqual({ended, {signal, 9}}, cb_guard:next_event(G, 20000)),
            ?assertEqual({ok, [<<"head">>, <<"last">>]}, cb_journal:read(File))
        end)
    end}.

unreadable_files_are_errors_test() ->
    with_file(fun(File) ->
        ?assertEqual({error, {journal, File, enoent}}, cb_journal:read(File)),
        ok = file:write_file(File, <<"something else">>),
        ?assertEqual({error, {journal, File, not_a_journal}}, cb_journal:read(File)),
        {ok, J} = cb_journal:open(File, 4096),
        ok = cb_journal:start(J, <<"record">>),
        {ok, Whole} = file:read_file(File),
        ok = file:write_file(File, binary:part(Whole, 0, 22)),
        ?assertEqual({error, {journal, File, truncated}}, cb_journal:read(File))
    end).

a_directory_cannot_be_a_journal_test() ->
    ?assertEqual({error, {journal, "/", eisdir}}, cb_journal:open("/", 4096)),
    ?assertMatch({error, {journal, _, enoent}}, cb_journal:open("/no/such/dir/j", 4096)).

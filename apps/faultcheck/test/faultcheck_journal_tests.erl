-module(faultcheck_journal_tests).
-include_lib("eunit/include/eunit.hrl").

journal_test_() ->
    {foreach, fun() -> cb_files:fresh_name("journal", "") end, fun(File) ->
        _ = faultcheck_journal:close(),
        _ = file:delete(File)
    end, [
        fun(File) -> {Title, fun() -> Test(File) end} end
     || {Title, Test} <- [
            {"commands follow the head of their test", fun follow/1},
            {"each attempt begins without commands and moves on", fun attempts/1},
            {"a new test forgets the one before", fun forgets/1},
            {"a full journal keeps the last commands and says so", fun full/1},
            {"damage is told, not raised", fun damage/1}
        ]
    ]}.

without_a_journal_nothing_happens_test() ->
    ok = faultcheck_journal:close(),
    ok = faultcheck_journal:test(head()),
    ok = faultcheck_journal:attempt(),
    ok = faultcheck_journal:command({set, {var, 1}, {call, m, f, []}}).

follow(File) ->
    ok = faultcheck_journal:open(File, 4096),
    {error, {journal, File, empty}} = faultcheck_journal:read(File),
    ok = faultcheck_journal:test(head()),
    [ok = faultcheck_journal:command(C) || C <- commands(3)],
    {ok, Entry} = faultcheck_journal:read(File),
    ?assertEqual(maps:merge(head(), #{attempt => 0, cut => false, commands => commands(3)}), Entry).

attempts(File) ->
    ok = faultcheck_journal:open(File, 4096),
    ok = faultcheck_journal:test(head()),
    ok = faultcheck_journal:attempt(),
    ok = faultcheck_journal:command(hd(commands(1))),
    Before = faultcheck_journal:progress(File),
    {ok, #{attempt := 0, commands := [_]}} = faultcheck_journal:read(File),
    ok = faultcheck_journal:attempt(),
    {ok, #{attempt := 1, commands := []}} = faultcheck_journal:read(File),
    ?assertNotEqual(Before, faultcheck_journal:progress(File)).

forgets(File) ->
    ok = faultcheck_journal:open(File, 4096),
    ok = faultcheck_journal:test(head()),
    ok = faultcheck_journal:command(hd(commands(1))),
    Before = faultcheck_journal:progress(File),
    ok = faultcheck_journal:test(maps:merge(head(), #{test => 8})),
    {ok, #{test := 8, commands := []}} = faultcheck_journal:read(File),
    ?assertNotEqual(Before, faultcheck_journal:progress(File)).

full(File) ->
    ok = faultcheck_journal:open(File, 400),
    ok = faultcheck_journal:test(head()),
    All = commands(40),
    [ok = faultcheck_journal:command(C) || C <- All],
    {ok, #{cut := true, test := 7, commands := Last}} = faultcheck_journal:read(File),
    ?assert(lists:suffix(Last, All)).

damage(File) ->
    ok = faultcheck_journal:open(File, 4096),
    ok = faultcheck_journal:test(head()),
    {ok, Bytes} = file:read_file(File),
    ok = file:write_file(File, binary:part(Bytes, 0, 40)),
    {error, {journal, File, truncated}} = faultcheck_journal:read(File),
    ok = file:write_file(File, "something else"),
    {error, {journal, File, not_a_journal}} = faultcheck_journal:read(File),
    ok = file:delete(File),
    {error, {journal, File, enoent}} = faultcheck_journal:read(File),
    ?assertEqual(<<>>, faultcheck_journal:progress(File)).

commands(N) -> [{set, {var, I}, {call, m, push, [I]}} || I <- lists:seq(1, N)].

head() -> #{property => {prop_m, prop_x}, seed => 5, test => 7, size => 3}.

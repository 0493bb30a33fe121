-module(faultcheck_store_tests).
-include_lib("eunit/include/eunit.hrl").

store_test_() ->
    {foreach, fun() -> cb_files:fresh_name("store", "") end, fun(Dir) -> file:del_dir_r(Dir) end, [
        fun(Dir) -> {Title, fun() -> Test(filename:join(Dir, "f.consult")) end} end
     || {Title, Test} <- [
            {"what is written reads back", fun round_trip/1},
            {"added are those that are not there yet", fun adds/1},
            {"the text of the file stays", fun keeps_text/1},
            {"errors name the place", fun errors/1}
        ]
    ]}.

names_test() ->
    ?assertEqual(
        "base/rebar3_proper-counterexamples.consult", faultcheck_store:last_file("base")
    ),
    ?assertEqual("test/proper-regressions.consult", faultcheck_store:regression_file("test")).

round_trip(File) ->
    Entries = [{m, prop_a, [[81, 170]]}, {m, prop_b, ["tü€", <<1, 200>>, 1.5, 'ä b']}],
    {error, enoent} = faultcheck_store:read(File),
    ok = faultcheck_store:write(File, Entries),
    ?assertEqual({ok, Entries}, faultcheck_store:read(File)),
    ?assertEqual([File], filelib:wildcard(File ++ "*")).

adds(File) ->
    {ok, 2} = faultcheck_store:add(File, [{m, p, [1]}, {m, p, [2]}, {m, p, [1]}]),
    {ok, 1} = faultcheck_store:add(File, [{m, p, [2]}, {m, p, [3]}]),
    ?assertEqual({ok, [{m, p, [N]} || N <- [1, 2, 3]]}, faultcheck_store:read(File)).

keeps_text(File) ->
    ok = filelib:ensure_dir(File),
    ok = file:write_file(File, "%% found in spring\n{m, p, [1]}.\n"),
    {ok, 1} = faultcheck_store:add(File, [{m, p, [2]}]),
    {ok, <<"%% found in spring\n{m, p, [1]}.\n", _/binary>>} = file:read_file(File).

errors(File) ->
    ok = filelib:ensure_dir(File),
    ok = file:write_file(File, "{m, p, [1]}.\n{m, p, [2"),
    {error, Cut} = faultcheck_store:read(File),
    ?assertNotEqual(nomatch, string:find(Cut, File ++ ":2: not a complete Erlang term")),
    {error, Cut} = faultcheck_store:add(File, [{m, p, [3]}]),
    ok = file:write_file(File, "{m, p, [1]}.\n{m, p}.\n"),
    {error, Shape} = faultcheck_store:read(File),
    ?assertNotEqual(nomatch, string:find(Shape, "term 2 must be {Module, Property, Counter")),
    {error, Denied} = faultcheck_store:write("/dev/null/x", []),
    ?assertNotEqual(nomatch, string:find(Denied, "/dev/null/x")).

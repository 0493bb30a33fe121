-module(faultcheck_case_tests).
-include_lib("eunit/include/eunit.hrl").

case_test_() ->
    {foreach, fun() -> cb_files:fresh_name("cases", "") end, fun(Dir) -> file:del_dir_r(Dir) end, [
        fun(Dir) -> {Title, fun() -> Test(Dir) end} end
     || {Title, Test} <- [
            {"what is written reads back", fun round_trip/1},
            {"the same failure is the same case", fun same_case/1},
            {"nothing unfinished is left or seen", fun whole/1},
            {"a file is added, and replaces the one before", fun added/1},
            {"a case is found by its path and by its name alone", fun found/1},
            {"bad cases are one line", fun errors/1}
        ]
    ]}.

round_trip(Root) ->
    [
        begin
            {ok, Dir} = faultcheck_case:write(Root, Case),
            ?assertEqual({ok, Case}, faultcheck_case:read(Dir)),
            ?assertEqual({ok, Case}, faultcheck_case:read(filename:join(Dir, "case.json")))
        end
     || Case <- [
            sample(),
            (sample())#{shrink := #{}, test := none, size := none, transport := nif},
            (sample())#{shrink := #{flaky => {3, 10}, stopped => max_ms}, status := flaky},
            (sample())#{shrunk := [<<255>>, 'ä', "text", 1.5, {1, [2]}], reasons := ["ü", "€"]}
        ]
    ].

same_case(Root) ->
    {ok, Dir} = faultcheck_case:write(Root, sample()),
    {ok, Dir} = faultcheck_case:write(Root, (sample())#{seed := 6}),
    ?assertMatch({ok, #{seed := 6}}, faultcheck_case:read(Dir)),
    {ok, Other} = faultcheck_case:write(Root, (sample())#{shrunk := [commands(1)]}),
    ?assertNotEqual(Dir, Other).

found(Root) ->
    {ok, Dir} = faultcheck_case:write(Root, sample()),
    Id = filename:basename(Dir),
    File = filename:join(Dir, "case.json"),
    [
        ?assertEqual({ok, Path}, faultcheck_case:find(Given, In))
     || {Path, Given, In} <- [
            {Dir, Id, Root}, {Dir, Dir, "elsewhere"}, {File, File, "elsewhere"}, {Dir, Dir, Root}
        ]
    ],
    {error, Line} = faultcheck_case:find(Id ++ "0", Root),
    ?assertNotEqual(nomatch, string:find(Line, "no case " ++ Id ++ "0; stored cases are folders")),
    ?assertNotEqual(nomatch, string:find(Line, "did you mean " ++ Id ++ "?")),
    %% a folder without a case, and what is not directly below the root
    ok = file:make_dir(filename:join(Root, "empty")),
    {error, _} = faultcheck_case:find("empty", Root),
    {error, _} = faultcheck_case:find(filename:join(Id, "case.json"), Root),
    {error, _} = faultcheck_case:find(Id, filename:join(Root, "empty")).

added(Root) ->
    {ok, Dir} = faultcheck_case:write(Root, sample()),
    ok = faultcheck_case:add_file(Dir, "report.html", "one"),
    ok = faultcheck_case:add_file(Dir, "report.html", ["t", <<"wo">>]),
    ?assertEqual({ok, <<"two">>}, file:read_file(filename:join(Dir, "report.html"))),
    {ok, Names} = file:list_dir_all(Dir),
    ?assertEqual(["case.json", "report.html"], lists:sort(Names)),
    ?assertError(
        {not_written, _}, faultcheck_case:add_file(filename:join(Dir, "none"), "report.html", "")
    ).

%% The digits come from the text of the terms (md5sum of "[1]" is 35dba5d75538a9bb...).
id_test() ->
    ?assertEqual("prop_x-35dba5d7", faultcheck_case:id(prop_x, [1])).

whole(Root) ->
    {ok, Dir} = faultcheck_case:write(Root, sample()),
    {ok, Dir} = faultcheck_case:write(Root, sample()),
    ?assertEqual({ok, [filename:basename(Dir)]}, file:list_dir(Root)),
    ?assertEqual({ok, ["case.json"]}, file:list_dir(Dir)),
    {error, Line} = faultcheck_case:write("/dev/null", sample()),
    ?assertNotEqual(nomatch, string:find(Line, "/dev/null/prop_x-")).

errors(Root) ->
    {ok, Dir} = faultcheck_case:write(Root, sample()),
    File = filename:join(Dir, "case.json"),
    {ok, Text} = file:read_file(File),
    %% Cut at any byte before the last brace, it is an error and no crash.
    [
        ?assertMatch({error, [_ | _]}, read(File, binary:part(Text, 0, Length)))
     || Length <- lists:seq(0, byte_size(Text) - 3, 7)
    ],
    [
        ?assertNotEqual(nomatch, string:find(element(2, read(File, Bad)), Part))
     || {Bad, Part} <- [
            {"[]", "no \"format\""},
            {"{\"format\": 2}", "format 2; this version reads 1"},
            {"{\"format\": 1}", "is missing"},
            {string:replace(Text, "\"failed\"", "\"odd\""), "status must be one of"},
            {string:replace(Text, "\"[[{set", "\"[[{set{"), "is not the text of an Erlang term"}
        ]
    ],
    {error, Missing} = faultcheck_case:read(filename:join(Root, "none")),
    ?assertNotEqual(nomatch, string:find(Missing, "no case")).

read(File, Text) ->
    ok = file:write_file(File, Text),
    faultcheck_case:read(File).

commands_in_a_counterexample_test() ->
    ?assertEqual({ok, commands(2)}, faultcheck_case:commands([x, commands(2), []])),
    ?assertEqual(none, faultcheck_case:commands([[], [1, 2], "text"])),
    ?assertEqual(
        [x, commands(1), []], faultcheck_case:with_commands([x, commands(2), []], commands(1))
    ).

lines_test() ->
    ?assertEqual(
        ["V1 = m:push(1)", "m:pop(V1)", "[1,2]"],
        faultcheck_case:lines([
            [{set, {var, 1}, {call, m, push, [1]}}, {set, {var, 2}, {call, m, pop, [{var, 1}]}}],
            [1, 2]
        ])
    ).

commands(N) -> [{set, {var, I}, {call, m, push, [I]}} || I <- lists:seq(1, N)].

sample() ->
    #{
        module => prop_m,
        property => prop_x,
        status => failed,
        seed => 5,
        test => 17,
        size => 8,
        transport => none,
        options => ["-m", "prop_m"],
        versions => #{faultcheck => "0.1.0", proper => "1.2", otp => "25", git => "none"},
        original => [commands(5)],
        shrunk => [commands(2)],
        reasons => ["postcondition false"],
        shrink => #{tries => 9, accepted => 2, minimal => true, stopped => none, flaky => false}
    }.

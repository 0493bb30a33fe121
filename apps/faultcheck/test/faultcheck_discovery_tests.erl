-module(faultcheck_discovery_tests).
-include_lib("eunit/include/eunit.hrl").

find_test_() ->
    {setup, fun sources/0, fun(Dir) -> file:del_dir_r(Dir) end, fun(Dir) ->
        [
            ?_assertEqual(
                {ok, [{prop_b, [prop_one, prop_two]}]},
                faultcheck_discovery:find([{Dir, Dir}], [])
            ),
            ?_assertEqual(
                {ok, [{named_c, [prop_x]}, {prop_b, [prop_one, prop_two]}]},
                faultcheck_discovery:find([{Dir, Dir}, {Dir, Dir}], [named_c])
            ),
            ?_assertMatch(
                {error, "module prop_b is not compiled" ++ _},
                faultcheck_discovery:find([{Dir, "elsewhere"}], [])
            ),
            %% Looking does not load.
            ?_assertEqual(false, code:is_loaded(prop_b))
        ]
    end}.

sources() ->
    Dir = cb_files:fresh_name("discovery", ""),
    [
        begin
            File = filename:join(Dir, Name ++ ".erl"),
            ok = filelib:ensure_dir(File),
            ok = file:write_file(File, ["-module(", Name, ").\n", Text]),
            {ok, _} = compile:file(File, [{outdir, Dir}])
        end
     || {Name, Text} <- [
            {"prop_b", "-export([prop_two/0, prop_one/0, prop_one/1, help/0]).\n"
                "prop_two() -> true. prop_one() -> true. prop_one(doc) -> \"\". help() -> ok.\n"},
            {"named_c", "-export([prop_x/0]).\nprop_x() -> true.\n"}
        ]
    ],
    Dir.

-define(FOUND, [{prop_a, [prop_x, prop_y]}, {prop_b, [prop_z]}]).

select_test_() ->
    [
        ?_assertEqual(Expected, faultcheck_discovery:select(Options, ?FOUND))
     || {Options, Expected} <- [
            {#{}, {ok, [{prop_a, prop_x}, {prop_a, prop_y}, {prop_b, prop_z}]}},
            {#{module => [prop_b]}, {ok, [{prop_b, prop_z}]}},
            {#{prop => [prop_y]}, {ok, [{prop_a, prop_y}]}},
            {#{module => [prop_c]},
                {error, "no module prop_c; did you mean prop_a or prop_b?"}},
            {#{module => [prop_b], prop => [prop_x]},
                {error, "no property prop_x; did you mean prop_z?"}},
            {#{prop => [something]},
                {error, "no property something; there are prop_x, prop_y, prop_z"}}
        ]
    ].

nothing_at_all_test() ->
    ?assertEqual(
        {error, "no module prop_a; there is none at all"},
        faultcheck_discovery:select(#{module => [prop_a]}, [])
    ).

-module(faultcheck_project_tests).
-include_lib("eunit/include/eunit.hrl").

project_test_() ->
    {setup, fun() -> cb_files:fresh_name("project", "") end, fun(Dir) -> file:del_dir_r(Dir) end,
        fun(Dir) ->
            [
                {"makes all files", fun() ->
                    {ok, [_ | _]} = faultcheck_project:new(Dir),
                    Files = [".gitignore", "README.md", "rebar.config", "c_src/ring.c",
                        "src/ring_project.app.src", "test/prop_ring.erl"],
                    [?assert(filelib:is_regular(filename:join(Dir, F))) || F <- Files]
                end},
                {"the model has less than 20 lines of Erlang", fun() ->
                    {ok, Text} = file:read_file(filename:join([Dir, "test", "prop_ring.erl"])),
                    Lines = string:split(Text, "\n", all),
                    Code = [L || L <- Lines, re:run(L, "^ *(%|$)") =:= nomatch],
                    ?assert(length(Code) < 20)
                end},
                {"touches no directory with something in it", fun() ->
                    ?assertMatch({error, [_ | _]}, faultcheck_project:new(Dir))
                end},
                {"a file is no place for a project", fun() ->
                    {error, Line} = faultcheck_project:new(filename:join(Dir, "README.md")),
                    ?assertNotEqual(nomatch, string:find(Line, "is a file"))
                end}
            ]
        end}.

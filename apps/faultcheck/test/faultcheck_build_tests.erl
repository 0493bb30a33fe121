-module(faultcheck_build_tests).
-include_lib("eunit/include/eunit.hrl").

directory_test_() ->
    {foreach, fun() -> cb_files:fresh_name("build", "") end, fun(Dir) -> file:del_dir_r(Dir) end, [
        fun(Dir) -> {Title, fun() -> Test(Dir) end} end
     || {Title, Test} <- [
            {"compiles what is there", fun compiles/1},
            {"an error names file and line", fun error_line/1}
        ]
    ]}.

compiles(Dir) ->
    Out = filename:join(Dir, "out"),
    Text = "-module(one).\n-include(\"one.hrl\").\n-export([f/0]).\nf() -> ?X.\n",
    ok = source(Dir, "one.erl", Text),
    ok = source(Dir, "one.hrl", "-define(X, 1).\n"),
    ok = faultcheck_build:directory(Dir, Out, []),
    ?assert(filelib:is_regular(filename:join(Out, "one.beam"))).

error_line(Dir) ->
    ok = source(Dir, "two.erl", "-module(two).\n\nf( -> 1.\n"),
    {error, Text} = faultcheck_build:directory(Dir, filename:join(Dir, "out"), []),
    ?assertNotEqual(nomatch, string:find(Text, "two.erl:3:")).

source(Dir, Name, Text) ->
    File = filename:join(Dir, Name),
    ok = filelib:ensure_dir(File),
    file:write_file(File, Text).

-module(replay_token_tests).
-include_lib("eunit/include/eunit.hrl").

in_folder(Test) ->
    Dir = cb_files:fresh_name("token", ""),
    ok = file:make_dir(Dir),
    try Test(filename:join(Dir, "token")) after file:del_dir_r(Dir) end.

is_made_once_and_then_the_same_test() ->
    in_folder(fun(File) ->
        {ok, Token} = replay_token:shared(File),
        ?assertMatch({match, _}, re:run(Token, "^[0-9a-f]{64}$")),
        ?assertEqual({ok, Token}, replay_token:shared(File)),
        ?assertEqual(["token"], filelib:wildcard("*", filename:dirname(File)))
    end).

is_its_owners_alone_test() ->
    in_folder(fun(File) ->
        {ok, _} = replay_token:shared(File),
        ok = file:change_mode(File, 8#644),
        {error, Line} = replay_token:shared(File),
        ?assertEqual(File ++ ": others may read it; run: chmod 600 " ++ File, Line)
    end).

anything_else_is_no_token_test() ->
    in_folder(fun(File) ->
        ok = file:write_file(File, "secret\n"),
        ok = file:change_mode(File, 8#600),
        ?assertEqual({error, File ++ ": expected 32 to 128 hexadecimal digits"},
                     replay_token:shared(File))
    end).

%% Sanitizer builds: their reports are reasons.
-module(cb_sanitizer_tests).

-include_lib("eunit/include/eunit.hrl").

unsound(Options, Test) ->
    Lib = cb_sut:start("unsound.c", Options),
    try
        Test(Lib)
    after
        cb:stop(Lib)
    end.

%% gcc always; clang if it is there with its shared runtime.
compilers() ->
    [{"gcc", "g++"} | [{"clang", "clang++"} || has_clang_runtime()]].

has_clang_runtime() ->
    case cb_compiler:run("clang", ["-print-file-name=libclang_rt.asan-x86_64.so"]) of
        {ok, 0, File} -> filelib:is_regular(string:trim(File));
        _ -> false
    end.

address_test_() ->
    [
        {Compiler ++ " " ++ atom_to_list(Reset), {timeout, 60, fun() -> address(C, Reset) end}}
     || {Compiler, _} = C <- compilers(), Reset <- [fork, respawn]
    ].

address(Compiler, Reset) ->
    unsound([{sanitize, [address]}, {compiler, Compiler}, {reset, Reset}], fun(L) ->
        ?assertEqual(1, cb:call(L, beyond, [0])),
        {sanitizer, Kind, Details} = cb_sut:reason(fun() -> cb:call(L, beyond, [4]) end),
        ?assertEqual('heap-buffer-overflow', Kind),
        ?assertMatch(#{in := {beyond, [4]}, summary := _, log := _}, Details),
        #{summary := Summary, log := Log} = Details,
        ?assertNotEqual(nomatch, binary:match(Summary, <<"beyond">>)),
        ?assertNotEqual(nomatch, binary:match(Log, <<"unsound.c:11">>)),
        ok = cb:restart(L),
        ?assertEqual(1, cb:call(L, beyond, [0]))
    end).

undefined_behaviour_ends_a_library_of_ours_test_() ->
    {timeout, 60, fun() ->
        unsound([{sanitize, [undefined]}], fun(L) ->
            ?assertEqual(3, cb:call(L, increment, [2])),
            {sanitizer, undefined, #{summary := Summary}} =
                cb_sut:reason(fun() -> cb:call(L, increment, [16#7fffffff]) end),
            ?assertNotEqual(nomatch, binary:match(Summary, <<"signed integer overflow">>)),
            ok = cb:restart(L),
            ?assertEqual(3, cb:call(L, increment, [2]))
        end)
    end}.

%% A build that prints and goes on: the finding belongs to the call that made it, once.
undefined_behaviour_is_found_in_the_log_test_() ->
    {timeout, 60, fun() ->
        Options = [{sanitize, [undefined]}, {cflags, ["-fsanitize-recover=all"]}],
        unsound(Options, fun(L) ->
            ?assertMatch(
                {sanitizer, undefined, #{in := {increment, [16#7fffffff]}}},
                cb_sut:reason(fun() -> cb:call(L, increment, [16#7fffffff]) end)
            ),
            ?assertEqual(3, cb:call(L, increment, [2])),
            ?assertEqual(ok, cb:restart(L)),
            ?assertMatch({sanitizer, undefined, _}, cb:last_crash(L))
        end)
    end}.

-module(faultcheck_reason_tests).
-include_lib("eunit/include/eunit.hrl").

an_exception_names_our_own_places_test() ->
    Stack = [
        {prop_m, check, 2, [{file, "prop_m.erl"}, {line, 7}]},
        {proper, apply_args, 3, [{file, "proper.erl"}, {line, 1}]},
        {prop_m, prop_x, [1], []}
    ],
    ?assertEqual(
        ["error:{bad,1}", "in prop_m:check/2 (prop_m.erl:7)", "in prop_m:prop_x/1"],
        faultcheck_reason:lines(error, {bad, 1}, Stack)
    ).

what_c_bridge_raises_is_in_its_words_test() ->
    Reason = {unknown_function, <<"f">>, [<<"g">>]},
    Said = unicode:characters_to_list(cb_error:format(Reason)),
    ?assertEqual([Said], faultcheck_reason:lines(error, {cb, Reason}, [])).

addresses_are_left_out_test() ->
    ?assertEqual(
        ["crash: SIGFPE in f(), at f (a.c:3)"],
        faultcheck_reason:trimmed("crash: SIGFPE at address 0x7f207a09619c in f(), at f (a.c:3)\n")
    ),
    Null = "crash: SIGSEGV at address 0x10 in f()",
    ?assertEqual([Null], faultcheck_reason:trimmed(["  ", Null])).

not_started_test_() ->
    Load = {load, "libx.so", no_debug_info},
    [
        ?_assertMatch({true, [_ | _]}, faultcheck_reason:unstarted(Reason))
     || Reason <- [Load, {cb, Load}, {badmatch, {error, Load}}, {badmatch, {error, {cb, Load}}}]
    ] ++
        [?_assertEqual(false, faultcheck_reason:unstarted({badmatch, {error, enoent}}))].

timeout_test() ->
    ?assert(faultcheck_reason:is_timeout({cb, {timeout, 5, #{}}})),
    ?assertNot(faultcheck_reason:is_timeout({cb, {arity, f, 1, 2, <<>>}})).

endings_test() ->
    ?assertEqual("exited with status 3", faultcheck_reason:ending({exit, 3})),
    ?assertEqual("died of signal 9 (SIGKILL)", faultcheck_reason:ending({signal, 9})).

every_answer_of_proper_is_a_line_test_() ->
    [
        ?_assertEqual(nomatch, string:find([_ | _] = faultcheck_reason:proper(Reason), "\n"))
     || Reason <- [
            cant_generate,
            {cant_generate, [{m, f, 0}]},
            cant_satisfy,
            non_boolean_result,
            type_mismatch,
            rejected,
            too_many_instances,
            {typeserver, {bad, type}},
            {unrecognized_option, {odd, 1}},
            {unexpected, x}
        ]
    ].

-module(eqc_c_flags_tests).

-include_lib("eunit/include/eunit.hrl").

one_string_holds_all_flags_test() ->
    {ok, Options} =
        eqc_c_flags:options(m, [{c_src, "a.c b.c"},
                                {cppflags, "-Iinc -I more -Llib -lfaultcheck -l m -std=c99 "
                                           "-DNAME=\"a b\" -Wl,-z,now"}]),
    ?assertEqual([{c_src, ["a.c", "b.c"]}, {include_dirs, ["inc", "more"]}, {lib_dirs, ["lib"]},
                  {libs, ["faultcheck", "m"]}, {ldflags, ["-Wl,-z,now"]},
                  {cflags, ["-std=c99", "-DNAME=a b"]}], Options).

coverage_flags_ask_for_coverage_test_() ->
    [?_assertMatch({ok, [{c_src, ["m.c"]}, {coverage, _}]}, eqc_c_flags:options(m, [{cppflags, F}]))
     || F <- ["-fprofile-arcs -ftest-coverage", "-coverage", "--coverage", "-lgcov"]].

the_source_is_named_like_the_module_test() ->
    ?assertEqual({ok, [{c_src, ["m.c"]}]}, eqc_c_flags:options(m, [])).

other_options_are_passed_on_test() ->
    ?assertEqual({ok, [{c_src, ["x.c"]}, {transport, nif}]},
                 eqc_c_flags:options(m, [{c_src, ["x.c"]}, {transport, nif}])).

a_quote_that_is_not_closed_is_said_test() ->
    ?assertMatch({error, {bad_option, _, "a string with each quote closed"}},
                 eqc_c_flags:options(m, [{cppflags, "-DX=\"a"}])),
    ?assertMatch({error, {bad_option, 7, "a string"}}, eqc_c_flags:options(m, [{cppflags, 7}])).

-module(cb_options_tests).

-include_lib("eunit/include/eunit.hrl").

defaults_are_filled_in_test() ->
    {ok, Options} = cb_options:parse([{so, "libx.so"}]),
    ?assertMatch(
        #{transport := port, reset := auto, timeout := 5000, sanitize := [], force_reset := none},
        Options
    ).

files_may_be_strings_or_binaries_test() ->
    {ok, #{c_src := ["a.c"]}} = cb_options:parse([{c_src, "a.c"}]),
    {ok, #{c_src := ["a.c"]}} = cb_options:parse([{c_src, <<"a.c">>}]),
    {ok, #{c_src := ["a.c", "b.c"]}} = cb_options:parse([{c_src, ["a.c", <<"b.c">>]}]).

each_wrong_value_is_named_test_() ->
    Wrong = [
        {so, 7},
        {c_src, [1.5]},
        {cflags, "-O2"},
        {transport, tcp},
        {reset, often},
        {reset, {calls, [no_call]}},
        {timeout, 0},
        {timeout, soon},
        {sanitize, [memory]},
        {stubs, [f]},
        {dirty, maybe_so},
        {owner, me},
        {compiler, "gcc"},
        {env, [{a, 1}]},
        {module, 1},
        {no_such_option, 1},
        not_even_a_pair
    ],
    [
        ?_assertMatch({error, {bad_option, Option, _}}, cb_options:parse([{so, "x.so"}, Option]))
     || Option <- Wrong
    ].

something_must_be_loaded_test() ->
    ?assertEqual({error, {missing_option, [so, c_src]}}, cb_options:parse([])).

so_and_sources_exclude_each_other_test() ->
    ?assertMatch(
        {error, {bad_option, {so, "x.so"}, _}}, cb_options:parse([{so, "x.so"}, {c_src, "a.c"}])
    ),
    ?assertMatch(
        {error, {bad_option, {so, "x.so"}, _}},
        cb_options:parse([{so, "x.so"}, {stubs, [{f, 0}]}])
    ).

what_needs_a_port_is_refused_in_nif_test() ->
    ?assertEqual(
        {error, {needs_port, {sanitize, [address]}}},
        cb_options:parse([{so, "x.so"}, {transport, nif}, {sanitize, [address]}])
    ),
    Fun = fun() -> 1 end,
    ?assertEqual(
        {error, {needs_port, {stubs, [f]}}},
        cb_options:parse([{c_src, "x.c"}, {transport, nif}, {stubs, [{f, Fun}, {g, 1}]}])
    ).

overrides_test_() ->
    {setup, fun() -> ok end, fun(_) -> [unset(K) || K <- keys()] end, [
        fun the_environment_wins_over_the_model/0
    ]}.

keys() -> [force_transport, force_reset, timeout_factor].

unset(Key) -> application:unset_env(c_bridge, Key).

the_environment_wins_over_the_model() ->
    ok = application:set_env(c_bridge, force_transport, port),
    ok = application:set_env(c_bridge, force_reset, fork),
    ok = application:set_env(c_bridge, timeout_factor, 2.5),
    Asked = [{so, "x.so"}, {transport, nif}, {reset, none}, {timeout, 100}],
    ?assertMatch(
        {ok, #{transport := port, force_reset := {force, fork}, reset := none, timeout := 250}},
        cb_options:parse(Asked)
    ).

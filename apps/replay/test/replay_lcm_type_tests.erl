-module(replay_lcm_type_tests).
-include_lib("eunit/include/eunit.hrl").

every_fingerprint_is_that_of_lcm_gen_test() ->
    Ours = maps:from_list([{atom_to_binary(Name), hex(F)}
                           || {Name, #{fingerprint := F}}
                                  <- maps:to_list(replay_lcm_type:schema())]),
    ?assertEqual(replay_lcm_peer:fingerprints(), Ours).

a_fingerprint_names_its_type_test() ->
    #{fingerprint := F} = replay_lcm_type:struct(risk),
    ?assertEqual({ok, risk}, replay_lcm_type:named(F)),
    ?assertEqual(error, replay_lcm_type:named(1)).

least_sizes_follow_from_the_fields_test() ->
    %% added up by hand from lcm/object.lcm and lcm/poly.lcm
    ?assertEqual(4 + 1 + 1 + 18 * 4, replay_lcm_type:min_size({struct, object})),
    ?assertEqual(5 + 1 + 4, replay_lcm_type:min_size({struct, poly})),
    ?assertEqual([1, 2, 4, 8, 1, 1, 4, 8, 5],
                 [replay_lcm_type:min_size(B)
                  || B <- [int8_t, int16_t, int32_t, int64_t, byte, boolean, float, double,
                           string]]).

parsed(Text) -> replay_lcm_type:parse([{"t.lcm", Text}]).

comments_and_sizes_are_read_test() ->
    {ok, #{t := #{fields := Fields, counts := Counts}}} =
        parsed(<<"/* a\nb */ package p; struct t { int8_t n; // how many\n double x[n][2]; }">>),
    ?assertEqual([{n, int8_t, []}, {x, double, [n, 2]}], Fields),
    ?assertEqual(#{n => x}, Counts).

what_is_wrong_with_a_definition_is_one_line_test_() ->
    [?_assertEqual({error, Line}, parsed(Text)) || {Line, Text} <- [
        {"t.lcm: nothing in it", <<"// only this">>},
        {"t.lcm: expected `package NAME;' first", <<"struct t { }">>},
        {"t.lcm: expected `struct NAME {', found `enum'", <<"package p; enum e { A }">>},
        {"t.lcm: expected `TYPE NAME;' or `}'", <<"package p; struct t { int8_t">>},
        {"t.lcm: `[0]' is no size that is supported here",
         <<"package p; struct t { byte x[0]; }">>},
        {"t.lcm: `[n]' is no size that is supported here",
         <<"package p; struct t { int8_t n; byte x[2][n]; }">>},
        {"t: `n' of `x' is no integer before it",
         <<"package p; struct t { byte x[n]; int8_t n; }">>},
        {"t: two arrays share a count",
         <<"package p; struct t { int8_t n; byte x[n]; byte y[n]; }">>},
        {"u: no such type", <<"package p; struct t { u x; }">>},
        {"t: contains itself", <<"package p; struct t { int8_t n; t x[n]; }">>}
    ]].

hex(F) -> iolist_to_binary(io_lib:format("~16.16.0b", [F])).

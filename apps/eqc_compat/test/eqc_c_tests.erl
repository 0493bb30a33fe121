-module(eqc_c_tests).

-include_lib("eunit/include/eunit.hrl").

data(File) ->
    filename:join([filename:dirname(code:which(?MODULE)), "data", File]).

c_values_are_read_and_written_test() ->
    ok = eqc_c:start(seatheater, [{c_src, data("seatheater.c")},
                                  {cppflags, "-DHEATER_LIMIT=60 -std=c99"}]),
    Hot = eqc_c:create_array(unsigned_char, [90, 20]),
    ?assertEqual(90, eqc_c:array_index(Hot, 0)),
    ?assertEqual([90, 20], eqc_c:read_array(Hot, 2)),
    _ = seatheater:heater_sample(Hot),
    ?assertEqual(1, seatheater:heater_hot_samples()),
    ?assertEqual(0, eqc_c:value_of(heater_off)),
    ok = eqc_c:set_value(heater_off, 5),
    ?assertEqual(5, eqc_c:value_of(heater_off)),
    _ = seatheater:heater_set_label(eqc_c:create_string("front")),
    ?assertEqual("front", eqc_c:read_string(eqc_c:address_of(heater_label))),
    ok = eqc_c:restart(),
    ?assertEqual(0, eqc_c:value_of(heater_off)),
    ?assertEqual(0, seatheater:heater_hot_samples()),
    ok = eqc_c:stop().

what_is_not_started_is_said_test() ->
    ?assertError({cb, {not_started, eqc_c}}, eqc_c:restart()).

a_missing_source_is_said_test() ->
    ?assertError({cb, _}, eqc_c:start(no_such_source, [])).

%% Contexts, listings, clocks, predicates and recordings of libfaultcheck itself, behind a library
%% that uses it.
-module(faultcheck_context_tests).

-include_lib("eunit/include/eunit.hrl").

context_test_() ->
    {setup, fun start/0, fun cb:stop/1, fun(Lib) ->
        [
            {atom_to_list(element(2, erlang:fun_info(Test, name))), fun() -> fresh(Lib, Test) end}
         || Test <- [
                fun nothing_is_listed_at_first/1,
                fun what_is_armed_is_listed/1,
                fun channels_are_listed_for_each_receiver/1,
                fun idle_calls_are_counted_on_request/1,
                fun a_context_has_a_seed/1,
                fun errors_are_counted/1,
                fun the_clock_is_moved_by_hand/1,
                fun the_clock_may_be_a_function/1,
                fun a_trigger_may_be_a_predicate/1,
                fun a_recording_is_read/1,
                fun every_type_is_recorded/1,
                fun packets_are_recorded/1,
                fun a_recording_may_go_to_a_file/1,
                fun a_file_that_cannot_be_written_is_told/1,
                fun an_error_propagates/1,
                fun tolerances_are_kept_to/1,
                fun damaged_recordings_are_refused/1
            ]
        ]
    end}.

start() ->
    Library = cb_library:find("libfaultcheck.so", faultcheck_inject),
    Source = cb_files:fresh_name("faultcheck_context", ".c"),
    ok = file:write_file(Source,
        "#include <stdbool.h>\n"
        "#include <stdint.h>\n"
        "void fc_reset(void *);\n"
        "int64_t noon;\n"
        "int64_t clock_of_the_model(void *user) { (void)user; return noon; }\n"
        "bool is_noon(void *user) { (void)user; return noon == 12; }\n"
        "void use(void) { fc_reset(0); }\n"),
    try
        {ok, Lib} = cb:start(faultcheck_context_tests, [
            {c_src, Source},
            {ldflags, [Library, "-Wl,-rpath," ++ filename:dirname(Library)]},
            {transport, nif}, {reset, none}, {module, false}
        ]),
        Lib
    after
        file:delete(Source)
    end.

fresh(Lib, Test) ->
    ok = faultcheck_context:reset(Lib, null),
    ok = faultcheck_context:advance(Lib, null, 0),
    Test(Lib).

probe(Lib, Id, Value) -> probe(Lib, null, Id, Value).

probe(Lib, Context, Id, Value) ->
    Buffer = cb:create_array(Lib, double, [Value]),
    _ = cb:call(Lib, fc_probe_f64, [Context, Id, Buffer]),
    [Result] = cb:read(Lib, Buffer, 1),
    ok = cb:free(Lib, Buffer),
    Result.

arm(Lib, Where, Fault) ->
    {ok, Id} = faultcheck_inject:arm(Lib, null, Where, Fault),
    Id.

list(Lib) ->
    {ok, Entries} = faultcheck_context:list(Lib, null),
    Entries.

%% ---- the listing

nothing_is_listed_at_first(Lib) -> ?assertEqual([], list(Lib)).

what_is_armed_is_listed(Lib) ->
    Waiting = arm(Lib, {probe, <<"x">>}, {{offset, 0.5}, [{from, 3}]}),
    Disabled = arm(Lib, {probe, <<"x">>}, {bitflip, 9}),
    ok = faultcheck_inject:enable(Lib, null, Disabled, false),
    Skipped = arm(Lib, {probe, <<"y">>}, {bitflip, 70}),
    _ = [probe(Lib, Id, 1.0) || Id <- [<<"x">>, <<"y">>]],
    [X, Y] = list(Lib),
    ?assertMatch(#{id := <<"x">>, kind := probe, types := [f64], calls := 1, puts := 0}, X),
    ?assertMatch(
        [#{id := Waiting, model := <<"offset">>, a := 0.5, state := waiting, calls_left := 2,
           triggered := 0, last_error := 'FC_OK'},
         #{id := Disabled, model := <<"bitflip">>, n := 9, state := disabled}],
        maps:get(faults, X)),
    ?assertMatch(
        [#{id := Skipped, state := active, triggered := 1, applied := 0, skipped := 1,
           last_error := 'FC_E_BIT'}],
        maps:get(faults, Y)).

channels_are_listed_for_each_receiver(Lib) ->
    _ = [0 = cb:call(Lib, fc_channel_subscribe, [null, <<"c">>, R]) || R <- [<<"r">>, <<"s">>]],
    _ = arm(Lib, {channel, <<"c">>, <<"s">>}, {drop, 2}),
    0 = cb:call(Lib, fc_channel_put, [null, <<"c">>, <<1>>, 1]),
    [#{kind := channel, puts := 1, calls := 0, types := [], faults := [Fault]}] = list(Lib),
    ?assertMatch(#{model := <<"drop">>, n := 2, receiver := <<"s">>}, Fault).

idle_calls_are_counted_on_request(Lib) ->
    _ = probe(Lib, <<"x">>, 1.0),
    ok = faultcheck_context:count_calls(Lib, null, true),
    _ = [probe(Lib, <<"x">>, 1.0) || _ <- [1, 2, 3]],
    ?assertMatch([#{calls := 3}], list(Lib)).

%% ---- contexts

a_context_has_a_seed(Lib) ->
    Flipped = fun(Seed) ->
        {ok, Context} = faultcheck_context:new(Lib, #{seed => Seed}),
        {ok, _} = faultcheck_inject:arm(Lib, Context, {probe, <<"x">>}, {noise_gauss, 1}),
        Values = [probe(Lib, Context, <<"x">>, 0.0) || _ <- [1, 2, 3]],
        ok = faultcheck_context:free(Lib, Context),
        Values
    end,
    ?assertEqual(Flipped(7), Flipped(7)),
    ?assertNotEqual(Flipped(7), Flipped(8)).

errors_are_counted(Lib) ->
    ?assertEqual(0, faultcheck_context:error_count(Lib, null)),
    {error, {'FC_E_NO_FAULT', _}} = faultcheck_inject:remove(Lib, null, 4711),
    ?assertEqual(1, faultcheck_context:error_count(Lib, null)).

%% ---- clocks and predicates

the_clock_is_moved_by_hand(Lib) ->
    ok = faultcheck_context:advance(Lib, null, 250),
    ?assertEqual(250, faultcheck_context:now(Lib, null)),
    _ = arm(Lib, {probe, <<"x">>}, {{offset, 1.0}, [{time, 100, 50}]}),
    Values = [
        begin
            ok = faultcheck_context:advance(Lib, null, Ns),
            probe(Lib, <<"x">>, 0.0)
        end
     || Ns <- [99, 1, 49, 1]
    ],
    ?assertEqual([0.0, 1.0, 1.0, 0.0], Values).

the_clock_may_be_a_function(Lib) ->
    ok = cb:set(Lib, noon, 1200),
    ok = faultcheck_context:use_clock(Lib, null, {function, clock_of_the_model}),
    ?assertEqual(1200, faultcheck_context:now(Lib, null)),
    ok = faultcheck_context:use_clock(Lib, null, monotonic),
    First = faultcheck_context:now(Lib, null),
    ?assert(First =/= 1200 andalso faultcheck_context:now(Lib, null) >= First).

a_trigger_may_be_a_predicate(Lib) ->
    _ = arm(Lib, {probe, <<"x">>}, {{offset, 1.0}, [{predicate, is_noon}]}),
    At = fun(Time) ->
        ok = cb:set(Lib, noon, Time),
        probe(Lib, <<"x">>, 0.0)
    end,
    ?assertEqual([0.0, 1.0, 0.0], [At(T) || T <- [11, 12, 13]]).

%% ---- recordings

recorded(Lib, Run) ->
    ok = faultcheck_record:start(Lib, null),
    _ = Run(),
    {ok, Recording} = faultcheck_record:stop(Lib, null),
    Recording.

a_recording_is_read(Lib) ->
    _ = arm(Lib, {probe, <<"x">>}, {{offset, 0.5}, [{from, 1}]}),
    Recording = recorded(Lib, fun() ->
        _ = probe(Lib, <<"x">>, 1.0),
        ok = faultcheck_context:advance(Lib, null, 30),
        probe(Lib, <<"x">>, 2.0)
    end),
    ?assertEqual(
        {ok, [
            #{kind => probe, id => <<"x">>, type => f64, sequence => 0, time_ns => 0,
              before => 1.0, 'after' => 1.0, faults => 0},
            #{kind => probe, id => <<"x">>, type => f64, sequence => 1, time_ns => 30,
              before => 2.0, 'after' => 2.5, faults => 1}
        ]},
        faultcheck_record:calls(Recording)).

every_type_is_recorded(Lib) ->
    Values = [
        {f32, 0.5}, {f32, inf}, {f64, -0.25}, {f64, neg_inf}, {f64, nan}, {i8, -128}, {i16, -2},
        {i32, -2147483648}, {i64, -9223372036854775808}, {u8, 255}, {u16, 65535},
        {u32, 4294967295}, {u64, 18446744073709551615}, {bool, true}, {bool, false},
        {bytes, <<>>}, {bytes, <<0, 255>>}
    ],
    Recording = recorded(Lib, fun() ->
        [ok = faultcheck_record:monitor(Lib, null, <<"m", 255>>, T, V) || {T, V} <- Values]
    end),
    {ok, Calls} = faultcheck_record:calls(Recording),
    ?assertEqual(Values, [{T, V} || #{type := T, 'after' := V} <- Calls]),
    ?assertEqual([{<<"m", 255>>, monitor}],
                 lists:usort([{Id, Kind} || #{id := Id, kind := Kind} <- Calls])),
    ?assertMatch([#{types := [f32, f64, i8, i16, i32, i64, u8, u16, u32, u64, bool, bytes]}],
                 list(Lib)).

packets_are_recorded(Lib) ->
    Buffer = cb:create_array(Lib, 'unsigned char', [0, 0]),
    Recording = recorded(Lib, fun() ->
        0 = cb:call(Lib, fc_channel_put, [null, <<"c">>, <<4, 5>>, 2]),
        1 = cb:call(Lib, fc_channel_get, [null, <<"c">>, null, Buffer, 2, null])
    end),
    ?assertMatch({ok, [#{kind := put, 'after' := <<4, 5>>}, #{kind := get, 'after' := <<4, 5>>}]},
                 faultcheck_record:calls(Recording)).

a_recording_may_go_to_a_file(Lib) ->
    File = cb_files:fresh_name("faultcheck_record", ".rec"),
    try
        ok = faultcheck_record:start(Lib, null, File),
        _ = probe(Lib, <<"x">>, 1.0),
        ?assertEqual({ok, <<>>}, faultcheck_record:stop(Lib, null)),
        {ok, Recording} = file:read_file(File),
        ?assertMatch({ok, [#{id := <<"x">>}]}, faultcheck_record:calls(Recording))
    after
        file:delete(File)
    end.

a_file_that_cannot_be_written_is_told(Lib) ->
    {error, {'FC_E_IO', Text}} = faultcheck_record:start(Lib, null, "/nowhere/at/all"),
    ?assertNotEqual(nomatch, string:find(Text, "/nowhere/at/all")).

%% ---- golden runs

chain(Lib) ->
    recorded(Lib, fun() ->
        [
            begin
                Sensor = probe(Lib, <<"sensor">>, 10.0 + N),
                ok = faultcheck_record:monitor(Lib, null, <<"filter">>, f64, Sensor / 2),
                faultcheck_record:monitor(Lib, null, <<"alarm">>, bool, Sensor > 12.5)
            end
         || N <- lists:seq(0, 4)
        ]
    end).

an_error_propagates(Lib) ->
    Golden = chain(Lib),
    ?assertEqual({ok, []}, faultcheck_record:compare(Lib, Golden, Golden)),
    _ = arm(Lib, {probe, <<"sensor">>}, {{offset, 1.0}, [{from, 2}, {for, 1}]}),
    {ok, Found} = faultcheck_record:compare(Lib, Golden, chain(Lib)),
    ?assertMatch(
        [#{id := <<"sensor">>, kind := probe, calls := 5, differing := 1, first := 2,
           missing := 0, extra := 0, largest_absolute := 1.0},
         #{id := <<"filter">>, first := 2, largest_absolute := 0.5},
         #{id := <<"alarm">>, first := 2}],
        Found).

tolerances_are_kept_to(Lib) ->
    Golden = chain(Lib),
    _ = arm(Lib, {probe, <<"sensor">>}, {offset, 0.25}),
    Run = chain(Lib),
    Differing = fun(Tolerance) ->
        {ok, Found} = faultcheck_record:compare(Lib, Golden, Run, Tolerance),
        [Id || #{id := Id} <- Found]
    end,
    ?assertEqual([<<"sensor">>, <<"filter">>], Differing(#{})),
    ?assertEqual([<<"sensor">>], Differing(#{absolute => 0.2})),
    ?assertEqual([], Differing(#{relative => 0.03})),
    ?assertMatch({error, {'FC_E_ARG', _}},
                 faultcheck_record:compare(Lib, Golden, Run, #{absolute => -1})).

damaged_recordings_are_refused(Lib) ->
    Golden = chain(Lib),
    Short = binary:part(Golden, 0, byte_size(Golden) - 1),
    {error, {'FC_E_FORMAT', Text}} = faultcheck_record:compare(Lib, Golden, Short),
    {error, {position, At}} = faultcheck_record:calls(Short),
    ?assertNotEqual(nomatch, string:find(Text, "byte " ++ integer_to_list(At) ++ ":")),
    ?assertEqual({error, {position, 0}}, faultcheck_record:calls(<<"nonsense">>)),
    ?assertEqual({error, {position, 8}}, faultcheck_record:calls(<<"FCREC001", 0>>)).

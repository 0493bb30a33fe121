-module(airbag_trace_tests).
-include_lib("eunit/include/eunit.hrl").

trace_test_() ->
    {setup, fun airbag_test_sut:port/0, fun(_) -> airbag_sut:stop() end, [
        {"a bit that is flipped is seen in what arrives", fun flip/0},
        {"a repeated packet arrives so many times, and all count; the next does not",
            fun repetition/0},
        {"an explosion is without faults", fun explosion/0},
        {"status, CRC and counter of each protected packet", fun protected/0},
        {"what behind the failure would come is not run", fun not_run/0},
        {"a trace agrees with the airbag's own counters", fun counters/0}
    ]}.

plain() -> airbag_options:new(#{protection => plain}).

run(Options, Calls) -> airbag_trace:run(Options, commands(Calls)).

commands(Calls) ->
    [
        {set, {var, N}, {call, airbag_eqc, Name, Args}}
     || {N, {Name, Args}} <- lists:zip(lists:seq(1, length(Calls)), Calls)
    ].

%% 84 is 01010100; its bit 0 inverted is 85.
flip() ->
    #{steps := [_, Step], result := ok} =
        run(plain(), [{bit_flip, [0, 0]}, {sensor, [[84, 170]]}]),
    #{armed := [{bitflip, 0, 0}], sent := [<<84, 170>>], received := [Packet]} = Step,
    ?assertMatch(
        #{sent := <<84, 170>>, bytes := <<85, 170>>, activations := 1, fired := false,
            status := none},
        Packet
    ),
    ?assertEqual([{0, 0}], airbag_trace:flipped(Packet)).

repetition() ->
    #{steps := [_, _, Step], result := {postcondition, false}} = Trace =
        run(plain(), [{bit_flip, [0, 0]}, {repetition, [2]}, {sensor, [[84, 170]]}]),
    #{received := Received, value := {value, 1}} = Step,
    ?assertEqual(
        [{1, false}, {2, true}, {3, true}],
        [{Count, Fired} || #{activations := Count, fired := Fired} <- Received]
    ),
    #{steps := [_, Repeated, Once]} =
        run(plain(), [{repetition, [1]}, {sensor, [[1, 2]]}, {sensor, [[1, 2]]}]),
    ?assertMatch(#{armed := [{repetition, 1}], received := [_, _]}, Repeated),
    ?assertMatch(#{armed := [], received := [_]}, Once),
    ?assertEqual([{1, 3}, {2, 3}, {3, 3}], [{N, At} || {N, At, _} <- airbag_trace:packets(Trace)]).

explosion() ->
    #{steps := [_, Step], result := ok} =
        run(plain(), [{bit_flip, [1, 7]}, {explosion, [[85, 170]]}]),
    #{armed := [], received := [First, Second]} = Step,
    ?assertEqual([], airbag_trace:flipped(First)),
    ?assertMatch(#{activations := 2, fired := true, sent := <<85, 170>>}, Second).

%% The checksums come from the reference by division: remainder over Data ID and protected bytes.
protected() ->
    Options = airbag_options:new(#{protection => e2e, configuration => recommended}),
    Messages = [{sensor, [[N, 170]]} || N <- [1, 2, 3]],
    #{steps := Steps, covered := 4} = run(Options, Messages ++ [{bit_flip, [3, 0]} | Messages]),
    Sent = [Bytes || #{sent := [Bytes]} <- Steps],
    ?assertEqual([0, 1, 2, 3, 4, 5], [Last band 15 || <<_:3/binary, Last>> <- Sent]),
    [
        ?assertEqual(e2e_crc:remainder(crc8, <<16#23, 16#01, Rest/binary>>), Crc)
     || <<Crc, Rest/binary>> <- Sent
    ],
    Statuses = [Status || #{received := [#{status := Status}]} <- Steps],
    ?assertEqual([initial, ok, ok, wrong_crc, wrong_crc, wrong_crc], Statuses).

not_run() ->
    #{steps := Steps} =
        run(plain(), [{bit_flip, [0, 0]}, {repetition, [1]}, {sensor, [[84, 170]]},
            {sensor, [[1, 2]]}]),
    #{value := none, sent := [], received := []} = lists:last(Steps).

%% airbag_seen counts what the recording says packet by packet.
counters() ->
    Options = airbag_options:new(#{protection => e2e}),
    Calls =
        [{sensor, [[N, 170]]} || N <- lists:seq(1, 5)] ++
            [{bit_flip, [1, 2]}, {repetition, [3]}] ++
            [{sensor, [[N, 170]]} || N <- lists:seq(1, 5)],
    ok = airbag_eqc:begin_test(Options),
    _ = airbag_sut:calls([{airbag_clear_statuses, []}]),
    Trace = run(Options, Calls),
    Statuses = [Status || {_, _, #{status := Status}} <- airbag_trace:packets(Trace)],
    Seen = maps:remove(no_new_data, airbag_sut:value_of(airbag_seen)),
    %% one of them four times
    ?assertEqual(9 + 4, length(Statuses)),
    maps:foreach(
        fun(Status, Count) ->
            ?assertEqual({Status, Count}, {Status, length([S || S <- Statuses, S =:= Status])})
        end,
        Seen
    ).

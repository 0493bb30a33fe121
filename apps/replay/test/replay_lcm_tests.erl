-module(replay_lcm_tests).
-include_lib("eunit/include/eunit.hrl").

%% ---- liblcm's messages ----

messages_of_liblcm_are_read_and_written_alike_test() ->
    Messages = replay_lcm_peer:messages(),
    ?assertEqual(120, length(Messages)),
    lists:foreach(
        fun(#{<<"type">> := Name, <<"channel">> := Channel, <<"value">> := Value,
              <<"bytes">> := Hex}) ->
            Type = binary_to_existing_atom(Name),
            Bytes = replay_lcm_peer:bytes(Hex),
            {ok, Type, Message} = replay_lcm:decode(Bytes),
            ?assertEqual(replay_lcm_peer:value(Type, Value), Message),
            ?assertEqual(Bytes, replay_lcm:encode(Type, Message)),
            ?assertEqual(Channel, replay_lcm:channel(Type))
        end,
        Messages
    ).

every_channel_has_a_type_test() ->
    Types = [Type || {Type, _} <- replay_lcm:channels()],
    ?assertEqual([], Types -- maps:keys(replay_lcm_type:schema())),
    ?assertEqual(10, length(lists:usort([C || {_, C} <- replay_lcm:channels()]))).

%% ---- Encoding ----

ack() -> #{client => "a", seq => 7, ok => 1, text => <<"no">>}.

bytes_are_those_of_the_definition_test() ->
    %% by hand: fingerprint (lcm-gen), length with NUL, text, NUL, i32, i8
    ?assertEqual(<<16#c172967dd907c581:64, 2:32, "a", 0, 7:32, 1, 3:32, "no", 0>>,
                 replay_lcm:encode(ack, ack())).

text_may_be_any_chardata_test() ->
    Bytes = replay_lcm:encode(ack, (ack())#{text := [$x, "\x{e4}", <<"\x{20ac}"/utf8>>]}),
    {ok, #{text := Text}} = replay_lcm:decode(ack, Bytes),
    ?assertEqual(<<"x\x{e4}\x{20ac}"/utf8>>, Text).

counts_are_made_from_the_lists_test() ->
    Risk = #{t_us => 1, run => 1, observer => -1, ellipses => []},
    ?assertEqual(replay_lcm:encode(risk, Risk), replay_lcm:encode(risk, Risk#{n => 99})).

a_number_too_large_for_a_float_is_infinite_test() ->
    Range = #{anchor => 0, measured => 1.0e300, expected => -1.0e300, used => 0},
    Bytes = replay_lcm:encode(ranges, #{t_us => 0, run => 1, object => 0, items => [Range]}),
    {ok, #{items := [Decoded]}} = replay_lcm:decode(ranges, Bytes),
    ?assertMatch(#{measured := inf, expected := neg_inf}, Decoded).

what_is_no_such_message_is_named_test_() ->
    [?_assertError({replay, Line}, replay_lcm:encode(Type, Message)) || {Line, Type, Message} <- [
        {"ack: `text' is missing", ack, maps:remove(text, ack())},
        {"ack.seq: expected an integer of 32 bits, not 2147483648", ack,
         (ack())#{seq := 1 bsl 31}},
        {"ack.ok: expected an integer of 8 bits, not true", ack, (ack())#{ok := true}},
        {"ack.client: expected text, not 7", ack, (ack())#{client := 7}},
        {"ack.client: expected text without NUL, not <<0>>", ack, (ack())#{client := <<0>>}},
        {"risk.ellipses: expected a list, not none", risk,
         #{t_us => 0, run => 1, observer => 0, ellipses => none}},
        {"risk.ellipses: expected a map, not 1", risk,
         #{t_us => 0, run => 1, observer => 0, ellipses => [1]}},
        {"world.seg: expected a list of 4, not [1]", world,
         #{run => 1, version => 1, seg => [[1]], anchors => [], polys => []}},
        {"world.seg: expected a number, inf, neg_inf or nan, not x", world,
         #{run => 1, version => 1, seg => [[1, 2, 3, x]], anchors => [], polys => []}},
        {"frame.t_us: expected an integer of 64 bits, not 1.5", frame,
         #{t_us => 1.5, run => 1, seq => 0, objects => []}},
        {"frame.objects: `id' is missing", frame,
         #{t_us => 1, run => 1, seq => 0, objects => [#{}]}}
    ]].

%% ---- Hostile bytes ----

what_cannot_be_decoded_is_one_line_test_() ->
    Head = <<16#d89b075ea021c860:64, 0:64, 1:32, 0:32>>,
    [?_assertEqual({error, Line}, replay_lcm:decode(Bytes)) || {Line, Bytes} <- [
        {"shorter than a fingerprint", <<1, 2, 3>>},
        {"no type has the fingerprint 0000000000000001: sender or receiver is of another version",
         <<1:64, 0:64>>},
        {"risk.observer: int32_t does not fit in 3 bytes", binary:part(Head, 0, 23)},
        {"risk.ellipses: -1 of them cannot be in 0 bytes", <<Head/binary, -1:32>>},
        {"risk.ellipses: 2147483647 of them cannot be in 1 bytes",
         <<Head/binary, 16#7fffffff:32, 0>>},
        {"risk: 1 bytes too many", <<Head/binary, 0:32, 0>>},
        {"ack.client: text of 0 bytes cannot be in 11",
         <<16#c172967dd907c581:64, 0:32, 0:32, 0, 1:32, 0:16>>},
        {"ack.client: text of 2147483647 bytes cannot be in 2",
         <<16#c172967dd907c581:64, 16#7fffffff:32, "ab">>},
        {"ack.client: text of 2 bytes without a NUL at its end only",
         <<16#c172967dd907c581:64, 2:32, "ab", 0:32, 0, 1:32, 0>>},
        {"ack.client: text of 3 bytes without a NUL at its end only",
         <<16#c172967dd907c581:64, 3:32, 0, "b", 0, 0:32, 0, 1:32, 0>>},
        {"frame.objects: 2 of them cannot be in 78 bytes",
         <<16#4bd969c0a5717aeb:64, 0:64, 0:32, 0:32, 2:32, 0:(78 * 8)>>}
    ]].

another_type_is_not_taken_for_the_one_asked_test() ->
    Bytes = replay_lcm:encode(ack, ack()),
    ?assertEqual({error, "risk: type mismatch, fingerprint c172967dd907c581 instead of "
                         "d89b075ea021c860"}, replay_lcm:decode(risk, Bytes)),
    ?assertEqual({error, "risk: shorter than a fingerprint"}, replay_lcm:decode(risk, <<1>>)).

%% ---- Frames by hand ----

object(Id) ->
    #{id => Id, kind => 0, flags => 2, pos => [1.5, -2.0, 0.5], vel => [0.25, 0.0, 0.0],
      yaw => 0.5, roll => 0.25, pitch => -0.25, pos_est => [1.0, -2.0, 0.5],
      vel_est => [0.0, 0.0, 0.0], comfort => 1.0, steer => [0.0, 0.125]}.

frames_by_hand_are_those_of_the_schema_test() ->
    Frame = #{t_us => 20000, run => 1, seq => 2, objects => [object(1), object(2)]},
    {ok, ByHand} = replay_lcm_frame:encode(Frame),
    %% A NaN makes the general way judge; the bytes but its own are the same.
    [First, Second] = maps:get(objects, Frame),
    General = replay_lcm:encode(frame, Frame#{objects := [First, Second#{yaw := nan}]}),
    unusual = replay_lcm_frame:encode(Frame#{objects := [First, Second#{yaw := nan}]}),
    At = 28 + 78 + 30,
    <<A:At/binary, _:32, B/binary>> = General,
    ?assertMatch(<<A:At/binary, 0.5:32/float, B/binary>>, ByHand),
    ?assertEqual({ok, frame, Frame#{n => 2}}, replay_lcm:decode(ByHand)).

whole_numbers_are_reals_too_test() ->
    Frame = #{t_us => 0, run => 1, seq => 0, objects => [(object(1))#{yaw := 1}]},
    {ok, #{objects := [#{yaw := Yaw}]}} = replay_lcm:decode(frame, replay_lcm:encode(frame, Frame)),
    ?assertEqual(1.0, Yaw).

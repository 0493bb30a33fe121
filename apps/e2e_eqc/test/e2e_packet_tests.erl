-module(e2e_packet_tests).
-include_lib("eunit/include/eunit.hrl").

%% The worked examples that the protocol specification publishes, all-zero data (e2e.md section 3).
published_test_() ->
    [
        {lists:concat([P, " ", Hex]), fun() ->
            Packet = e2e_packet:protect(P, Config, Counter, <<0:Bytes/unit:8>>),
            ?assertEqual(Hex, hex(binary:part(Packet, 0, length(Hex) div 2))),
            ?assertEqual({Counter, true}, e2e_packet:inspect(P, Config, Packet))
        end}
     || {P, Config, Bytes, Examples} <- published(), {Counter, Hex} <- Examples
    ].

published() ->
    P11 = (e2e_configuration:example(p11))#{'DataID' := 16#123},
    P22 = (e2e_configuration:example(p22))#{'DataIDList' := lists:seq(1, 16)},
    Of = fun e2e_configuration:example/1,
    [
        {p11, P11#{'DataIDMode' := 0}, 8, [{0, "cc00"}, {1, "9101"}]},
        {p11, P11, 8, [{0, "2a10"}, {1, "7711"}]},
        {p22, P22, 8, [{1, "1b01"}, {2, "9802"}, {3, "3103"}, {0, "0e00"}]},
        {p04, Of(p04), 16, [{0, "001000000a0b0c0d862b055600000000"}]},
        {p44, Of(p44), 16, [{0, "001000000a0b0c0d862b055600000000"}]},
        {p05, Of(p05), 8, [{0, "1cca00"}]},
        {p06, Of(p06), 8, [{0, "b155000800"}]},
        {p07, Of(p07), 24, [{0, "1fb2e737fcedbcd900000018000000000a0b0c0d"}]},
        {p08, Of(p08), 20, [{0, "41494e5200000014000000000a0b0c0d"}]}
    ].

%% The recommended airbag configuration of e2e.md section 9.
airbag_test() ->
    Config = e2e_configuration:example(p01),
    Packets = [e2e_packet:protect(p01, Config, C, <<0, 85, 170, 0>>) || C <- [0, 1, 2]],
    ?assertEqual(["6d55aa00", "7055aa01", "5755aa02"], [hex(P) || P <- Packets]).

checksums_test() ->
    Expected = ["4b", "df", "29b1", "bb3d", "cbf43926", "1697d06a", "995dc9bbdf1939fa"],
    Found = [
        hex(<<(e2e_crc:calculate(A, <<"123456789">>)):(e2e_crc:width(A))>>)
     || A <- e2e_crc:algorithms()
    ],
    ?assertEqual(Expected, Found).

hex(Bytes) -> lists:flatten([io_lib:format("~2.16.0b", [B]) || <<B>> <= Bytes]).

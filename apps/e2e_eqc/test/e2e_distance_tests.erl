-module(e2e_distance_tests).
-include_lib("eunit/include/eunit.hrl").

%% e2e.md section 9 has these from an enumeration of every pattern.
recommended_airbag_test() ->
    Config = e2e_configuration:example(p01),
    ?assertEqual({3, 18}, e2e_distance:least(p01, Config, 4, 4)),
    ?assertEqual(128, e2e_distance:undetected(p01, Config, 4, 4)),
    ?assertEqual([32, 496, 4960, 35960], [e2e_distance:patterns(32, N) || N <- [1, 2, 3, 4]]).

thesis_airbag_test() ->
    Config = (e2e_configuration:example(p01))#{'DataLength' := 16, 'DataID' := 0},
    ?assertEqual({1, 16}, e2e_distance:least(p01, Config, 4, 4)).

p05_of_five_bytes_test() ->
    Config = (e2e_configuration:example(p05))#{'DataLength' := 40},
    ?assertEqual({4, 8}, e2e_distance:least(p05, Config, 5, 4)).

%% Five and six flips are counted in another way than fewer. Codes made by hand: all of the first
%% five add up to 0; two sets of six share one of them.
five_and_six_flips_test() ->
    ?assertEqual({5, 1}, e2e_distance:least_of([1, 2, 4, 8, 15], 6)),
    ?assertEqual({6, 1}, e2e_distance:least_of([1, 2, 4, 8, 16, 31], 6)),
    Two = [1, 2, 4, 8, 16, 31, 32, 64, 128, 256, 1 bxor 32 bxor 64 bxor 128 bxor 256],
    ?assertEqual({6, 2}, e2e_distance:least_of(Two, 6)),
    ?assertEqual({above, 6}, e2e_distance:least_of([1, 2, 4, 8, 16, 32], 6)).

%% Where the counter chooses the Data ID, for each of its values.
special_counters_test_() ->
    Alt = (e2e_configuration:example(p01))#{'DataIDMode' := 1, 'DataLength' := 24,
        'CounterOffset' := 12},
    Short = fun(P, Bytes) -> (e2e_configuration:example(P))#{'DataLength' := 8 * Bytes} end,
    [
        {lists:concat([P, " ", Flips]), fun() ->
            ?assertEqual(counted(P, Config, Bytes, Flips),
                e2e_distance:undetected(P, Config, Bytes, Flips))
        end}
     || {P, Config, Bytes} <- [{p01, Alt, 3}, {p02, Short(p02, 4), 4}, {p22, Short(p22, 3), 3}],
        Flips <- [1, 2, 3]
    ].

%% Most patterns that leave a packet intact, over all counters: by trying them on the reference.
counted(P, Config, Bytes, Flips) ->
    Counters = lists:seq(0, e2e_packet:counters(P) - 1),
    lists:max([counted(P, Config, Bytes, Flips, C) || C <- Counters]).

counted(P, Config, Bytes, Flips, Counter) ->
    Packet = e2e_packet:protect(P, Config, Counter, <<16#A5, 0:(Bytes - 1)/unit:8>>),
    Size = bit_size(Packet),
    <<Number:Size>> = Packet,
    length([
        mask
     || Mask <- masks(Size, Flips),
        element(2, e2e_packet:inspect(P, Config, <<(Number bxor Mask):Size>>))
    ]).

masks(_, 0) -> [0];
masks(Size, Flips) when Size < Flips -> [];
masks(Size, Flips) ->
    masks(Size - 1, Flips) ++ [(1 bsl (Size - 1)) bor M || M <- masks(Size - 1, Flips - 1)].

%% libe2e refuses every packet with fewer flipped bits than the distance: all of one or two tried.
two_flips_test_() ->
    {setup,
        fun() -> {ok, _} = application:ensure_all_started(c_bridge), ok end,
        fun(_) -> e2e_sut:stop() end,
        fun(_) -> [{atom_to_list(P), fun() -> refuses(P) end} || P <- e2e_packet:profiles()] end}.

refuses(P) ->
    Config = e2e_configuration:example(P),
    {Bytes, _} = e2e_packet:lengths(P, Config),
    ok = e2e_sut:prepare(),
    Machine = #{'WindowSizeValid' => 1, 'WindowSizeInit' => 1, 'WindowSizeInvalid' => 1},
    [ok, ok, ok] = e2e_sut:open(P, Config, Machine),
    {ok, Packet} = e2e_sut:protect(<<16#5A, 0:(Bytes - 1)/unit:8>>),
    Size = bit_size(Packet),
    <<Number:Size>> = Packet,
    Accepted = [
        Mask
     || Flips <- [1, 2],
        Flips < least(e2e_distance:least(P, Config, Bytes, 2)),
        Mask <- masks(Size, Flips),
        e2e_sut:check(<<(Number bxor Mask):Size>>) =:= ok,
        not lists:member(maps:get('Status', e2e_sut:receiver()), ['ERROR', 'WRONGCRC'])
    ],
    ?assertEqual([], Accepted).

least({above, N}) -> N + 1;
least({N, _}) -> N.

-module(airbag_eqc_tests).
-include_lib("eunit/include/eunit.hrl").

with(Changes, Test) ->
    ok = airbag_options:use(airbag_options:new(Changes)),
    Test(airbag_eqc:initial_state()).

flip(S, Byte, Bit) -> airbag_eqc:bit_flip_next(S, ok, [Byte, Bit]).
repeat(S, N) -> airbag_eqc:repetition_next(S, ok, [N]).

a_message_is_anything_but_the_one_that_fires_test() ->
    with(#{}, fun(S) ->
        ?assert(airbag_eqc:sensor_pre(S, [[84, 170]])),
        ?assertNot(airbag_eqc:sensor_pre(S, [[85, 170]]))
    end).

four_faults_are_the_most_test() ->
    with(#{}, fun(S0) ->
        S3 = repeat(flip(flip(S0, 0, 0), 1, 0), 2),
        ?assert(airbag_eqc:bit_flip_pre(S3)),
        S4 = flip(S3, 2, 0),
        ?assertNot(airbag_eqc:bit_flip_pre(S4)),
        ?assertNot(airbag_eqc:repetition_pre(S4)),
        ?assertNot(airbag_eqc:bit_flip_pre(S4, [3, 0]))
    end).

a_fault_is_armed_once_test() ->
    with(#{}, fun(S0) ->
        S = repeat(flip(S0, 1, 7), 3),
        ?assertNot(airbag_eqc:bit_flip_pre(S, [1, 7])),
        ?assert(airbag_eqc:bit_flip_pre(S, [1, 6])),
        ?assertNot(airbag_eqc:repetition_pre(S, [3])),
        ?assert(airbag_eqc:repetition_pre(S, [1]))
    end).

flips_can_be_limited_and_faults_left_out_test() ->
    with(#{max_flips => 2}, fun(S0) ->
        S = flip(flip(S0, 0, 0), 1, 0),
        ?assertNot(airbag_eqc:bit_flip_pre(S)),
        ?assert(airbag_eqc:repetition_pre(S))
    end),
    with(#{faults => [bit_flip]}, fun(S) ->
        ?assertNot(airbag_eqc:repetition_pre(S)),
        ?assert(airbag_eqc:bit_flip_pre(S))
    end).

a_bare_packet_has_two_bytes_test() ->
    with(#{protection => plain}, fun(S) ->
        ?assert(airbag_eqc:bit_flip_pre(S, [1, 0])),
        ?assertNot(airbag_eqc:bit_flip_pre(S, [2, 0]))
    end).

explosion_clears_the_faults_but_not_in_the_papers_model_test() ->
    Explode = fun(S) ->
        airbag_eqc:armed_faults(airbag_eqc:explosion_next(flip(S, 0, 1), 1, [[85, 170]]))
    end,
    with(#{}, fun(S) -> ?assertEqual([], Explode(S)) end),
    with(#{fault_list => paper}, fun(S) -> ?assertEqual([{bitflip, 0, 1}], Explode(S)) end).

%% Every variant runs through the real library; without faults nothing can fail.
every_variant_runs_test_() ->
    Variants = [
        #{protection => P, configuration => C, generator => G, fault_list => F, faults => []}
     || P <- [plain, e2e], C <- [thesis, recommended], G <- [byte, focused], F <- [cleared, paper]
    ],
    {setup, fun airbag_test_sut:port/0, fun(_) -> ok end, [
        {airbag_options:label(airbag_options:new(V)), fun() -> passes(V) end}
     || V <- Variants
    ]}.

passes(Changes) ->
    Airbag = airbag_options:new(Changes),
    airbag_experiment:in_state(Airbag, fun() ->
        Results = [element(2, airbag_experiment:test(Airbag, 1, N)) || N <- lists:seq(1, 42)],
        ?assertEqual([ok], lists:usort([R || {_, _, R} <- Results]))
    end).

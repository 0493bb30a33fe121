-module(airbag_sut_tests).
-include_lib("eunit/include/eunit.hrl").

the_library_is_found_in_the_clone_test() ->
    ?assert(filelib:is_regular(airbag_sut:library())).

sut_test_() ->
    {setup, fun airbag_test_sut:port/0, fun(_) -> ok end, [
        {"a test starts with nothing of the one before", fun resets/0},
        {"options are those of the test that begins", fun configures/0},
        {"both transports give the same results", fun transports/0}
    ]}.

resets() ->
    Plain = airbag_options:new(#{protection => plain}),
    ok = airbag_sut:begin_test(Plain),
    [_, _, _, 1] = airbag_sut:calls([
        {faultcheck_packet_addFaultRepeat, [<<"airbag">>, 1]},
        {sensor, [[85, 170]]},
        {airbag_iteration, []},
        {airbag_is_active, []}
    ]),
    %% left in the channel, and a fault armed
    [_, _] = airbag_sut:calls([
        {sensor, [[85, 170]]},
        {faultcheck_packet_addFaultCorruptionBitFlip, [<<"airbag">>, 0, 1]}
    ]),
    ok = airbag_sut:begin_test(Plain),
    ?assertEqual(0, airbag_sut:value_of(airbag_active)),
    [_, _] = airbag_sut:calls([{sensor, [[85, 170]]}, {airbag_iteration, []}]),
    ?assertEqual(1, airbag_sut:value_of(activations)),
    ok = airbag_sut:stop().

configures() ->
    One = airbag_options:new(#{protection => plain, needed => 1}),
    Two = airbag_options:new(#{protection => plain, needed => 2}),
    Fires = fun(Options) ->
        ok = airbag_sut:begin_test(Options),
        lists:last(
            airbag_sut:calls([
                {sensor, [[85, 170]]}, {airbag_iteration, []}, {airbag_is_active, []}
            ])
        )
    end,
    ?assertEqual([1, 0, 1], [Fires(O) || O <- [One, Two, One]]),
    ok = airbag_sut:stop().

%% Without explosions, because in nif the airbag prints where this VM does.
transports() ->
    Airbag = airbag_options:new(#{configuration => recommended}),
    Results = fun(Transport) ->
        ok = airbag_sut:default_transport(Transport),
        airbag_experiment:in_state(Airbag, fun() ->
            [results(Airbag, commands(N)) || N <- lists:seq(1, 42)]
        end)
    end,
    Port = Results(port),
    Nif = Results(nif),
    ok = airbag_sut:default_transport(port),
    ?assertEqual(Port, Nif),
    ?assert(length(lists:append([History || {History, _} <- Port])) > 100).

commands(N) ->
    faultcheck_proper:with_state(N, {1, 2, N}, fun() ->
        {Commands, _} = faultcheck_generator:generate(airbag_eqc, N),
        Commands
    end).

results(Airbag, Commands) ->
    Quiet = [C || {set, _, {call, _, Name, _}} = C <- Commands, Name =/= explosion],
    ok = airbag_sut:begin_test(Airbag),
    {History, _, Result} = faultcheck_statem:run_commands(airbag_eqc, Quiet),
    {[Value || {_, Value} <- History], Result}.

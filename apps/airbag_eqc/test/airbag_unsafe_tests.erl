-module(airbag_unsafe_tests).
-include_lib("eunit/include/eunit.hrl").

unsafe_test_() ->
    {setup, fun airbag_test_sut:port/0, fun(_) -> ok end, [
        {"the same seed finds the same failure", {timeout, 60, fun same/0}},
        {"it takes a flip, a repetition and a message", {timeout, 60, fun minimal/0}},
        {"an airbag that cannot be started is no failure found", fun unstarted/0},
        {"one flip is enough where one message fires", {timeout, 60, fun one_needed/0}}
    ]}.

find(Changes, Seed) ->
    Airbag = airbag_options:new(Changes#{protection => plain, generator => focused}),
    {found, Commands} = airbag_unsafe:find(Airbag, Seed),
    [{Name, Args} || {set, _, {call, airbag_eqc, Name, Args}} <- Commands].

same() ->
    ?assertEqual(find(#{}, 11), find(#{}, 11)).

minimal() ->
    Commands = find(#{}, 3),
    ?assert(length(Commands) =< 3),
    ?assertMatch({sensor, [[_, 170]]}, lists:last(Commands)).

one_needed() ->
    [{bit_flip, [0, Bit]}, {sensor, [[X, 170]]}] = find(#{needed => 1}, 5),
    ?assertEqual(85, X bxor (1 bsl Bit)).

unstarted() ->
    ok = application:set_env(airbag_eqc, library, "/nowhere/libairbag.so"),
    try
        ?assertError({cb, {load, _, _}}, find(#{}, 1))
    after
        application:unset_env(airbag_eqc, library)
    end.

-module(airbag_options_tests).
-include_lib("eunit/include/eunit.hrl").

unknown_options_and_values_are_named_test() ->
    ?assertError({unknown_airbag_options, [speed]}, airbag_options:new(#{speed => 1})),
    ?assertError({bad_airbag_options, [{needed, 0}]}, airbag_options:new(#{needed => 0})),
    ?assertError(
        {bad_airbag_options, [{protection, none}]}, airbag_options:new(#{protection => none})
    ).

the_options_belong_to_the_process_test() ->
    Plain = airbag_options:new(#{protection => plain}),
    ok = airbag_options:use(Plain),
    Self = self(),
    {Pid, Ref} = spawn_monitor(fun() -> Self ! {self(), airbag_options:current()} end),
    receive
        {'DOWN', Ref, process, Pid, normal} -> ok
    end,
    receive
        {Pid, Other} -> ?assertMatch(#{protection := e2e}, Other)
    end,
    ?assertEqual(Plain, airbag_options:current()).

labels_say_what_differs_test() ->
    Label = fun(Changes) -> airbag_options:label(airbag_options:new(Changes)) end,
    ?assertEqual("plain, byte generator, 1 needed", Label(#{protection => plain, needed => 1})),
    ?assertEqual("E2E thesis, focused generator", Label(#{generator => focused})),
    ?assertEqual(
        "E2E recommended, byte generator, at most 2 flips",
        Label(#{configuration => recommended, max_flips => 2})
    ).

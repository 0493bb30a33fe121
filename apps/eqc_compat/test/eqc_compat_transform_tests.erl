%% A model written for Quviq runs after its two include lines are replaced.
-module(eqc_compat_transform_tests).

-include_lib("eunit/include/eunit.hrl").

-define(INCLUDES, "-include_lib(\"eqc/include/eqc.hrl\").\n"
                  "-include_lib(\"eqc/include/eqc_statem.hrl\").\n").

data(File) ->
    filename:join([filename:dirname(code:which(?MODULE)), "data", File]).

%% The model with nothing else changed, compiled and loaded.
load_model() ->
    {ok, Text} = file:read_file(data("seatheater_eqc.erl.txt")),
    Ours = "-include_lib(\"eqc_compat/include/eqc_compat.hrl\").\n",
    [Before, After] = string:split(Text, ?INCLUDES),
    Dir = filename:join([element(2, file:get_cwd()), "_build", "test", "generated"]),
    File = filename:join(Dir, "seatheater_eqc.erl"),
    ok = filelib:ensure_dir(File),
    ok = file:write_file(File, [Before, Ours, After]),
    {ok, Mod, Binary} = compile:file(File, [binary, report, {d, 'C_SOURCE', data("seatheater.c")}]),
    {module, Mod} = code:load_binary(Mod, File, Binary),
    Mod.

in_both_transports_the_failure_is_found_and_shrunk_test_() ->
    [{atom_to_list(Transport), {timeout, 120, fun() -> found_and_shrunk(Transport) end}}
     || Transport <- [nif, port]].

found_and_shrunk(Transport) ->
    Mod = load_model(),
    ok = application:set_env(c_bridge, force_transport, Transport),
    try
        ok = Mod:start(),
        Property = eqc:numtests(3000, Mod:prop_heater()),
        Printed = printing(
                    fun(Print) ->
                            false = eqc:quickcheck(Property, [{on_output, Print},
                                                              {start_size, 20}])
                    end),
        [Commands] = eqc:counterexample(),
        ok = eqc_c:stop(),
        %% Only an occupied seat keeps the count over a cool sample.
        ?assertMatch([{occupy, [1]}, {sample, [[61, 20]]}, {sample, [[61, 20]]},
                      {sample, [[0, 20]]}, {sample, [[61, 20]]}],
                     occupied_first([{Name, Args} || {set, _, {call, _, Name, Args}} <- Commands])),
        ?assertMatch(#{minimal := true}, faultcheck_statem:last_shrink()),
        ?assertNotEqual(nomatch, string:find(Printed, "Failed"))
    after
        application:unset_env(c_bridge, force_transport)
    end.

%% Where the seat is occupied does not matter as long as it is before the cool sample.
occupied_first(Steps) ->
    {Occupy, Samples} = lists:partition(fun({Name, _}) -> Name =:= occupy end, Steps),
    Hot = fun({sample, [[Degrees, _]]}) -> Degrees > 60 end,
    {HotOnes, CoolOnes} = lists:partition(Hot, Samples),
    case {HotOnes, CoolOnes} of
        {[A, B, C], [Cool]} -> Occupy ++ [A, B, Cool, C];
        {_, _} -> Steps
    end.

printing(Fun) ->
    Self = self(),
    Ref = make_ref(),
    Fun(fun(Format, Args) -> Self ! {Ref, io_lib:format(Format, Args)}, ok end),
    lists:flatten(printed(Ref)).

printed(Ref) ->
    receive {Ref, Text} -> [Text | printed(Ref)] after 0 -> [] end.

%% The type of the header gives way to one of the model's own.
own_types_replace_those_of_the_header_test() ->
    Dir = filename:join([element(2, file:get_cwd()), "_build", "test", "generated"]),
    File = filename:join(Dir, "own_types.erl"),
    ok = filelib:ensure_dir(File),
    ok = file:write_file(File, ["-module(own_types).\n"
                                "-include_lib(\"eqc_compat/include/eqc_compat.hrl\").\n"
                                "-type symbolic_state() :: integer().\n"
                                "-spec initial_state() -> symbolic_state().\n"
                                "initial_state() -> 0.\n"
                                "tick_args(_) -> [].\n"
                                "tick() -> ok.\n"]),
    ?assertMatch({ok, own_types, _}, compile:file(File, [binary, report, warnings_as_errors])).

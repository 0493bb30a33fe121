%% Against libfaultcheck itself.
-module(faultcheck_inject_tests).

-include_lib("eunit/include/eunit.hrl").

inject_test_() ->
    {setup, fun start/0, fun cb:stop/1, fun(Lib) ->
        [
            {atom_to_list(element(2, erlang:fun_info(Test, name))), fun() -> fresh(Lib, Test) end}
         || Test <- [
                fun an_armed_fault_alters_the_probe/1,
                fun a_trigger_says_when/1,
                fun a_fault_is_disabled_and_removed/1,
                fun all_faults_are_removed/1,
                fun contexts_are_apart/1,
                fun packets_are_altered/1,
                fun what_is_invalid_is_refused/1,
                fun what_the_library_refuses_is_told/1,
                fun every_value_model_can_be_armed/1,
                fun realistic_faults_can_be_armed/1,
                fun parameters_by_name_are_those_of_the_terms/1
            ]
        ]
    end}.

start() ->
    App = code:lib_dir(faultcheck),
    Root = lists:foldl(fun(_, D) -> filename:dirname(D) end, App, [1, 2, 3, 4]),
    File = filename:join([Root, "_build", "native", "lib", "libfaultcheck.so"]),
    {ok, Lib} = cb:start(faultcheck_inject_tests, [{so, File}, {transport, nif}, {reset, none},
                                                   {module, false}]),
    Lib.

fresh(Lib, Test) ->
    ok = cb:call(Lib, fc_reset, [null]),
    Test(Lib).

probe(Lib, Context, Id, Value) ->
    Buffer = cb:create_array(Lib, double, [Value]),
    0 = cb:call(Lib, fc_probe_f64, [Context, Id, Buffer]),
    [Result] = cb:read(Lib, Buffer, 1),
    ok = cb:free(Lib, Buffer),
    Result.

probes(Lib, Id, Values) -> [probe(Lib, null, Id, V) || V <- Values].

an_armed_fault_alters_the_probe(Lib) ->
    {ok, Id} = faultcheck_inject:arm(Lib, null, {probe, <<"x">>}, {offset, 2.5}),
    ?assert(Id > 0),
    ?assertEqual([3.5, 4.5], probes(Lib, <<"x">>, [1.0, 2.0])).

a_trigger_says_when(Lib) ->
    Fault = {{offset, 1}, [{for, 2}, {from, 1}]},
    {ok, Id} = faultcheck_inject:arm(Lib, null, {probe, <<"x">>}, Fault),
    ?assertEqual([0.0, 1.0, 1.0, 0.0], probes(Lib, <<"x">>, [0.0, 0.0, 0.0, 0.0])),
    ok = faultcheck_inject:trigger(Lib, null, Id, [{periodic, 2, 1}]),
    ?assertEqual([1.0, 0.0, 1.0, 0.0], probes(Lib, <<"x">>, [0.0, 0.0, 0.0, 0.0])).

a_fault_is_disabled_and_removed(Lib) ->
    {ok, Id} = faultcheck_inject:arm(Lib, null, {probe, <<"x">>}, {offset, 1}),
    ok = faultcheck_inject:enable(Lib, null, Id, false),
    ?assertEqual([0.0], probes(Lib, <<"x">>, [0.0])),
    ok = faultcheck_inject:enable(Lib, null, Id, true),
    ?assertEqual([1.0], probes(Lib, <<"x">>, [0.0])),
    ok = faultcheck_inject:remove(Lib, null, Id),
    ?assertEqual([0.0], probes(Lib, <<"x">>, [0.0])),
    ?assertMatch({error, {'FC_E_NO_FAULT', _}}, faultcheck_inject:remove(Lib, null, Id)).

all_faults_are_removed(Lib) ->
    [{ok, _}, {ok, _}] =
        [faultcheck_inject:arm(Lib, null, {probe, Id}, {offset, 1}) || Id <- [<<"x">>, <<"y">>]],
    ok = faultcheck_inject:remove_all(Lib, null, {probe, <<"x">>}),
    ?assertEqual([0.0], probes(Lib, <<"x">>, [0.0])),
    ?assertEqual([1.0], probes(Lib, <<"y">>, [0.0])),
    ok = faultcheck_inject:remove_all(Lib, null, all),
    ?assertEqual([0.0], probes(Lib, <<"y">>, [0.0])).

contexts_are_apart(Lib) ->
    Other = cb:call(Lib, fc_new, [null]),
    {ok, _} = faultcheck_inject:arm(Lib, Other, {probe, <<"x">>}, {offset, 1}),
    ?assertEqual([0.0], probes(Lib, <<"x">>, [0.0])),
    ?assertEqual(1.0, probe(Lib, Other, <<"x">>, 0.0)),
    cb:call(Lib, fc_free, [Other]).

packets_are_altered(Lib) ->
    Fault = {{corruption, 1, 0}, [{from, 1}]},
    {ok, _} = faultcheck_inject:arm(Lib, null, {channel, <<"c">>}, Fault),
    [0, 0] = [cb:call(Lib, fc_channel_put, [null, <<"c">>, <<4, 5>>, 2]) || _ <- [1, 2]],
    Buffer = cb:create_array(Lib, 'unsigned char', [0, 0]),
    Got = [
        {cb:call(Lib, fc_channel_get, [null, <<"c">>, null, Buffer, 2, null]),
         cb:read_bytes(Lib, Buffer, 2)}
     || _ <- [1, 2]
    ],
    ?assertEqual([{1, <<4, 5>>}, {1, <<4, 4>>}], Got).

what_is_invalid_is_refused(Lib) ->
    Arm = fun(Where, Fault) -> faultcheck_inject:arm(Lib, null, Where, Fault) end,
    ?assertEqual({error, {invalid, "fault {drop,-1}: Packets is -1, expected an integer "
                                   "0..2147483647"}},
                 Arm({channel, <<"c">>}, {drop, -1})),
    ?assertMatch({error, {invalid, _}}, Arm({probe, <<"x">>}, lose)),
    ?assertMatch({error, {invalid, _}}, Arm({channel, <<"c">>}, stuck)),
    ?assertMatch({error, {invalid, _}}, Arm({channel, <<"c">>, <<"r">>}, block_put)),
    ?assertMatch({error, {invalid, _}}, Arm({probe, <<"a", 0>>}, stuck)),
    ?assertMatch({error, {invalid, _}}, Arm(nowhere, stuck)).

what_the_library_refuses_is_told(Lib) ->
    {error, {'FC_E_NO_FAULT', Text}} = faultcheck_inject:enable(Lib, null, 4711, true),
    ?assertNotEqual(nomatch, string:find(Text, "4711")).

every_value_model_can_be_armed(Lib) ->
    Faults = [F || F <- faultcheck_fault_tests:examples(), faultcheck_fault:stage(F) =:= probe],
    ?assert(length(Faults) > 19),
    [?assertMatch({ok, _}, faultcheck_inject:arm(Lib, null, {probe, <<"x">>}, F)) || F <- Faults].

realistic_faults_can_be_armed(Lib) ->
    Where = fun(F) ->
        case faultcheck_fault:class(F) of
            communication -> {channel, <<"ITS_DATA0">>};
            _ -> {probe, <<"RollId0">>}
        end
    end,
    [
        ?assertMatch({ok, _}, faultcheck_inject:arm(Lib, null, Where(F), F))
     || {_, _, Faults, _} <- faultcheck_fault_realistic:rows(), F <- Faults
    ].

%% docs/faults.md says so of fc_arm_named.
parameters_by_name_are_those_of_the_terms(Lib) ->
    Examples = [faultcheck_fault:model(F) || F <- faultcheck_fault_tests:examples()],
    Models = [M || M <- Examples, is_numeric(parameters(M))],
    ?assert(length(Models) > 25),
    [?assertMatch({_, Id} when Id > 0, {M, arm_named(Lib, M)}) || M <- Models].

arm_named(Lib, Model) ->
    Name = atom_to_binary(name(Model)),
    [#{parameters := Kinds} | _] = entries(Model),
    Arguments = [
        #{name => list_to_binary(string:lowercase(atom_to_list(P))), text => null, number => V}
     || {{P, _}, V} <- lists:zip(Kinds, parameters(Model)), V =/= none
    ],
    Function =
        case faultcheck_fault:class(Model) of
            communication -> fc_channel_arm_named;
            _ -> fc_arm_named
        end,
    cb:call(Lib, Function, [null, <<"x">>, Name, Arguments, length(Arguments)]).

entries(Model) -> faultcheck_fault_catalogue:find(name(Model)).

name(Model) when is_atom(Model) -> Model;
name(Model) -> element(1, Model).

parameters(Model) when is_atom(Model) -> [];
parameters(Model) -> tl(tuple_to_list(Model)).

%% Texts, units and models inside models have words of their own.
is_numeric(Parameters) ->
    lists:all(fun(P) -> is_number(P) orelse P =:= none orelse P =:= inf end, Parameters).

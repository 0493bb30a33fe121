-module(faultcheck_model_tests).

-include_lib("eunit/include/eunit.hrl").

model(Mod) -> {Mod, faultcheck_model:info(Mod)}.

commands_are_those_with_arguments_test() ->
    ?assertEqual([bit_flip, explosion, repetition, sensor],
                 faultcheck_model:commands(faultcheck_model:info(bag_model))).

faults_are_declared_by_the_model_test() ->
    ?assertEqual([bit_flip, repetition],
                 faultcheck_model:faults(faultcheck_model:info(bag_model))),
    ?assertEqual([], faultcheck_model:faults(faultcheck_model:info(chain_model))).

enabled_commands_have_their_weights_test() ->
    ?assertEqual([{1, bit_flip}, {1, explosion}, {1, repetition}, {10, sensor}],
                 faultcheck_model:enabled(model(bag_model), bag_model:initial_state())),
    ?assertEqual([{1, open}],
                 faultcheck_model:enabled(model(chain_model), chain_model:initial_state())).

optional_callbacks_have_defaults_test() ->
    Model = model(args_model),
    ?assert(faultcheck_model:allowed(Model, none, wide, [1])),
    ?assertEqual(none, faultcheck_model:next(Model, none, wide, [1], ok)),
    ?assertEqual(true, faultcheck_model:post(Model, none, wide, [1], ok)),
    ?assertEqual([], faultcheck_model:requirements(Model, none, wide, [1], ok)).

requirement_tags_come_from_the_model_test() ->
    ?assertEqual(['REQ-1'],
                 faultcheck_model:requirements(model(odd_model), #{ran => []}, fine, [1], 2)).

an_unknown_command_is_said_test() ->
    ?assertError({unknown_command, chain_model, nothing, _},
                 faultcheck_model:allowed(model(chain_model), none, nothing, [])).

what_is_no_model_is_said_test() ->
    ?assertError({not_a_model, lists, "it exports no X_args/1; does it include faultcheck.hrl?"},
                 faultcheck_model:info(lists)),
    ?assertError({not_a_model, no_such_model, "there is no such module in the code path"},
                 faultcheck_statem:run_commands(no_such_model, [])).

a_new_version_of_a_model_is_noticed_test() ->
    Load = fun(Command) ->
                   Forms = [form(T) || T <- ["-module(short_lived).", "-compile(export_all).",
                                             "initial_state() -> 0.",
                                             Command ++ "_args(_) -> [].",
                                             Command ++ "() -> ok."]],
                   {ok, short_lived, Binary} = compile:forms(Forms, []),
                   {module, _} = code:load_binary(short_lived, "short_lived.erl", Binary),
                   faultcheck_model:commands(faultcheck_model:info(short_lived))
           end,
    ?assertEqual([first], Load("first")),
    ?assertEqual([second], Load("second")).

form(Text) ->
    {ok, Tokens, _} = erl_scan:string(Text),
    {ok, Form} = erl_parse:parse_form(Tokens),
    Form.

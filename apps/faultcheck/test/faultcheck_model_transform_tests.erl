-module(faultcheck_model_transform_tests).

-include_lib("eunit/include/eunit.hrl").

-define(HEADER, "-module(m).\n-include(\"faultcheck.hrl\").\n").

%% A wrong model gives one line: file, line, what is wrong, what would be right.
wrong_models_test_() ->
    [{Name, ?_assertEqual([Line], errors(Source))} || {Name, Source, Line} <- wrong()].

wrong() ->
    [{"X_args is missing",
      "initial_state() -> 0.\n"
      "sensor_pre(_) -> true.\n"
      "sensor(_) -> ok.\n",
      "m.erl:4: sensor_pre/1 belongs to a command sensor, but sensor_args/1 is missing: write "
      "sensor_args(State) -> [Type, ...]"},
     {"X_next alone, its command misspelled",
      "initial_state() -> 0.\n"
      "tick_args(_) -> [].\n"
      "tick() -> ok.\n"
      "sensr_next(S, _, []) -> S.\n",
      "m.erl:6: sensr_next/3 belongs to a command sensr, but sensr_args/1 is missing: write "
      "sensr_args(State) -> [Type, ...]"},
     {"X is missing",
      "initial_state() -> 0.\n"
      "sensor_args(_) -> [byte()].\n",
      "m.erl:4: sensor_args/1 describes a command, but there is no function sensor: write "
      "sensor(Arg1, ...) with a parameter for each argument"},
     {"X_args has the wrong arity",
      "initial_state() -> 0.\n"
      "sensor_args() -> [byte()].\n"
      "sensor(_) -> ok.\n",
      "m.erl:4: sensor_args/0 has the wrong number of parameters: write sensor_args(State)"},
     {"X_pre has the wrong arity",
      "initial_state() -> 0.\n"
      "sensor_args(_) -> [byte()].\n"
      "sensor_pre(_, _, _) -> true.\n"
      "sensor(_) -> ok.\n",
      "m.erl:5: sensor_pre/3 has the wrong number of parameters: write "
      "sensor_pre(State) or sensor_pre(State, Args)"},
     {"X_next has the wrong arity",
      "initial_state() -> 0.\n"
      "sensor_args(_) -> [byte()].\n"
      "sensor(_) -> ok.\n"
      "sensor_next(S, _) -> S.\n",
      "m.erl:6: sensor_next/2 has the wrong number of parameters: write "
      "sensor_next(State, Result, Args)"},
     {"X_post has the wrong arity",
      "initial_state() -> 0.\n"
      "sensor_args(_) -> [byte()].\n"
      "sensor(_) -> ok.\n"
      "sensor_post(_) -> true.\n",
      "m.erl:6: sensor_post/1 has the wrong number of parameters: write "
      "sensor_post(State, Args, Result)"},
     {"X takes another number of arguments than X_args gives",
      "initial_state() -> 0.\n"
      "sensor_args(_) -> [byte()].\n"
      "sensor(_, _) -> ok.\n",
      "m.erl:4: sensor_args/1 gives 1 argument, but sensor/2 takes 2: make both agree"},
     {"a callback matches another number of arguments",
      "initial_state() -> 0.\n"
      "sensor_args(_) -> [byte(), byte()].\n"
      "sensor(_, _) -> ok.\n"
      "sensor_post(_, [_], R) -> R =:= ok.\n",
      "m.erl:6: sensor_post/3 matches a list of 1 argument, but sensor/2 takes 2"},
     {"initial_state/0 is missing",
      "sensor_args(_) -> [byte()].\n"
      "sensor(_) -> ok.\n",
      "m.erl:3: a model needs initial_state/0: write initial_state() -> State"},
     {"weight has the wrong arity",
      "initial_state() -> 0.\n"
      "sensor_args(_) -> [byte()].\n"
      "sensor(_) -> ok.\n"
      "weight(_) -> 1.\n",
      "m.erl:6: weight/1 has the wrong number of parameters: write weight(State, Command)"},
     {"faults has the wrong arity",
      "initial_state() -> 0.\n"
      "sensor_args(_) -> [byte()].\n"
      "sensor(_) -> ok.\n"
      "faults(_) -> [].\n",
      "m.erl:6: faults/1 has the wrong number of parameters: write faults() -> [Command]"}].

a_model_needs_no_exports_and_no_specs_test() ->
    Mod = load("initial_state() -> 0.\n"
               "sensor_pre(_) -> true.\n"
               "sensor_args(_) -> [byte()].\n"
               "sensor(_) -> ok.\n"
               "prop_p() -> true.\n",
               [warnings_as_errors, warn_missing_spec]),
    Exports = Mod:module_info(exports),
    [?assert(lists:member(E, Exports))
     || E <- [{initial_state, 0}, {sensor_pre, 1}, {sensor_args, 1}, {sensor, 1}, {prop_p, 0}]].

helpers_that_only_look_like_callbacks_are_left_alone_test() ->
    Mod = load("initial_state() -> 0.\n"
               "tick_args(_) -> [helper_next(1), is_pre(2)].\n"
               "tick(_, _) -> ok.\n"
               "helper_next(X) -> X.\n"
               "is_pre(X) -> X.\n", []),
    ?assertEqual([tick], faultcheck_model:commands(faultcheck_model:info(Mod))).

a_module_of_properties_alone_is_no_model_test() ->
    Mod = load("prop_p() -> ?FORALL(X, integer(), X =:= default_args(X)).\n"
               "default_args(X) -> X.\n", []),
    ?assertEqual(false, lists:member({command, 1}, Mod:module_info(exports))),
    ?assert(proper:quickcheck(Mod:prop_p(), [quiet])).

functions_that_proper_imports_can_be_defined_test() ->
    Mod = load("-export([b/0]).\n"
               "initial_state() -> 0.\n"
               "tick_args(_) -> [byte()].\n"
               "tick(_) -> ok.\n"
               "byte() -> 7.\n"
               "b() -> byte().\n", []),
    ?assertEqual(7, Mod:b()).

commands_and_run_commands_are_ours_test() ->
    Mod = load("-export([c/0, r/1]).\n"
               "initial_state() -> 0.\n"
               "tick_args(_) -> [].\n"
               "tick() -> exit(no).\n"
               "c() -> commands(?MODULE).\n"
               "r(C) -> run_commands(?MODULE, C).\n", []),
    ?assertMatch({[_], 0, {exception, exit, no, _}},
                 Mod:r([{set, {var, 1}, {call, Mod, tick, []}}])),
    ?assertEqual(faultcheck, proper_types:get_prop(kind, Mod:c())).

plain_callbacks_serve_the_tools_of_proper_statem_test() ->
    Mod = load("initial_state() -> 0.\n"
               "up_args(_) -> [exactly(2)].\n"
               "up_pre(S, _) -> S < 4.\n"
               "up(_) -> ok.\n"
               "up_next(S, _, [N]) -> S + N.\n", []),
    Up = fun(N) -> {set, {var, N}, {call, Mod, up, [2]}} end,
    ?assertEqual(4, proper_statem:state_after(Mod, [Up(1), Up(2)])),
    ?assertEqual(true, Mod:precondition(3, {call, Mod, up, [2]})),
    ?assertEqual(false, Mod:precondition(4, {call, Mod, up, [2]})),
    ?assertEqual(true, Mod:postcondition(4, {call, Mod, up, [2]}, ok)).

own_plain_callbacks_are_kept_test() ->
    Mod = load("-export([precondition/2]).\n"
               "initial_state() -> 0.\n"
               "up_args(_) -> [].\n"
               "up() -> ok.\n"
               "precondition(_, _) -> mine.\n", []),
    ?assertEqual(mine, Mod:precondition(0, {call, Mod, up, []})).

%%% Compiling

errors(Source) ->
    {error, Errors, []} = compile(Source, []),
    [lists:flatten(io_lib:format("~ts:~b: ~ts", [filename:basename(File), line(Location),
                                                 Module:format_error(Reason)]))
     || {File, Problems} <- Errors, {Location, Module, Reason} <- Problems].

line({Line, _Column}) -> Line;
line(Line) -> Line.

load(Source, Options) ->
    {ok, m, Binary, _} = compile(Source, Options),
    {module, m} = code:load_binary(m, "m.erl", Binary),
    m.

compile(Source, Options) ->
    Dir = filename:join([filename:dirname(code:which(faultcheck_model)), "..", "include"]),
    File = filename:join(directory(), "m.erl"),
    ok = file:write_file(File, [?HEADER, Source]),
    compile:file(File, [binary, return, {i, Dir} | Options]).

directory() ->
    {ok, Cwd} = file:get_cwd(),
    Dir = filename:join([Cwd, "_build", "test", "generated"]),
    ok = filelib:ensure_dir(filename:join(Dir, "x")),
    Dir.

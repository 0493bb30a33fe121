%% @doc Runs a sequence of commands against the system under test.
%%
%% proper_statem:run_commands/2 is not used: PropEr 1.2 asks for stack traces in a way that
%% OTP 24 no longer has, so that an exception in a command would end the whole run.
-module(faultcheck_run).

-export([commands/3, commands/4, failure/1, last/0, evaluate/2, attempt/1]).
-export([start/3, step/2, state/1]).
-export_type([history/0, result/0, run/0, exception/0, observe/0, position/0]).

-type exception() :: {exception, error | exit | throw, Reason :: term(), Stack :: list()}.
%% The state in front of each command that was run, and the command's result.
-type history() :: [{faultcheck_model:state(), term()}].
-type result() :: ok
                | {precondition, false | exception()}
                | {postcondition, term() | exception()}    % what X_post gave instead of true
                | {next_state, exception()}
                | {objective, term()}                      % what should be a finite number
                | exception().                             % raised by the command itself
%% Looks at the state behind each command that was run; anything but ok is the run's result.
-type observe() :: fun((faultcheck_model:state()) -> ok | {objective, term()}).
-type run() :: {history(), faultcheck_model:state(), result()}.

-record(run, {model :: {module(), faultcheck_model:info()},
              state :: faultcheck_model:state(),
              env :: #{term() => term()},
              history = [] :: history(),        % newest first
              tags = none :: none | [term()],   % requirement tags, when they are asked for
              observe = none :: none | observe()}).
-opaque position() :: #run{}.

%% @doc Runs a sequence up to its end or the first command that fails. An exception of a
%% command is a result like any other failure; it never escapes. Environment has values for
%% variables {var, Name} that the sequence does not set.
-spec commands(module(), [faultcheck_generator:command()], [{atom(), term()}]) -> run().
commands(Mod, Commands, Environment) ->
    commands(Mod, Commands, Environment, none).

%% @doc The same, with an observer.
-spec commands(module(), [faultcheck_generator:command()], [{atom(), term()}], none | observe()) ->
          run().
commands(Mod, Commands, Environment, Observe) ->
    Counting = faultcheck_stats:active(),
    Start = start(Mod, Environment, Observe),
    {Result, #run{state = State, history = History} = End} = run(Commands, Start),
    Run = {lists:reverse(History), State, Result},
    _ = put({?MODULE, last}, {Mod, Commands, Run}),
    _ = Counting andalso count(Commands, End),
    Run.

%% @doc The position in front of the first command.
-spec start(module(), [{atom(), term()}], none | observe()) -> position().
start(Mod, Environment, Observe) ->
    #run{model = {Mod, faultcheck_model:info(Mod)},
         state = Mod:initial_state(),
         env = maps:from_list(Environment),
         tags = case faultcheck_stats:active() of true -> []; false -> none end,
         observe = Observe}.

%% @doc The model's state at a position.
-spec state(position()) -> faultcheck_model:state().
state(#run{state = State}) ->
    State.

run([], Run) ->
    {ok, Run};
run([Command | Rest], Run) ->
    case step(Command, Run) of
        {ok, Next} -> run(Rest, Next);
        Failed -> Failed
    end.

%% @doc Runs one command.
-spec step(faultcheck_generator:command(), position()) -> {result(), position()}.
step({set, {var, N}, {call, Mod, Name, Symbolic}} = Command, #run{env = Env} = Run) ->
    case attempt(fun() -> evaluate(Symbolic, Env) end) of
        {ok, Args} ->
            check(N, {Mod, Name, Args}, Command, Run);
        Exception ->
            {Exception, result(Exception, Run)}
    end.

check(N, {_, Name, Args} = Call, Command, #run{model = Model, state = State} = Run) ->
    case attempt(fun() -> faultcheck_model:allowed(Model, State, Name, Args) end) of
        {ok, true} ->
            faultcheck_journal:command(Command),
            call(N, Call, Run);
        {ok, _} ->
            {{precondition, false}, Run};
        Exception ->
            {{precondition, Exception}, Run}
    end.

call(N, {Mod, Name, Args}, Run) ->
    case attempt(fun() -> apply(Mod, Name, Args) end) of
        {ok, Result} -> judge(N, Name, Args, Result, result(Result, Run));
        Exception -> {Exception, result(Exception, Run)}
    end.

result(Result, #run{state = State, history = History} = Run) ->
    Run#run{history = [{State, Result} | History]}.

judge(N, Name, Args, Result, #run{model = Model, state = State} = Run) ->
    case attempt(fun() -> faultcheck_model:post(Model, State, Name, Args, Result) end) of
        {ok, true} ->
            Next = attempt(fun() -> faultcheck_model:next(Model, State, Name, Args, Result) end),
            advance(N, Name, Args, Result, Next, Run);
        {ok, Other} ->
            {{postcondition, Other}, requirements(Name, Args, Result, Run)};
        Exception ->
            {{postcondition, Exception}, Run}
    end.

advance(N, Name, Args, Result, {ok, NextState}, #run{env = Env} = Run) ->
    Tagged = requirements(Name, Args, Result, Run),
    observe(Tagged#run{state = NextState, env = Env#{N => Result}});
advance(_N, _Name, _Args, _Result, Exception, Run) ->
    {{next_state, Exception}, Run}.

observe(#run{observe = none} = Run) ->
    {ok, Run};
observe(#run{observe = Observe, state = State} = Run) ->
    {Observe(State), Run}.

%% @doc What a function gives, or its exception.
-spec attempt(fun(() -> Value)) -> {ok, Value} | exception().
attempt(Fun) ->
    try
        {ok, Fun()}
    catch
        Class:Reason:Stack -> {exception, Class, Reason, Stack}
    end.

%% @doc Puts values in the place of variables. The symbolic calls that PropEr's own generators
%% make inside arguments are evaluated too.
-spec evaluate(term(), #{term() => term()}) -> term().
evaluate({var, Name} = Var, Env) ->
    case Env of
        #{Name := Value} -> Value;
        #{} -> Var
    end;
evaluate({call, Mod, Fun, Args}, Env) when is_atom(Mod), is_atom(Fun), is_list(Args) ->
    apply(Mod, Fun, evaluate(Args, Env));
evaluate([Head | Tail], Env) ->
    [evaluate(Head, Env) | evaluate(Tail, Env)];
evaluate(Tuple, Env) when is_tuple(Tuple) ->
    list_to_tuple(evaluate(tuple_to_list(Tuple), Env));
evaluate(Other, _Env) ->
    Other.

requirements(_Name, _Args, _Result, #run{tags = none} = Run) ->
    Run;
requirements(Name, Args, Result, #run{model = Model, state = State, tags = Tags} = Run) ->
    New = faultcheck_model:requirements(Model, State, Name, Args, Result),
    Run#run{tags = New ++ Tags}.

count(Commands, #run{model = {_, Info}, history = History, tags = Tags}) ->
    Length = length(History),
    Names = [Name || {set, _, {call, _, Name, _}} <- lists:sublist(Commands, Length)],
    Faults = faultcheck_model:faults(Info),
    faultcheck_stats:sequence(Names, [N || N <- Names, lists:member(N, Faults)], Length, Tags).

%% @doc The last run in this process: the model, the commands and what came of them. There is
%% none when the body of the property ran in another process (?TIMEOUT, ?TRAPEXIT).
-spec last() -> {module(), [faultcheck_generator:command()], run()} | none.
last() ->
    case get({?MODULE, last}) of
        undefined -> none;
        Last -> Last
    end.

%% @doc How the last run in this process failed, if it was of these commands.
-spec failure([faultcheck_generator:command()]) -> faultcheck_shrinker:failure().
failure(Commands) ->
    case last() of
        {_, Commands, {History, _, Result}} ->
            #{kind => kind(Result), at => at(length(History), Result)};
        _ -> #{kind => unknown, at => unknown}
    end.

%% The property itself may find fault with a run that was ok.
at(_Done, ok) -> unknown;
at(Done, {precondition, _}) -> Done + 1;
at(Done, _) -> Done.

kind(ok) -> property;
kind({exception, Class, Reason, _}) -> {Class, tag(Reason)};
kind({Where, {exception, Class, Reason, _}}) -> {Where, Class, tag(Reason)};
kind({Where, _}) -> Where.

tag({cb, Reason}) -> {cb, tag(Reason)};
tag(Reason) when is_tuple(Reason), tuple_size(Reason) > 0 -> tag(element(1, Reason));
tag(Reason) when is_atom(Reason) -> Reason;
tag(_) -> other.

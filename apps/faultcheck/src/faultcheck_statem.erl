%% @doc Command sequences of a grouped model under an ordinary PropEr property.
%%
%% ```
%% prop_safety() ->
%%     ?FORALL(Cmds, faultcheck_statem:commands(?MODULE),
%%             begin
%%                 {_, _, Result} = Run = faultcheck_statem:run_commands(?MODULE, Cmds),
%%                 ?WHENFAIL(io:put_chars(faultcheck_statem:pretty(?MODULE, Cmds, Run)),
%%                           aggregate(faultcheck_statem:command_names(Cmds), Result =:= ok))
%%             end).
%% '''
%% faultcheck_model says what a model is. A failing sequence is shrunk by
%% faultcheck_shrinker, driven by PropEr's own loop; last_shrink/0 tells how that went.
%%
%% Before it shrinks, a failure is run 10 more times. One that does not repeat each time is
%% flaky and left as it is. The ten count as steps for PropEr's option max_shrinks.
-module(faultcheck_statem).

-export([commands/1, commands/2, more_commands/2, uniform/2]).
-export([run_commands/2, run_commands/3, command_names/1, pretty/3]).
-export_type([command/0, history/0, result/0, run/0, exception/0]).

-type command() :: faultcheck_generator:command().
-type exception() :: {exception, error | exit | throw, Reason :: term(), Stack :: list()}.
%% The state in front of each command that was run, and the command's result.
-type history() :: [{faultcheck_model:state(), term()}].
-type result() :: ok
                | {precondition, false | exception()}
                | {postcondition, term() | exception()}    % what X_post gave instead of true
                | {next_state, exception()}
                | exception().                             % raised by the command itself
-type run() :: {history(), faultcheck_model:state(), result()}.

%% @doc Sequences of a model's commands, as a PropEr type.
-spec commands(module()) -> proper_types:type().
commands(Mod) ->
    commands(Mod, #{}).

-spec commands(module(), map()) -> proper_types:type().
commands(Mod, _Options) ->
    faultcheck_proper:new_type(
      fun(Size) ->
              faultcheck_stats:generated(),
              {Commands, Side} = faultcheck_generator:generate(Mod, Size),
              faultcheck_proper:with_side(Commands, Side)
      end,
      fun(Imm) -> is_list(faultcheck_proper:clean(Imm)) end,
      fun(_Imm, _Type, _State) -> {[], done} end,
      fun(Base) -> faultcheck_generator:mutate(Mod, Base) end).

%% @doc The same type with sequences N times as long.
-spec more_commands(pos_integer(), proper_types:type()) -> proper_types:type().
more_commands(N, Type) ->
    faultcheck_proper:resized(N, Type).

%% @doc Integers Lo..Hi, each equally likely whatever the size of the test: for addresses,
%% masks and times. (PropEr bounds wide ranges by the size.) Shrinks like integer(Lo, Hi).
-spec uniform(integer(), integer()) -> proper_types:type().
uniform(Lo, Hi) when is_integer(Lo), is_integer(Hi), Lo =< Hi ->
    faultcheck_proper:integer_type(Lo, Hi, fun() -> Lo + rand:uniform(Hi - Lo + 1) - 1 end).

%% @doc Module, name and arity of each command, for aggregate/2.
-spec command_names([command()]) -> [mfa()].
command_names(Commands) ->
    [{Mod, Name, length(Args)} || {set, _, {call, Mod, Name, Args}} <- Commands].

%%% Running

-record(run, {model :: {module(), faultcheck_model:info()},
              state :: faultcheck_model:state(),
              env :: #{term() => term()},
              history = [] :: history(),        % newest first
              tags = none :: none | [term()]}). % requirement tags, when they are asked for

%% @doc Runs a sequence up to its end or the first command that fails. An exception of a
%% command is a result like any other failure; it never escapes.
-spec run_commands(module(), [command()]) -> run().
run_commands(Mod, Commands) ->
    run_commands(Mod, Commands, []).

%% @doc The same, with values for variables {var, Name} that the sequence does not set.
-spec run_commands(module(), [command()], [{atom(), term()}]) -> run().
run_commands(Mod, Commands, Environment) ->
    Counting = faultcheck_stats:active(),
    Start = #run{model = {Mod, faultcheck_model:info(Mod)},
                 state = Mod:initial_state(),
                 env = maps:from_list(Environment),
                 tags = case Counting of true -> []; false -> none end},
    {Result, #run{state = State, history = History} = End} = run(Commands, Start),
    Done = length(History),
    remember(Commands, Done, Result),
    _ = Counting andalso count(Commands, End),
    {lists:reverse(History), State, Result}.

run([], Run) ->
    {ok, Run};
run([Command | Rest], Run) ->
    case step(Command, Run) of
        {ok, Next} -> run(Rest, Next);
        Failed -> Failed
    end.

step({set, {var, N}, {call, Mod, Name, SymbolicArgs}} = Command,
     #run{model = Model, state = State, env = Env, history = History} = Run) ->
    Args = evaluate(SymbolicArgs, Env),
    case attempt(fun() -> faultcheck_model:allowed(Model, State, Name, Args) end) of
        {ok, true} ->
            faultcheck_journal:command(Command),
            case attempt(fun() -> apply(Mod, Name, Args) end) of
                {ok, Result} ->
                    Ran = Run#run{history = [{State, Result} | History]},
                    judge(N, Name, Args, Result, Ran);
                Exception ->
                    {Exception, Run#run{history = [{State, Exception} | History]}}
            end;
        {ok, _} ->
            {{precondition, false}, Run};
        Exception ->
            {{precondition, Exception}, Run}
    end.

judge(N, Name, Args, Result, #run{model = Model, state = State} = Run) ->
    case attempt(fun() -> faultcheck_model:post(Model, State, Name, Args, Result) end) of
        {ok, true} ->
            Next = attempt(fun() -> faultcheck_model:next(Model, State, Name, Args, Result) end),
            advance(N, Name, Args, Result, Next, Run);
        {ok, Other} ->
            {{postcondition, Other}, tag(Name, Args, Result, Run)};
        Exception ->
            {{postcondition, Exception}, Run}
    end.

advance(N, Name, Args, Result, {ok, NextState}, #run{env = Env} = Run) ->
    Tagged = tag(Name, Args, Result, Run),
    {ok, Tagged#run{state = NextState, env = Env#{N => Result}}};
advance(_N, _Name, _Args, _Result, Exception, Run) ->
    {{next_state, Exception}, Run}.

attempt(Fun) ->
    try
        {ok, Fun()}
    catch
        Class:Reason:Stack -> {exception, Class, Reason, Stack}
    end.

%% Puts values in the place of variables. The symbolic calls that PropEr's own generators
%% make inside arguments are evaluated too.
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

%% The shrinker asks how a run failed. It finds nothing when the body of the property ran in
%% another process (?TIMEOUT, ?TRAPEXIT), or ran other commands than were generated.
remember(Commands, Done, Result) ->
    _ = put({?MODULE, last_run}, {Commands, Done, Result}),
    ok.

tag(_Name, _Args, _Result, #run{tags = none} = Run) ->
    Run;
tag(Name, Args, Result, #run{model = Model, state = State, tags = Tags} = Run) ->
    New = faultcheck_model:requirements(Model, State, Name, Args, Result),
    Run#run{tags = New ++ Tags}.

count(Commands, #run{model = {_, Info}, history = History, tags = Tags}) ->
    Length = length(History),
    Names = [Name || {set, _, {call, _, Name, _}} <- lists:sublist(Commands, Length)],
    Faults = faultcheck_model:faults(Info),
    faultcheck_stats:sequence(Names, [N || N <- Names, lists:member(N, Faults)], Length, Tags).

%%% Printing

%% @doc A run in words: a line for each command, `mod:command(args) -> result', the one that
%% failed marked with the reason.
-spec pretty(module(), [command()], run()) -> iolist().
pretty(_Mod, Commands, {History, _State, Result}) ->
    Used = used_variables(Commands),
    Failed = failed_at(length(History), Result),
    Values = [{value, Value} || {_, Value} <- History],
    Numbered = lists:zip3(lists:seq(1, length(Commands)), Commands,
                          Values ++ lists:duplicate(length(Commands) - length(Values), none)),
    [line(N, Failed, Command, Value, Result, Used) || {N, Command, Value} <- Numbered].

%% The number of the command that failed; a precondition stops a run before its command.
failed_at(_Done, ok) -> none;
failed_at(Done, {precondition, _}) -> Done + 1;
failed_at(Done, _) -> Done.

line(N, Failed, Command, _Value, _Result, Used) when N > Failed ->
    ["  ", call(Command, Used), "   (not run)\n"];
line(N, N, Command, {value, {exception, _, _, _}}, Result, Used) ->
    ["! ", call(Command, Used), $\n, why(Result)];
line(N, N, Command, {value, Value}, Result, Used) ->
    ["! ", call(Command, Used), " -> ", term(Value), $\n, why(Result)];
line(N, N, Command, none, Result, Used) ->
    ["! ", call(Command, Used), $\n, why(Result)];
line(_N, _Failed, Command, {value, Value}, _Result, Used) ->
    ["  ", call(Command, Used), " -> ", term(Value), $\n].

call({set, {var, N}, {call, Mod, Name, Args}}, Used) ->
    [case lists:member(N, Used) of
         true -> io_lib:format("V~b = ", [N]);
         false -> []
     end,
     io_lib:format("~tw:~tw(", [Mod, Name]), lists:join(", ", [term(A) || A <- Args]), ")"].

why({precondition, false}) -> "    precondition false\n";
why({precondition, Exception}) -> ["    in the precondition: " | cause(Exception)];
why({postcondition, {exception, _, _, _} = Exception}) ->
    ["    in the postcondition: " | cause(Exception)];
why({postcondition, false}) -> "    postcondition false\n";
why({postcondition, Other}) -> ["    postcondition: ", term(Other), $\n];
why({next_state, Exception}) -> ["    in the next state: " | cause(Exception)];
why(Exception) -> ["    ", cause(Exception)].

cause({exception, error, {cb, Reason}, _Stack}) ->
    [cb_error:format(Reason), $\n];
cause({exception, Class, Reason, Stack}) ->
    [atom_to_list(Class), ": ", term(Reason), place(Stack), $\n].

place([{Mod, Fun, ArityOrArgs, _} | _]) ->
    Arity = if is_list(ArityOrArgs) -> length(ArityOrArgs); true -> ArityOrArgs end,
    io_lib:format(" in ~tw:~tw/~b", [Mod, Fun, Arity]);
place(_) ->
    [].

used_variables(Commands) ->
    lists:usort(variables([Args || {set, _, {call, _, _, Args}} <- Commands])).

variables({var, N}) -> [N];
variables([Head | Tail]) -> variables(Head) ++ variables(Tail);
variables(Tuple) when is_tuple(Tuple) -> variables(tuple_to_list(Tuple));
variables(_) -> [].

%% Lists of bytes are data here, not text: l leaves them as numbers.
term({var, N}) when is_integer(N) -> io_lib:format("V~b", [N]);
term(Term) -> io_lib:format("~0ltp", [Term]).

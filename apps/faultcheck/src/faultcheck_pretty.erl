%% @doc A run of commands as a person reads it.
-module(faultcheck_pretty).

-export([format/2, commands/1, why/1]).

%% @doc A run in words: a line for each command, `mod:command(args) -> result', the one that
%% failed marked with the reason.
-spec format([faultcheck_generator:command()], faultcheck_run:run()) -> iolist().
format(Commands, {History, _State, Result}) ->
    Used = used_variables(Commands),
    Failed = failed_at(length(History), Result),
    Values = [{value, Value} || {_, Value} <- History],
    Numbered = lists:zip3(lists:seq(1, length(Commands)), Commands,
                          Values ++ lists:duplicate(length(Commands) - length(Values), none)),
    [line(N, Failed, Command, Value, Result, Used) || {N, Command, Value} <- Numbered].

%% @doc The commands alone, a line each.
-spec commands([faultcheck_generator:command()]) -> [iolist()].
commands(Commands) ->
    Used = used_variables(Commands),
    [call(Command, Used) || Command <- Commands].

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

%% @doc Why a run that is not ok ended, in one line or more.
-spec why(faultcheck_run:result()) -> iolist().
why({precondition, false}) -> "    precondition false\n";
why({precondition, Exception}) -> ["    in the precondition: " | cause(Exception)];
why({postcondition, {exception, _, _, _} = Exception}) ->
    ["    in the postcondition: " | cause(Exception)];
why({postcondition, false}) -> "    postcondition false\n";
why({postcondition, Other}) -> ["    postcondition: ", term(Other), $\n];
why({objective, Other}) -> ["    the objective is not a finite number: ", term(Other), $\n];
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
term(Term) -> io_lib:format("~0lp", [Term]).

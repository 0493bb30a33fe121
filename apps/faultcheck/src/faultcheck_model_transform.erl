%% @doc Parse transform of faultcheck.hrl: checks and completes a grouped model.
%%
%% - names and arities that cannot be right are compile errors (check/1),
%% - the callbacks and commands are exported, with a plain -spec where there is none,
%% - command/1, precondition/2, next_state/3 and postcondition/3 are added, so that
%%   proper_statem's own tools (parallel_commands, state_after) accept the model too,
%% - imports from PropEr that the module itself defines are dropped, and those of
%%   proper_statem that faultcheck_statem replaces are redirected.
-module(faultcheck_model_transform).

-export([parse_transform/2, format_error/1]).

-type form() :: erl_parse:abstract_form() | erl_parse:form_info().

-define(SUFFIXES, ["_args", "_pre", "_next", "_post", "_req", "_mutate", "_duration"]).
-define(REPLACED, [{commands, 1}, {commands, 2}, {more_commands, 2}, {run_commands, 2},
                   {run_commands, 3}, {command_names, 1}]).

-record(fn, {name, arity, anno, file, clauses}).

-spec parse_transform([form()], [compile:option()]) ->
          [form()] | {error, [{file:filename(), [{erl_anno:location(), module(), term()}]}], []}.
parse_transform(Forms, Options) ->
    Fns = functions(Forms),
    case check(Fns) of
        [] ->
            Exports = exports(Forms, Options),
            add(Forms, Fns, Exports);
        Errors ->
            {error, [{File, [{Location, ?MODULE, Reason}]} || {File, Location, Reason} <- Errors],
             []}
    end.

-spec format_error(term()) -> iolist().
format_error({no_function, X}) ->
    io_lib:format("~ts_args/1 describes a command, but there is no function ~ts: write "
                  "~ts(Arg1, ...) with a parameter for each argument", [X, X, X]);
format_error({no_args, F, A, X}) ->
    io_lib:format("~ts/~b belongs to a command ~ts, but ~ts_args/1 is missing: write "
                  "~ts_args(State) -> [Type, ...]", [F, A, X, X, X]);
format_error({arity, F, A, Right}) ->
    io_lib:format("~ts/~b has the wrong number of parameters: write ~ts", [F, A, Right]);
format_error({arguments, X, Given, Arities}) ->
    io_lib:format("~ts_args/1 gives ~b argument~ts, but ~ts: make both agree",
                  [X, Given, plural(Given), takes(X, Arities)]);
format_error({pattern, F, A, Given, X, Takes}) ->
    io_lib:format("~ts/~b matches a list of ~b argument~ts, but ~ts/~b takes ~b",
                  [F, A, Given, plural(Given), X, Takes, Takes]);
format_error(no_initial_state) ->
    "a model needs initial_state/0: write initial_state() -> State".

plural(1) -> "";
plural(_) -> "s".

takes(X, [Arity]) ->
    io_lib:format("~ts/~b takes ~b", [X, Arity, Arity]);
takes(X, Arities) ->
    lists:join(" and ", [io_lib:format("~ts/~b", [X, Arity]) || Arity <- Arities]) ++ " are there".

%%% Reading the module

functions(Forms) ->
    {_, Fns} = lists:foldl(fun function/2, {"", []}, Forms),
    lists:reverse(Fns).

function({attribute, _, file, {File, _}}, {_, Fns}) ->
    {File, Fns};
function({function, Anno, Name, Arity, Clauses}, {File, Fns}) ->
    {File, [#fn{name = Name, arity = Arity, anno = Anno, file = File, clauses = Clauses} | Fns]};
function(_, Acc) ->
    Acc.

%% The names already exported, or all.
exports(Forms, Options) ->
    Compile = lists:append([case O of L when is_list(L) -> L; _ -> [O] end
                            || {attribute, _, compile, O} <- Forms]),
    case lists:member(export_all, Options ++ Compile) of
        true -> all;
        false -> lists:append([Fs || {attribute, _, export, Fs} <- Forms])
    end.

%% X and suffix of a callback's name; none for other functions.
split(Name) ->
    Text = atom_to_list(Name),
    Found = [{lists:sublist(Text, length(Text) - length(S)), S}
             || S <- ?SUFFIXES, lists:suffix(S, Text), length(Text) > length(S)],
    case Found of
        [{X, Suffix}] -> {list_to_atom(X), Suffix};
        [] -> none
    end.

arities(Name, Fns) ->
    [A || #fn{name = N, arity = A} <- Fns, N =:= Name].

has(Name, Arity, Fns) ->
    lists:member(Arity, arities(Name, Fns)).

sister(X, Suffix) ->
    list_to_atom(atom_to_list(X) ++ Suffix).

%% Commands are the X with X_args/1. A module without any may still use the header,
%% for properties only.
commands(Fns) ->
    [X || #fn{name = F, arity = 1} <- Fns, {X, "_args"} <- [split(F)],
          is_command(X, Fns)].

%% A helper such as default_args/1 is none: no function default, no sisters.
is_command(X, Fns) ->
    arities(X, Fns) =/= []
        orelse lists:any(fun(S) -> arities(sister(X, S), Fns) =/= [] end, ?SUFFIXES -- ["_args"])
        orelse has(initial_state, 0, Fns).

%%% Checking

check(Fns) ->
    Commands = commands(Fns),
    Problems = lists:append([check_function(Fn, Commands, Fns) || Fn <- Fns]),
    Problems ++ check_initial_state(Commands, Fns).

check_initial_state([], _Fns) ->
    [];
check_initial_state([X | _], Fns) ->
    case has(initial_state, 0, Fns) of
        true -> [];
        false -> [problem(find(sister(X, "_args"), 1, Fns), no_initial_state)]
    end.

check_function(#fn{name = weight, arity = A} = Fn, [_ | _], _Fns) when A =/= 2 ->
    [problem(Fn, {arity, weight, A, "weight(State, Command)"})];
check_function(#fn{name = faults, arity = A} = Fn, [_ | _], _Fns) when A =/= 0 ->
    [problem(Fn, {arity, faults, A, "faults() -> [Command]"})];
check_function(#fn{name = F} = Fn, Commands, Fns) ->
    case split(F) of
        none ->
            [];
        {X, Suffix} ->
            case lists:member(X, Commands) of
                true -> check_callback(Fn, X, Suffix, Fns);
                false -> check_stray(Fn, X, Suffix, Commands, Fns)
            end
    end.

%% X is a command.
check_callback(#fn{name = F, arity = A} = Fn, X, Suffix, Fns) ->
    case {lists:member(A, allowed(Suffix)), Suffix} of
        {false, _} -> [problem(Fn, {arity, F, A, right(X, Suffix)})];
        {true, "_args"} -> check_arguments(Fn, X, Fns);
        {true, _} -> check_patterns(Fn, X, Fns)
    end.

%% X_args/1 is missing. It is an error if X is a function of this module, or if the
%% name and arity are too special for a helper.
check_stray(#fn{name = F, arity = A} = Fn, X, Suffix, Commands, Fns) ->
    Wrong = not lists:member(A, allowed(Suffix)),
    ArgsThere = arities(sister(X, "_args"), Fns) =/= [],
    XThere = arities(X, Fns) =/= [],
    Special = Commands =/= [] andalso A =:= 3 andalso not Wrong,
    if
        Suffix =:= "_args", XThere -> [problem(Fn, {arity, F, A, right(X, Suffix)})];
        Suffix =:= "_args"; Wrong; ArgsThere -> [];
        XThere; Special -> [problem(Fn, {no_args, F, A, X})];
        true -> []
    end.

check_arguments(#fn{clauses = Clauses} = Fn, X, Fns) ->
    case arities(X, Fns) of
        [] ->
            [problem(Fn, {no_function, X})];
        Arities ->
            [problem(Fn, clause_anno(C), {arguments, X, N, Arities})
             || C <- Clauses, N <- list_length(last_expression(C)), not lists:member(N, Arities)]
    end.

%% The list of arguments in the head of X_pre/2, X_next/3, X_post/3, X_req/3.
check_patterns(#fn{name = F, arity = A, clauses = Clauses} = Fn, X, Fns) ->
    Takes = lists:usort(lists:append([list_length(last_expression(C))
                                      || #fn{name = N, arity = 1, clauses = Cs} <- Fns,
                                         N =:= sister(X, "_args"), C <- Cs])),
    case Takes of
        [Takes1] ->
            [problem(Fn, clause_anno(C), {pattern, F, A, N, X, Takes1})
             || {clause, _, Head, _, _} = C <- Clauses, {ok, Pattern} <- [args_pattern(F, Head)],
                N <- list_length(Pattern), N =/= Takes1];
        _ ->
            []
    end.

args_pattern(F, Head) ->
    case {split(F), Head} of
        {{_, "_pre"}, [_, Args]} -> {ok, Args};
        {{_, "_mutate"}, [Args, _, _]} -> {ok, Args};
        {{_, "_duration"}, [Args]} -> {ok, Args};
        {{_, "_next"}, [_, _, Args]} -> {ok, Args};
        {{_, "_post"}, [_, Args, _]} -> {ok, Args};
        {{_, "_req"}, [_, Args, _]} -> {ok, Args};
        _ -> none
    end.

last_expression({clause, _, _, _, Body}) -> lists:last(Body).

clause_anno({clause, Anno, _, _, _}) -> Anno.

%% [Length] of a list that is written out, [] when it cannot be told.
list_length({match, _, _, Expression}) -> list_length(Expression);
list_length({nil, _}) -> [0];
list_length({cons, _, _, Tail}) -> [N + 1 || N <- list_length(Tail)];
list_length(_) -> [].

allowed("_args") -> [1];
allowed("_pre") -> [1, 2];
allowed("_duration") -> [1];
allowed(_) -> [3].

right(X, "_args") -> io_lib:format("~ts_args(State)", [X]);
right(X, "_pre") -> io_lib:format("~ts_pre(State) or ~ts_pre(State, Args)", [X, X]);
right(X, "_next") -> io_lib:format("~ts_next(State, Result, Args)", [X]);
right(X, "_mutate") -> io_lib:format("~ts_mutate(Args, Scale, State)", [X]);
right(X, "_duration") -> io_lib:format("~ts_duration(Args)", [X]);
right(X, Suffix) -> io_lib:format("~ts~ts(State, Args, Result)", [X, Suffix]).

find(Name, Arity, Fns) ->
    [Fn | _] = [Fn || #fn{name = N, arity = A} = Fn <- Fns, N =:= Name, A =:= Arity],
    Fn.

problem(#fn{anno = Anno} = Fn, Reason) ->
    problem(Fn, Anno, Reason).

problem(#fn{file = File}, Anno, Reason) ->
    {File, erl_anno:location(Anno), Reason}.

%%% Completing the module

add(Forms, Fns, Exports) ->
    Anno = erl_anno:set_generated(true, erl_anno:new(1)),
    Commands = commands(Fns),
    Delegates = case Commands of
                    [] -> [];
                    _ -> [D || {Name, Arity} = D <- delegates(), not has(Name, Arity, Fns)]
                end,
    Public = public(Commands, Fns),
    Export = case Exports of
                 all -> [];
                 _ -> (Public ++ Delegates) -- Exports
             end,
    Specified = [FA || {attribute, _, spec, {FA, _}} <- Forms],
    Properties = [{N, 0} || #fn{name = N, arity = 0} <- Fns,
                            lists:prefix("prop_", atom_to_list(N))],
    Specs = [spec(FA, Anno)
             || FA <- lists:usort(Public ++ Delegates ++ Properties),
                not lists:member(FA, Specified)],
    {Head, [Module | Tail]} = lists:splitwith(fun(F) -> not is_module(F) end, Forms),
    {attribute, _, module, Mod} = Module,
    Body = [imports(F, Fns) || F <- Tail, not is_eof(F)],
    Head ++ [Module, {attribute, Anno, export, Export},
             {attribute, Anno, import, {faultcheck_statem, wanted_imports(Body, Fns)}}]
        ++ Body ++ Specs ++ [delegate(Name, Arity, Mod, Anno) || {Name, Arity} <- Delegates]
        ++ [F || F <- Tail, is_eof(F)].

is_module({attribute, _, module, _}) -> true;
is_module(_) -> false.

is_eof({eof, _}) -> true;
is_eof(_) -> false.

%% What the runner calls: callbacks, the commands themselves, and the model's own functions.
public(Commands, Fns) ->
    Callbacks = [{F, A} || X <- Commands, #fn{name = F, arity = A} <- Fns,
                           F =:= X orelse is_callback_of(X, F, A)],
    Model = [{initial_state, 0} | faultcheck_model:optional()],
    Callbacks ++ [FA || Commands =/= [], {F, A} = FA <- Model, has(F, A, Fns)].

is_callback_of(X, F, A) ->
    case split(F) of
        {X, Suffix} -> lists:member(A, allowed(Suffix));
        _ -> false
    end.

imports({attribute, Anno, import, {From, Functions}}, Fns) ->
    Kept = [FA || {Name, Arity} = FA <- Functions, not has(Name, Arity, Fns),
                  not (From =:= proper_statem andalso lists:member(FA, ?REPLACED))],
    {attribute, Anno, import, {From, Kept}};
imports(Form, _Fns) ->
    Form.

wanted_imports(Body, Fns) ->
    Imported = lists:append([Fs || {attribute, _, import, {_, Fs}} <- Body]),
    [FA || {Name, Arity} = FA <- ?REPLACED ++ [{uniform, 2}],
           not has(Name, Arity, Fns), not lists:member(FA, Imported)].

%% -spec Name(term(), ...) -> term().
spec({Name, Arity}, Anno) ->
    Term = {type, Anno, term, []},
    Args = {type, Anno, product, lists:duplicate(Arity, Term)},
    {attribute, Anno, spec, {{Name, Arity}, [{type, Anno, 'fun', [Args, Term]}]}}.

delegates() ->
    [{command, 1}, {precondition, 2}, {next_state, 3}, {postcondition, 3}].

%% Name(V1, ...) -> faultcheck_model:Name(Mod, V1, ...).
delegate(Name, Arity, Mod, Anno) ->
    Vars = [{var, Anno, list_to_atom("V" ++ integer_to_list(I))} || I <- lists:seq(1, Arity)],
    Remote = {remote, Anno, {atom, Anno, faultcheck_model}, {atom, Anno, Name}},
    Call = {call, Anno, Remote, [{atom, Anno, Mod} | Vars]},
    {function, Anno, Name, Arity, [{clause, Anno, Vars, [], [Call]}]}.

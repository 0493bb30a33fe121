%% @doc A parallel test case: commands that run first, branches that run at once, and commands that
%% run after them. Pure.
%%
%% A case is legal when every order that keeps the order inside its parts is: whatever the threads
%% do, each command's preconditions hold in front of it. A branch uses results of its own commands
%% and of those that run first; what runs last may use all.
%%
%% The shrinker works on one list of commands, the flat form. There the place of the module's name
%% tells which part a command belongs to.
-module(faultcheck_parallel_case).

-export([generate/3, legal/2, flatten/1, unflatten/2, candidates/1, commands/1]).
-export_type([test_case/0, limits/0, flat/0]).

-type command() :: faultcheck_generator:command().
-type test_case() ::
    {parallel, First :: [command()], Branches :: [[command()]], Last :: [command()]}.
-type limits() :: #{branches := pos_integer(), length := pos_integer()}.
%% Commands with a lane() in the place of the module.
-type flat() :: [command()].

-define(BRANCHES, [branch_1, branch_2, branch_3, branch_4, branch_5, branch_6, branch_7, branch_8]).

-type model() :: {module(), faultcheck_model:info()}.
%% What may be the model's states once these commands are left of each branch.
-type frontier() :: #{[[command()]] => [faultcheck_model:state()]}.

%% @doc A random case and the side data of its commands. The sequence it is made from has a length
%% of at most Size.
-spec generate(module(), Size :: non_neg_integer(), limits()) ->
    {test_case(), faultcheck_generator:side()}.
generate(Mod, Size, #{branches := N, length := Longest}) ->
    {Commands, Side} = faultcheck_generator:generate(Mod, Size),
    Behind = rand:uniform(3) - 1,
    Most = N * Longest + Behind,
    {First, Rest} = lists:split(max(0, length(Commands) - Most), Commands),
    {Meant, Last} = lists:split(max(0, length(Rest) - Behind), Rest),
    Case = distribute(Mod, First, Meant, lists:duplicate(N, []), Longest),
    Whole = append_last(Mod, Last, Case),
    Vars = [V || {set, {var, V}, _} <- commands(Whole)],
    {Whole, maps:with(Vars, Side)}.

%% Each command to a random branch in which the case stays legal; without one it is left out.
distribute(_Mod, First, [], Branches, _Longest) ->
    {parallel, First, Branches, []};
distribute(Mod, First, [Command | Commands], Branches, Longest) ->
    Open = [I || {I, B} <- number(Branches), length(B) < Longest],
    Places = [I || {_, I} <- lists:sort([{rand:uniform(), I} || I <- Open])],
    distribute(Mod, First, Commands, place(Mod, First, Command, Branches, Places), Longest).

place(_Mod, _First, _Command, Branches, []) ->
    Branches;
place(Mod, First, Command, Branches, [Place | Places]) ->
    Longer = [
        case I of
            Place -> Branch ++ [Command];
            _ -> Branch
        end
     || {I, Branch} <- number(Branches)
    ],
    case legal(Mod, {parallel, First, Longer, []}) of
        true -> Longer;
        false -> place(Mod, First, Command, Branches, Places)
    end.

append_last(Mod, Commands, Case) ->
    lists:foldl(
        fun(Command, {parallel, First, Branches, Last} = Shorter) ->
            Longer = {parallel, First, Branches, Last ++ [Command]},
            case legal(Mod, Longer) of
                true -> Longer;
                false -> Shorter
            end
        end,
        Case,
        Commands
    ).

number(List) -> lists:zip(lists:seq(1, length(List)), List).

%% @doc All commands of a case, as one sequence.
-spec commands(test_case()) -> [command()].
commands({parallel, First, Branches, Last}) ->
    First ++ lists:append(Branches) ++ Last.

%% @doc Whether every order of the commands is legal.
-spec legal(module(), test_case()) -> boolean().
legal(Mod, {parallel, First, Branches, Last} = Case) ->
    Model = {Mod, faultcheck_model:info(Mod)},
    %% A model may have no clause for a state that generation never reaches: not legal either.
    try
        uses_what_is_set(Case) andalso
            in_order(Model, Last, in_all_orders(Model, Branches,
                in_order(Model, First, [Mod:initial_state()]))) =/= illegal
    catch
        error:_ -> false
    end.

uses_what_is_set({parallel, First, Branches, Last}) ->
    After = used(First, []),
    Behind = [used(Branch, After) || Branch <- Branches],
    not lists:member(illegal, [After | Behind]) andalso
        used(Last, lists:append([After | Behind])) =/= illegal.

%% The variables that are set behind a sequence, if it uses no others.
used(Commands, Set) ->
    lists:foldl(
        fun(_, illegal) -> illegal;
           ({set, {var, N}, {call, _, _, Args}}, Known) ->
                case faultcheck_repair:variables(Args) -- Known of
                    [] -> [N | Known];
                    _ -> illegal
                end
        end,
        Set,
        Commands
    ).

in_order(_Model, _Commands, illegal) ->
    illegal;
in_order(Model, Commands, States) ->
    lists:foldl(
        fun(_, illegal) -> illegal;
           (Command, Before) -> after_command(Model, Command, Before)
        end,
        States,
        Commands
    ).

%% The states behind a command, or illegal when it is not allowed in one of those before it.
after_command({_, _} = Model, {set, Var, {call, _, Name, Args}}, States) ->
    case lists:all(fun(S) -> faultcheck_model:allowed(Model, S, Name, Args) end, States) of
        true -> lists:usort([faultcheck_model:next(Model, S, Name, Args, Var) || S <- States]);
        false -> illegal
    end.

%% Branch by branch would be every order one by one; this keeps the states that orders have in
%% common together.
in_all_orders(_Model, _Branches, illegal) ->
    illegal;
in_all_orders(Model, Branches, States) ->
    advance(Model, lists:sum([length(B) || B <- Branches]), #{Branches => States}).

-spec advance(model(), non_neg_integer(), frontier()) -> [faultcheck_model:state()] | illegal.
advance(_Model, 0, Frontier) ->
    lists:usort(lists:append(maps:values(Frontier)));
advance(Model, Left, Frontier) ->
    Steps = [
        {Rests, after_command(Model, Command, States)}
     || {Branches, States} <- maps:to_list(Frontier), {Command, Rests} <- heads(Branches)
    ],
    case lists:keymember(illegal, 2, Steps) of
        true -> illegal;
        false -> advance(Model, Left - 1, lists:foldl(fun join/2, #{}, Steps))
    end.

join({Rests, States}, Frontier) ->
    Frontier#{Rests => lists:umerge(States, maps:get(Rests, Frontier, []))}.

%% Each branch's next command, with the branches as they are behind it.
heads(Branches) ->
    [
        {Command, lists:sublist(Branches, I - 1) ++ [Rest] ++ lists:nthtail(I, Branches)}
     || {I, [Command | Rest]} <- number(Branches)
    ].

%% @doc The case as one list.
-spec flatten(test_case()) -> flat().
flatten({parallel, First, Branches, Last}) ->
    Lanes = lists:zip(lists:sublist(?BRANCHES, length(Branches)), Branches),
    lists:append([in_lane(L, Cs) || {L, Cs} <- [{first, First}] ++ Lanes ++ [{last, Last}]]).

in_lane(Lane, Commands) ->
    [{set, Var, {call, Lane, Name, Args}} || {set, Var, {call, _, Name, Args}} <- Commands].

%% @doc The case of a list. Branches that are empty are left out.
-spec unflatten(module(), flat()) -> test_case().
unflatten(Mod, Flat) ->
    Lane = fun(Wanted) ->
        in_lane(Mod, [C || {set, _, {call, L, _, _}} = C <- Flat, L =:= Wanted])
    end,
    {parallel, Lane(first), [B || L <- ?BRANCHES, B <- [Lane(L)], B =/= []], Lane(last)}.

%% @doc Cases with less in the branches: the first command of a branch runs before them instead, or
%% the last one behind them.
-spec candidates(test_case()) -> [test_case()].
candidates({parallel, First, Branches, Last}) ->
    Earlier = [
        {parallel, First ++ [Command], without_empty(Rests), Last}
     || {Command, Rests} <- heads(Branches)
    ],
    Backwards = [lists:reverse(B) || B <- Branches],
    Later = [
        {parallel, First, without_empty([lists:reverse(R) || R <- Rests]), [Command | Last]}
     || {Command, Rests} <- heads(Backwards)
    ],
    Earlier ++ Later.

without_empty(Branches) -> [B || B <- Branches, B =/= []].

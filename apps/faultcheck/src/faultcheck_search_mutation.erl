%% @doc A neighbour of a command sequence, for the guided search.
%%
%% One edit, a second with probability 1/2, a further one with 1/4. The kinds and their shares are
%% a table below. An edit is placed where the run came nearest to failing: with probability
%% `follow' at that time less an exponentially distributed one (mean `lookback'), else anywhere;
%% new commands address those involved (the objective's Key) with probability `address'. Commands
%% that set the scene (setting/0 of the model) stay in front and are only moved. After each edit
%% the sequence is made legal; at the end it is cut, or filled at random, to the simulated time of
%% a sequence.
-module(faultcheck_search_mutation).

-export([child/3, fresh/2]).
-export_type([parent/0]).

-type sequence() :: {[faultcheck_generator:command()], faultcheck_generator:side()}.
-type parent() :: #{
    commands := [faultcheck_generator:command()],
    side := faultcheck_generator:side(),
    %% when it came nearest to failing, and who
    time := number(),
    key := term(),
    atom() => term()
}.

-define(SHARES, [
    {15, insert},
    {12, delete},
    {15, replace},
    {38, perturb},
    {10, shift},
    {5, redraw},
    {5, setting}
]).
-define(FAULT_SHARE, 0.3).
-define(ATTEMPTS, 10).
-define(FARTHEST_SHIFT, 5).
-define(MOST_DELETED, 3).
-define(MOST_INSERTED, 3).

-record(edit, {
    model :: {module(), faultcheck_model:info()},
    options :: faultcheck_search_options:options(),
    parent :: parent(),
    setting :: [faultcheck_generator:command()],
    body :: [faultcheck_generator:command()],
    side :: faultcheck_generator:side()
}).

%% @doc A random sequence of the length that the options ask for.
-spec fresh(module(), faultcheck_search_options:options()) -> sequence().
fresh(Mod, #{time := Time, max_commands := Most}) ->
    faultcheck_generator:fill(Mod, [], #{}, Time, Most).

%% @doc A neighbour.
-spec child(module(), parent(), faultcheck_search_options:options()) -> sequence().
child(Mod, Parent, Options) ->
    Model = {Mod, faultcheck_model:info(Mod)},
    Edit = #edit{
        model = Model, options = Options, parent = Parent, setting = [], body = [], side = #{}
    },
    other(?ATTEMPTS, Edit).

%% A run of the parent once more would tell nothing.
other(Left, #edit{parent = #{commands := Commands, side := Side}} = Edit) ->
    case edited([1, 0.5, 0.25], Commands, Side, Edit) of
        {Commands, _} when Left > 1 -> other(Left - 1, Edit);
        Child -> Child
    end.

edited([Chance | Chances], Commands, Side, #edit{model = {Mod, _}} = Edit) ->
    case chance(Chance) of
        true ->
            Changed = change(split(Commands, Edit#edit{side = Side})),
            {Legal, LegalSide} = legal(Mod, Changed),
            edited(Chances, Legal, LegalSide, Edit);
        false ->
            finish(Commands, Side, Edit)
    end;
edited([], Commands, Side, Edit) ->
    finish(Commands, Side, Edit).

legal(Mod, {Commands, Side}) ->
    faultcheck_repair:repair(Mod, Commands, Side, faultcheck_repair:names(Commands)).

finish(Commands, Side, #edit{model = {Mod, _} = Model, options = Options}) ->
    #{time := Time, max_commands := Most} = Options,
    Cut = lists:sublist(within(Commands, Time, Model), Most),
    {Full, FullSide} = faultcheck_generator:fill(Mod, Cut, Side, Time, Most),
    Kept = maps:with([N || {set, {var, N}, _} <- Full], FullSide),
    faultcheck_repair:renumber(Full, Kept).

%% Commands that begin before the time is up.
within([Command | Rest], Left, Model) when Left > 0 ->
    [Command | within(Rest, Left - duration(Command, Model), Model)];
within(_, _Left, _Model) ->
    [].

duration({set, _, {call, _, Name, Args}}, Model) -> faultcheck_model:duration(Model, Name, Args).

split(Commands, #edit{model = {_, Info}} = Edit) ->
    Setting = faultcheck_model:setting(Info),
    {Front, Body} = lists:splitwith(fun(C) -> lists:member(name(C), Setting) end, Commands),
    Edit#edit{setting = Front, body = Body}.

name({set, _, {call, _, Name, _}}) -> Name.

all(#edit{setting = Setting, body = Body, side = Side}) -> {Setting ++ Body, Side}.

%% ---- the edits ----------------------------------------------------------------------------

change(#edit{body = []} = Edit) -> all(Edit);
change(Edit) -> change(pick(?SHARES, rand:uniform(100)), Edit).

pick([{Share, Kind} | _], Dice) when Dice =< Share -> Kind;
pick([{Share, _} | Rest], Dice) -> pick(Rest, Dice - Share).

change(insert, #edit{model = {Mod, _}, setting = Setting, body = Body, side = Side} = Edit) ->
    {Before, Behind} = lists:split(place(Edit) - 1, Body),
    Focus = focus(Edit),
    faultcheck_generator:insert(
        Mod, {Setting ++ Before, Behind, Side}, what(Setting ++ Before, Edit), Focus
    );
change(delete, #edit{body = Body} = Edit) ->
    {Before, Behind} = lists:split(place(Edit) - 1, Body),
    Gone = min(length(Behind), rand:uniform(?MOST_DELETED)),
    all(Edit#edit{body = Before ++ lists:nthtail(Gone, Behind)});
change(replace, #edit{body = Body} = Edit) ->
    again(lists:nth(place(Edit), Body), Edit);
change(perturb, #edit{body = Body} = Edit) ->
    moved(lists:nth(place(Edit), Body), Edit);
change(setting, #edit{setting = []} = Edit) ->
    change(perturb, Edit);
change(setting, #edit{setting = Setting} = Edit) ->
    moved(one_of(Setting), Edit);
change(shift, #edit{body = Body} = Edit) ->
    From = shifted(Edit),
    {Before, [Command | Behind]} = lists:split(From - 1, Body),
    Without = Before ++ Behind,
    Offset = rand:uniform(?FARTHEST_SHIFT) * one_of([-1, 1]),
    To = max(0, min(length(Without), From - 1 + Offset)),
    {NewBefore, NewBehind} = lists:split(To, Without),
    all(Edit#edit{body = NewBefore ++ [Command | NewBehind]});
change(redraw, #edit{body = Body} = Edit) ->
    all(Edit#edit{body = lists:sublist(Body, place(Edit) - 1)}).

%% What to insert: a fault in some cases, else what the model wishes, else what comes.
what(Before, #edit{model = {_, Info} = Model, parent = #{key := Key}, options = Options}) ->
    Faults = faultcheck_model:faults(Info),
    case Faults =/= [] andalso chance(?FAULT_SHARE) of
        true ->
            {any, Faults, 1};
        false ->
            About =
                case chance(maps:get(address, Options)) of
                    true -> Key;
                    false -> any
                end,
            case faultcheck_model:insertion(Model, state_behind(Before, Model), About) of
                none -> {any, faultcheck_model:commands(Info) -- Faults, ?MOST_INSERTED};
                Wished -> Wished
            end
    end.

state_behind(Commands, {Mod, _} = Model) ->
    lists:foldl(
        fun({set, Var, {call, _, Name, Args}}, State) ->
            faultcheck_model:next(Model, State, Name, Args, Var)
        end,
        Mod:initial_state(),
        Commands
    ).

focus(#edit{model = Model, parent = #{key := Key}, options = #{address := Address}}) ->
    case chance(Address) of
        true -> fun(State) -> faultcheck_model:focus(Model, State, Key) end;
        false -> fun(State) -> State end
    end.

%% A fresh command of the same kind.
again({set, _, {call, _, Name, _}} = Command, #edit{model = Model} = Edit) ->
    Focus = focus(Edit),
    Draw = fun(State) ->
        case faultcheck_generator:fresh_arguments(Model, Focus(State), Name) of
            {ok, Imm, Args} -> {Imm, Args};
            error -> none
        end
    end,
    with_arguments(Command, Draw, Edit).

moved({set, _, {call, _, Name, Args}} = Command, #edit{model = Model, options = Options} = Edit) ->
    #{scale := Scale} = Options,
    Move = fun(State) ->
        New = faultcheck_model:mutate(Model, State, Name, Args, Scale),
        {New, New}
    end,
    with_arguments(Command, Move, Edit).

%% Tries a few times to find arguments that the precondition accepts.
with_arguments({set, {var, N}, _} = Command, Arguments, #edit{model = {Mod, _}} = Edit) ->
    {Commands, Side} = all(Edit),
    State = faultcheck_repair:state_before(Mod, N, Commands),
    case attempt(?ATTEMPTS, Command, State, Arguments, Edit) of
        {Imm, Args} ->
            {set, Var, {call, _, Name, _}} = Command,
            New = {set, Var, {call, Mod, Name, Args}},
            NewSide =
                case Imm of
                    Args -> maps:remove(N, Side);
                    _ -> Side#{N => Imm}
                end,
            {lists:keyreplace(Var, 2, Commands, New), NewSide};
        none ->
            {Commands, Side}
    end.

attempt(0, _Command, _State, _Arguments, _Edit) ->
    none;
attempt(Left, {set, _, {call, _, Name, _}} = Command, State, Arguments, Edit) ->
    case Arguments(State) of
        {_, Args} = New ->
            case faultcheck_model:allowed(Edit#edit.model, State, Name, Args) of
                true -> New;
                false -> attempt(Left - 1, Command, State, Arguments, Edit)
            end;
        none ->
            attempt(Left - 1, Command, State, Arguments, Edit)
    end.

%% ---- places -------------------------------------------------------------------------------

%% The number of a command of the body, from 1.
place(#edit{body = Body, options = #{follow := Follow}} = Edit) ->
    case chance(Follow) of
        true -> before_minimum(Edit);
        false -> rand:uniform(length(Body))
    end.

before_minimum(#edit{setting = Setting, body = Body, model = Model, parent = Parent} = Edit) ->
    #edit{options = #{lookback := Lookback}} = Edit,
    Set = lists:sum([duration(C, Model) || C <- Setting]),
    Wanted = maps:get(time, Parent) - Set + Lookback * math:log(1.0 - rand:uniform()),
    one_of(running(Body, Wanted, {1, []}, Model)).

%% The commands at a time since the body's first one: that which runs then, and those in front of
%% it that take no time.
running([_], _Left, {N, Group}, _Model) ->
    [N | Group];
running([Command | Rest], Left, {N, Group}, Model) ->
    case duration(Command, Model) of
        Duration when Duration > 0, Left < Duration -> [N | Group];
        Duration when Duration > 0 -> running(Rest, Left - Duration, {N + 1, []}, Model);
        _ -> running(Rest, Left, {N + 1, [N | Group]}, Model)
    end.

%% Faults are moved rather than others.
shifted(#edit{body = Body, model = {_, Info}} = Edit) ->
    Faults = faultcheck_model:faults(Info),
    Places = [N || {N, C} <- lists:zip(lists:seq(1, length(Body)), Body),
                   lists:member(name(C), Faults)],
    case Places =/= [] andalso chance(0.8) of
        true -> one_of(Places);
        false -> place(Edit)
    end.

chance(Probability) -> rand:uniform() < Probability.

one_of(List) -> lists:nth(rand:uniform(length(List)), List).

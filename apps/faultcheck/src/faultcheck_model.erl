%% @doc What a grouped stateful model exports, and how its callbacks are found.
%%
%% A command X of a model is a block of functions:
%%
%% ```
%% X_pre(State) -> boolean()                may X be chosen now?           optional
%% X_args(State) -> [proper_types:type()]   its arguments                  required
%% X_pre(State, Args) -> boolean()          are these arguments valid?     optional
%% X(Arg1, ..., ArgN) -> Result             run it                         required
%% X_next(State, Result, Args) -> State     what it does to the model      optional
%% X_post(State, Args, Result) -> boolean() what the answer must be        optional
%% X_req(State, Args, Result) -> [term()]   requirement tags it exercised  optional
%% '''
%%
%% and the model as a whole has
%%
%% ```
%% initial_state() -> State                                                required
%% weight(State, X) -> non_neg_integer()    how often X is chosen, 0 never optional
%% faults() -> [X]                          commands that inject faults    optional
%% '''
%%
%% What a guided search asks for besides (faultcheck_search); all optional, but for a search
%% objective/1:
%%
%% ```
%% objective(State) -> {Value, When, Key}   how near the run has come to failing so far: smaller
%%                                          is nearer. Asked after each command, in the state
%%                                          behind it. When: `now', or {time, T} in the unit of
%%                                          X_duration since the start. Key: who was involved,
%%                                          any term
%% X_duration(Args) -> number()             simulated time that the command takes, 0 if absent;
%%                                          in a model without any each command takes 1
%% X_mutate(Args, Scale, State) -> Args     arguments near Args; absent: faultcheck_perturb
%% setting() -> [X]                         commands that set the scene before all others: they
%%                                          are only moved, never deleted or placed elsewhere
%% focus(State, Key) -> State               a state in which X_args addresses those of Key; it
%%                                          is used to draw arguments, for nothing else
%% insertion(State, Key) -> [{X, Types}]    commands to insert together, with the types of their
%%                                          arguments
%% snapshot() -> Ref                        the whole state of the system under test: faults,
%% restore(Ref), release(Ref)               queues, random streams, the objective so far
%% '''
%%
%% What it may do for a stored case (faultcheck_case, faultcheck_export):
%%
%% ```
%% report(Case, Dir) -> ok | faultcheck_case:told()     adds files to its folder
%% export(Case, Dir, What) -> {ok, Files} | {error, Line}
%% '''
%%
%% X_next also runs while commands are generated; the result is then a symbolic
%% variable {var,N}, so it must not look inside it.
-module(faultcheck_model).

-export([info/1, optional/0, commands/1, faults/1, enabled/2, args/3, allowed/4, next/5, post/5,
         requirements/5]).
-export([setting/1, objective/2, duration/3, mutate/5, focus/3, insertion/3]).
-export([has_objective/1, has_snapshots/1]).
-export([command/2, precondition/3, next_state/4, postcondition/4]).
-export_type([info/0, state/0, command_name/0, moment/0]).

-type state() :: term().
-type command_name() :: atom().

%% Names of the optional callbacks, or none: looked up once, not on each call.
-record(command, {name :: command_name(),
                  args :: atom(),
                  pre1 = none :: atom(),
                  pre2 = none :: atom(),
                  next = none :: atom(),
                  post = none :: atom(),
                  req = none :: atom(),
                  mutate = none :: atom(),
                  duration = none :: atom()}).
-record(info, {commands :: #{command_name() => #command{}},
               list :: [#command{}],
               faults :: [command_name()],
               setting :: [command_name()],
               %% whether any command has a duration
               timed :: boolean(),
               %% which of optional/0 there are
               has :: #{{atom(), arity()} => true}}).
-opaque info() :: #info{}.
%% When in a run its objective was smallest.
-type moment() :: now | {time, number()}.

%% @doc The callbacks of a model. Cached until another version of it is loaded. A module that is
%% no model is the caller's error {not_a_model, Mod, Why}.
-spec info(module()) -> info().
info(Mod) ->
    Version = version(Mod),
    case persistent_term:get({?MODULE, Mod}, none) of
        {Version, Info} ->
            Info;
        _ ->
            Info = read(Mod),
            persistent_term:put({?MODULE, Mod}, {Version, Info}),
            Info
    end.

%% In words, since whoever reads this named the wrong module or forgot the header.
version(Mod) ->
    try
        Mod:module_info(md5)
    catch
        error:undef -> error({not_a_model, Mod, "there is no such module in the code path"})
    end.

%% @doc What a model as a whole may export besides initial_state/0.
-spec optional() -> [{atom(), arity()}].
optional() ->
    [{weight, 2}, {faults, 0}, {objective, 1}, {setting, 0}, {focus, 2}, {insertion, 2},
     {snapshot, 0}, {restore, 1}, {release, 1}].

%% @doc The command names of a model, in alphabetical order.
-spec commands(info()) -> [command_name()].
commands(#info{list = Commands}) ->
    [C#command.name || C <- Commands].

%% @doc Commands that a model declares as faults.
-spec faults(info()) -> [command_name()].
faults(#info{faults = Faults}) ->
    Faults.

%% @doc Commands that may be chosen in a state, with their weights (all above 0).
-spec enabled({module(), info()}, state()) -> [{pos_integer(), command_name()}].
enabled({Mod, #info{list = Commands} = Info}, State) ->
    Weighted = has({weight, 2}, Info),
    [{Weight, Name} || #command{name = Name, pre1 = Pre} <- Commands,
                       Pre =:= none orelse Mod:Pre(State),
                       Weight <- [weight(Weighted, Mod, State, Name)],
                       Weight > 0].

weight(false, _Mod, _State, _Name) -> 1;
weight(true, Mod, State, Name) -> Mod:weight(State, Name).

%% @doc The argument types of a command in a state.
-spec args({module(), info()}, state(), command_name()) -> proper_types:raw_type().
args({Mod, Info}, State, Name) ->
    #command{args = Args} = command_of(Mod, Info, Name),
    Mod:Args(State).

%% @doc Both preconditions of a command.
-spec allowed({module(), info()}, state(), command_name(), [term()]) -> boolean().
allowed({Mod, Info}, State, Name, Args) ->
    #command{pre1 = Pre1, pre2 = Pre2} = command_of(Mod, Info, Name),
    (Pre1 =:= none orelse Mod:Pre1(State)) andalso (Pre2 =:= none orelse Mod:Pre2(State, Args)).

%% @doc The model's state after a command.
-spec next({module(), info()}, state(), command_name(), [term()], Result :: term()) -> state().
next({Mod, Info}, State, Name, Args, Result) ->
    case command_of(Mod, Info, Name) of
        #command{next = none} -> State;
        #command{next = Next} -> Mod:Next(State, Result, Args)
    end.

%% @doc The postcondition of a command, in the state before it; true when it has none.
-spec post({module(), info()}, state(), command_name(), [term()], Result :: term()) -> term().
post({Mod, Info}, State, Name, Args, Result) ->
    case command_of(Mod, Info, Name) of
        #command{post = none} -> true;
        #command{post = Post} -> Mod:Post(State, Args, Result)
    end.

%% @doc The requirement tags a command exercised.
-spec requirements({module(), info()}, state(), command_name(), [term()], Result :: term()) ->
          [term()].
requirements({Mod, Info}, State, Name, Args, Result) ->
    case command_of(Mod, Info, Name) of
        #command{req = none} -> [];
        #command{req = Req} -> Mod:Req(State, Args, Result)
    end.

%%% For a guided search

%% @doc Commands that set the scene.
-spec setting(info()) -> [command_name()].
setting(#info{setting = Setting}) ->
    Setting.

%% @doc Whether the model says how near a run came to failing.
-spec has_objective(info()) -> boolean().
has_objective(Info) ->
    has({objective, 1}, Info).

%% @doc Whether the system under test can be put back to where it was.
-spec has_snapshots(info()) -> boolean().
has_snapshots(Info) ->
    lists:all(fun(F) -> has(F, Info) end, [{snapshot, 0}, {restore, 1}, {release, 1}]).

%% @doc How near to failing the run has come, when, and by whom.
-spec objective({module(), info()}, state()) ->
          {Value :: term(), moment(), Key :: term()}.
objective({Mod, _}, State) ->
    Mod:objective(State).

%% @doc The simulated time that a command takes; 1 in a model that knows no time.
-spec duration({module(), info()}, command_name(), [term()]) -> number().
duration({_, #info{timed = false}}, _Name, _Args) ->
    1;
duration({Mod, Info}, Name, Args) ->
    case command_of(Mod, Info, Name) of
        #command{duration = none} -> 0;
        #command{duration = Duration} -> Mod:Duration(Args)
    end.

%% @doc Arguments near the given ones.
-spec mutate({module(), info()}, state(), command_name(), [term()], faultcheck_perturb:scale()) ->
          [term()].
mutate({Mod, Info} = Model, State, Name, Args, Scale) ->
    case command_of(Mod, Info, Name) of
        #command{mutate = none} ->
            faultcheck_perturb:arguments(Args, Scale, args(Model, State, Name));
        #command{mutate = Mutate} ->
            Mod:Mutate(Args, Scale, State)
    end.

%% @doc The state from which to draw arguments that address those of Key.
-spec focus({module(), info()}, state(), Key :: term()) -> state().
focus({Mod, Info}, State, Key) ->
    case has({focus, 2}, Info) of
        true -> Mod:focus(State, Key);
        false -> State
    end.

%% @doc Commands that the model wants inserted together; none when it has no wish.
-spec insertion({module(), info()}, state(), Key :: term()) ->
          [{command_name(), faultcheck_proper:type()}] | none.
insertion({Mod, Info}, State, Key) ->
    case has({insertion, 2}, Info) of
        true -> Mod:insertion(State, Key);
        false -> none
    end.

%% The plain callbacks of proper_statem, which the parse transform delegates to here.

%% @private
-spec command(module(), state()) -> proper_types:type().
command(Mod, State) ->
    Model = {Mod, info(Mod)},
    Choices = [{Weight, {call, Mod, Name, args(Model, State, Name)}}
               || {Weight, Name} <- enabled(Model, State)],
    proper_types:frequency(Choices).

%% @private
-spec precondition(module(), state(), {call, module(), command_name(), [term()]}) -> boolean().
precondition(Mod, State, {call, _, Name, Args}) ->
    allowed({Mod, info(Mod)}, State, Name, Args).

%% @private
-spec next_state(module(), state(), term(), {call, module(), command_name(), [term()]}) -> state().
next_state(Mod, State, Result, {call, _, Name, Args}) ->
    next({Mod, info(Mod)}, State, Name, Args, Result).

%% @private
-spec postcondition(module(), state(), {call, module(), command_name(), [term()]}, term()) ->
          boolean().
postcondition(Mod, State, {call, _, Name, Args}, Result) ->
    post({Mod, info(Mod)}, State, Name, Args, Result) =:= true.

command_of(Mod, #info{commands = Commands}, Name) ->
    case Commands of
        #{Name := Command} -> Command;
        #{} -> error({unknown_command, Mod, Name, maps:keys(Commands)})
    end.

read(Mod) ->
    Exports = maps:from_list([{Export, true} || Export <- Mod:module_info(exports)]),
    Names = lists:sort([Name || {F, 1} <- maps:keys(Exports),
                                {ok, Name} <- [without_suffix(F, "_args")]]),
    Commands = [read_command(Name, Exports) || Name <- Names],
    Commands =:= [] andalso
        error({not_a_model, Mod, "it exports no X_args/1; does it include faultcheck.hrl?"}),
    is_map_key({initial_state, 0}, Exports) orelse
        error({not_a_model, Mod, "it exports no initial_state/0"}),
    #info{commands = maps:from_list([{C#command.name, C} || C <- Commands]),
          list = Commands,
          faults = names(Mod, faults, Exports),
          setting = names(Mod, setting, Exports),
          timed = lists:any(fun(C) -> C#command.duration =/= none end, Commands),
          has = maps:with(optional(), Exports)}.

names(Mod, Function, Exports) ->
    case is_map_key({Function, 0}, Exports) of
        true -> Mod:Function();
        false -> []
    end.

has(Function, #info{has = Has}) ->
    is_map_key(Function, Has).

without_suffix(Function, Suffix) ->
    Name = atom_to_list(Function),
    case lists:suffix(Suffix, Name) andalso length(Name) > length(Suffix) of
        true -> {ok, list_to_atom(lists:sublist(Name, length(Name) - length(Suffix)))};
        false -> none
    end.

read_command(Name, Exports) ->
    Callback = fun(Suffix, Arity) ->
                       Function = list_to_atom(atom_to_list(Name) ++ Suffix),
                       case is_map_key({Function, Arity}, Exports) of
                           true -> Function;
                           false -> none
                       end
               end,
    #command{name = Name,
             args = Callback("_args", 1),
             pre1 = Callback("_pre", 1),
             pre2 = Callback("_pre", 2),
             next = Callback("_next", 3),
             post = Callback("_post", 3),
             req = Callback("_req", 3),
             mutate = Callback("_mutate", 3),
             duration = Callback("_duration", 1)}.

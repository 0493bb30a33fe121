%% @doc Leaves a command out while a value that depended on it moves by one bit.
%%
%% Two bit flips and the value that both turn into the dangerous one are minimal as they are:
%% without one of the flips the value is wrong, and any other value is wrong with both. So each
%% removal is tried again with each integer of the other commands changed by one bit, in all
%% commands of that name at once, as long as the generators of the model could give it.
%% Short sequences only: it is the last resort, after faultcheck_shrinker's other steps.
-module(faultcheck_joint_shrinker).

-export([candidates/2]).

%% Longest sequence that is looked at, and most candidates given.
-define(MOST_COMMANDS, 10).
-define(MOST_CANDIDATES, 2000).

-type command() :: faultcheck_generator:command().

%% @doc The sequences to try, each one command shorter than the given one.
-spec candidates(module(), [command()]) -> [[command()]].
candidates(_Mod, Commands) when length(Commands) > ?MOST_COMMANDS ->
    [];
candidates(Mod, Commands) ->
    All = [
        Moved
     || Left <- lists:reverse(Commands),
        Kept <- [lists:delete(Left, Commands)],
        {Name, Value} <- values(Kept),
        Bit <- bits(Value),
        Moved <- [move(Name, Value, Value bxor (1 bsl Bit), Kept)],
        generated(Mod, Kept, Moved)
    ],
    lists:sublist(All, ?MOST_CANDIDATES).

%% The integers in the arguments, each with the commands it stands in.
values(Commands) ->
    lists:usort([
        {Name, Value}
     || {set, _, {call, _, Name, Args}} <- Commands, Value <- integers(Args)
    ]).

integers(Value) when is_integer(Value) -> [Value];
integers([First | Rest]) -> integers(First) ++ integers(Rest);
integers({var, _}) -> [];
integers(Tuple) when is_tuple(Tuple) -> integers(tuple_to_list(Tuple));
integers(_) -> [].

%% The bits of a byte, or of the value if it is larger.
bits(Value) -> lists:seq(0, max(8, width(abs(Value))) - 1).

width(0) -> 0;
width(Value) -> 1 + width(Value bsr 1).

move(Name, From, To, Commands) ->
    [
        case Called of
            Name -> {set, Var, {call, Mod, Name, moved(From, To, Args)}};
            _ -> Command
        end
     || {set, Var, {call, Mod, Called, Args}} = Command <- Commands
    ].

moved(From, To, From) -> To;
moved(From, To, [First | Rest]) -> [moved(From, To, First) | moved(From, To, Rest)];
moved(_, _, {var, _} = Var) -> Var;
moved(From, To, Tuple) when is_tuple(Tuple) ->
    list_to_tuple(moved(From, To, tuple_to_list(Tuple)));
moved(_, _, Other) -> Other.

%% Whether the model's generators could give the arguments that changed.
generated(Mod, Before, After) ->
    lists:all(
        fun({Same, Same}) -> true;
           ({_, Command}) -> faultcheck_argument_shrinker:generated(Mod, Command, After)
        end,
        lists:zip(Before, After)
    ).

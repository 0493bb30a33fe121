%% @doc Stored counterexamples: sequences that made copters collide, shrunk, with their options.
%%
%% priv/counterexamples has a file NAME.eterm for each, and its scenario NAME.json beside it: the
%% same flight, for coptersim_run.
-module(copter_stored).

-export([all/0, origin/1, write/4]).
-export_type([origin/0]).

-type stored() :: {
    Name :: string(), copter_options:options(), [faultcheck_generator:command()]
}.

%% Where one comes from: which test of which seed (copter_trial:commands/3), and how many commands
%% that had.
-type origin() :: #{
    property := string(),
    seed := non_neg_integer(),
    test := pos_integer(),
    commands := pos_integer()
}.

%% @doc All of them, by name.
-spec all() -> [stored()].
all() ->
    [read(File) || File <- lists:sort(filelib:wildcard(filename:join(dir(), "*.eterm")))].

dir() -> filename:join(code:priv_dir(copter_eqc), "counterexamples").

read(File) ->
    case file:consult(File) of
        {ok, [#{options := Changes, calls := Calls}]} ->
            {filename:basename(File, ".eterm"), copter_options:new(Changes), commands(Calls)};
        {error, Reason} ->
            error({counterexample, File, file:format_error(Reason)})
    end.

%% @doc Where the one with this name comes from, if its file says so.
-spec origin(string()) -> origin() | none.
origin(Name) ->
    case file:consult(filename:join(dir(), Name ++ ".eterm")) of
        {ok, [#{origin := Origin}]} -> Origin;
        {ok, _} -> none
    end.

commands(Calls) ->
    Numbers = lists:seq(1, length(Calls)),
    [{set, {var, N}, {call, copter_eqc, F, Args}} || {N, {F, Args}} <- lists:zip(Numbers, Calls)].

%% @doc Writes one into a directory: both files. Changes are those of copter_options:new/1.
-spec write(
    file:filename(), Name :: string(), Changes :: map(), [faultcheck_generator:command()]
) -> ok.
write(Dir, Name, Changes, Commands) ->
    Calls = [{F, Args} || {set, _, {call, copter_eqc, F, Args}} <- Commands],
    Text = io_lib:format("~lp.~n", [#{options => Changes, calls => Calls}]),
    Scenario = copter_scenario:from_commands(Commands, copter_options:new(Changes), [
        {name, {text, Name}}
    ]),
    ok = file:write_file(filename:join(Dir, Name ++ ".eterm"), Text),
    file:write_file(filename:join(Dir, Name ++ ".json"), faultcheck_json:pretty(Scenario)).

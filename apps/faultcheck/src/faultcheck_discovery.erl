%% @doc Finds properties in compiled test directories, without loading a module, and chooses
%% among them as the options say.
-module(faultcheck_discovery).

-export([find/2, select/2]).
-export_type([place/0, found/0]).

%% The directory of the sources and that of their beam files.
-type place() :: {Sources :: file:filename(), Beams :: file:filename()}.
-type found() :: [{module(), [Property :: atom()]}].

%% @doc The modules named `prop_*', and those in Named, with their properties: exported
%% functions without arguments whose name begins with `prop_'.
-spec find([place()], [module()]) -> {ok, found()} | {error, string()}.
find(Places, Named) ->
    Modules = [
        {Module, filename:join(Beams, atom_to_list(Module) ++ ".beam")}
     || {Sources, Beams} <- Places,
        File <- lists:sort(filelib:wildcard("*.erl", Sources)),
        Module <- [list_to_atom(filename:rootname(File))],
        lists:prefix("prop_", atom_to_list(Module)) orelse lists:member(Module, Named)
    ],
    find(Modules, [], []).

find([], _Seen, Found) ->
    {ok, lists:reverse(Found)};
find([{Module, Beam} | Rest], Seen, Found) ->
    case {lists:member(Module, Seen), beam_lib:chunks(Beam, [exports])} of
        {true, _} ->
            find(Rest, Seen, Found);
        {false, {ok, {Module, [{exports, Exports}]}}} ->
            find(Rest, [Module | Seen], [{Module, properties(Exports)} | Found]);
        {false, _} ->
            {error, lists:concat(["module ", Module, " is not compiled: no usable ", Beam])}
    end.

properties(Exports) ->
    [F || {F, 0} <- lists:sort(Exports), lists:prefix("prop_", atom_to_list(F))].

%% @doc The properties to run, in the order of modules and names; all when nothing is named.
-spec select(faultcheck_options:options(), found()) ->
    {ok, [{module(), atom()}]} | {error, string()}.
select(Options, Found) ->
    case modules(maps:find(module, Options), Found) of
        {ok, Modules} -> chosen(maps:find(prop, Options), Modules);
        {error, _} = Error -> Error
    end.

modules(error, Found) ->
    {ok, Found};
modules({ok, Names}, Found) ->
    case [Name || Name <- Names, not lists:keymember(Name, 1, Found)] of
        [] -> {ok, [F || {Module, _} = F <- Found, lists:member(Module, Names)]};
        [Name | _] -> {error, unknown("module", Name, [M || {M, _} <- Found])}
    end.

chosen(error, Modules) ->
    {ok, [{M, P} || {M, Ps} <- Modules, P <- Ps]};
chosen({ok, Names}, Modules) ->
    All = [P || {_, Ps} <- Modules, P <- Ps],
    case Names -- All of
        [] -> {ok, [{M, P} || {M, Ps} <- Modules, P <- Ps, lists:member(P, Names)]};
        [Name | _] -> {error, unknown("property", Name, All)}
    end.

unknown(What, Name, Known) ->
    Text = atom_to_list(Name),
    Names = [atom_to_list(K) || K <- Known],
    There =
        case faultcheck_suggest:phrase(Text, Names) of
            "" when Names =:= [] -> "; there is none at all";
            "" when length(Names) =:= 1 -> "; there is " ++ hd(Names);
            "" -> "; there are " ++ lists:flatten(lists:join(", ", lists:sort(Names)));
            Near -> Near
        end,
    lists:concat(["no ", What, " ", Text, There]).

%% @doc The folder that a live flight leaves below those of the cases.
%%
%% A flight that some property could have made is a case (faultcheck_case). Any other one is its
%% scenario alone, scenario.json, from which it can be played again; no property repeats it.
-module(replay_kept).

-export([write/3, find/2, is_flight/1, told/2]).
-export_type([kept/0, files/0]).

-type kept() :: faultcheck_case:'case'() | {flight, Id :: string()}.
%% Further files of the folder.
-type files() :: [{file:filename(), iodata()}].

%% @doc Writes it below Root, with the files that belong to it, and answers its folder. The error is
%% one line.
-spec write(file:filename(), kept(), files()) -> {ok, file:filename()} | {error, string()}.
write(Root, {flight, Id}, Files) ->
    Dir = filename:join(Root, Id),
    case filelib:ensure_dir(filename:join(Dir, "x")) of
        ok -> added(Dir, Files);
        {error, Why} -> {error, lists:concat([Dir, ": ", file:format_error(Why)])}
    end;
write(Root, Case, Files) ->
    case faultcheck_case:write(Root, Case) of
        {ok, Dir} -> added(Dir, Files);
        {error, _} = Error -> Error
    end.

added(Dir, Files) ->
    try lists:foreach(fun({N, Text}) -> ok = faultcheck_case:add_file(Dir, N, Text) end, Files) of
        ok -> {ok, Dir}
    catch
        error:{not_written, Line} -> {error, Line}
    end.

%% @doc Whether a folder is that of a flight which is no case.
-spec is_flight(file:filename()) -> boolean().
is_flight(Dir) ->
    filelib:is_regular(filename:join(Dir, "scenario.json")) andalso
        not filelib:is_file(filename:join(Dir, "case.json")).

%% @doc The case or flight that a user names: by its path, or by its id below Root. The error is a
%% line for the user.
-spec find(file:filename(), file:filename()) -> {ok, file:filename()} | {error, string()}.
find(Given, Root) ->
    Below = [filename:join(Root, Given) || filename:basename(Given) =:= Given],
    case lists:filter(fun is_flight/1, [Given | Below]) of
        [Dir | _] -> {ok, Dir};
        [] -> readable(faultcheck_case:find(Given, Root))
    end.

readable({ok, Path}) ->
    case faultcheck_case:read(Path) of
        {ok, _} -> {ok, Path};
        {error, _} = Error -> Error
    end;
readable({error, _} = Error) ->
    Error.

%% @doc What the user is told when it has been written under a name.
-spec told(kept(), file:filename()) -> string().
told({flight, _}, Name) ->
    lists:concat(["stored this flight as ", Name, ": it can be played, but no property has its "
                  "world, so it is no case"]);
told(_, Name) ->
    lists:concat(["stored this flight as ", Name]).

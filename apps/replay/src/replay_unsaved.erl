%% @doc A live flight while it goes on, so that it outlives a player that is killed.
%%
%% Every now and then it is written into `.unfinished-PID' below the folder of the cases,
%% PID being that of the player. It goes when the flight is stored; what a dead player has left
%% there is stored when the next one starts.
-module(replay_unsaved).

-export([write/3, forget/1, recover/1]).

%% @doc Writes what there is of a flight, in the place of what was written before.
-spec write(file:filename(), module(), replay_source:state()) -> ok | {error, string()}.
write(Cases, Mod, State) ->
    Root = place(Cases),
    {Kept, Files} = Mod:store(State),
    case replay_kept:write(Root, Kept, Files) of
        {ok, Dir} ->
            _ = [file:del_dir_r(Old) || Old <- folders(Root), Old =/= Dir],
            ok;
        {error, _} = Error ->
            Error
    end.

place(Cases) -> filename:join(Cases, ".unfinished-" ++ os:getpid()).

%% Not those that are being written.
folders(Root) ->
    Files = filelib:wildcard(filename:join(Root, "*/{case,scenario}.json")),
    lists:usort([D || F <- Files, D <- [filename:dirname(F)], hd(filename:basename(D)) =/= $.]).

%% @doc The flight has been stored.
-spec forget(file:filename()) -> ok.
forget(Cases) ->
    _ = file:del_dir_r(place(Cases)),
    ok.

%% @doc Stores what dead players have left, and tells the folders.
-spec recover(file:filename()) -> [file:filename()].
recover(Cases) ->
    Left = filelib:wildcard(filename:join(Cases, ".unfinished-*")),
    lists:append([recovered(Cases, Root) || Root <- Left, not is_of_living(Root)]).

is_of_living(Root) ->
    "-" ++ Pid = string:find(filename:basename(Root), "-"),
    filelib:is_dir(filename:join("/proc", Pid)).

recovered(Cases, Root) ->
    Moved = [
        New
     || Dir <- folders(Root),
        New <- [filename:join(Cases, filename:basename(Dir))],
        file:rename(Dir, New) =:= ok
    ],
    _ = file:del_dir_r(Root),
    Moved.

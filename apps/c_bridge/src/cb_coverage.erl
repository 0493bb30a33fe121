%% @doc Coverage counts of gcov: where they go, and the notes that belong to them.
%%
%% Counts are written to Dir followed by the absolute path that the object file had when it was
%% compiled, so that several builds and runs keep apart. gcov and lcov want the notes (.gcno)
%% beside the counts (.gcda).
-module(cb_coverage).

-export([environment/1, collect/1]).

%% @doc What the process that holds the code under test needs in its environment.
-spec environment(none | file:filename()) -> [{string(), string()}].
environment(none) -> [];
environment(Dir) -> [{"GCOV_PREFIX", filename:absname(Dir)}, {"GCOV_PREFIX_STRIP", "0"}].

%% @doc Copies the notes of all counts below Dir beside them.
-spec collect(file:filename()) -> ok.
collect(Dir) ->
    Root = filename:absname(Dir),
    lists:foreach(
        fun(Counts) -> copy_notes(Root, filename:rootname(Counts) ++ ".gcno") end,
        filelib:wildcard("**/*.gcda", Root)
    ).

copy_notes(Root, Relative) ->
    Origin = filename:join("/", Relative),
    Copy = filename:join(Root, Relative),
    case filelib:is_regular(Origin) of
        true ->
            {ok, _} = file:copy(Origin, Copy),
            ok;
        false ->
            ok
    end.

%% @doc Where two terms differ first: of two long histories of states, the one member that matters.
-module(e2e_difference).

-export([same/2]).
-export_type([difference/0]).

%% Keys of maps and positions in lists and tuples, from 1, on the way to the difference.
-type difference() :: {at, [term()], expected, term(), got, term()}.

%% @doc true, or the first difference.
-spec same(Expected :: term(), Actual :: term()) -> true | difference().
same(Expected, Actual) -> same(Expected, Actual, []).

same(Same, Same, _) ->
    true;
same(Expected, Actual, Path) when is_map(Expected), is_map(Actual) ->
    case maps:keys(Expected) =:= maps:keys(Actual) of
        true -> first(maps:keys(Expected), maps:values(Expected), maps:values(Actual), Path);
        false -> differs(Expected, Actual, Path)
    end;
same(Expected, Actual, Path) when is_tuple(Expected), is_tuple(Actual) ->
    same(tuple_to_list(Expected), tuple_to_list(Actual), Path);
same(Expected, Actual, Path) when is_list(Expected), length(Expected) =:= length(Actual) ->
    first(lists:seq(1, length(Expected)), Expected, Actual, Path);
same(Expected, Actual, Path) ->
    differs(Expected, Actual, Path).

first([_ | Keys], [Same | Expected], [Same | Actual], Path) -> first(Keys, Expected, Actual, Path);
first([Key | _], [Expected | _], [Actual | _], Path) -> same(Expected, Actual, [Key | Path]).

differs(Expected, Actual, Path) -> {at, lists:reverse(Path), expected, Expected, got, Actual}.

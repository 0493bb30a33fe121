%% @doc Finds what somebody probably meant: the known words nearest to a mistyped one.
-module(faultcheck_suggest).

-export([similar/2, phrase/2]).

-define(MOST, 3).

%% @doc The known words within a third of their length in single-letter edits, nearest first.
-spec similar(string(), [string()]) -> [string()].
similar(Word, Known) ->
    Near = [
        {Distance, K}
     || K <- lists:usort(Known),
        Distance <- [distance(string:lowercase(Word), string:lowercase(K))],
        Distance =< max(1, max(length(Word), length(K)) div 3) orelse
            (length(Word) > 2 andalso lists:prefix(Word, K))
    ],
    lists:sublist([K || {_, K} <- lists:sort(Near)], ?MOST).

%% @doc `"; did you mean a or b?"', or nothing when no known word is near.
-spec phrase(string(), [string()]) -> string().
phrase(Word, Known) ->
    case similar(Word, Known) of
        [] -> "";
        Near -> "; did you mean " ++ lists:flatten(lists:join(" or ", Near)) ++ "?"
    end.

%% Levenshtein distance, one row at a time.
distance(A, B) ->
    First = lists:seq(0, length(B)),
    lists:last(lists:foldl(fun(Char, Row) -> next_row(Char, B, Row) end, First, A)).

next_row(Char, B, [First | _] = Row) ->
    next_row(Char, B, Row, [First + 1]).

next_row(_Char, [], [_], Done) ->
    lists:reverse(Done);
next_row(Char, [C | B], [Diagonal, Above | Row], [Left | _] = Done) ->
    Cost =
        case C of
            Char -> 0;
            _ -> 1
        end,
    next_row(Char, B, [Above | Row], [lists:min([Above + 1, Left + 1, Diagonal + Cost]) | Done]).

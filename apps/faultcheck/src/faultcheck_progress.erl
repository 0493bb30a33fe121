%% @doc Who wants to hear, now and then, how shrinking goes: a function of this process.
-module(faultcheck_progress).

-export([set/1, shrinking/1]).

-define(EVERY_MS, 200).

%% @doc Sets the function, or undefined to hear no more.
-spec set(fun((map()) -> term()) | undefined) -> ok.
set(undefined) ->
    _ = erase(?MODULE),
    ok;
set(Report) when is_function(Report, 1) ->
    _ = put(?MODULE, {Report, now_ms()}),
    ok.

%% @doc Reports, unless that was done a moment ago. The map is made only when wanted.
-spec shrinking(fun(() -> map())) -> ok.
shrinking(Map) ->
    case get(?MODULE) of
        undefined ->
            ok;
        {Report, Last} ->
            Now = now_ms(),
            case Now - Last >= ?EVERY_MS of
                true ->
                    _ = put(?MODULE, {Report, Now}),
                    _ = Report(Map()),
                    ok;
                false ->
                    ok
            end
    end.

now_ms() ->
    erlang:monotonic_time(millisecond).

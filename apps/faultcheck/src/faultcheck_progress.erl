%% @doc Who wants to hear, now and then, how long work goes: a function of this process.
-module(faultcheck_progress).

-export([set/1, report/2]).
-export_type([what/0]).

-type what() :: shrinking | searching.

-define(EVERY_MS, 200).

%% @doc Sets the function, or undefined to hear no more.
-spec set(fun((what(), map()) -> term()) | undefined) -> ok.
set(undefined) ->
    _ = erase(?MODULE),
    ok;
set(Listener) when is_function(Listener, 2) ->
    _ = put(?MODULE, {Listener, now_ms()}),
    ok.

%% @doc Reports, unless that was done a moment ago. The map is made only when wanted.
-spec report(what(), fun(() -> map())) -> ok.
report(What, Map) ->
    case get(?MODULE) of
        undefined ->
            ok;
        {Listener, Last} ->
            Now = now_ms(),
            case Now - Last >= ?EVERY_MS of
                true ->
                    _ = put(?MODULE, {Listener, Now}),
                    _ = Listener(What, Map()),
                    ok;
                false ->
                    ok
            end
    end.

now_ms() ->
    erlang:monotonic_time(millisecond).

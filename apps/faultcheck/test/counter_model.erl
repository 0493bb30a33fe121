%% A counter in a public table for tests of parallel cases: count/0 adds one in one step, or where
%% the table says so in two, so that two at once may lose one.
-module(counter_model).

-include("faultcheck.hrl").

-export([reset/1]).

-record(st, {count = 0, given = [], taken = false}).

reset(Kind) ->
    _ = ets:whereis(?MODULE) =/= undefined orelse ets:new(?MODULE, [public, named_table]),
    ets:insert(?MODULE, [{count, 0}, {kind, Kind}]).

initial_state() -> #st{}.

weight(_, count) -> 3;
weight(_, _) -> 1.

count_args(_) -> [].
count() ->
    case ets:lookup(?MODULE, kind) of
        [{_, atomic}] ->
            ets:update_counter(?MODULE, count, 1);
        [{_, torn}] ->
            [{_, N}] = ets:lookup(?MODULE, count),
            erlang:yield(),
            ets:insert(?MODULE, {count, N + 1}),
            N + 1
    end.
count_next(#st{count = N, given = Given} = S, Result, []) ->
    S#st{count = N + 1, given = [Result | Given]}.
count_post(#st{count = N}, [], Result) -> Result =:= N + 1.

read_args(_) -> [].
read() ->
    [{_, N}] = ets:lookup(?MODULE, count),
    N.
read_post(#st{count = N}, [], Result) -> Result =:= N.

%% Uses the result of a count.
known_pre(#st{given = Given}) -> Given =/= [].
known_args(#st{given = Given}) -> [oneof(Given)].
known_pre(#st{given = Given}, [Which]) -> lists:member(Which, Given).
known(Which) -> Which.
known_post(_, [Which], Result) -> Result =:= Which.

%% ---- take: once only, so never in two branches
take_pre(#st{taken = Taken}) -> not Taken.
take_args(_) -> [].
take_pre(#st{taken = Taken}, []) -> not Taken.
take() -> taken.
take_next(S, _, []) -> S#st{taken = true}.
take_post(_, [], Result) -> Result =:= taken.

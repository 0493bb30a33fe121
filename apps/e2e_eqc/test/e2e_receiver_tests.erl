-module(e2e_receiver_tests).
-include_lib("eunit/include/eunit.hrl").

%% e2e.md section 9, "Recovery", for profile 1 with MaxDeltaCounterInit 3 and SyncCounterInit 0:
%% fault-free packets until the second OK, from every state that faults can bring about.
recovery_test_() ->
    [
        {"MaxNoNewOrRepeatedData 14", fun() -> ?assertEqual({3, 12}, worst(14)) end},
        {"MaxNoNewOrRepeatedData 0", fun() -> ?assertEqual({4, 13}, worst(0)) end}
    ].

worst(MaxNoNew) ->
    Config = (e2e_configuration:example(p01))#{'MaxNoNewOrRepeatedData' := MaxNoNew},
    {longest(Config, true_counters), longest(Config, any_counter)}.

longest(Config, Counters) ->
    States = reachable(Config, Counters, [start()], #{}),
    %% the burst comes when the application has asked and there was nothing new
    Asked = [after_event(Config, State, none) || State <- maps:keys(States)],
    lists:max([packets_to_two(Config, State, 0, 2) || State <- Asked]).

%% A receiver and the counter that is sent next.
start() -> {plain(e2e_receiver:initial(p01)), 0}.

%% Status and LostData decide nothing.
plain(State) -> State#{'Status' := 'NONEWDATA', 'LostData' := 0}.

reachable(_, _, [], Seen) -> Seen;
reachable(Config, Counters, [State | Rest], Seen) when is_map_key(State, Seen) ->
    reachable(Config, Counters, Rest, Seen);
reachable(Config, Counters, [State | Rest], Seen) ->
    Next = [after_event(Config, State, Event) || Event <- events(Counters, State)],
    reachable(Config, Counters, Next ++ Rest, Seen#{State => true}).

%% A packet is lost, corrupted, delivered or delivered twice, or there is none; or its counter was
%% corrupted undetectably. The application asks until there is nothing new, so a lost packet is a
%% check without data.
events(true_counters, _) -> [none, lost, corrupted, delivered, twice];
events(any_counter, State) -> events(true_counters, State) ++ lists:seq(0, 14).

after_event(Config, {State, Next}, none) -> {judged(Config, State, none), Next};
after_event(Config, {State, Next}, Event) ->
    After = lists:foldl(
        fun(Found, Before) -> judged(Config, Before, Found) end, State, found(Event, Next)),
    {After, (Next + 1) rem 15}.

found(lost, _) -> [none];
found(corrupted, _) -> [{0, false}];
found(delivered, Next) -> [{Next, true}];
found(twice, Next) -> [{Next, true}, {Next, true}];
found(Counter, _) -> [{Counter, true}].

judged(Config, State, Found) ->
    {ok, After} = e2e_receiver:judge(p01, Config, State, Found),
    plain(After).

packets_to_two(_, _, Packets, 0) -> Packets;
packets_to_two(Config, {State, Next}, Packets, Missing) ->
    {ok, #{'Status' := Status} = After} = e2e_receiver:judge(p01, Config, State, {Next, true}),
    Left = if Status =:= 'OK' -> Missing - 1; true -> Missing end,
    packets_to_two(Config, {After, (Next + 1) rem 15}, Packets + 1, Left).

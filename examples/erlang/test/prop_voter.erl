%% Whatever one of three sensors says, the median is not outside what the other two say.
%%
%% The fault is any that FaultCheck knows for a value: noise, drift, delay, a stuck bit, ...
%% (docs/faults.md lists them). With voter_mean in the place of voter_median the property fails.
-module(prop_voter).
-include_lib("faultcheck/include/faultcheck.hrl").

prop_one_faulty_sensor_is_harmless() ->
    ?SETUP(fun() -> {ok, Lib} = cb:start(voter, [{c_src, "c_src/voter.c"},
                                                 {libs, ["faultcheck"]}]),
                    fun() -> cb:stop(Lib) end end,
           ?FORALL({Faulty, Fault, Readings},
                   {oneof([1, 2, 3]), faultcheck_fault_gen:value(f64), non_empty(list(reading()))},
                   begin
                       ok = cb:restart(voter),
                       {ok, _} = faultcheck_inject:arm(voter, null, probe(Faulty), Fault),
                       lists:all(fun(Reading) -> tolerated(Faulty, Reading) end, Readings)
                   end)).

reading() -> {metres(), metres(), metres()}.

metres() -> float(-100.0, 100.0).

probe(1) -> {probe, <<"S1val">>};
probe(2) -> {probe, <<"S2val">>};
probe(3) -> {probe, <<"S3val">>}.

tolerated(Faulty, Reading) ->
    [First, Second] = [element(Sensor, Reading) || Sensor <- [1, 2, 3], Sensor =/= Faulty],
    Median = cb:call(voter, voter_median, tuple_to_list(Reading)),
    min(First, Second) =< Median andalso Median =< max(First, Second).

#!/usr/bin/env escript
%% How far does one faulty sensor move the median of three, and how far their mean? C code and
%% faults driven from Erlang, without a model or a property.
main([]) ->
    {ok, Lib} = cb:start(voter, [{c_src, "c_src/voter.c"}, {libs, ["faultcheck"]}]),
    io:format("~-48s ~8s ~8s~n", ["fault of the first sensor; largest error of", "median", "mean"]),
    lists:foreach(fun(Fault) -> print(Lib, Fault) end, faults()),
    ok = cb:stop(Lib).

faults() ->
    [{offset, 5.0},
     {amplification, -1.0},
     {{drift, 0.5, none}, [{from, 10}, {for, 20}]},
     {noise_gauss, 3.0},
     {delay, {calls, 5}},
     {dropout, 0.3, zero},
     {set_to, nan}].

print(Lib, Fault) ->
    Words = lists:flatten(faultcheck_fault:describe(Fault)),
    Errors = [largest_error(Lib, Function, Fault) || Function <- [voter_median, voter_mean]],
    io:format("~-48ts ~8ts ~8ts~n", [Words | Errors]).

%% The true value climbs from 1 to 60; the other two sensors are 0.5 too low and 1.5 too high.
largest_error(Lib, Function, Fault) ->
    ok = cb:restart(Lib),
    {ok, _} = faultcheck_inject:arm(Lib, null, {probe, <<"S1val">>}, Fault),
    text(lists:max([distance(X, cb:call(Lib, Function, [X, X - 0.5, X + 1.5]))
                    || N <- lists:seq(1, 60), X <- [float(N)]])).

%% Numbers that Erlang does not have come as atoms, and every atom is larger than a number.
distance(_True, nan) -> nan;
distance(True, Value) -> abs(Value - True).

text(nan) -> "NaN";
text(Error) -> io_lib:format("~.2f", [Error]).

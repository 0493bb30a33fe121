%% @doc The original's parameters, as properties that fail: `make demo' shows the first.
%%
%%     rebar3 proper -d demo -m prop_copter_demo
%%
%% The properties that every build must pass are in test/prop_copter.erl.
-module(prop_copter_demo).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([
    prop_copters_survive_faults/0, prop_copters_survive_faults/1,
    prop_copters_survive_a_crowd/0, prop_copters_survive_a_crowd/1
]).

%% One test in some ten collides, most from one reflected range signal.
-spec prop_copters_survive_faults() -> proper:outer_test().
prop_copters_survive_faults() ->
    copter_eqc:safe(copter_options:new(#{world => reference, max_copters => 4})).

-spec prop_copters_survive_faults(doc | opts) -> term().
prop_copters_survive_faults(doc) ->
    "Up to four copters must not collide, whatever up to three faults of sensors and radio do";
prop_copters_survive_faults(opts) ->
    [{numtests, 1000}, {start_size, 20}, {transport, nif}].

%% Without faults: one test in some 150. What it shrinks to stays long, for the outcome is chaotic.
-spec prop_copters_survive_a_crowd() -> proper:outer_test().
prop_copters_survive_a_crowd() ->
    copter_eqc:safe(copter_options:new(#{min_copters => 10, max_faults => 0})).

-spec prop_copters_survive_a_crowd(doc | opts) -> term().
prop_copters_survive_a_crowd(doc) ->
    "Ten copters in a box of 20 m must not collide, however they are steered";
prop_copters_survive_a_crowd(opts) ->
    [{numtests, 3000}, {start_size, 30}, {transport, nif}].

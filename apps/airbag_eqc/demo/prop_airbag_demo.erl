%% @doc The airbag's safety without protection, as a property that fails: what `make demo` shows.
%%
%%     rebar3 proper -d demo -m prop_airbag_demo
%%
%% The properties that every build must pass are in test/prop_airbag.erl.
-module(prop_airbag_demo).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([prop_never_fires_without_cause/0, prop_never_fires_without_cause/1]).

-spec prop_never_fires_without_cause() -> proper:outer_test().
prop_never_fires_without_cause() ->
    airbag_eqc:safe(airbag_options:new(#{protection => plain, generator => focused})).

-spec prop_never_fires_without_cause(doc | opts) -> term().
prop_never_fires_without_cause(doc) ->
    "The unprotected airbag must not fire unless it is told to, whatever happens to its packets";
prop_never_fires_without_cause(opts) ->
    [{numtests, 1000}, {start_size, 20}, {transport, nif}].

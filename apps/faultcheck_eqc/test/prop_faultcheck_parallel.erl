%% @doc libfaultcheck on several threads: section 7.4.
-module(prop_faultcheck_parallel).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([
    prop_probes_at_once/0, prop_probes_at_once/1,
    prop_channels_at_once/0, prop_channels_at_once/1,
    prop_three_threads/0, prop_three_threads/1
]).

prop_probes_at_once() -> faultcheck_threads:agrees(probes).

prop_probes_at_once(doc) -> "Probes, arming and triggers on two threads have an order: 7.4";
prop_probes_at_once(opts) -> [{numtests, 100}, {transport, nif}].

prop_channels_at_once() -> faultcheck_threads:agrees(channels).

prop_channels_at_once(doc) -> "Puts, gets and arming on two threads have an order: 7.4";
prop_channels_at_once(opts) -> [{numtests, 100}, {transport, nif}].

prop_three_threads() -> faultcheck_threads:agrees(probes, 3).

prop_three_threads(doc) -> "Probes on three threads: 7.4";
prop_three_threads(opts) -> [{numtests, 30}, {transport, nif}].

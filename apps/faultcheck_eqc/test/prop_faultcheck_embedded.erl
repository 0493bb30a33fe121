%% @doc The embedded profile does what its description says, with the results of libfaultcheck.
-module(prop_faultcheck_embedded).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([prop_embedded/0, prop_embedded/1]).

prop_embedded() -> faultcheck_embedded:agrees().

prop_embedded(doc) -> "fi.h: commands, windows, counters; values as in libfaultcheck: 1, 5.20";
prop_embedded(opts) -> [{numtests, 300}, {transport, nif}].

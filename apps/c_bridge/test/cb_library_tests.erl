-module(cb_library_tests).
-include_lib("eunit/include/eunit.hrl").

a_library_is_found_in_the_clone_test() ->
    ?assert(filelib:is_regular(cb_library:find("libfaultcheck.so", ?MODULE))).

a_directory_that_is_named_is_the_only_one_searched_test() ->
    Before = os:getenv("FAULTCHECK_LIB_DIR"),
    true = os:putenv("FAULTCHECK_LIB_DIR", "/nowhere"),
    Line = <<"not in /nowhere; run `make native` or set FAULTCHECK_LIB_DIR to its directory">>,
    try
        ?assertError({cb, {load, "libfaultcheck.so", {dlerror, Line}}},
                     cb_library:find("libfaultcheck.so", ?MODULE))
    after
        restore(Before)
    end.

restore(false) -> os:unsetenv("FAULTCHECK_LIB_DIR");
restore(Value) -> os:putenv("FAULTCHECK_LIB_DIR", Value).

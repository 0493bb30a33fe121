-module(faultcheck_suggest_tests).
-include_lib("eunit/include/eunit.hrl").

nearest_first_test() ->
    Known = ["prop_good", "prop_goods", "prop_bad", "other"],
    ?assertEqual(["prop_good", "prop_goods"], faultcheck_suggest:similar("prop_goot", Known)),
    ?assertEqual([], faultcheck_suggest:similar("xyz", Known)).

a_beginning_is_near_test() ->
    ?assertEqual(["regressions"], faultcheck_suggest:similar("reg", ["regressions", "retry"])).

phrase_test() ->
    ?assertEqual("; did you mean ab or ac?", faultcheck_suggest:phrase("aa", ["ab", "ac"])),
    ?assertEqual("", faultcheck_suggest:phrase("aa", [])).

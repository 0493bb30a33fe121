-module(faultcheck_junit_tests).
-include_lib("eunit/include/eunit.hrl").

a_suite_per_module_test() ->
    Xml = parse([passed(m1, prop_a), failed(m2, prop_b, "bad"), passed(m1, prop_c)]),
    ?assertEqual(["m1", "m2"], values("//testsuite/@name", Xml)),
    ?assertEqual(["2", "1"], values("//testsuite/@tests", Xml)),
    ?assertEqual(["0", "1"], values("//testsuite/@failures", Xml)),
    ?assertEqual(["prop_a", "prop_c", "prop_b"], values("//testcase/@name", Xml)).

any_text_is_well_formed_test() ->
    Nasty = "<&\">\n\e[0m" ++ [0, 8364, 16#FFFE],
    Xml = parse([failed(m, prop_a, Nasty)]),
    [Message] = values("//failure/@message", Xml),
    ?assertEqual("<&\">\n?[0m?" ++ [8364, $?], Message).

errors_are_not_failures_test() ->
    Xml = parse([(failed(m, prop_a, "none"))#{status := unstarted}]),
    ?assertEqual(["1"], values("/testsuites/@errors", Xml)),
    ?assertEqual(["unstarted"], values("//error/@type", Xml)).

parse(Outcomes) ->
    Text = faultcheck_junit:format(Outcomes),
    {Xml, []} = xmerl_scan:string(binary_to_list(Text), [{encoding, 'utf-8'}]),
    Xml.

values(Path, Xml) -> [element(9, Attribute) || Attribute <- xmerl_xpath:string(Path, Xml)].

passed(Module, Property) ->
    #{property => {Module, Property}, status => passed, tests => 100, ms => 1500}.

failed(Module, Property, Reason) ->
    (passed(Module, Property))#{status := failed, reasons => [Reason]}.

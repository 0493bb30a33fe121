-module(copter_campaign_tests).
-include_lib("eunit/include/eunit.hrl").

the_short_campaign_writes_its_report_test_() ->
    {timeout, 120, fun() ->
        Dir = cb_files:fresh_name("copter_campaign", ""),
        try
            ok = copter_campaign:run(Dir, copter_campaign:short()),
            {ok, Text} = file:read_file(filename:join(Dir, "copter_campaign.md")),
            [
                ?assertNotEqual(nomatch, string:find(Text, Heading))
             || Heading <- ["## Hardened, without faults", "## Each realistic fault alone",
                            "## Survival by copters", "## Stored counterexamples"]
            ],
            {ok, Bytes} = file:read_file(filename:join(Dir, "copter_campaign.json")),
            {ok, #{<<"free">> := Free, <<"faults">> := Faults}} = faultcheck_json:decode(Bytes),
            %% Four copters, hardened, nothing wrong with them.
            ?assertMatch(#{<<"tests">> := 40, <<"collisions">> := 0}, Free),
            ?assertEqual(2 * length(copter_fault:kinds()), length(Faults)),
            ?assert(filelib:is_regular(filename:join(Dir, "copter_campaign/faults.svg"))),
            ?assertNot(filelib:is_dir(filename:join(Dir, "copter_campaign/state")))
        after
            file:del_dir_r(Dir)
        end
    end}.

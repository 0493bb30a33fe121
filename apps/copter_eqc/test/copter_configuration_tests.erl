-module(copter_configuration_tests).
-include_lib("eunit/include/eunit.hrl").

%% The simulator has a set of the same name, for scenarios and for C.
the_simulator_knows_the_hardened_configuration_test() ->
    {ok, _} = application:ensure_all_started(c_bridge),
    Names = [
        Name
     || C <- copter_configuration:names(), Name <- maps:keys(copter_configuration:values(C))
    ],
    Values = fun() -> [{Name, copter_sut:value_of(Name)} || Name <- lists:usort(Names)] end,
    ok = copter_sut:begin_test(copter_options:new(#{configuration => hardened})),
    Ours = Values(),
    ok = copter_sut:begin_test(copter_options:new(#{})),
    Original = Values(),
    ok = copter_sut:configure(hardened),
    Theirs = Values(),
    ok = copter_sut:stop(),
    ?assertEqual(Theirs, Ours),
    ?assertNotEqual(Original, Ours).

every_configuration_has_a_title_test() ->
    Titles = [copter_configuration:title(C) || C <- copter_configuration:names()],
    ?assertEqual(length(Titles), length(lists:usort(Titles))).

-module(faultcheck_versions_tests).
-include_lib("eunit/include/eunit.hrl").

all_are_there_test() ->
    #{otp := Otp, faultcheck := Vsn} = faultcheck_versions:all(),
    ?assertEqual(erlang:system_info(otp_release), Otp),
    {ok, Text} = application:get_key(faultcheck, vsn),
    ?assertEqual(Text, Vsn),
    ?assertMatch([1, _ | _], faultcheck_versions:proper()).

only_what_a_seed_depends_on_differs_test() ->
    Then = #{faultcheck => "0.1", proper => "1.2", otp => "25", git => "a"},
    ?assertEqual([], faultcheck_versions:differences(Then, Then#{git := "b"})),
    ?assertEqual(
        ["PropEr 1.2 then, 1.5 now"], faultcheck_versions:differences(Then, Then#{proper := "1.5"})
    ),
    ?assertEqual("7@0.1,1.2,25", faultcheck_versions:seed(7, Then)),
    ?assertEqual(
        "FaultCheck 0.1, PropEr 1.2, OTP 25, git a", faultcheck_versions:text(Then)
    ).

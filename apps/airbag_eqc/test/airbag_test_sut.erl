%% @doc For tests: the airbag in an OS process of its own, where its printing disturbs nobody.
-module(airbag_test_sut).

-export([port/0]).

-spec port() -> ok.
port() ->
    {ok, _} = application:ensure_all_started(c_bridge),
    airbag_sut:default_transport(port).

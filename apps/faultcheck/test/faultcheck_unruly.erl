%% Properties over faultcheck_unruly.c, for the tests of the runner: one for each way to misbehave.
-module(faultcheck_unruly).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([prop_hang/1, prop_good/1]).

prop_good() -> property(good).
prop_good(doc) -> "the level is the sum of the steps".

prop_wrong() -> property(wrong).
prop_crash() -> property(crash).
prop_hang() -> property(hang).
prop_hang(opts) -> [{timeout, 400}].

prop_leave() -> property(leave).
prop_print() -> property(print).
prop_flaky() -> property(flaky).
prop_guest() -> property(guest).
prop_slow() -> property(slow).

%% Without C code.
prop_value() -> ?FORALL(L, list(integer()), length(L) < 5).
prop_raise() -> ?FORALL(L, list(integer()), length(L) < 5 orelse error({long, length(L)})).
prop_halt() -> ?FORALL(L, list(integer()), length(L) < 5 orelse erlang:halt(5)).
prop_stuck() -> ?FORALL(L, list(integer()), length(L) < 5 orelse receive never -> true end).
prop_fails() -> fails(?FORALL(L, list(integer()), length(L) < 5)).
prop_fails_not() -> fails(?FORALL(_, integer(), true)).
prop_chance() -> ?FORALL(L, list(integer()), length(L) < 5 orelse os:system_time() rem 4 =/= 0).
prop_talk() ->
    ?FORALL(L, list(integer()), ?WHENFAIL(io:format("told of ~w~n", [L]), length(L) < 5)).
%% Prints the run of its commands itself.
prop_shows() ->
    put(?MODULE, wrong),
    ?SETUP(
        fun unruly/0,
        ?FORALL(Commands, commands(?MODULE), begin
            {_, _, Result} = Run = restarted(Commands),
            Told = ["told:\n", faultcheck_statem:pretty(?MODULE, Commands, Run)],
            ?WHENFAIL(io:put_chars(Told), Result =:= ok)
        end)
    ).
prop_missing() ->
    ?SETUP(
        fun() ->
            {ok, _} = cb:start(unruly, [{so, "no_such_library.so"}]),
            fun() -> ok end
        end,
        ?FORALL(_, integer(), true)
    ).

%% Everything that a test may leave behind: samples, rejected cases, prints.
prop_chatty() ->
    ?FORALL(
        L,
        list(integer()),
        ?IMPLIES(
            length(L) =/= 2,
            begin
                length(L) =:= 7 andalso io:format("seven: ~w~n", [L]),
                collect(length(L) div 5, measure("sum", lists:sum(L), length(L) < limit()))
            end
        )
    ).

limit() -> list_to_integer(os:getenv("FAULTCHECK_TEST_LIMIT", "1000")).

%% A search by chance, as this model has no objective, that crashes its VM.
prop_search_crash() ->
    put(?MODULE, crash),
    Options = #{strategy => random, begin_test => fun() -> ok = cb:restart(unruly) end},
    ?SETUP(fun unruly/0, faultcheck_search:property(?MODULE, Options)).

%% One search a test.
prop_search() ->
    Options = #{max_runs => 30, begin_test => fun() -> cart_model:reset(1.0 * limit()) end},
    faultcheck_search:property(cart_model, Options).

%% Does something to its VM or its verdict in the first tests that have a list of seven; how many
%% are left to do is in a file.
prop_struck() ->
    File = os:getenv("FAULTCHECK_TEST_STRIKES"),
    ?FORALL(L, list(integer()), length(L) =/= 7 orelse strike(File)).

strike(File) ->
    {ok, Left} = file:read_file(File),
    case binary_to_list(Left) of
        [] ->
            true;
        [How | Rest] ->
            ok = file:write_file(File, Rest),
            struck(How)
    end.

struck($k) ->
    ok = cb_nif:kill(list_to_integer(os:getpid()), 9),
    receive never -> true end;
struck($f) ->
    false.

%% Which VM ran it.
prop_where() ->
    File = os:getenv("FAULTCHECK_TEST_DRAW"),
    ?FORALL(
        _,
        integer(),
        begin
            ok = file:write_file(File, os:getpid() ++ "\n", [append]),
            true
        end
    ).

%% Only newer versions of PropEr search.
-ifdef(FORALL_TARGETED).
prop_targeted() ->
    ?FORALL_TARGETED(X, integer(0, 1000), begin ?MAXIMIZE(X), X < 900 end).
prop_exists() -> ?EXISTS(X, integer(0, 1000), X > 1000).
-endif.

%% What was drawn, to a file.
prop_draw() ->
    File = os:getenv("FAULTCHECK_TEST_DRAW"),
    ?FORALL(
        L,
        list(integer()),
        begin
            ok = file:write_file(File, io_lib:format("~w~n", [L]), [append]),
            true
        end
    ).

property(How) ->
    put(?MODULE, How),
    ?SETUP(
        fun unruly/0,
        ?FORALL(Commands, commands(?MODULE), begin
            {_, _, Result} = restarted(Commands),
            Result =:= ok
        end)
    ).

unruly() ->
    Source = filename:join(os:getenv("FAULTCHECK_TEST_DIR"), "faultcheck_unruly.c"),
    {ok, Lib} = cb:start(unruly, [
        {c_src, Source}, {transport, nif}, {reset, snapshot}, {timeout, 150}
    ]),
    fun() -> cb:stop(Lib) end.

restarted(Commands) ->
    ok = cb:restart(unruly),
    run_commands(?MODULE, Commands).

initial_state() -> 0.

step_args(_Level) -> [get(?MODULE), integer(0, 9)].
step(How, By) -> cb:call(unruly, How, [By]).
step_next(Level, _Result, [_How, By]) -> Level + By.
step_post(Level, [_How, By], Result) -> Result =:= Level + By.

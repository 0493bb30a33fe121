-module(cb_program_tests).

-include_lib("eunit/include/eunit.hrl").

refuse(_, _) -> {error, unexpected}.

ask(Program, Request) -> ask(Program, Request, 10000).

ask(Program, Request, Timeout) -> cb_program:request(Program, Request, Timeout, fun refuse/2).

with_program(Source, Test) ->
    {ok, Options} = cb_options:parse([
        {c_src, cb_sut:source(Source)}, {cache_dir, cb_sut:cache()}
    ]),
    {ok, #{file := File}} = cb_compile:library(program, Options),
    {ok, Started} = cb_program:start("/dev/null", []),
    {{ok, #{reset := _}}, Loaded} = ask(Started, {load, File, #{}}),
    try
        Test(Loaded)
    after
        cb_program:stop(Loaded, 1000)
    end.

an_answer_that_comes_too_late_is_dropped_test() ->
    with_program("faulty.c", fun(P0) ->
        %% Long enough not to be done when the caller has given up.
        {timeout, P1} = ask(P0, {call, wait_ms, [100]}, 1),
        ?assertMatch({{ok, 1}, _}, ask(P1, {call, step, []}))
    end).

%% A request that crosses the end of its child must not change the parent.
the_parent_of_a_child_that_ended_stays_as_loaded_test() ->
    with_program("faulty.c", fun(P0) ->
        {{ok, Child}, P1} = ask(P0, fork),
        {{ok, 1}, P2} = ask(P1, {call, step, []}),
        ok = cb_program:signal(Child, kill),
        ?assertEqual({child_ended, {signal, 9}}, cb_program:await_child_end(P2, 5000)),
        {Refused, P3} = ask(P2, {call, step, []}),
        ?assertEqual({error, no_child}, Refused),
        {{ok, _}, P4} = ask(P3, fork),
        ?assertMatch({{ok, 1}, _}, ask(P4, {call, step, []}))
    end).

the_end_between_two_requests_is_seen_by_the_next_test() ->
    with_program("faulty.c", fun(P0) ->
        ok = cb_program:kill(P0),
        ?assertEqual({signal, 9}, cb_program:await_end(P0, 5000)),
        ?assertMatch({{ended, _}, _}, ask(P0, {call, step, []}))
    end).

a_log_that_cannot_be_written_is_an_error_of_start_test() ->
    ?assertMatch({error, {load, _, {protocol, _}}}, cb_program:start("/no/such/dir/log", [])).

-module(cb_program_tests).

-include_lib("eunit/include/eunit.hrl").

refuse(_, _) -> {error, unexpected}.

ask(Program, Request) -> cb_program:request(Program, Request, 10000).

with_program(Source, Test) ->
    {ok, Options} = cb_options:parse([
        {c_src, cb_sut:source(Source)}, {cache_dir, cb_sut:cache()}
    ]),
    {ok, #{file := File}} = cb_compile:library(program, Options),
    {ok, Started} = cb_program:start("/dev/null", [], fun refuse/2),
    {ok, #{reset := _}} = ask(Started, {load, File, #{}}),
    try
        Test(Started)
    after
        cb_program:stop(Started, 1000)
    end.

an_answer_that_comes_too_late_is_dropped_test() ->
    with_program("faulty.c", fun(P) ->
        %% Long enough not to be done when the caller has given up.
        ?assertEqual(timeout, cb_program:request(P, {call, wait_ms, [100]}, 1)),
        ?assertEqual({ok, 1}, ask(P, {call, step, []}))
    end).

%% A request that crosses the end of its child must not change the parent.
the_parent_of_a_child_that_ended_stays_as_loaded_test() ->
    with_program("faulty.c", fun(P) ->
        {ok, Child} = ask(P, fork),
        ?assertEqual({ok, 1}, ask(P, {call, step, []})),
        ok = cb_program:signal(Child, kill),
        ?assertEqual({child_ended, {signal, 9}}, cb_program:await_child_end(P, 5000)),
        ?assertEqual({error, no_child}, ask(P, {call, step, []})),
        {ok, _} = ask(P, fork),
        ?assertEqual({ok, 1}, ask(P, {call, step, []}))
    end).

the_end_between_two_requests_is_seen_by_the_next_test() ->
    with_program("faulty.c", fun(P) ->
        ok = cb_program:kill(P),
        ?assertEqual({signal, 9}, cb_program:await_end(P, 5000)),
        ?assertMatch({ended, _}, ask(P, {call, step, []}))
    end).

a_log_that_cannot_be_written_is_an_error_of_start_test() ->
    Started = cb_program:start("/no/such/dir/log", [], fun refuse/2),
    ?assertMatch({error, {load, _, {protocol, _}}}, Started).

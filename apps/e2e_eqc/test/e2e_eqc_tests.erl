-module(e2e_eqc_tests).
-include_lib("eunit/include/eunit.hrl").

-define(SEED, 2019).
-define(TESTS, 300).

%% The same tests each time: what they reach is a fact, not a chance.
reached_test_() ->
    {setup,
        fun() -> {ok, _} = application:ensure_all_started(c_bridge), ok end,
        fun(_) -> e2e_sut:stop() end,
        fun(_) ->
            [
                {"every status of " ++ atom_to_list(P), {timeout, 60, fun() -> reaches(P) end}}
             || P <- e2e_packet:profiles()
            ]
        end}.

reaches(P) ->
    Tags = tags(P),
    Has = fun(Wanted) -> ?assertEqual([], Wanted -- Tags) end,
    Has([{P, status, S} || S <- statuses(P)]),
    Has([{P, fault, F} || F <- faults()]),
    Has([{P, recovered}, {P, refused, input_null}, {P, refused, input_wrong},
        {P, refused, wrong_state}]),
    Has([{machine, From, To} || {From, To} <- transitions()]).

tags(P) ->
    ok = faultcheck_stats:start(),
    Seeded = proper:setup(
        fun() -> _ = rand:seed(exsss, ?SEED), fun() -> ok end end, e2e_eqc:agrees(P)),
    ?assertEqual(true, proper:quickcheck(Seeded, [quiet, {numtests, ?TESTS}])),
    #{requirements := Tags} = faultcheck_stats:stop(),
    maps:keys(Tags).

statuses(P) when P =:= p01; P =:= p02 ->
    ['OK', 'NONEWDATA', 'WRONGCRC', 'SYNC', 'INITIAL', 'REPEATED', 'OKSOMELOST', 'WRONGSEQUENCE'];
statuses(_) ->
    ['OK', 'NONEWDATA', 'ERROR', 'REPEATED', 'OKSOMELOST', 'WRONGSEQUENCE'].

faults() -> [lose, repeat, resequence, insert, corrupt, forge, truncate, extend, delay].

transitions() ->
    [{'NODATA', 'NODATA'}, {'NODATA', 'INIT'}, {'INIT', 'INIT'}, {'INIT', 'VALID'},
        {'INIT', 'INVALID'}, {'VALID', 'VALID'}, {'VALID', 'INVALID'}, {'INVALID', 'INVALID'},
        {'INVALID', 'VALID'}].

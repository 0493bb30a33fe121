-module(cb_module_tests).

-include_lib("eunit/include/eunit.hrl").

signatures(Count) ->
    Names = [list_to_atom("f" ++ integer_to_list(I)) || I <- lists:seq(1, Count)],
    [{Name, [{a, int}, {b, int}], int} || Name <- Names].

with_module(Test) ->
    Name = cb_module_tests_generated,
    try
        Test(Name)
    after
        code:purge(Name),
        code:delete(Name)
    end.

each_c_function_is_a_function_test() ->
    with_module(fun(Name) ->
        ok = cb_module:load(Name, signatures(3)),
        ?assert(erlang:function_exported(Name, f3, 2)),
        %% It acts on the library of that name, which this process has not started.
        ?assertError({cb, {not_started, Name}}, Name:f1(1, 2)),
        ?assertError({cb, {not_started, Name}}, Name:anything(1))
    end).

many_functions_go_through_one_test() ->
    with_module(fun(Name) ->
        ok = cb_module:load(Name, signatures(501)),
        ?assertNot(erlang:function_exported(Name, f1, 2)),
        ?assertError({cb, {not_started, Name}}, Name:f501(1, 2))
    end).

other_functions_replace_the_module_test() ->
    with_module(fun(Name) ->
        ok = cb_module:load(Name, signatures(1)),
        ok = cb_module:load(Name, signatures(2)),
        ?assert(erlang:function_exported(Name, f2, 2))
    end).

a_module_that_exists_is_left_alone_test() ->
    ?assertMatch({error, {module_clash, lists, _}}, cb_module:load(lists, [])),
    ?assertMatch({error, {module_clash, erlang, _}}, cb_module:load(erlang, [])),
    %% Not loaded, but in the code path.
    ?assertMatch({error, {module_clash, _, _}}, cb_module:load(erl_tar, [])).

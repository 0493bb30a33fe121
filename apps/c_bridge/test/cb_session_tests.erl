%% Starting: libraries built elsewhere, headers for those without debug information, several at
%% once, and what goes wrong.
-module(cb_session_tests).

-include_lib("eunit/include/eunit.hrl").

-define(TRANSPORTS, [nif, port]).

with_plain_library(Flags, Test) ->
    Dir = cb_files:fresh_name("cb_session_tests", ""),
    ok = filelib:ensure_dir(filename:join(Dir, "x")),
    So = filename:join(Dir, "libplain.so"),
    Args = Flags ++ ["-shared", "-fPIC", "-o", So, cb_sut:source("plain.c")],
    {ok, 0, _} = cb_compiler:run("gcc", Args),
    try
        Test(So)
    after
        ok = file:del_dir_r(Dir)
    end.

%% In a process of their own: what another test has loaded is not seen.
in_both(Test) -> {spawn, [{atom_to_list(T), fun() -> Test(T) end} || T <- ?TRANSPORTS]}.

a_library_built_elsewhere_test_() ->
    in_both(fun(Transport) ->
        with_plain_library(["-g"], fun(So) ->
            {ok, Lib} = cb:start(sut_plain, [{so, So}, {transport, Transport}]),
            ?assertEqual(3, cb:call(Lib, plain_add, [1, 2])),
            ?assertEqual(3, sut_plain:plain_add(1, 2)),
            ok = cb:stop(Lib)
        end)
    end).

a_missing_library_test_() ->
    in_both(fun(Transport) ->
        ?assertMatch(
            {error, {load, _, {dlerror, _}}},
            cb:start(missing, [{so, "/no/such/lib.so"}, {transport, Transport}])
        )
    end).

a_file_that_is_no_library_test_() ->
    in_both(fun(Transport) ->
        ?assertMatch(
            {error, {load, _, _}},
            cb:start(no_library, [{so, cb_sut:source("plain.h")}, {transport, Transport}])
        )
    end).

a_library_with_undefined_symbols_test_() ->
    in_both(fun(Transport) ->
        Dir = cb_files:fresh_name("cb_session_tests", ""),
        ok = filelib:ensure_dir(filename:join(Dir, "x")),
        So = filename:join(Dir, "libdevice.so"),
        Args = ["-g", "-shared", "-fPIC", "-o", So, cb_sut:source("device.c")],
        {ok, 0, _} = cb_compiler:run("gcc", Args),
        {error, {load, _, {dlerror, Text}} = Reason} =
            cb:start(sut_undefined, [{so, So}, {transport, Transport}]),
        ok = file:del_dir_r(Dir),
        ?assertNotEqual(nomatch, string:find(Text, "undefined symbol")),
        %% The file is named once.
        Line = unicode:characters_to_list(cb_error:format(Reason)),
        ?assertEqual(2, length(string:split(Line, "libdevice.so", all)))
    end).

no_debug_information_test_() ->
    in_both(fun(Transport) ->
        with_plain_library(["-s"], fun(So) ->
            {error, Reason} = cb:start(sut_bare, [{so, So}, {transport, Transport}]),
            ?assertMatch({load, _, no_debug_info}, Reason)
        end)
    end).

headers_replace_debug_information_test_() ->
    in_both(fun(Transport) ->
        with_plain_library(["-s"], fun(So) ->
            {ok, Lib} = cb:start(sut_headers, [
                {so, So},
                {headers, [cb_sut:source("plain.h")]},
                {transport, Transport},
                {cache_dir, filename:dirname(So)}
            ]),
            ?assertEqual(3, cb:call(Lib, plain_add, [1, 2])),
            ?assertEqual(#{first => 1, second => 2.5}, cb:call(Lib, plain_make, [1, 2.5])),
            ?assertEqual(2.5, cb:call(Lib, plain_second, [#{second => 2.5}])),
            ?assertEqual(3, cb:value_of(Lib, plain_counter)),
            ok = cb:set(Lib, plain_counter, 4),
            ?assertEqual(4, cb:value_of(Lib, plain_counter)),
            ?assertMatch(
                {unknown_function, not_in_header, _},
                cb_sut:reason(fun() -> cb:call(Lib, not_in_header, []) end)
            ),
            ok = cb:stop(Lib)
        end)
    end).

a_library_may_be_started_twice_test_() ->
    in_both(fun(Transport) ->
        One = cb_sut:start(sut_one, "plain_state.c", [{transport, Transport}]),
        Two = cb_sut:start(sut_two, "plain_state.c", [{transport, Transport}]),
        ok = cb:set(One, value, 11),
        ok = cb:set(Two, value, 22),
        ?assertEqual({11, 22}, {cb:value_of(sut_one, value), cb:value_of(sut_two, value)}),
        Pointer = cb:create_array(One, int, [1]),
        ?assertMatch(
            {which_library, [sut_one, sut_two]}, cb_sut:reason(fun() -> cb:read(Pointer, 1) end)
        ),
        ok = cb:stop(One),
        ok = cb:stop(Two)
    end).

the_same_file_twice_has_two_states_test_() ->
    in_both(fun(Transport) ->
        with_plain_library(["-g"], fun(So) ->
            {ok, One} = cb:start(sut_first, [{so, So}, {transport, Transport}]),
            {ok, Two} = cb:start(sut_second, [{so, So}, {transport, Transport}]),
            ok = cb:set(One, plain_counter, 11),
            ?assertEqual(3, cb:value_of(Two, plain_counter)),
            ok = cb:stop(One),
            ok = cb:stop(Two)
        end)
    end).

%% Threads of the VM have names: 1_dirty_cpu_... up to OTP 25, erts_dcpus_1 after that.
slow_functions_run_on_dirty_schedulers_test_() ->
    [
        {lists:flatten(io_lib:format("~p", [Dirty])), fun() ->
            Lib = cb_sut:start("faulty.c", [{transport, nif}, {reset, none}, {dirty, Dirty}]),
            ?assertEqual(1, cb:call(Lib, step, [])),
            Thread = cb:cstring(Lib, cb:call(Lib, thread_name, [])),
            IsDirty = binary:match(Thread, [<<"dirty_cpu">>, <<"dcpu">>]) =/= nomatch,
            ?assertEqual({Expected, Thread}, {IsDirty, Thread}),
            ok = cb:stop(Lib)
        end}
     || {Dirty, Expected} <- [{false, false}, {[step], false}, {true, true}, {[thread_name], true}]
    ].

starting_again_stops_the_earlier_one_test() ->
    One = cb_sut:start("plain_state.c", []),
    ok = cb:set(One, value, 11),
    Two = cb_sut:start("plain_state.c", []),
    ?assertEqual(1, cb:value_of(sut_plain_state, value)),
    ?assertEqual({not_running, stopped}, cb_sut:reason(fun() -> cb:value_of(One, value) end)),
    ok = cb:stop(Two).

a_name_of_a_module_is_refused_test() ->
    Options = [{c_src, cb_sut:source("plain_state.c")}, {cache_dir, cb_sut:cache()}],
    ?assertMatch({error, {module_clash, lists, _}}, cb:start(lists, Options)),
    %% Without the module any name will do.
    {ok, Lib} = cb:start(lists, [{module, false} | Options]),
    ?assertEqual(1, cb:value_of(lists, value)),
    ok = cb:stop(Lib).

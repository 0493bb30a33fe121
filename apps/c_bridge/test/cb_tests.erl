%% What goes in comes out: the same tests through both transports.
-module(cb_tests).

-include_lib("eunit/include/eunit.hrl").

-define(BOTH(Source, Tests), [
    {spawn, {setup, local,
        fun() -> cb_sut:start(Source, [{transport, Transport}, {reset, reload}]) end,
        fun cb:stop/1, fun(Lib) ->
            [
                {atom_to_list(Transport) ++ ": " ++ Name, fun() -> Test(Lib) end}
             || {Name, Test} <- Tests
            ]
        end}}
 || Transport <- [nif, port]
]).

scalars_test_() ->
    ?BOTH("arithmetic.c", [
        {"calls return values", fun calls/1},
        {"limits of each integer type", fun integer_limits/1},
        {"out of range is an error, never a wrap", fun out_of_range/1},
        {"floats, with what Erlang has no float for", fun floats/1},
        {"enumerators are atoms", fun enums/1},
        {"booleans", fun booleans/1},
        {"static functions and variables", fun hidden/1},
        {"a K&R function", fun old_style/1},
        {"constants can be read only", fun constants/1},
        {"handles and strings name functions", fun names/1},
        {"a batch gives all results", fun batch/1},
        {"a batch stops at the first failing call", fun failing_batch/1},
        {"the generated module", fun generated_module/1},
        {"the name given to start", fun by_name/1},
        {"what there is", fun listing/1},
        {"errors of calls", fun call_errors/1},
        {"errors of variables", fun variable_errors/1}
    ]).

calls(L) ->
    ?assertEqual(3, cb:call(L, add, [1, 2])),
    ?assertEqual(-6000000000, cb:call(L, multiply, [-3000000, 2000])),
    ?assertEqual(254, cb:call(L, low_byte, [16#fffe])).

integer_limits(L) ->
    [
        begin
            ok = cb:set(L, Variable, Value),
            ?assertEqual({Variable, Value}, {Variable, cb:value_of(L, Variable)})
        end
     || {Variable, Bits, Signed} <- integers(), Value <- limits(Bits, Signed)
    ].

integers() ->
    [
        {g_schar, 8, true},
        {g_uchar, 8, false},
        {g_char, 8, true},
        {g_short, 16, true},
        {g_ushort, 16, false},
        {g_int, 32, true},
        {g_uint, 32, false},
        {g_long, 64, true},
        {g_ulong, 64, false},
        {g_llong, 64, true},
        {g_ullong, 64, false},
        {g_int8, 8, true},
        {g_uint64, 64, false},
        {g_size, 64, false}
    ].

limits(Bits, true) -> [-(1 bsl (Bits - 1)), -1, 0, (1 bsl (Bits - 1)) - 1];
limits(Bits, false) -> [0, 1, (1 bsl Bits) - 1].

out_of_range(L) ->
    [
        begin
            ok = cb:set(L, Variable, 1),
            ?assertMatch(
                {value, [Variable], {out_of_range, _, Value}},
                cb_sut:reason(fun() -> cb:set(L, Variable, Value) end)
            ),
            ?assertEqual(1, cb:value_of(L, Variable))
        end
     || {Variable, Bits, Signed} <- integers(),
        Limits <- [limits(Bits, Signed)],
        Value <- [hd(Limits) - 1, lists:last(Limits) + 1]
    ],
    ?assertMatch(
        {arg, add, 2, b, {out_of_range, int, 2147483648}},
        cb_sut:reason(fun() -> cb:call(L, add, [1, 2147483648]) end)
    ).

floats(L) ->
    ?assertEqual(1.5, cb:call(L, halve, [3])),
    ?assertEqual(0.5, cb:call(L, third, [1.5])),
    [
        begin
            ok = cb:set(L, Variable, Value),
            ?assertEqual(Value, cb:value_of(L, Variable))
        end
     || Variable <- [g_float, g_double], Value <- [nan, inf, neg_inf, 0.25, -2.0]
    ].

enums(L) ->
    ?assertEqual('MIDDLE', cb:call(L, raise, ['LOW'])),
    ?assertEqual('MIDDLE', cb:call(L, raise, [-1])),
    ok = cb:set(L, g_level, 'HIGH'),
    ?assertEqual('HIGH', cb:value_of(L, g_level)),
    ok = cb:set(L, g_level, 5),
    ?assertEqual(5, cb:value_of(L, g_level)),
    ?assertMatch(
        {arg, raise, 1, l, {bad_enumerator, 'enum level', 'HIGHER'}},
        cb_sut:reason(fun() -> cb:call(L, raise, ['HIGHER']) end)
    ).

booleans(L) ->
    ?assertEqual(false, cb:call(L, invert, [true])),
    ?assertEqual(true, cb:call(L, invert, [0])),
    ok = cb:set(L, g_bool, true),
    ?assertEqual(true, cb:value_of(L, g_bool)).

hidden(L) ->
    ok = cb:set(L, hidden, 21),
    ?assertEqual(42, cb:call(L, twice_hidden, [])),
    ?assertEqual(42, cb:call(L, use_hidden, [])).

old_style(L) -> ?assertEqual(5, cb:call(L, old_style, [8, 3])).

constants(L) ->
    ?assertEqual(11, cb:value_of(L, g_const)),
    ?assertMatch({read_only, _}, cb_sut:reason(fun() -> cb:set(L, g_const, 1) end)).

names(L) ->
    {ok, Add} = cb:resolve(L, add),
    ?assertEqual(3, cb:call(L, Add, [1, 2])),
    ?assertEqual(3, cb:call(L, "add", [1, 2])),
    ?assertEqual(3, cb:call(L, <<"add">>, [1, 2])),
    ?assertEqual([3], cb:call_batch(L, [{Add, [1, 2]}])),
    ?assertMatch({error, {unknown_function, addd, [add | _]}}, cb:resolve(L, addd)).

batch(L) ->
    ?assertEqual([3, 1.0, false], cb:call_batch(L, [{add, [1, 2]}, {halve, [2]}, {invert, [1]}])),
    ?assertEqual([], cb:call_batch(L, [])).

failing_batch(L) ->
    ok = cb:restart(L),
    Calls = [{count_call, []}, {add, [1]}, {count_call, []}],
    ?assertMatch(
        {batch, 2, [1], {arity, add, 2, 1, _}},
        cb_sut:reason(fun() -> cb:call_batch(L, Calls) end)
    ),
    ?assertEqual(1, cb:value_of(L, g_calls)).

generated_module(_) ->
    ?assertEqual(7, sut_arithmetic:add(3, 4)),
    %% A wrong number of arguments is told by the bridge, not by `undef'.
    ?assertMatch({arity, add, 2, 1, _}, cb_sut:reason(fun() -> sut_arithmetic:add(3) end)),
    ?assertMatch({unknown_function, no, _}, cb_sut:reason(fun() -> sut_arithmetic:no() end)).

by_name(_) ->
    ?assertEqual(3, cb:call(sut_arithmetic, add, [1, 2])),
    ok = cb:set(sut_arithmetic, g_int, 9),
    ?assertEqual(9, cb:value_of(sut_arithmetic, g_int)),
    ok = cb:restart(sut_arithmetic),
    ?assertEqual(42, cb:value_of(sut_arithmetic, g_int)),
    ?assertEqual({not_started, nobody}, cb_sut:reason(fun() -> cb:call(nobody, add, []) end)).

listing(L) ->
    ?assert(lists:member({add, [{a, int}, {b, int}], int}, cb:functions(L))),
    ?assert(lists:member({g_level, 'enum level'}, cb:globals(L))),
    #{file := File, libraries := [_ | _]} = cb:info(L),
    ?assertEqual(<<"sut_arithmetic.so">>, filename:basename(File)).

call_errors(L) ->
    Wrong = fun(F, Args) -> cb_sut:reason(fun() -> cb:call(L, F, Args) end) end,
    ?assertMatch({unknown_function, ad, Similar} when is_list(Similar), Wrong(ad, [])),
    ?assertMatch({arity, add, 2, 3, Prototype} when is_binary(Prototype), Wrong(add, [1, 2, 3])),
    ?assertMatch({arg, add, 1, a, {bad_type, int, 1.5}}, Wrong(add, [1.5, 1])),
    ?assertMatch({arg, add, 1, a, {bad_type, int, one}}, Wrong(add, [one, 1])).

variable_errors(L) ->
    Wrong = fun(Path) -> cb_sut:reason(fun() -> cb:value_of(L, Path) end) end,
    ?assertMatch({unknown_variable, g_in, [_ | _]}, Wrong(g_in)),
    ?assertMatch({unknown_member, _, x, _}, Wrong([g_int, x])),
    ?assertMatch({bad_index, _, 0, _}, Wrong([g_int, 0])).

shapes_test_() ->
    ?BOTH("shapes.c", [
        {"structs by value", fun structs/1},
        {"members, bit-fields, unions", fun members/1},
        {"arrays", fun arrays/1},
        {"buffers for one call", fun buffers/1},
        {"memory that lives longer", fun created/1},
        {"pointers", fun pointers/1},
        {"function pointers", fun function_pointers/1},
        {"variadic functions", fun variadic/1},
        {"errors of memory", fun memory_errors/1},
        {"what cannot be passed", fun unsupported/1}
    ]).

structs(L) ->
    ?assertEqual(#{x => 11, y => 12}, cb:call(L, moved, [#{x => 1, y => 2}, 10])),
    %% Missing keys are zero.
    ?assertEqual(#{x => 1, y => 6}, cb:call(L, moved, [#{y => 5}, 1])),
    ?assertEqual(7, cb:call(L, point_sum, [#{x => 3, y => 4}])),
    ?assertMatch(
        {arg, moved, 1, p, {bad_type, _, _}},
        cb_sut:reason(fun() -> cb:call(L, moved, [[1, 2], 1]) end)
    ).

members(L) ->
    ?assertMatch(
        #{corner := #{x := 1, y := 2}, size := [0.5, 1.5], flag := 5, sign := -3},
        cb:value_of(L, g_box)
    ),
    ok = cb:set(L, [g_box, flag], 7),
    ok = cb:set(L, [g_box, sign], -8),
    ok = cb:set(L, [g_box, corner, y], 99),
    ok = cb:set(L, [g_box, size, 1], 2),
    ?assertMatch(
        #{corner := #{x := 1, y := 99}, size := [0.5, 2.0], flag := 7, sign := -8},
        cb:value_of(L, g_box)
    ),
    ?assertMatch(
        {value, _, {out_of_range, _, 8}}, cb_sut:reason(fun() -> cb:set(L, [g_box, flag], 8) end)
    ),
    %% An anonymous union: its members are those of the struct.
    ?assertMatch(#{kind := 1, number := 17}, cb:value_of(L, g_tagged)),
    ok = cb:set(L, [g_tagged, number], 18),
    ?assertEqual(18, cb:value_of(L, [g_tagged, number])),
    ?assertEqual([4, 3, 2, 1], cb:value_of(L, [g_word, bytes])),
    ?assertEqual(16#01020304, cb:call(L, word_of, [#{whole => 16#01020304}])).

arrays(L) ->
    ?assertEqual([[1, 2, 3], [4, 5, 6]], cb:value_of(L, g_matrix)),
    ok = cb:set(L, [g_matrix, 1], [7, 8, 9]),
    ?assertEqual(8, cb:value_of(L, [g_matrix, 1, 1])),
    ok = cb:set(L, g_text, <<"bye">>),
    ?assertEqual("bye", lists:takewhile(fun(C) -> C =/= 0 end, cb:value_of(L, g_text))),
    ?assertMatch(
        {bad_index, _, 2, 2}, cb_sut:reason(fun() -> cb:value_of(L, [g_matrix, 2]) end)
    ).

buffers(L) ->
    ?assertEqual(6, cb:call(L, sum, [[1, 2, 3], 3])),
    ?assertEqual(0, cb:call(L, sum, [null, 0])),
    ?assertMatch(
        {arg, sum, 1, values, {out_of_range, _, 2147483648}},
        cb_sut:reason(fun() -> cb:call(L, sum, [[1, 2147483648], 2]) end)
    ).

created(L) ->
    Numbers = cb:create_array(L, int, [1, 2, 3]),
    ?assertMatch({ptr, int, _}, Numbers),
    ?assertEqual(6, cb:call(L, sum, [Numbers, 3])),
    cb:call(L, keep, [Numbers]),
    ?assertEqual(2, cb:call(L, kept_at, [1])),
    ok = cb:set(L, [Numbers, 1], 20),
    ?assertEqual(20, cb:call(L, kept_at, [1])),
    ?assertEqual([1, 20, 3], cb:read(L, Numbers, 3)),
    ?assertEqual([1, 20], cb:read(Numbers, 2)),
    Bytes = cb:create_array(L, unsigned_char, <<5, 6, 7>>),
    ?assertEqual(<<5, 6, 7>>, cb:read_bytes(L, Bytes, 3)),
    Room = cb:create_array(L, "unsigned char", [0, 0, 0, 0]),
    cb:call(L, fill, [Room, 3, 9]),
    ?assertEqual([9, 9, 9, 0], cb:read(L, Room, 4)),
    ok = cb:free(L, Room),
    Points = cb:create_array(L, 'struct point', [#{x => 1, y => 2}]),
    ?assertEqual(3, cb:call(L, point_sum, [Points])).

pointers(L) ->
    ?assertEqual(null, cb:value_of(L, g_null_point)),
    ?assertEqual(null, cb:call(L, nowhere, [])),
    Point = cb:value_of(L, g_some_point),
    ?assertMatch({ptr, 'struct point', _}, Point),
    ?assertEqual(3, cb:value_of(L, [Point, x])),
    ?assertEqual(4, cb:value_of(L, [g_some_point, y])),
    ?assertEqual(7, cb:call(L, point_sum, [Point])),
    ?assertEqual(7, cb:call(L, point_sum, [cb:address_of(L, g_point)])),
    Name = cb:call(L, name_of, [cb:address_of(L, g_box)]),
    ?assertEqual(<<"crate">>, cb:cstring(L, Name)),
    ?assertEqual(<<"crate">>, cb:cstring(Name)),
    %% A pointer is the same in every run of a test: no address shows.
    {ptr, _, Reference} = Point,
    ?assert(Reference band 16#ffffffff < 1000).

function_pointers(L) ->
    Minus = cb:call(L, minus_op, []),
    ?assertEqual(5, cb:call(L, apply, [Minus, 8, 3])),
    ?assertEqual(5, cb:call(L, apply, [cb:address_of(L, minus), 8, 3])).

variadic(L) ->
    ?assertEqual(6, cb:call(L, total, [3, 1, 2, 3])),
    ?assertEqual(0, cb:call(L, total, [0])),
    ?assertMatch(
        {arity, total, {at_least, 1}, 0, _}, cb_sut:reason(fun() -> cb:call(L, total, []) end)
    ).

memory_errors(L) ->
    Wrong = fun(Fun) -> cb_sut:reason(Fun) end,
    ?assertMatch({null_pointer, _}, Wrong(fun() -> cb:read(L, null, 1) end)),
    ?assertMatch({null_pointer, _}, Wrong(fun() -> cb:cstring(L, null) end)),
    ?assertMatch({null_pointer, _}, Wrong(fun() -> cb:value_of(L, [g_null_point, x]) end)),
    ?assertMatch({bad_pointer, nonsense}, Wrong(fun() -> cb:read(L, nonsense, 1) end)),
    ?assertMatch({unknown_type, _}, Wrong(fun() -> cb:create_array(L, 'struct none', []) end)),
    ?assertMatch(
        {value, int, {bad_type, int, x}}, Wrong(fun() -> cb:create_array(L, int, [x]) end)
    ),
    Old = cb:create_array(L, int, [1]),
    ok = cb:restart(L),
    ?assertEqual({stale_pointer, Old}, Wrong(fun() -> cb:read(L, Old, 1) end)),
    ?assertEqual({stale_pointer, Old}, Wrong(fun() -> cb:call(L, sum, [Old, 1]) end)).

unsupported(L) ->
    ?assertMatch(
        {not_callable, huge, {unsupported_type, _, _}},
        cb_sut:reason(fun() -> cb:call(L, huge, [1]) end)
    ).

cxx_test_() ->
    ?BOTH("thrower.cpp", [
        {"C++ functions and their exceptions", fun cxx/1}
    ]).

cxx(L) ->
    ?assertEqual(7, cb:call(L, bill, [2])),
    ?assertEqual(
        {cxx_exception, <<"std::invalid_argument: negative count">>},
        cb_sut:reason(fun() -> cb:call(L, bill, [-1]) end)
    ),
    ?assertEqual(7, cb:call(L, bill, [2])).

printer_test_() ->
    ?BOTH("printer.c", [
        {"a library that prints", fun printing/1}
    ]).

printing(L) ->
    Before = cb:value_of(L, said),
    [cb:call(L, say, [<<"words">>]) || _ <- lists:seq(1, 10)],
    ?assertEqual(Before + 10, cb:value_of(L, said)).

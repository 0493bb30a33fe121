%% Writes the seeds of README.md, in this folder.
-module(seeds).
-export([main/0]).

main() ->
    write("bridge_port", [term_to_binary({1, Request}) || Request <- requests()]),
    write("bridge_values", [[Type, term_to_binary(Value)] || {Type, Value} <- values()]),
    halt().

write(Folder, Seeds) ->
    [
        ok = file:write_file(filename:join(Folder, integer_to_list(N)), Seed)
     || {N, Seed} <- lists:zip(lists:seq(1, length(Seeds)), Seeds)
    ].

requests() ->
    Pointer = {ptr, int, 1 bsl 32},
    [
        hello, functions, globals, snapshot, restore, flush_coverage, {resolve, next},
        {load, <<"x">>, #{}},
        {call, next, [1]}, {call, <<"sum">>, [1, -2, 3]}, {call, 0, [1]}, {call, scale, [1.5, inf]},
        {call, turned, [#{x => 1, y => 2}]},
        {call, same_flags, [#{on => 1, level => -8, wide => 9}]},
        {call, same_all, [#{i8 => 1, text => <<"ab">>, points => [#{x => 1}], level => 'HIGH'}]},
        {call, takes_pointers, [<<"b">>, #{x => 1}, [<<"t">>, null], next]},
        {call, open_list, [1, 2.5, <<"x">>]},
        {batch, [{next, [1]}, {nxt, []}]}, {begin_test, [{next, [1]}]}, {get, [all, points, 1, x]},
        {set, [all, flags], #{wide => 1 bsl 39}}, {set, [table, 0], 1},
        {get, [pointing, next, to, x]},
        {set, [pointing, text], <<"text">>}, {alloc, 'unsigned char', [1, 2]},
        {alloc, "int *[2]", [[null]]},
        {free, Pointer}, {read, Pointer, 2}, {read_bytes, Pointer, 2}, {cstring, null},
        {address_of, [counter]},
        {get, [{ptr, 'struct point', 1 bsl 32}, 0, x]}, {symbolise, [{<<"/x">>, 1, true}]}
    ].

values() ->
    [
        {0, -128}, {1, 255}, {2, -1}, {3, 65535}, {4, 1 bsl 31}, {5, 7}, {6, -(1 bsl 63)},
        {7, (1 bsl 64) - 1},
        {8, true}, {9, 1.0e38}, {10, nan}, {11, 2}, {12, 'LOW'}, {13, <<"abcd">>},
        {14, [[1, 2], [3]]},
        {15, #{x => 1, y => -1}}, {16, #{on => 1, level => -8, wide => 5}},
        {17, #{i8 => 1, yes => true, level => 5, points => [#{x => 1}], flags => #{wide => 1}}},
        {18, "text"}, {19, [#{x => 1}, #{y => 2}]},
        {20, #{to => #{x => 1}, text => <<"t">>, next => null}},
        {21, #{as_int => 1}}, {22, [[1, 2], null]}
    ].

-module(faultcheck_space_tests).
-include_lib("eunit/include/eunit.hrl").

all(Space) ->
    [faultcheck_space:at(I, Space) || I <- lists:seq(0, faultcheck_space:size(Space) - 1)].

subsets_come_by_size_then_in_list_order_test() ->
    ?assertEqual(
        [[], [a], [b], [c], [a, b], [a, c], [b, c]],
        all(faultcheck_space:subsets([a, b, c], 2))
    ).

subsets_are_complete_and_different_test() ->
    Space = faultcheck_space:subsets(lists:seq(1, 8), 8),
    ?assertEqual(256, faultcheck_space:size(Space)),
    ?assertEqual(256, length(lists:usort(all(Space)))).

a_limit_above_the_number_of_elements_adds_nothing_test() ->
    ?assertEqual([[], [a]], all(faultcheck_space:subsets([a], 5))).

%% 1 + 16 + 120 + 560 + 1820 and 1 + 32 + 496 + 4960 + 35960, by hand.
sizes_of_the_airbags_spaces_test() ->
    Size = fun(N) -> faultcheck_space:size(faultcheck_space:subsets(lists:seq(1, N), 4)) end,
    ?assertEqual(2517, Size(16)),
    ?assertEqual(41449, Size(32)).

words_come_by_length_test() ->
    ?assertEqual(
        ["", "a", "b", "aa", "ab", "ba", "bb"],
        all(faultcheck_space:words("ab", 2))
    ).

a_product_changes_the_second_part_fastest_test() ->
    Product = faultcheck_space:product(
        faultcheck_space:items([1, 2]), faultcheck_space:items([a, b])
    ),
    ?assertEqual([{1, a}, {1, b}, {2, a}, {2, b}], all(Product)).

map_changes_each_item_test() ->
    Space = faultcheck_space:map(fun(X) -> X * X end, faultcheck_space:items([1, 2, 3])),
    ?assertEqual([1, 4, 9], all(Space)).

an_index_outside_is_an_error_test() ->
    ?assertError(function_clause, faultcheck_space:at(2, faultcheck_space:items([a, b]))).

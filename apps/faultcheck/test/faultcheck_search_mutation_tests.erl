-module(faultcheck_search_mutation_tests).

-include_lib("eunit/include/eunit.hrl").

with_random(Fun) ->
    model_lab:isolated(fun() -> faultcheck_proper:with_state(10, {3, 1, 4}, Fun) end).

options() -> faultcheck_search_options:new(#{}).

parent({Commands, Side}) -> #{commands => Commands, side => Side, time => 10.0, key => left}.

%% Five generations of children, one of each.
family(Mod) ->
    Fresh = faultcheck_search_mutation:fresh(Mod, options()),
    lists:foldl(
        fun(_, [Last | _] = All) ->
            [faultcheck_search_mutation:child(Mod, parent(Last), options()) | All]
        end,
        [Fresh],
        lists:seq(1, 300)
    ).

children_are_legal_numbered_and_as_long_as_wanted_test() ->
    lists:foreach(
        fun({Commands, Side}) ->
            ?assertEqual(Commands, faultcheck_repair:repair(cart_model, Commands)),
            Variables = [N || {set, {var, N}, _} <- Commands],
            ?assertEqual(lists:seq(1, length(Commands)), Variables),
            ?assertEqual([], maps:keys(Side) -- Variables),
            Time = lists:sum([N / 10 || {set, _, {call, _, roll, [N]}} <- Commands]),
            ?assert(Time >= 20 - 1.0e-9 andalso Time < 21)
        end,
        with_random(fun() -> family(cart_model) end)
    ).

children_differ_from_their_parents_test() ->
    Family = with_random(fun() -> family(cart_model) end),
    Same = [1 || {A, B} <- lists:zip(lists:droplast(Family), tl(Family)), A =:= B],
    ?assert(length(Same) < 30).

%% Variables are used by later commands of this model: an edit must not leave one without value.
children_of_a_model_with_results_are_legal_test() ->
    Family = with_random(fun() -> family(chain_model) end),
    lists:foreach(
        fun({Commands, _}) ->
            ?assertEqual(Commands, faultcheck_repair:repair(chain_model, Commands))
        end,
        Family
    ).

the_setting_stays_in_front_test() ->
    Family = with_random(fun() -> family(setting_model) end),
    lists:foreach(
        fun({Commands, _}) ->
            Names = [Name || {set, _, {call, _, Name, _}} <- Commands],
            {Front, Body} = lists:splitwith(fun(N) -> N =:= place end, Names),
            ?assertEqual(2, length(Front)),
            ?assertNot(lists:member(place, Body))
        end,
        Family
    ),
    Places = lists:usort([Args || {Commands, _} <- Family,
                                  {set, _, {call, _, place, Args}} <- Commands]),
    ?assert(length(Places) > 4).

%% Follow 1 and a lookback near 0: what runs at the time of the minimum, and in front of it.
edits_are_placed_where_the_run_came_nearest_test() ->
    Options = faultcheck_search_options:new(#{follow => 1, lookback => 1.0e-6, address => 0}),
    Changed = with_random(fun() ->
        {Commands, Side} = faultcheck_search_mutation:fresh(cart_model, Options),
        Parent = (parent({Commands, Side}))#{time => 10.0},
        Children = [
            faultcheck_search_mutation:child(cart_model, Parent, Options)
         || _ <- lists:seq(1, 200)
        ],
        [began(same(Commands, Child, 0), Commands) || {Child, _} <- Children, Child =/= Commands]
    end),
    %% a shift moves a fault from anywhere, and by up to five places
    Near = [T || T <- Changed, T > 6, T =< 10.0],
    ?assert(length(Near) > 0.7 * length(Changed)).

same([C | A], [C | B], N) -> same(A, B, N + 1);
same(_, _, N) -> N.

began(N, Commands) ->
    lists:sum([Steps / 10 || {set, _, {call, _, roll, [Steps]}} <- lists:sublist(Commands, N)]).

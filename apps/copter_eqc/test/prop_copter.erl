%% @doc The properties of the quadcopters (Paper III, section 4.1) and of their simulator.
%%
%% Without faults the hardened configuration holds. The original's parameters do not in a crowded
%% box: that property must fail, and here it passes when a collision is found and shrunk.
%% demo/prop_copter_demo.erl shows the same as an ordinary property that fails.
-module(prop_copter).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([
    prop_hardened_without_faults/0, prop_hardened_without_faults/1,
    prop_original_collides_in_a_crowd/0, prop_original_collides_in_a_crowd/1,
    prop_perceived_is_true_without_faults/0, prop_perceived_is_true_without_faults/1,
    prop_splitting_changes_nothing/0, prop_splitting_changes_nothing/1,
    prop_names_change_nothing/0, prop_names_change_nothing/1,
    prop_moving_the_world_changes_nothing/0, prop_moving_the_world_changes_nothing/1,
    prop_transports_agree/0, prop_transports_agree/1,
    prop_threads_agree/0, prop_threads_agree/1,
    prop_grid_is_brute_force/0, prop_grid_is_brute_force/1,
    prop_scenario_is_the_sequence/0, prop_scenario_is_the_sequence/1,
    prop_search_finds_a_rare_collision/0, prop_search_finds_a_rare_collision/1,
    prop_snapshots_only_save_time/0, prop_snapshots_only_save_time/1,
    prop_snapshot_is_complete/0, prop_snapshot_is_complete/1,
    prop_override_rests_while_nobody_is_near/0, prop_override_rests_while_nobody_is_near/1
]).

%% ---- collisions -------------------------------------------------------------------------------

prop_hardened_without_faults() ->
    copter_eqc:safe(
        copter_options:new(#{
            world => reference, max_copters => 4, max_faults => 0, configuration => hardened
        })
    ).

prop_hardened_without_faults(doc) -> "Hardened, without faults, four copters do not collide";
prop_hardened_without_faults(opts) -> [{numtests, 300}, {transport, nif}].

prop_original_collides_in_a_crowd() ->
    Options = copter_options:new(#{min_copters => 10, max_faults => 0}),
    ?FORALL(Seed, uniform(0, 16#FFFFFFFF), copter_unsafe:fails_as_expected(Options, Seed)).

prop_original_collides_in_a_crowd(doc) ->
    "The original's parameters let copters collide in a crowded box, also without faults";
prop_original_collides_in_a_crowd(opts) ->
    [{numtests, 1}, {transport, nif}].

%% One in 1200 random tests collides here; the search needs some 130 in the median.
prop_search_finds_a_rare_collision() ->
    Options = copter_options:world('W1'),
    ?FORALL(Seed, uniform(0, 16#FFFFFFFF), begin
        {Status, #{commands := Commands}} = search(Options, #{seed => Seed, max_runs => 5000}),
        Status =:= found andalso element(1, copter_trial:run(Options, Commands)) =:= collision
    end).

prop_search_finds_a_rare_collision(doc) -> "A guided search finds a collision without faults";
prop_search_finds_a_rare_collision(opts) -> [{numtests, 2}, {transport, nif}].

%% With prefixes restored from snapshots a search goes the same way for less.
prop_snapshots_only_save_time() ->
    Options = copter_options:new(#{max_copters => 4, horizon_ms => 4000}),
    ?FORALL(Seed, uniform(0, 16#FFFFFFFF), begin
        {A, With} = search(Options, #{seed => Seed, max_runs => 60}),
        {B, Without} = search(Options, #{seed => Seed, max_runs => 60, snapshots => 0}),
        Same = [commands, outcome, value, key, runs, elapsed, populations],
        conjunction([
            {same, equals({A, maps:with(Same, With)}, {B, maps:with(Same, Without)})},
            {cheaper, maps:get(simulated, With) =< maps:get(simulated, Without)}
        ])
    end).

prop_snapshots_only_save_time(doc) -> "A search with snapshots finds what it finds without";
prop_snapshots_only_save_time(opts) -> [{numtests, 10}, {transport, nif}].

search(#{horizon_ms := Horizon} = Options, Given) ->
    ok = copter_options:use(Options),
    faultcheck_search:search(copter_eqc, Given#{
        bias => 0.9, time => Horizon, begin_test => fun() -> copter_eqc:begin_test(Options) end
    }).

%% ---- the simulator ----------------------------------------------------------------------------

%% A sequence with these options, and that test of what came of it.
whatever(Changes, Test) ->
    Options = copter_options:new(Changes),
    ok = copter_options:use(Options),
    ?SETUP(
        fun() ->
            ok = copter_options:use(Options),
            fun() -> ok end
        end,
        ?FORALL(Commands, commands(copter_eqc), Test(Options, Commands))
    ).

prop_perceived_is_true_without_faults() ->
    whatever(#{max_faults => 0}, fun(Options, Commands) ->
        #{true := True, perceived := Perceived} = copter_trial:ending(Options, Commands),
        equals(True, Perceived)
    end).

prop_perceived_is_true_without_faults(doc) ->
    "Without faults each copter perceives the truth, to the last bit";
prop_perceived_is_true_without_faults(opts) ->
    [{numtests, 100}, {transport, nif}].

%% Each iterate in parts, down to single steps.
prop_splitting_changes_nothing() ->
    whatever(#{}, fun(Options, Commands) ->
        ?FORALL(Parts, non_empty(list(uniform(5, 300))), begin
            Whole = copter_trial:ending(Options, Commands),
            equals(Whole, copter_trial:ending(Options, split(Commands, Parts)))
        end)
    end).

prop_splitting_changes_nothing(doc) -> "However time is split into runs, not a bit changes";
prop_splitting_changes_nothing(opts) -> [{numtests, 100}, {transport, nif}].

%% Parts of whole steps, in turn; a sequence of the model does not have iterate twice running, so
%% these are run without its preconditions.
split(Commands, Parts) ->
    {Split, _} = lists:mapfoldl(fun split_one/2, Parts, Commands),
    lists:append(Split).

split_one({set, Var, {call, Mod, iterate, [Ms]}}, Parts) ->
    {Pieces, Rest} = pieces(Ms div 5 * 5, Parts),
    {[{set, Var, {call, Mod, iterate, [Piece]}} || Piece <- Pieces], Rest};
split_one(Command, Parts) ->
    {[Command], Parts}.

pieces(0, Parts) -> {[], Parts};
pieces(Left, [Part | Parts]) ->
    Piece = min(Left, Part div 5 * 5),
    {Pieces, Rest} = pieces(Left - Piece, Parts ++ [Part]),
    {[Piece | Pieces], Rest}.

%% Ids in the same order. A bit flip may hit the id in a message, so messages stay whole.
prop_names_change_nothing() ->
    Faults = copter_fault:kinds() -- [corruption],
    whatever(#{faults => Faults}, fun(Options, Commands) ->
        ?FORALL({First, Step}, {uniform(0, 1000), uniform(1, 1000)}, begin
            New = fun(Id) -> First + Step * Id end,
            Before = copter_trial:ending(Options, Commands),
            After = copter_trial:ending(Options, renamed(New, Commands)),
            equals(with_names(New, Before), After)
        end)
    end).

prop_names_change_nothing(doc) -> "Other ids in the same order change nothing but the ids";
prop_names_change_nothing(opts) -> [{numtests, 100}, {transport, nif}].

renamed(New, Commands) ->
    [
        {set, Var, {call, Mod, F, renamed(F, New, Args)}}
     || {set, Var, {call, Mod, F, Args}} <- Commands
    ].

renamed(F, _, Args) when F =:= iterate; F =:= fault_anchor; F =:= fault_clear -> Args;
renamed(_, New, [Id | Args]) -> [New(Id) | Args].

with_names(New, #{result := Result, true := True, perceived := Perceived} = Ending) ->
    Ending#{
        result := collision_of(New, Result),
        true := [{New(Id), Bits} || {Id, Bits} <- True],
        perceived := [{New(Id), Bits} || {Id, Bits} <- Perceived]
    }.

collision_of(New, {collision, #{kind := copter, ids := Ids} = Collision}) ->
    {collision, Collision#{ids := [New(Id) || Id <- Ids]}};
collision_of(New, {collision, #{kind := terrain, ids := [Id, Line]} = Collision}) ->
    {collision, Collision#{ids := [New(Id), Line]}};
collision_of(_, Result) ->
    Result.

%% Rounding differs, and grows with time; faults along an axis of the world do not turn with it.
prop_moving_the_world_changes_nothing() ->
    Faults = copter_fault:kinds() -- [corruption, jump, anchor],
    Options = copter_options:new(#{faults => Faults, horizon_ms => 5000}),
    ?FORALL(
        {Seed, Dx, Dy, Turns},
        {uniform(0, 16#FFFFFFFF), uniform(-50, 50), uniform(-50, 50), integer(0, 3)},
        begin
            Commands = copter_trial:commands(Options, Seed, 1),
            copter_moved:difference(Options, Commands, {float(Dx), float(Dy), Turns}) < 1.0e-6
        end
    ).

prop_moving_the_world_changes_nothing(doc) ->
    "A world shifted and turned by quarters gives the same flight within 1e-6 over 5 s";
prop_moving_the_world_changes_nothing(opts) ->
    [{numtests, 100}, {transport, nif}].

%% Without the option transport, which would make both the same.
prop_transports_agree() ->
    whatever(#{}, fun(Options, Commands) ->
        Ending = fun(Transport) ->
            ok = copter_sut:default_transport(Transport),
            Result = copter_trial:ending(Options, Commands),
            ok = copter_sut:stop(),
            Result
        end,
        Port = Ending(port),
        equals(Port, Ending(nif))
    end).

prop_transports_agree(doc) -> "In this VM and in an OS process of its own: the same bits";
prop_transports_agree(opts) -> [{numtests, 10}].

prop_threads_agree() ->
    Options = copter_options:new(#{horizon_ms => 2000, min_copters => 10}),
    ?FORALL({Seed, Threads}, {uniform(0, 16#FFFFFFFF), integer(2, 8)}, begin
        Commands = copter_trial:commands(Options, Seed, 1),
        One = copter_trial:ending(Options, Commands),
        equals(One, copter_trial:ending(Options#{threads := Threads}, Commands))
    end).

prop_threads_agree(doc) -> "One thread or several: the same bits";
prop_threads_agree(opts) -> [{numtests, 20}, {transport, nif}].

prop_grid_is_brute_force() ->
    ?FORALL(Seed, uniform(0, 16#FFFFFFFF), begin
        Copters = 10 + 40 * (Seed rem 2),
        Options = copter_options:new(#{
            world => {box, Copters}, max_copters => Copters, horizon_ms => 2000
        }),
        Commands = copter_trial:commands(Options, Seed, 1),
        Grid = copter_trial:ending(Options, Commands),
        equals(Grid, copter_trial:ending(Options#{brute_force := true}, Commands))
    end).

prop_grid_is_brute_force(doc) -> "Candidates from a grid or all pairs: the same bits";
prop_grid_is_brute_force(opts) -> [{numtests, 25}, {transport, nif}].

%% The scenario that is stored with a case: the same collision, or the same states at the end.
prop_scenario_is_the_sequence() ->
    Options = copter_options:new(#{min_copters => 4, horizon_ms => 8000}),
    ?FORALL(Seed, uniform(0, 16#FFFFFFFF), begin
        Commands = copter_trial:commands(Options, Seed, 1),
        Trace = copter_test_scenario:fly(Options, Commands),
        Run = copter_trial:rerun(Options, Commands),
        equals(
            copter_test_scenario:compared({run, Run}),
            copter_test_scenario:compared({trace, Trace})
        )
    end).

prop_scenario_is_the_sequence(doc) -> "coptersim_run flies the scenario of a sequence bit for bit";
prop_scenario_is_the_sequence(opts) -> [{numtests, 50}, {transport, nif}].

%% What happens after a snapshot happens again after it is restored.
prop_snapshot_is_complete() ->
    whatever(#{}, fun(Options, Commands) ->
        ?FORALL(Share, uniform(0, 100), begin
            {Before, After} = lists:split(length(Commands) * Share div 100, Commands),
            Direct = copter_trial:ending(Options, Commands),
            _ = copter_trial:rerun(Options, Before),
            Snapshot = copter_sut:snapshot(),
            First = copter_trial:continued(After),
            ok = copter_sut:restore(Snapshot),
            Second = copter_trial:continued(After),
            ok = copter_sut:release(Snapshot),
            conjunction([
                {first, equals(Direct, First)}, {second, equals(Direct, Second)}
            ])
        end)
    end).

prop_snapshot_is_complete(doc) -> "A restored snapshot goes on as the original, to the last bit";
prop_snapshot_is_complete(opts) -> [{numtests, 100}, {transport, nif}].

%% Slow copters, more than 10 m from each other and far from the lines.
prop_override_rests_while_nobody_is_near() ->
    Options = copter_options:new(#{world => {box, 400}, max_faults => 0}),
    Tilt = uniform(-20, 20),
    ?FORALL(
        {Places, Steering},
        {some_of([{X, Y} || X <- [-30, -15, 0, 15, 30], Y <- [-30, -15, 0, 15, 30]]),
         list({uniform(0, 24), Tilt, Tilt, uniform(-900, 900)})},
        begin
            ok = copter_eqc:begin_test(Options),
            Copters = lists:zip(lists:seq(0, length(Places) - 1), Places),
            [ok = copter_sut:add_copter(Id, float(X), float(Y)) || {Id, {X, Y}} <- Copters],
            [
                begin
                    ok = copter_eqc:steer(Of rem length(Places), Roll, Pitch, Turn),
                    ok = copter_sut:iterate(100)
                end
             || {Of, Roll, Pitch, Turn} <- lists:sublist(Steering, 20)
            ],
            [] =:= [Id || {Id, _} <- Copters, maps:get(steps, copter_sut:station(Id)) =/= 0]
        end
    ).

prop_override_rests_while_nobody_is_near(doc) ->
    "The override leaves slow copters alone that are more than 10 m apart";
prop_override_rests_while_nobody_is_near(opts) ->
    [{numtests, 100}, {transport, nif}].

some_of(Places) ->
    ?LET(
        Order,
        vector(length(Places), uniform(0, 1000000)),
        ?LET(N, integer(1, length(Places)),
             lists:sublist([P || {_, P} <- lists:sort(lists:zip(Order, Places))], N))
    ).

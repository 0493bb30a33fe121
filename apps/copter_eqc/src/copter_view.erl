%% @doc Quadcopters as something that can be played (replay_source): stored cases, scenarios, and
%% flights by hand in the reference world.
%%
%% The simulation is the one of the calling process (copter_sut). A case is carried out command by
%% command as the property did; only time is cut into shorter parts, which changes no bit.
-module(copter_view).
-behaviour(replay_source).

-export([open/1, start/1, advance/2, next/1, now/1, step_us/1, duration/1, ending/1, recorded/1]).
-export([is_live/1, info/1, world/1, objects/1, risk/2, ranges/2, faults/1, faults_key/1]).
-export([observer/1, fork/1, act/2, store/1]).
-export([of_case/4, endings/2]).
-export_type([view/0, endings/0]).

%% How the sequences of a case ended.
-type endings() :: #{shrunk | original => replay_source:ending()}.

-record(view, {
    %% of a stored case; none: flown by hand, or a scenario
    'case' = none :: none | faultcheck_case:'case'(),
    name :: string(),
    original = 0 :: non_neg_integer(),
    %% of a stored counterexample, or of a test
    origin = none :: none | copter_stored:origin(),
    settings :: copter_sut:settings(),
    recorded :: unknown | any_failure | replay_source:ending(),
    %% can be stored as a case of this property
    property :: none | {module(), atom()},
    live = false :: boolean(),
    plan :: [copter_plan:planned()],
    end_us :: replay_source:t_us() | unknown,
    %% what is still to come of the plan; what was done, newest first
    due = [] :: [copter_plan:planned()],
    done = [] :: [copter_plan:planned()],
    now = 0 :: replay_source:t_us(),
    ending = running :: replay_source:ending(),
    collided = [] :: [replay_source:id()],
    armed = copter_armed:new() :: copter_armed:armed(),
    %% tenths, of those steered by hand
    hands = #{} :: #{replay_source:id() => {integer(), integer(), integer()}}
}).
-opaque view() :: #view{}.

%% Of a live flight the latest so many are listed.
-define(MOST_COMMANDS, 500).
-define(EXAMPLE, "crowd_with_faults").
%% us
-define(SHORTEST_DT, 1000).

%% ---- opening ----------------------------------------------------------------------------------

%% @doc See replay_source. Also a flight without a case, `{flight, Name, Settings, Plan}', and that
%% of a test which is running, `{test, Name, Origin, Settings, Plan}'.
-spec open(replay_source:what()) -> {ok, view()} | {error, string()}.
open({'case', Dir, Which}) ->
    Scenario = filename:join(Dir, "scenario.json"),
    case {faultcheck_case:read(Dir), filelib:is_file(Scenario)} of
        {{error, _} = Error, _} ->
            Error;
        {_, false} ->
            {error, lists:concat([Dir, ": scenario.json is missing; faultcheck report ", Dir,
                                  " writes it"])};
        {{ok, Case}, true} ->
            with_scenario(Scenario, fun(#{settings := Settings, origin := Origin}) ->
                of_case(Case, Which, Settings, recorded_in(Origin, Which))
            end)
    end;
open(example) ->
    open({named, ?EXAMPLE});
open({named, Name}) ->
    case [Stored || {Known, _, _} = Stored <- copter_stored:all(), Known =:= Name] of
        [{_, Options, Commands}] -> {ok, of_stored(Name, Options, Commands)};
        [] -> {error, lists:concat(["no stored flight ", Name])}
    end;
open({scenario, File}) ->
    with_scenario(File, fun(#{name := Name, settings := Settings, plan := Plan}) ->
        Title = unicode:characters_to_list(Name),
        (of_plan(Title, Settings, Plan))#view{live = true, end_us = unknown}
    end);
open({kept, Dir}) ->
    with_scenario(filename:join(Dir, "scenario.json"), fun(Scenario) ->
        #{settings := Settings, plan := Plan, origin := Origin} = Scenario,
        (of_plan(filename:basename(Dir), Settings, Plan))#view{
            recorded = recorded_in(Origin, shrunk)
        }
    end);
open({flight, Name, Settings, Plan}) ->
    {ok, of_plan(Name, Settings, Plan)};
open({test, Name, Origin, Settings, Plan}) ->
    {ok, (of_plan(Name, Settings, Plan))#view{origin = Origin}};
open(live) ->
    Settings = settings_of(#{world => reference}),
    Empty = of_plan("flown by hand", Settings, #{planned => [], end_us => 0}),
    {ok, Empty#view{live = true, end_us = unknown}}.

with_scenario(File, Then) ->
    case copter_plan:read_scenario(File) of
        {ok, Scenario} -> {ok, Then(Scenario)};
        {error, _} = Error -> Error
    end.

of_plan(Name, Settings, #{planned := Planned, end_us := End}) ->
    #view{
        name = Name, settings = Settings, recorded = unknown, property = property_in(Settings),
        plan = Planned, original = length(Planned), end_us = End
    }.

%% A property in whose world and with whose parameters it flies, or none.
property_in(Settings) ->
    Worlds = [{reference, prop_copters_survive_faults}, {{box, 10}, prop_copters_survive_a_crowd}],
    case [P || {W, P} <- Worlds, settings_of(#{world => W}) =:= Settings] of
        [Property | _] -> {prop_copter_demo, Property};
        [] -> none
    end.

settings_of(Changes) -> copter_sut:settings(copter_options:new(Changes)).

of_stored(Name, Options, Commands) ->
    #{dt_us := Dt} = Settings = copter_sut:settings(Options),
    View = of_plan(Name, Settings, copter_plan:from_commands(Commands, Dt)),
    Origin = copter_stored:origin(Name),
    Original =
        case Origin of
            #{commands := Before} -> Before;
            none -> View#view.original
        end,
    View#view{recorded = any_failure, origin = Origin, original = Original}.

%% @doc A stored case with the settings of its property. Recorded is how it ended then.
-spec of_case(
    faultcheck_case:'case'(),
    shrunk | original,
    copter_sut:settings(),
    unknown | any_failure | replay_source:ending()
) -> view().
of_case(Case, Which, #{dt_us := Dt} = Settings, Recorded) ->
    #{property := Property, module := Module, shrunk := Shrunk, original := Original} = Case,
    {ok, Commands} = faultcheck_case:commands(maps:get(Which, Case)),
    View = of_plan(
        faultcheck_case:id(Property, Shrunk), Settings, copter_plan:from_commands(Commands, Dt)
    ),
    {ok, Before} = faultcheck_case:commands(Original),
    View#view{
        'case' = Case, recorded = Recorded, property = {Module, Property},
        original = length(Before)
    }.

recorded_in(Origin, Which) ->
    case Origin of
        #{<<"x_endings">> := Endings} when is_map(Endings) ->
            read_ending(maps:get(atom_to_binary(Which), Endings, null));
        _ ->
            any_failure
    end.

read_ending(null) -> any_failure;
read_ending(<<"passed">>) -> passed;
read_ending(Text) -> {failed, unicode:characters_to_list(Text)}.

%% @doc How the sequences of a case end with these settings.
-spec endings(faultcheck_case:'case'(), copter_sut:settings()) -> endings().
endings(Case, Settings) ->
    maps:from_list([
        {Which, ending_of(of_case(Case, Which, Settings, unknown))}
     || Which <- [shrunk, original]
    ]).

ending_of(#view{end_us = End} = View) ->
    {_, Begun} = start(View),
    {_, Ended} = advance(End, Begun),
    ending(Ended).

%% ---- time -------------------------------------------------------------------------------------

%% @doc Back to time 0.
-spec start(view()) -> {[replay_source:event()], view()}.
start(#view{settings = Settings, plan = Plan} = View) ->
    ok = copter_sut:begin_flight(Settings),
    carry_out(View#view{
        due = Plan, done = [], now = 0, ending = running, collided = [],
        armed = copter_armed:new(), hands = #{}
    }).

%% @doc Lets time pass.
-spec advance(replay_source:t_us(), view()) -> {[replay_source:event()], view()}.
advance(T, View) -> advance(T, [], View).

advance(T, Events, #view{ending = running, now = Now, settings = #{dt_us := Dt}} = View) ->
    Until = lists:min([T | [Next || Next <- [next(View), duration(View)], is_integer(Next)]]),
    case (Until - Now) div Dt of
        Steps when Steps > 0 ->
            {New, Moved} = moved(copter_sut:run(Steps), View),
            {More, Next} = carry_out(Moved),
            advance(T, Events ++ New ++ More, Next);
        _ ->
            {Events, View}
    end;
advance(_, Events, View) ->
    {Events, View}.

moved(ok, View) ->
    {[], View#view{now = copter_sut:time_us()}};
moved({collision, First}, View) ->
    Text = collision_text(First),
    Collisions = copter_sut:collisions(),
    Copters = lists:usort(lists:append([copters_in(C) || C <- Collisions])),
    Events = [collision_event(C, View) || C <- Collisions] ++
        [event(verdict, #{t_us => copter_sut:time_us(), text => ["failed: ", Text]})],
    {Events, View#view{
        now = copter_sut:time_us(), ending = {failed, Text}, collided = Copters
    }}.

copters_in(#{kind := copter, ids := Ids}) -> Ids;
copters_in(#{kind := terrain, ids := [Id, _]}) -> [Id].

collision_text(#{t_us := T, point := {X, Y}} = Collision) ->
    text("~ts at ~.6f s, (~.3f, ~.3f)", [met(Collision), T / 1.0e6, X, Y]).

met(#{kind := copter, ids := [A, B]}) -> text("copters ~b and ~b collided", [A, B]);
met(#{kind := terrain, ids := [Id, Line]}) -> text("copter ~b met terrain line ~b", [Id, Line]).

collision_event(#{kind := Kind, ids := [A, B], t_us := T, point := {X, Y}} = Collision, View) ->
    Other =
        case Kind of
            copter -> B;
            terrain -> place_of(B, View)
        end,
    event(collision, #{t_us => T, a => A, b => Other, x => X, y => Y, text => met(Collision)}).

%% Where a line stands in the list of the message.
place_of(Id, View) ->
    length(lists:takewhile(fun({Other, _, _}) -> Other =/= Id end, lines(View))).

%% What is planned for now; and whether that is all.
carry_out(#view{due = [{T, _, _} = Planned | Due], now = Now, ending = running} = View) when
    T =< Now
->
    {Events, Next} = perform(Planned, View#view{due = Due}),
    {More, Last} = carry_out(Next),
    {Events ++ More, Last};
carry_out(#view{due = [], now = Now, end_us = End, ending = running} = View) when Now >= End ->
    {[event(verdict, #{t_us => Now, text => "passed"})], View#view{ending = passed}};
carry_out(View) ->
    {[], View}.

perform({_, Index, Call} = Planned, #view{now = Now} = View0) ->
    case performed(Planned, View0) of
        {ok, Events, View} ->
            {Events, View};
        {refused, Sentence, View} ->
            Text = text("~ts: ~ts", [call_text(Call), Sentence]),
            Verdict = event(verdict, #{t_us => Now, text => ["failed: ", Text]}),
            {[command_event(Index, Call, Now), Verdict], View#view{ending = {failed, Text}}}
    end.

performed({_, Index, {Name, Args} = Call}, #view{now = Now, done = Done} = View0) ->
    View = before(Call, View0#view{done = [{Now, Index, Call} | Done]}),
    Event = command_event(Index, Call, Now),
    case copter_plan:is_time(Name) orelse apply(copter_eqc, Name, Args) of
        true -> {ok, [Event], View};
        ok -> after_call(Call, Event, View);
        {error, {_, Sentence}} -> {refused, Sentence, View}
    end.

command_event(Index, Call, Now) ->
    event(command, #{t_us => Now, a => Index, text => call_text(Call)}).

before({fault_clear, []}, #view{now = Now, armed = Armed} = View) ->
    View#view{armed = copter_armed:cleared(all, Now, Armed)};
before({fly_clear, [{_, Place}]}, #view{now = Now, armed = Armed} = View) ->
    View#view{armed = copter_armed:cleared(Place, Now, Armed)};
before(_, View) ->
    View.

after_call(Call, Event, #view{now = Now, armed = Armed, settings = #{dt_us := Dt}} = View) ->
    case faults_of(Call, Dt) of
        [] ->
            {ok, [Event], View};
        Faults ->
            New = copter_armed:armed(Faults, Now, Dt, Armed),
            {ok, [Event | [fault_event(F, Now) || F <- Faults]], View#view{armed = New}}
    end.

faults_of({fly_inject, [Where, Model, Parameters, Trigger, Seed]}, _) ->
    Own = [{<<"seed">>, Seed} || Seed =/= none],
    [{Where, Model, {object, Parameters ++ Own}, Trigger}];
faults_of({Name, Args}, Dt) ->
    case string:prefix(atom_to_list(Name), "fault_") of
        Kind when Kind =:= nomatch; Kind =:= "clear" ->
            [];
        Kind ->
            Armings = copter_fault:arming(list_to_existing_atom(Kind), Args, copter_sut:copters()),
            [copter_armed:named(A, Dt) || A <- Armings]
    end.

fault_event({{_, Place}, Model, Params, _}, Now) ->
    event(fault, #{
        t_us => Now,
        a => copter_armed:object_of(Place),
        text => [Place, ": ", Model, " ", faultcheck_json:encode(Params)]
    }).

event(Kind, Given) ->
    Defaults = #{a => -1, b => -1, x => 0.0, y => 0.0},
    #{text := Text} = Event = maps:merge(Defaults, Given),
    Event#{kind => atom_to_binary(Kind), text := unicode:characters_to_binary(Text)}.

call_text({Name, Args}) -> text("~ts(~ts)", [Name, args_text(Args)]).

args_text(Args) -> lists:join(", ", [io_lib:format("~0tp", [A]) || A <- Args]).

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

%% @doc The time of the next thing planned.
-spec next(view()) -> replay_source:t_us() | none.
next(#view{due = [{T, _, _} | _]}) -> T;
next(#view{due = []}) -> none.

-spec now(view()) -> replay_source:t_us().
now(#view{now = Now}) -> Now.

-spec step_us(view()) -> pos_integer().
step_us(#view{settings = #{dt_us := Dt}}) -> Dt.

-spec duration(view()) -> replay_source:t_us() | unknown.
duration(#view{end_us = End}) -> End.

-spec ending(view()) -> replay_source:ending().
ending(#view{ending = Ending}) -> Ending.

-spec recorded(view()) -> unknown | any_failure | replay_source:ending().
recorded(#view{recorded = Recorded}) -> Recorded.

-spec is_live(view()) -> boolean().
is_live(#view{live = Live}) -> Live.

%% ---- what can be seen -------------------------------------------------------------------------

%% @doc What it is, for VIZ_CASE.
-spec info(view()) -> replay_source:info().
info(#view{name = Name, live = Live, original = Stored} = View) ->
    Commands = [command(P) || P <- commands(View)],
    Original =
        case Live of
            true -> length(Commands);
            false -> Stored
        end,
    #{
        case_id => list_to_binary(Name),
        property => property_of(View),
        seed => seed_of(View),
        code_version => version_of(View),
        ncmd_original => Original,
        commands => Commands,
        params => copter_view_params:of_view(parameters(View))
    }.

%% All that are planned, and those done by hand.
commands(#view{live = false, plan = Plan}) -> Plan;
commands(#view{live = true, done = Done, due = Due}) ->
    lists:reverse(lists:sublist(Done, ?MOST_COMMANDS), Due).

command({T, Index, {Name, Args}}) ->
    #{
        t_us => T,
        index => Index,
        name => atom_to_binary(Name),
        args => unicode:characters_to_binary(args_text(Args))
    }.

property_of(#view{'case' = none, live = true}) -> <<"flown by hand">>;
property_of(#view{'case' = none, origin = #{property := Property}}) ->
    unicode:characters_to_binary(Property);
property_of(#view{'case' = none}) -> <<>>;
property_of(#view{'case' = #{module := Module, property := Property}}) ->
    unicode:characters_to_binary([atom_to_list(Module), $:, atom_to_list(Property)]).

seed_of(#view{'case' = none, origin = #{seed := Seed, test := Test}}) ->
    unicode:characters_to_binary(text("~b, test ~b", [Seed, Test]));
seed_of(#view{'case' = none}) -> <<>>;
seed_of(#view{'case' = #{seed := Seed}}) -> integer_to_binary(Seed).

version_of(#view{'case' = none}) -> versions(faultcheck_versions:all());
version_of(#view{'case' = #{versions := Versions}}) -> versions(Versions).

versions(#{faultcheck := Version, git := Git}) ->
    unicode:characters_to_binary([Version, " ", Git]).

parameters(#view{'case' = Case, live = Live, settings = Settings, recorded = Recorded} = View) ->
    #{
        'case' => Case,
        live => Live,
        dt_us => maps:get(dt_us, Settings),
        copters => copters_of(View),
        recorded => Recorded
    }.

copters_of(#view{live = true}) ->
    copter_sut:copters();
copters_of(#view{plan = Plan}) ->
    lists:usort(lists:append([added(Call) || {_, _, Call} <- Plan])).

added({add_copter, [Id | _]}) -> [Id];
added({fly_add, [Id | _]}) -> [Id];
added({add_grid, [N, _]}) -> lists:seq(0, N - 1);
added(_) -> [].

%% @doc Terrain and anchors.
-spec world(view()) -> replay_source:world().
world(#view{settings = #{anchors := Anchors}} = View) ->
    #{
        seg => [[X1, Y1, X2, Y2] || {_, {X1, Y1}, {X2, Y2}} <- lines(View)],
        anchors => [#{id => Id, pos => [X, Y, Z]} || {Id, X, Y, Z} <- Anchors],
        polys => []
    }.

lines(#view{settings = #{lines := Lines}}) -> lists:keysort(1, Lines).

%% @doc All copters.
-spec objects(view()) -> [replay_source:object()].
objects(#view{now = Now, collided = Collided, armed = Armed, hands = Hands}) ->
    Marks = #{
        collided => Collided,
        faulted => copter_armed:copters(Now, Armed),
        manual => lists:sort(maps:keys(Hands))
    },
    copter_columns:objects(Marks, copter_surroundings:comfort()).

-spec risk(replay_source:id(), view()) -> [replay_source:ellipse()].
risk(Id, #view{now = Now} = View) ->
    copter_surroundings:risk(Id, Now, [Line || {Line, _, _} <- lines(View)]).

-spec ranges(replay_source:id(), view()) -> [replay_source:range()].
ranges(Id, _View) -> copter_surroundings:ranges(Id).

-spec faults(view()) -> [replay_source:fault()].
faults(#view{now = Now, armed = Armed}) -> copter_armed:items(Now, Armed).

-spec faults_key(view()) -> term().
faults_key(#view{now = Now, armed = Armed}) -> copter_armed:key(Now, Armed).

%% @doc Who collided, who is disturbed, or the first.
-spec observer(view()) -> replay_source:id().
observer(#view{now = Now, collided = Collided, armed = Armed} = View) ->
    case Collided ++ copter_armed:copters(Now, Armed) ++ copters_of(View) of
        [Id | _] -> Id;
        [] -> -1
    end.

%% ---- by hand ----------------------------------------------------------------------------------

%% @doc The plan ends here.
-spec fork(view()) -> view().
fork(#view{ending = Ending} = View) ->
    Goes =
        case Ending of
            passed -> running;
            _ -> Ending
        end,
    View#view{live = true, due = [], end_us = unknown, ending = Goes, recorded = unknown}.

%% @doc What a person does; see replay_source.
-spec act(replay_source:action(), view()) ->
    {ok, [replay_source:event()], view()} | {error, string()}.
act(_, #view{live = false}) ->
    {error, "a replay cannot be changed: fork it first"};
act(_, #view{ending = {failed, Text}}) ->
    {error, "the flight is over: " ++ Text};
act(Action, View) ->
    case copter_hand:calls(Action, copter_sut:copters(), View#view.hands) of
        {ok, Calls, Hands} -> by_hand(Calls, [], View#view{hands = Hands}, View);
        {error, _} = Error -> Error
    end.

by_hand([], Events, View, _) ->
    {ok, Events, View};
by_hand([Call | Calls], Events, #view{now = Now, done = Done, due = Due} = View, Before) ->
    Index = length(Done) + length(Due),
    try performed({Now, Index, Call}, View) of
        {refused, Sentence, _} -> {error, text("~ts", [Sentence])};
        {ok, New, Next} -> by_hand(Calls, Events ++ New, Next, Before)
    catch
        %% the simulator says in a sentence what it does not accept
        error:{csim, _, _, Sentence} -> {error, unicode:characters_to_list(Sentence)}
    end.

%% @doc The flight as a case of its property; as its scenario where no property has its world, or
%% where its steps are too short for the commands of one.
-spec store(view()) -> {replay_kept:kept(), replay_kept:files()}.
store(#view{property = {Module, Property}, settings = #{dt_us := Dt} = Settings} = View) when
    Dt >= ?SHORTEST_DT
->
    #view{done = Done, now = End, 'case' = Before} = View,
    Commands = copter_plan:to_commands(lists:reverse(Done), End, Dt),
    Result = result(View),
    Case = stored(Module, Property, [Commands], Result, Before),
    Scenario = copter_scenario:from_case(Case, Settings, #{shrunk => Result, original => Result}),
    {Case, [scenario_file(Scenario)]};
store(#view{done = Done, now = End, settings = Settings} = View) ->
    Planned = lists:reverse(Done),
    Id = faultcheck_case:id(flight, [Settings, Planned, End]),
    Scenario = copter_scenario:from_plan(Planned, End, Settings, Id, result(View)),
    {{flight, Id}, [scenario_file(Scenario)]}.

result(#view{ending = {failed, _} = Failed}) -> Failed;
result(_) -> passed.

scenario_file(Scenario) -> {"scenario.json", faultcheck_json:pretty(Scenario)}.

stored(Module, Property, Sequence, Result, Before) ->
    {Status, Reasons} =
        case Result of
            passed -> {passed, []};
            {failed, _} -> {failed, ["postcondition false"]}
        end,
    Options =
        case Before of
            none -> ["--dir", "demo"];
            #{options := Given} -> Given
        end,
    #{
        module => Module,
        property => Property,
        status => Status,
        seed => 0,
        test => none,
        size => none,
        transport => none,
        options => Options,
        versions => faultcheck_versions:all(),
        original => Sequence,
        shrunk => Sequence,
        reasons => Reasons,
        shrink => #{tries => 0, accepted => 0, minimal => false}
    }.

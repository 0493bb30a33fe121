%% @doc What happens in a flight, and when: the commands of a sequence, or the events of a scenario,
%% each with its simulated time.
%%
%% Calls are those of the model copter_eqc, so a plan is carried out as the sequence was. Those that
%% let time pass stay among them: they are to be shown, and their time is that until the next one.
-module(copter_plan).

-export([from_commands/2, to_commands/3, is_time/1]).
-export([read_scenario/1]).
-export_type([call/0, planned/0, plan/0, scenario/0]).

-type call() :: {Name :: atom(), Args :: [term()]}.
%% The number of the command, from 0.
-type planned() :: {T_us :: non_neg_integer(), Index :: non_neg_integer(), call()}.
-type plan() :: #{
    planned := [planned()],
    %% when the last command is over
    end_us := non_neg_integer()
}.
-type scenario() :: #{
    name := binary(),
    settings := copter_sut:settings(),
    plan := plan(),
    %% members that begin with x_
    origin := #{binary() => faultcheck_json:decoded()}
}.

-define(US_PER_MS, 1000).
-define(NS_PER_US, 1000).
-define(DEFAULT_DIV, 20).

%% @doc The plan of a sequence, whose time passes in whole steps.
-spec from_commands([faultcheck_generator:command()], Dt_us :: pos_integer()) -> plan().
from_commands(Commands, Dt) ->
    Calls = [{Name, Args} || {set, _, {call, copter_eqc, Name, Args}} <- Commands],
    timed([{0, Call} || Call <- Calls], Dt).

%% Times are relative to those of the iterates before.
timed(Calls, Dt) ->
    {Planned, {End, _}} = lists:mapfoldl(
        fun({At, Call}, {Begun, Index}) ->
            {{Begun + At, Index, Call}, {Begun + lasting(Call, Dt), Index + 1}}
        end,
        {0, 0},
        Calls
    ),
    #{planned => Planned, end_us => End}.

lasting({Name, [Ms]}, Dt) when Name =:= iterate; Name =:= fly_wait ->
    Ms * ?US_PER_MS div Dt * Dt;
lasting(_, _) ->
    0.

%% @doc Whether all that a command does is to let time pass.
-spec is_time(Name :: atom()) -> boolean().
is_time(Name) -> Name =:= iterate orelse Name =:= fly_wait.

%% @doc The sequence of what was done up to a time: the way back. Steps must not be shorter than a
%% millisecond, for which iterate has no words. It also wants copters; without them it is fly_wait.
-spec to_commands([planned()], End_us :: non_neg_integer(), Dt_us :: pos_integer()) ->
    [faultcheck_generator:command()].
to_commands(Planned, End, Dt) when Dt >= ?US_PER_MS ->
    Done = [{T, Call} || {T, _, {Name, _} = Call} <- Planned, not is_time(Name)],
    numbered(passing(Done, 0, End, 0)).

passing([], Now, End, Copters) -> passes(End - Now, Copters);
passing([{T, Call} | Rest], Now, End, Copters) ->
    passes(T - Now, Copters) ++ [Call | passing(Rest, T, End, Copters + more(Call))].

more({fly_remove, _}) -> -1;
more({add_grid, [N, _]}) -> N;
more({Name, _}) when Name =:= add_copter; Name =:= fly_add -> 1;
more(_) -> 0.

%% Rounded up to whole ms, of which whole steps are made.
passes(0, _) -> [];
passes(Us, 0) -> [{fly_wait, [ms(Us)]}];
passes(Us, _) -> [{iterate, [ms(Us)]}].

ms(Us) -> (Us + ?US_PER_MS - 1) div ?US_PER_MS.

numbered(Calls) ->
    Numbers = lists:seq(1, length(Calls)),
    [{set, {var, N}, {call, copter_eqc, F, Args}} || {N, {F, Args}} <- lists:zip(Numbers, Calls)].

%% ---- scenarios --------------------------------------------------------------------------------

%% @doc Reads a scenario (docs/copter_scenarios.md). The error is one line.
-spec read_scenario(file:filename()) -> {ok, scenario()} | {error, string()}.
read_scenario(File) ->
    case file:read_file(File) of
        {error, Why} -> {error, line("~ts: ~ts", [File, file:format_error(Why)])};
        {ok, Text} -> decoded(File, faultcheck_json:decode(Text))
    end.

decoded(File, {error, {offset, Offset}}) ->
    {error, line("~ts: not JSON at byte ~b", [File, Offset])};
decoded(File, {ok, #{<<"format">> := <<"coptersim-scenario/1">>} = Json}) ->
    try
        {ok, scenario(Json)}
    catch
        throw:{bad, Line} -> {error, line("~ts: ~ts", [File, Line])};
        error:{badkey, Key} -> {error, line("~ts: the member ~ts is missing", [File, Key])};
        error:_ -> {error, line("~ts: a member has a value that does not fit (see "
                                "docs/copter_scenarios.md)", [File])}
    end;
decoded(File, {ok, _}) ->
    {error, line("~ts: not a scenario: \"format\" is not coptersim-scenario/1", [File])}.

scenario(Json) ->
    Duration = maps:get(<<"duration_us">>, Json),
    #{dt_us := Dt} = Settings = settings(Json),
    Placed = lists:flatmap(fun placed/1, maps:get(<<"copters">>, Json)),
    Events = [
        {up(T, Dt), Call}
     || #{<<"t_us">> := T} = Event <- by_time(maps:get(<<"events">>, Json, [])),
        Call <- event(without_comments(Event), up(T, Dt) - T)
    ],
    Calls = [{0, Call} || Call <- Placed] ++ Events,
    #{
        name => maps:get(<<"name">>, Json, <<"">>),
        settings => Settings,
        plan => #{
            planned => [{T, N, C} || {N, {T, C}} <- lists:zip(numbers(Calls), Calls)],
            end_us => Duration div Dt * Dt
        },
        origin => maps:filter(fun(Key, _) -> is_origin(Key) end, Json)
    }.

numbers(List) -> lists:seq(0, length(List) - 1).

is_origin(<<"x_", _/binary>>) -> true;
is_origin(_) -> false.

without_comments(Event) -> maps:filter(fun(Key, _) -> not is_comment(Key) end, Event).

is_comment(Key) -> is_origin(Key) orelse Key =:= <<"class">> orelse Key =:= <<"description">>.

%% Those of the same time in their order.
by_time(Events) ->
    lists:sort(fun(#{<<"t_us">> := A}, #{<<"t_us">> := B}) -> A =< B end, Events).

%% Between two steps: on the next one.
up(T, Dt) -> (T + Dt - 1) div Dt * Dt.

%% What a decoded scenario begins with.
settings(Json) ->
    Dt = maps:get(<<"dt_us">>, Json),
    World = maps:get(<<"world">>, Json, #{}),
    Params = maps:merge(
        maps:with([<<"altitude">>, <<"integrator">>, <<"halt_on_collision">>], Json),
        maps:get(<<"params">>, Json, #{})
    ),
    #{
        dt_us => Dt,
        its_div => maps:get(<<"its_div">>, Json, ?DEFAULT_DIV),
        anchor_div => maps:get(<<"anchor_div">>, Json, ?DEFAULT_DIV),
        values => maps:merge(named(Params), named(maps:get(<<"gains">>, Json, #{}))),
        lines => [
            {Id, {X1, Y1}, {X2, Y2}}
         || #{<<"id">> := Id, <<"p1">> := [X1, Y1], <<"p2">> := [X2, Y2]} <-
                maps:get(<<"lines">>, World, [])
        ],
        anchors => [
            {Id, X, Y, Z}
         || #{<<"id">> := Id, <<"pos">> := [X, Y, Z]} <- maps:get(<<"anchors">>, World, [])
        ]
    }.

named(Values) ->
    maps:from_list([{binary_to_atom(K, utf8), number(K, V)} || {K, V} <- maps:to_list(Values)]).

number(_, V) when is_number(V) -> V;
number(_, true) -> 1;
number(_, false) -> 0;
number(_, V) when is_binary(V) -> V;
number(Key, V) -> throw({bad, line("~ts: ~0tp is no value", [Key, V])}).

placed(#{<<"id">> := Id, <<"pos">> := [X, Y]} = Copter) ->
    case maps:keys(maps:without([<<"id">>, <<"pos">>, <<"yaw">>, <<"gains">>], Copter)) of
        [] -> ok;
        [Other | _] -> throw({bad, line("copters: \"~ts\" cannot be shown", [Other])})
    end,
    Yaw = maps:get(<<"yaw">>, Copter, 0.0),
    [
        {fly_add, [Id, float(X), float(Y), float(Yaw)]}
        | gains(Id, maps:get(<<"gains">>, Copter, #{}))
    ].

gains(Id, Gains) -> [{fly_set, [Id, Name, V]} || {Name, V} <- maps:to_list(named(Gains))].

%% Late: us from the time of the event to the step that it acts on.
event(#{<<"type">> := <<"command">>, <<"copter">> := Id} = Event, _) ->
    [Roll, Pitch, Yaw] = [
        float(maps:get(K, Event, 0.0)) || K <- [<<"roll">>, <<"pitch">>, <<"yaw">>]
    ],
    [{fly_command, [Id, Roll, Pitch, Yaw]}];
event(#{<<"type">> := <<"gains">>} = Event, _) ->
    Id = maps:get(<<"copter">>, Event, all),
    gains(Id, maps:without([<<"type">>, <<"copter">>, <<"t_us">>], Event));
event(#{<<"type">> := <<"fault">>, <<"probe">> := Probe} = Event, Late) ->
    [armed({probe, Probe}, maps:remove(<<"probe">>, Event), Late)];
event(#{<<"type">> := <<"packet_fault">>, <<"channel">> := Channel} = Event, Late) ->
    [armed({channel, Channel}, maps:remove(<<"channel">>, Event), Late)];
event(#{<<"type">> := <<"clear_faults">>, <<"probe">> := Probe}, _) ->
    [{fly_clear, [{probe, Probe}]}];
event(#{<<"type">> := <<"clear_faults">>, <<"channel">> := Channel}, _) ->
    [{fly_clear, [{channel, Channel}]}];
event(#{<<"type">> := <<"clear_faults">>}, _) ->
    [{fault_clear, []}];
event(#{<<"type">> := <<"params">>} = Event, _) ->
    gains(all, maps:without([<<"type">>, <<"t_us">>], Event));
event(#{<<"type">> := <<"add_copter">>} = Event, _) ->
    placed(maps:without([<<"type">>, <<"t_us">>], Event));
event(#{<<"type">> := <<"remove_copter">>, <<"id">> := Id}, _) ->
    [{fly_remove, [Id]}];
event(#{<<"type">> := Type}, _) ->
    throw({bad, line("events of type ~ts cannot be shown", [Type])}).

%% Parameters are members of the event, or of its member `params'.
armed(Where, #{<<"model">> := Model} = Event, Late) ->
    Others = maps:without([<<"type">>, <<"t_us">>, <<"model">>, <<"params">>], Event),
    When = maps:with(
        [<<"duration_us">>, <<"delay_us">>, <<"from_calls">>, <<"for_calls">>, <<"seed">>]
            ++ [<<"probability">> || not has_probability(Model)],
        Others
    ),
    Beside = maps:without(maps:keys(When), Others),
    Own = without_comments(maps:get(<<"params">>, Event, #{})),
    Parameters = lists:sort(maps:to_list(Beside) ++ maps:to_list(Own)),
    Bad = [Why || {Name, V} <- Parameters, Why <- copter_hand:why_wrong(Model, Name, V)],
    _ = [throw({bad, line("~ts: ~ts", [element(2, Where), Why])}) || Why <- Bad],
    Trigger = trigger(When, Late),
    {fly_inject, [Where, Model, Parameters, Trigger, maps:get(<<"seed">>, When, none)]}.

%% Those models have a parameter of this name.
has_probability(Model) -> lists:member(Model, [<<"dropout">>, <<"spike">>]).

trigger(When, Late) ->
    Time = maps:with([<<"delay_us">>, <<"duration_us">>], When),
    Calls = maps:with([<<"from_calls">>, <<"for_calls">>], When),
    _ = [
        throw({bad, line("~ts: a whole number from 0 up expected", [Key])})
     || {Key, V} <- maps:to_list(maps:merge(Time, Calls)), not (is_integer(V) andalso V >= 0)
    ],
    map_size(Time) > 0 andalso map_size(Calls) > 0 andalso
        throw({bad, "either delay_us and duration_us, or from_calls and for_calls"}),
    window(Time, Late) ++
        [{random, P} || {ok, P} <- [maps:find(<<"probability">>, When)]] ++
        [{from, N} || {ok, N} <- [maps:find(<<"from_calls">>, Calls)]] ++
        [{for, N} || {ok, N} <- [maps:find(<<"for_calls">>, Calls)]].

%% Counted from the time of the event, which may be between two steps.
window(Time, Late) ->
    Delay = maps:get(<<"delay_us">>, Time, 0),
    From = max(Delay, Late),
    case Time of
        #{<<"duration_us">> := Duration} ->
            To = max(Delay + Duration, From),
            [{time, (From - Late) * ?NS_PER_US, (To - From) * ?NS_PER_US}];
        _ ->
            [{time, (From - Late) * ?NS_PER_US, forever} || Delay > 0]
    end.

line(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

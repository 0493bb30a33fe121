%% @doc One copter on a schedule: what it perceives wrongly, sampled while faults come and go.
%%
%% For the figures of Papers II and III: anchors of the reference world without its lines, steps of
%% 10 ms, an anchor every 50 ms. All times are simulated ms.
-module(copter_flight).

-export([samples/3, hold/3]).
-export([settled/4, mean_error/3]).
-export_type([event/0, sample/0, held/0]).

-type event() ::
    {set, atom(), number()}
    | {command, Roll :: float(), Pitch :: float(), Yaw :: float()}
    %% for a time from now on; it counts as one, whatever is armed for it
    | {fault, Ms :: pos_integer(), [{faultcheck_inject:where(), faultcheck_fault:model()}]}.
%% Differences of the true and the perceived position (m) and velocity (m/s); faults active.
-type sample() :: {
    Ms :: non_neg_integer(), Position :: float(), Velocity :: float(), Faults :: non_neg_integer()
}.
%% How far the copter is from where it should hold, m; true and perceived.
-type held() :: {Ms :: non_neg_integer(), True :: float(), Perceived :: float()}.

-define(COPTER, 0).
-define(SAMPLE_MS, 20).
-define(NS_PER_MS, 1000000).

%% @doc Flies the schedule, with these parameters, for so long; samples every 20 ms.
-spec samples(#{atom() => number()}, [{Ms :: non_neg_integer(), event()}], Ms :: pos_integer()) ->
    [sample()].
samples(Set, Schedule, End) ->
    ok = start(Set),
    fly(0, End, Schedule, []).

start(Set) ->
    ok = copter_sut:begin_test(
        copter_options:new(#{
            world => open, dt_us => 10000, its_ms => 200, anchor_ms => 50, set => Set
        })
    ),
    copter_sut:add_copter(?COPTER, 0.0, 0.0).

fly(Now, End, _Schedule, _Active) when Now > End ->
    [];
fly(Now, End, Schedule, Active0) ->
    {Due, Later} = lists:splitwith(fun({At, _}) -> At =< Now end, Schedule),
    Began = [Until || {_, Event} <- Due, Until <- act(Event, Now)],
    Active = [Until || Until <- Began ++ Active0, Until > Now],
    {Position, Velocity} = errors(),
    Sample = {Now, Position, Velocity, length(Active)},
    ok = copter_sut:iterate(?SAMPLE_MS),
    [Sample | fly(Now + ?SAMPLE_MS, End, Later, Active)].

%% When a fault ends.
act({set, Name, Value}, _) ->
    ok = copter_sut:set(Name, Value),
    [];
act({command, Roll, Pitch, Yaw}, _) ->
    ok = copter_sut:command(?COPTER, Roll, Pitch, Yaw),
    [];
act({fault, Ms, Faults}, Now) ->
    Window = [{time, 0, Ms * ?NS_PER_MS}],
    ok = copter_sut:arm([{Where, {Model, Window}, none} || {Where, Model} <- Faults]),
    [Now + Ms].

errors() ->
    #{px := X, py := Y, vx := Vx, vy := Vy} = copter_sut:state(?COPTER, true),
    #{px := Px, py := Py, vx := Pvx, vy := Pvy} = copter_sut:state(?COPTER, perceived),
    {hypot(X - Px, Y - Py), hypot(Vx - Pvx, Vy - Pvy)}.

hypot(A, B) -> math:sqrt(A * A + B * B).

%% ---- holding a position -------------------------------------------------------------------------

%% @doc A pilot holds the origin from what is perceived, while each range has Gaussian noise of that
%% deviation (m). The pilot decides every 20 ms.
-spec hold(Noise :: float(), Seed :: non_neg_integer(), Ms :: pos_integer()) -> [held()].
hold(Noise, Seed, End) ->
    ok = start(#{}),
    ok = copter_sut:arm([
        {{probe, iolist_to_binary(io_lib:format("RangeId~bAnch~b", [?COPTER, Anchor]))},
            {noise_gauss, Noise}, Seed + Anchor}
     || {Anchor, _, _, _} <- copter_world:anchors(open)
    ]),
    held(0, End, copter_pilot:start()).

held(Now, End, _Pilot) when Now > End ->
    [];
held(Now, End, Pilot) ->
    #{px := X, py := Y} = copter_sut:state(?COPTER, true),
    #{px := Px, py := Py} = Perceived = copter_sut:state(?COPTER, perceived),
    {{Roll, Pitch}, Next} = copter_pilot:hold(Perceived, ?SAMPLE_MS / 1000, Pilot),
    ok = copter_sut:command(?COPTER, Roll, Pitch, 0.0),
    ok = copter_sut:iterate(?SAMPLE_MS),
    [{Now, hypot(X, Y), hypot(Px, Py)} | held(Now + ?SAMPLE_MS, End, Next)].

%% ---- what is read off ---------------------------------------------------------------------------

%% @doc How long after From the position error stays below Limit until Until; never, or ms.
-spec settled([sample()], From :: integer(), Until :: integer(), Limit :: float()) ->
    non_neg_integer() | never.
settled(Samples, From, Until, Limit) ->
    Within = [S || {Ms, _, _, _} = S <- Samples, Ms >= From, Ms =< Until],
    case [Ms || {Ms, Error, _, _} <- Within, Error >= Limit] of
        [] -> 0;
        Above ->
            {LastSample, _, _, _} = lists:last(Within),
            case lists:last(Above) of
                LastSample -> never;
                Last -> Last + ?SAMPLE_MS - From
            end
    end.

%% @doc The mean position error in a span of time, m.
-spec mean_error([sample()], integer(), integer()) -> float().
mean_error(Samples, From, Until) ->
    mean([Error || {Ms, Error, _, _} <- Samples, Ms >= From, Ms < Until]).

mean(Values) -> lists:sum(Values) / length(Values).

%% @doc The quadcopter simulator as the system under test of the calling process.
%%
%% Each process has one simulation: begin_test/1 makes it when there is none, and from then on
%% resets it. It ends with its process. What the simulator refuses is an error
%% `{csim, Function, Code, Sentence}'.
%%
%% Environment of the application: `transport', and `library', the file where it is not to be
%% searched for.
-module(copter_sut).

-export([begin_test/1, begin_flight/1, settings/1, stop/0, default_transport/1, library/0]).
-export([add_copter/3, add_copter/4, remove_copter/1, copters/0, command/4]).
-export([arm/1, arm_named/5, clear_faults/0, clear_faults/1, iterate/1, run/1]).
-export([set/2, set/3, value_of/1, configure/1]).
-export([collisions/0, parameters/0, anchors/0]).
-export([time_us/0, state/2, bits/1, station/1, closest/0]).
-export([snapshot/0, restore/1, release/1]).
-export([instance/0]).
-export_type([outcome/0, collision/0, objective/0, view/0, closest/0, state/0, settings/0]).

-type objective() :: gap | stop | late.
%% What a flight begins with.
-type settings() :: #{
    dt_us := pos_integer(),
    %% messages, and one anchor, every so many steps
    its_div := non_neg_integer(),
    anchor_div := non_neg_integer(),
    %% parameters and gains that differ from the simulator's own; choices may have their names
    values := #{atom() => number() | binary()},
    lines := [copter_world:line()],
    anchors := [copter_world:anchor()]
}.
-type view() :: true | perceived.
-type outcome() :: ok | {collision, collision()}.
-type collision() :: #{
    kind := copter | terrain,
    %% the copters, or the copter and the line
    ids := [non_neg_integer()],
    t_us := non_neg_integer(),
    %% m
    point := {float(), float()}
}.
-type closest() :: #{
    %% m; inf when there was nothing to come close to
    value := number() | inf | nan,
    t_us := non_neg_integer(),
    kind := copter | terrain,
    ids := [non_neg_integer()]
}.
%% px, py, pz, vx, vy, roll, pitch, yaw, e_r, e_p of csim_state
-type state() :: #{atom() => float()}.

-define(LIBRARY, "libcoptersim.so").
%% Not less than the structures have; csim_new compares the first.
-define(OPTIONS_BYTES, 40).
-define(COLLISION_BYTES, 48).
-define(MOST_COLLISIONS, 100).
-define(STATE_BYTES, 80).
-define(STATION_BYTES, 64).
-define(COLUMNS_BYTES, 128).
-define(GAINS_BYTES, 88).
-define(US_PER_MS, 1000).

%% ---- start and stop ---------------------------------------------------------------------------

%% @doc An empty sky in the world that the options describe.
-spec begin_test(copter_options:options()) -> ok.
begin_test(Options) ->
    Sut = instance(Options),
    prepare(Sut, settings(Options), fun(Sim) -> [watch(Sim, Options)] end).

%% @doc The same from settings, without an objective.
-spec begin_flight(settings()) -> ok.
begin_flight(Settings) ->
    prepare(instance(#{threads => 1, brute_force => false}), Settings, fun(_) -> [] end).

%% @doc What the options say of a flight.
-spec settings(copter_options:options()) -> settings().
settings(#{dt_us := Dt, its_ms := Its, anchor_ms := Anchor, world := World} = Options) ->
    #{
        dt_us => Dt,
        its_div => Its * ?US_PER_MS div Dt,
        anchor_div => Anchor * ?US_PER_MS div Dt,
        values => copter_options:values(Options),
        lines => copter_world:lines(World),
        anchors => copter_world:anchors(World)
    }.

prepare(#{lib := Lib, sim := Sim} = Sut, Settings, Besides) ->
    _ = put(?MODULE, maps:merge(Sut, maps:with([dt_us, its_div, anchor_div, anchors], Settings))),
    Calls = parameters(Sim, Settings) ++ world(Sim, Settings) ++ Besides(Sim),
    checked(Lib, [{csim_reset, [Sim]} | Calls]).

world(Sim, #{lines := Lines, anchors := Anchors}) ->
    [{csim_add_line, [Sim, Id, X1, Y1, X2, Y2]} || {Id, {X1, Y1}, {X2, Y2}} <- Lines] ++
        [{csim_add_anchor, [Sim, Id, X, Y, Z]} || {Id, X, Y, Z} <- Anchors].

%% The configuration first: the others change it.
parameters(Sim, #{values := Values}) ->
    {First, Rest} = lists:partition(fun({Name, _}) -> Name =:= configuration end,
                                    maps:to_list(Values)),
    [parameter(Sim, Name, Value) || {Name, Value} <- First ++ Rest].

parameter(Sim, configuration, Name) -> {csim_configure, [Sim, Name]};
parameter(Sim, Name, Choice) when is_binary(Choice) ->
    {csim_set_text, [Sim, atom_to_binary(Name), Choice]};
parameter(Sim, Name, Value) ->
    {csim_set, [Sim, atom_to_binary(Name), float(Value)]}.

watch(Sim, #{objective := Objective, horizon_ms := Horizon}) ->
    Kind = maps:get(Objective, #{gap => 'CSIM_GAP', stop => 'CSIM_STOP', late => 'CSIM_LATE'}),
    {csim_watch_closeness, [Sim, Kind, Horizon * ?US_PER_MS]}.

instance(#{threads := Threads, brute_force := Brute}) ->
    Wanted = {Threads, Brute},
    case get(?MODULE) of
        undefined ->
            Lib = load(),
            with_simulation(Wanted, with_buffers(#{lib => Lib}));
        #{lib := Lib} = Sut ->
            case cb:last_crash(Lib) of
                none ->
                    with_simulation(Wanted, Sut);
                _ ->
                    ok = stop(),
                    instance(#{threads => Threads, brute_force => Brute})
            end
    end.

with_simulation(Kind, #{kind := Kind} = Sut) ->
    Sut;
with_simulation({Threads, Brute} = Kind, #{lib := Lib} = Sut) ->
    _ = [cb:call(Lib, csim_free, [Old]) || {ok, Old} <- [maps:find(sim, Sut)]],
    Given = #{
        size => ?OPTIONS_BYTES,
        faults => null,
        seed => 1,
        threads => Threads,
        brute_force => Brute,
        build => null
    },
    case cb:call(Lib, csim_new, [Given]) of
        null -> refused(Lib, csim_new, null);
        Sim -> Sut#{kind => Kind, sim => Sim, faults => cb:call(Lib, csim_faults, [Sim])}
    end.

with_buffers(#{lib := Lib} = Sut) ->
    Sut#{
        collision => buffer(Lib, csim_collision, ?COLLISION_BYTES),
        closest => buffer(Lib, csim_closeness, ?COLLISION_BYTES),
        state => buffer(Lib, csim_state, ?STATE_BYTES),
        station => buffer(Lib, csim_station, ?STATION_BYTES),
        gains => buffer(Lib, csim_gains, ?GAINS_BYTES),
        columns => buffer(Lib, csim_columns_view, ?COLUMNS_BYTES),
        count => cb:create_array(Lib, size_t, [0]),
        number => cb:create_array(Lib, double, [0.0])
    }.

%% Zeroed room for one structure, not smaller than it is.
buffer(Lib, Type, Bytes) ->
    {ptr, _, At} = cb:create_array(Lib, 'unsigned char', binary:copy(<<0>>, Bytes)),
    {ptr, Type, At}.

load() ->
    Options = [
        {so, library()},
        {transport, application:get_env(copter_eqc, transport, nif)},
        %% csim_reset is the reset; begin_test/1 calls it.
        {reset, {calls, []}},
        {dirty, [csim_run]},
        {module, false}
    ],
    case cb:start(coptersim, Options) of
        {ok, Lib} -> Lib;
        {error, Reason} -> error({cb, Reason})
    end.

%% @doc Ends the calling process's simulation.
-spec stop() -> ok.
stop() ->
    case erase(?MODULE) of
        undefined -> ok;
        #{lib := Lib} -> cb:stop(Lib)
    end.

%% @doc The transport where no runner asks for one. The shipped models ask for nif.
-spec default_transport(nif | port) -> ok.
default_transport(Transport) -> application:set_env(copter_eqc, transport, Transport).

%% @doc The library file: of FAULTCHECK_LIB_DIR, of the clone, or of an installation.
-spec library() -> file:filename().
library() ->
    case application:get_env(copter_eqc, library) of
        {ok, File} -> File;
        undefined -> cb_library:find(?LIBRARY, ?MODULE)
    end.

%% ---- commands ---------------------------------------------------------------------------------

%% @doc A copter at rest, metres; it looks along x, or in the direction of the yaw, degrees.
-spec add_copter(non_neg_integer(), float(), float()) -> ok.
add_copter(Id, X, Y) -> add_copter(Id, X, Y, 0.0).

-spec add_copter(non_neg_integer(), float(), float(), Yaw :: float()) -> ok.
add_copter(Id, X, Y, Yaw) -> one(csim_add_copter, [Id, X, Y, Yaw]).

%% @doc Takes a copter away.
-spec remove_copter(non_neg_integer()) -> ok.
remove_copter(Id) -> one(csim_remove_copter, [Id]).

%% @doc The ids of all copters, ascending.
-spec copters() -> [non_neg_integer()].
copters() ->
    #{lib := Lib, columns := Columns} = get(?MODULE),
    ok = one(csim_columns, ['CSIM_TRUE', Columns]),
    case cb:read(Lib, Columns, 1) of
        [#{count := 0}] -> [];
        [#{count := Count, id := Ids}] -> cb:read(Lib, Ids, Count)
    end.

%% @doc The pilot's command of a copter from now on, each -1..1.
-spec command(non_neg_integer(), float(), float(), float()) -> ok.
command(Id, Roll, Pitch, Yaw) -> one(csim_command, [Id, Roll, Pitch, Yaw, 0.0]).

%% @doc Arms faults; the first that is refused ends it.
-spec arm([copter_fault:arming()]) -> ok | {error, faultcheck_inject:reason()}.
arm([]) ->
    ok;
arm([{Where, Fault, Seed} | Rest]) ->
    #{lib := Lib, faults := Faults} = get(?MODULE),
    case faultcheck_inject:arm(Lib, Faults, Where, Fault) of
        {ok, Id} ->
            _ = [0 = cb:call(Lib, fc_seed_fault, [Faults, Id, Seed]) || Seed =/= none],
            arm(Rest);
        {error, _} = Error ->
            Error
    end.

%% @doc Arms a fault by the names of its model and parameters (fc_named.h); a seed of its own
%% random stream, or none.
-spec arm_named(
    faultcheck_inject:where(),
    Model :: binary(),
    [{Name :: binary(), number() | binary()}],
    faultcheck_fault:trigger(),
    Seed :: non_neg_integer() | none
) -> ok | {error, faultcheck_inject:reason()}.
arm_named({Kind, Place}, Model, Parameters, Trigger, Seed) ->
    #{lib := Lib, faults := Faults} = get(?MODULE),
    Function = maps:get(Kind, #{probe => fc_arm_named, channel => fc_channel_arm_named}),
    Arguments = [argument(P) || P <- Parameters],
    Args = [Faults, Place, Model, Arguments, length(Arguments)],
    case faultcheck_inject:attempt(Lib, Function, Args) of
        {Id, _} when Id > 0 ->
            _ = [0 = cb:call(Lib, fc_seed_fault, [Faults, Id, Seed]) || Seed =/= none],
            triggered(Lib, Faults, Id, Trigger);
        {_, Error} ->
            Error()
    end.

argument({Name, Text}) when is_binary(Text) -> #{name => Name, text => Text, number => 0.0};
argument({Name, Number}) -> #{name => Name, text => null, number => float(Number)}.

%% A fault whose trigger is refused does not stay armed.
triggered(Lib, Faults, Id, Trigger) ->
    case faultcheck_inject:trigger(Lib, Faults, Id, Trigger) of
        ok ->
            ok;
        {error, _} = Error ->
            ok = faultcheck_inject:remove(Lib, Faults, Id),
            Error
    end.

%% @doc Disarms all faults.
-spec clear_faults() -> ok.
clear_faults() -> clear_faults(all).

%% @doc Disarms those of one probe or channel.
-spec clear_faults(faultcheck_inject:where() | all) -> ok.
clear_faults(Where) ->
    #{lib := Lib, faults := Faults} = get(?MODULE),
    faultcheck_inject:remove_all(Lib, Faults, Where).

%% @doc Lets time pass, up to the first collision. Milliseconds, of which whole steps are made.
-spec iterate(pos_integer()) -> outcome().
iterate(Ms) ->
    #{dt_us := Dt} = get(?MODULE),
    run(Ms * ?US_PER_MS div Dt).

%% @doc The same for a number of steps.
-spec run(Steps :: non_neg_integer()) -> outcome().
run(Steps) ->
    #{dt_us := Dt, its_div := Its, anchor_div := Anchor, lib := Lib, sim := Sim} = Sut =
        get(?MODULE),
    case cb:call(Lib, csim_run, [Sim, Steps, Dt, Its, Anchor]) of
        0 -> after_run(cb:call(Lib, csim_status, [Sim]), Sut);
        Code -> refused(Lib, csim_run, Code)
    end.

after_run('CSIM_RUNNING', _Sut) -> ok;
after_run('CSIM_COLLIDED', Sut) -> {collision, collision(Sut)}.

%% The first one.
collision(#{collision := Buffer} = Sut) ->
    [First | _] = collisions(Buffer, 1, Sut),
    First.

%% The call says that there are more than fit by a code of its own.
collisions(Buffer, Room, #{lib := Lib, sim := Sim, count := Count}) ->
    ok = cb:set(Lib, [Count, 0], Room),
    Code = cb:call(Lib, csim_collisions, [Sim, Buffer, Count]),
    lists:member(Code, [0, -5]) orelse refused(Lib, csim_collisions, Code),
    [There] = cb:read(Lib, Count, 1),
    [
        #{kind => kind(Kind), ids => [Id, Other], t_us => Time, point => {X, Y}}
     || #{kind := Kind, id := Id, other := Other, t_us := Time, x := X, y := Y} <-
            cb:read(Lib, Buffer, min(There, Room))
    ].

%% @doc All collisions since the start, at most 100, in the order in which csim.h tells them.
-spec collisions() -> [collision()].
collisions() ->
    #{lib := Lib} = Sut = get(?MODULE),
    Buffer = buffer(Lib, csim_collision, ?MOST_COLLISIONS * ?COLLISION_BYTES),
    try
        collisions(Buffer, ?MOST_COLLISIONS, Sut)
    after
        {ptr, _, At} = Buffer,
        cb:free(Lib, {ptr, 'unsigned char', At})
    end.

kind('CSIM_TERRAIN') -> terrain;
kind('CSIM_COPTER') -> copter.

%% @doc A parameter or gain, of all copters; a choice may have its name.
-spec set(atom(), number() | binary()) -> ok.
set(Name, Choice) when is_binary(Choice) -> one(csim_set_text, [atom_to_binary(Name), Choice]);
set(Name, Value) -> one(csim_set, [atom_to_binary(Name), float(Value)]).

%% @doc A gain of one copter.
-spec set(non_neg_integer(), atom(), number()) -> ok.
set(Id, Name, Value) ->
    #{lib := Lib, gains := Buffer} = get(?MODULE),
    ok = one(csim_get_gains, [Id, Buffer]),
    ok = cb:set(Lib, [Buffer, 0, Name], float(Value)),
    one(csim_set_gains, [Id, Buffer]).

%% @doc The value of a parameter or gain.
-spec value_of(atom()) -> number().
value_of(Name) ->
    #{lib := Lib, number := Buffer} = get(?MODULE),
    ok = one(csim_get, [atom_to_binary(Name), Buffer]),
    [Value] = cb:read(Lib, Buffer, 1),
    Value.

%% @doc The ids of the anchors, in the order of their use.
-spec anchors() -> [non_neg_integer()].
anchors() -> [Id || {Id, _, _, _} <- maps:get(anchors, get(?MODULE))].

%% @doc All parameters and gains by name, in the simulator's order.
-spec parameters() -> [{binary(), number()}].
parameters() ->
    #{lib := Lib} = get(?MODULE),
    [
        begin
            [#{name := Name}] = cb:read(Lib, cb:call(Lib, csim_param_at, [N]), 1),
            Text = cb:cstring(Lib, Name),
            {Text, value_of(binary_to_atom(Text, utf8))}
        end
     || N <- lists:seq(0, cb:call(Lib, csim_param_count, []) - 1)
    ].

%% @doc All parameters to those of a set that the simulator knows by name.
-spec configure(atom()) -> ok.
configure(Name) -> one(csim_configure, [atom_to_binary(Name)]).

%% ---- what can be seen -------------------------------------------------------------------------

%% @doc Simulated time.
-spec time_us() -> non_neg_integer().
time_us() ->
    #{lib := Lib, sim := Sim} = get(?MODULE),
    cb:call(Lib, csim_time, [Sim]).

%% @doc The state of a copter.
-spec state(non_neg_integer(), view()) -> state().
state(Id, View) ->
    #{lib := Lib, state := Buffer} = get(?MODULE),
    ok = one(csim_get_state, [Id, view(View), Buffer]),
    [State] = cb:read(Lib, Buffer, 1),
    State.

%% @doc All states, copters in ascending order, as the bytes in memory.
-spec bits(view()) -> [{non_neg_integer(), binary()}].
bits(View) ->
    #{lib := Lib, state := Buffer} = get(?MODULE),
    [
        begin
            ok = one(csim_get_state, [Id, view(View), Buffer]),
            {Id, cb:read_bytes(Lib, Buffer, ?STATE_BYTES)}
        end
     || Id <- copters()
    ].

view(true) -> 'CSIM_TRUE';
view(perceived) -> 'CSIM_PERCEIVED'.

%% @doc The station of a copter: members of csim_station.
-spec station(non_neg_integer()) -> #{atom() => term()}.
station(Id) ->
    #{lib := Lib, station := Buffer} = get(?MODULE),
    ok = one(csim_override, [Id, Buffer]),
    [Station] = cb:read(Lib, Buffer, 1),
    Station.

%% @doc How near to a collision it came since begin_test/1.
-spec closest() -> closest().
closest() ->
    #{lib := Lib, closest := Buffer} = get(?MODULE),
    ok = one(csim_closest, [Buffer]),
    [#{value := Value, t_us := Time, kind := Kind, id := Id, other := Other}] =
        cb:read(Lib, Buffer, 1),
    #{value => Value, t_us => Time, kind => kind(Kind), ids => [Id, Other]}.

%% ---- snapshots --------------------------------------------------------------------------------

%% @doc Everything as it is now.
-spec snapshot() -> cb:ptr().
snapshot() ->
    #{lib := Lib, sim := Sim} = get(?MODULE),
    case cb:call(Lib, csim_save, [Sim]) of
        null -> refused(Lib, csim_save, null);
        Snapshot -> Snapshot
    end.

%% @doc Back to a snapshot of this process's simulation, any number of times.
-spec restore(cb:ptr()) -> ok.
restore(Snapshot) -> one(csim_restore, [Snapshot]).

%% @doc Forgets a snapshot.
-spec release(cb:ptr()) -> ok.
release(Snapshot) ->
    #{lib := Lib} = get(?MODULE),
    cb:call(Lib, csim_release, [Snapshot]).

%% @doc The library, the simulation, its faults and its buffers, for those who look at it closely.
-spec instance() -> #{lib := cb:lib(), sim := cb:ptr(), faults := cb:ptr(), atom() => term()}.
instance() -> get(?MODULE).

%% ---- calls ------------------------------------------------------------------------------------

one(Function, Args) ->
    #{lib := Lib, sim := Sim} = get(?MODULE),
    case cb:call(Lib, Function, [Sim | Args]) of
        0 -> ok;
        Code -> refused(Lib, Function, Code)
    end.

checked(Lib, Calls) ->
    Codes = cb:call_batch(Lib, Calls),
    case [{F, Code} || {{F, _}, Code} <- lists:zip(Calls, Codes), Code =/= 0] of
        [] -> ok;
        %% the sentence is that of the last one refused
        Refused -> {Function, Code} = lists:last(Refused), refused(Lib, Function, Code)
    end.

-spec refused(cb:lib(), atom(), term()) -> no_return().
refused(Lib, Function, Code) ->
    Sentence = cb:cstring(Lib, cb:call(Lib, csim_last_error_text, [])),
    error({csim, Function, Code, Sentence}).

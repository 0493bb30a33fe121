%% @doc The quadcopter simulator as the system under test of the calling process.
%%
%% Each process has one simulation: begin_test/1 makes it when there is none, and from then on
%% resets it. It ends with its process. What the simulator refuses is an error
%% `{csim, Function, Code, Sentence}'.
%%
%% Environment of the application: `transport', and `library', the file where it is not to be
%% searched for.
-module(copter_sut).

-export([begin_test/1, stop/0, default_transport/1, library/0]).
-export([add_copter/3, add_copter/4, copters/0, command/4, arm/1, clear_faults/0, iterate/1]).
-export([set/2, value_of/1, configure/1]).
-export([time_us/0, state/2, bits/1, station/1, closest/0]).
-export([snapshot/0, restore/1, release/1]).
-export_type([outcome/0, collision/0, objective/0, view/0, closest/0, state/0]).

-type objective() :: gap | stop | late.
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
-define(STATE_BYTES, 80).
-define(STATION_BYTES, 64).
-define(COLUMNS_BYTES, 128).
-define(US_PER_MS, 1000).

%% ---- start and stop ---------------------------------------------------------------------------

%% @doc An empty sky in the world that the options describe.
-spec begin_test(copter_options:options()) -> ok.
begin_test(Options) ->
    Sut = instance(Options),
    #{lib := Lib, sim := Sim} = Sut,
    #{dt_us := Dt, its_ms := Its, anchor_ms := Anchor} = Options,
    _ = put(?MODULE, Sut#{
        dt_us => Dt,
        its_div => Its * ?US_PER_MS div Dt,
        anchor_div => Anchor * ?US_PER_MS div Dt
    }),
    Calls = parameters(Sim, Options) ++ world(Sim, Options) ++ [watch(Sim, Options)],
    checked(Lib, [{csim_reset, [Sim]} | Calls]).

world(Sim, #{world := World}) ->
    [
        {csim_add_line, [Sim, Id, X1, Y1, X2, Y2]}
     || {Id, {X1, Y1}, {X2, Y2}} <- copter_world:lines(World)
    ] ++
        [{csim_add_anchor, [Sim, Id, X, Y, Z]} || {Id, X, Y, Z} <- copter_world:anchors(World)].

parameters(Sim, Options) ->
    [
        {csim_set, [Sim, atom_to_binary(Name), float(Value)]}
     || {Name, Value} <- maps:to_list(copter_options:values(Options))
    ].

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

%% @doc Disarms all faults.
-spec clear_faults() -> ok.
clear_faults() ->
    #{lib := Lib, faults := Faults} = get(?MODULE),
    faultcheck_inject:remove_all(Lib, Faults, all).

%% @doc Lets time pass, up to the first collision. Milliseconds, of which whole steps are made.
-spec iterate(pos_integer()) -> outcome().
iterate(Ms) ->
    #{dt_us := Dt, its_div := Its, anchor_div := Anchor, lib := Lib, sim := Sim} = Sut =
        get(?MODULE),
    Steps = Ms * ?US_PER_MS div Dt,
    case cb:call(Lib, csim_run, [Sim, Steps, Dt, Its, Anchor]) of
        0 -> after_run(cb:call(Lib, csim_status, [Sim]), Sut);
        Code -> refused(Lib, csim_run, Code)
    end.

after_run('CSIM_RUNNING', _Sut) -> ok;
after_run('CSIM_COLLIDED', Sut) -> {collision, collision(Sut)}.

%% The first one. The call says that there are more by a code of its own.
collision(#{lib := Lib, sim := Sim, collision := Buffer, count := Count}) ->
    ok = cb:set(Lib, [Count, 0], 1),
    Code = cb:call(Lib, csim_collisions, [Sim, Buffer, Count]),
    lists:member(Code, [0, -5]) orelse refused(Lib, csim_collisions, Code),
    [#{kind := Kind, id := Id, other := Other, t_us := Time, x := X, y := Y}] =
        cb:read(Lib, Buffer, 1),
    #{kind => kind(Kind), ids => [Id, Other], t_us => Time, point => {X, Y}}.

kind('CSIM_TERRAIN') -> terrain;
kind('CSIM_COPTER') -> copter.

%% @doc A parameter or gain, of all copters.
-spec set(atom(), number()) -> ok.
set(Name, Value) -> one(csim_set, [atom_to_binary(Name), float(Value)]).

%% @doc The value of a parameter or gain.
-spec value_of(atom()) -> number().
value_of(Name) ->
    #{lib := Lib, number := Buffer} = get(?MODULE),
    ok = one(csim_get, [atom_to_binary(Name), Buffer]),
    [Value] = cb:read(Lib, Buffer, 1),
    Value.

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

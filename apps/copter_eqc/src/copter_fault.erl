%% @doc The realistic faults of Paper III, section 2.2: their parameters, what is armed for them.
%%
%% Parameters are integers: thousandths of degrees, metres, or of a factor; milliseconds. What is
%% armed are faults of faultcheck_fault at the simulator's probes and channels. A fault with a
%% random model has a seed of its own among its arguments, so that it stays the same whatever
%% happens to the commands around it.
-module(copter_fault).

-export([kinds/0, args/3, place/2, arming/3, title/1]).
-export_type([kind/0, place/0, arming/0]).

-type kind() ::
    misalignment | air | drift | gain | reflection | anchor
    | corruption | loss | delay | repetition | jump.
%% What a fault of a kind may be on only once.
-type place() :: {kind(), Copter :: non_neg_integer() | all, Part :: term()}.
-type arming() :: {
    faultcheck_inject:where(), faultcheck_fault:fault(), Seed :: non_neg_integer() | none
}.

-define(MESSAGE_BYTES, 92).
-define(NS_PER_MS, 1000000).
%% degrees that a drift ends at
-define(DRIFT_LIMIT, 5.0).
-define(YAW_DRIFT_LIMIT, 20.0).
%% m, the least by which a reflected signal takes the longer way
-define(LEAST_DETOUR, 0.5).

%% @doc All kinds, in the order of the table in docs/copter.md.
-spec kinds() -> [kind()].
kinds() ->
    [misalignment, air, drift, gain, reflection, anchor, corruption, loss, delay, repetition, jump].

%% @doc A few words for tables.
-spec title(kind()) -> string().
title(misalignment) -> "accelerometer misalignment";
title(air) -> "air movement";
title(drift) -> "gyroscope drift";
title(gain) -> "gyroscope gain";
title(reflection) -> "ranging reflection";
title(anchor) -> "anchor misplacement";
title(corruption) -> "message: bit flip";
title(loss) -> "message: loss";
title(delay) -> "message: delay";
title(repetition) -> "message: repetition";
title(jump) -> "position jump".

%% ---- arguments ------------------------------------------------------------------------------

%% @doc The types of the arguments, beside the copter, of a fault. Uniform over the whole range:
%% which size a realistic fault has depends on nothing that grows with a test.
-spec args(kind(), copter_options:ranges(), Anchors :: [non_neg_integer()]) -> [term()].
args(misalignment, Ranges, _) -> [tilt(), signed(limit(misalignment, Ranges), "mdeg")];
args(air, Ranges, _) ->
    {Least, Most} = limit(air, Ranges),
    [tilt(), whole(Least, Most, "mdeg"), time(100, 500), time(1000, 10000), seed()];
args(drift, Ranges, _) ->
    [proper_types:oneof([roll, pitch, yaw]), signed(limit(drift, Ranges), "mdeg/s")];
args(gain, _, _) -> [tilt(), whole(950, 1050, "1/1000")];
args(reflection, Ranges, Anchors) ->
    {Least, Most} = limit(reflection, Ranges),
    Scattered = {scattered, whole(Least, Most, "1/1000")},
    Lasting = [{lasting, time(1000, 8000)} || Ranges =:= default],
    [
        proper_types:oneof(Anchors),
        whole(500, 8000, "mm"),
        proper_types:oneof([Scattered | Lasting]),
        seed()
    ];
args(anchor, Ranges, Anchors) ->
    [
        proper_types:oneof(Anchors),
        proper_types:oneof([x, y, z]),
        signed(limit(anchor, Ranges), "mm")
    ];
args(corruption, _, _) ->
    [
        faultcheck_range:index(0, ?MESSAGE_BYTES - 1, "byte"),
        faultcheck_range:index(0, 7, "bit")
    ];
args(loss, Ranges, _) ->
    {Packets, Ms} = limit(loss, Ranges),
    [proper_types:oneof([{packets, whole(1, Packets, "packets")}, {ms, time(100, Ms)}])];
args(delay, Ranges, _) -> [time(50, limit(delay, Ranges))];
args(repetition, Ranges, _) -> [whole(1, 5, "packets"), time(50, limit(delay, Ranges))];
args(jump, Ranges, _) -> [proper_types:oneof([x, y]), signed(limit(jump, Ranges), "mm")].

limit(misalignment, default) -> 3000;
limit(misalignment, mild) -> 1000;
limit(air, default) -> {500, 4000};
limit(air, mild) -> {500, 2000};
limit(drift, default) -> 200;
limit(drift, mild) -> 50;
limit(reflection, default) -> {50, 300};
limit(reflection, mild) -> {20, 100};
limit(anchor, default) -> 200;
limit(anchor, mild) -> 100;
limit(loss, default) -> {50, 8000};
limit(loss, mild) -> {10, 600};
limit(delay, default) -> 500;
limit(delay, mild) -> 200;
limit(jump, default) -> 1500;
limit(jump, mild) -> 500.

tilt() -> proper_types:oneof([roll, pitch]).

signed(Limit, Unit) -> whole(-Limit, Limit, Unit).

whole(Least, Most, Unit) -> faultcheck_range:int(Least, Most, #{unit => Unit}).

time(Least, Most) -> whole(Least, Most, "ms").

seed() -> faultcheck_range:index(0, 16#FFFFFFFF, "seed").

%% @doc Where a fault of this kind acts: a second one there would be but another size of it.
-spec place(kind(), [term()]) -> place().
place(anchor, [Anchor, Axis, _]) -> {anchor, all, {Anchor, Axis}};
place(reflection, [Copter, Anchor | _]) -> {reflection, Copter, Anchor};
place(corruption, [Copter, Byte, Bit]) -> {corruption, Copter, {Byte, Bit}};
place(Kind, [Copter, Axis | _]) when is_atom(Axis) -> {Kind, Copter, Axis};
place(Kind, [Copter | _]) -> {Kind, Copter, none}.

%% ---- what is armed --------------------------------------------------------------------------

%% @doc What to arm for a fault with these arguments. Copters are all that there are: a misplaced
%% anchor is so for each of them.
-spec arming(kind(), [term()], Copters :: [non_neg_integer()]) -> [arming()].
arming(misalignment, [Copter, Axis, Angle], _) ->
    [{attitude(Axis, Copter), {offset, thousandths(Angle)}, none}];
arming(air, [Copter, Axis, Angle, Hold, Window, Seed], _) ->
    Most = thousandths(Angle),
    Gusts = {held_offset, -Most, Most, Hold * ?NS_PER_MS},
    [{attitude(Axis, Copter), {Gusts, during(Window)}, Seed}];
arming(drift, [Copter, Axis, Rate], _) ->
    Limit =
        case Axis of
            yaw -> ?YAW_DRIFT_LIMIT;
            _ -> ?DRIFT_LIMIT
        end,
    [{attitude(Axis, Copter), {drift_timed, thousandths(Rate), Limit}, none}];
arming(gain, [Copter, Axis, Factor], _) ->
    [{attitude(Axis, Copter), {amplification, thousandths(Factor)}, none}];
arming(reflection, [Copter, Anchor, Most, When, Seed], _) ->
    Trigger =
        case When of
            {scattered, Share} -> [{random, thousandths(Share)}];
            {lasting, Ms} -> during(Ms)
        end,
    Detour = {random_offset, ?LEAST_DETOUR, thousandths(Most)},
    [{probe(["RangeId", Copter, "Anch", Anchor]), {Detour, Trigger}, Seed}];
arming(anchor, [Anchor, Axis, Offset], Copters) ->
    Prefix = "Anch" ++ capital(Axis) ++ "Id",
    [
        {probe([Prefix, Copter, "Anch", Anchor]), {offset, thousandths(Offset)}, none}
     || Copter <- Copters
    ];
arming(corruption, [Copter, Byte, Bit], _) ->
    [{channel(Copter), {corruption, Byte, Bit}, none}];
arming(loss, [Copter, {packets, N}], _) ->
    [{channel(Copter), {drop, N}, none}];
arming(loss, [Copter, {ms, Ms}], _) ->
    [{channel(Copter), {lose, during(Ms)}, none}];
arming(delay, [Copter, Ms], _) ->
    [{channel(Copter), {delay, {ns, Ms * ?NS_PER_MS}}, none}];
arming(repetition, [Copter, Times, Ms], _) ->
    [
        {channel(Copter), {delay, {ns, Ms * ?NS_PER_MS}}, none},
        {channel(Copter), {repeat, Times}, none}
    ];
%% The simulator applies the probe in place, so one step moves the copter for good.
arming(jump, [Copter, Axis, Offset], _) ->
    Id = probe(["P", atom_to_list(Axis), "Id", Copter]),
    [{Id, {{offset, thousandths(Offset)}, [{for, 1}]}, none}].

during(Ms) -> [{time, 0, Ms * ?NS_PER_MS}].

attitude(Axis, Copter) -> probe([string:titlecase(atom_to_list(Axis)), "Id", Copter]).

channel(Copter) -> {channel, name(["ITS_DATA", Copter])}.

probe(Parts) -> {probe, name(Parts)}.

name(Parts) -> list_to_binary([text(P) || P <- Parts]).

text(N) when is_integer(N) -> integer_to_list(N);
text(Text) -> Text.

capital(Axis) -> string:uppercase(atom_to_list(Axis)).

thousandths(N) -> N / 1000.

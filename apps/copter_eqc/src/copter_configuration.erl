%% @doc Named sets of parameters: the original's, each counter-measure alone, and the hardened one.
%%
%% Papers II and III name the counter-measures; docs/copter.md tells what each brings, measured by
%% the campaign. Values are those of docs/coptersim.md; a choice is the number of the choice.
-module(copter_configuration).

-export([names/0, measures/0, title/1, values/1, its_ms/1, gain_names/0]).
-export_type([name/0]).

-type name() ::
    default | radii | soft_gains | small_corrections | gate_median | gate_never_accept
    | gate_majority | comfort_error | risk_age | braking | strong_override | plausibility | crc
    | e2e | fast_its | hardened.

-define(ITS_MS, 100).
-define(FAST_ITS_MS, 50).

%% @doc All of them.
-spec names() -> [name()].
names() -> [default] ++ measures() ++ [hardened].

%% @doc The counter-measures.
-spec measures() -> [name()].
measures() ->
    [
        radii, soft_gains, small_corrections, gate_median, gate_never_accept, gate_majority,
        comfort_error, risk_age, braking, strong_override, plausibility, crc, e2e, fast_its
    ].

%% @doc A few words for tables.
-spec title(name()) -> string().
title(default) -> "the original's";
title(radii) -> "larger zones";
title(soft_gains) -> "lower gains";
title(small_corrections) -> "small corrections";
title(gate_median) -> "median gate";
title(gate_never_accept) -> "gate never gives in";
title(gate_majority) -> "majority gate";
title(comfort_error) -> "comfort zone by confidence";
title(risk_age) -> "risk grows with age";
title(braking) -> "room to brake";
title(strong_override) -> "stronger override";
title(plausibility) -> "plausibility of messages";
title(crc) -> "CRC of messages";
title(e2e) -> "E2E of messages";
title(fast_its) -> "messages every 50 ms";
title(hardened) -> "hardened".

%% @doc Parameters and gains that differ from the simulator's own.
-spec values(name()) -> #{atom() => number()}.
values(default) -> #{};
values(radii) -> #{comfort_radius => 0.9, base_radius => 1.5};
values(soft_gains) -> #{pos_p => 0.3, vel_p => 0.2};
values(small_corrections) -> #{max_corr => 0.07};
values(gate_median) -> #{gate => 1};
values(gate_never_accept) -> #{gate => 2};
values(gate_majority) -> #{gate => 3};
values(comfort_error) -> #{comfort_error_gain => 1.0};
values(risk_age) -> #{risk_age_gain => 1.0};
values(braking) -> #{brake_gain => 2.0};
values(strong_override) -> #{override_gain => 0.6};
values(plausibility) -> #{plausibility => 1};
values(crc) -> #{protect => 1};
values(e2e) -> #{protect => 2};
values(fast_its) -> #{};
values(hardened) ->
    #{
        comfort_radius => 1.1,
        base_radius => 1.5,
        max_corr => 0.07,
        brake_gain => 2.0,
        override_gain => 0.6,
        silence_us => 300000
    }.

%% @doc How often each copter tells the others where it is.
-spec its_ms(name()) -> pos_integer().
its_ms(fast_its) -> ?FAST_ITS_MS;
its_ms(hardened) -> ?FAST_ITS_MS;
its_ms(_) -> ?ITS_MS.

%% @doc Which of the values are gains of the estimator: scenarios have a place of their own for
%% them.
-spec gain_names() -> [atom()].
gain_names() ->
    [pos_p, pos_i, pos_d, vel_p, vel_i, vel_d, acc_p, acc_i, acc_d, max_corr, max_tilt].

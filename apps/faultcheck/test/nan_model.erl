%% A model whose objective is no number once its command `spoil' was run.
-module(nan_model).

-include("faultcheck.hrl").

initial_state() -> 1.0.

spoil_args(_) -> [].
spoil() -> ok.
spoil_next(_, _, []) -> nan.

idle_args(_) -> [].
idle() -> ok.

weight(_, spoil) -> 1;
weight(_, idle) -> 20.

objective(Value) -> {Value, now, none}.

%% Two things are placed before anything moves.
-module(setting_model).

-include("faultcheck.hrl").

initial_state() -> 0.

setting() -> [place].

place_pre(N) -> N < 2.
place_args(N) -> [N, faultcheck_range:int(0, 100)].
place_pre(N, [Id, _]) -> N < 2 andalso Id =:= N.
place(_, _) -> ok.
place_next(N, _, [_, _]) -> N + 1.

move_pre(N) -> N =:= 2.
move_args(_) -> [faultcheck_range:int(-9, 9)].
move(_) -> ok.

objective(_) -> {1, now, none}.

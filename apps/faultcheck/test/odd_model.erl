%% Commands that go wrong in every way a command can, and arguments of every kind.
-module(odd_model).

-include("faultcheck.hrl").

-export([reset/0]).

reset() -> ok.

initial_state() -> #{ran => []}.

weight(_, never) -> 0;
weight(_, _) -> 1.

faults() -> [crash].

ran(S, Name) -> S#{ran := [Name | maps:get(ran, S)]}.

fine_args(_) -> [integer()].
fine(X) -> X + 1.
fine_next(S, _, [_]) -> ran(S, fine).
fine_req(_, [_], _) -> ['REQ-1'].

use_pre(S) -> lists:member(fine, maps:get(ran, S)).
use_args(_) -> [integer()].
use(X) -> {used, X}.

never_args(_) -> [].
never() -> ok.

even_args(_) -> [integer(0, 9)].
even_pre(_, [N]) -> N rem 2 =:= 0.
even(N) -> N.

%% How it goes wrong is its argument; outside the tests below it never does.
crash_args(_) -> [none].
crash(none) -> ok;
crash({raise, Class, Reason}) -> erlang:raise(Class, Reason, []);
crash(Other) -> Other.
crash_pre(_, [pre_raises]) -> error(pre);
crash_pre(_, [pre_false]) -> false;
crash_pre(_, _) -> true.
crash_post(_, [post_raises], _) -> error(post);
crash_post(_, [post_explains], _) -> {1, '/=', 2};
crash_post(_, [post_false], _) -> false;
crash_post(_, _, _) -> true.
crash_next(_, _, [next_raises]) -> error(next);
crash_next(S, _, _) -> S.

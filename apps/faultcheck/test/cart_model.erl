%% A cart on rails in plain Erlang, for tests of the guided search: it is pushed to the left or to
%% the right, rolls on, and must not come to the end of the rails. Pushes in one direction are rare
%% by chance. With the fault `ice' it slows down less.
-module(cart_model).

-include("faultcheck.hrl").

-export([reset/0, reset/1, cart/0]).

-record(st, {ice = false}).

reset() -> reset(100.0).

%% The rails end that far from the start.
reset(End) ->
    put(cart, #{x => 0.0, v => 0.0, t => 0.0, drag => 0.8, 'end' => End, nearest => {End, 0.0}}),
    ok.

cart() -> get(cart).

initial_state() -> #st{}.

weight(_, ice) -> 1;
weight(_, _) -> 4.

faults() -> [ice].

%% ---- push: changes the speed
push_args(_) -> [faultcheck_range:real(-10, 10, #{unit => "m/s"})].
push(Speed) ->
    #{v := V} = Cart = get(cart),
    put(cart, Cart#{v := V + Speed}),
    ok.

%% ---- ice: less friction from now on, once
ice_pre(#st{ice = Ice}) -> not Ice.
ice_args(_) -> [].
ice() ->
    put(cart, (get(cart))#{drag := 0.9}),
    ok.
ice_next(S, _, []) -> S#st{ice = true}.

%% ---- roll: time goes by
roll_args(_) -> [faultcheck_range:int(1, 10, #{unit => "steps", boundary => false})].
roll(Steps) ->
    put(cart, step(Steps, get(cart))),
    abs(maps:get(x, get(cart))).
roll_post(_, _, X) -> X < maps:get('end', get(cart)).
roll_duration([Steps]) -> Steps / 10.

step(0, Cart) ->
    Cart;
step(Left, #{x := X, v := V, t := T, drag := Drag, nearest := {Nearest, _} = Before} = Cart) ->
    NewX = X + V / 10,
    Room = maps:get('end', Cart) - abs(NewX),
    After =
        case Room < Nearest of
            true -> {Room, T + 0.1};
            false -> Before
        end,
    step(Left - 1, Cart#{x := NewX, v := V * Drag, t := T + 0.1, nearest := After}).

%% ---- for the search
objective(_) ->
    {Room, Time} = maps:get(nearest, get(cart)),
    {Room, {time, Time}, side(maps:get(x, get(cart)))}.

side(X) when X < 0 -> left;
side(_) -> right.

snapshot() ->
    Ref = make_ref(),
    put({cart, Ref}, get(cart)),
    Ref.
restore(Ref) ->
    #{} = Cart = get({cart, Ref}),
    put(cart, Cart),
    ok.
release(Ref) ->
    #{} = erase({cart, Ref}),
    ok.

%% The model of c_src/ring.c is the list of the items in it.
-module(prop_ring).
-include_lib("faultcheck/include/faultcheck.hrl").

prop_ring() ->
    ?SETUP(fun() -> {ok, Ring} = cb:start(ring, [{c_src, "c_src/ring.c"}]),
                    fun() -> cb:stop(Ring) end end,
           ?FORALL(Commands, commands(?MODULE), begin
               ok = cb:restart(ring),
               {_, _, Result} = run_commands(?MODULE, Commands),
               Result =:= ok
           end)).

initial_state() -> [].

%% Adding answers 1, or 0 when three are in it.
add_args(_Items) -> [integer(0, 99)].
add(Item) -> cb:call(ring, ring_add, [Item]).
add_next(Items, _Result, [Item]) -> lists:sublist(Items ++ [Item], 3).
add_post(Items, [_Item], Result) -> Result =:= (if length(Items) < 3 -> 1; true -> 0 end).

%% Taking answers the oldest item, or -1 when there is none.
take_args(_Items) -> [].
take() -> cb:call(ring, ring_take, []).
take_next(Items, _Result, []) -> lists:nthtail(min(1, length(Items)), Items).
take_post(Items, [], Result) -> Result =:= hd(Items ++ [-1]).

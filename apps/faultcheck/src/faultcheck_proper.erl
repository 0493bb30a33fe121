%% @doc Every internal of PropEr that is relied on, in one place.
%%
%% The internals are the same in PropEr 1.2 and 1.5:
%%   proper_types:new_type/2, cook_outer/1, is_instance/2, is_type/1, find_prop/2, subtype/2;
%%   integer/2 and float/2 keep their limits as the property env, {Low, High};
%%   proper_gen:safe_generate/1, clean_instance/1;
%%   proper_shrink:shrink/3, number_shrinker/4;  the tuple {'$used', Parts, Instance}, of
%%   which cleaning keeps Instance;  the state {inc, Last, Inc, OverLimit} of the number
%%   shrinker, found as the last element of the shrinker states around it;
%%   proper:global_state_init_size_seed/2 and global_state_erase/0.
%% faultcheck_proper_tests has a test for each, so that a PropEr that differs is noticed.
-module(faultcheck_proper).

-export([new_type/4, integer_type/3, resized/2, with_limits/2, limits/1]).
-export([generate/1, fast_generate/1, clean/1, with_side/2, side/1, cook/1, is_instance/2]).
-export([shrink/3, shrink_number/4, number_state/1, set_number/2, end_number/1]).
-export([with_state/3, size/0, preserving_random/2]).
-export_type([type/0, imm/0, shrink_state/0, seed/0]).

%% Opaque to us; PropEr's own types are too narrow for Dialyzer here.
-type type() :: term().
-type imm() :: term().
-type shrink_state() :: term().
-type seed() :: {non_neg_integer(), non_neg_integer(), non_neg_integer()}.

%% @doc A type with its own generator, membership test, shrinker and, for targeted
%% properties of PropEr 1.5, neighbourhood function.
%%
%% The kind is an atom of its own: with a kind PropEr knows it would add its own shrinkers.
-spec new_type(fun((non_neg_integer()) -> imm()), fun((imm()) -> boolean()),
               fun((imm(), type(), shrink_state()) -> {[imm()], shrink_state()}),
               Neighbour :: fun((Value :: term()) -> imm())) -> type().
new_type(Generator, IsInstance, Shrinker, Neighbour) ->
    Type = own_type(Generator, IsInstance, Shrinker),
    case has_neighbours() of
        true ->
            Near = fun(Base, _Temperature) ->
                           own_type(fun(_Size) -> Neighbour(Base) end, IsInstance, Shrinker)
                   end,
            apply(proper_gen_next, set_user_nf, [Type, Near]);
        false ->
            Type
    end.

own_type(Generator, IsInstance, Shrinker) ->
    proper_types:new_type([{generator, Generator},
                           {is_instance, IsInstance},
                           {shrinkers, [Shrinker]}], faultcheck).

%% Asked for once: looking for a module that is not there goes through the whole code path,
%% and a nested ?FORALL makes a type for each test.
has_neighbours() ->
    Key = {?MODULE, has_neighbours},
    case persistent_term:get(Key, unknown) of
        unknown ->
            _ = code:ensure_loaded(proper_gen_next),
            Has = erlang:function_exported(proper_gen_next, set_user_nf, 2),
            persistent_term:put(Key, Has),
            Has;
        Has ->
            Has
    end.

%% @doc Integers Lo..Hi from a generator of its own, shrunk like PropEr's.
-spec integer_type(integer(), integer(), fun(() -> integer())) -> type().
integer_type(Lo, Hi, Generator) ->
    proper_types:new_type(
      [{generator, Generator},
       {is_instance, fun(X) -> is_integer(X) andalso Lo =< X andalso X =< Hi end},
       {shrinkers, [fun(X, _Type, S) -> proper_shrink:number_shrinker(X, Lo, Hi, S) end]}], basic).

%% @doc The type with its size parameter multiplied.
-spec resized(pos_integer(), type()) -> type().
resized(N, Type) ->
    proper_types:sized(fun(Size) -> proper_types:resize(Size * N, Type) end).

%% @doc The type with limits that limits/1 tells again.
-spec with_limits(faultcheck_range:limits(), type()) -> type().
with_limits(Limits, Type) ->
    proper_types:subtype([{env, {?MODULE, Limits}}], Type).

%% @doc The limits of a number's type: those of with_limits/2, or those of PropEr's integer/2 and
%% float/2 where both are finite.
-spec limits(type()) -> {ok, faultcheck_range:limits()} | none.
limits(Type) ->
    case proper_types:is_type(Type) andalso proper_types:find_prop(env, Type) of
        {ok, {?MODULE, Limits}} ->
            {ok, Limits};
        {ok, {Low, High}} when is_integer(Low), is_integer(High) ->
            {ok, #{kind => int, min => Low, max => High}};
        {ok, {Low, High}} when is_number(Low), is_number(High) ->
            {ok, #{kind => real, min => float(Low), max => float(High)}};
        _ ->
            none
    end.

%% @doc An intermediate instance of a type; error when PropEr cannot make one.
-spec generate(type()) -> {ok, imm()} | error.
generate(RawType) ->
    case proper_gen:safe_generate(RawType) of
        {ok, Imm} -> {ok, Imm};
        {error, _} -> error
    end.

%% @doc As generate/1, without a detour for the plain values models often use as types.
-spec fast_generate(type()) -> {ok, imm()} | error.
fast_generate(X) when is_atom(X); is_number(X); is_binary(X) -> {ok, X};
fast_generate({var, N} = Var) when is_integer(N) -> {ok, Var};
fast_generate(RawType) -> generate(RawType).

%% @doc The value of an intermediate instance.
-spec clean(imm()) -> term().
clean(X) when is_atom(X); is_number(X); is_binary(X) -> X;
clean(Imm) -> proper_gen:clean_instance(Imm).

%% @doc An instance that carries something beside its value. The side data is inside a
%% fun, since PropEr looks through tuples and lists for types to generate from. A fresh
%% reference in the environment makes equal values differ: PropEr does not run a
%% candidate that equals the current one.
-spec with_side(term(), term()) -> imm().
with_side(Value, Side) ->
    with_side(Value, Side, make_ref()).

with_side(Value, Side, Ref) ->
    {'$used', fun() -> {Ref, Side} end, Value}.

%% @doc The side data, or none when the value came from a file.
-spec side(imm()) -> {ok, term()} | none.
side({'$used', Fun, _}) when is_function(Fun, 0) ->
    {_Ref, Side} = Fun(),
    {ok, Side};
side(_) ->
    none.

%% @doc The outermost layer of a raw type as a type.
-spec cook(type()) -> type().
cook(RawType) ->
    proper_types:cook_outer(RawType).

%% @doc Whether a value is of a type, as far as PropEr can tell.
-spec is_instance(term(), type()) -> boolean().
is_instance(Value, Type) ->
    proper_types:is_instance(Value, Type) =:= true.

%% @doc One step of PropEr's own shrinkers. They may raise when the type no longer
%% fits the value; that ends the shrinking of this value.
-spec shrink(imm(), type(), shrink_state()) -> {[imm()], shrink_state()}.
shrink(Imm, Type, State) ->
    try
        proper_shrink:shrink(Imm, Type, State)
    catch
        _:_ -> {[], done}
    end.

%% @doc One step of PropEr's shrinker of numbers Low..High.
-spec shrink_number(number(), number(), number(), shrink_state()) -> {[number()], shrink_state()}.
shrink_number(Number, Low, High, State) ->
    proper_shrink:number_shrinker(Number, Low, High, State).

%% @doc When a shrinker is in the middle of a number: the value it offered last, the
%% step to the next one, and how many steps may still follow.
-spec number_state(shrink_state()) ->
          {Last :: number(), Step :: number(), Left :: non_neg_integer()} | none.
number_state({inc, Last, Inc, OverLimit}) when is_function(Inc, 1), is_function(OverLimit, 1) ->
    Step = Inc(Last) - Last,
    {Last, Step, steps_left(Last, Step, OverLimit)};
number_state(State) when is_tuple(State), tuple_size(State) > 1 ->
    number_state(element(tuple_size(State), State));
number_state(_) ->
    none.

steps_left(Last, Step, OverLimit) ->
    Over = fun(K) -> OverLimit(Last + K * Step) end,
    largest_within(0, first_over(1, Over), Over).

%% Low is within the limit, High is over it.
largest_within(Low, High, _Over) when High - Low =:= 1 ->
    Low;
largest_within(Low, High, Over) ->
    Middle = (Low + High) div 2,
    case Over(Middle) of
        true -> largest_within(Low, Middle, Over);
        false -> largest_within(Middle, High, Over)
    end.

first_over(K, Over) ->
    case Over(K) of
        true -> K;
        false -> first_over(2 * K, Over)
    end.

%% @doc Makes Value the next candidate of the number a shrinker is in the middle of.
-spec set_number(shrink_state(), number()) -> shrink_state().
set_number(State, Value) ->
    replace_number(State, {inc, Value, fun(_) -> Value end, fun(_) -> false end}).

%% @doc Ends the number a shrinker is in the middle of.
-spec end_number(shrink_state()) -> shrink_state().
end_number(State) ->
    replace_number(State, done).

replace_number({inc, _, _, _}, New) ->
    New;
replace_number(State, New) ->
    N = tuple_size(State),
    setelement(N, State, replace_number(element(N, State), New)).

%% @doc Runs Fun with PropEr's generators usable outside a property.
-spec with_state(Size :: non_neg_integer(), seed(), fun(() -> Result)) -> Result.
with_state(Size, Seed, Fun) ->
    ok = proper:global_state_init_size_seed(Size, Seed),
    try
        Fun()
    after
        proper:global_state_erase()
    end.

%% @doc The size parameter of the running property.
-spec size() -> non_neg_integer().
size() ->
    case get('$size') of
        undefined -> 10;
        Size -> Size
    end.

%% @doc Runs Fun with a random state that depends on Seed alone; the process's own
%% random state is as before afterwards.
-spec preserving_random(term(), fun(() -> Result)) -> Result.
preserving_random(Seed, Fun) ->
    Saved = rand:export_seed(),
    _ = rand:seed(exsss, erlang:phash2(Seed, 1 bsl 32)),
    try
        Fun()
    after
        restore(Saved)
    end.

restore(undefined) -> _ = erase(rand_seed), ok;
restore(Saved) -> _ = rand:seed(Saved), ok.

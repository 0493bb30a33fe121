%% @doc The part of Quviq's eqc that models use, by PropEr.
-module(eqc).

-export([quickcheck/1, quickcheck/2, numtests/2, counterexample/0, check/2]).
-export([aggregate/2, collect/2, measure/3, equals/2, fails/1, conjunction/1]).
-export_type([property/0]).

-type property() :: proper:outer_test().

%% @doc Tests a property 100 times, or as often as numtests/2 says; a failure is shrunk.
-spec quickcheck(property()) -> boolean() | {error, term()}.
quickcheck(Property) -> proper:quickcheck(Property).

%% @doc The same with PropEr's options.
-spec quickcheck(property(), list()) -> term().
quickcheck(Property, Options) -> proper:quickcheck(Property, Options).

-spec numtests(pos_integer(), property()) -> property().
numtests(N, Property) -> proper:numtests(N, Property).

%% @doc The last counterexample.
-spec counterexample() -> term().
counterexample() -> proper:counterexample().

%% @doc Tests a property with a counterexample.
-spec check(property(), term()) -> term().
check(Property, Counterexample) -> proper:check(Property, Counterexample).

-spec aggregate([term()], proper:test()) -> proper:test().
aggregate(Samples, Test) -> proper:aggregate(Samples, Test).

-spec collect(term(), proper:test()) -> proper:test().
collect(Sample, Test) -> proper:collect(Sample, Test).

-spec measure(string() | atom(), number() | [number()], proper:test()) -> proper:test().
measure(Title, Numbers, Test) when is_atom(Title) ->
    measure(atom_to_list(Title), Numbers, Test);
measure(Title, Numbers, Test) ->
    proper:measure(Title, Numbers, Test).

-spec equals(term(), term()) -> proper:test().
equals(A, B) -> proper:equals(A, B).

-spec fails(property()) -> property().
fails(Property) -> proper:fails(Property).

-spec conjunction([{atom(), proper:test()}]) -> proper:test().
conjunction(Properties) -> proper:conjunction(Properties).

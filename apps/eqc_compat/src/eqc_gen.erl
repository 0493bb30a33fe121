%% @doc The generators of Quviq's eqc_gen that models use, by PropEr's types.
-module(eqc_gen).

-export([int/0, nat/0, bool/0, real/0, choose/2, elements/1, oneof/1, frequency/1, list/1,
         vector/2, binary/0, binary/1, return/1, resize/2, noshrink/1]).
-export_type([gen/1]).

%% A generator of values of a type.
-type gen(_Type) :: proper_types:raw_type().

-spec int() -> gen(integer()).
int() -> proper_types:int().

-spec nat() -> gen(non_neg_integer()).
nat() -> proper_types:nat().

-spec bool() -> gen(boolean()).
bool() -> proper_types:bool().

-spec real() -> gen(float()).
real() -> proper_types:real().

%% @doc Any integer of the range is equally likely, however wide the range.
-spec choose(integer(), integer()) -> gen(integer()).
choose(Low, High) -> faultcheck_statem:uniform(Low, High).

-spec elements([T, ...]) -> gen(T).
elements(Values) -> proper_types:elements(Values).

-spec oneof([gen(T), ...]) -> gen(T).
oneof(Generators) -> proper_types:oneof(Generators).

-spec frequency([{pos_integer(), gen(T)}, ...]) -> gen(T).
frequency(Weighted) -> proper_types:frequency(Weighted).

-spec list(gen(T)) -> gen([T]).
list(Generator) -> proper_types:list(Generator).

-spec vector(non_neg_integer(), gen(T)) -> gen([T]).
vector(Length, Generator) -> proper_types:vector(Length, Generator).

-spec binary() -> gen(binary()).
binary() -> proper_types:binary().

-spec binary(non_neg_integer()) -> gen(binary()).
binary(Bytes) -> proper_types:binary(Bytes).

-spec return(T) -> gen(T).
return(Value) -> proper_types:return(Value).

-spec resize(non_neg_integer(), gen(T)) -> gen(T).
resize(Size, Generator) -> proper_types:resize(Size, Generator).

-spec noshrink(gen(T)) -> gen(T).
noshrink(Generator) -> proper_types:noshrink(Generator).

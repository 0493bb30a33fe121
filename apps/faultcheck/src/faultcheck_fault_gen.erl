%% @doc Generators of faults.
%%
%% Their values are plain terms (faultcheck_fault). Sizes bound numbers, delays and durations;
%% one parameter in ten is a limit of its type or just past an integer's. A fault shrinks to
%% weaker, shorter, later and simpler ones: see faultcheck_fault_weaker.
-module(faultcheck_fault_gen).

-export([fault/0, probe/0, probe/1, sensor/0, sensor/1, value/1, communication/0, communication/1]).
-export([model/1, trigger/0]).
-export_type([names/0]).

%% What communication faults may name.
-type names() :: #{channels => [binary()], receivers => [binary()]}.

%% @doc Any fault.
-spec fault() -> faultcheck_proper:type().
fault() -> type(fun(Size) -> with_trigger(random_model(any_class(), f64, #{}, Size), Size) end).

%% @doc The plain faults of probes (docs/faultcheck.md, 2), for values of any type.
-spec probe() -> faultcheck_proper:type().
probe() -> probe(any).

%% @doc The same for values of one type.
-spec probe(faultcheck_fault:value_type() | any) -> faultcheck_proper:type().
probe(Type) -> of_class(probe, Type, #{}).

%% @doc The models of faulty sensors.
-spec sensor() -> faultcheck_proper:type().
sensor() -> sensor(any).

%% @doc The same for values of one type.
-spec sensor(faultcheck_fault:value_type() | any) -> faultcheck_proper:type().
sensor(Type) -> of_class(sensor, Type, #{}).

%% @doc Both, for a probe of that type.
-spec value(faultcheck_fault:value_type() | any) -> faultcheck_proper:type().
value(Type) -> of_class([probe, sensor], Type, #{}).

%% @doc Faults of channels.
-spec communication() -> faultcheck_proper:type().
communication() -> communication(#{}).

%% @doc The same among channels and receivers of those names.
-spec communication(names()) -> faultcheck_proper:type().
communication(Names) -> of_class(communication, any, Names).

of_class(Class, Type, Names) ->
    type(fun(Size) -> with_trigger(random_model(Class, Type, Names, Size), Size) end).

%% @doc A model alone, without trigger.
-spec model(faultcheck_fault_catalogue:class()) -> faultcheck_proper:type().
model(Class) -> type(fun(Size) -> random_model(Class, any, #{}, Size) end).

%% @doc A trigger alone; half of them are empty.
-spec trigger() -> faultcheck_proper:type().
trigger() ->
    shrunk_by(fun random_trigger/1,
              fun(Trigger) -> faultcheck_fault:validate_trigger(Trigger) =:= ok end,
              fun faultcheck_fault_weaker:triggers/1).

type(Generate) ->
    shrunk_by(Generate, fun(Fault) -> faultcheck_fault:validate(Fault) =:= ok end,
              fun faultcheck_fault_weaker:faults/1).

shrunk_by(Generate, IsInstance, Weaker) ->
    faultcheck_proper:new_type(
        Generate,
        IsInstance,
        fun
            (Value, _Type, init) -> {Weaker(Value), done};
            (_Value, _Type, _State) -> {[], done}
        end,
        fun(Base) -> one_of([Base | Weaker(Base)]) end).

%% ---- models ---------------------------------------------------------------------------------

any_class() -> one_of([probe, sensor, communication]).

random_model(Class, Type, Names, Size) ->
    Entries = [
        Entry
     || #{class := C} = Entry <- faultcheck_fault_catalogue:models(),
        C =:= Class orelse (is_list(Class) andalso lists:member(C, Class)),
        makes_sense(Entry, Type)
    ],
    #{name := Name, parameters := Kinds} = one_of(Entries),
    Values = [value(Kind, {Name, Type, Names}, Size) || {_, Kind} <- Kinds],
    ordered(list_to_tuple_or_atom([Name | Values])).

makes_sense(#{class := sensor, name := Name}, bytes) -> Name =:= delay;
makes_sense(#{class := probe, name := Name}, bytes) ->
    not lists:member(Name, [amplification, offset]);
makes_sense(_, _) -> true.

list_to_tuple_or_atom([Name]) -> Name;
list_to_tuple_or_atom(Parts) -> list_to_tuple(Parts).

ordered({Name, A, B}) when (Name =:= saturate orelse Name =:= random_offset) ->
    {Name, lesser(A, B), greater(A, B)};
ordered({held_offset, A, B, Ns}) ->
    {held_offset, lesser(A, B), greater(A, B), Ns};
ordered(Model) ->
    Model.

lesser(A, B) -> hd(by_size([A, B])).

greater(A, B) -> lists:last(by_size([A, B])).

by_size(Reals) ->
    Are = fun(Atom) -> [R || R <- Reals, R =:= Atom] end,
    Are(neg_inf) ++ lists:sort([R || R <- Reals, is_number(R)]) ++ Are(inf).

value(bit, {_, Type, _}, _Size) -> below(width(Type));
value(bit_of_byte, _, _) -> below(8);
value(bit_value, _, _) -> below(2);
value(any_real, {set_to, bytes, _}, _) -> float(below(256));
value(any_real, {_, Type, _}, Size) ->
    rarely(fun() -> one_of([inf, neg_inf, nan]) end, fun() -> real(Type, Size) end);
value(real, {_, Type, _}, Size) -> real(Type, Size);
value(limit, _, Size) -> one_of([none, abs(small_real(Size))]);
value(positive, _, Size) -> abs(small_real(Size)) + 0.25;
value(probability, _, _) -> one_of([0.0, 0.25, 0.5, 0.75, 1.0]);
value(natural, {truncate, _, _}, Size) -> below(Size + 4);
value(natural, {corruption, _, _}, _) -> below(4);
value(natural, _, Size) -> below(Size div 4 + 4);
value(count, {held_offset, _, _}, _) -> 1000 * (1 + below(4));
value(count, _, Size) -> 1 + below(Size + 4);
value(byte, _, _) -> below(256);
value(dropout_mode, {_, Type, _}, _) ->
    one_of([hold, zero | [nan || lists:member(Type, [any, f32, f64])]]);
value(name, {_, _, Names}, _) -> one_of(channels(Names));
value(data, _, Size) -> bytes(below(min(Size, 8) + 1));
value(delay, _, Size) -> {calls, below(Size div 2 + 4)};
value(channel_delay, _, Size) -> one_of([{gets, below(Size div 4 + 3)}, {ns, below(4) * 1000}]);
value(receivers, {_, _, Names}, _) -> some_of(receivers(Names));
value(field, _, _) -> field();
value(part, _, _) -> one_of([whole, field()]);
value(model, _, Size) -> random_model([probe, sensor], one_of([u8, i16, bytes]), #{}, Size).

field() ->
    one_of([{below(3), bytes, below(4)}, {below(4), one_of(scalars()), one_of([little, big])}]).

scalars() -> [f32, f64, i8, i16, i32, i64, u8, u16, u32, u64, bool].

channels(Names) -> maps:get(channels, Names, [<<"a">>, <<"b">>]).

receivers(Names) -> maps:get(receivers, Names, [<<"x">>, <<"y">>]).

width(bool) -> 1;
width(Type) when Type =:= i8; Type =:= u8 -> 8;
width(Type) when Type =:= i16; Type =:= u16 -> 16;
width(Type) when Type =:= i64; Type =:= u64; Type =:= f64 -> 64;
width(_) -> 32.

%% The limits of integer types and their neighbours are where conversions go wrong.
real(Type, Size) -> rarely(fun() -> extreme(Type) end, fun() -> small_real(Size) end).

extreme(Type) when Type =:= f64; Type =:= f32 ->
    one_of([1.7976931348623157e308, -1.7976931348623157e308, 5.0e-324, 3.4028234663852886e38,
            1.0e-45, -0.0, 16777217.0]);
extreme(_) ->
    Limit = math:pow(2, one_of([7, 8, 15, 16, 31, 32, 53, 63, 64])),
    one_of([-1.0, 1.0]) * Limit + one_of([-1.0, -0.5, 0.0, 1.0]).

small_real(Size) ->
    Whole = below(2 * Size + 9) - Size - 4,
    float(Whole) + one_of([0.0, 0.0, 0.5, 0.1, 0.25]).

%% ---- triggers -------------------------------------------------------------------------------

with_trigger(Model, Size) ->
    case random_trigger(Size) of
        [] -> Model;
        Trigger -> {Model, Trigger}
    end.

random_trigger(Size) ->
    case below(2) of
        0 -> [];
        1 -> window(Size) ++ rarely(fun() -> [condition()] end, fun() -> [] end, 3)
    end.

window(Size) ->
    From = {from, below(Size div 4 + 3)},
    For = {for, below(Size div 4 + 3)},
    one_of([[From], [For], [From, {for, 1}], [From, For]]).

condition() ->
    one_of([
        {random, one_of([0.25, 0.5, 1.0])},
        {periodic, 1 + below(5), below(4)},
        {time, below(4) * 1000, one_of([forever, below(5) * 1000])}
    ]).

%% ---- choice ---------------------------------------------------------------------------------

rarely(Rare, Usual) -> rarely(Rare, Usual, 10).

rarely(Rare, Usual, OneIn) ->
    case below(OneIn) of
        0 -> Rare();
        _ -> Usual()
    end.

below(N) -> rand:uniform(N) - 1.

one_of(List) -> lists:nth(rand:uniform(length(List)), List).

some_of(List) ->
    case [X || X <- List, below(2) =:= 0] of
        [] -> [one_of(List)];
        Some -> Some
    end.

bytes(N) -> list_to_binary([below(256) || _ <- lists:seq(1, N)]).

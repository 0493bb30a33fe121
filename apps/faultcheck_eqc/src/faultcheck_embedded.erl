%% @doc The embedded profile against its description, and against libfaultcheck where the two agree
%% (faultcheck_embedded_sut says where they do not).
%%
%% The model says what each command replies and what is listed; libfaultcheck says what a probe
%% makes of a value.
-module(faultcheck_embedded).
-include_lib("faultcheck/include/faultcheck.hrl").

%% PropEr 1.5 calls its property types opaque, though a plain boolean is one of them.
-dialyzer({[no_opaque, no_return], [agrees/0]}).

-export([agrees/0]).

%% The limits that the profile is built with.
-define(PROBES, 5).
-define(FAULTS, 5).
-define(ID_BYTES, 20).
-define(INT_MAX, 16#7FFFFFFF).

-record(fault, {type, param, start, duration}).
%% Faults in the order of adding.
-record(probe, {id, calls = 0, faults = []}).
%% Slots as the listing goes through them; empty ones are free.
-record(state, {enabled = false, slots = lists:duplicate(?PROBES, free)}).

initial_state() -> #state{}.

faults() -> [add].

%% Traffic is what shows a fault.
weight(_S, probe) -> 12;
weight(_S, add) -> 6;
weight(#state{enabled = false}, set_enabled) -> 8;
weight(_S, set_enabled) -> 1;
weight(_S, _) -> 1.

%% ---- add ----------------------------------------------------------------------------------------
add_args(_S) -> [id(), type(), param(), number(), number()].
add(Id, Type, Param, Start, Duration) ->
    faultcheck_embedded_sut:add(Id, Type, Param, Start, Duration).
add_next(S, _, [Id | _] = Args) ->
    case added(S, Args) of
        {Slot, Probe, Fault} -> put_slot(Slot, with_fault(Id, Probe, Fault), S);
        refused -> S
    end.
add_post(S, Args, Result) ->
    case {added(S, Args), Result} of
        {refused, {error, _}} -> true;
        {refused, _} -> false;
        {_, Result} -> Result =:= ok
    end.

with_fault(Id, free, Fault) -> with_fault(Id, #probe{id = Id}, Fault);
with_fault(_, #probe{faults = Faults, calls = Calls} = Probe, #fault{start = Start} = Fault) ->
    Probe#probe{faults = Faults ++ [Fault#fault{start = Calls + Start}]}.

%% The slot, what is in it, and the new fault with a start from now on.
added(S, [Id, Type, Param, Start, Duration]) ->
    Slot = slot(Id, S),
    case
        byte_size(Id) =< ?ID_BYTES andalso is_type(Type) andalso Param =/= <<"abc">> andalso
            is_number_word(Start) andalso is_number_word(Duration) andalso Slot
    of
        false -> refused;
        {_, #probe{faults = Faults}} when length(Faults) =:= ?FAULTS -> refused;
        {N, Probe} ->
            Fault = #fault{type = upper(Type), param = Param, start = binary_to_integer(Start),
                           duration = binary_to_integer(Duration)},
            {N, Probe, Fault}
    end.

is_type(Type) -> lists:member(upper(Type), types()).

%% NONE in any letter case, the others as they are.
upper(Type) ->
    case string:uppercase(Type) of
        <<"NONE">> -> <<"NONE">>;
        _ -> Type
    end.

is_number_word(Word) ->
    try binary_to_integer(Word) of
        N -> N >= 0 andalso N =< ?INT_MAX
    catch
        error:badarg -> false
    end.

slot(Id, #state{slots = Slots}) ->
    Numbered = lists:zip(lists:seq(1, ?PROBES), Slots),
    case [{N, P} || {N, #probe{id = I} = P} <- Numbered, I =:= Id] ++
         [{N, free} || {N, free} <- Numbered] of
        [First | _] -> First;
        [] -> false
    end.

put_slot(N, Probe, #state{slots = Slots} = S) ->
    {Before, [_ | After]} = lists:split(N - 1, Slots),
    S#state{slots = Before ++ [Probe | After]}.

%% ---- set_enabled, clear, reset ------------------------------------------------------------------
set_enabled_args(_S) -> [frequency([{12, <<"1">>}, {2, <<"0">>}, {1, <<"2">>}, {1, <<"on">>}])].
set_enabled(Word) -> faultcheck_embedded_sut:set_enabled(Word).
set_enabled_next(S, _, [Word]) ->
    case Word of
        <<"1">> -> S#state{enabled = true};
        <<"0">> -> S#state{enabled = false};
        _ -> S
    end.
set_enabled_post(_S, [Word], Result) ->
    case lists:member(Word, [<<"0">>, <<"1">>]) of
        true -> Result =:= ok;
        false -> element(1, Result) =:= error
    end.

clear_args(_S) -> [].
clear() -> faultcheck_embedded_sut:clear().
clear_next(S, _, []) -> S#state{slots = lists:duplicate(?PROBES, free)}.
clear_post(_S, [], Result) -> Result =:= ok.

reset_args(_S) -> [].
reset() -> faultcheck_embedded_sut:reset().
reset_next(#state{slots = Slots} = S, _, []) ->
    S#state{slots = [case P of free -> free; _ -> P#probe{calls = 0} end || P <- Slots]}.
reset_post(_S, [], Result) -> Result =:= ok.

%% ---- listing ------------------------------------------------------------------------------------
listing_args(_S) -> [].
listing() -> faultcheck_embedded_sut:listing().
listing_post(#state{slots = Slots}, [], Lines) ->
    Expected = [{P, F} || #probe{faults = Faults} = P <- Slots, F <- Faults],
    lists:last(Lines) =:= <<"ok">> andalso length(Lines) =:= length(Expected) + 1 andalso
        lists:all(fun({Line, {P, F}}) -> is_listed(Line, P, F) end,
                  lists:zip(lists:droplast(Lines), Expected)).

is_listed(Line, #probe{id = Id, calls = Calls}, #fault{} = F) ->
    [<<"probe=", Id1/binary>>, <<"it=", It/binary>>, <<"type=", Type/binary>>,
     <<"param=", Param/binary>>, <<"start=", Start/binary>>, <<"duration=", Duration/binary>>] =
        binary:split(Line, <<" ">>, [global]),
    {Id1, binary_to_integer(It), Type, binary_to_integer(Start), binary_to_integer(Duration)} =:=
        {Id, Calls, F#fault.type, F#fault.start, F#fault.duration} andalso
        bits(Param) =:= faultcheck_embedded_sut:bits(F#fault.param).

%% Erlang wants a point before the exponent.
bits(Param) ->
    case binary:split(Param, <<"e">>) of
        [_] -> faultcheck_embedded_sut:bits(Param);
        [Digits, Power] -> faultcheck_embedded_sut:bits(<<Digits/binary, ".0e", Power/binary>>)
    end.

%% ---- probe --------------------------------------------------------------------------------------
probe_args(_S) -> ?LET(Type, oneof([i32, f32]), [id(), Type, value(Type)]).
probe(Id, Type, Value) -> faultcheck_embedded_sut:probe(Id, Type, Value).
probe_next(#state{enabled = true} = S, _, [Id, _, _]) ->
    case slot(Id, S) of
        {N, #probe{calls = Calls} = P} -> put_slot(N, P#probe{calls = Calls + 1}, S);
        _ -> S
    end;
probe_next(S, _, _) -> S.
probe_post(S, [Id, _, Value], {Embedded, Main}) ->
    Embedded =:= Main andalso (may_change(Id, S) orelse Embedded =:= Value).

may_change(_, #state{enabled = false}) -> false;
may_change(Id, S) -> is_record(element(2, slot_or_free(Id, S)), probe).

slot_or_free(Id, S) ->
    case slot(Id, S) of
        false -> {0, free};
        Slot -> Slot
    end.

%% ---- the property -------------------------------------------------------------------------------

%% @doc The embedded profile does what its description says, and alters values as libfaultcheck.
-spec agrees() -> proper:test().
agrees() ->
    ?FORALL(Commands, more_commands(3, commands(?MODULE)), begin
        ok = faultcheck_embedded_sut:prepare(),
        {_, _, Result} = Run = run_commands(?MODULE, Commands),
        ?WHENFAIL(
            io:put_chars(faultcheck_statem:pretty(?MODULE, Commands, Run)),
            aggregate(command_names(Commands), Result =:= ok)
        )
    end).

%% ---- generators ---------------------------------------------------------------------------------

%% Few, so that faults meet; enough to run out of slots; the longest and one that is too long.
id() ->
    frequency([
        {12, <<"x">>},
        {4, <<"y">>},
        {1, oneof([<<"a">>, <<"b">>, <<"c">>, <<255, 1>>])},
        {1, binary:copy(<<"l">>, ?ID_BYTES)},
        {1, binary:copy(<<"l">>, ?ID_BYTES + 1)}
    ]).

types() -> [<<"NONE">>, <<"BITFLIP">>, <<"OFFSET">>, <<"AMPLIFICATION">>, <<"SET_TO">>].

type() -> frequency([{30, oneof(types())}, {1, oneof([<<"nonE">>, <<"bitflip">>, <<"SET">>])}]).

%% Bits, numbers that halve and double exactly, all floats, the limits of int and float.
param() ->
    frequency([
        {4, ?LET(N, integer(-2, 40), integer_to_binary(N))},
        {4, ?LET(N, integer(-40, 40), text(N / 4))},
        {3, ?LET(F, finite(uniform(0, 16#FFFFFFFF)), text(F))},
        {2, oneof([<<"0.1">>, <<"-0.0">>, <<"16777217">>, <<"2147483647">>, <<"-2147483649">>,
                   <<"3.40282347e38">>, <<"-3.40282347e38">>, <<"1.0e-45">>, <<"1.0e-60">>])},
        {1, <<"abc">>}
    ]).

%% Nine digits name every float.
text(F) -> iolist_to_binary(io_lib:format("~.8e", [F])).

finite(Bits) ->
    ?LET(B, Bits, case <<B:32>> of <<F:32/float>> -> F; _ -> 1.5 end).

%% Small, so that windows open and close; the largest; what is refused.
number() ->
    frequency([
        {20, ?LET(N, integer(0, 5), integer_to_binary(N))},
        {1, oneof([<<"2147483647">>, <<"2147483648">>, <<"-1">>, <<"x">>, <<"007">>])}
    ]).

%% A float is its bits: any, NaN and infinities too.
value(i32) ->
    frequency([
        {4, integer(-20, 20)},
        {2, oneof([-16#80000000, -16#7FFFFFFF, 16#7FFFFFFE, 16#7FFFFFFF, 16777217])},
        {1, uniform(-16#80000000, 16#7FFFFFFF)}
    ]);
value(f32) ->
    frequency([
        {4, ?LET(N, integer(-40, 40), float_bits(N / 4))},
        {3, uniform(0, 16#FFFFFFFF)},
        {1, oneof([0, 16#80000000, 1, 16#7F7FFFFF, 16#7F800000, 16#FF800000, 16#7FC00000])}
    ]).

float_bits(F) ->
    <<Bits:32>> = <<F:32/float>>,
    Bits.

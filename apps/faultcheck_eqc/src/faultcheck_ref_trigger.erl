%% @doc When a fault is active (faultcheck.md, 3 and 7.5).
-module(faultcheck_ref_trigger).

-export([new/0, change/3, fires/3]).
-export_type([trigger/0, change/0]).

-type trigger() :: #{
    countdown := non_neg_integer(),
    %% affected calls left, negative: no limit
    duration := integer(),
    conditions := #{time | random | periodic => tuple() | float()}
}.
-type change() :: none | {once, non_neg_integer()} | {for, integer()}
                | faultcheck_fault:condition().

%% @doc Permanent.
-spec new() -> trigger().
new() -> #{countdown => 0, duration => -1, conditions => #{}}.

%% @doc Setting a delay resets the duration, and k of a periodic trigger counts from the delay.
-spec change(change(), Now :: integer(), trigger()) -> trigger().
change(none, _, _) -> new();
change({from, N}, _, T) -> restart(T#{countdown := N, duration := -1});
change({once, N}, _, T) -> restart(T#{countdown := N, duration := 1});
change({for, N}, _, T) -> T#{duration := N};
change({time, Delay, Duration}, Now, T) -> with(time, {Now, Delay, Duration}, T);
change({random, P}, _, T) -> with(random, float(P), T);
change({periodic, Period, Active}, _, T) -> with(periodic, {Period, Active, 0}, T).

restart(#{conditions := #{periodic := {Period, Active, _}}} = T) ->
    with(periodic, {Period, Active, 0}, T);
restart(T) ->
    T.

with(Kind, Value, #{conditions := C} = T) -> T#{conditions := C#{Kind => Value}}.

%% @doc One call passes.
-spec fires(trigger(), Now :: integer(), faultcheck_ref_stream:stream()) ->
    {boolean(), trigger(), faultcheck_ref_stream:stream()}.
fires(#{duration := 0} = T, _, Stream) ->
    {false, T, Stream};
fires(#{countdown := N} = T, _, Stream) when N > 0 ->
    {false, T#{countdown := N - 1}, Stream};
fires(#{conditions := Conditions} = T, Now, Stream) ->
    {InPeriod, Next} = period(Conditions),
    InTime = in_time(Conditions, Now),
    {Drawn, Later} = draw(Conditions, InPeriod andalso InTime, Stream),
    {Drawn, consume(Drawn, T#{conditions := Next}), Later}.

period(#{periodic := {Period, Active, K}} = C) ->
    {K rem Period < Active, C#{periodic := {Period, Active, K + 1}}};
period(C) ->
    {true, C}.

in_time(#{time := {Start, Delay, forever}}, Now) -> Now - Start >= Delay;
in_time(#{time := {Start, Delay, Duration}}, Now) ->
    Now - Start >= Delay andalso Now - Start < Delay + Duration;
in_time(_, _) -> true.

draw(#{random := P}, true, Stream) ->
    {Unit, Next} = faultcheck_ref_stream:unit(Stream),
    {Unit < P, Next};
draw(_, Hold, Stream) ->
    {Hold, Stream}.

consume(true, #{duration := D} = T) when D > 0 -> T#{duration := D - 1};
consume(_, T) -> T.

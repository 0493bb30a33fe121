%% @doc Numbers with their limits inside: smallest and largest value, and the unit.
%%
%% ```
%% steer_args(S) ->
%%     [oneof(copters(S)), faultcheck_range:int(-15, 15, #{unit => "degree"})].
%% '''
%% The types are ordinary PropEr types. Values are uniform over the whole range, whatever the size
%% of the test, and shrink towards 0, or to the limit next to it. That a range knows its limits
%% lets others use them without a second table: boundary-biased generation (below), and the
%% guided search, which moves a value by a part of its range and clamps it there
%% (faultcheck_perturb).
%%
%% With a boundary bias B, a value is one of the two limits with probability B. It is 0 unless
%% `rebar3 proper --boundary-bias B' or set_bias/1 says otherwise; a range with `boundary => false'
%% never listens to it (durations, say), one with a number has a bias of its own.
-module(faultcheck_range).

-export([int/2, int/3, real/2, real/3, index/2, index/3]).
-export([bias/0, set_bias/1, with_bias/2, limits/1, clamp/2]).
-export_type([options/0, limits/0, bias/0]).

-type bias() :: float() | 0 | 1.
-type options() :: #{
    unit => string(),
    %% true: the bias of the process; false: none; or a bias of its own
    boundary => boolean() | bias()
}.
-type limits() :: #{
    kind := int | real,
    min := number(),
    max := number(),
    unit => string(),
    boundary => boolean() | bias(),
    %% false: no value is nearer to another than to a third
    ordered => boolean()
}.

%% A real shrinks over a thousand places or more of its range, at whole multiples of a power of 10.
-define(PLACES, 1000).

%% @doc Integers Min..Max.
-spec int(integer(), integer()) -> faultcheck_proper:type().
int(Min, Max) -> int(Min, Max, #{}).

%% @doc The same with options.
-spec int(integer(), integer(), options()) -> faultcheck_proper:type().
int(Min, Max, Options) when is_integer(Min), is_integer(Max), Min =< Max ->
    type((checked(Options))#{kind => int, min => Min, max => Max}).

%% @doc Floats Min..Max.
-spec real(number(), number()) -> faultcheck_proper:type().
real(Min, Max) -> real(Min, Max, #{}).

%% @doc The same with options.
-spec real(number(), number(), options()) -> faultcheck_proper:type().
real(Min, Max, Options) when is_number(Min), is_number(Max), Min =< Max ->
    type((checked(Options))#{kind => real, min => float(Min), max => float(Max)}).

%% @doc Integers that only tell things apart: bits, bytes, seeds. They shrink as int/2, have no
%% boundary bias, and a search draws them anew.
-spec index(integer(), integer()) -> faultcheck_proper:type().
index(Min, Max) -> index(Min, Max, "").

%% @doc The same with what is counted, in place of a unit.
-spec index(integer(), integer(), string()) -> faultcheck_proper:type().
index(Min, Max, What) when is_integer(Min), is_integer(Max), Min =< Max ->
    type(#{
        kind => int, min => Min, max => Max, unit => What, boundary => false, ordered => false
    }).

checked(Options) ->
    maps:foreach(
        fun
            (unit, Unit) when is_list(Unit) -> ok;
            (boundary, B) when is_boolean(B); is_number(B), B >= 0, B =< 1 -> ok;
            (Key, Value) -> error({range_option, Key, Value, {known, [boundary, unit]}})
        end,
        Options
    ),
    Options.

type(Limits) ->
    faultcheck_proper:with_limits(
        Limits,
        faultcheck_proper:new_type(
            fun(_Size) -> draw(Limits) end,
            fun(Value) -> within(Value, Limits) end,
            fun(Value, _Type, State) -> shrink(Value, Limits, State) end,
            fun(Value) -> faultcheck_perturb:number(Value, 0.3, Limits) end
        )
    ).

within(Value, #{kind := int, min := Min, max := Max}) ->
    is_integer(Value) andalso Min =< Value andalso Value =< Max;
within(Value, #{kind := real, min := Min, max := Max}) ->
    is_float(Value) andalso Min =< Value andalso Value =< Max.

%% @doc What a type says of its limits: that of this module, or PropEr's integer/2 and float/2 with
%% two limits.
-spec limits(faultcheck_proper:type()) -> {ok, limits()} | none.
limits(Type) -> faultcheck_proper:limits(Type).

%% @doc The value of the range that is nearest.
-spec clamp(number(), limits()) -> number().
clamp(Value, #{kind := int, min := Min, max := Max}) -> max(Min, min(Max, round(Value)));
clamp(Value, #{kind := real, min := Min, max := Max}) -> max(Min, min(Max, float(Value))).

%% ---- drawing ------------------------------------------------------------------------------

draw(#{kind := Kind, min := Min, max := Max} = Limits) ->
    case at_limit(wanted_bias(Limits)) of
        true -> lists:nth(rand:uniform(2), [Min, Max]);
        false -> uniform(Kind, Min, Max)
    end.

uniform(int, Min, Max) -> Min + rand:uniform(Max - Min + 1) - 1;
uniform(real, Min, Max) -> clamp(Min + rand:uniform() * (Max - Min), limits_of(real, Min, Max)).

limits_of(Kind, Min, Max) -> #{kind => Kind, min => Min, max => Max}.

%% Without a bias nothing is drawn for it: the values are those of a range that has none.
at_limit(Bias) when Bias == 0 -> false;
at_limit(Bias) -> rand:uniform() < Bias.

wanted_bias(#{boundary := false}) -> 0;
wanted_bias(#{boundary := Own}) when is_number(Own) -> Own;
wanted_bias(_) -> bias().

%% @doc The boundary bias of the calling process, or of the run.
-spec bias() -> bias().
bias() ->
    case get({?MODULE, bias}) of
        undefined -> application:get_env(faultcheck, boundary_bias, 0);
        Bias -> Bias
    end.

%% @doc Sets the bias of the calling process, 0 to 1; undefined gives it that of the run.
-spec set_bias(bias() | undefined) -> ok.
set_bias(undefined) ->
    _ = erase({?MODULE, bias}),
    ok;
set_bias(Bias) when is_number(Bias), Bias >= 0, Bias =< 1 ->
    _ = put({?MODULE, bias}, Bias),
    ok.

%% @doc Runs Fun with a bias; that of before holds again afterwards.
-spec with_bias(bias() | undefined, fun(() -> Result)) -> Result.
with_bias(Bias, Fun) ->
    Before = get({?MODULE, bias}),
    ok = set_bias(Bias),
    try
        Fun()
    after
        set_bias(Before)
    end.

%% ---- shrinking ----------------------------------------------------------------------------

%% Integers as PropEr does it: the shrinker of command sequences knows how to bisect those.
shrink(Value, #{kind := int, min := Min, max := Max}, State) ->
    faultcheck_proper:shrink_number(Value, Min, Max, State);
shrink(Value, #{kind := real} = Limits, State) when State =:= init; element(1, State) =:= shrunk ->
    {simpler(Value, Limits), done};
shrink(_Value, _Limits, _State) ->
    {[], done}.

%% Nearer to the simplest value, the boldest first.
simpler(Value, #{min := Min, max := Max} = Limits) ->
    Target = clamp(0.0, Limits),
    Step = step(Max - Min),
    Rounded = [towards(Target, Value, Step * Factor) || Factor <- [1000, 100, 10, 1]],
    Half = towards(Target, (Target + Value) / 2, Step),
    Least = towards(Target, previous(Value, Target, Step), Step),
    Candidates = [Target | Rounded] ++ [Half, Least],
    distinct([C || C <- Candidates, abs(C - Target) < abs(Value - Target)]).

previous(Value, Target, Step) when Value > Target -> Value - Step;
previous(Value, _Target, Step) -> Value + Step.

%% The power of 10 that divides the range into at least so many places.
step(Width) when Width > 0 -> math:pow(10, math:floor(math:log10(Width / ?PLACES)));
step(_) -> 1.0.

%% The multiple of Step, counted from 0, next to Value on the side of Target.
towards(Target, Value, Step) ->
    Steps = Value / Step,
    Whole =
        case Value >= Target of
            true -> math:floor(Steps + 1.0e-9);
            false -> math:ceil(Steps - 1.0e-9)
        end,
    Rounded = Whole * Step,
    case (Value >= Target) =:= (Rounded >= Target) of
        true -> Rounded;
        false -> Target
    end.

distinct([]) -> [];
distinct([Value | Rest]) -> [Value | distinct([V || V <- Rest, V /= Value])].

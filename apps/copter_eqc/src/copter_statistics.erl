%% @doc Rates of rare events, with the interval that they lie in.
-module(copter_statistics).

-export([wilson/2, rate/2]).

%% The normal distribution's 97.5 % quantile.
-define(Z, 1.959963984540054).

%% @doc The 95 % interval of a probability after Events in Tests tests (Wilson's score interval).
-spec wilson(Events :: non_neg_integer(), Tests :: pos_integer()) -> {float(), float()}.
wilson(Events, Tests) ->
    P = Events / Tests,
    Z2 = ?Z * ?Z / Tests,
    Middle = P + Z2 / 2,
    Half = ?Z * math:sqrt(P * (1 - P) / Tests + Z2 / (4 * Tests)),
    {max(0.0, (Middle - Half) / (1 + Z2)), min(1.0, (Middle + Half) / (1 + Z2))}.

%% @doc The rate and its interval: `0.40 % [0.17, 0.93]'.
-spec rate(non_neg_integer(), pos_integer()) -> string().
rate(Events, Tests) ->
    {Low, High} = wilson(Events, Tests),
    [Shown, Least, Most] = [percent(P) || P <- [Events / Tests, Low, High]],
    lists:flatten([Shown, " [", without_sign(Least), ", ", without_sign(Most), "]"]).

without_sign(Percent) -> string:trim(Percent, trailing, " %").

%% With as many digits as it takes to see it.
percent(Share) when Share =< 0 -> "0 %";
percent(Share) when Share < 0.001 -> text("~.3f %", 100 * Share);
percent(Share) when Share < 0.1 -> text("~.2f %", 100 * Share);
percent(Share) -> text("~.1f %", 100 * Share).

text(Format, Value) -> lists:flatten(io_lib:format(Format, [float(Value)])).

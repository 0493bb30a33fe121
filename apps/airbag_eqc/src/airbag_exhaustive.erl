%% @doc Every corruption mask of at most so many bits, against every first data byte.
%%
%% One item of the enumeration is one mask, a permanent corruption of each packet. The packet
%% [x,170] is sent four times, with an iteration each, for all x but 85. A mask is *undetected* if
%% an altered packet was accepted, and *able* if it also turns some [x,170] into [85,170]. *Fired*
%% counts pairs of a mask and a value x that fired the airbag.
-module(airbag_exhaustive).

-export([run/4, table/2, mask/1, hex/1]).
-export_type([mask/0, result/0, count/0]).

-type mask() :: [0..255].
-type count() :: masks | undetected | able | fired.
-type result() :: #{
    counts := #{{count(), Flips :: non_neg_integer()} => pos_integer()},
    %% pairs that fired the airbag, in the order of the masks
    found := [{X :: 0..255, mask()}],
    atom() => term()
}.

-define(FIRE_BYTE, 85).

%% @doc Bytes are the bytes of the packet that masks may touch; Options are those of
%% faultcheck_enumerate.
-spec run(
    thesis | recommended, [0..3], Flips :: non_neg_integer(), faultcheck_enumerate:options()
) -> {ok, result()} | {stopped, result()} | {error, faultcheck_enumerate:reason()}.
run(Configuration, Bytes, Flips, Options) ->
    Positions = [{Byte, Bit} || Byte <- Bytes, Bit <- lists:seq(0, 7)],
    Space = faultcheck_space:map(fun mask/1, faultcheck_space:subsets(Positions, Flips)),
    Airbag = airbag_options:new(#{protection => e2e, configuration => Configuration}),
    faultcheck_enumerate:run(
        Space,
        fun(Mask, _) -> check(Mask) end,
        Options#{
            name => {exhaustive, Configuration, Bytes, Flips, maps:get(name, Options, none)},
            start => fun() -> airbag_eqc:begin_test(Airbag) end,
            stop => fun(ok) -> airbag_sut:stop() end
        }
    ).

%% @doc The mask that flips these bits.
-spec mask([{Byte :: 0..3, Bit :: 0..7}]) -> mask().
mask(Flips) ->
    Bits = fun(Byte) -> lists:sum([1 bsl Bit || {B, Bit} <- Flips, B =:= Byte]) end,
    [Bits(Byte) || Byte <- lists:seq(0, 3)].

check(Mask) ->
    [Result] = airbag_sut:calls([{airbag_sweep, [Mask]}]),
    #{accepted := Accepted, fired := Fired, fired_value := X} = Result,
    Undetected = Accepted > 0,
    Counts = #{
        masks => 1,
        undetected => truth(Undetected),
        able => truth(Undetected andalso able(Mask)),
        fired => Fired
    },
    Flips = flips(Mask),
    {
        maps:from_list([{{Key, Flips}, N} || {Key, N} <- maps:to_list(Counts), N > 0]),
        [{X, Mask} || Fired > 0]
    }.

truth(true) -> 1;
truth(false) -> 0.

%% The second data byte stays 170, and the first one changes.
able([_, First, Second, _]) -> First =/= 0 andalso Second =:= 0.

flips(Mask) -> length([1 || <<1:1>> <= list_to_binary(Mask)]).

%% @doc A count for 0, 1, ... flips.
-spec table(count(), result()) -> [non_neg_integer()].
table(Count, #{counts := Counts}) ->
    Most = lists:max([Flips || {masks, Flips} <- maps:keys(Counts)]),
    [maps:get({Count, Flips}, Counts, 0) || Flips <- lists:seq(0, Most)].

%% @doc A mask as it is written in the reports: 13 40 00 00.
-spec hex(mask()) -> iolist().
hex(Mask) -> lists:join(" ", [io_lib:format("~2.16.0b", [Byte]) || Byte <- Mask]).

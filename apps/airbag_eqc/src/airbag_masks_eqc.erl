%% @doc The airbag under one message and some bit flips that stay: the model for a guided search.
%%
%% A test is one first data byte that is one or two flips away from 85, 0 to 4 flips in bytes 0
%% and 1 of the protected packet, and messages enough to fire. With the thesis configuration two
%% pairs of a value and a mask fire the airbag, both masks of four bits: by chance one test in
%% 5 * 5 * 1820 / 2 = 22 750.
%%
%% The objective is how many bits of what arrives differ from a packet that counts, in the bytes
%% that the checksum protects (`region'), or in the data byte alone (`value').
-module(airbag_masks_eqc).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([search/1, begin_test/1, distance/2]).
-export_type([objective/0]).

-type objective() :: region | value.
-type flip() :: {Byte :: 0..1, Bit :: 0..7}.

-record(state, {
    objective :: objective(),
    value = none :: none | byte(),
    flips = [] :: [flip()],
    sent = false :: boolean()
}).

-define(MOST_FLIPS, 4).
%% The mask fires at the third message at the latest.
-define(MESSAGES, 4).
-define(FIRE_BYTE, 85).

initial_state() ->
    case get(?MODULE) of
        undefined -> #state{objective = region};
        Objective -> #state{objective = Objective}
    end.

faults() -> [flip].

setting() -> [value].

%% 0 to 4 flips, equally likely.
weight(#state{flips = Flips}, flip) -> ?MOST_FLIPS - length(Flips);
weight(_, _) -> 1.

%% ---- value: the first data byte of each message ---------------------------------------------
value_pre(#state{value = Value}) -> Value =:= none.
value_args(_) -> [oneof([84, 87, 117, 213, 21])].
value(_) -> ok.
value_next(S, _, [Value]) -> S#state{value = Value}.

%% ---- flip: a bit of each packet is inverted -------------------------------------------------
flip_pre(#state{value = Value, sent = Sent}) -> Value =/= none andalso not Sent.
flip_args(_) -> [integer(0, 1), integer(0, 7)].
flip_pre(#state{flips = Flips} = S, [Byte, Bit]) ->
    flip_pre(S) andalso
        length(Flips) < ?MOST_FLIPS andalso
        not lists:member({Byte, Bit}, Flips).
flip(Byte, Bit) ->
    [Result] = airbag_sut:calls([
        {faultcheck_packet_addFaultCorruptionBitFlip, [<<"airbag">>, Byte, Bit]}
    ]),
    Result.
flip_next(#state{flips = Flips} = S, _, [Byte, Bit]) -> S#state{flips = [{Byte, Bit} | Flips]}.
%% Which bit it is has no order that would be worth a small step.
flip_mutate(_, _Scale, _) -> [rand:uniform(2) - 1, rand:uniform(8) - 1].

%% ---- messages: a few, each taken at once; the airbag must not fire ---------------------------
messages_pre(#state{value = Value, sent = Sent}) -> Value =/= none andalso not Sent.
messages_args(#state{value = Value}) -> [Value].
messages_pre(#state{value = Value} = S, [Sent]) -> messages_pre(S) andalso Sent =:= Value.
messages(Value) ->
    Calls = [{sensor_e2e, [[Value, 170]]}, {airbag_iteration_e2e, []}],
    Fired = {airbag_is_active, []},
    lists:last(airbag_sut:calls(lists:append(lists:duplicate(?MESSAGES, Calls)) ++ [Fired])).
messages_next(S, _, [_]) -> S#state{sent = true}.
messages_post(_, [_], Active) -> Active =:= 0.
messages_duration([_]) -> 1.

%% ---- for the search -------------------------------------------------------------------------

objective(#state{sent = false}) ->
    {16, now, none};
objective(#state{value = Value, flips = Flips, objective = Objective}) ->
    {distance(Objective, {Value, airbag_exhaustive:mask(Flips)}), now, Value}.

%% Another flip; messages in front of the last flips would cut these off.
insertion(S, _Key) -> [{flip, flip_args(S)}].

%% @doc The bits in which a packet with that value, under that mask, differs from a packet with 85
%% that counts. The checksum is linear (see airbag_crc), so the counter and the Data ID, the same in
%% both, do not matter.
-spec distance(objective(), {byte(), airbag_exhaustive:mask()}) -> 0..16.
distance(value, {Value, [_, First, _, _]}) ->
    bits(First bxor Value bxor ?FIRE_BYTE);
distance(region, {Value, [Checksum, First, _, _]}) ->
    Change = Value bxor ?FIRE_BYTE,
    bits(Checksum bxor airbag_crc:of_difference([Change])) + bits(First bxor Change).

bits(Byte) -> length([1 || <<1:1>> <= <<Byte>>]).

%% @doc Brings the airbag into its state before the first message, with the paper's configuration.
-spec begin_test(objective()) -> ok.
begin_test(Objective) ->
    _ = put(?MODULE, Objective),
    airbag_eqc:begin_test(airbag_options:new(#{configuration => thesis})).

%% @doc Searches for a mask that fires the airbag. Options: `objective', and those of
%% faultcheck_search:search/2.
-spec search(map()) -> {found | not_found, faultcheck_search:result()}.
search(Options) ->
    Objective = maps:get(objective, Options, region),
    %% A single bit is right among sixteen: that takes patience.
    Defaults = #{
        time => 1,
        max_runs => 100000,
        patience => 300,
        immigrants => 0.0,
        begin_test => fun() -> begin_test(Objective) end
    },
    ok = begin_test(Objective),
    faultcheck_search:search(?MODULE, maps:merge(Defaults, maps:remove(objective, Options))).

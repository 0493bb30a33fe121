%% @doc The properties of the airbag (Paper I, section 5).
%%
%% Without protection the airbag fires without cause: those properties must fail, and here they
%% pass when the failure is found, is the expected one, and shrinks to at most three commands.
%% demo/prop_airbag_demo.erl shows the same failure as an ordinary property.
-module(prop_airbag).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([
    prop_safety_plain/0, prop_safety_plain/1,
    prop_safety_plain_focused/0, prop_safety_plain_focused/1,
    prop_safety_one_command/0, prop_safety_one_command/1,
    prop_safety_e2e_thesis/0, prop_safety_e2e_thesis/1,
    prop_safety_e2e_recommended/0, prop_safety_e2e_recommended/1,
    prop_safety_e2e_four_flips/0, prop_safety_e2e_four_flips/1,
    prop_explodes_without_faults/0, prop_explodes_without_faults/1,
    prop_sensor_median/0, prop_sensor_median/1
]).

%% ---- the airbag without protection ----------------------------------------------------------

prop_safety_plain() -> unsafe(#{protection => plain}).

prop_safety_plain(doc) -> "Without protection two faults and a message fire the airbag";
prop_safety_plain(opts) -> [{numtests, 1}, {transport, nif}].

prop_safety_plain_focused() -> unsafe(#{protection => plain, generator => focused}).

prop_safety_plain_focused(doc) -> "As prop_safety_plain, with messages close to [85,170]";
prop_safety_plain_focused(opts) -> [{numtests, 1}, {transport, nif}].

prop_safety_one_command() -> unsafe(#{protection => plain, needed => 1}).

prop_safety_one_command(doc) -> "Where one message fires the airbag, one bit flip does";
prop_safety_one_command(opts) -> [{numtests, 1}, {transport, nif}].

unsafe(Changes) ->
    Options = airbag_options:new(Changes),
    ?FORALL(Seed, uniform(0, 16#FFFFFFFF), airbag_unsafe:fails_as_expected(Options, Seed)).

%% ---- the airbag with E2E profile 1 ----------------------------------------------------------

%% DataLength 16 leaves bytes 2 and 3 open: flips there may fire nothing as long as the second
%% data byte is always 170. Up to two flips in all hold; with four, three masks do not.
prop_safety_e2e_thesis() -> safe(#{configuration => thesis, max_flips => 2}).

prop_safety_e2e_thesis(doc) -> "The paper's E2E configuration holds against two bit flips";
prop_safety_e2e_thesis(opts) -> [{numtests, 500}, {transport, nif}].

prop_safety_e2e_recommended() -> safe(#{configuration => recommended, max_flips => 2}).

prop_safety_e2e_recommended(doc) -> "The recommended configuration holds against two bit flips";
prop_safety_e2e_recommended(opts) -> [{numtests, 500}, {transport, nif}].

safe(Changes) -> airbag_eqc:safe(airbag_options:new(Changes#{protection => e2e})).

%% With four flips it may fire, but only under a mask that the CRC cannot see.
prop_safety_e2e_four_flips() ->
    ?FORALL(
        Configuration,
        oneof([thesis, recommended]),
        begin
            Airbag = airbag_options:new(#{configuration => Configuration, generator => focused}),
            ok = airbag_options:use(Airbag),
            ?FORALL(Commands, commands(airbag_eqc), begin
                ok = airbag_eqc:begin_test(Airbag),
                {History, _, Result} = run_commands(airbag_eqc, Commands),
                Result =:= ok orelse unseen(Configuration, element(1, lists:last(History)))
            end)
        end
    ).

prop_safety_e2e_four_flips(doc) -> "Only masks that the CRC cannot see fire the protected airbag";
prop_safety_e2e_four_flips(opts) -> [{numtests, 500}, {transport, nif}].

unseen(Configuration, State) ->
    Flips = [{Byte, Bit} || {bitflip, Byte, Bit} <- airbag_eqc:armed_faults(State)],
    airbag_test_crc:misses(Configuration, airbag_exhaustive:mask(Flips)).

%% ---- without faults -------------------------------------------------------------------------

%% Every variant fires when it must, after any messages, and at no other time.
prop_explodes_without_faults() ->
    ?FORALL(
        {Changes, Messages},
        {oneof(variants()), list(?SUCHTHAT([X, _], [byte(), 170], X =/= 85))},
        begin
            Options = airbag_options:new(Changes#{faults => []}),
            ok = airbag_eqc:begin_test(Options),
            Commands = numbered([{sensor, [M]} || M <- Messages] ++ [{explosion, [[85, 170]]}]),
            {_, _, Result} = Run = run_commands(airbag_eqc, Commands),
            ?WHENFAIL(
                io:put_chars(faultcheck_statem:pretty(airbag_eqc, Commands, Run)),
                Result =:= ok
            )
        end
    ).

prop_explodes_without_faults(doc) -> "Without faults every variant fires when it must";
prop_explodes_without_faults(opts) -> [{transport, nif}].

variants() ->
    [
        #{protection => plain},
        #{protection => plain, needed => 1},
        #{configuration => thesis},
        #{configuration => recommended}
    ].

numbered(Calls) ->
    Numbers = lists:seq(1, length(Calls)),
    [{set, {var, N}, {call, airbag_eqc, F, Args}} || {N, {F, Args}} <- lists:zip(Numbers, Calls)].

%% ---- three redundant sensors ----------------------------------------------------------------

%% The median stays between the two sensors that work, whatever the third one says.
prop_sensor_median() ->
    ?FORALL(
        {Values, Broken, Fault},
        {vector(3, uniform(-1000000, 1000000)), integer(1, 3), fault()},
        begin
            ok = airbag_eqc:begin_test(airbag_options:new(#{})),
            Probe = lists:nth(Broken, [<<"S1val">>, <<"S2val">>, <<"S3val">>]),
            [Clean, _, Faulty] = airbag_sut:calls([
                {sensor_evaluate, Values}, arm(Probe, Fault), {sensor_evaluate, Values}
            ]),
            Working = [V || {N, V} <- lists:zip([1, 2, 3], Values), N =/= Broken],
            Clean =:= lists:nth(2, lists:sort(Values)) andalso
                Faulty >= lists:min(Working) andalso
                Faulty =< lists:max(Working)
        end
    ).

prop_sensor_median(doc) -> "One broken sensor of three is outvoted";
prop_sensor_median(opts) -> [{transport, nif}].

fault() ->
    oneof([
        {bit_flip, integer(0, 31)},
        {offset, uniform(-2000000, 2000000)},
        {set_to, oneof([-2147483648, 2147483647, uniform(-2000000, 2000000)])}
    ]).

arm(Probe, {bit_flip, Bit}) -> {faultcheck_addFaultBitFlip, [Probe, Bit]};
arm(Probe, {offset, Offset}) -> {faultcheck_addFaultOffset, [Probe, Offset]};
arm(Probe, {set_to, Value}) -> {faultcheck_addFaultSetTo, [Probe, Value]}.

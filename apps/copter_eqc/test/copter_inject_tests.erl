%% What the visualizer's form for injecting a fault offers, asked of the player and armed in
%% libfaultcheck: every model of the form's catalogue, with the values that its fields allow.
%%
%% Models and parameters come from the file the form has them from. What a field of each kind allows
%% is written here as visualizer/page/src/panels/fault_catalogue.ts has it; a kind that is not known
%% here fails.
-module(copter_inject_tests).
-include_lib("eunit/include/eunit.hrl").

-define(TOKEN, <<"token">>).

%% ---- what the form offers ---------------------------------------------------------------------

models(Where) ->
    Path = "visualizer/page/src/panels/generated/fault_models.json",
    {ok, Text} = file:read_file(filename:join(root(code:lib_dir(faultcheck)), Path)),
    {ok, #{<<"models">> := Models}} = faultcheck_json:decode(Text),
    [M || #{<<"class">> := C} = M <- Models, (C =:= <<"communication">>) =:= (Where =:= channel)].

%% The clone, from _build/PROFILE/lib/faultcheck.
root(Dir) -> lists:foldl(fun(_, D) -> filename:dirname(D) end, Dir, [1, 2, 3, 4]).

name(#{<<"name">> := Name}) -> Name.

%% Filled forms of a model: in the n-th each field has the n-th of its values, or again the first.
forms(#{<<"name">> := Model, <<"parameters">> := Parameters}) ->
    Fields = lists:append([
        case Kind of
            <<"natural">> -> [{string:lowercase(Name), [0, 1, natural(Model)]}];
            _ -> fields(Kind, string:lowercase(Name))
        end
     || #{<<"name">> := Name, <<"kind">> := Kind} <- Parameters
    ]),
    Most = lists:max([1 | [length(Values) || {_, Values} <- Fields]]),
    [
        maps:from_list(lists:append([
            filled(Name, lists:nth((N - 1) rem length(Values) + 1, Values))
         || {Name, Values} <- Fields
        ]))
     || N <- lists:seq(1, Most)
    ].

filled(_, nothing) -> [];
filled(_, Several) when is_map(Several) -> maps:to_list(Several);
filled(Name, Value) -> [{Name, Value}].

-define(MOST, 16#20000000000000).

%% The smallest, the proposed and the largest value, or all choices.
fields(<<"bit">>, Name) -> [{Name, [0, 1023]}];
fields(<<"bit_of_byte">>, Name) -> [{Name, [0, 7]}];
fields(<<"bit_value">>, Name) -> [{Name, [0, 1]}];
fields(<<"byte">>, Name) -> [{Name, [0, 255]}];
fields(<<"count">>, Name) -> [{Name, [1, 10, 100000000, ?MOST]}];
fields(<<"any_real">>, Name) -> [{Name, [<<"-inf">>, 1, <<"inf">>, <<"nan">>, -1.0e308, 1.0e308]}];
fields(<<"real">>, Name) -> [{Name, [<<"-inf">>, 0.1, <<"inf">>, -1.0e308, 1.0e308]}];
fields(<<"positive">>, Name) -> [{Name, [1.0e-308, 0.1, <<"inf">>, 1.0e308]}];
fields(<<"probability">>, Name) -> [{Name, [0, 0.1, 1]}];
fields(<<"limit">>, Name) -> [{Name, [nothing, 0, <<"inf">>, 1.0e308]}];
fields(<<"dropout_mode">>, Name) -> [{Name, [<<"hold">>, <<"zero">>, <<"nan">>]}];
fields(<<"name">>, Name) -> [{Name, [<<"ITS_DATA1">>, <<"x">>]}];
fields(<<"data">>, Name) -> [{Name, [<<"00">>, binary:copy(<<"fF">>, 92)]}];
fields(<<"receivers">>, Name) -> [{Name, [<<"a">>, <<"ITS_DATA0, ITS_DATA1">>]}];
fields(<<"delay">>, _) -> [{<<"calls">>, [1, 10, ?MOST]}];
fields(<<"channel_delay">>, _) -> [{<<"ns">>, [0, 200000000, ?MOST]}];
fields(<<"field">>, _) -> part([]);
fields(<<"part">>, _) -> part([nothing]);
fields(<<"model">>, _) -> [{<<"apply">>, [applied(M) || M <- models(probe)]}].

natural(<<"corruption">>) -> 16#7FFFFFFF;
natural(<<"extend">>) -> 65536;
natural(<<"repeat">>) -> 10000;
natural(_) -> ?MOST.

part(Whole) ->
    Types = [<<"f32">>, <<"f64">>, <<"i8">>, <<"i16">>, <<"i32">>, <<"i64">>, <<"u8">>, <<"u16">>,
             <<"u32">>, <<"u64">>, <<"bool">>, <<"bytes">>],
    [{<<"type">>, Whole ++ Types}, {<<"byte">>, [0, 91, ?MOST]}, {<<"big_endian">>, [0, 1]},
     {<<"length">>, [nothing, 0, ?MOST]}].

%% With what the form proposes.
applied(Model) ->
    Forms = forms(Model),
    (lists:nth(min(2, length(Forms)), Forms))#{<<"apply">> => name(Model)}.

windows() ->
    [
        #{}, #{from_s => 0}, #{from_s => 0, for_s => 0.1}, #{from_s => 0.05, for_s => 1.0e6},
        #{from_s => 1.0e6}, #{from_calls => 0}, #{from_calls => 0, for_calls => 1},
        #{from_calls => 3, for_calls => 16#FFFFFFFF}, #{from_calls => 16#FFFFFFFF}
    ].

text(Place, Model, Params, Window) ->
    faultcheck_json:encode(Window#{probe => Place, model => Model, params => Params}).

%% ---- a flight ---------------------------------------------------------------------------------

%% Two copters, 6 m from each other; a simulated second takes 50 ms.
flight() ->
    _ = put(now, 0),
    {ok, _, P0} = replay_player:open(#{
        opening => {view, live}, number => 1, view => copter_view, token => ?TOKEN,
        cases => "/nonexistent", scenarios => "/nonexistent", playing => true, speed => 20.0
    }, 0),
    {1, _, P1} = ask(<<"add_object">>, [-3.0, 0.0], <<>>, P0),
    {1, _, P2} = ask(<<"add_object">>, [3.0, 0.0], <<>>, P1),
    P2.

ask(Verb, Args, Text, P0) ->
    Seq = case get(seq) of undefined -> 1; N -> N + 1 end,
    _ = put(seq, Seq),
    {Out, P1} = replay_player:control(
        #{client => <<"c">>, token => ?TOKEN, seq => Seq, verb => Verb, object => -1,
          args => Args, text => Text},
        sender, get(now), P0
    ),
    [#{ok := Ok, text := Line}] = [M || {publish, {ack, M}} <- Out],
    {Ok, unicode:characters_to_list(Line), P1}.

flown(SimulatedUs, P0) ->
    Now = get(now) + SimulatedUs div 20,
    _ = put(now, Now),
    {_, P1} = replay_player:wake(Now, replay_player:refresh(P0)),
    P1.

%% Time, verdict and active faults.
seen(P) ->
    {Out, _} = replay_player:wake(get(now), replay_player:refresh(P)),
    [#{t_us := T, verdict := Verdict} | _] = [M || {publish, {status, M}} <- Out],
    [#{items := Items} | _] = [M || {publish, {faults, M}} <- Out],
    {T, Verdict, [{Place, Model} || #{probe := Place, type := Model, to_us := To} <- Items,
                                    To =:= -1 orelse To > T]}.

%% ---- every model ------------------------------------------------------------------------------

probes() ->
    [<<"PxId0">>, <<"PyId1">>, <<"RollId0">>, <<"PitchId1">>, <<"YawId0">>, <<"ClockId1">>,
     <<"RangeId0Anch1">>, <<"AnchXId1Anch0">>, <<"AnchYId0Anch1">>, <<"AnchZId1Anch1">>].

every_model_is_armed_with_all_its_values_test_() ->
    [
        {timeout, 120, {atom_to_list(Where), fun() ->
            Models = models(Where),
            ?assert(length(Models) >= 17),
            Forms = [{name(M), Form} || M <- Models, Form <- forms(M)],
            _ = [armed(nth_of(N, Places), Model, Form, #{})
                 || {N, {Model, Form}} <- numbered(Forms)],
            ok = copter_sut:stop()
        end}}
     || {Where, Places} <- [{probe, probes()}, {channel, [<<"ITS_DATA0">>, <<"ITS_DATA1">>]}]
    ].

every_model_is_armed_at_every_probe_test_() ->
    {timeout, 120, fun() ->
        P0 = flown(100000, flight()),
        P1 = lists:foldl(
            fun({Place, M}, P) ->
                Form = lists:last(lists:sublist(forms(M), 2)),
                {1, "", Next} = ask(<<"inject">>, [], text(Place, name(M), Form, #{}), P),
                Next
            end,
            P0,
            [{Place, M} || M <- models(probe), Place <- probes()]
        ),
        {_, 0, Active} = seen(P1),
        ?assertEqual(length(models(probe)) * length(probes()), length(Active)),
        {1, "", P2} = ask(<<"clear_faults">>, [], <<>>, P1),
        {_, 0, []} = seen(P2),
        ok = copter_sut:stop()
    end}.

numbered(List) -> lists:zip(lists:seq(1, length(List)), List).

nth_of(N, List) -> lists:nth(N rem length(List) + 1, List).

armed(Place, Model, Params, Window) ->
    Text = text(Place, Model, Params, Window),
    P0 = flown(100000, flight()),
    {T0, 0, []} = seen(P0),
    {Ok, Line, P1} = ask(<<"inject">>, [], Text, P0),
    ?assertEqual({Text, 1, ""}, {Text, Ok, Line}),
    {T0, 0, [{Place, Model}]} = seen(P1),
    P2 = flown(200000, P1),
    ?assertMatch({Text, {T, 0, _}} when T =:= T0 + 200000, {Text, seen(P2)}),
    {1, "", P3} = ask(<<"clear_faults">>, [], <<>>, P2),
    ?assertMatch({Text, {T, 0, []}} when T =:= T0 + 400000, {Text, seen(flown(200000, P3))}).

every_window_is_taken_test_() ->
    {timeout, 60, fun() ->
        _ = [
            armed(Place, Model, Params, Window)
         || {Place, Model, Params} <- [
                {<<"RangeId0Anch0">>, <<"offset">>, #{constant => 0.1}},
                {<<"PxId1">>, <<"stuck">>, #{}},
                {<<"ITS_DATA1">>, <<"lose">>, #{}}
            ],
            Window <- windows()
        ],
        ok = copter_sut:stop()
    end}.

%% ---- what is not allowed ----------------------------------------------------------------------

%% Of each model: without each parameter that it needs, with one it does not have, with a text for a
%% number and the other way round.
wrong_values_change_nothing_test_() ->
    {timeout, 120, fun() ->
        P0 = flown(100000, flight()),
        Before = seen(P0),
        P1 = lists:foldl(
            fun({Place, Model, Params}, P) ->
                {Ok, Line, Next} = ask(<<"inject">>, [], text(Place, Model, Params, #{}), P),
                ?assertEqual({Model, Params, 0}, {Model, Params, Ok}),
                ?assertMatch("inject: " ++ [_, _, _, _, _ | _], Line),
                ?assertEqual(nomatch, string:find(Line, "\n")),
                ?assertEqual(nomatch, string:find(Line, "fly_inject")),
                Next
            end,
            P0,
            [
                {Place, name(M), Wrong}
             || {Where, Place} <- [{probe, <<"PxId0">>}, {channel, <<"ITS_DATA1">>}],
                M <- models(Where), Wrong <- wrong(M)
            ]
        ),
        ?assertEqual(Before, seen(P1)),
        {_, Verdict, []} = seen(flown(200000, P1)),
        ?assertEqual(0, Verdict),
        ok = copter_sut:stop()
    end}.

%% A model without what is optional may stand alone.
wrong(Model) ->
    [Form | _] = forms(Model),
    Optional = [<<"limit">>, <<"byte">>, <<"type">>, <<"big_endian">>, <<"length">>, <<"times">>,
                <<"count">>, <<"packets">>],
    Needed = maps:keys(maps:without(Optional, Form)),
    [Form#{<<"no_such">> => 1}] ++
        [maps:remove(Name, Form) || Name <- Needed] ++
        [Form#{Name => other(V)} || {Name, V} <- maps:to_list(maps:with(Needed, Form))].

other(<<"inf">>) -> <<"much">>;
other(<<"-inf">>) -> <<"much">>;
other(Text) when is_binary(Text) -> 1;
other(_) -> <<"much">>.

what_would_stop_the_clock_is_refused_test() ->
    P = flight(),
    [
        ?assertMatch({0, Line, _}, ask(<<"inject">>, [], text(<<"ITS_DATA0">>, M, Params, #{}), P))
     || {M, Params, Line} <- [
            {<<"repeat">>, #{packets => 10001}, "inject: packets: 10000 are the most"},
            {<<"extend">>, #{count => 65537, byte => 0}, "inject: count: 65536 are the most"}
        ]
    ],
    ok = copter_sut:stop().

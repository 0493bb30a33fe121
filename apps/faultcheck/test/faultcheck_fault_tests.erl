-module(faultcheck_fault_tests).

-include_lib("eunit/include/eunit.hrl").

-export([examples/0]). % of every model

a_fault_is_a_model_or_a_model_with_a_trigger_test() ->
    ?assertEqual({{offset, 2.5}, []}, faultcheck_fault:normal({offset, 2.5})),
    ?assertEqual({{offset, 2}, [{from, 3}]}, faultcheck_fault:normal({{offset, 2}, [{from, 3}]})),
    ?assertEqual({lose, []}, faultcheck_fault:normal(lose)),
    ?assertEqual({lose, [{for, 1}]}, faultcheck_fault:normal({lose, [{for, 1}]})),
    ?assertEqual({{subset, [<<"x">>]}, []}, faultcheck_fault:normal({subset, [<<"x">>]})).

good_faults_are_valid_test_() ->
    [?_assertEqual(ok, faultcheck_fault:validate(Fault)) || Fault <- examples()].

%% One of each model; a model that is new in the catalogue must come in here.
the_examples_cover_the_catalogue_test() ->
    Covered = [{faultcheck_fault:class(F), element(1, {name(faultcheck_fault:model(F))})}
               || F <- examples()],
    Models = faultcheck_fault_catalogue:models(),
    Known = [{Class, Name} || #{class := Class, name := Name} <- Models],
    ?assertEqual([], Known -- Covered).

name(Model) when is_atom(Model) -> Model;
name(Model) -> element(1, Model).

examples() ->
    [
        {bitflip, 31}, bitflip_random, stuck, {stuck_bit, 3, 1}, {amplification, -1.5},
        {{offset, nan}, [{from, 10}, {for, 2}]}, {set_to, inf}, {noise_uniform, 0.5},
        {noise_gauss, 2}, {random_offset, neg_inf, 3}, {held_offset, -4, 4, 1000},
        {drift, 0.1, none}, {drift_timed, 0.1, 5.0}, {ramp, 10, 4}, {delay, {calls, 3}},
        {quantise, 0.25}, {dead_zone, 0, 1}, {saturate, -1, 1}, {oscillate, 1.0, 8},
        {dropout, 0.5, nan},
        {{spike, 0.1, 9}, [{random, 0.5}]}, {corruption, 2, 7}, {field, {0, u16, big}, {offset, 1}},
        {truncate, 0}, {extend, 2, 255}, {drop, 1}, {lose, [{periodic, 4, 1}]}, {repeat, 2},
        repeat_last, {insert, <<1, 0, 2>>, 1}, {masquerade, <<"other">>}, {resequence, 1},
        block_get, {delay, {gets, 2}}, {delay, {ns, 1500000}}, {misroute, <<"other">>},
        {{asymmetric, [<<"x">>], whole, {bitflip, 3}}, [{time, 0, forever}]},
        {asymmetric, [<<"x">>, <<"y">>], {2, bytes, 0}, {set_to, 0}},
        {subset, [<<"x">>]}, {block_put, [{predicate, busy}]}
    ].

a_bad_fault_is_told_in_one_line_test_() ->
    [
        ?_assertEqual({error, Line}, faultcheck_fault:validate(Fault))
     || {Fault, Line} <- [
            {{bitfilp, 3}, "fault {bitfilp,3}: there is no model bitfilp; did you mean bitflip?"},
            {{bitflip, -1}, "fault {bitflip,-1}: Bit is -1, expected an integer from 0 up"},
            {bitflip, "fault bitflip: expected {bitflip, Bit}"},
            {17, "fault 17: expected a model of docs/faults.md"},
            {{corruption, 0, 8}, "fault {corruption,0,8}: Bit is 8, expected an integer 0..7"},
            {{saturate, 2, 1}, "fault {saturate,2,1}: Low is 2, expected at most High, 1"},
            {{delay, 3}, "fault {delay,3}: Delay is 3, expected {calls, N}, {gets, N} or {ns, N} "
                         "with N from 0 up"},
            {{spike, 1.5, 1}, "fault {spike,1.5,1}: Probability is 1.5, expected a number 0..1"},
            {{masquerade, <<0>>}, "fault {masquerade,<<0>>}: From is <<0>>, expected a binary "
                                  "without zero bytes"},
            {{field, {0, u8, big}, lose},
             "fault {field,{0,u8,big},lose}: Model is lose, expected a model of a probe or sensor"},
            {{stuck, [{from, -1}]}, "trigger {from,-1}: expected {from, N} with N from 0 up"},
            {{stuck, [often]}, "trigger often: expected one of from, for, time, random, periodic, "
                               "predicate"},
            {{stuck, [{for, 1}, {for, 2}]},
             "trigger [{for,1},{for,2}]: for stands there twice"}
        ]
    ].

a_long_fault_is_told_in_one_line_too_test() ->
    {error, Line} = faultcheck_fault:validate({insert, binary:copy(<<200>>, 300), -1}),
    ?assertEqual(nomatch, string:find(Line, "\n")).

classes_and_stages_test() ->
    ?assertEqual({probe, probe}, place({bitflip, 3})),
    ?assertEqual({sensor, probe}, place({delay, {calls, 3}})),
    ?assertEqual({communication, put}, place({delay, {gets, 3}})),
    ?assertEqual({communication, get}, place({lose, [{for, 3}]})).

place(Fault) -> {faultcheck_fault:class(Fault), faultcheck_fault:stage(Fault)}.

every_fault_has_one_line_for_people_test_() ->
    [
        ?_test(begin
            Line = faultcheck_fault:describe(Fault),
            ?assertEqual(nomatch, string:find(Line, "\n")),
            ?assert(string:length(Line) > 8)
        end)
     || Fault <- examples()
    ].

descriptions_test_() ->
    [
        ?_assertEqual(Line, faultcheck_fault:describe(Fault))
     || {Fault, Line} <- [
            {{bitflip, 3}, "invert bit 3, always"},
            {{{offset, 2.5}, [{from, 100}, {for, 20}]}, "add 2.5, 20 times from call 101 on"},
            {{{drop, 1}, [{for, 1}]}, "drop 1 packet, once, at call 1"},
            {{lose, [{periodic, 5, 2}]}, "drop a packet each time, 2 of every 5 calls"},
            {{lose, [{random, 0.1}, {from, 2}]},
             "drop a packet each time, from call 3 on, with probability 0.1"},
            {{field, {2, i16, big}, {drift, 1, none}},
             "drift by 1 each call in the big-endian i16 at byte 2, always"},
            {{delay, {ns, 1500000}}, "delay by 1500 us, always"}
        ]
    ].

%% ---- docs/faults.md ---------------------------------------------------------------------------

%% Made with `faultcheck_fault_catalogue:markdown/0'.
the_page_is_up_to_date_test() ->
    {ok, Page} = file:read_file(page()),
    ?assertEqual(unicode:characters_to_binary(faultcheck_fault_catalogue:markdown()), Page).

page() ->
    filename:join([root(code:lib_dir(faultcheck)), "docs", "faults.md"]).

%% Made with `faultcheck_fault_catalogue:json/0'.
the_list_of_the_visualizers_form_is_up_to_date_test() ->
    Path = "visualizer/page/src/panels/generated/fault_models.json",
    {ok, List} = file:read_file(filename:join(root(code:lib_dir(faultcheck)), Path)),
    ?assertEqual(faultcheck_fault_catalogue:json(), List).

%% The clone, from _build/PROFILE/lib/faultcheck.
root(Dir) -> lists:foldl(fun(_, D) -> filename:dirname(D) end, Dir, [1, 2, 3, 4]).

-module(faultcheck_json_tests).
-include_lib("eunit/include/eunit.hrl").

encode_test_() ->
    [
        ?_assertEqual(Text, faultcheck_json:encode(Json))
     || {Json, Text} <- [
            {null, <<"null">>},
            {true, <<"true">>},
            {failed, <<"\"failed\"">>},
            {-3, <<"-3">>},
            {0.5, <<"0.5">>},
            {[], <<"[]">>},
            {#{}, <<"{}">>},
            {{text, "a\"b\\c\n\t\e"}, <<"\"a\\\"b\\\\c\\n\\t\\u001b\"">>},
            {{text, [228, 8364]}, <<"\"ä€"/utf8, "\"">>},
            {<<255>>, <<"\"ÿ\""/utf8>>},
            {#{b => 1, a => [1, null]}, <<"{\"a\":[1,null],\"b\":1}">>},
            {{object, [{b, 1}, {a, 2}]}, <<"{\"b\":1,\"a\":2}">>}
        ]
    ].

pretty_test() ->
    ?assertEqual(
        <<"{\n  \"a\": [\n    1,\n    2\n  ],\n  \"b\": {}\n}\n">>,
        faultcheck_json:pretty(#{a => [1, 2], b => #{}})
    ).

decode_test_() ->
    [
        ?_assertEqual({ok, Value}, faultcheck_json:decode(Text))
     || {Text, Value} <- [
            {<<" {\"a\" : [ 1 , -2.5e1, true ] } ">>, #{<<"a">> => [1, -25.0, true]}},
            {<<"1e3">>, 1000.0},
            {<<"-1E+2">>, -100.0},
            {<<"\"\\u00e4\\ud83d\\ude00\\n\"">>, <<"ä😀\n"/utf8>>},
            {<<"[]">>, []},
            {<<"{}">>, #{}}
        ]
    ].

errors_tell_the_offset_test_() ->
    [
        ?_assertEqual({error, {offset, Offset}}, faultcheck_json:decode(Text))
     || {Text, Offset} <- [
            {<<>>, 0},
            {<<"[1,]">>, 3},
            {<<"{\"a\":1,}">>, 7},
            {<<"{\"a\" 1}">>, 5},
            {<<"[1 2]">>, 3},
            {<<"nul">>, 0},
            {<<"\"abc">>, 4},
            {<<"1 x">>, 2},
            {<<"\"\\ud800\"">>, 3}
        ]
    ].

prop_test() ->
    Round = proper:quickcheck(round_trip(), [quiet, {numtests, 100}, {max_size, 12}]),
    ?assertEqual(true, Round).

%% Whatever is encoded reads back as itself, plain or pretty.
round_trip() ->
    proper:forall(value(), fun(Value) ->
        lists:all(
            fun(Text) -> {ok, Value} =:= faultcheck_json:decode(Text) end,
            [faultcheck_json:encode(Value), faultcheck_json:pretty(Value)]
        )
    end).

value() -> proper_types:sized(fun value/1).

value(0) ->
    proper_types:oneof([null, true, false, proper_types:integer(), proper_types:float(), text()]);
value(Size) ->
    Smaller = proper_types:lazy(fun() -> value(Size div 3) end),
    Few = fun(Type) -> proper_types:resize(4, Type) end,
    proper_types:oneof([value(0), Few(proper_types:list(Smaller)), Few(object(Smaller))]).

text() -> proper_types:bind(unicode(), fun(T) -> T end, false).

unicode() -> proper_unicode:utf8().

object(Values) ->
    Pairs = proper_types:list({text(), Values}),
    proper_types:bind(Pairs, fun maps:from_list/1, false).

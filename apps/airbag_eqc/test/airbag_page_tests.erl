-module(airbag_page_tests).
-include_lib("eunit/include/eunit.hrl").

page_test_() ->
    {setup, fun airbag_test_sut:port/0, fun(_) -> airbag_sut:stop() end, [
        {"the page says what is in the trace", fun numbers/0},
        {"the same case gives the same bytes", fun again/0},
        {"a wrong checksum is told with the right one", fun checksum/0},
        {"what a command holds is text", fun hostile/0},
        {"it loads nothing and runs nothing", fun inert/0},
        {"an airbag that stays silent is told as that", fun silent/0},
        {"an airbag that fired as it was told to is not blamed", fun told_to/0},
        {"every number of the tables is in the picture", fun picture/0}
    ]}.

stored(Calls) ->
    Commands = [
        {set, {var, N}, {call, airbag_eqc, Name, Args}}
     || {N, {Name, Args}} <- lists:zip(lists:seq(1, length(Calls)), Calls)
    ],
    #{
        module => prop_airbag,
        property => prop_safety_plain,
        status => failed,
        seed => 4711,
        test => 3,
        size => 20,
        transport => nif,
        options => ["-m", "prop_airbag", "--seed", "4711"],
        versions => #{faultcheck => "0", proper => "0", otp => "0", git => "0"},
        original => [Commands ++ Commands],
        shrunk => [Commands],
        reasons => ["postcondition false"],
        shrink => #{}
    }.

plain() -> airbag_options:new(#{protection => plain}).

unsafe() -> [{bit_flip, [0, 0]}, {repetition, [1]}, {sensor, [[84, 170]]}].

page(Options, Calls) ->
    #{shrunk := [Commands]} = Case = stored(Calls),
    Trace = airbag_trace:run(Options, Commands),
    {unicode:characters_to_binary(airbag_page:format(Case, Trace)), Trace}.

numbers() ->
    {Page, Trace} = page(plain(), unsafe()),
    has(Page, "The airbag fired without cause"),
    has(Page, "shrunk from 6"),
    has(Page, "sent 54 aa; what arrived as packet 2 is 55 aa"),
    has(Page, "It is activation message 2 in succession, and 2 fire the airbag."),
    Rows = rows(Page, "h-packets"),
    Expected = [
        [integer_to_binary(N), integer_to_binary(At), <<"byte 0 bit 0">>, <<"[85,170]">>,
            integer_to_binary(Count), airbag(Fired)]
     || {N, At, #{activations := Count, fired := Fired}} <- airbag_trace:packets(Trace)
    ],
    ?assertEqual(Expected, [[lists:nth(I, Row) || I <- [1, 2, 5, 6, 7, 8]] || Row <- Rows]),
    %% 84 and 85 as bits
    [[_, _, Sent, Received | _] | _] = Rows,
    ?assertEqual(<<"54 01010100 aa 10101010">>, Sent),
    ?assertEqual(<<"55 01010101 aa 10101010">>, Received).

airbag(true) -> <<"fired">>;
airbag(false) -> <<"silent">>.

again() ->
    {First, _} = page(plain(), unsafe()),
    {Second, _} = page(plain(), unsafe()),
    ?assertEqual(First, Second).

%% What the checksum of the altered bytes ought to be, by division of polynomials.
checksum() ->
    Options = airbag_options:new(#{protection => e2e, configuration => recommended}),
    {Page, Trace} = page(Options, [{bit_flip, [2, 3]}, {sensor, [[7, 170]]}]),
    [{1, 2, #{bytes := <<Crc, Rest/binary>>}}] = airbag_trace:packets(Trace),
    Right = e2e_crc:remainder(crc8, <<16#23, 16#01, Rest/binary>>),
    [Row] = rows(Page, "h-packets"),
    Told = io_lib:format("~2.16.0b wrong, not ~2.16.0b", [Crc, Right]),
    ?assertEqual(unicode:characters_to_binary(Told), lists:nth(7, Row)),
    ?assertEqual(<<"WRONGCRC">>, lists:nth(9, Row)).

%% A case that somebody has edited; the second command's precondition raises.
hostile() ->
    Text = list_to_atom("</script><script>alert(1)</script> & \"x\" \x{1F4A5}"),
    {Page, _} = page(plain(), [{sensor, [[1, 2]]}, {bit_flip, [Text, '<b>']}]),
    ?assertEqual(nomatch, binary:match(Page, <<"<script">>)),
    ?assertEqual(nomatch, binary:match(Page, <<"<b>">>)),
    has(Page, "&lt;script&gt;alert(1)").

inert() ->
    {Page, _} = page(plain(), unsafe()),
    has(Page, "default-src 'none'"),
    [
        ?assertEqual({Word, nomatch}, {Word, binary:match(Page, Word)})
     || Word <- [<<"<script">>, <<"<link">>, <<"<img">>, <<"src=">>, <<"url(">>, <<"onload">>]
    ].

silent() ->
    Options = airbag_options:new(#{protection => plain, needed => 3}),
    Case = stored([{explosion, [[85, 170]]}]),
    #{shrunk := [Commands]} = Case,
    #{steps := [Step]} = Trace = airbag_trace:run(Options, Commands),
    %% as it would be of an airbag that needs one message more than it is to
    Failing = Trace#{
        result := {postcondition, false}, steps := [Step#{value := {value, 0}}]
    },
    Page = unicode:characters_to_binary(airbag_page:format(Case, Failing)),
    has(Page, "The airbag did not fire when it was told to"),
    has(Page, "[85,170] was sent 3 times").

told_to() ->
    {Page, _} = page(plain(), [{explosion, [[85, 170]]} | unsafe()]),
    Rows = rows(Page, "h-packets"),
    ?assertEqual(
        [<<"silent">>, <<"fired">>, <<"silent">>, <<"fired">>], [lists:last(Row) || Row <- Rows]
    ),
    has(Page, "Command 4, sensor([84,170]), sent 54 aa; what arrived as packet 4 is 55 aa"),
    has(Page, "fired, as told"),
    ?assertEqual(1, length(binary:matches(Page, <<">FIRED<">>))),
    %% the last packet, and the command that failed
    ?assertEqual(2, length(binary:matches(Page, <<"<tr class=\"bad\">">>))).

picture() ->
    {Page, _} = page(plain(), unsafe()),
    [_, Rest] = binary:split(Page, <<"<svg">>),
    [Svg, _] = binary:split(Rest, <<"</svg>">>),
    Texts = ["<title", "<desc", "byte 0 bit 0 inverted", ">FIRED<", "2 fire it"],
    [has(Svg, Text) || Text <- Texts],
    ?assertEqual(2, length(binary:matches(Svg, <<"class=\"packet altered\"">>))).

%% ---- reading a page ---------------------------------------------------------------------------

has(Page, Text) ->
    Bytes = unicode:characters_to_binary(Text),
    ?assertNotEqual({Text, nomatch}, {Text, binary:match(Page, Bytes)}).

%% The cells of the table behind a heading, as a reader sees them.
rows(Page, Heading) ->
    [_, Behind] = binary:split(Page, iolist_to_binary(["id=\"", Heading])),
    [_, Body] = binary:split(Behind, <<"<tbody>">>),
    [Table, _] = binary:split(Body, <<"</tbody>">>),
    [
        [visible(Cell) || Cell <- tl(binary:split(Row, <<"<td>">>, [global]))]
     || Row <- tl(binary:split(Table, <<"<tr">>, [global]))
    ].

visible(Cell) ->
    Text = re:replace(Cell, "<[^>]*>", "", [global, {return, binary}]),
    string:trim(Text).

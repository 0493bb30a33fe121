%% @doc The report of a failure of the airbag: one page that loads and runs nothing.
-module(airbag_page).

-export([format/2]).

-import(faultcheck_html, [escape/1]).

%% @doc The page of a case and its trace. It names no folder and nobody, so the same case gives the
%% same bytes everywhere.
-spec format(faultcheck_case:'case'(), airbag_trace:trace()) -> iodata().
format(#{property := Property} = Case, Trace) ->
    Title = ["Airbag: ", atom_to_list(Property)],
    faultcheck_html:document(Title, airbag_style:css(), [
        "<main>\n",
        header(Case, Trace),
        section("why", "Why", [["<p>", escape(S), "</p>\n"] || S <- airbag_story:sentences(Trace)]),
        section("line", "Time line", [
            "<div class=\"scroll\" role=\"region\" aria-label=\"Time line\" tabindex=\"0\">\n",
            airbag_timeline:svg(Trace),
            "</div>\n"
        ]),
        section("commands", "Commands", commands(Trace)),
        section("packets", "Packets that arrived", packets(Trace)),
        section("setting", "Setting", setting(Trace)),
        section("repeat", "Run it again", again(Case)),
        "</main>\n"
    ]).

section(Id, Heading, Body) ->
    [
        "<section aria-labelledby=\"h-", Id, "\">\n<h2 id=\"h-", Id, "\">", escape(Heading),
        "</h2>\n", Body, "</section>\n"
    ].

header(#{module := Module, property := Property, original := Original} = Case, Trace) ->
    #{steps := Steps} = Trace,
    [
        "<header>\n<p class=\"badge ", badge(Trace), "\">", escape(word(Trace)), "</p>\n",
        ["<h1>", escape(airbag_story:headline(Trace)), "</h1>\n"],
        ["<p class=\"quiet\">", escape(io_lib:format("~tp:~tp(), ", [Module, Property]))],
        [escape(count(length(Steps), "command")), escape(before(Original, length(Steps)))],
        ["</p>\n", doubtful(Case, Trace), "</header>\n"]
    ].

badge(#{result := ok}) -> "passed";
badge(_) -> "failed".

word(#{result := ok}) -> "passes now";
word(_) -> "failed".

before(Original, Length) ->
    case faultcheck_case:commands(Original) of
        {ok, Commands} when length(Commands) > Length ->
            io_lib:format(", shrunk from ~b", [length(Commands)]);
        _ ->
            ""
    end.

doubtful(#{status := flaky}, _) -> "<p>The failure is flaky: it does not repeat each time.</p>\n";
doubtful(_, _) -> "".

count(1, What) -> ["1 ", What];
count(N, What) -> io_lib:format("~b ~ss", [N, What]).

%% ---- tables -----------------------------------------------------------------------------------

commands(#{steps := Steps} = Trace) ->
    Failed = airbag_trace:failed_at(Trace),
    table("commands", ["number", "command", "gave", "faults in force"], [
        {
            Number =:= Failed,
            [
                integer_to_list(Number),
                ["<code>", escape(airbag_story:call(Name, Args)), "</code>"],
                [gave(Value), [" <strong>failed</strong>" || Number =:= Failed]],
                escape(lists:join("; ", [airbag_story:fault(F) || F <- Armed]))
            ]
        }
     || {Number, #{name := Name, args := Args, value := Value, armed := Armed}} <- numbered(Steps)
    ]).

gave(none) -> "not run";
gave({value, {exception, _, _, _}}) -> "an exception";
gave({value, Value}) -> ["<code>", escape(io_lib:format("~0lp", [Value])), "</code>"].

packets(#{options := #{protection := Protection}} = Trace) ->
    Packets = airbag_trace:packets(Trace),
    Heads =
        ["packet", "command", "sent", "received", "bits inverted", "message"] ++
            [Head || Protection =:= e2e, Head <- ["CRC", "counter", "status"]] ++
            ["count", "airbag"],
    [
        [bits_legend() || Packets =/= []],
        table("packets", Heads, [packet(P, Trace) || P <- Packets]),
        ["<p>None arrived.</p>\n" || Packets =:= []]
    ].

bits_legend() ->
    "<p class=\"quiet\">Bytes as hexadecimal and as bits, the highest bit first; what was inverted "
    "on the way is <span class=\"flip\">underlined and framed</span>.</p>\n".

packet({Number, At, #{bytes := Bytes, sent := Sent} = Packet}, Trace) ->
    #{options := #{protection := Protection}} = Trace,
    #{activations := Count, fired := Fired} = Packet,
    Flips = airbag_trace:flipped(Packet),
    {
        airbag_story:unasked({At, Packet}, Trace),
        [integer_to_list(Number), integer_to_list(At), sent(Sent), bytes(Bytes, Flips)] ++
            [flips(Flips), message(Protection, Bytes)] ++
            [Cell || Protection =:= e2e, Cell <- protection(Packet, Trace)] ++
            [integer_to_list(Count), fired(Fired)]
    }.

sent(unknown) -> "cannot be told";
sent(Bytes) -> bytes(Bytes, []).

bytes(Bytes, Flips) ->
    [byte(Byte, [Bit || {At, Bit} <- Flips, At =:= N - 1])
     || {N, Byte} <- numbered(binary_to_list(Bytes))].

byte(Byte, Flips) ->
    Bits = [
        case lists:member(Bit, Flips) of
            true -> ["<b class=\"flip\">", bit(Byte, Bit), "</b>"];
            false -> bit(Byte, Bit)
        end
     || Bit <- lists:seq(7, 0, -1)
    ],
    ["<span class=\"byte\"><code>", airbag_story:hex(<<Byte>>), "</code> <small>", Bits,
        "</small></span> "].

bit(Byte, Bit) -> integer_to_list((Byte bsr Bit) band 1).

flips([]) -> "none";
flips(Flips) ->
    lists:join(", ", [io_lib:format("byte ~b bit ~b", [Byte, Bit]) || {Byte, Bit} <- Flips]).

message(plain, Bytes) -> data(Bytes);
message(e2e, <<_, Data:2/binary, _/binary>>) -> data(Data);
message(e2e, _) -> "wrong length".

data(Data) -> ["<code>", io_lib:format("~w", [binary_to_list(Data)]), "</code>"].

protection(#{bytes := <<Crc, _:2/binary, Last>>, status := Status} = Packet, Trace) ->
    [
        checksum(Crc, wanted(Packet, Trace)),
        integer_to_list(Last band 15),
        airbag_coverage:status(Status)
    ];
protection(_, _) ->
    ["none", "none", "not checked"].

checksum(Crc, unknown) -> hex(Crc);
checksum(Crc, Crc) -> [hex(Crc), " right"];
checksum(Crc, Wanted) -> [hex(Crc), " wrong, not ", hex(Wanted)].

hex(Byte) -> ["<code>", airbag_story:hex(<<Byte>>), "</code>"].

%% The checksum that these bytes want: that of what was sent, moved by what changed. (It is linear.)
wanted(#{sent := Sent, bytes := Bytes}, #{covered := Covered}) when
    byte_size(Sent) =:= byte_size(Bytes), Covered > 0, Covered =< byte_size(Sent)
->
    [Crc | Before] = binary_to_list(binary:part(Sent, 0, Covered)),
    [_ | After] = binary_to_list(binary:part(Bytes, 0, Covered)),
    Crc bxor airbag_crc:of_difference([A bxor B || {A, B} <- lists:zip(Before, After)]);
wanted(_, _) ->
    unknown.

fired(true) -> "<strong>fired</strong>";
fired(false) -> "silent".

%% Rows are {Marked, Cells}; the name is that of the section. Wide ones scroll, also by keys.
table(Section, Heads, Rows) ->
    [
        "<div class=\"scroll\" role=\"region\" aria-labelledby=\"h-", Section,
        "\" tabindex=\"0\">\n<table>\n<thead><tr>",
        [["<th scope=\"col\">", escape(Head), "</th>"] || Head <- Heads],
        "</tr></thead>\n<tbody>\n",
        [
            ["<tr", [" class=\"bad\"" || Bad], ">", [["<td>", Cell, "</td>"] || Cell <- Cells],
                "</tr>\n"]
         || {Bad, Cells} <- Rows
        ],
        "</tbody>\n</table>\n</div>\n"
    ].

%% ---- what else there is to know ---------------------------------------------------------------

setting(#{options := Options, covered := Covered}) ->
    #{protection := Protection, configuration := Configuration, needed := Needed} = Options,
    Own =
        case Protection of
            plain ->
                [{"protection", "none: a packet is the two bytes of the message"}];
            e2e ->
                [
                    {"protection", "AUTOSAR E2E profile 1: checksum in byte 0, message in bytes 1 "
                        "and 2, counter in the low half of byte 3"},
                    {"configuration", atom_to_list(Configuration)},
                    {"checksum covers", io_lib:format("the first ~b bytes and the Data ID",
                        [Covered])}
                ]
        end,
    [
        "<dl>\n",
        [
            ["<dt>", escape(Name), "</dt><dd>", escape(Value), "</dd>\n"]
         || {Name, Value} <- Own ++ [
                {"fires after", count(Needed, "message") ++ [" [85,170] in succession"]}
            ]
        ],
        "</dl>\n"
    ].

again(#{property := Property, shrunk := Shrunk, seed := Seed} = Case) ->
    #{versions := Versions, options := Words} = Case,
    Id = faultcheck_case:id(Property, Shrunk),
    [
        "<dl>\n",
        [
            ["<dt>", Name, "</dt><dd><code>", escape(Value), "</code></dd>\n"]
         || {Name, Value} <- [
                {"this case", ["make replay CASE=cases/", Id]},
                {"the search that found it", ["rebar3 proper " | lists:join(" ", Words)]},
                {"seed", integer_to_list(Seed)},
                {"found with", faultcheck_versions:text(Versions)}
            ]
        ],
        "</dl>\n<details><summary>The commands as Erlang terms</summary>\n<pre>",
        [[escape(Line), $\n] || Line <- faultcheck_case:lines(Shrunk)],
        "</pre></details>\n"
    ].

numbered(List) -> lists:zip(lists:seq(1, length(List)), List).

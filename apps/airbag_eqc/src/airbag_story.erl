%% @doc Why a run of the airbag failed, in sentences. All of it is read from the trace.
-module(airbag_story).

-export([headline/1, sentences/1, fault/1, call/2, hex/1, unasked/2]).

-type text() :: unicode:chardata().

%% @doc What happened, in a few words.
-spec headline(airbag_trace:trace()) -> text().
headline(#{result := ok}) ->
    "The commands pass with this build";
headline(#{result := {postcondition, _}} = Trace) ->
    case {last(Trace), firing(Trace)} of
        {#{name := explosion}, _} -> "The airbag did not fire when it was told to";
        {_, none} -> "A command gave what it must not give";
        {_, _} -> "The airbag fired without cause"
    end;
headline(#{result := {precondition, _}}) ->
    "A command is not allowed where it stands";
headline(_) ->
    "A command could not be run to its end".

%% @doc Why, a sentence each.
-spec sentences(airbag_trace:trace()) -> [text()].
sentences(#{result := ok}) ->
    ["The case was stored with a build that failed; this one does what the model wants."];
sentences(#{result := {postcondition, _}} = Trace) ->
    case {last(Trace), firing(Trace)} of
        {#{name := explosion} = Step, _} -> silent(Step);
        {_, none} -> reasons(Trace);
        {_, Firing} -> fired(Firing, Trace)
    end;
sentences(Trace) ->
    reasons(Trace).

reasons(#{result := Result}) ->
    Why = lists:flatten(faultcheck_pretty:why(Result)),
    [string:trim(Line) || Line <- string:split(Why, "\n", all), string:trim(Line) =/= ""].

last(#{steps := Steps}) ->
    lists:last([Step || #{value := {value, _}} = Step <- Steps]).

%% The packet with which the airbag fired though nobody told it to.
firing(Trace) ->
    case [P || {_, At, Packet} = P <- airbag_trace:packets(Trace), unasked({At, Packet}, Trace)] of
        [First | _] -> First;
        [] -> none
    end.

%% @doc Whether the airbag has fired behind this packet of a command, and was not to.
-spec unasked({pos_integer(), airbag_trace:packet()}, airbag_trace:trace()) -> boolean().
unasked({At, #{fired := Fired}}, #{steps := Steps}) ->
    #{name := Name} = lists:nth(At, Steps),
    Fired andalso Name =/= explosion.

fired({Number, At, #{bytes := Bytes, activations := Count} = Packet}, Trace) ->
    #{steps := Steps, options := #{needed := Needed}} = Trace,
    #{name := Name, args := Args, armed := Armed} = lists:nth(At, Steps),
    [
        [
            io_lib:format("Command ~b, ", [At]), call(Name, Args),
            io_lib:format(", sent ~ts; ", [bytes(maps:get(sent, Packet))]),
            io_lib:format("what arrived as packet ~b is ", [Number]), bytes(Bytes), $.
        ],
        change(airbag_trace:flipped(Packet)),
        checked(Packet),
        [
            io_lib:format("It is activation message ~b in succession, and ", [Count]),
            io_lib:format("~b fire", [Needed]),
            [$s || Needed =:= 1], " the airbag."
        ]
    ] ++ copies(At, Steps) ++ armed(Armed).

bytes(unknown) -> "it cannot be told what";
bytes(Bytes) -> hex(Bytes).

change([]) ->
    "It arrived as it was sent.";
change([{Byte, Bit}]) ->
    io_lib:format("On its way bit ~b of byte ~b was inverted.", [Bit, Byte]);
change(Flips) ->
    Words = [io_lib:format("bit ~b of byte ~b", [Bit, Byte]) || {Byte, Bit} <- Flips],
    {Most, [Last]} = lists:split(length(Words) - 1, Words),
    ["On its way ", lists:join(", ", Most), " and ", Last, " were inverted."].

checked(#{status := none}) ->
    "Nothing protects it: the airbag takes any two bytes for a message.";
checked(#{status := Status} = Packet) ->
    Said = ["E2E_P01Check says ", airbag_coverage:status(Status)],
    case airbag_trace:flipped(Packet) of
        [] -> [Said, "."];
        _ -> [Said, ": these inversions leave a packet whose checksum and counter are right."]
    end.

%% How many of the counted messages are one message delivered again.
copies(At, Steps) ->
    case lists:nth(At, Steps) of
        #{sent := [_], received := Received} when length(Received) > 1 ->
            [io_lib:format("The message was sent once and arrived ~b times.", [length(Received)])];
        _ ->
            []
    end.

armed([]) -> [];
armed(Faults) -> [["Faults in force: ", lists:join("; ", [fault(F) || F <- Faults]), "."]].

silent(#{sent := Sent, received := Received}) ->
    Last =
        case Received of
            [] ->
                "None of them arrived.";
            _ ->
                #{activations := Count} = Packet = lists:last(Received),
                [
                    io_lib:format("~b arrived; behind the last one the count was ~b", [
                        length(Received), Count
                    ]),
                    [
                        [", and its check said ", airbag_coverage:status(S)]
                     || #{status := S} <- [Packet], S =/= none
                    ],
                    "."
                ]
        end,
    [
        io_lib:format("All faults were removed and [85,170] was sent ~b times.", [length(Sent)]),
        Last
    ].

%% @doc A fault in a few words.
-spec fault(airbag_eqc:fault()) -> text().
fault({bitflip, Byte, Bit}) ->
    io_lib:format("byte ~b bit ~b inverted", [Byte, Bit]);
fault({repetition, 1}) ->
    "next packet once more";
fault({repetition, Num}) ->
    io_lib:format("next packet ~b more times", [Num]).

%% @doc A command as it is written.
-spec call(atom(), [term()]) -> text().
call(Name, Args) ->
    [atom_to_list(Name), $(, lists:join(", ", [io_lib:format("~0lp", [A]) || A <- Args]), $)].

%% @doc Bytes as in "55 aa".
-spec hex(binary()) -> text().
hex(Bytes) -> airbag_exhaustive:hex(binary_to_list(Bytes)).

%% @doc Every fault model that models can name: its term, its parameters, what it does, and what the
%% standards call it. docs/faults.md is markdown/0, the visualizer's form is made from json/0;
%% scripts/fault_catalogue.sh writes both files.
-module(faultcheck_fault_catalogue).

-export([models/0, find/1, term/1, markdown/0, json/0]).
-export_type([entry/0, class/0, stage/0, kind/0]).

%% What kind of value a parameter is; faultcheck_fault_parameter checks them.
-type kind() :: bit | bit_of_byte | bit_value | any_real | real | limit | positive | probability
              | natural | count | byte | dropout_mode | name | data | delay | channel_delay
              | receivers | field | part | model.
-type class() :: probe | sensor | communication.
%% Where it acts: at a probe, when a packet is put, or when a receiver gets one.
-type stage() :: probe | put | get.
-type entry() :: #{
    name := atom(),
    class := class(),
    stage := stage(),
    parameters := [{atom(), kind()}],
    meaning := string(),
    standard := string()
}.

%% @doc All of them, in the order of the page.
-spec models() -> [entry()].
models() -> probe() ++ sensor() ++ communication().

%% @doc The models whose terms begin with this atom; a delay is one of probes or of channels.
-spec find(atom()) -> [entry()].
find(Name) -> [Entry || #{name := N} = Entry <- models(), N =:= Name].

probe() ->
    [
        entry(probe, probe, bitflip, [{'Bit', bit}],
              "inverts bit Bit, 0 the least significant; of bytes, bit Bit rem 8 of byte Bit div 8",
              "soft error: bit flip"),
        entry(probe, probe, bitflip_random, [],
              "inverts one bit, drawn anew at each affected call", "soft error: bit flip"),
        entry(probe, probe, stuck, [],
              "holds the value of the first affected call", "stuck in range"),
        entry(probe, probe, stuck_bit, [{'Bit', bit}, {'Value', bit_value}],
              "forces bit Bit to Value, 0 or 1", "stuck-at fault"),
        entry(probe, probe, amplification, [{'Factor', any_real}],
              "multiplies by Factor", "gain fault (out of range)"),
        entry(probe, probe, offset, [{'Constant', any_real}], "adds Constant", "offset"),
        entry(probe, probe, set_to, [{'Value', any_real}],
              "replaces by Value; fills bytes", "stuck in range, out of range")
    ].

sensor() ->
    [
        entry(sensor, probe, noise_uniform, [{'Amplitude', real}],
              "adds a number drawn evenly from -Amplitude..Amplitude", "noise"),
        entry(sensor, probe, noise_gauss, [{'Deviation', real}],
              "adds a normal number of that standard deviation, at most 6 of them", "noise"),
        entry(sensor, probe, random_offset, [{'Low', real}, {'High', real}],
              "adds a number drawn evenly from Low..High", "offset"),
        entry(sensor, probe, held_offset, [{'Low', real}, {'High', real}, {'Ns', count}],
              "adds a number drawn evenly from Low..High and held for Ns nanoseconds", "offset"),
        entry(sensor, probe, drift, [{'Rate', real}, {'Limit', limit}],
              "adds Rate more at each affected call, up to Limit", "drift"),
        entry(sensor, probe, drift_timed, [{'Rate', real}, {'Limit', limit}],
              "adds Rate for each second since the first affected call, up to Limit", "drift"),
        entry(sensor, probe, ramp, [{'Value', real}, {'Calls', count}],
              "goes from the first value to Value within Calls calls", "drift"),
        entry(sensor, probe, delay, [{'Delay', delay}],
              "gives the value of N affected calls ago", "delayed signal"),
        entry(sensor, probe, quantise, [{'Step', positive}],
              "rounds to multiples of Step", "loss of resolution"),
        entry(sensor, probe, dead_zone, [{'Centre', real}, {'Width', real}],
              "gives Centre for all values closer to it than Width", "stuck in range"),
        entry(sensor, probe, saturate, [{'Low', real}, {'High', real}],
              "limits to Low..High", "saturation"),
        entry(sensor, probe, oscillate, [{'Amplitude', real}, {'Calls', count}],
              "adds a sine of that Amplitude with a period of Calls calls", "oscillation"),
        entry(sensor, probe, dropout, [{'Probability', probability}, {'Mode', dropout_mode}],
              "with that Probability: the last value that got through (hold), zero, or nan",
              "intermittent signal"),
        entry(sensor, probe, spike, [{'Probability', probability}, {'Height', real}],
              "with that Probability adds or subtracts Height", "spike")
    ].

communication() ->
    [
        entry(communication, get, corruption, [{'Byte', natural}, {'Bit', bit_of_byte}],
              "inverts bit Bit of byte Byte", "corruption of information"),
        entry(communication, get, field, [{'Field', field}, {'Model', model}],
              "applies a model of a probe to a typed field", "corruption of information"),
        entry(communication, get, truncate, [{'Bytes', natural}],
              "cuts to at most Bytes bytes", "corruption of information"),
        entry(communication, get, extend, [{'Count', natural}, {'Byte', byte}],
              "appends Byte Count times", "corruption of information"),
        entry(communication, get, drop, [{'Packets', natural}],
              "discards that many packets in all", "loss of information"),
        entry(communication, get, lose, [],
              "each affected get discards one packet and takes the next", "loss of information"),
        entry(communication, get, repeat, [{'Packets', natural}],
              "delivers one packet that many more times", "repetition of information"),
        entry(communication, get, repeat_last, [],
              "delivers the packet before once more, the waiting ones stay",
              "repetition of information"),
        entry(communication, get, insert, [{'Packet', data}, {'Times', natural}],
              "delivers Packet up to that many times while the waiting ones stay",
              "insertion of information"),
        entry(communication, get, masquerade, [{'From', name}],
              "delivers the head of channel From as if it belonged here",
              "masquerade of information"),
        entry(communication, get, resequence, [{'Position', natural}],
              "delivers the packet at that position, 0 the head", "incorrect sequence"),
        entry(communication, get, block_get, [],
              "delivers nothing, the packets stay", "blocked access to a channel"),
        entry(communication, put, delay, [{'Delay', channel_delay}],
              "hides the packet for N gets, {gets, N}, or for a time, {ns, T}; order is kept",
              "delay of information"),
        entry(communication, put, misroute, [{'To', name}],
              "the packet goes to channel To instead", "incorrect addressing"),
        entry(communication, put, asymmetric,
              [{'Receivers', receivers}, {'Part', part}, {'Model', model}],
              "the receivers listed get a copy altered by Model",
              "asymmetric information sent to several receivers"),
        entry(communication, put, subset, [{'Receivers', receivers}],
              "only the receivers listed get the packet",
              "information received by a subset of the receivers"),
        entry(communication, put, block_put, [],
              "the packet is refused", "blocked access to a channel")
    ].

entry(Class, Stage, Name, Parameters, Meaning, Standard) ->
    #{
        name => Name,
        class => Class,
        stage => Stage,
        parameters => Parameters,
        meaning => Meaning,
        standard => Standard
    }.

%% @doc The term in words, `{drift, Rate, Limit}'.
-spec term(entry()) -> string().
term(#{name := Name, parameters := []}) ->
    atom_to_list(Name);
term(#{name := Name, parameters := Parameters}) ->
    Parts = [atom_to_list(Name) | [shown(P) || P <- Parameters]],
    lists:flatten(["{", lists:join(", ", Parts), "}"]).

shown({_, delay}) -> "{calls, N}";
shown({Name, _}) -> atom_to_list(Name).

%% ---- the page -------------------------------------------------------------------------------

%% @doc The text of docs/faults.md.
-spec markdown() -> iodata().
markdown() ->
    [
        intro(),
        section("At probes", probe),
        section("Of sensors, at probes", sensor),
        section("On channels", communication),
        parameters(),
        triggers(),
        faultcheck_fault_realistic:markdown(),
        by_name(),
        standards()
    ].

intro() ->
    "<!-- generated from apps/faultcheck/src/faultcheck_fault_catalogue.erl by\n"
    "     faultcheck_fault_catalogue:markdown/0; a test compares the two -->\n"
    "# Fault models\n\n"
    "A fault is a term: `Model`, or `{Model, Trigger}` when it is not permanent. `faultcheck_fault`"
    "\nchecks and describes faults, `faultcheck_fault_gen` generates them, `faultcheck_inject` arms"
    "\nthem on `{probe, Id}`, `{channel, Channel}` or `{channel, Channel, Receiver}`.\n\n"
    "```erlang\n"
    "{ok, Fault} = faultcheck_inject:arm(Lib, null, {probe, <<\"speed\">>},\n"
    "                                    {{offset, 2.5}, [{from, 100}, {for, 20}]}).\n"
    "```\n".

section(Title, Class) ->
    [
        "\n## ", Title, "\n\n| term | what it does | where | called by the standards |\n"
        "|---|---|---|---|\n",
        [row(Entry) || #{class := C} = Entry <- models(), C =:= Class]
    ].

row(#{meaning := Meaning, stage := Stage, standard := Standard} = Entry) ->
    ["| `", term(Entry), "` | ", Meaning, " | ", atom_to_list(Stage), " | ", Standard, " |\n"].

parameters() ->
    "\n## Parameters\n\n"
    "`Bit` 0 is the least significant. A probed type without that bit leaves the fault out\n"
    "(`FC_E_BIT`). `Limit` is a number from 0 up, or `none`. `Factor`, `Constant` and the `Value`\n"
    "of `set_to` may be `inf`, `neg_inf` and `nan`; the other numbers may be infinite, not `nan`.\n"
    "Integers are computed in double, cut toward zero and limited to the type.\n"
    "`Field` is `{Offset, Type, little | big}` or `{Offset, bytes, Length}`; `Part` is a field or\n"
    "`whole`; `Model` is a model of the first two tables. `Mode` is `hold`, `zero` or `nan`.\n".

triggers() ->
    "\n## Triggers\n\n"
    "A list; all conditions must hold; `[]` is permanent.\n\n"
    "| condition | holds |\n|---|---|\n"
    "| `{from, N}` | after the first N calls from the arming on |\n"
    "| `{for, N}` | for N affected calls |\n"
    "| `{time, Delay, Duration}` | that time after the arming, in ns; Duration may be `forever` |\n"
    "| `{random, P}` | at each call with probability P, when the others hold |\n"
    "| `{periodic, Period, Active}` | in the first Active of each Period calls |\n"
    "| `{predicate, Function}` | while the C function `bool Function(void *)` says so |\n\n"
    "A call is a probe call, a get of a receiver, or a put.\n".

by_name() ->
    "\n## By name\n\n"
    "Scenarios and `fc_arm_named` of `fc_named.h` name a model and its parameters: the names of\n"
    "the terms above in lower case, as in `\"model\": \"drift_timed\", \"rate\": 0.1, \"limit\": "
    "5`.\nThese may also be called otherwise, and these may be left out:\n\n"
    "| model | parameter |\n|---|---|\n"
    "| amplification, offset | `value` for `factor` and `constant` |\n"
    "| drift, drift_timed | without `limit` there is none |\n"
    "| drop | `count` for `packets`; without it all packets |\n"
    "| repeat | `count` for `packets` |\n"
    "| bitflip of a channel | another name of corruption |\n"
    "| delay of a channel | either `gets` or `ns` |\n"
    "| insert | `packet` in hexadecimal; `times` 1 |\n"
    "| subset, asymmetric | `receivers`: names between commas |\n"
    "| field, asymmetric | `apply` a model of a probe, beside its parameters, to the field at "
    "`byte` of `type`, `big_endian` 0 or 1, bytes of `length`; without them to the whole packet "
    "|\n\n"
    "`fc_model_name` and `fc_model_parameter` list them all.\n".

standards() ->
    "\n## Names in the standards\n\n"
    "Those of channels: ISO 26262-6, Annex D (exchange of information), and the fault models of\n"
    "the AUTOSAR E2E protocol. Those of sensors and bits: the failure modes of ISO 26262-5,\n"
    "Annex D, or their usual engineering name.\n".

%% ---- for the visualizer's page ----------------------------------------------------------------

%% @doc The text of visualizer/page/src/panels/generated/fault_models.json.
-spec json() -> binary().
json() ->
    Generated = "from apps/faultcheck/src/faultcheck_fault_catalogue.erl by json/0",
    faultcheck_json:pretty({object, [
        {generated, {text, Generated}},
        {models, [described(Entry) || Entry <- models()]}
    ]}).

described(#{name := Name, class := Class, stage := Stage, parameters := Parameters} = Entry) ->
    #{meaning := Meaning, standard := Standard} = Entry,
    {object, [
        {name, Name},
        {class, Class},
        {stage, Stage},
        {parameters, [{object, [{name, P}, {kind, Kind}]} || {P, Kind} <- Parameters]},
        {meaning, {text, Meaning}},
        {standard, {text, Standard}}
    ]}.

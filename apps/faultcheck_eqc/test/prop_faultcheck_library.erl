%% @doc libfaultcheck does what the reference model says, section by section.
-module(prop_faultcheck_library).
-include_lib("faultcheck/include/faultcheck.hrl").

-export([
    prop_probes/0, prop_probes/1,
    prop_triggers/0, prop_triggers/1,
    prop_sensors/0, prop_sensors/1,
    prop_channels/0, prop_channels/1,
    prop_communication/0, prop_communication/1,
    prop_routing/0, prop_routing/1,
    prop_everything/0, prop_everything/1
]).

prop_probes() -> faultcheck_eqc:agrees(probes).

prop_probes(doc) -> "Probe faults and triggers: sections 2, 3, 5, 7.2 and 7.5";
prop_probes(opts) -> [{numtests, 200}, {transport, nif}].

prop_triggers() -> faultcheck_eqc:agrees(triggers).

prop_triggers(doc) -> "Triggers that meet on one fault: 3 and 7.5";
prop_triggers(opts) -> [{numtests, 200}, {transport, nif}].

prop_sensors() -> faultcheck_eqc:agrees(sensors).

prop_sensors(doc) -> "Random streams and sensor models, bit by bit: 7.3 and 7.6";
prop_sensors(opts) -> [{numtests, 200}, {transport, nif}].

prop_channels() -> faultcheck_eqc:agrees(channels).

prop_channels(doc) -> "Packet channels of the compatible interface: section 4";
prop_channels(opts) -> [{numtests, 150}, {transport, nif}].

prop_communication() -> faultcheck_eqc:agrees(communication).

prop_communication(doc) -> "Channels with receivers and all communication faults: 7.7";
prop_communication(opts) -> [{numtests, 250}, {transport, nif}].

prop_routing() -> faultcheck_eqc:agrees(routing).

prop_routing(doc) -> "Delayed packets and faults that move packets between channels: 7.7";
prop_routing(opts) -> [{numtests, 200}, {transport, nif}].

prop_everything() -> faultcheck_eqc:agrees(everything).

prop_everything(doc) -> "Probes and channels together, in several contexts: 7.1";
prop_everything(opts) -> [{numtests, 150}, {transport, nif}].

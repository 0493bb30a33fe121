%% The airbag property of Paper I: the airbag must not fire unless it is told to, whatever the
%% channel does to messages. This airbag is not protected, so the property fails.
%%
%% The state of the model is the list of the faults that are armed.
-module(prop_airbag_node).
-include_lib("faultcheck/include/faultcheck.hrl").

prop_does_not_fire_without_cause() ->
    ?SETUP(fun() -> {ok, Lib} = cb:start(airbag_node, [{c_src, "c_src/airbag_node.c"},
                                                       {libs, ["faultcheck"]}]),
                    fun() -> cb:stop(Lib) end end,
           ?FORALL(Commands, commands(?MODULE), begin
               ok = cb:restart(airbag_node),
               {_, _, Result} = run_commands(?MODULE, Commands),
               Result =:= ok
           end)).

initial_state() -> [].
faults() -> [bit_flip, repetition].

%% Ten messages for each fault: a fault needs traffic to show itself.
weight(_Faults, sensor) -> 10;
weight(_Faults, _Fault) -> 1.

%% ---- sensor: a message that must not fire the airbag ----------------------------------------
%% First bytes that are one bit away from 85; any byte finds them too, in more tests.
sensor_args(_Faults) -> [oneof([84, 87, 117, 213, 21]), 170].
sensor(First, Second) ->
    cb:call(airbag_node, sensor, [First, Second]),
    cb:call(airbag_node, airbag_iteration, []).
sensor_post(_Faults, [_First, _Second], Fired) -> Fired =:= 0.

%% ---- bit_flip: from now on a bit of each message is inverted --------------------------------
bit_flip_pre(Faults) -> length(Faults) < 4.
bit_flip_args(_Faults) -> [integer(0, 1), integer(0, 7)].
bit_flip_pre(Faults, [Byte, Bit]) -> not lists:member({flip, Byte, Bit}, Faults).
bit_flip(Byte, Bit) ->
    cb:call(airbag_node, faultcheck_packet_addFaultCorruptionBitFlip, ["airbag", Byte, Bit]).
bit_flip_next(Faults, _Result, [Byte, Bit]) -> [{flip, Byte, Bit} | Faults].

%% ---- repetition: the next message is delivered more than once -------------------------------
repetition_pre(Faults) -> length(Faults) < 4.
repetition_args(_Faults) -> [integer(1, 3)].
repetition(Times) -> cb:call(airbag_node, faultcheck_packet_addFaultRepeat, ["airbag", Times]).
repetition_next(Faults, _Result, [Times]) -> [{repeat, Times} | Faults].

%% @doc The model of Paper I, section 5: an airbag must fire after two messages [85,170] in
%% succession, and must not fire without them, whatever happens to packets in the channel.
%%
%% A sensor node sends messages, faults alter them on their way, and the airbag node receives
%% them. The faults stay for the whole test, as in the paper. Which airbag this is, bare or
%% protected, says airbag_options.
-module(airbag_eqc).
-include_lib("faultcheck/include/faultcheck.hrl").

%% PropEr 1.5 calls its property types opaque, though a plain boolean is one of them.
-dialyzer({[no_opaque, no_return], [safe/1, safe/2]}).

-export([safe/1, safe/2, begin_test/1, armed_faults/1, report/2]).
-export_type([fault/0, tell/0]).

-define(CHANNEL, <<"airbag">>).
-define(FIRE, [85, 170]).

-type fault() :: {bitflip, Byte :: 0..3, Bit :: 0..7} | {repetition, 1..3}.
-type tell() :: fun(([faultcheck_statem:command()], faultcheck_statem:run()) -> ok).

-record(state, {
    faults = [] :: [fault()],
    options :: airbag_options:options()
}).

initial_state() ->
    #state{options = airbag_options:current()}.

faults() -> [bit_flip, repetition].

%% Ten messages for each fault: a fault needs traffic to show itself.
weight(_S, sensor) -> 10;
weight(_S, bit_flip) -> 1;
weight(_S, repetition) -> 1;
weight(_S, explosion) -> 1.

%% ---- sensor: a message that must not fire the airbag ----------------------------------------
%% The focused generator knows the values close to 85; any byte finds them one time in 50.
sensor_args(S) -> [[first_byte(S#state.options), 170]].
sensor_pre(_S, [Data]) -> Data =/= ?FIRE.
sensor(Data) -> lists:last(airbag_sut:calls(message(Data) ++ iteration() ++ [flag()])).
sensor_post(_S, [_Data], Active) -> Active =:= 0.

%% ---- bit_flip: from now on one bit of each packet is inverted -------------------------------
bit_flip_pre(S) -> room(bit_flip, S) andalso flips(S) < option(max_flips, S).
bit_flip_args(S) -> [integer(0, packet_bytes(S) - 1), integer(0, 7)].
bit_flip_pre(S, [Byte, Bit]) ->
    bit_flip_pre(S) andalso
        Byte < packet_bytes(S) andalso
        not armed({bitflip, Byte, Bit}, S).
bit_flip(Byte, Bit) ->
    arm(faultcheck_packet_addFaultCorruptionBitFlip, [?CHANNEL, Byte, Bit]).
bit_flip_next(S, _Result, [Byte, Bit]) -> add({bitflip, Byte, Bit}, S).

%% ---- repetition: the next packet is delivered 1 to 3 more times -----------------------------
repetition_pre(S) -> room(repetition, S).
repetition_args(_S) -> [integer(1, 3)].
repetition_pre(S, [Num]) -> repetition_pre(S) andalso not armed({repetition, Num}, S).
repetition(Num) -> arm(faultcheck_packet_addFaultRepeat, [?CHANNEL, Num]).
repetition_next(S, _Result, [Num]) -> add({repetition, Num}, S).

%% ---- explosion: without faults, enough messages must fire the airbag ------------------------
explosion_args(_S) -> [?FIRE].
explosion(Data) ->
    Messages = lists:append(lists:duplicate(messages_to_fire(), message(Data))),
    Calls = [remove_faults() | Messages] ++ iteration() ++ [flag(), initialise()],
    [_Initialised, Active | _] = lists:reverse(airbag_sut:calls(Calls)),
    Active.
explosion_next(S, _Result, [_Data]) ->
    case option(fault_list, S) of
        cleared -> S#state{faults = []};
        paper -> S
    end.
explosion_post(_S, [_Data], Active) -> Active =:= 1.

%% ---- what the properties call ---------------------------------------------------------------

%% @doc Brings the airbag of these options into its state before the first command.
-spec begin_test(airbag_options:options()) -> ok.
begin_test(Options) ->
    ok = airbag_options:use(Options),
    airbag_sut:begin_test(Options).

%% @doc The faults armed in a state of the model.
-spec armed_faults(#state{}) -> [fault()].
armed_faults(#state{faults = Faults}) -> Faults.

%% @doc The property: no sequence of commands makes the airbag break its promises.
-spec safe(airbag_options:options()) -> proper:outer_test().
safe(Options) ->
    safe(Options, fun(Commands, Run) ->
        io:put_chars(faultcheck_statem:pretty(?MODULE, Commands, Run))
    end).

%% @doc The same, with what is to be told of a failure.
-spec safe(airbag_options:options(), tell()) -> proper:outer_test().
safe(Options, Tell) ->
    %% Now, for report/2, and in the process of the tests.
    ok = airbag_options:use(Options),
    ?SETUP(
        fun() ->
            ok = airbag_options:use(Options),
            fun() -> ok end
        end,
        ?FORALL(Commands, commands(?MODULE), begin
            ok = begin_test(Options),
            {_, _, Result} = Run = run_commands(?MODULE, Commands),
            ?WHENFAIL(Tell(Commands, Run), aggregate(command_names(Commands), Result =:= ok))
        end)
    ).

%% @doc Adds a page to a stored case: its packets, and what the airbag made of each.
-spec report(faultcheck_case:'case'(), file:filename()) -> faultcheck_case:told().
report(#{shrunk := Shrunk} = Case, Dir) ->
    {ok, Commands} = faultcheck_case:commands(Shrunk),
    Trace = airbag_trace:run(airbag_options:current(), Commands),
    ok = faultcheck_case:add_file(Dir, "report.html", airbag_page:format(Case, Trace)),
    #{report => "report.html"}.

%% ---- the model's own --------------------------------------------------------------------

%% One flip away from 85 are 84, 87, 117, 213 and 21.
first_byte(#{generator := byte}) -> byte();
first_byte(#{generator := focused}) -> oneof([84, 87, 117, 213, 21]).

room(Kind, #state{faults = Faults} = S) ->
    lists:member(Kind, option(faults, S)) andalso length(Faults) < option(max_faults, S).

flips(#state{faults = Faults}) -> length([bitflip || {bitflip, _, _} <- Faults]).

armed(Fault, #state{faults = Faults}) -> lists:member(Fault, Faults).

add(Fault, #state{faults = Faults} = S) -> S#state{faults = Faults ++ [Fault]}.

option(Name, #state{options = Options}) -> maps:get(Name, Options).

packet_bytes(S) ->
    case option(protection, S) of
        plain -> 2;
        e2e -> 4
    end.

%% ---- the calls into C: bare or protected ----------------------------------------------------

message(Data) -> [{protected(sensor, sensor_e2e), [Data]}].

iteration() -> [{protected(airbag_iteration, airbag_iteration_e2e), []}].

flag() -> {airbag_is_active, []}.

initialise() -> {application_init, []}.

remove_faults() -> {faultcheck_packet_removeAllFaults, []}.

arm(Function, Arguments) ->
    [Result] = airbag_sut:calls([{Function, Arguments}]),
    Result.

%% A receiver that saw faults needs up to 12 messages to trust the sender again, and 15 are
%% enough from every state it can reach.
messages_to_fire() ->
    case airbag_options:current() of
        #{protection := e2e} -> 15;
        #{protection := plain, needed := Needed} -> max(2, Needed)
    end.

protected(Plain, E2E) ->
    case airbag_options:current() of
        #{protection := plain} -> Plain;
        #{protection := e2e} -> E2E
    end.

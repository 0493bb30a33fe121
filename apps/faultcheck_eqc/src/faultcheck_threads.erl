%% @doc libfaultcheck on several threads, compared with the reference model faultcheck_ref: what all
%% calls gave must be what they give in some order, one at a time (faultcheck.md, 7.4).
%%
%% Only what 7.4 promises to be atomic takes part: calls for one identifier, channel or fault.
%% Errors are counted behind the call that met them, so their number is not asked for.
-module(faultcheck_threads).
-include_lib("faultcheck/include/faultcheck.hrl").

%% PropEr 1.5 calls its property types opaque, though a plain boolean is one of them.
-dialyzer({[no_opaque, no_return], [agrees/1, agrees/2]}).

-export([agrees/1, agrees/2, holds/2]).
-export_type([profile/0]).

%% What the commands work on.
-type profile() :: probes | channels.

-record(state, {
    profile :: profile(),
    context :: faultcheck_ref:context(),
    %% faults that were armed, removed or not
    faults = [] :: [term()]
}).

initial_state() ->
    #state{profile = profile(), context = faultcheck_ref:new(1)}.

profile() -> application:get_env(faultcheck_eqc, threads_profile, probes).

faults() -> [add].

%% Few calls meet, so most of them are of those that share most.
weight(_S, probe) -> 6;
weight(_S, put) -> 6;
weight(_S, get) -> 6;
weight(_S, add) -> 3;
weight(_S, trigger) -> 3;
weight(_S, probe_handle) -> 3;
weight(_S, _) -> 1.

%% ---- add: arm a fault -------------------------------------------------------------------------
add_args(#state{profile = probes}) -> [{probe, probe_id()}, value_model()];
add_args(#state{profile = channels}) ->
    ?LET(Channel, channel(), [{channel, Channel}, channel_model(Channel)]).
add_pre(#state{context = C}, [Place, _]) -> length(faultcheck_ref:faults(Place, C)) < 3.
add(Place, Model) -> faultcheck_threads_sut:add(Place, Model).
add_next(#state{context = C, faults = Faults} = S, Id, [Place, Model]) ->
    {'FC_OK', After} = faultcheck_ref:add(Place, Model, Id, C),
    S#state{context = After, faults = [Id | Faults]}.
add_post(#state{faults = Faults}, _, Id) ->
    is_integer(Id) andalso Id > 0 andalso not lists:member(Id, Faults).

%% ---- faults that were armed at some time ------------------------------------------------------
trigger_pre(S) -> are_any(S).
trigger_args(S) -> [a_fault(S), change()].
trigger_pre(S, [Id, _]) -> is_known(Id, S).
trigger(Id, Change) -> faultcheck_threads_sut:trigger(Id, Change).
trigger_next(S, _, [Id, Change]) -> after_(faultcheck_ref:trigger(Id, Change, context(S)), S).
trigger_post(S, [Id, Change], Result) ->
    gives(faultcheck_ref:trigger(Id, Change, context(S)), Result).

enable_pre(S) -> are_any(S).
enable_args(S) -> [a_fault(S), boolean()].
enable_pre(S, [Id, _]) -> is_known(Id, S).
enable(Id, Enabled) -> faultcheck_threads_sut:enable(Id, Enabled).
enable_next(S, _, [Id, Enabled]) -> after_(faultcheck_ref:enable(Id, Enabled, context(S)), S).
enable_post(S, [Id, Enabled], Result) ->
    gives(faultcheck_ref:enable(Id, Enabled, context(S)), Result).

remove_pre(S) -> are_any(S).
remove_args(S) -> [a_fault(S)].
remove_pre(S, [Id]) -> is_known(Id, S).
remove(Id) -> faultcheck_threads_sut:remove(Id).
remove_next(S, _, [Id]) -> after_(faultcheck_ref:remove(Id, context(S)), S).
remove_post(S, [Id], Result) -> gives(faultcheck_ref:remove(Id, context(S)), Result).

remove_all_args(S) -> [place(S)].
remove_all(Place) -> faultcheck_threads_sut:remove_all(Place).
remove_all_next(S, _, [Place]) -> S#state{context = faultcheck_ref:remove_all(Place, context(S))}.

latest_args(S) -> [place(S)].
latest(Place) -> faultcheck_threads_sut:latest(Place).
latest_next(S, _, [Place]) -> S#state{context = context_of(ref_latest(Place, S))}.
latest_post(S, [Place], Result) ->
    case ref_latest(Place, S) of
        {ok, Id, _} -> Result =:= Id;
        {Code, _} -> Result =:= Code
    end.

ref_latest(Place, S) -> faultcheck_ref:latest(Place, context(S)).

context_of(Tuple) -> element(tuple_size(Tuple), Tuple).

%% ---- probes -----------------------------------------------------------------------------------
probe_pre(S) -> are_probes(S).
probe_args(_) -> ?LET(Type, oneof([i32, f64, bytes]), [probe_id(), Type, value(Type)]).
probe_pre(S, _) -> probe_pre(S).
probe(Id, Type, Value) ->
    faultcheck_threads_sut:probe(Id, Type, faultcheck_ref_value:new(Type, Value)).
probe_next(S, _, [Id, Type, Value]) -> S#state{context = element(3, probed(Id, Type, Value, S))}.
probe_post(S, [Id, Type, Value], {Code, Result}) ->
    {Expected, Altered, _} = probed(Id, Type, Value, S),
    Code =:= Expected andalso faultcheck_ref_value:matches(Type, Altered, Result).

probed(Id, Type, Value, S) ->
    faultcheck_ref:probe(Id, Type, faultcheck_ref_value:new(Type, Value), context(S)).

%% By its handle, which tells no code.
probe_handle_pre(S) -> are_probes(S).
probe_handle_args(_) -> [value(i32)].
probe_handle_pre(S, _) -> probe_handle_pre(S).
probe_handle(Value) -> faultcheck_threads_sut:probe_handle(Value).
probe_handle_next(S, Result, [Value]) -> probe_next(S, Result, [<<"x">>, i32, Value]).
probe_handle_post(S, [Value], {'FC_OK', Result}) ->
    faultcheck_ref_value:matches(i32, element(2, probed(<<"x">>, i32, Value, S)), Result).

num_active_pre(S) -> are_probes(S).
num_active_args(_) -> [probe_id()].
num_active_pre(S, _) -> num_active_pre(S).
num_active(Id) -> faultcheck_threads_sut:num_active(Id).
num_active_post(S, [Id], Result) -> Result =:= faultcheck_ref:num_active(Id, context(S)).

%% ---- channels ---------------------------------------------------------------------------------
put_pre(S) -> are_channels(S).
put_args(_) -> [channel(), packet()].
put_pre(S, _) -> put_pre(S).
put(Channel, Data) -> faultcheck_threads_sut:put(Channel, Data).
put_next(S, _, [Channel, Data]) -> after_(faultcheck_ref:put(Channel, Data, context(S)), S).
put_post(S, [Channel, Data], Result) ->
    gives(faultcheck_ref:put(Channel, Data, context(S)), Result).

get_pre(S) -> are_channels(S).
get_args(_) -> [channel(), receiver()].
get_pre(S, _) -> get_pre(S).
get(Channel, Receiver) -> faultcheck_threads_sut:get(Channel, Receiver).
get_next(S, _, [Channel, Receiver]) -> after_(ref_get(Channel, Receiver, S), S).
get_post(S, [Channel, Receiver], Result) -> gives(ref_get(Channel, Receiver, S), Result).

%% There is room for what put/2 puts.
ref_get(Channel, Receiver, S) -> faultcheck_ref:get(Channel, Receiver, 32, context(S)).

depth_pre(S) -> are_channels(S).
depth_args(_) -> [channel(), receiver()].
depth_pre(S, _) -> depth_pre(S).
depth(Channel, Receiver) -> faultcheck_threads_sut:depth(Channel, Receiver).
depth_next(S, _, [Channel, Receiver]) ->
    after_(faultcheck_ref:depth(Channel, Receiver, context(S)), S).
depth_post(S, [Channel, Receiver], Result) ->
    gives(faultcheck_ref:depth(Channel, Receiver, context(S)), Result).

subscribe_pre(S) -> are_channels(S).
subscribe_args(_) -> [channel(), receiver()].
subscribe_pre(S, _) -> subscribe_pre(S).
subscribe(Channel, Receiver) -> faultcheck_threads_sut:subscribe(Channel, Receiver).
subscribe_next(S, _, [Channel, Receiver]) ->
    S#state{context = faultcheck_ref:subscribe(Channel, Receiver, context(S))}.
subscribe_post(_, _, Result) -> Result =:= 'FC_OK'.

clear_pre(S) -> are_channels(S).
clear_args(_) -> [channel()].
clear_pre(S, _) -> clear_pre(S).
clear(Channel) -> faultcheck_threads_sut:clear(Channel).
clear_next(S, _, [Channel]) -> S#state{context = faultcheck_ref:clear(Channel, context(S))}.

%% ---- the property -------------------------------------------------------------------------------

%% @doc Whatever threads do, the library gives what the model gives in some order.
-spec agrees(profile()) -> proper:outer_test().
agrees(Profile) -> agrees(Profile, 2).

%% @doc The same on that many threads.
-spec agrees(profile(), pos_integer()) -> proper:outer_test().
agrees(Profile, Threads) ->
    ?SETUP(
        fun() ->
            ok = use(Profile),
            fun() -> ok end
        end,
        ?FORALL(Case, faultcheck_parallel:commands(?MODULE, limits(Threads)), begin
            Result = holds(Profile, Case),
            ?WHENFAIL(
                io:put_chars(faultcheck_parallel:pretty(Result)),
                aggregate(
                    faultcheck_parallel:command_names(Case), faultcheck_parallel:is_ok(Result))
            )
        end)
    ).

limits(2) -> #{branches => 2, length => 5};
limits(Threads) -> #{branches => Threads, length => 3}.

%% @doc One case: what came of it.
-spec holds(profile(), faultcheck_parallel_case:test_case()) -> faultcheck_parallel:result().
holds(Profile, Case) ->
    ok = use(Profile),
    Options = #{repetitions => 100, execute => fun faultcheck_threads_sut:execute/2},
    faultcheck_parallel:run_commands(?MODULE, Case, Options).

use(Profile) -> application:set_env(faultcheck_eqc, threads_profile, Profile).

%% ---- the state ----------------------------------------------------------------------------------

context(#state{context = C}) -> C.

after_({_, C}, S) -> S#state{context = C}.

gives({Expected, _}, Result) -> Result =:= Expected.

are_any(#state{faults = Faults}) -> Faults =/= [].

is_known(Id, #state{faults = Faults}) -> lists:member(Id, Faults).

are_probes(#state{profile = Profile}) -> Profile =:= probes.

are_channels(#state{profile = Profile}) -> Profile =:= channels.

%% ---- generators ---------------------------------------------------------------------------------

%% What meets on one name shows most.
probe_id() -> frequency([{5, <<"x">>}, {1, <<"y">>}]).

channel() -> frequency([{5, <<"c">>}, {1, <<"d">>}]).

receiver() -> frequency([{3, <<>>}, {1, <<"r">>}]).

place(#state{profile = probes}) -> {probe, probe_id()};
place(#state{profile = channels}) -> {channel, channel()}.

a_fault(#state{faults = Faults}) -> oneof(Faults).

%% Models that show which call was affected, and in which order.
value_model() ->
    oneof([
        {offset, 1.0},
        {drift, 1.0, none},
        {delay, {calls, integer(1, 2)}},
        {bitflip, integer(0, 7)},
        bitflip_random,
        stuck
    ]).

channel_model(Channel) ->
    [Other] = [<<"c">>, <<"d">>] -- [Channel],
    oneof([
        {drop, integer(0, 2)},
        {repeat, integer(0, 2)},
        {delay, {gets, integer(0, 2)}},
        {resequence, 1},
        {corruption, 0, integer(0, 7)},
        {misroute, Other},
        {masquerade, Other},
        lose,
        repeat_last,
        block_get,
        block_put
    ]).

%% Triggers that count.
change() ->
    frequency([
        {1, none},
        {2, {from, integer(0, 3)}},
        {2, {once, integer(0, 3)}},
        {3, {for, integer(0, 3)}},
        {2, {periodic, integer(1, 3), integer(1, 2)}},
        {1, {random, 0.5}}
    ]).

value(bytes) -> packet();
value(i32) -> integer(-20, 20);
value(f64) -> ?LET(N, integer(-40, 40), N / 4).

packet() -> ?LET(N, integer(0, 3), binary(N)).

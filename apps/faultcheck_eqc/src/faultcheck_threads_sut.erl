%% @doc libfaultcheck on several threads as the system under test of the calling process.
%%
%% The functions for a call add it to the plan of fc_threads that execute/2 is making, and give its
%% number. What the calls gave is read when the plan has run.
-module(faultcheck_threads_sut).

-export([execute/2, stop/0]).
-export([probe/3, probe_handle/1, num_active/1, put/2, get/2, depth/2, subscribe/2, clear/1]).
-export([add/2, trigger/2, enable/2, remove/1, remove_all/1, latest/1]).

-type place() :: {probe | channel, binary()}.
-type call_number() :: non_neg_integer().

%% The size of fc_threads_result.
-define(RESULT_BYTES, 64).

%% @doc Runs a case that many times: an outcome for each. An `execute' of faultcheck_parallel.
-spec execute(faultcheck_parallel_case:test_case(), pos_integer()) ->
    [faultcheck_linear:outcome()].
execute({parallel, First, Branches, Last} = Case, Repetitions) ->
    #{lib := Lib} = instance(),
    Threads = max(1, length(Branches)),
    Plan = cb:call(Lib, fc_threads_new, [Threads]),
    try
        Numbered = lists:zip(lists:seq(1, length(Branches)), Branches),
        Lanes = [{0, First} | Numbered] ++ [{Threads + 1, Last}],
        Numbers = lists:foldl(fun(Lane, Sofar) -> plan(Plan, Lane, Sofar) end, #{}, Lanes),
        0 = cb:call(Lib, fc_threads_run, [Plan, Repetitions, 1]),
        Commands = faultcheck_parallel_case:commands(Case),
        Calls = [{N, maps:get(N, Numbers), Call} || {set, {var, N}, Call} <- Commands],
        outcomes(Lib, Plan, Calls, Repetitions)
    after
        cb:call(Lib, fc_threads_free, [Plan])
    end.

%% Variables stand for numbers of calls while the plan is made.
plan(Plan, {Lane, Commands}, Numbers) ->
    _ = erlang:put({?MODULE, lane}, {Plan, Lane}),
    lists:foldl(
        fun({set, {var, N}, {call, Mod, Name, Args}}, Sofar) ->
            Number = apply(Mod, Name, faultcheck_run:evaluate(Args, Sofar)),
            Sofar#{N => Number}
        end,
        Numbers,
        Commands
    ).

outcomes(Lib, Plan, Calls, Repetitions) ->
    Size = length(Calls) * ?RESULT_BYTES,
    Pointer = cb:call(Lib, fc_threads_results, [Plan]),
    Bytes = cb:read_bytes(Lib, Pointer, Repetitions * Size),
    [outcome(binary:part(Bytes, R * Size, Size), Calls) || R <- lists:seq(0, Repetitions - 1)].

outcome(Bytes, Calls) ->
    Read = [{N, read(binary:part(Bytes, At * ?RESULT_BYTES, ?RESULT_BYTES), Call)}
            || {N, At, Call} <- Calls],
    {maps:from_list([{N, Result} || {N, {Result, _}} <- Read]),
     maps:from_list([{N, Times} || {N, {_, {Begin, _} = Times}} <- Read, Begin > 0])}.

read(<<Value:64/signed-native, Size:64/native, Begin:64/native, End:64/native, Data/binary>>,
     {call, _, Name, Args}) ->
    {result(Name, Args, Value, binary:part(Data, 0, Size)), {Begin, End}}.

result(probe, [_, Type, _], Code, Data) ->
    {code(Code), faultcheck_eqc_sut:decode(Type, Data)};
result(probe_handle, [_], Code, Data) ->
    {code(Code), faultcheck_eqc_sut:decode(i32, Data)};
result(get, _, 1, Data) -> {packet, Data};
result(get, _, 0, _) -> nothing;
result(Name, _, Value, _) when Value > 0; Name =:= num_active; Name =:= depth, Value >= 0 -> Value;
result(_, _, Code, _) -> code(Code).

code(Code) -> faultcheck_inject:code_name(Code).

%% ---- the instance -----------------------------------------------------------------------------

instance() ->
    case erlang:get(?MODULE) of
        undefined ->
            Sut = start(),
            _ = erlang:put(?MODULE, Sut),
            Sut;
        Sut ->
            Sut
    end.

start() ->
    Options = [
        {so, cb_library:find("libfc_threads.so", ?MODULE)},
        {transport, nif},
        {dirty, [fc_threads_run]},
        {reset, {calls, []}},
        {module, false}
    ],
    case cb:start(faultcheck_threads, Options) of
        {ok, Lib} -> #{lib => Lib};
        {error, Reason} -> error({cb, Reason})
    end.

%% @doc Ends the instance.
-spec stop() -> ok.
stop() ->
    case erase(?MODULE) of
        undefined -> ok;
        #{lib := Lib} -> cb:stop(Lib)
    end.

%% ---- calls ------------------------------------------------------------------------------------

call(Function, Args) ->
    {Plan, Lane} = erlang:get({?MODULE, lane}),
    #{lib := Lib} = instance(),
    Number = cb:call(Lib, Function, [Plan, Lane | Args]),
    Number >= 0 orelse error({fc_threads, Function, Args}),
    Number.

-spec probe(binary(), faultcheck_ref_value:type(), faultcheck_ref_value:value()) -> call_number().
probe(Id, Type, Value) ->
    Bytes = faultcheck_eqc_sut:encode(Type, Value),
    call(fc_threads_probe, [type(Type), Id, Bytes, byte_size(Bytes)]).

type(i32) -> 'FC_I32';
type(f64) -> 'FC_F64';
type(bytes) -> 'FC_BYTES'.

%% @doc A probe of <<"x">> by its handle.
-spec probe_handle(integer()) -> call_number().
probe_handle(Value) -> call(fc_threads_probe_handle, [Value]).

-spec num_active(binary()) -> call_number().
num_active(Id) -> named('FC_THREADS_NUM_ACTIVE', Id).

-spec put(binary(), binary()) -> call_number().
put(Channel, Data) -> call(fc_threads_put, [Channel, Data, byte_size(Data)]).

-spec get(binary(), binary()) -> call_number().
get(Channel, Receiver) -> call(fc_threads_get, [Channel, Receiver]).

-spec depth(binary(), binary()) -> call_number().
depth(Channel, Receiver) -> paired('FC_THREADS_DEPTH', Channel, Receiver).

-spec subscribe(binary(), binary()) -> call_number().
subscribe(Channel, Receiver) -> paired('FC_THREADS_SUBSCRIBE', Channel, Receiver).

-spec clear(binary()) -> call_number().
clear(Channel) -> named('FC_THREADS_CLEAR', Channel).

-spec add(place(), faultcheck_fault:model()) -> call_number().
add({probe, Id}, Model) -> call(fc_threads_arm, [Id, faultcheck_inject:fc_model(Model)]);
add({channel, Channel}, Model) -> add_communication(Channel, Model).

add_communication(Ch, {drop, N}) -> numbered('FC_THREADS_DROP', Ch, N);
add_communication(Ch, {repeat, N}) -> numbered('FC_THREADS_REPEAT', Ch, N);
add_communication(Ch, {delay, {gets, N}}) -> numbered('FC_THREADS_DELAY', Ch, N);
add_communication(Ch, {resequence, N}) -> numbered('FC_THREADS_RESEQUENCE', Ch, N);
add_communication(Ch, {corruption, 0, Bit}) -> numbered('FC_THREADS_CORRUPTION', Ch, Bit);
add_communication(Ch, {misroute, To}) -> paired('FC_THREADS_MISROUTE', Ch, To);
add_communication(Ch, {masquerade, From}) -> paired('FC_THREADS_MASQUERADE', Ch, From);
add_communication(Ch, lose) -> named('FC_THREADS_LOSE', Ch);
add_communication(Ch, repeat_last) -> named('FC_THREADS_REPEAT_LAST', Ch);
add_communication(Ch, block_get) -> named('FC_THREADS_BLOCK_GET', Ch);
add_communication(Ch, block_put) -> named('FC_THREADS_BLOCK_PUT', Ch).

-spec trigger(call_number(), faultcheck_ref_trigger:change()) -> call_number().
trigger(Fault, none) -> faulted('FC_THREADS_NONE', Fault, 0, 0);
trigger(Fault, {from, N}) -> faulted('FC_THREADS_AFTER', Fault, N, 0);
trigger(Fault, {once, N}) -> faulted('FC_THREADS_ONCE_AFTER', Fault, N, 0);
trigger(Fault, {for, N}) -> faulted('FC_THREADS_DURATION', Fault, N, 0);
trigger(Fault, {periodic, P, N}) -> faulted('FC_THREADS_PERIODIC', Fault, P, N);
trigger(Fault, {random, 0.5}) -> faulted('FC_THREADS_RANDOM', Fault, 1, 2).

-spec enable(call_number(), boolean()) -> call_number().
enable(Fault, true) -> faulted('FC_THREADS_ENABLE', Fault, 1, 0);
enable(Fault, false) -> faulted('FC_THREADS_ENABLE', Fault, 0, 0).

-spec remove(call_number()) -> call_number().
remove(Fault) -> faulted('FC_THREADS_REMOVE', Fault, 0, 0).

-spec remove_all(place()) -> call_number().
remove_all({probe, Id}) -> named('FC_THREADS_REMOVE_ALL', Id);
remove_all({channel, Channel}) -> named('FC_THREADS_CHANNEL_REMOVE_ALL', Channel).

-spec latest(place()) -> call_number().
latest({probe, Id}) -> named('FC_THREADS_LATEST', Id);
latest({channel, Channel}) -> named('FC_THREADS_CHANNEL_LATEST', Channel).

named(Which, Name) -> call(fc_threads_named, [Which, Name]).
numbered(Which, Channel, N) -> call(fc_threads_numbered, [Which, Channel, N]).
paired(Which, Channel, Other) -> call(fc_threads_paired, [Which, Channel, Other]).
faulted(Which, Fault, N, M) -> call(fc_threads_faulted, [Which, Fault, N, M]).

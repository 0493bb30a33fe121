%% @doc libfaultcheck as its document describes it: a context of the reference model.
%%
%% Written from faultcheck.md, sections 2 to 5 and 7.2 to 7.7. Pure: each function gives the
%% result that the library must give and the context afterwards. Codes are the names of fc.h.
-module(faultcheck_ref).

-export([new/1, reset/1, seed/2, advance/2, errors/1]).
-export([add/4, trigger/3, enable/3, remove/2, remove_all/2, restrict/3, latest/2]).
-export([probe/4, num_active/2, put/3, get/4, subscribe/3, clear/2, depth/3]).
-export([fault/2, faults/1, faults/2, receivers/2]).
-export_type([context/0, place/0]).

-type place() :: {probe | channel, binary()}.
-type probe() :: #{faults := [fault()], ordinal := non_neg_integer(), refused := boolean()}.
-type fault() :: faultcheck_ref_fault:fault().
-opaque context() :: #{
    first_seed := non_neg_integer(),
    seed := non_neg_integer(),
    now := integer(),
    %% not known after a value was not known
    errors := non_neg_integer() | unsure,
    probes := #{binary() => probe()},
    channels := faultcheck_ref_get:channels()
}.

%% @doc A context with a manual clock at 0.
-spec new(Seed :: non_neg_integer()) -> context().
new(Seed) ->
    #{first_seed => Seed, seed => Seed, now => 0, errors => 0, probes => #{}, channels => #{}}.

-spec reset(context()) -> context().
reset(#{first_seed := Seed}) -> new(Seed).

%% @doc All streams start anew.
-spec seed(non_neg_integer(), context()) -> context().
seed(Seed, C) ->
    Reseed = fun(Name, #{faults := Faults} = Record) ->
        Record#{faults := [faultcheck_ref_fault:seed(Seed, Name, F) || F <- Faults]}
    end,
    #{probes := Probes, channels := Channels} = C,
    C#{seed := Seed, probes := maps:map(Reseed, Probes), channels := maps:map(Reseed, Channels)}.

-spec advance(non_neg_integer(), context()) -> context().
advance(Ns, #{now := Now} = C) -> C#{now := Now + Ns}.

%% @doc Errors since the last reset.
-spec errors(context()) -> non_neg_integer() | unsure.
errors(#{errors := N}) -> N.

count(_, #{errors := unsure} = C) -> C;
count(unsure, C) -> C#{errors := unsure};
count(More, #{errors := N} = C) -> C#{errors := N + More}.

%% ---- arming -----------------------------------------------------------------------------------

%% @doc Adds a fault that will be known by Id, or refuses it.
-spec add(place(), faultcheck_fault:model(), term(), context()) -> {atom(), context()}.
add(Place, Model, Id, C) ->
    case faultcheck_ref_fault:refusal(Model) of
        'FC_OK' -> {'FC_OK', armed(Place, Model, Id, C)};
        Code -> {Code, refuse(Place, count(1, C))}
    end.

armed({_, Name} = Place, Model, Id, #{seed := Seed} = C) ->
    #{faults := Faults, ordinal := Ordinal} = Record = record(Place, C),
    Fault = faultcheck_ref_fault:new(Id, Model, Seed, Name, Ordinal),
    Changed = Record#{faults := Faults ++ [Fault], ordinal := Ordinal + 1, refused := false},
    store(Place, exists(Place, Changed), C).

%% A channel exists once it got a packet or a fault.
exists({channel, _}, Channel) -> Channel#{exists := true};
exists({probe, _}, Probe) -> Probe.

refuse(Place, C) -> store(Place, (record(Place, C))#{refused := true}, C).

%% @doc Changes a trigger.
-spec trigger(term(), faultcheck_ref_trigger:change(), context()) -> {atom(), context()}.
trigger(Id, Change, #{now := Now} = C) ->
    case valid(Change) of
        true -> with_fault(Id, fun(F) -> faultcheck_ref_fault:change(Change, Now, F) end, C);
        false -> {'FC_E_ARG', count(1, C)}
    end.

%% A duration may be below 0: without limit.
valid({for, _}) -> true;
valid({once, _}) -> true;
valid(none) -> true;
valid(Condition) -> faultcheck_fault:validate_trigger([Condition]) =:= ok.

-spec enable(term(), boolean(), context()) -> {atom(), context()}.
enable(Id, Enabled, C) -> with_fault(Id, fun(F) -> F#{enabled := Enabled} end, C).

%% @doc From now on for one receiver only.
-spec restrict(term(), binary(), context()) -> {atom(), context()}.
restrict(Id, Receiver, C) ->
    case fault(Id, C) of
        {ok, #{model := Model}} ->
            case faultcheck_fault:stage(Model) of
                get -> with_fault(Id, fun(F) -> F#{receiver := Receiver} end, C);
                _ -> {'FC_E_ARG', count(1, C)}
            end;
        error ->
            {'FC_E_NO_FAULT', count(1, C)}
    end.

-spec remove(term(), context()) -> {atom(), context()}.
remove(Id, C) ->
    case place_of(Id, C) of
        {ok, Place} ->
            #{faults := Faults} = Record = record(Place, C),
            {'FC_OK', store(Place, Record#{faults := [F || F <- Faults, not is(Id, F)]}, C)};
        error ->
            {'FC_E_NO_FAULT', count(1, C)}
    end.

%% @doc Disarms a place, or all probes, or all channels. Packets stay.
-spec remove_all(place() | probes | channels, context()) -> context().
remove_all(Kind, C) when is_atom(Kind) ->
    #{Kind := Records} = C,
    C#{Kind := maps:map(fun(_, Record) -> Record#{faults := []} end, Records)};
remove_all(Place, C) ->
    store(Place, (record(Place, C))#{faults := []}, C).

%% @doc The fault added last, unless it was refused.
-spec latest(place(), context()) -> {ok, term(), context()} | {'FC_E_NO_FAULT', context()}.
latest(Place, C) ->
    case record(Place, C) of
        #{refused := false, faults := [_ | _] = Faults} ->
            {ok, maps:get(id, lists:last(Faults)), C};
        _ ->
            {'FC_E_NO_FAULT', count(1, C)}
    end.

%% ---- probes -----------------------------------------------------------------------------------

%% @doc Passes a value through the faults of an identifier.
-spec probe(binary(), faultcheck_ref_value:type(), faultcheck_ref_value:value(), context()) ->
    {faultcheck_ref_model:code(), faultcheck_ref_value:value(), context()}.
probe(Id, Type, Value, #{now := Now} = C) ->
    #{faults := Faults} = Probe = record({probe, Id}, C),
    {Passed, {Codes, Result}} = lists:mapfoldl(
        fun(Fault, Sofar) -> pass(Fault, Type, Now, Sofar) end, {[], Value}, Faults),
    After = store({probe, Id}, Probe#{faults := Passed}, C),
    case lists:member(unsure, Codes) of
        true -> {unsure, Result, count(unsure, After)};
        false -> {lists:last(['FC_OK' | Codes]), Result, count(length(Codes), After)}
    end.

%% The codes of what was skipped, the first one last.
pass(#{model := Model} = Fault, Type, Now, {Codes, Value}) ->
    case faultcheck_ref_fault:pass(all, Now, Fault) of
        {false, Next} ->
            {Next, {Codes, Value}};
        {true, Next} ->
            case faultcheck_ref_fault:apply_value(Model, {Type, Value}, all, Now, Next) of
                {'FC_OK', Result, Applied} -> {Applied, {Codes, Result}};
                {Code, Result, Applied} -> {Applied, {[Code | Codes], Result}}
            end
    end.

%% @doc How many of an identifier's faults were triggered in its most recent call.
-spec num_active(binary(), context()) -> non_neg_integer().
num_active(Id, C) ->
    #{faults := Faults} = record({probe, Id}, C),
    length([active || #{runs := #{all := #{active := true}}} <- Faults]).

%% ---- channels ---------------------------------------------------------------------------------

-spec put(binary(), binary(), context()) -> {atom(), context()}.
put(Name, Data, #{channels := Channels, now := Now} = C) ->
    {Code, Errors, After} = faultcheck_ref_put:put(Name, Data, Now, Channels),
    {Code, count(Errors, C#{channels := After})}.

%% @doc A get with room for that many bytes.
-spec get(binary(), binary(), non_neg_integer(), context()) ->
    {nothing | {packet, binary() | any} | {atom(), non_neg_integer() | any} | 'FC_E_RECEIVER',
     context()}.
get(Name, Receiver, Capacity, #{channels := Channels, now := Now} = C) ->
    Channel = record({channel, Name}, C),
    case {faultcheck_ref_channel:exists(Channel),
          faultcheck_ref_channel:receiver(Receiver, Channel)} of
        {false, _} -> {nothing, C};
        {true, error} -> {'FC_E_RECEIVER', count(1, C)};
        {true, _} -> fit(Capacity, faultcheck_ref_get:get(Name, Receiver, Now, Channels), C)
    end.

%% A packet that does not fit: as if nothing had happened.
fit(Capacity, {{packet, Data}, _, _}, C) when is_binary(Data), byte_size(Data) > Capacity ->
    {{'FC_E_SPACE', byte_size(Data)}, count(1, C)};
fit(_, {Result, Errors, Channels}, C) ->
    {Result, count(Errors, C#{channels := Channels})}.

-spec subscribe(binary(), binary(), context()) -> context().
subscribe(Name, Receiver, C) ->
    Place = {channel, Name},
    store(Place, faultcheck_ref_channel:subscribe(Receiver, record(Place, C)), C).

-spec clear(binary(), context()) -> context().
clear(Name, C) ->
    store({channel, Name}, faultcheck_ref_channel:clear(record({channel, Name}, C)), C).

-spec depth(binary(), binary(), context()) -> {non_neg_integer() | atom(), context()}.
depth(Name, Receiver, C) ->
    case faultcheck_ref_channel:depth(Receiver, record({channel, Name}, C)) of
        Depth when is_integer(Depth) -> {Depth, C};
        Code -> {Code, count(1, C)}
    end.

%% ---- looking inside -----------------------------------------------------------------------------

%% @doc An armed fault.
-spec fault(term(), context()) -> {ok, fault()} | error.
fault(Id, C) ->
    case [F || {_, F} <- faults(C), is(Id, F)] of
        [Fault] -> {ok, Fault};
        [] -> error
    end.

%% @doc All armed faults and where they are.
-spec faults(context()) -> [{place(), fault()}].
faults(#{probes := Probes, channels := Channels}) ->
    [{{probe, Name}, F} || {Name, #{faults := Faults}} <- maps:to_list(Probes), F <- Faults] ++
        [{{channel, Name}, F} || {Name, #{faults := Fs}} <- maps:to_list(Channels), F <- Fs].

-spec faults(place(), context()) -> [fault()].
faults(Place, C) -> maps:get(faults, record(Place, C)).

-spec receivers(binary(), context()) -> [binary()].
receivers(Name, C) -> faultcheck_ref_channel:names(record({channel, Name}, C)).

is(Id, #{id := Other}) -> Id =:= Other.

place_of(Id, C) ->
    case [Place || {Place, F} <- faults(C), is(Id, F)] of
        [Place] -> {ok, Place};
        [] -> error
    end.

with_fault(Id, Change, C) ->
    case place_of(Id, C) of
        {ok, Place} ->
            #{faults := Faults} = Record = record(Place, C),
            Changed = [case is(Id, F) of true -> Change(F); false -> F end || F <- Faults],
            {'FC_OK', store(Place, Record#{faults := Changed}, C)};
        error ->
            {'FC_E_NO_FAULT', count(1, C)}
    end.

record({probe, Name}, #{probes := Probes}) ->
    maps:get(Name, Probes, #{faults => [], ordinal => 0, refused => false});
record({channel, Name}, #{channels := Channels}) ->
    maps:get(Name, Channels, faultcheck_ref_channel:new()).

store({probe, Name}, Probe, #{probes := Probes} = C) -> C#{probes := Probes#{Name => Probe}};
store({channel, Name}, Channel, #{channels := Channels} = C) ->
    C#{channels := Channels#{Name => Channel}}.

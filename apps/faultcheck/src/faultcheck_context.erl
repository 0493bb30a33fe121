%% @doc Contexts of libfaultcheck in a library under test: made, reset, seeded, their clocks, and
%% what they have seen and armed, as terms.
%%
%% ```
%% {ok, Context} = faultcheck_context:new(Lib, #{seed => 7}),
%% ok = faultcheck_context:advance(Lib, Context, 1000000),
%% {ok, [#{id := <<"speed">>, faults := [_]} | _]} = faultcheck_context:list(Lib, Context).
%% '''
%% Faults are armed by faultcheck_inject. A context may be null: the default one.
-module(faultcheck_context).

-export([new/2, free/2, reset/2, seed/3, error_count/2, count_calls/3, list/2]).
-export([now/2, advance/3, use_clock/3]).
-export_type([listed/0, listed_fault/0]).

-type context() :: faultcheck_inject:context().
-type listed() :: #{
    id := binary(),
    kind := probe | channel,
    %% probed or monitored as these; of probes
    types := [faultcheck_record:type()],
    %% probe and monitor calls, while they are counted; gets
    calls := non_neg_integer(),
    puts := non_neg_integer(),
    faults := [listed_fault()]
}.
%% One on a channel that is met at gets is listed once for each receiver.
-type listed_fault() :: #{
    id := faultcheck_inject:id(),
    model := binary(),
    %% parameters as in fc_model of fc_fault.h; n also: byte, count or position
    a := number() | atom(),
    b := number() | atom(),
    n := integer(),
    receiver := binary(),
    state := waiting | active | exhausted | disabled,
    calls_left := non_neg_integer(),
    triggered := non_neg_integer(),
    applied := non_neg_integer(),
    skipped := non_neg_integer(),
    last_error := atom()
}.

%% @doc A context of its own; free it with free/2.
-spec new(cb:library(), #{seed => non_neg_integer()}) ->
    {ok, cb:ptr()} | {error, faultcheck_inject:reason()}.
new(Lib, Options) ->
    case faultcheck_inject:attempt(Lib, fc_new, [null]) of
        {null, Error} ->
            Error();
        {Context, _} ->
            ok = maps:foreach(fun(seed, Seed) -> seed(Lib, Context, Seed) end, Options),
            {ok, Context}
    end.

-spec free(cb:library(), cb:ptr()) -> ok.
free(Lib, Context) -> cb:call(Lib, fc_free, [Context]).

%% @doc Faults, queues, counters, names seen, recordings and streams as in a new one.
-spec reset(cb:library(), context()) -> ok.
reset(Lib, Context) -> cb:call(Lib, fc_reset, [Context]).

%% @doc All random streams anew.
-spec seed(cb:library(), context(), 0..16#FFFFFFFFFFFFFFFF) -> ok.
seed(Lib, Context, Seed) -> cb:call(Lib, fc_seed, [Context, Seed]).

%% @doc Errors since the last reset.
-spec error_count(cb:library(), context()) -> non_neg_integer().
error_count(Lib, Context) -> cb:call(Lib, fc_error_count, [Context]).

%% @doc Whether calls of identifiers that are not armed, monitored or recorded are counted too.
-spec count_calls(cb:library(), context(), boolean()) -> ok.
count_calls(Lib, Context, On) -> cb:call(Lib, fc_count_calls, [Context, On]).

%% ---- the clock --------------------------------------------------------------------------------

%% @doc Nanoseconds by the context's clock.
-spec now(cb:library(), context()) -> integer().
now(Lib, Context) -> cb:call(Lib, fc_now, [Context]).

%% @doc Moves the manual clock, which is the context's from the first call on.
-spec advance(cb:library(), context(), Ns :: integer()) -> ok.
advance(Lib, Context, Ns) -> cb:call(Lib, fc_advance, [Context, Ns]).

%% @doc The system's monotonic clock, or a C function int64_t name(void *) of the library.
-spec use_clock(cb:library(), context(), monotonic | {function, cb:fname()}) -> ok.
use_clock(Lib, Context, monotonic) ->
    cb:call(Lib, fc_set_clock, [Context, null, null]);
use_clock(Lib, Context, {function, Name}) ->
    cb:call(Lib, fc_set_clock, [Context, cb:address_of(Lib, Name), null]).

%% ---- the listing ------------------------------------------------------------------------------

%% @doc Every identifier and channel seen or armed since the context was new, sorted by name, probes
%% before channels of the same name.
-spec list(cb:library(), context()) -> {ok, [listed()]} | {error, faultcheck_inject:reason()}.
list(Lib, Context) ->
    case faultcheck_inject:attempt(Lib, fc_listing_new, [Context]) of
        {null, Error} ->
            Error();
        {Listing, _} ->
            Entries = entries(Lib, Listing, 0),
            ok = cb:call(Lib, fc_listing_free, [Listing]),
            {ok, Entries}
    end.

entries(Lib, Listing, At) ->
    case cb:call(Lib, fc_listing_at, [Listing, At]) of
        null ->
            [];
        Pointer ->
            [Entry] = cb:read(Lib, Pointer, 1),
            [listed(Lib, Entry) | entries(Lib, Listing, At + 1)]
    end.

listed(Lib, #{id := Id, is_channel := Channel, types := Types} = Entry) ->
    #{calls := Calls, puts := Puts, faults := Faults, fault_count := Count} = Entry,
    #{
        id => cb:cstring(Lib, Id),
        kind => case Channel of true -> channel; false -> probe end,
        types => faultcheck_record:types(Types),
        calls => Calls,
        puts => Puts,
        faults => [fault(Lib, F) || Count > 0, F <- cb:read(Lib, Faults, Count)]
    }.

fault(Lib, #{model := Model, receiver := Receiver, state := State, last_error := Code} = Fault) ->
    Known = maps:with([id, a, b, n, calls_left, triggered, applied, skipped], Fault),
    Known#{
        model => cb:cstring(Lib, Model),
        receiver => cb:cstring(Lib, Receiver),
        state => state(State),
        last_error => faultcheck_inject:code_name(Code)
    }.

state('FC_WAITING') -> waiting;
state('FC_ACTIVE') -> active;
state('FC_EXHAUSTED') -> exhausted;
state('FC_DISABLED') -> disabled.

%% @doc One run of a source as messages: numbers frames and events, and decides what is due.
%%
%% Pure but for the source's simulator. What is told in intervals (ranges ten times, status five
%% times, everything that lasts once a second) goes by a pace in microseconds that the caller gives:
%% wall time when playing, simulated time in a recording.
-module(replay_run).

-export([new/3, start/1, advance/2, show/3, repeat/2, again/1, changed/1]).
-export([source/1, with_source/2, module_of/1, number/1, told/2, act/2]).
-export([chosen/1, observe/2, add/2]).
-export_type([run/0, message/0, pace/0, status/0]).

-type message() :: {replay_lcm:type(), replay_lcm:message()}.
-type pace() :: integer().
%% VIZ_STATUS without time and run.
-type status() :: #{atom() => term()}.

-record(run, {
    source :: replay_source:source(),
    number :: pos_integer(),
    frames = 0 :: non_neg_integer(),
    events = 0 :: non_neg_integer(),
    %% the latest events by number, to be told again; when that was last done, and which is next
    history = #{} :: #{non_neg_integer() => message()},
    repeated = none :: none | {pace(), non_neg_integer()},
    observer :: auto | replay_source:id(),
    %% further members of `params' of VIZ_CASE
    extra = [] :: [{atom(), faultcheck_json:json()}],
    world = none :: none | replay_source:world(),
    version = 0 :: non_neg_integer(),
    faults_key = none :: term(),
    %% what the latest frame showed
    shown = none :: term(),
    status = none :: none | status(),
    %% when each of these was last told
    told = #{} :: #{atom() => pace()}
}).
-opaque run() :: #run{}.

-define(EVERY, #{
    lasting => 1000000, faults => 1000000, still => 1000000, status => 200000, ranges => 100000
}).
%% So many events are told again, every so many microseconds; so many are kept for that (a bridge
%% keeps as many).
-define(REPEATED, 200).
-define(REPEAT_US, 1000000).
-define(MOST_EVENTS, 20000).

%% @doc A run with this number; whose contours are shown, or auto: the source's choice.
-spec new(replay_source:source(), pos_integer(), auto | replay_source:id()) -> run().
new(Source, Number, Observer) -> #run{source = Source, number = Number, observer = Observer}.

%% @doc Brings the source to time 0.
-spec start(run()) -> {[message()], run()}.
start(#run{source = {Mod, State}} = Run) ->
    {Events, Next} = Mod:start(State),
    told(Events, Run#run{source = {Mod, Next}}).

%% @doc Lets simulated time pass.
-spec advance(replay_source:t_us(), run()) -> {[message()], run()}.
advance(T, #run{source = {Mod, State}} = Run) ->
    {Events, Next} = Mod:advance(T, State),
    told(Events, Run#run{source = {Mod, Next}}).

%% @doc What a person does.
-spec act(replay_source:action(), run()) -> {ok, [message()], run()} | {error, string()}.
act(Action, #run{source = {Mod, State}} = Run) ->
    case Mod:act(Action, State) of
        {ok, Events, Next} ->
            {Messages, Told} = told(Events, Run#run{source = {Mod, Next}}),
            {ok, Messages, Told};
        {error, _} = Error ->
            Error
    end.

%% @doc Events as messages.
-spec told([replay_source:event()], run()) -> {[message()], run()}.
told(Events, #run{number = Number} = Run) ->
    lists:mapfoldl(
        fun(Event, #run{events = N, history = History} = Now) ->
            Message = {event, Event#{run => Number, seq => N}},
            Kept = maps:remove(N - ?MOST_EVENTS, History#{N => Message}),
            {Message, Now#run{events = N + 1, history = Kept}}
        end,
        Run,
        Events
    ).

%% @doc Events that were told before, once a second again with their old numbers, for whoever has
%% come since: all, or when there are many the next 200 of them in turn.
-spec repeat(pace(), run()) -> {[message()], run()}.
repeat(Pace, #run{repeated = none} = Run) ->
    {[], Run#run{repeated = {Pace, 0}}};
repeat(Pace, #run{repeated = {Last, _}} = Run) when Pace - Last < ?REPEAT_US ->
    {[], Run};
repeat(Pace, #run{repeated = {_, Next}, history = History, events = End} = Run) ->
    Known = map_size(History),
    Oldest = End - Known,
    From = max(Next - Oldest, 0),
    Count = min(Known, ?REPEATED),
    Numbers = [Oldest + (From + I) rem Known || I <- lists:seq(0, Count - 1)],
    {[map_get(N, History) || N <- lists:sort(Numbers)],
     Run#run{repeated = {Pace, Oldest + (From + Count) rem max(Known, 1)}}}.

%% @doc Whatever is due: a frame with the observer's contours whenever there is something new to be
%% seen, and what is told in intervals. A frame of the same moment is told once a second again, with
%% its old number.
-spec show(pace(), status(), run()) -> {[message()], run()}.
show(Pace, Status, Run0) ->
    Parts = [fun lasting/2, fun faults/2, fun picture/2, fun ranges/2,
             fun(P, R) -> status(P, Status, R) end],
    {Messages, Run} = lists:mapfoldl(fun(Part, Run) -> Part(Pace, Run) end, Run0, Parts),
    {lists:append(Messages), Run}.

%% @doc Everything is due again: something has changed that cannot be seen here.
-spec again(run()) -> run().
again(Run) -> Run#run{told = #{}}.

%% @doc What can be seen has changed without time or an event.
-spec changed(run()) -> run().
changed(Run) -> Run#run{shown = none}.

lasting(Pace, #run{source = {Mod, State}, number = Number} = Run0) ->
    case due(lasting, Pace, Run0) of
        {false, Run} ->
            {[], Run};
        {true, Due} ->
            Run = #run{version = Version} = with_world(Mod:world(State), Due),
            World = (Run#run.world)#{run => Number, version => Version},
            {[{case_info, info(Mod:info(State), Run)}, {world, World}], Run}
    end.

info(#{params := {object, Members}} = Info, #run{extra = Extra}) ->
    Info#{params := faultcheck_json:encode({object, Members ++ Extra})}.

with_world(World, #run{world = World} = Run) -> Run;
with_world(World, #run{version = Version} = Run) -> Run#run{world = World, version = Version + 1}.

faults(Pace, #run{source = {Mod, State}, faults_key = Before, number = Number} = Run0) ->
    Key = Mod:faults_key(State),
    case due(faults, Pace, Run0) of
        {false, Run} when Key =:= Before ->
            {[], Run};
        {_, Run} ->
            Faults = #{t_us => Mod:now(State), run => Number, items => Mod:faults(State)},
            {[{faults, Faults}], mark(faults, Pace, Run#run{faults_key = Key})}
    end.

picture(Pace, #run{shown = Before, frames = N} = Run0) ->
    Shown = {now_of(Run0), Run0#run.events, observer(Run0)},
    case due(still, Pace, Run0) of
        {false, Run} when Shown =:= Before ->
            {[], Run};
        {true, Run} when Shown =:= Before ->
            {frame(N - 1, Run), Run};
        {_, Run} ->
            {frame(N, Run), mark(still, Pace, Run#run{shown = Shown, frames = N + 1})}
    end.

now_of(#run{source = {Mod, State}}) -> Mod:now(State).

frame(Seq, #run{source = {Mod, State}, number = Number} = Run) ->
    Observer = observer(Run),
    At = #{t_us => Mod:now(State), run => Number},
    [
        {frame, At#{seq => Seq, objects => Mod:objects(State)}},
        {risk, At#{observer => Observer, ellipses => Mod:risk(Observer, State)}}
    ].

ranges(Pace, #run{source = {Mod, State}, number = Number} = Run0) ->
    case due(ranges, Pace, Run0) of
        {false, Run} ->
            {[], Run};
        {true, Run} ->
            Observer = observer(Run),
            Ranges = #{
                t_us => Mod:now(State), run => Number, object => Observer,
                items => Mod:ranges(Observer, State)
            },
            {[{ranges, Ranges}], Run}
    end.

status(Pace, Status, #run{status = Before, source = {Mod, State}, number = Number} = Run0) ->
    case due(status, Pace, Run0) of
        {false, Run} when Status =:= Before ->
            {[], Run};
        {_, Run} ->
            Message = Status#{t_us => Mod:now(State), run => Number},
            {[{status, Message}], mark(status, Pace, Run#run{status = Status})}
    end.

due(What, Pace, #run{told = Told} = Run) ->
    case Told of
        #{What := Last} when Pace - Last < map_get(What, ?EVERY) -> {false, Run};
        _ -> {true, mark(What, Pace, Run)}
    end.

mark(What, Pace, #run{told = Told} = Run) -> Run#run{told = Told#{What => Pace}}.

%% @doc The source as it is now.
-spec source(run()) -> replay_source:state().
source(#run{source = {_, State}}) -> State.

-spec module_of(run()) -> module().
module_of(#run{source = {Mod, _}}) -> Mod.

%% @doc The run with its source in another state.
-spec with_source(replay_source:state(), run()) -> run().
with_source(State, #run{source = {Mod, _}} = Run) -> Run#run{source = {Mod, State}}.

-spec number(run()) -> pos_integer().
number(#run{number = Number}) -> Number.

%% @doc Adds members to `params' of VIZ_CASE, which docs/visualizer.md lists.
-spec add([{atom(), faultcheck_json:json()}], run()) -> run().
add(Members, #run{extra = Extra} = Run) -> Run#run{extra = Extra ++ Members}.

%% Whose contours are shown; -1: nobody's.
observer(#run{observer = auto, source = {Mod, State}}) -> Mod:observer(State);
observer(#run{observer = Id}) -> Id.

%% @doc Who was chosen to be observed.
-spec chosen(run()) -> auto | replay_source:id().
chosen(#run{observer = Observer}) -> Observer.

%% @doc Shows the contours of another object.
-spec observe(replay_source:id(), run()) -> run().
observe(Id, #run{told = Told} = Run) ->
    Run#run{observer = Id, told = maps:remove(ranges, Told)}.

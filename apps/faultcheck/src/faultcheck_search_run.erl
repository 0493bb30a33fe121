%% @doc One run of a command sequence for the guided search: the smallest objective, when and by
%% whom, what the run cost, and snapshots on its way.
%%
%% A child of a sequence begins with the same commands. Where the system under test has snapshots,
%% the run goes on from the last one that was taken in the common part: the prefix itself is
%% compared, command by command.
-module(faultcheck_search_run).

-export([new/4, refs/1, observer/1]).
-export_type([run/0, outcome/0, place/0]).

%% Where a snapshot was taken: the number of commands before it, the position of the run, what it
%% has seen so far, the simulated time, and the model's own reference.
-type place() :: #{
    count := pos_integer(),
    position := faultcheck_run:position(),
    best := best(),
    elapsed := number(),
    ref := term()
}.
-type best() :: {Value :: number(), Time :: number(), Key :: term()} | none.
%% An atom compares greater than any number: worse than all.
-type value() :: number() | worst.
-type outcome() :: ok | faultcheck_run:result().
-type run() :: #{
    commands := [faultcheck_generator:command()],
    side := faultcheck_generator:side(),
    outcome := outcome(),
    value := value(),
    time := number(),
    key := term(),
    %% simulated time of the whole run, and what of it was simulated now
    elapsed := number(),
    simulated := number(),
    places := [place()]
}.

-record(going, {
    model :: {module(), faultcheck_model:info()},
    position :: faultcheck_run:position(),
    best = none :: best(),
    elapsed = 0 :: number(),
    count = 0 :: non_neg_integer(),
    %% simulated time between two snapshots, and when the last was taken; or none are taken
    every :: number() | none,
    last = 0 :: number(),
    places = [] :: [place()]
}).

%% @doc Runs a sequence. Parent: a run whose snapshots are still there, or none.
-spec new(module(), {[faultcheck_generator:command()], faultcheck_generator:side()}, run() | none,
          faultcheck_search_options:options()) -> run().
new(Mod, {Commands, Side}, Parent, Options) ->
    faultcheck_journal:attempt(),
    Going = begin_at(Mod, Commands, Parent, Options),
    From = Going#going.elapsed,
    Rest = lists:nthtail(Going#going.count, Commands),
    {Outcome, #going{best = Best, elapsed = Elapsed, places = Places}} = steps(Rest, Going),
    {Value, Time, Key} = nearest(Best),
    #{
        commands => Commands,
        side => Side,
        outcome => Outcome,
        value => value(Outcome, Value),
        time => Time,
        key => Key,
        elapsed => Elapsed,
        simulated => Elapsed - From,
        places => Places
    }.

nearest(none) -> {worst, 0, none};
nearest(Best) -> Best.

value({objective, _}, _) -> worst;
value(_, Value) -> Value.

%% @doc The snapshots that a run needs.
-spec refs(run()) -> [term()].
refs(#{places := Places}) -> [Ref || #{ref := Ref} <- Places].

%% ---- where to begin -----------------------------------------------------------------------

begin_at(Mod, Commands, Parent, #{time := Time, snapshots := Snapshots, begin_test := Begin}) ->
    Model = {Mod, faultcheck_model:info(Mod)},
    Every =
        case Snapshots > 0 andalso faultcheck_model:has_snapshots(element(2, Model)) of
            true -> Time / Snapshots;
            false -> none
        end,
    case common(Commands, Parent) of
        [Place | _] = Places ->
            restored(Place, Commands, #going{
                model = Model,
                position = maps:get(position, Place),
                every = Every,
                places = Places
            });
        [] ->
            _ = Begin(),
            #going{
                model = Model,
                position = faultcheck_run:start(Mod, [], none),
                every = Every
            }
    end.

restored(#{ref := Ref, count := Count} = Place, Commands, #going{model = {Mod, _}} = Going) ->
    _ = Mod:restore(Ref),
    %% Should the system die, the journal has all the commands that led there.
    lists:foreach(fun faultcheck_journal:command/1, lists:sublist(Commands, Count)),
    #{best := Best, elapsed := Elapsed} = Place,
    Going#going{best = Best, elapsed = Elapsed, count = Count, last = Elapsed}.

%% The parent's places in the common beginning, the last one first.
common(_Commands, none) ->
    [];
common(Commands, #{commands := Others, places := Places}) ->
    Same = same(Commands, Others, 0),
    lists:dropwhile(fun(#{count := Count}) -> Count > Same end, Places).

same([Command | Rest], [Command | Others], N) -> same(Rest, Others, N + 1);
same(_, _, N) -> N.

%% ---- command by command -------------------------------------------------------------------

steps([], Going) ->
    {ok, Going};
steps([Command | Rest], #going{position = Position} = Going) ->
    {Result, Next} = faultcheck_run:step(Command, Position),
    case judged(Result, behind(Command, Going#going{position = Next})) of
        {ok, After} -> steps(Rest, snapshot(After));
        Failed -> Failed
    end.

behind({set, _, {call, _, Name, Args}}, Going) ->
    #going{model = Model, elapsed = Elapsed, count = Count} = Going,
    Duration = faultcheck_model:duration(Model, Name, Args),
    Going#going{elapsed = Elapsed + Duration, count = Count + 1}.

judged(ok, #going{model = Model, position = Position, elapsed = Elapsed} = Going) ->
    case objective(Model, faultcheck_run:state(Position)) of
        false -> {ok, Going};
        {objective, _} = Failed -> {Failed, Going};
        {Value, When, Key} -> {ok, nearer({Value, moment(When, Elapsed), Key}, Going)}
    end;
judged(Failed, Going) ->
    {Failed, Going}.

nearer({Value, _, _} = New, #going{best = Best} = Going) when
    Best =:= none; Value < element(1, Best)
->
    Going#going{best = New};
nearer(_, Going) ->
    Going.

moment(now, Elapsed) -> Elapsed;
moment({time, Time}, _Elapsed) -> Time.

snapshot(#going{every = Every, last = Last, elapsed = Elapsed} = Going) when
    Every =:= none; Elapsed - Last < Every
->
    Going;
snapshot(#going{model = {Mod, _}, position = Position, places = Places} = Going) ->
    #going{count = Count, best = Best, elapsed = Elapsed} = Going,
    Place = #{
        count => Count, position => Position, best => Best, elapsed => Elapsed,
        ref => Mod:snapshot()
    },
    Going#going{places = [Place | Places], last = Elapsed}.

%% What is no finite number is a failure. A model that is tested by chance may have none.
objective({_, Info} = Model, State) ->
    faultcheck_model:has_objective(Info) andalso told(Model, State).

told(Model, State) ->
    try faultcheck_model:objective(Model, State) of
        {Value, now, _} = Objective when is_number(Value) -> Objective;
        {Value, {time, T}, _} = Objective when is_number(Value), is_number(T) -> Objective;
        Other -> {objective, Other}
    catch
        Class:Reason:Stack -> {objective, {exception, Class, Reason, Stack}}
    end.

%% @doc Looks at the objective behind each command of an ordinary run.
-spec observer(module()) -> faultcheck_run:observe().
observer(Mod) ->
    Model = {Mod, faultcheck_model:info(Mod)},
    fun(State) ->
        case objective(Model, State) of
            {objective, _} = Failed -> Failed;
            _ -> ok
        end
    end.

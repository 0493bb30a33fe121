%% @doc The player: a run on a clock, and what people ask of it.
%%
%% Wall time and messages come in as arguments, what is to be done about them goes out
%% (replay_player_server does it), so that a test needs neither network nor patience. Whoever calls
%% owns the source's simulator.
%%
%% A run can only go forward. To seek backwards is a new run from the start, which the page knows
%% by its number; until the moment wanted is reached, it is told ten frames a simulated second.
-module(replay_player).

-export([open/2, wake/2, next_wake/1, control/4, refresh/1, close/1]).
-export([has_ended/1, first_number/0, notice/2, unsaved/1]).
-export_type([player/0, options/0, out/0, opening/0]).

-type wall() :: replay_clock:wall().
%% What to play: with the source that a case's model names, or with the source given by `view'.
-type opening() ::
    {'case', file:filename(), shrunk | original} | {view, replay_source:what()}.
-type options() :: #{
    opening := opening(),
    %% of the first run; later ones count on
    number := pos_integer(),
    %% the source of what is no case, if there is one
    view := module() | none,
    %% none: nobody may control it
    token := none | binary(),
    cases := file:filename(),
    scenarios := file:filename(),
    playing := boolean(),
    speed := float()
}.
-type out() ::
    {publish, replay_run:message()}
    %% for the terminal
    | {log, string()}
    | {store, replay_kept:kept(), replay_kept:files()}.

-record(player, {
    options :: options(),
    opening :: opening(),
    run :: replay_run:run(),
    clock :: replay_clock:clock(),
    %% where to, of a run that is not there yet
    target = none :: none | replay_source:t_us(),
    %% the end and the verdict have been told
    ended = false :: boolean(),
    verdict = 0 :: 0..3,
    message = "" :: string(),
    %% when steering of an object ends by itself
    leases = #{} :: #{replay_source:id() => wall()},
    %% a live flight that is worth keeping
    touched = false :: boolean(),
    asked = replay_asked:new() :: replay_asked:asked(),
    woken :: wall()
}).
-opaque player() :: #player{}.

-define(FRAMES_PER_S, 60).
-define(STATUS_US, 200000).
-define(LEASE_US, 300000).
%% us of simulated time: at most so much is computed before messages are heard again; frames on the
%% way to a target
-define(PART_US, 2000000).
-define(SPARSE_US, 100000).
-define(FRAME_US, 16667).
-define(RUN_MASK, 16#3FFFFFFF).

%% ---- opening and closing ----------------------------------------------------------------------

%% @doc Opens what is to be played and begins.
-spec open(options(), wall()) -> {ok, [out()], player()} | {error, string()}.
open(#{opening := Opening, number := Number, playing := Playing, speed := Speed} = Options, Now) ->
    case source(Opening, Options) of
        {ok, Source} ->
            {Out, Player} = begun(Source, Number, Now, #player{
                options = Options, opening = Opening, woken = Now,
                run = replay_run:new(Source, Number, auto),
                clock = replay_clock:speed(Now, Speed, replay_clock:new(0))
            }),
            {ok, Out, playing(Playing, Now, Player)};
        {error, _} = Error ->
            Error
    end.

playing(true, Now, #player{clock = Clock} = P) -> P#player{clock = replay_clock:play(Now, Clock)};
playing(false, Now, #player{clock = Clock} = P) -> P#player{clock = replay_clock:pause(Now, Clock)}.

source({'case', Dir, Which}, #{view := View}) ->
    replay_source:of_case(Dir, Which, View);
source({view, _}, #{view := none}) ->
    {error, "what is to be played? a case: faultcheck play cases/<id>"};
source({view, What}, #{view := View}) ->
    case View:open(What) of
        {ok, State} -> {ok, {View, State}};
        {error, _} = Error -> Error
    end.

%% A source from its beginning. A stored one is played to its end first: then it is known when that
%% is, and who is worth looking at.
begun({Mod, State} = Source, Number, Now, #player{clock = Clock} = P) ->
    {Limit, Observer} =
        case Mod:is_live(State) of
            true -> {infinity, auto};
            false -> preview(Source)
        end,
    New = P#player{
        run = replay_run:new(Source, Number, Observer),
        clock = replay_clock:seek(Now, 0, replay_clock:limit(Now, Limit, Clock)),
        touched = false, leases = #{}, message = ""
    },
    started(none, New).

preview({Mod, State}) ->
    {_, Begun} = Mod:start(State),
    {_, Ended} = Mod:advance(Mod:duration(Begun), Begun),
    {Mod:now(Ended), Mod:observer(Ended)}.

%% The run from time 0, on its way to a target.
started(Target, #player{run = Run0} = P) ->
    {Messages, Run} = replay_run:start(replay_run:add(flyable(P), Run0)),
    {publish(Messages), P#player{run = Run, target = Target, ended = false, verdict = 0}}.

%% What `scenario' takes.
flyable(#player{options = #{token := none}}) ->
    [];
flyable(#player{options = #{scenarios := Dir}}) ->
    Files = [F || F <- filelib:wildcard("*.json", Dir), replay_verb:is_file_name(F)],
    [{scenarios, [{text, F} || F <- Files]}].

again(Target, #player{run = Run} = P) ->
    Source = {replay_run:module_of(Run), replay_run:source(Run)},
    Fresh = replay_run:new(Source, replay_run:number(Run) + 1, replay_run:chosen(Run)),
    started(Target, P#player{run = Fresh}).

publish(Messages) -> [{publish, M} || M <- Messages].

%% @doc What is left to be done when nothing will be played any more.
-spec close(player()) -> [out()].
close(P) ->
    {Out, _} = kept(P),
    Out.

%% ---- time -------------------------------------------------------------------------------------

%% @doc Lets time pass up to this moment.
-spec wake(wall(), player()) -> {[out()], player()}.
wake(Now, P0) ->
    {Released, P1} = release(Now, P0),
    {Moved, P2} = move(Now, P1#player{woken = Now}),
    {Shown, P3} = show(Now, P2),
    {Released ++ Moved ++ Shown, P3}.

%% @doc Everything that is told in intervals is told at the next moment again.
-spec refresh(player()) -> player().
refresh(#player{run = Run} = P) -> P#player{run = replay_run:again(Run)}.

%% @doc When to wake it next; a moment that has passed means: at once.
-spec next_wake(player()) -> wall().
next_wake(#player{target = Target, woken = Woken}) when Target =/= none -> Woken;
next_wake(#player{clock = Clock, woken = Woken, leases = Leases}) ->
    Next =
        case replay_clock:is_playing(Clock) of
            true -> next_frame(Woken);
            false -> Woken + ?STATUS_US
        end,
    lists:min([Next | maps:values(Leases)]).

%% On a grid of wall time, so that late frames do not make later ones late.
next_frame(Now) ->
    Number = floor_div(Now * ?FRAMES_PER_S, 1000000) + 1,
    -floor_div(-Number * 1000000, ?FRAMES_PER_S).

floor_div(A, B) when A >= 0 -> A div B;
floor_div(A, B) -> -((-A + B - 1) div B).

release(Now, #player{leases = Leases} = P) ->
    Over = [Id || {Id, Until} <- maps:to_list(Leases), Until =< Now],
    lists:foldl(
        fun(Id, {Out, Player}) ->
            case act({release, Id}, Player) of
                {ok, New, Next} -> {Out ++ New, Next};
                {error, _} -> {Out, Player}
            end
        end,
        {[], P#player{leases = maps:without(Over, Leases)}},
        lists:sort(Over)
    ).

move(Now, #player{clock = Clock, target = none} = P) ->
    towards(replay_clock:position(Now, Clock), Now, P);
move(Now, #player{target = Target} = P) ->
    towards(Target, Now, P).

towards(Wanted, Now, #player{run = Run} = P) ->
    {Mod, State} = {replay_run:module_of(Run), replay_run:source(Run)},
    Step = Mod:step_us(State),
    Reached = Mod:now(State),
    case Wanted div Step * Step of
        T when T < Reached ->
            {Out, Fresh} = again(T, P),
            {More, Next} = towards(T, Now, Fresh),
            {Out ++ More, Next};
        %% a run of no length is over before it begins
        T when T =< Reached; P#player.ended ->
            ended(Now, [], P#player{target = none});
        T when T - Reached > ?PART_US; P#player.target =/= none ->
            sparsely(min(T, Reached + ?PART_US), T, Now, P);
        T ->
            {Messages, Next} = replay_run:advance(T, Run),
            ended(Now, publish(Messages), P#player{run = Next, target = none})
    end.

%% On the way to T as far as Until.
sparsely(Until, T, Now, #player{run = Run0} = P0) ->
    {Mod, State} = {replay_run:module_of(Run0), replay_run:source(Run0)},
    case Mod:now(State) of
        Reached when Reached >= T ->
            {[], P0#player{target = none}};
        Reached when Reached >= Until ->
            {[], P0#player{target = T}};
        Reached ->
            {Messages, Run} = replay_run:advance(min(Until, Reached + ?SPARSE_US), Run0),
            {Events, P1} = ended(Now, publish(Messages), P0#player{run = Run, target = T}),
            {Shown, P2} = show(Now, P1),
            case P2#player.ended of
                true ->
                    {Events ++ Shown, P2};
                false ->
                    {More, P3} = sparsely(Until, T, Now, P2),
                    {Events ++ Shown ++ More, P3}
            end
    end.

%% Whether that was the end; then the clock stands there.
ended(_, Out, #player{ended = true} = P) ->
    {Out, P#player{target = none}};
ended(Now, Out, #player{run = Run, clock = Clock} = P) ->
    {Mod, State} = {replay_run:module_of(Run), replay_run:source(Run)},
    case {Mod:ending(State), replay_clock:looped(Clock)} of
        {running, _} ->
            {Out, P};
        {Ending, Loop} ->
            {Verdict, Message} = verdict(Ending, Mod:recorded(State)),
            {Told, Next} = differing(Verdict, Message, Mod:now(State), Run),
            Done = P#player{
                run = Next, ended = true, target = none, verdict = Verdict, message = Message,
                clock = stopped(Loop, Now, Mod:now(State), Clock)
            },
            {Kept, Last} = kept(Done),
            {Out ++ Told ++ Kept, Last#player{message = Message}}
    end.

stopped({_, _}, _, _, Clock) -> Clock;
stopped(none, Now, T, Clock) -> replay_clock:pause(Now, replay_clock:seek(Now, T, Clock)).

verdict(passed, Recorded) when Recorded =:= passed; Recorded =:= unknown -> {1, ""};
verdict({failed, _}, Recorded) when Recorded =:= any_failure; Recorded =:= unknown -> {2, ""};
verdict({failed, Text}, {failed, Text}) -> {2, ""};
verdict(Ending, Recorded) ->
    {3, lists:concat(["this build does not end as recorded: ", words(Ending), "; recorded: ",
                      words(Recorded)])}.

words(passed) -> "passed";
words(any_failure) -> "failed";
words({failed, Text}) -> Text.

differing(3, Message, T, Run) -> event(<<"verdict">>, "differs: " ++ Message, T, Run);
differing(_, _, _, Run) -> {[], Run}.

event(Kind, Text, T, Run) ->
    Event = #{
        t_us => T, kind => Kind, a => -1, b => -1, x => 0.0, y => 0.0, text => Text
    },
    {Messages, Next} = replay_run:told([Event], Run),
    {publish(Messages), Next}.

%% @doc A line for whoever looks at the run that is played now: an event of kind `log'. Reports
%% contain it, so it names no folder.
-spec notice(string(), player()) -> {[out()], player()}.
notice(Line, #player{run = Run} = P) ->
    Now = (replay_run:module_of(Run)):now(replay_run:source(Run)),
    {Out, Next} = event(<<"log">>, Line, Now, Run),
    {Out, P#player{run = Next}}.

show(Now, #player{run = Run0} = P) ->
    {Messages, Run1} = replay_run:show(Now, status(P), Run0),
    {Repeated, Run} = replay_run:repeat(Now, Run1),
    {publish(Messages ++ Repeated), P#player{run = Run}}.

status(#player{run = Run, clock = Clock, options = #{token := Token}} = P) ->
    {Mod, State} = {replay_run:module_of(Run), replay_run:source(Run)},
    #{
        mode => mode_number(mode(P)),
        paused => flag(not replay_clock:is_playing(Clock)),
        speed => replay_clock:speed(Clock),
        duration_us => known(Mod:is_live(State), Clock),
        verdict => P#player.verdict,
        control_allowed => flag(Token =/= none),
        message => P#player.message
    }.

known(true, _) -> -1;
known(false, Clock) -> replay_clock:limit_of(Clock).

mode_number(live) -> 1;
mode_number(replay) -> 2.

flag(true) -> 1;
flag(false) -> 0.

%% @doc Whether there is nothing more to be seen.
-spec has_ended(player()) -> boolean().
has_ended(#player{ended = Ended}) -> Ended.

%% @doc A number for the first run, above those of any player before: seconds of wall time.
-spec first_number() -> pos_integer().
first_number() -> erlang:system_time(second) band ?RUN_MASK.

%% Whether a person flies.
mode(#player{run = Run}) ->
    case (replay_run:module_of(Run)):is_live(replay_run:source(Run)) of
        true -> live;
        false -> replay
    end.

%% ---- what people ask for ----------------------------------------------------------------------

%% @doc A VIZ_CONTROL message. Sender is who sent it: the client's name is only unique there.
-spec control(replay_lcm:message(), Sender :: term(), wall(), player()) -> {[out()], player()}.
control(_, _, _, #player{options = #{token := none}} = P) ->
    {[], P};
control(#{token := Given, client := Client, seq := Seq} = Message, Sender, Now, P) ->
    #player{options = #{token := Token}, asked = Asked} = P,
    case replay_verb:token_fits(Given, Token) of
        false ->
            Ack = ack(Message, {error, "control: wrong token; load the page again"}),
            {[{log, "refused a control message with a wrong token"}, Ack], P};
        true ->
            case replay_asked:before({Sender, Client}, Seq, Asked) of
                new -> answered(Message, Sender, Now, P);
                {answered, Answer} -> {[ack(Message, Answer)], P};
                overtaken -> {[ack(Message, {error, "came too late, after a newer one"})], P}
            end
    end.

%% At the moment it comes, not at that of the latest frame.
answered(#{client := Client, seq := Seq} = Message, Sender, Now, P0) ->
    {Moved, P} = wake(Now, P0),
    {Out, Answer, Next} =
        case replay_verb:parse(Message) of
            {error, Line} -> {[], {error, Line}, P};
            {ok, Verb} -> done(Verb, Now, P)
        end,
    Asked = replay_asked:answered({Sender, Client}, Seq, Answer, Next#player.asked),
    {Shown, Last} = show(Now, Next#player{asked = Asked}),
    {Moved ++ Out ++ [ack(Message, Answer)] ++ Shown, Last}.

done(Verb, Now, P) ->
    case do(Verb, Now, P) of
        {ok, Out, Next} -> {Out, ok, Next};
        {error, Line} -> {[], {error, Line}, P}
    end.

ack(#{client := Client, seq := Seq}, Answer) ->
    {Ok, Text} =
        case Answer of
            ok -> {1, ""};
            {error, Line} -> {0, Line}
        end,
    {publish, {ack, #{client => Client, seq => Seq, ok => Ok, text => Text}}}.

do(play, Now, #player{ended = true} = P) ->
    case mode(P) of
        live -> {error, "play: the flight is over; restart it"};
        replay -> from_start(Now, playing(true, Now, P))
    end;
do(play, Now, P) ->
    {ok, [], playing(true, Now, P)};
do(pause, Now, P) ->
    {ok, [], playing(false, Now, P)};
do({speed, Factor}, Now, #player{clock = Clock} = P) ->
    {ok, [], P#player{clock = replay_clock:speed(Now, Factor, Clock)}};
do({loop, Span}, Now, #player{clock = Clock} = P) ->
    replay_only("loop", P, fun() ->
        {ok, [], P#player{clock = replay_clock:loop(Now, Span, Clock)}}
    end);
do({step, Frames}, Now, #player{run = Run} = P) ->
    {Mod, State} = {replay_run:module_of(Run), replay_run:source(Run)},
    T = Mod:now(State) + Frames * max(?FRAME_US, Mod:step_us(State)),
    case mode(P) of
        live when Frames < 0 -> {error, "step: a live flight cannot go back"};
        _ -> {ok, [], sought(max(0, T), Now, playing(false, Now, P))}
    end;
do({seek, T}, Now, P) ->
    replay_only("seek", P, fun() -> {ok, [], sought(T, Now, P)} end);
do(restart, Now, P) ->
    case mode(P) of
        replay -> from_start(Now, P);
        live -> reopened(P#player.opening, Now, P)
    end;
do({observe, Id}, _, #player{run = Run} = P) ->
    {Mod, State} = {replay_run:module_of(Run), replay_run:source(Run)},
    case Id =:= -1 orelse lists:member(Id, [I || #{id := I} <- Mod:objects(State)]) of
        true -> {ok, [], P#player{run = replay_run:observe(Id, Run)}};
        false -> {error, lists:concat(["observe: there is no object ", Id])}
    end;
do({load, Id, Which}, Now, #player{options = #{cases := Cases}} = P) ->
    Dir = filename:join(Cases, Id),
    Opening =
        case filelib:is_dir(Dir) of
            true -> {'case', Dir, Which};
            false -> {view, {named, Id}}
        end,
    case is_played(Opening, P) of
        true -> {ok, [], P};
        false -> reopened(Opening, Now, P)
    end;
do({scenario, Name}, Now, #player{options = #{scenarios := Dir}} = P) ->
    reopened({view, {scenario, filename:join(Dir, Name)}}, Now, P);
do(fork, Now, #player{target = Target} = P) ->
    case {mode(P), Target} of
        {live, _} -> {error, "fork: this flight is live already"};
        {replay, none} -> forked(Now, P);
        {replay, _} -> {error, "fork: not there yet, seeking"}
    end;
do({live, Action}, Now, P) ->
    case mode(P) of
        live -> acted(Action, Now, P);
        replay -> {error, verb_of(Action) ++ ": only in a live flight; fork this replay first"}
    end.

%% Several pages may ask for what all of them show: it is not begun again for each.
is_played(Opening, #player{opening = Opening, ended = false} = P) -> mode(P) =:= replay;
is_played(_, _) -> false.

%% It goes on from where it is, unless it has failed.
forked(Now, #player{run = Run, clock = Clock} = P) ->
    {Mod, State} = {replay_run:module_of(Run), replay_run:source(Run)},
    Live = Mod:fork(State),
    case Mod:ending(Live) of
        running ->
            Free = replay_clock:limit(Now, infinity, replay_clock:loop(Now, none, Clock)),
            {ok, [], P#player{
                run = replay_run:again(replay_run:with_source(Live, Run)),
                clock = replay_clock:seek(Now, Mod:now(State), Free),
                touched = true, ended = false, verdict = 0, message = ""
            }};
        {failed, Text} ->
            {error, "fork: it is over, " ++ Text ++ "; seek back first"}
    end.

verb_of(Action) when is_atom(Action) -> atom_to_list(Action);
verb_of(Action) -> atom_to_list(element(1, Action)).

replay_only(Verb, P, Fun) ->
    case mode(P) of
        replay -> Fun();
        live -> {error, Verb ++ ": a live flight only goes forward"}
    end.

sought(T, Now, #player{clock = Clock} = P) ->
    Sought = replay_clock:seek(Now, T, Clock),
    P#player{clock = Sought, target = replay_clock:position(Now, Sought)}.

from_start(Now, #player{clock = Clock} = P) ->
    {Out, Next} = again(none, P#player{clock = replay_clock:seek(Now, 0, Clock), message = ""}),
    {ok, Out, Next}.

%% What is played now stays when the other cannot be opened.
reopened(Opening, Now, #player{options = Options, run = Run} = P) ->
    case source(Opening, Options) of
        {error, _} = Error ->
            Error;
        {ok, Source} ->
            {Kept, Left} = kept(P),
            Number = replay_run:number(Run) + 1,
            Free = Left#player{clock = replay_clock:loop(Now, none, Left#player.clock)},
            {Out, Next} = begun(Source, Number, Now, Free#player{opening = Opening}),
            {ok, Kept ++ Out, playing(true, Now, Next)}
    end.

acted({steer, Id, _, _, _} = Action, Now, #player{leases = Leases} = P) ->
    acting(Action, P#player{leases = Leases#{Id => Now + ?LEASE_US}});
acted(stop_all, Now, P) ->
    acting(stop_all, playing(false, Now, P#player{leases = #{}}));
acted(Action, _, P) ->
    acting(Action, P).

acting(Action, P) ->
    case act(Action, P) of
        {ok, Out, Next} -> {ok, Out, Next#player{touched = true}};
        {error, Line} -> {error, with_verb(verb_of(Action), Line)}
    end.

with_verb(Verb, Line) ->
    case string:prefix(Line, Verb ++ ":") of
        nomatch -> Verb ++ ": " ++ Line;
        _ -> Line
    end.

act(Action, #player{run = Run0} = P) ->
    case replay_run:act(Action, Run0) of
        {ok, Messages, Run} -> {ok, publish(Messages), P#player{run = replay_run:changed(Run)}};
        {error, _} = Error -> Error
    end.

%% @doc The live flight that would be stored if it ended now.
-spec unsaved(player()) -> none | {module(), replay_source:state()}.
unsaved(#player{touched = true, run = Run}) ->
    {replay_run:module_of(Run), replay_run:source(Run)};
unsaved(_) ->
    none.

%% A live flight in which somebody did something is stored.
kept(#player{touched = true, run = Run} = P) ->
    {Mod, State} = {replay_run:module_of(Run), replay_run:source(Run)},
    {Kept, Files} = Mod:store(State),
    {[{store, Kept, Files}], P#player{touched = false}};
kept(P) ->
    {[], P}.

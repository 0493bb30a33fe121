%% @doc A run from beginning to end as an LCM log: the run.lcm of a case.
%%
%% It has a frame at every event and every 15 to 20 ms of simulated time, and everything else that
%% the player would send but answers to control. Times of the log are simulated, so the same case
%% gives the same bytes each time.
-module(replay_recording).

-export([write/2, messages/1]).
-export_type([summary/0]).

-type summary() :: #{
    end_us := replay_source:t_us(),
    frames := non_neg_integer(),
    events := non_neg_integer(),
    ending := replay_source:ending()
}.

-define(FRAME_US, 20000).
-define(MODE_REPLAY, 2).

%% @doc Records a source that the calling process has opened. Its duration must be known. The file
%% appears when it is complete.
-spec write(replay_source:source(), file:filename()) -> {ok, summary()} | {error, string()}.
write(Source, File) ->
    case replay_lcm_log:create(File) of
        {ok, Writer} -> written(Source, Writer);
        {error, _} = Error -> Error
    end.

written(Source, Writer) ->
    try fold(Source, fun log/2, Writer) of
        {Done, Summary} -> closed(replay_lcm_log:close(Done), Summary)
    catch
        throw:{cannot_write, Line} ->
            replay_lcm_log:discard(Writer),
            {error, Line};
        Class:Reason:Stack ->
            replay_lcm_log:discard(Writer),
            erlang:raise(Class, Reason, Stack)
    end.

closed(ok, Summary) -> {ok, Summary};
closed({error, _} = Error, _) -> Error.

log({T, {Type, Message}}, Writer) ->
    Bytes = replay_lcm:encode(Type, Message),
    case replay_lcm_log:write(Writer, T, replay_lcm:channel(Type), Bytes) of
        {ok, Next} -> Next;
        {error, Line} -> throw({cannot_write, Line})
    end.

%% @doc The same as messages, each with its simulated time, and how it went.
-spec messages(replay_source:source()) ->
    {[{replay_source:t_us(), replay_run:message()}], summary()}.
messages(Source) ->
    {Messages, Summary} = fold(Source, fun(Message, All) -> [Message | All] end, []),
    {lists:reverse(Messages), Summary}.

%% First without looking: who is to be observed, and when it ends, is known afterwards.
fold({Mod, State0}, Fun, Acc) ->
    {_, State1} = Mod:start(State0),
    {_, Ended} = Mod:advance(Mod:duration(State1), State1),
    Status = #{
        mode => ?MODE_REPLAY, paused => 0, speed => 1.0, duration_us => Mod:now(Ended),
        control_allowed => 0, message => "", verdict => 0
    },
    {Begun, Run} = replay_run:start(replay_run:new({Mod, Ended}, 1, Mod:observer(Ended))),
    Parts = frame_us(Mod:step_us(Ended)),
    #{acc := Last, end_us := End} = Counted = parts(Run, Begun, Parts, Status, Fun, #{
        acc => Acc, frames => 0, events => 0, end_us => Mod:now(Ended)
    }),
    Summary = (maps:with([frames, events], Counted))#{
        end_us => End, ending => Mod:ending(Ended)
    },
    {Last, Summary}.

%% As many whole steps as fit.
frame_us(Step) -> max(1, ?FRAME_US div Step) * Step.

parts(Run0, Events, Every, Status, Fun, Counted0) ->
    Mod = replay_run:module_of(Run0),
    State = replay_run:source(Run0),
    Now = Mod:now(State),
    Ending = Mod:ending(State),
    {Shown, Run} = replay_run:show(Now, Status#{verdict := verdict(Ending)}, Run0),
    Counted = counted(Now, Events ++ Shown, length(Events), Fun, Counted0),
    case Ending of
        running ->
            Sample = (Now div Every + 1) * Every,
            Until = lists:min([Sample | [T || T <- [Mod:next(State)], is_integer(T), T > Now]]),
            {New, Next} = replay_run:advance(Until, Run),
            parts(Next, New, Every, Status, Fun, Counted);
        _ ->
            Counted
    end.

counted(T, Messages, NewEvents, Fun, #{acc := Acc, frames := Frames, events := Events} = Counted) ->
    Counted#{
        acc := lists:foldl(fun(M, A) -> Fun({T, M}, A) end, Acc, Messages),
        frames := Frames + 1,
        events := Events + NewEvents
    }.

verdict(running) -> 0;
verdict(passed) -> 1;
verdict({failed, _}) -> 2.

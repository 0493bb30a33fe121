%% @doc Looks after a port program on behalf of the process that talks to it.
%%
%% It kills the program when that process ends: a program that hangs in C code does not notice that
%% nobody listens any more. And it tells that process when an answer is overdue, so that no call has
%% to set up a timer; overdue is what has taken the time allowed and up to half as much again.
-module(cb_janitor).

-export([start/1, program/4, finished/1]).
-export_type([janitor/0]).

-type janitor() :: pid().

-record(watch, {
    owner :: pid(),
    monitor :: reference(),
    timeout :: timeout(),
    os_pid = none :: none | non_neg_integer(),
    %% the number of the last request, the number of the last one that nobody waits for
    counters = none :: none | atomics:atomics_ref(),
    key :: undefined | reference(),
    seen = 0 :: non_neg_integer(),
    ticks = 0 :: non_neg_integer()
}).

-define(TICKS, 4).

%% @doc Looks after the calling process; Timeout is what a request may take.
-spec start(timeout()) -> janitor().
start(Timeout) ->
    Owner = self(),
    spawn(fun() ->
        wait(#watch{owner = Owner, monitor = monitor(process, Owner), timeout = Timeout})
    end).

%% @doc The program, instead of the one told before. When the request of the first counter is not
%% that of the second one for too long, the owner gets `{overdue, Key, Number}'.
-spec program(janitor(), non_neg_integer(), atomics:atomics_ref(), Key :: reference()) -> ok.
program(Janitor, OsPid, Counters, Key) ->
    Janitor ! {program, OsPid, Counters, Key},
    ok.

%% @doc The owner has cleaned up itself.
-spec finished(janitor()) -> ok.
finished(Janitor) ->
    Janitor ! finished,
    ok.

wait(#watch{monitor = Monitor, os_pid = OsPid} = Watch) ->
    receive
        {program, Next, Counters, Key} ->
            wait(Watch#watch{os_pid = Next, counters = Counters, key = Key, seen = 0});
        finished ->
            ok;
        {'DOWN', Monitor, process, _, _} ->
            kill(OsPid)
    after tick(Watch) ->
        wait(look(Watch))
    end.

kill(none) -> ok;
kill(OsPid) -> cb_program:signal(OsPid, kill).

tick(#watch{timeout = infinity}) -> infinity;
tick(#watch{counters = none}) -> infinity;
tick(#watch{timeout = Timeout}) -> max(1, (Timeout + ?TICKS - 1) div ?TICKS).

look(#watch{counters = Counters, seen = Seen, ticks = Ticks} = Watch) ->
    case {atomics:get(Counters, 1), atomics:get(Counters, 2)} of
        {Number, Number} -> Watch#watch{seen = 0};
        {Seen, _} -> told(Watch#watch{ticks = Ticks + 1});
        {Number, _} -> Watch#watch{seen = Number, ticks = 0}
    end.

%% Once: at the tick at which it becomes overdue.
told(#watch{owner = Owner, key = Key, seen = Number, ticks = ?TICKS} = Watch) ->
    Owner ! {overdue, Key, Number},
    Watch;
told(Watch) ->
    Watch.

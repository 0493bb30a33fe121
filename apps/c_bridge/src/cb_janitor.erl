%% @doc Cleans up after a process that ends without stopping its system under test.
%%
%% A port program that hangs in C code does not notice that nobody listens any more.
-module(cb_janitor).

-export([start/0, program/2, finished/1]).
-export_type([janitor/0]).

-type janitor() :: pid().

%% @doc Watches the calling process.
-spec start() -> janitor().
start() ->
    Owner = self(),
    spawn(fun() -> wait(monitor(process, Owner), none) end).

%% @doc The OS process that must not outlive the owner, instead of the one told before.
-spec program(janitor(), non_neg_integer()) -> ok.
program(Janitor, OsPid) ->
    Janitor ! {program, OsPid},
    ok.

%% @doc The owner has cleaned up itself.
-spec finished(janitor()) -> ok.
finished(Janitor) ->
    Janitor ! finished,
    ok.

wait(Owner, OsPid) ->
    receive
        {program, Next} -> wait(Owner, Next);
        finished -> ok;
        {'DOWN', Owner, process, _, _} -> kill(OsPid)
    end.

kill(none) -> ok;
kill(OsPid) -> cb_program:signal(OsPid, kill).

%% A source without a simulator: one object that moves 1 m/s along x, in steps of 5 ms, and
%% `{ends, T, Ending}' says how. By hand it can be steered and moved aside.
-module(replay_test_source).
-behaviour(replay_source).

-export([open/1, start/1, advance/2, next/1, now/1, step_us/1, duration/1, ending/1, recorded/1]).
-export([is_live/1, info/1, world/1, objects/1, risk/2, ranges/2, faults/1, faults_key/1]).
-export([observer/1, fork/1, act/2, store/1]).

-define(STEP, 5000).

open({moving, Duration, Ending, Recorded}) ->
    {ok, #{
        duration => Duration, will => Ending, recorded => Recorded, live => false, now => 0,
        ending => running, y => 0.0, steer => none, faults => []
    }};
open(live) ->
    {ok, Source} = open({moving, unknown, running, unknown}),
    {ok, Source#{live := true}};
%% Something happens while it is opened.
open({after_that, Happens, What}) ->
    _ = Happens(),
    open(What);
open({named, "other"}) ->
    open({moving, 500000, passed, passed});
open(What) ->
    {error, lists:flatten(io_lib:format("there is no ~0tp", [What]))}.

start(#{duration := Duration, will := Will} = S) ->
    Ending = case Duration of 0 -> Will; _ -> running end,
    {[event(command, 0, <<"go">>)], S#{now := 0, ending := Ending, y := 0.0, steer := none}}.

event(Kind, T, Text) ->
    #{kind => atom_to_binary(Kind), t_us => T, a => 0, b => -1, x => 0.0, y => 0.0, text => Text}.

advance(_, #{ending := Ending} = S) when Ending =/= running ->
    {[], S};
advance(T, #{duration := End, will := Will} = S) ->
    case T div ?STEP * ?STEP of
        Now when is_integer(End), Now >= End ->
            {[event(verdict, End, <<"the end">>)], S#{now := End, ending := Will}};
        Now ->
            {[], S#{now := Now}}
    end.

next(_) -> none.
now(#{now := Now}) -> Now.
step_us(_) -> ?STEP.
duration(#{duration := End}) -> End.
ending(#{ending := Ending}) -> Ending.
recorded(#{recorded := Recorded}) -> Recorded.
is_live(#{live := Live}) -> Live.

info(_) ->
    #{
        case_id => <<"test">>, property => <<>>, seed => <<>>, code_version => <<>>,
        ncmd_original => 0, commands => [], params => {object, []}
    }.

world(_) -> #{seg => [], anchors => [], polys => []}.

objects(#{now := Now, y := Y, steer := Steer}) ->
    [
        #{
            id => 0, kind => 2,
            flags => case Steer of none -> 0; _ -> 16 end,
            pos => [Now / 1.0e6, Y, 0.0], vel => [1.0, 0.0, 0.0], yaw => 0.0, roll => 0.0,
            pitch => 0.0, pos_est => [0.0, 0.0, 0.0], vel_est => [0.0, 0.0, 0.0],
            comfort => 1.0, steer => [0.0, 0.0]
        }
    ].

risk(_, _) -> [].
ranges(_, _) -> [].
faults(#{faults := Faults}) -> Faults.
faults_key(#{faults := Faults}) -> length(Faults).
observer(_) -> 0.
fork(#{ending := Ending} = S) ->
    Goes = case Ending of passed -> running; _ -> Ending end,
    S#{live := true, duration := unknown, ending := Goes}.

act({steer, 0, _, _, _} = Steer, S) ->
    {ok, [event(command, now(S), <<"steer">>)], S#{steer := Steer}};
act({release, 0}, S) -> {ok, [event(command, now(S), <<"release">>)], S#{steer := none}};
act(stop_all, S) -> {ok, [], S#{steer := none}};
act({set, -1, <<"y">>, Y}, S) -> {ok, [], S#{y := Y}};
act(Action, _) -> {error, lists:flatten(io_lib:format("cannot ~0tp", [Action]))}.

store(_) ->
    Sequence = [[{set, {var, 1}, {call, replay_test_source, go, []}}]],
    {
        #{
            module => prop_test, property => prop_test, status => passed, seed => 0, test => none,
            size => none, transport => none, options => [], versions => faultcheck_versions:all(),
            original => Sequence, shrunk => Sequence, reasons => [], shrink => #{}
        },
        [{"more.txt", "more"}]}.

%% @doc What can be played: a stored case or a live simulation, as the player and recordings see it.
%%
%% A source belongs to the process that opened it and knows nothing of wall time, messages' numbers
%% or the network. Times are simulated microseconds; what is shown are maps with the members of the
%% messages in lcm/*.lcm.
%%
%% A model of commands (faultcheck_model) says which module shows its cases by exporting
%% `view() -> module()'; of_case/3 finds it.
-module(replay_source).

-export([of_case/3]).
-export_type([id/0, t_us/0, object/0, ellipse/0, range/0, fault/0, event/0, world/0, info/0]).
-export_type([what/0, state/0, ending/0, action/0, source/0]).

%% Of a vehicle; -1 where a message wants one and there is none.
-type id() :: integer().
-type t_us() :: non_neg_integer().
-type object() :: #{atom() => term()}.
-type ellipse() :: #{atom() => term()}.
-type range() :: #{atom() => term()}.
-type fault() :: #{atom() => term()}.
%% kind, a, b, x, y, text and t_us; the number and the run are added by those who send it.
-type event() :: #{atom() => term()}.
%% seg, anchors, polys
-type world() :: #{atom() => term()}.
%% case_id, property, seed, code_version, ncmd_original, commands; params is an object with its
%% members in order, {object, _} of faultcheck_json
-type info() :: #{atom() => term()}.

%% What open/1 takes; a source may know more.
-type what() ::
    %% a folder of a stored case
    {'case', file:filename(), shrunk | original}
    %% one that the source brings along
    | {named, string()}
    | example
    %% a scenario file, flown live
    | {scenario, file:filename()}
    %% a folder of a flight that is no case (replay_kept)
    | {kept, file:filename()}
    | live
    | term().
-type state() :: term().
-type source() :: {module(), state()}.
%% The text tells how it failed: equal texts are equal failures.
-type ending() :: running | passed | {failed, string()}.
%% What a person does in a live flight.
-type action() ::
    {steer, id(), Roll :: float(), Pitch :: float(), YawRate :: float()}
    %% nobody steers it any more
    | {release, id()}
    | {set, id() | -1, Name :: binary(), float()}
    %% the text of `inject' in docs/visualizer.md, decoded
    | {inject, #{binary() => faultcheck_json:decoded()}}
    %% of all, or of one object; everywhere, or at {"probe": ...}
    | {clear_faults, id() | -1, all | #{binary() => faultcheck_json:decoded()}}
    | {add_object, X :: float(), Y :: float()}
    | {remove_object, id()}
    %% no steering any more
    | stop_all.

%% Opens it and brings it to time 0. The error is one line.
-callback open(what()) -> {ok, state()} | {error, string()}.
%% Back to time 0, with the events of that time.
-callback start(state()) -> {[event()], state()}.
%% Lets time pass: up to the last whole step not after T, or to the end.
-callback advance(t_us(), state()) -> {[event()], state()}.
%% When something planned happens next.
-callback next(state()) -> t_us() | none.
-callback now(state()) -> t_us().
-callback step_us(state()) -> pos_integer().
%% Unknown of a live flight.
-callback duration(state()) -> t_us() | unknown.
-callback ending(state()) -> ending().
%% How it ended when it was stored. any_failure: it failed, nobody knows how.
-callback recorded(state()) -> unknown | any_failure | ending().
-callback is_live(state()) -> boolean().

-callback info(state()) -> info().
-callback world(state()) -> world().
-callback objects(state()) -> [object()].
%% The risk contours of one object; [] when it is not there.
-callback risk(id(), state()) -> [ellipse()].
-callback ranges(id(), state()) -> [range()].
-callback faults(state()) -> [fault()].
%% Another term whenever what faults/1 tells has changed, but for hits.
-callback faults_key(state()) -> term().
%% Whom to look at when nobody was chosen: whoever failed, or the first.
-callback observer(state()) -> id().

%% From here on a person flies.
-callback fork(state()) -> state().
-callback act(action(), state()) -> {ok, [event()], state()} | {error, string()}.
%% The flight so far as something to be stored.
-callback store(state()) -> {replay_kept:kept(), replay_kept:files()}.

%% @doc Opens a stored case with the source that its model names; a flight that is no case with
%% View, if there is one.
-spec of_case(file:filename(), shrunk | original, View :: module() | none) ->
    {ok, source()} | {error, string()}.
of_case(Dir, Which, View) ->
    case replay_kept:is_flight(Dir) of
        true when View =:= none -> {error, line("~ts: no case, and nothing can show it", [Dir])};
        true -> opened(View, {kept, Dir});
        false -> read(Dir, Which)
    end.

read(Dir, Which) ->
    case faultcheck_case:read(Dir) of
        {ok, Case} -> shown_by(view(maps:get(Which, Case)), Dir, Which);
        {error, _} = Error -> Error
    end.

view(CounterExample) ->
    case faultcheck_case:commands(CounterExample) of
        {ok, [{set, _, {call, Model, _, _}} | _]} -> {Model, exported(Model)};
        none -> {none, none}
    end.

exported(Model) ->
    _ = code:ensure_loaded(Model),
    case erlang:function_exported(Model, view, 0) of
        true -> Model:view();
        false -> none
    end.

shown_by({none, _}, Dir, _) ->
    {error, line("~ts: this case has no commands to be shown", [Dir])};
shown_by({Model, none}, Dir, _) ->
    {error, line("~ts: nothing can show it; the model ~ts exports no view/0", [Dir, Model])};
shown_by({_, View}, Dir, Which) ->
    opened(View, {'case', Dir, Which}).

opened(View, What) ->
    case View:open(What) of
        {ok, State} -> {ok, {View, State}};
        {error, _} = Error -> Error
    end.

line(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

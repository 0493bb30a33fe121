%% @doc A recording (run.lcm) as terms: what exports are made from.
-module(replay_flight).

-export([read/1, at/2, world_at/2, position_error/1, velocity_error/1, nearest/2]).
-export_type([flight/0]).

%% us, 285 years: times are exact in every program that reads an export.
-define(LATEST, (1 bsl 53)).

-type object() :: replay_source:object().
-type flight() :: #{
    'case' := none | replay_source:info(),
    %% in order of time; these are decoded messages
    frames := [replay_lcm:message(), ...],
    risks := [replay_lcm:message()],
    events := [replay_lcm:message()],
    %% with the time from which each holds
    worlds := [{replay_source:t_us(), replay_lcm:message()}]
}.

%% @doc Reads a recording. The error is one line.
-spec read(file:filename()) -> {ok, flight()} | {error, string()}.
read(File) ->
    Empty = #{'case' => none, frames => [], risks => [], events => [], worlds => []},
    try replay_lcm_log:fold(File, fun(Event, Flight) -> add(Event, File, Flight) end, Empty) of
        {ok, #{frames := []}} -> {error, line("~ts: there is no frame in it", [File])};
        {ok, Flight} -> {ok, maps:map(fun ordered/2, Flight)};
        {truncated, Line, _} -> {error, Line};
        {error, Line} -> {error, Line}
    catch
        throw:{bad_message, Line} -> {error, Line}
    end.

ordered('case', Case) -> Case;
ordered(_, Newest) -> lists:reverse(Newest).

add(#{data := Data, t_us := T, number := Number}, File, Flight) ->
    case replay_lcm:decode(Data) of
        {ok, Type, #{t_us := Told} = Message} when Told >= 0, Told < ?LATEST ->
            put_message(Type, Message, T, Flight);
        {ok, _, #{t_us := Told}} ->
            throw({bad_message, line("~ts: event ~b: a time of ~b us", [File, Number, Told])});
        {ok, Type, Message} when T >= 0, T < ?LATEST ->
            put_message(Type, Message, T, Flight);
        {ok, _, _} ->
            throw({bad_message, line("~ts: event ~b: a time of ~b us", [File, Number, T])});
        {error, Line} -> throw({bad_message, line("~ts: event ~b: ~ts", [File, Number, Line])})
    end.

put_message(frame, Frame, _, Flight) ->
    prepend(frames, Frame, Flight);
put_message(risk, Risk, _, Flight) ->
    prepend(risks, Risk, Flight);
put_message(event, Event, _, Flight) ->
    prepend(events, Event, Flight);
put_message(case_info, Case, _, Flight) ->
    Flight#{'case' := Case};
%% It is told once a second, and of interest when it changes.
put_message(world, #{version := Version}, _, #{worlds := [{_, #{version := Version}} | _]} = F) ->
    F;
put_message(world, World, T, Flight) ->
    prepend(worlds, {T, World}, Flight);
put_message(_, _, _, Flight) ->
    Flight.

prepend(Key, Value, Flight) ->
    #{Key := Values} = Flight,
    Flight#{Key := [Value | Values]}.

%% @doc The latest message that is not after a time, the first one if all are.
-spec at(replay_source:t_us(), [replay_lcm:message(), ...]) -> replay_lcm:message().
at(T, [First | Rest]) ->
    lists:foldl(
        fun
            (#{t_us := Then} = Message, _) when Then =< T -> Message;
            (_, Latest) -> Latest
        end,
        First,
        Rest
    ).

%% @doc The world at a time; an empty one when nothing was told of it.
-spec world_at(replay_source:t_us(), flight()) -> replay_lcm:message().
world_at(T, #{worlds := Worlds}) ->
    case [World || {Then, World} <- Worlds, Then =< T] of
        [] -> #{seg => [], anchors => [], polys => []};
        Known -> lists:last(Known)
    end.

%% @doc How far the perceived position is from the true one, m.
-spec position_error(object()) -> float() | nan.
position_error(#{pos := Pos, pos_est := Est}) -> distance(Pos, Est).

%% @doc The same of the velocity, m/s.
-spec velocity_error(object()) -> float() | nan.
velocity_error(#{vel := Vel, vel_est := Est}) -> distance(Vel, Est).

%% @doc The object nearest to another one, and its true distance, m.
-spec nearest(object(), [object()]) -> {replay_source:id(), float() | nan} | none.
nearest(#{id := Id, pos := Pos}, Objects) ->
    case [{distance(Pos, There), Other} || #{id := Other, pos := There} <- Objects, Other =/= Id] of
        [] ->
            none;
        Distances ->
            %% atoms come behind numbers
            {Distance, Other} = lists:min(Distances),
            {Other, Distance}
    end.

distance(A, B) ->
    case lists:all(fun is_float/1, A ++ B) of
        true -> math:sqrt(lists:sum([(P - Q) * (P - Q) || {P, Q} <- lists:zip(A, B)]));
        false -> nan
    end.

line(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

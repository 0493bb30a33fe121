%% @doc What a person does to a flight, as commands of the model copter_eqc.
%%
%% Angles of messages are radians; commands have tenths of degrees, and what is steered goes
%% through the same limits as the model's.
-module(copter_hand).

-export([calls/3, why_wrong/3]).
-export_type([hands/0]).

%% What is asked of copters that are steered: tenths of degrees, and of degrees/s.
-type hands() :: #{replay_source:id() => {integer(), integer(), integer()}}.

-define(TENTHS_PER_RADIAN, 572.9577951308232).
-define(NS_PER_S, 1.0e9).
-define(MOST_COPTERS, 1000).
%% A channel's packets are all taken in one step: more copies, or longer ones, would stop the clock.
-define(MOST_COPIES, 10000).
-define(MOST_ADDED_BYTES, 65536).

%% @doc The commands, and who is steered then; Copters are all that there are. The error is a line.
-spec calls(replay_source:action(), [replay_source:id()], hands()) ->
    {ok, [copter_plan:call()], hands()} | {error, string()}.
calls({steer, Id, Roll, Pitch, Turn}, Copters, Hands) ->
    {Tilt, Rate} = copter_pilot:limits(),
    Wanted = {tenths(Roll, Tilt), tenths(Pitch, Tilt), tenths(Turn, Rate)},
    case {known(Id, Copters), Hands} of
        {{error, _} = Error, _} -> Error;
        {_, #{Id := Wanted}} -> {ok, [], Hands};
        _ -> {ok, [steer(Id, Wanted)], Hands#{Id => Wanted}}
    end;
calls({release, Id}, Copters, Hands) ->
    case is_map_key(Id, Hands) andalso lists:member(Id, Copters) of
        true -> {ok, [level(Id)], maps:remove(Id, Hands)};
        false -> {ok, [], maps:remove(Id, Hands)}
    end;
calls(stop_all, Copters, _) ->
    {ok, [level(Id) || Id <- Copters], #{}};
calls({set, -1, Name, Value}, _, Hands) ->
    with_name(Name, fun(Known) -> {ok, [{fly_set, [all, Known, Value]}], Hands} end);
calls({set, Id, Name, Value}, Copters, Hands) ->
    with_name(Name, fun(Known) -> set_one(Id, Known, Value, Copters, Hands) end);
calls({inject, Json}, Copters, Hands) ->
    injected(Json, Copters, Hands);
calls({clear_faults, -1, all}, _, Hands) ->
    {ok, [{fault_clear, []}], Hands};
calls({clear_faults, Id, all}, Copters, Hands) ->
    Places = copter_view_params:probes([Id], copter_sut:anchors()) ++
        copter_view_params:channels([Id]),
    case known(Id, Copters) of
        ok -> {ok, [clear(Place, Copters) || Place <- Places], Hands};
        {error, _} = Error -> Error
    end;
calls({clear_faults, _, #{<<"probe">> := Place}}, Copters, Hands) when is_binary(Place) ->
    case copter_view_params:kind(Place, Copters) of
        none -> {error, line("clear_faults: there is no probe or channel ~ts", [Place])};
        _ -> {ok, [clear(Place, Copters)], Hands}
    end;
calls({clear_faults, _, _}, _, _) ->
    {error, "clear_faults: \"probe\" is needed, a text"};
calls({add_object, _, _}, Copters, _) when length(Copters) >= ?MOST_COPTERS ->
    {error, lists:concat(["there are ", ?MOST_COPTERS, " copters, the most a frame may hold"])};
calls({add_object, X, Y}, Copters, Hands) ->
    {ok, [{fly_add, [lists:max([-1 | Copters]) + 1, float(X), float(Y), 0.0]}], Hands};
calls({remove_object, Id}, Copters, Hands) ->
    case known(Id, Copters) of
        ok -> {ok, [{fly_remove, [Id]}], maps:remove(Id, Hands)};
        {error, _} = Error -> Error
    end.

tenths(Radians, Most) -> max(-Most, min(Most, round(Radians * ?TENTHS_PER_RADIAN))).

steer(Id, {Roll, Pitch, Turn}) -> {steer, [Id, Roll, Pitch, Turn]}.

level(Id) -> steer(Id, {0, 0, 0}).

clear(Place, Copters) -> {fly_clear, [{copter_view_params:kind(Place, Copters), Place}]}.

known(Id, Copters) ->
    case lists:member(Id, Copters) of
        true -> ok;
        false -> {error, lists:concat(["there is no copter ", Id])}
    end.

%% Names that the simulator does not know make no atoms.
with_name(Name, Then) ->
    Known = [N || {N, _} <- copter_sut:parameters()],
    case lists:member(Name, Known) of
        true ->
            Then(binary_to_atom(Name, utf8));
        false ->
            Near = faultcheck_suggest:phrase(
                unicode:characters_to_list(Name), [binary_to_list(N) || N <- Known]
            ),
            {error, line("there is no parameter ~ts~ts", [Name, Near])}
    end.

set_one(Id, Name, Value, Copters, Hands) ->
    case {known(Id, Copters), lists:member(Name, copter_configuration:gain_names())} of
        {{error, _} = Error, _} -> Error;
        {ok, true} -> {ok, [{fly_set, [Id, Name, Value]}], Hands};
        {ok, false} -> {error, line("~ts is one for all: set it without an object", [Name])}
    end.

%% ---- inject -----------------------------------------------------------------------------------

injected(#{<<"probe">> := Probe, <<"model">> := Model} = Json, Copters, Hands) when
    is_binary(Probe), is_binary(Model)
->
    Known = [<<"probe">>, <<"model">>, <<"params">>, <<"from_s">>, <<"for_s">>, <<"from_calls">>,
             <<"for_calls">>],
    Params = maps:get(<<"params">>, Json, #{}),
    case {maps:keys(maps:without(Known, Json)), place(Probe, Copters), trigger(Json)} of
        {[Unknown | _], _, _} ->
            {error, line("inject: unknown member ~ts", [Unknown])};
        {[], {error, _} = Error, _} ->
            Error;
        {[], _, {error, _} = Error} ->
            Error;
        {[], Where, Trigger} when is_map(Params) ->
            Sorted = lists:sort(maps:to_list(Params)),
            case [Why || {Name, V} <- Sorted, Why <- why_wrong(Model, Name, V)] of
                [] -> {ok, [{fly_inject, [Where, Model, Sorted, Trigger, none]}], Hands};
                [Why | _] -> {error, "inject: " ++ Why}
            end;
        _ ->
            {error, "inject: params must be an object"}
    end;
injected(_, _, _) ->
    {error, "inject: \"probe\" and \"model\" are needed, both texts"}.

%% @doc What libfaultcheck does not refuse itself of a parameter of a model: nothing, or one line.
-spec why_wrong(Model :: binary(), Name :: binary(), faultcheck_json:decoded()) -> [string()].
why_wrong(_, Name, V) when not (is_number(V) orelse is_binary(V)) ->
    [line("~ts must be a number or a text", [Name])];
why_wrong(<<"repeat">>, Name, V) when V > ?MOST_COPIES -> too_many(Name, ?MOST_COPIES);
why_wrong(<<"extend">>, Name, V) when V > ?MOST_ADDED_BYTES -> too_many(Name, ?MOST_ADDED_BYTES);
why_wrong(_, _, _) -> [].

too_many(Name, Most) -> [line("~ts: ~b are the most", [Name, Most])].

place(Name, Copters) ->
    case copter_view_params:kind(Name, Copters) of
        none -> {error, line("inject: there is no probe or channel ~ts", [Name])};
        Kind -> {Kind, Name}
    end.

trigger(Json) ->
    Given = maps:with([<<"from_s">>, <<"for_s">>, <<"from_calls">>, <<"for_calls">>], Json),
    Calls = is_map_key(<<"from_calls">>, Given) orelse is_map_key(<<"for_calls">>, Given),
    Seconds = is_map_key(<<"from_s">>, Given) orelse is_map_key(<<"for_s">>, Given),
    Bad = [Key || {Key, V} <- maps:to_list(Given), not good(Key, V)],
    case {Bad, Calls, Seconds} of
        {[Key | _], _, _} -> {error, line("inject: ~ts must be a number from 0 up", [Key])};
        {[], true, true} -> {error, "inject: either seconds or calls"};
        {[], true, false} -> in_calls(Given);
        {[], false, true} -> in_seconds(Given);
        {[], false, false} -> []
    end.

good(<<_:5/binary, "calls">>, V) -> is_integer(V) andalso V >= 0 andalso V < 1 bsl 32;
good(<<_:4/binary, "calls">>, V) -> is_integer(V) andalso V >= 0 andalso V < 1 bsl 32;
good(_, V) -> is_number(V) andalso V >= 0 andalso V =< 1.0e6.

in_calls(Given) ->
    [{from, N} || {ok, N} <- [maps:find(<<"from_calls">>, Given)], N > 0] ++
        [{for, N} || {ok, N} <- [maps:find(<<"for_calls">>, Given)]].

in_seconds(Given) ->
    For =
        case maps:find(<<"for_s">>, Given) of
            {ok, S} -> round(S * ?NS_PER_S);
            error -> forever
        end,
    [{time, round(maps:get(<<"from_s">>, Given, 0) * ?NS_PER_S), For}].

line(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

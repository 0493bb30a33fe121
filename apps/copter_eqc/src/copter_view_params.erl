%% @doc What the page is told about a flight beside its commands: `params' of VIZ_CASE
%% (docs/visualizer.md); and the names of the simulator's probes and channels.
-module(copter_view_params).

-export([of_view/1, probes/2, channels/1, kind/2, is_position/1]).
-export_type([about/0]).

-type about() :: #{
    'case' := none | faultcheck_case:'case'(),
    live := boolean(),
    dt_us := pos_integer(),
    copters := [replay_source:id()],
    recorded := unknown | any_failure | replay_source:ending()
}.

%% Above so many copters the probes of anchors are not listed; they can be named all the same.
-define(MOST_LISTED, 40).

%% @doc The object.
-spec of_view(about()) -> faultcheck_json:json().
of_view(#{'case' := Case, live := Live, recorded := Recorded} = About) ->
    {object,
        [{summary, {text, summary(About)}}] ++
            [{shrink_steps, Tries} || Tries <- tries(Case)] ++
            [{recorded, {text, Text}} || Text <- recorded(Recorded)] ++
            lists:append([injectable(About) || Live])}.

tries(#{shrink := #{tries := Tries}}) -> [Tries];
tries(_) -> [].

summary(#{copters := Copters, dt_us := Dt}) ->
    Number =
        case length(Copters) of
            1 -> "1 copter";
            N -> lists:concat([N, " copters"])
        end,
    io_lib:format("~ts, ~ts ms step", [Number, milliseconds(Dt)]).

milliseconds(Us) when Us rem 1000 =:= 0 -> integer_to_list(Us div 1000);
milliseconds(Us) -> float_to_list(Us / 1000, [short]).

recorded(unknown) -> [];
recorded(any_failure) -> ["failed"];
recorded(passed) -> ["passed"];
recorded({failed, Text}) -> ["failed: " ++ Text].

%% What is asked for in a live flight only.
injectable(#{copters := Copters}) ->
    [
        {probes, probes(Copters, anchors(Copters))},
        {channels, channels(Copters)},
        {settings, {object, copter_sut:parameters()}}
    ].

anchors(Copters) when length(Copters) > ?MOST_LISTED -> [];
anchors(_) -> copter_sut:anchors().

%% @doc The probes of copters, those to anchors among them.
-spec probes([replay_source:id()], Anchors :: [non_neg_integer()]) -> [binary()].
probes(Copters, Anchors) ->
    [
        name([Kind, "Id", Id])
     || Id <- Copters, Kind <- ["Px", "Py", "Roll", "Pitch", "Yaw", "Clock"]
    ] ++
        [
            name([Kind, "Id", Id, "Anch", Anchor])
         || Id <- Copters, Kind <- ["Range", "AnchX", "AnchY", "AnchZ"], Anchor <- Anchors
        ].

%% @doc The channels that copters receive by.
-spec channels([replay_source:id()]) -> [binary()].
channels(Copters) -> [name(["ITS_DATA", Id]) || Id <- Copters].

name(Parts) -> unicode:characters_to_binary(lists:concat(Parts)).

%% @doc What a name is, if there is such a thing for these copters.
-spec kind(binary(), [replay_source:id()]) -> probe | channel | none.
kind(Name, Copters) ->
    Pattern = "^(?:(Px|Py|Roll|Pitch|Yaw|Clock)Id([0-9]+)|"
        "(?:Range|AnchX|AnchY|AnchZ)Id([0-9]+)Anch([0-9]+)|ITS_DATA([0-9]+))$",
    case re:run(Name, Pattern, [{capture, all_but_first, binary}]) of
        {match, [_, Id]} -> probe_of(Id, Copters);
        {match, [_, _, Id, Anchor]} ->
            case lists:member(binary_to_integer(Anchor), copter_sut:anchors()) of
                true -> probe_of(Id, Copters);
                false -> none
            end;
        {match, [_, _, _, _, Id]} ->
            case probe_of(Id, Copters) of
                probe -> channel;
                none -> none
            end;
        nomatch -> none
    end.

probe_of(Id, Copters) ->
    case lists:member(binary_to_integer(Id), Copters) of
        true -> probe;
        false -> none
    end.

%% @doc Whether it is the probe of a copter's own position, which is called once a step.
-spec is_position(binary()) -> boolean().
is_position(Name) -> re:run(Name, "^P[xy]Id[0-9]+$") =/= nomatch.

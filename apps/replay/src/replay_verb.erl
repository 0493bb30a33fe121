%% @doc What may be asked of the player (VIZ_CONTROL): checked and clamped, so that nothing else
%% comes further. A refusal is one line that begins with the verb.
-module(replay_verb).

-export([parse/1, token_fits/2, is_file_name/1]).
-export_type([verb/0]).

-type verb() ::
    play
    | pause
    | restart
    | fork
    | {speed, float()}
    %% frames
    | {step, integer()}
    | {seek, replay_source:t_us()}
    | {loop, replay_clock:span()}
    | {observe, replay_source:id()}
    | {load, Id :: string(), shrunk | original}
    | {scenario, Name :: string()}
    %% of a live flight
    | {live, replay_source:action()}.

-define(MOST_FRAMES, 100000).
-define(MOST_SECONDS, 1.0e6).
-define(METRES, 1.0e5).
-define(TILT, 1.5707963267948966).
-define(TURN, 10.0).
-define(MOST_VALUE, 1.0e9).
-define(CASE_ID, "^[A-Za-z0-9_-]{1,64}$").
-define(FILE_NAME, "^[A-Za-z0-9_-][A-Za-z0-9_.-]{0,63}$").
-define(NAME, "^[A-Za-z0-9_.-]{1,64}$").
-define(MOST_TEXT, 4096).

%% @doc The verb of a message.
-spec parse(replay_lcm:message()) -> {ok, verb()} | {error, string()}.
parse(#{verb := Verb, text := Text}) when byte_size(Text) > ?MOST_TEXT ->
    refused(Verb, "a text of ~b bytes; ~b are the most", [byte_size(Text), ?MOST_TEXT]);
parse(#{verb := Verb, args := Args} = Message) ->
    case [A || A <- Args, not is_number(A)] of
        [] -> checked(Verb, Message);
        [A | _] -> refused(Verb, "~p is no finite number", [A])
    end.

checked(Verb, #{object := Object, args := Args, text := Text}) ->
    case verb(Verb, Args, Object, Text) of
        {ok, _} = Ok -> Ok;
        {error, Line} -> refused(Verb, "~ts", [Line]);
        unknown -> unknown(Verb, length(Args))
    end.

verb(<<"play">>, [], _, _) -> {ok, play};
verb(<<"pause">>, [], _, _) -> {ok, pause};
verb(<<"restart">>, [], _, _) -> {ok, restart};
verb(<<"fork">>, [], _, _) -> {ok, fork};
verb(<<"speed">>, [Factor], _, _) -> {ok, {speed, float(Factor)}};
verb(<<"step">>, [N], _, _) -> {ok, {step, trunc(clamp(N, ?MOST_FRAMES))}};
verb(<<"seek">>, [S], _, _) -> {ok, {seek, us(S)}};
verb(<<"loop">>, [From, To], _, _) -> {ok, {loop, {us(From), us(To)}}};
verb(<<"loop">>, [], _, _) -> {ok, {loop, none}};
verb(<<"observe">>, [], Object, _) -> {ok, {observe, max(-1, Object)}};
verb(<<"load">>, [], Object, Text) -> verb(<<"load">>, [0.0], Object, Text);
verb(<<"load">>, [Original], _, Text) ->
    text(Text, ?CASE_ID, "a case id: 1 to 64 letters, digits, - and _",
         fun(Id) -> {load, Id, which(Original)} end);
verb(<<"scenario">>, [], _, Text) ->
    text(Text, ?FILE_NAME, "a file name without a folder", fun(Name) -> {scenario, Name} end);
verb(<<"steer">>, [Roll, Pitch, Turn], Object, _) ->
    object(Object, {steer, Object, clamp(Roll, ?TILT), clamp(Pitch, ?TILT), clamp(Turn, ?TURN)});
verb(<<"set">>, [Value], Object, Text) ->
    text(Text, ?NAME, "a name: 1 to 64 letters, digits, . - and _",
         fun(_) -> {live, {set, max(-1, Object), Text, clamp(Value, ?MOST_VALUE)}} end);
verb(<<"inject">>, [], _, Text) -> json(Text, fun(Json) -> {inject, Json} end);
verb(<<"clear_faults">>, [], Object, <<>>) -> {ok, {live, {clear_faults, max(-1, Object), all}}};
verb(<<"clear_faults">>, [], Object, Text) ->
    json(Text, fun(Json) -> {clear_faults, max(-1, Object), Json} end);
verb(<<"add_object">>, [X, Y], _, _) ->
    {ok, {live, {add_object, clamp(X, ?METRES), clamp(Y, ?METRES)}}};
verb(<<"remove_object">>, [], Object, _) -> object(Object, {remove_object, Object});
verb(<<"stop_all">>, [], _, _) -> {ok, {live, stop_all}};
verb(_, _, _, _) -> unknown.

which(Original) when Original >= 0.5 -> original;
which(_) -> shrunk.

us(Seconds) -> trunc(max(0.0, min(?MOST_SECONDS, float(Seconds))) * 1000000).

clamp(Value, Most) -> max(-Most, min(Most, float(Value))).

object(Object, Action) when Object >= 0 -> {ok, {live, Action}};
object(_, _) -> {error, "which object?"}.

text(Text, Pattern, Wanted, Fun) ->
    case re:run(Text, Pattern, [dollar_endonly]) of
        {match, _} -> {ok, Fun(binary_to_list(Text))};
        nomatch -> {error, "expected " ++ Wanted}
    end.

json(Text, Fun) ->
    case faultcheck_json:decode(Text) of
        {ok, Json} when is_map(Json) -> {ok, {live, Fun(Json)}};
        {ok, _} -> {error, "expected a JSON object"};
        {error, {offset, Offset}} -> {error, lists:concat(["not JSON at byte ", Offset])}
    end.

unknown(Verb, Arguments) ->
    Known = [
        {"play", 0}, {"pause", 0}, {"restart", 0}, {"fork", 0}, {"speed", 1}, {"step", 1},
        {"seek", 1}, {"loop", 2}, {"observe", 0}, {"load", 1}, {"scenario", 0}, {"steer", 3},
        {"set", 1}, {"inject", 0}, {"clear_faults", 0}, {"add_object", 2}, {"remove_object", 0},
        {"stop_all", 0}
    ],
    Name = printable(Verb),
    case lists:keyfind(Name, 1, Known) of
        {_, Wanted} ->
            refused(Verb, "~b numbers are expected, not ~b", [Wanted, Arguments]);
        false ->
            Near = faultcheck_suggest:phrase(Name, [N || {N, _} <- Known]),
            refused(Verb, "there is no such verb~ts", [Near])
    end.

%% Comes from outside and goes to a terminal.
printable(Text) ->
    [C || <<C>> <= binary:part(Text, 0, min(32, byte_size(Text))), C > 32, C < 127].

refused(Verb, Format, Args) ->
    {error, lists:flatten([printable(Verb), ": ", io_lib:format(Format, Args)])}.

%% @doc Whether a file can be named.
-spec is_file_name(string()) -> boolean().
is_file_name(Name) -> re:run(Name, ?FILE_NAME, [dollar_endonly]) =/= nomatch.

%% @doc Compares without telling by its time where the first difference is.
-spec token_fits(binary(), binary()) -> boolean().
token_fits(Given, Token) when byte_size(Given) =:= byte_size(Token) ->
    Pairs = lists:zip(binary_to_list(Given), binary_to_list(Token)),
    lists:foldl(fun({A, B}, Sum) -> Sum bor (A bxor B) end, 0, Pairs) =:= 0;
token_fits(_, _) ->
    false.

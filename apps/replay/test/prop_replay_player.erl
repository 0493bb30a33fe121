%% @doc The player as a state machine whose requests come over a network that loses, repeats and
%% reorders them; and its clock against one that counts.
-module(prop_replay_player).
-include_lib("proper/include/proper.hrl").

-export([prop_clock_counts/0, prop_clock_counts/1]).
-export([prop_player_does_what_arrives/0, prop_player_does_what_arrives/1]).

-define(LIMIT, 20000000).
-define(STEP, 5000).
-define(TOKEN, <<"token">>).

%% ---- the clock --------------------------------------------------------------------------------

%% The model adds up what each moment brings. The clock cuts to whole us whenever it is touched.
prop_clock_counts() ->
    ?FORALL(Script, list({delay(), clock_call()}), begin
        Start = {0.0, 0, replay_clock:new(?LIMIT), model()},
        {Difference, _, _, _} = lists:foldl(fun count/2, Start, Script),
        ?WHENFAIL(io:format("off by ~p us~n", [Difference]), Difference =< length(Script) + 1)
    end).

prop_clock_counts(doc) -> "Simulated time is what play, pause, speed and seek make of wall time";
prop_clock_counts(opts) -> [{numtests, 300}].

model() -> #{playing => false, speed => 1.0, pos => 0.0, slack => 0}.

count({Delay, Call}, {Worst, Before, Clock0, Model0}) ->
    Now = Before + Delay,
    Model1 = passed(Delay, Model0),
    Off = abs(replay_clock:position(Now, Clock0) - maps:get(pos, Model1)),
    {max(Worst, Off), Now, clock(Call, Now, Clock0), modelled(Call, Model1)}.

clock(play, Now, Clock) -> replay_clock:play(Now, Clock);
clock(pause, Now, Clock) -> replay_clock:pause(Now, Clock);
clock({speed, X}, Now, Clock) -> replay_clock:speed(Now, X, Clock);
clock({seek, T}, Now, Clock) -> replay_clock:seek(Now, T, Clock).

passed(Delay, #{playing := true, speed := Speed, pos := Pos} = Model) ->
    Model#{pos := min(float(?LIMIT), Pos + Delay * Speed)};
passed(_, Model) ->
    Model.

modelled(play, Model) -> Model#{playing := true};
modelled(pause, Model) -> Model#{playing := false};
modelled({speed, X}, Model) -> Model#{speed := max(0.05, min(20.0, X))};
modelled({seek, T}, Model) -> Model#{pos := float(max(0, min(T, ?LIMIT))), slack := 0}.

delay() -> integer(0, 3000000).

clock_call() ->
    oneof([play, pause, {speed, float(0.01, 30.0)}, {seek, integer(-1000000, ?LIMIT + 1000000)}]).

%% ---- the player -------------------------------------------------------------------------------

%% What arrives counts when it is newer than everything before of that client.
prop_player_does_what_arrives() ->
    ?FORALL(Script, list({delay(), verb(), fate()}), begin
        Numbered = [{N, S} || {N, S} <- lists:zip(lists:seq(1, length(Script)), Script)],
        {Good, _} = lists:foldl(fun arrive/2, {true, start()}, travelled(Numbered)),
        aggregate([Fate || {_, _, Fate} <- Script], Good)
    end).

prop_player_does_what_arrives(doc) ->
    "Requests that are lost, repeated or reordered leave the player where the others put it";
prop_player_does_what_arrives(opts) ->
    [{numtests, 200}].

verb() ->
    oneof([
        {<<"play">>, []}, {<<"pause">>, []}, {<<"speed">>, [float(0.01, 30.0)]},
        {<<"seek">>, [float(0.0, 25.0)]}, {<<"step">>, [integer(-50, 50)]}
    ]).

fate() -> frequency([{6, good}, {1, lost}, {1, twice}, {1, overtaken}]).

%% The requests in the order of arrival, each with its delay; one that is overtaken comes after its
%% successor, at the same moment.
travelled([{_, {D, _, lost}} | Rest]) -> [{D, none} | travelled(Rest)];
travelled([{N, {D, Verb, twice}} | Rest]) -> [{D, {N, Verb}}, {0, {N, Verb}} | travelled(Rest)];
travelled([{N, {D, Verb, overtaken}}, {M, {D2, Verb2, _}} | Rest]) ->
    [{D + D2, {M, Verb2}}, {0, {N, Verb}} | travelled(Rest)];
travelled([{N, {D, Verb, _}} | Rest]) -> [{D, {N, Verb}} | travelled(Rest)];
travelled([]) -> [].

start() ->
    {ok, _, Player} = replay_player:open(#{
        opening => {view, {moving, ?LIMIT, passed, passed}}, number => 1,
        view => replay_test_source, token => ?TOKEN, cases => "", scenarios => "",
        playing => false, speed => 1.0
    }, 0),
    #{player => Player, now => 0, newest => 0, model => model()}.

arrive({Delay, Request}, {Good, #{now := Before, player := P0, model := Model0} = S}) ->
    Now = Before + Delay,
    P1 = until(Now, P0),
    Model1 = ended(passed(Delay, Model0)),
    {Status, P2} = asked(Request, Now, P1),
    Next = requested(Request, S#{model := Model1}),
    #{model := #{playing := Playing, speed := Speed, pos := Pos, slack := Slack}} = Next,
    #{paused := Paused, t_us := T, speed := Told} = Status,
    Same = Paused =:= (if Playing -> 0; true -> 1 end) andalso abs(Told - Speed) < 1.0e-9 andalso
        abs(T - Pos) =< ?STEP + 100 + Slack,
    Same orelse io:format("~p: status ~p~nmodel ~p~n", [Request, Status, Next]),
    {Good andalso Same, Next#{player := P2, now := Now}}.

%% At the end it stops.
ended(#{pos := Pos} = Model) when Pos >= ?LIMIT -> Model#{playing := false};
ended(Model) -> Model.

requested({N, {Verb, Args}}, #{newest := Newest, model := Model} = S) when N > Newest ->
    S#{newest := N, model := ended(does(Verb, Args, Model))};
requested(_, S) ->
    S.

does(<<"play">>, [], #{pos := Pos} = Model) when Pos >= ?LIMIT ->
    Model#{playing := true, pos := 0.0};
does(<<"play">>, [], Model) -> modelled(play, Model);
does(<<"pause">>, [], Model) -> modelled(pause, Model);
does(<<"speed">>, [X], Model) -> modelled({speed, X}, Model);
does(<<"seek">>, [X], Model) -> modelled({seek, trunc(X * 1000000)}, Model);
%% From the whole step that it shows: 1 us may decide which.
does(<<"step">>, [N], #{pos := Pos, slack := Slack} = Model) ->
    Stepped = modelled({seek, trunc(Pos) div ?STEP * ?STEP + N * 16667}, Model#{playing := false}),
    Stepped#{slack := Slack + ?STEP}.

until(Now, Player) ->
    case replay_player:next_wake(Player) of
        Next when Next > Now -> Player;
        Next ->
            {_, After} = replay_player:wake(Next, Player),
            until(Now, After)
    end.

%% The status after a request and a moment to act upon it.
asked(none, Now, Player) ->
    status(Now, Player);
asked({N, {Verb, Args}}, Now, P0) ->
    {_, P1} = replay_player:control(
        #{client => <<"c">>, token => ?TOKEN, seq => N, verb => Verb, object => -1, args => Args,
          text => <<>>},
        sender, Now, P0
    ),
    status(Now, P1).

status(Now, P0) ->
    {Out, P1} = replay_player:wake(Now, replay_player:refresh(settled(Now, P0))),
    {lists:last([S || {publish, {status, S}} <- Out]), P1}.

%% As long as it is on its way to somewhere, it wants to be woken at once.
settled(Now, P0) ->
    {_, P1} = replay_player:wake(Now, P0),
    case replay_player:next_wake(P1) > Now of
        true -> P1;
        false -> settled(Now, P1)
    end.

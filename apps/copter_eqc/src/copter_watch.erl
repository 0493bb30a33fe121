%% @doc Shows tests of copters in the visualizer while they run (`rebar3 proper --watch').
%%
%% A test is flown twice: first to be seen, ten times as fast as time passes, or so fast that it
%% takes three seconds; then by the property, as ever. So nothing of its outcome depends on being
%% watched. Of the candidates of shrinking, which are many, one is shown a second.
-module(copter_watch).

-export([test/2]).

-define(SPEED, 10).
-define(LONGEST_S, 3).
-define(EVERY_MS, 1000).

%% @doc Shows the commands of a test if that is asked for, else nothing.
-spec test(copter_options:options(), [faultcheck_generator:command()]) -> ok.
test(Options, Commands) ->
    case application:get_env(faultcheck, watch, false) of
        false -> ok;
        true -> watched(faultcheck_instrument:running(), Options, Commands)
    end.

watched(#{attempt := Attempt} = Running, Options, Commands) ->
    Now = erlang:monotonic_time(millisecond),
    case {Attempt, get(?MODULE)} of
        {_, cannot} -> ok;
        {1, Before} -> shown(Running, Options, Commands, Before);
        {_, {_, Last}} when Now - Last < ?EVERY_MS -> ok;
        {_, Before} -> shown(Running, Options, Commands, Before)
    end;
watched(none, _, _) ->
    ok.

shown(Running, Options, Commands, undefined) ->
    case opened(url()) of
        {ok, Broadcast} ->
            shown(Running, Options, Commands, {Broadcast, 0});
        {error, Line} ->
            io:format("watch: ~ts~n", [Line]),
            _ = put(?MODULE, cannot),
            ok
    end;
shown(Running, Options, Commands, {Broadcast, _}) ->
    #{dt_us := Dt} = Settings = copter_sut:settings(Options),
    #{end_us := End} = Plan = copter_plan:from_commands(Commands, Dt),
    Test = {test, title(Running), origin(Running, Commands), Settings, Plan},
    Speed = max(?SPEED, End / 1.0e6 / ?LONGEST_S),
    {ok, Next} = replay_broadcast:show({copter_view, Test}, Speed, Broadcast),
    _ = put(?MODULE, {Next, erlang:monotonic_time(millisecond)}),
    ok.

%% Unless somebody else is shown there.
opened(Url) ->
    case replay_neighbour:find(Url, #{}) of
        none -> replay_broadcast:open(Url);
        {found, Line} -> {error, Line ++ " (LCM_DEFAULT_URL); the tests are not shown"}
    end.

title(#{test := Test, attempt := 1}) -> lists:concat(["test ", Test]);
title(#{test := Test, attempt := N}) -> lists:concat(["test ", Test, ", candidate ", N]).

origin(#{property := {Module, Name}, seed := Seed, test := Test}, Commands) ->
    #{
        property => lists:concat([Module, ":", Name]), seed => Seed, test => Test,
        commands => length(Commands)
    }.

%% As the programs of LCM choose it.
url() ->
    case os:getenv("LCM_DEFAULT_URL") of
        Unset when Unset =:= false; Unset =:= "" -> replay_lcm_url:default();
        Url -> Url
    end.

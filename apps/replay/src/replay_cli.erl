%% @doc The program `bin/faultcheck play'.
-module(replay_cli).

-export([main/0, run/1, parse/1]).
-export_type([options/0]).

-type options() :: #{atom() => term()}.

-define(USAGE_ERROR, 2).
-define(CANNOT, 3).
-define(INTERRUPTED, 130).

%% @doc Runs the words of the command line and ends the VM with the exit status.
-spec main() -> no_return().
main() ->
    _ = io:setopts([{encoding, unicode}]),
    erlang:halt(run(init:get_plain_arguments())).

-spec run([string()]) -> 0..255.
run(Words) ->
    case parse(Words) of
        help ->
            io:put_chars(usage()),
            0;
        {ok, Options} ->
            case located(Options) of
                {ok, Located} -> alone(Located);
                {error, Line} -> failed(Line, ?USAGE_ERROR)
            end;
        {error, Line} ->
            failed(Line, ?USAGE_ERROR)
    end.

failed(Line, Status) ->
    io:format(standard_error, "play: ~ts~n", [Line]),
    Status.

usage() ->
    "Usage: faultcheck play [CASE] [options]\n\n"
    "Plays a stored case, or a live simulation, as LCM messages: for the visualizer's bridge, and\n"
    "for standard LCM tools. CASE is a folder below cases/, or its name alone; without it an\n"
    "example is played.\n\n"
    "  --original             the failure as it was found, before it was shrunk\n"
    "  --live                 a live flight in an empty world, to be steered from a page\n"
    "  --scenario FILE        the same in the world of a scenario file\n"
    "  --group URL            where to: udpm://239.255.76.67:7667?ttl=0; --lcm-url is the same\n"
    "  --udp ADDR:PORT        one receiver on this host instead: 127.0.0.1:7667\n"
    "  --cases DIR            stored cases, to be loaded from a page (cases)\n"
    "  --scenarios DIR        scenario files, to be flown from a page (examples/copter)\n"
    "  --speed X              0.05 to 20 (1)\n"
    "  --paused               do not begin by itself\n"
    "  --allow-control        pages may control it, with a token of the file given by\n"
    "  --token-file FILE      shared with the bridge; whoever comes first makes it\n"
    "  --allow-network        take a URL with ttl > 0\n\n"
    "Ctrl-C ends it; a live flight is stored below cases/ then.\n"
    "Exit status: 2 wrong usage or input, or another player on the group, 3 an address or a file\n"
    "cannot be used, 130 interrupted.\n".

%% ---- options ----------------------------------------------------------------------------------

%% @doc Reads the command line. The error is one line.
-spec parse([string()]) -> {ok, options()} | help | {error, string()}.
parse(Words) -> parse(Words, #{}).

parse([], Options) -> complete(Options);
parse([Help | _], _) when Help =:= "--help"; Help =:= "-h" -> help;
parse(["--" ++ _ = Word | Rest], Options) ->
    {Name, Given} =
        case string:split(Word, "=") of
            [N, V] -> {N, [V]};
            [N] -> {N, []}
        end,
    option(Name, lists:keyfind(Name, 1, table()), Given ++ Rest, Given =/= [], Options);
parse(["-" ++ _ = Word | _], _) ->
    unknown(Word);
parse([Case | Rest], Options) when not is_map_key('case', Options) ->
    parse(Rest, Options#{'case' => Case});
parse([Word | _], _) ->
    {error, "unexpected argument " ++ Word ++ "; one case is played at a time"}.

table() ->
    [
        {"--original", original, flag}, {"--live", live, flag}, {"--scenario", scenario, text},
        {"--group", url, text}, {"--lcm-url", url, text}, {"--udp", udp, text},
        {"--cases", cases, text}, {"--scenarios", scenarios, text}, {"--speed", speed, speed},
        {"--paused", paused, flag}, {"--allow-control", control, flag},
        {"--token-file", token_file, text}, {"--allow-network", network, flag}
    ].

option(Name, false, _, _, _) -> unknown(Name);
option(Name, {_, _, flag}, _, true, _) -> {error, Name ++ " takes no value"};
option(_, {_, Key, flag}, Rest, false, Options) -> parse(Rest, Options#{Key => true});
option(Name, {_, _, _}, [], _, _) -> {error, Name ++ " needs a value"};
option(_, {_, Key, text}, [Value | Rest], _, Options) -> parse(Rest, Options#{Key => Value});
option(Name, {_, Key, speed}, [Text | Rest], _, Options) ->
    case speed(Text) of
        {ok, Speed} -> parse(Rest, Options#{Key => Speed});
        error -> {error, Name ++ ": expected a number from 0.05 to 20, not " ++ Text}
    end.

speed(Text) ->
    Number =
        case {string:to_float(Text), string:to_integer(Text)} of
            {{F, ""}, _} -> F;
            {_, {N, ""}} when is_integer(N) -> float(N);
            _ -> 0.0
        end,
    case Number >= 0.05 andalso Number =< 20.0 of
        true -> {ok, Number};
        false -> error
    end.

unknown(Name) ->
    Known = [N || {N, _, _} <- table()],
    {error, "unknown option " ++ Name ++ faultcheck_suggest:phrase(Name, Known)}.

complete(Options) ->
    Sources = [K || K <- ['case', live, scenario], is_map_key(K, Options)],
    Control = [is_map_key(K, Options) || K <- [control, token_file]],
    case {Sources, Control, is_map_key(udp, Options) andalso is_map_key(url, Options)} of
        {[_, _ | _], _, _} -> {error, "a case, --live or --scenario: expected one of them"};
        {_, [A, B], _} when A =/= B ->
            {error, "--allow-control and --token-file: expected both or none"};
        {_, _, true} -> {error, "--group and --udp: expected one of them"};
        _ -> {ok, Options}
    end.

%% ---- playing ----------------------------------------------------------------------------------

%% The options with the path of the case, which can be read.
located(#{'case' := Given} = Options) ->
    case replay_kept:find(Given, cases(Options)) of
        {ok, Path} -> {ok, Options#{'case' := Path}};
        {error, _} = Error -> Error
    end;
located(Options) ->
    {ok, Options}.

cases(Options) -> maps:get(cases, Options, faultcheck_case:directory()).

%% Two on one group would be shown mixed.
alone(Options) ->
    case replay_neighbour:find(url(Options), udp(Options)) of
        none -> played(Options);
        {found, Line} -> not_alone(Line)
    end.

not_alone(Line) ->
    failed(Line ++ ": --group udpm://239.255.76.67:PORT, or make visualizer PORT=N", ?USAGE_ERROR).

udp(Options) -> #{allow_network => maps:get(network, Options, false)}.

played(Options) ->
    case token(Options) of
        {error, Line} -> failed(Line, ?CANNOT);
        {ok, Token} -> started(Options, replay_player_server:start(server(Options, Token)))
    end.

token(#{token_file := File}) -> replay_token:shared(File);
token(_) -> {ok, none}.

server(Options, Token) ->
    #{
        player => #{
            opening => opening(Options),
            number => replay_player:first_number(),
            view => view(),
            token => Token,
            cases => cases(Options),
            scenarios => maps:get(scenarios, Options, "examples/copter"),
            playing => not maps:get(paused, Options, false),
            speed => maps:get(speed, Options, 1.0)
        },
        url => url(Options),
        udp => udp(Options),
        say => fun(Line) -> io:format("play: ~ts~n", [Line]) end
    }.

%% What plays where there is no case: the program that starts the VM names it.
view() ->
    _ = application:load(replay),
    case application:get_env(replay, view) of
        {ok, View} -> View;
        undefined -> none
    end.

opening(#{'case' := Dir} = Options) ->
    {'case', Dir, case Options of #{original := true} -> original; _ -> shrunk end};
opening(#{live := true}) -> {view, live};
opening(#{scenario := File}) -> {view, {scenario, File}};
opening(_) -> {view, example}.

url(#{udp := Address}) -> Address;
url(#{url := Url}) -> Url;
url(_) -> replay_lcm_url:default().

started(_, {error, {another, Line}}) ->
    not_alone(Line);
started(_, {error, Line}) ->
    failed(Line, ?CANNOT);
started(Options, {ok, Pid}) ->
    Control =
        case Options of
            #{control := true} -> "on";
            _ -> "off"
        end,
    io:format("play: sends to ~ts; control is ~ts~n", [url(Options), Control]),
    ok = faultcheck_interrupt:install(self()),
    Monitor = monitor(process, Pid),
    receive
        faultcheck_interrupt ->
            ok = replay_player_server:stop(Pid),
            ?INTERRUPTED;
        {'DOWN', Monitor, process, Pid, {shutdown, {another, Line}}} ->
            not_alone(Line);
        {'DOWN', Monitor, process, Pid, Reason} ->
            failed(io_lib:format("ended: ~0tp", [Reason]), ?CANNOT)
    end.

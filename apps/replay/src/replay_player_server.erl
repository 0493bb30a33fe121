%% @doc The player as a process: UDP, timers, files. What it does about them decides replay_player.
-module(replay_player_server).
-behaviour(gen_server).

-export([start/1, stop/1]).
-export([init/1, handle_call/3, handle_cast/2, handle_info/2, terminate/2]).
-export_type([options/0]).

-type options() :: #{
    player := replay_player:options(),
    url := string(),
    udp := replay_lcm_udp:options(),
    %% what people should know, a line each
    say := fun((string()) -> term()),
    %% for so long after the beginning it may give way to another player: 1 s
    unsure_us => non_neg_integer()
}.

-record(state, {
    player :: replay_player:player(),
    lcm :: replay_lcm_udp:lcm(),
    url :: string(),
    %% until then another player may be heard that was started together with this one
    unsure_until :: integer(),
    cases :: file:filename(),
    view :: module() | none,
    say :: fun((string()) -> term()),
    timer :: reference(),
    %% the latest failure to send, which is told once
    failure = "" :: string(),
    %% of the live flight, in case the player is killed: who writes it; what was written, and when
    writer = none :: none | pid(),
    written = none :: none | {module(), replay_source:state()},
    written_us :: integer()
}).

-define(US_PER_MS, 1000).
-define(WRITE_US, 2000000).
-define(UNSURE_US, 1000000).

%% @doc Opens the source and the sockets, and plays. The error is one line; another player on the
%% group is one of its own. It ends with the reason `{shutdown, {another, Line}}' when it hears such
%% a one only after it has begun, and is the one to give way (replay_neighbour).
-spec start(options()) -> {ok, pid()} | {error, string() | {another, string()}}.
start(Options) ->
    case gen_server:start(?MODULE, Options, []) of
        {ok, Pid} -> {ok, Pid};
        {error, {shutdown, Why}} -> {error, Why}
    end.

%% @doc Ends it; a live flight is stored first.
-spec stop(pid()) -> ok.
stop(Pid) -> gen_server:stop(Pid).

-spec init(options()) -> {ok, #state{}} | {stop, {shutdown, string() | {another, string()}}}.
init(#{url := Url, udp := Udp} = Options) ->
    _ = process_flag(trap_exit, true),
    case replay_lcm_udp:open(Url, Udp) of
        {error, Line} -> {stop, {shutdown, Line}};
        {ok, Lcm} -> opened(Lcm, Options)
    end.

%% To open a long case takes a while, in which another player may have begun.
opened(Lcm, #{player := Given, url := Url} = Options) ->
    case replay_player:open(Given, now_us()) of
        {error, Line} ->
            refused(Line, Lcm);
        {ok, Out, Player} ->
            case replay_neighbour:is_heard(Lcm) of
                {true, Heard} -> refused({another, replay_neighbour:line(Url)}, Heard);
                {false, Heard} -> {ok, begun(Out, Player, Heard, Options)}
            end
    end.

refused(Why, Lcm) ->
    ok = replay_lcm_udp:close(Lcm),
    {stop, {shutdown, Why}}.

begun(Out, Player, Lcm, #{player := Given, url := Url, say := Say} = Options) ->
    #{cases := Cases, view := View} = Given,
    Now = now_us(),
    State = #state{
        player = Player, lcm = Lcm, url = Url, cases = Cases, view = View, say = Say,
        timer = make_ref(),
        unsure_until = Now + maps:get(unsure_us, Options, ?UNSURE_US), written_us = Now
    },
    scheduled(perform(Out, recovered(State))).

now_us() -> erlang:monotonic_time(microsecond).

-spec handle_call(term(), {pid(), term()}, #state{}) -> {noreply, #state{}}.
handle_call(_, _, State) -> {noreply, State}.

-spec handle_cast(term(), #state{}) -> {noreply, #state{}}.
handle_cast(_, State) -> {noreply, State}.

-spec handle_info(term(), #state{}) ->
    {noreply, #state{}} | {stop, {shutdown, {another, string()}}, #state{}}.
handle_info({timeout, Timer, wake}, #state{timer = Timer, player = Player} = State) ->
    {Out, Next} = replay_player:wake(now_us(), Player),
    {noreply, scheduled(kept_safe(perform(Out, State#state{player = Next})))};
handle_info({timeout, _, wake}, State) ->
    {noreply, State};
handle_info({'EXIT', Writer, Reason}, #state{writer = Writer, say = Say} = State) ->
    _ = [Say(line("the flight cannot be kept safe: ~0tp", [Reason])) || Reason =/= normal],
    {noreply, State#state{writer = none}};
handle_info({'EXIT', _, Reason}, #state{say = Say} = State) ->
    _ = [Say(line("recording failed: ~0tp", [Reason])) || Reason =/= normal],
    {noreply, State};
handle_info(Info, #state{lcm = Lcm} = State) ->
    case replay_lcm_udp:incoming(Info, Lcm) of
        {message, <<"VIZ_CONTROL">>, Payload, From, Next} ->
            {noreply, control(Payload, From, State#state{lcm = Next})};
        {message, <<"VIZ_STATUS">>, _, From, Next} ->
            beside(From, State#state{lcm = Next});
        {message, _, _, _, Next} ->
            {noreply, State#state{lcm = Next}};
        {bad, _, _, Next} ->
            {noreply, State#state{lcm = Next}};
        {none, Next} ->
            {noreply, State#state{lcm = Next}};
        unknown ->
            {noreply, State}
    end.

%% Whose status it is: its own comes back too.
beside(From, #state{lcm = Lcm, url = Url, unsure_until = Until} = State) ->
    case now_us() < Until andalso replay_neighbour:gives_way(From, Lcm, Url) of
        {true, Line} -> {stop, {shutdown, {another, Line}}, State};
        false -> {noreply, State}
    end.

control(Payload, {Ip, _} = From, #state{player = Player, say = Say} = State) ->
    case replay_lcm:decode(control, Payload) of
        {ok, Message} when element(1, Ip) =:= 127 ->
            {Out, Next} = replay_player:control(Message, From, now_us(), Player),
            scheduled(perform(Out, State#state{player = Next}));
        {ok, _} ->
            _ = Say("refused a control message that came from another host"),
            State;
        {error, Line} ->
            _ = Say("refused a control message: " ++ Line),
            State
    end.

%% One timer at a time; its moments are absolute.
scheduled(#state{timer = Before, player = Player} = State) ->
    _ = erlang:cancel_timer(Before),
    Ms = -(-replay_player:next_wake(Player) div ?US_PER_MS),
    State#state{timer = erlang:start_timer(Ms, self(), wake, [{abs, true}])}.

-spec terminate(term(), #state{}) -> ok.
terminate(_, #state{player = Player, lcm = Lcm} = State) ->
    Out = replay_player:close(Player),
    _ = lists:foldl(fun(O, S) -> perform_one(O, fun recorded/2, S) end, State, Out),
    replay_lcm_udp:close(Lcm).

perform(Out, State) ->
    Aside = fun(Dir, Now) -> spawn_link(fun() -> recorded(Dir, Now) end) end,
    lists:foldl(fun(O, S) -> perform_one(O, Aside, S) end, State, Out).

perform_one({publish, {Type, Message}}, _, #state{lcm = Lcm} = State) ->
    Bytes = replay_lcm:encode(Type, Message),
    case replay_lcm_udp:publish(Lcm, replay_lcm:channel(Type), Bytes) of
        ok -> State;
        {error, Line} -> failed(Line, State)
    end;
perform_one({log, Line}, _, #state{say = Say} = State) ->
    _ = Say(Line),
    State;
perform_one({store, Kept, Files}, Record, #state{cases = Cases} = State) ->
    Stored = stored(Kept, Files, Record, State),
    Idle = without_writer(Stored),
    ok = replay_unsaved:forget(Cases),
    Idle#state{written = none}.

%% What a player that was killed has left.
recovered(#state{cases = Cases, say = Say} = State) ->
    lists:foreach(
        fun(Dir) ->
            _ = Say("stored a flight whose player was killed as " ++ Dir),
            spawn_link(fun() -> recorded(Dir, State) end)
        end,
        replay_unsaved:recover(Cases)
    ),
    State.

%% By another process: a long flight takes a while.
kept_safe(#state{writer = none, player = Player, written = Before, written_us = At} = State) ->
    Now = now_us(),
    case replay_player:unsaved(Player) of
        {Mod, Source} = Flight when Flight =/= Before, Now - At >= ?WRITE_US ->
            Cases = State#state.cases,
            Writer = spawn_link(fun() -> ok = replay_unsaved:write(Cases, Mod, Source) end),
            State#state{writer = Writer, written = Flight, written_us = Now};
        _ ->
            State
    end;
kept_safe(State) ->
    State.

without_writer(#state{writer = none} = State) ->
    State;
without_writer(#state{writer = Writer} = State) ->
    receive
        {'EXIT', Writer, _} -> State#state{writer = none}
    end.

%% Told to the pages too, with the run that is played now.
noticed(Line, #state{player = Player} = State) ->
    {Out, Next} = replay_player:notice(Line, Player),
    perform(Out, State#state{player = Next}).

failed(Line, #state{failure = Line} = State) ->
    State;
failed(Line, #state{say = Say} = State) ->
    _ = Say("cannot send: " ++ Line),
    State#state{failure = Line}.

%% What belongs to it, and its recording, which takes a simulator of its own.
stored(Kept, Files, Record, #state{cases = Cases, say = Say} = State) ->
    case replay_kept:write(Cases, Kept, Files) of
        {ok, Dir} ->
            _ = Say(replay_kept:told(Kept, Dir)),
            _ = Record(Dir, State),
            noticed(replay_kept:told(Kept, filename:basename(Dir)), State);
        {error, Line} ->
            _ = Say("the flight cannot be stored: " ++ Line),
            noticed("the flight cannot be stored; the player's terminal says why", State)
    end.

recorded(Dir, #state{view = View, say = Say}) ->
    Result =
        case replay_source:of_case(Dir, shrunk, View) of
            {ok, Source} -> replay_recording:write(Source, filename:join(Dir, "run.lcm"));
            {error, _} = Error -> Error
        end,
    case Result of
        {ok, _} -> ok;
        {error, Line} -> Say("no recording: " ++ Line)
    end.

line(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

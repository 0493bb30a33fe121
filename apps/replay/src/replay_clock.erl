%% @doc Simulated time as a function of wall time: playing, paused, faster, slower, in a loop.
%%
%% Pure: wall time comes in as microseconds of a monotonic clock. While it plays, the position
%% follows from the moment at which it began to, so that waits do not add up; late callers are
%% simply told how far it is by now.
-module(replay_clock).

-export([new/1, play/2, pause/2, speed/3, seek/3, loop/3, limit/3]).
-export([position/2, is_playing/1, speed/1, looped/1, limit_of/1]).
-export_type([clock/0, wall/0, span/0]).

%% us
-type wall() :: integer().
-type t_us() :: non_neg_integer().
-type span() :: none | {From :: t_us(), To :: t_us()}.
-record(clock, {
    playing = false :: boolean(),
    speed = 1.0 :: float(),
    %% where it was, then
    from = 0 :: t_us(),
    since = 0 :: wall(),
    limit :: t_us() | infinity,
    loop = none :: span()
}).
-opaque clock() :: #clock{}.

-define(SLOWEST, 0.05).
-define(FASTEST, 20.0).

%% @doc At time 0, paused. It does not go beyond the limit.
-spec new(t_us() | infinity) -> clock().
new(Limit) -> #clock{limit = Limit}.

%% @doc Goes on from where it is.
-spec play(wall(), clock()) -> clock().
play(Now, Clock) -> (settled(Now, Clock))#clock{playing = true}.

%% @doc Stays where it is.
-spec pause(wall(), clock()) -> clock().
pause(Now, Clock) -> (settled(Now, Clock))#clock{playing = false}.

%% @doc Goes on so many times as fast as wall time; clamped to 0.05 to 20.
-spec speed(wall(), number(), clock()) -> clock().
speed(Now, Factor, Clock) ->
    (settled(Now, Clock))#clock{speed = max(?SLOWEST, min(?FASTEST, float(Factor)))}.

%% @doc Is somewhere else, playing or not; clamped to 0 and the limit.
-spec seek(wall(), integer(), clock()) -> clock().
seek(Now, T, #clock{limit = Limit} = Clock) ->
    Clock#clock{from = max(0, min(T, Limit)), since = Now}.

%% @doc Goes back to From whenever it comes to To. none, or a span of no length, ends that.
-spec loop(wall(), span(), clock()) -> clock().
loop(Now, {From, To}, #clock{limit = Limit} = Clock) when From < To, From < Limit ->
    (settled(Now, Clock))#clock{loop = {From, min(To, Limit)}};
loop(Now, _, Clock) ->
    (settled(Now, Clock))#clock{loop = none}.

%% @doc Another limit; it is not beyond it any more.
-spec limit(wall(), t_us() | infinity, clock()) -> clock().
limit(Now, Limit, Clock) ->
    #clock{from = From} = Settled = settled(Now, Clock),
    Settled#clock{limit = Limit, from = min(From, Limit)}.

settled(Now, Clock) -> Clock#clock{from = position(Now, Clock), since = Now}.

%% @doc The simulated time that belongs to a wall time.
-spec position(wall(), clock()) -> t_us().
position(_, #clock{playing = false, from = From}) ->
    From;
position(Now, #clock{speed = Speed, from = Begun, since = Since, limit = Limit, loop = Loop}) ->
    Reached = Begun + trunc(max(0, Now - Since) * Speed),
    case Loop of
        {From, To} when Begun < To, Reached >= To -> From + (Reached - To) rem (To - From);
        _ -> min(Reached, Limit)
    end.

-spec is_playing(clock()) -> boolean().
is_playing(#clock{playing = Playing}) -> Playing.

%% @doc Simulated seconds per second.
-spec speed(clock()) -> float().
speed(#clock{speed = Speed}) -> Speed.

-spec looped(clock()) -> span().
looped(#clock{loop = Loop}) -> Loop.

-spec limit_of(clock()) -> t_us() | infinity.
limit_of(#clock{limit = Limit}) -> Limit.

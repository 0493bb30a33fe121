%% @doc Risk contours by hand, as replay_lcm_frame does frames: both are sent 60 times a second.
-module(replay_lcm_risk).

-export([encode/1]).

%% @doc With the fingerprint; `unusual' for what the general way must judge.
-spec encode(replay_lcm:message()) -> {ok, binary()} | unusual.
encode(#{t_us := T, run := Run, observer := Observer, ellipses := Ellipses}) when
    is_integer(T), T >= -(1 bsl 63), T < 1 bsl 63,
    is_integer(Run), Run >= -(1 bsl 31), Run < 1 bsl 31,
    is_integer(Observer), Observer >= -(1 bsl 31), Observer < 1 bsl 31,
    is_list(Ellipses)
->
    #{fingerprint := Fingerprint} = replay_lcm_type:struct(risk),
    Head = <<Fingerprint:64, T:64, Run:32, Observer:32, (length(Ellipses)):32>>,
    try {ok, put_ellipses(Ellipses, Head)}
    catch error:_ -> unusual
    end;
encode(_) ->
    unusual.

put_ellipses([], Bytes) ->
    Bytes;
put_ellipses([Ellipse | Rest], Bytes) ->
    #{
        about := About, kind := Kind, overlap := Overlap, x := X, y := Y, rx := Rx, ry := Ry,
        theta := Theta, age := Age
    } = Ellipse,
    true = is_integer(About) andalso About >= -(1 bsl 31) andalso About < 1 bsl 31 andalso
        is_integer(Kind) andalso Kind >= -128 andalso Kind < 128 andalso
        is_integer(Overlap) andalso Overlap >= -128 andalso Overlap < 128,
    put_ellipses(Rest,
        <<Bytes/binary, About:32, Kind, Overlap, X:32/float, Y:32/float, Rx:32/float,
          Ry:32/float, Theta:32/float, Age:32/float>>).

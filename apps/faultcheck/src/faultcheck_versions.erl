%% @doc Which versions a result belongs to. A seed repeats a run only with the same ones.
-module(faultcheck_versions).

-export([all/0, proper/0, git/0, text/1, seed/2, differences/2]).
-export_type([versions/0]).

-type versions() :: #{
    faultcheck := string(), proper := string(), otp := string(), git := string()
}.

-spec all() -> versions().
all() ->
    #{
        faultcheck => vsn(faultcheck),
        proper => vsn(proper),
        otp => erlang:system_info(otp_release),
        git => git()
    }.

%% @doc PropEr's version as numbers: `[1, 2]'. Empty when PropEr is missing.
-spec proper() -> [non_neg_integer()].
proper() ->
    case persistent_term:get(?MODULE, unknown) of
        unknown ->
            Numbers = numbers(vsn(proper)),
            ok = persistent_term:put(?MODULE, Numbers),
            Numbers;
        Numbers ->
            Numbers
    end.

numbers(Text) ->
    [N || Part <- string:lexemes(Text, ".-+"), {N, ""} <- [string:to_integer(Part)]].

vsn(App) ->
    _ = application:load(App),
    case application:get_key(App, vsn) of
        {ok, Vsn} -> Vsn;
        undefined -> "none"
    end.

%% @doc The state of the repository around the current directory: a short commit and `-dirty'.
-spec git() -> string().
git() ->
    case os:find_executable("git") of
        false -> "none";
        Git -> git(Git)
    end.

git(Git) ->
    Args = ["describe", "--always", "--dirty", "--abbrev=10", "--exclude=*"],
    Port = open_port({spawn_executable, Git}, [
        {args, Args}, exit_status, stderr_to_stdout, in, binary
    ]),
    case collect(Port, <<>>) of
        {0, Text} -> string:trim(binary_to_list(Text));
        {_, _} -> "none"
    end.

collect(Port, Text) ->
    receive
        {Port, {data, More}} -> collect(Port, <<Text/binary, More/binary>>);
        {Port, {exit_status, Status}} -> {Status, Text}
    end.

%% @doc `"FaultCheck 0.1.0, PropEr 1.2, OTP 25, git 0123456789"'.
-spec text(versions()) -> string().
text(#{faultcheck := F, proper := P, otp := O, git := G}) ->
    text("FaultCheck ~ts, PropEr ~ts, OTP ~ts, git ~ts", [F, P, O, G]).

%% @doc A seed as the command line takes it: with the versions that it belongs to.
-spec seed(non_neg_integer(), versions()) -> string().
seed(Seed, #{faultcheck := F, proper := P, otp := O}) ->
    text("~b@~ts,~ts,~ts", [Seed, F, P, O]).

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

%% @doc What differs between two, in words; a seed of one may not repeat in the other.
-spec differences(#{atom() => string()}, versions()) -> [string()].
differences(Then, Now) ->
    [
        lists:concat([Name, " ", maps:get(Key, Then), " then, ", maps:get(Key, Now), " now"])
     || {Key, Name} <- [{faultcheck, "FaultCheck"}, {proper, "PropEr"}, {otp, "OTP"}],
        maps:get(Key, Then) =/= maps:get(Key, Now)
    ].

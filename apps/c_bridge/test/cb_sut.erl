%% @doc Helpers of the tests: the C sources beside them, waiting for the end of OS processes.
-module(cb_sut).

-export([source/1, start/3, start/2, cache/0, await_gone/1, alive/1, reason/1]).

%% @doc A file of apps/c_bridge/test/c. `src' in the build directory links to the real one.
source(Name) ->
    Src = filename:join(code:lib_dir(c_bridge), "src"),
    Real =
        case file:read_link_all(Src) of
            {ok, Target} -> filename:absname(Target, filename:dirname(Src));
            {error, _} -> Src
        end,
    filename:join([filename:dirname(Real), "test", "c", Name]).

start(Name, Options) -> start(list_to_atom("sut_" ++ filename:rootname(Name)), Name, Options).

start(LibName, Name, Options) ->
    {ok, Lib} = cb:start(LibName, [{c_src, source(Name)}, {cache_dir, cache()} | Options]),
    Lib.

%% @doc One cache for all tests of a run.
cache() -> filename:absname("_build/test/c_bridge").

%% @doc Waits until no process has this pid; whoever waits is stopped by EUnit if it never ends.
await_gone(OsPid) ->
    case alive(OsPid) of
        true ->
            receive
            after 5 -> await_gone(OsPid)
            end;
        false ->
            gone
    end.

%% A zombie is gone: nobody has waited for it yet.
alive(OsPid) ->
    case file:read_file(["/proc/", integer_to_list(OsPid), "/stat"]) of
        {ok, Stat} -> binary:match(Stat, <<") Z ">>) =:= nomatch;
        {error, _} -> false
    end.

%% @doc The reason that Fun raises.
reason(Fun) ->
    try Fun() of
        Value -> {no_error, Value}
    catch
        error:{cb, Reason} -> Reason
    end.

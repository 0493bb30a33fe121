%% @doc Where a shared library is that an application of the same build or installation uses.
-module(cb_library).

-export([find/2]).

%% @doc The library's file: of the directory that FAULTCHECK_LIB_DIR names, otherwise of the
%% installation or the clone that a module of the application came from. None there is the error
%% {cb, {load, Name, _}}.
-spec find(Name :: string(), Near :: module()) -> file:filename().
find(Name, Near) ->
    Places = places(os:getenv("FAULTCHECK_LIB_DIR"), Near),
    case [File || Dir <- Places, File <- [filename:join(Dir, Name)], filelib:is_file(File)] of
        [File | _] -> File;
        [] -> error({cb, {load, Name, {dlerror, nowhere(Places)}}})
    end.

places(Dir, _Near) when is_list(Dir), Dir =/= "" ->
    [Dir];
places(_, Near) ->
    %% PREFIX/lib/faultcheck/APP-VERSION, or _build/PROFILE/lib/APP
    App = filename:dirname(filename:dirname(filename:absname(code:which(Near)))),
    Up = filename:dirname(filename:dirname(App)),
    [Up, filename:join([filename:dirname(Up), "native", "lib"]), "_build/native/lib"].

nowhere(Places) ->
    unicode:characters_to_binary([
        "not in ",
        lists:join(", ", Places),
        "; run `make native` or set FAULTCHECK_LIB_DIR to its directory"
    ]).

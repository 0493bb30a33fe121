%% @doc The `nif' transport: the system under test inside this VM.
%%
%% Nothing here survives a crash of the C code; the runner puts such systems into a child VM.
-module(cb_session).

-export([start/1, restart/2, stop/1]).

%% @doc Loads the library of the options. The map is what the core says about it, with the reset
%% chosen.
-spec start(cb_options:options()) -> {ok, cb_nif:session(), map()} | {error, term()}.
start(#{file := File, load_options := LoadOptions, env := Env} = Options) ->
    case cb_nif:load_error() of
        none ->
            %% Compiled code reads the coverage directory when it writes its counts.
            ok = lists:foreach(fun({Name, Value}) -> ok = cb_nif:setenv(Name, Value) end, Env),
            load(cb_nif:new(), {load, File, LoadOptions}, Options);
        Reason ->
            {error, Reason}
    end.

load(Session, Request, #{reset := Asked, force_reset := Forced}) ->
    case cb_nif:request_dirty(Session, Request) of
        {ok, Loaded} ->
            case cb_reset:choose(nif, Asked, Forced, Loaded) of
                {ok, Choice} -> prepare(Session, maps:merge(Loaded, Choice));
                {error, _} = Error -> Error
            end;
        {error, _} = Error ->
            Error
    end.

prepare(Session, Info) ->
    case requests(Session, after_load(Info)) of
        ok -> {ok, Session, Info};
        {error, _} = Error -> Error
    end.

after_load(#{method := snapshot} = Info) -> [snapshot | cb_reset:requests(Info)];
after_load(Info) -> cb_reset:requests(Info).

%% @doc Back to the state after start, by the method that start/1 has chosen.
-spec restart(cb_nif:session(), map()) -> ok | {error, term()}.
restart(Session, #{method := snapshot} = Info) ->
    requests(Session, [restore | cb_reset:requests(Info)]);
restart(Session, #{method := reload} = Info) ->
    requests(Session, [reload | cb_reset:requests(Info)]);
restart(Session, Info) ->
    requests(Session, cb_reset:requests(Info)).

requests(_Session, []) ->
    ok;
requests(Session, [Request | Requests]) ->
    case cb_nif:request(Session, Request) of
        {ok, _} -> requests(Session, Requests);
        {error, _} = Error -> Error
    end.

-spec stop(cb_nif:session()) -> ok.
stop(Session) ->
    {ok, _} = cb_nif:request(Session, stop),
    ok.

%% @doc The native functions: the `nif' transport, journals, signals, and the environment that C
%% code sees.
%%
%% Loading this module loads no code under test. What a request is and what it answers is told in
%% docs/architecture.md, "how a call travels"; `cb' is the module to call.
-module(cb_nif).

-export([
    new/0,
    request/2,
    request_dirty/2,
    call/3,
    call_dirty/3,
    batch/2,
    journal_open/2,
    journal_start/2,
    journal_append/2,
    kill/2,
    setenv/2,
    interrupt_as_term/0,
    load_error/0
]).
-export_type([session/0, journal/0, reply/0]).

-on_load(load/0).

-type session() :: reference().
-type journal() :: reference().
-type reply() :: {ok, term()} | {error, term()}.

%% @doc An empty session; `{load, File, Opts}' is the first request to make.
-spec new() -> session().
new() -> missing().

-spec request(session(), term()) -> reply().
request(_Session, _Request) -> missing().

%% @doc The same on a dirty scheduler, for C functions that take longer than a millisecond.
-spec request_dirty(session(), term()) -> reply().
request_dirty(_Session, _Request) -> missing().

-spec call(session(), binary() | atom() | non_neg_integer(), [term()]) -> reply().
call(_Session, _Function, _Args) -> missing().

-spec call_dirty(session(), binary() | atom() | non_neg_integer(), [term()]) -> reply().
call_dirty(_Session, _Function, _Args) -> missing().

-spec batch(session(), [{binary() | atom() | non_neg_integer(), [term()]}]) -> reply().
batch(_Session, _Calls) -> missing().

-spec journal_open(unicode:chardata(), pos_integer()) -> {ok, journal()} | {error, term()}.
journal_open(_File, _Bytes) -> missing().

-spec journal_start(journal(), iodata()) -> ok | {error, full}.
journal_start(_Journal, _Record) -> missing().

-spec journal_append(journal(), iodata()) -> ok | {error, full}.
journal_append(_Journal, _Record) -> missing().

-spec kill(pos_integer(), non_neg_integer()) -> ok | {error, atom()}.
kill(_OsPid, _Signal) -> missing().

-spec setenv(unicode:chardata(), unicode:chardata()) -> ok.
setenv(_Name, _Value) -> missing().

%% @doc From now on this VM takes SIGINT (Ctrl-C) for SIGTERM, which Erlang code can handle.
-spec interrupt_as_term() -> ok | {error, atom()}.
interrupt_as_term() -> missing().

%% @doc Why the native functions are not there; `none' if they are.
-spec load_error() -> none | {load, file:filename(), {dlerror, string()}}.
load_error() ->
    case load_library() of
        ok -> none;
        {error, {reload, _}} -> none;
        {error, {_, Text}} -> {load, library() ++ ".so", {dlerror, lists:flatten(Text)}}
    end.

%% The module stays loaded without its library, so that the first use can say what is missing.
load() ->
    _ = load_library(),
    ok.

load_library() -> erlang:load_nif(library(), 0).

library() -> filename:join(cb_files:priv_dir(), "c_bridge_nif").

-spec missing() -> any().
missing() -> erlang:nif_error({cb, load_error()}).

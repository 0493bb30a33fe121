%% @doc Which reset brings the system under test back to its state after start.
%%
%% `auto' is the fork server for `port'; for `nif' it is snapshot if the library qualifies (see
%% what the core says about it when it is loaded), else reload. A reset that was asked for is
%% used even if it does not cover the whole state, with a warning.
-module(cb_reset).

-export([choose/4, requests/1]).
-export_type([method/0, asked/0, transport/0, reset_call/0, choice/0]).

-type transport() :: nif | port.
-type method() :: fork | snapshot | reload | respawn | calls | none.
-type reset_call() :: {Function :: atom() | string() | binary(), [term()]}.
-type asked() :: auto | fork | snapshot | reload | respawn | none | {calls, [reset_call()]}.
-type choice() :: #{method := method(), calls := [reset_call()], warnings := [binary()]}.

%% @doc Forced, if not `none', replaces the method that the model asked for; the calls of
%% `{calls, _}' are then made after it, because they are part of the state after start.
-spec choose(transport(), asked(), Forced :: none | {force, asked()}, Loaded :: map()) ->
    {ok, choice()} | {error, {reset, asked(), not_in_nif}}.
choose(Transport, Asked, Forced, Loaded) ->
    Wanted = wanted(Asked, Forced),
    case method(Transport, Wanted, Loaded) of
        not_in_nif ->
            {error, {reset, Wanted, not_in_nif}};
        Method ->
            Warnings = warnings(Method, Loaded),
            {ok, #{method => Method, calls => calls(Asked), warnings => Warnings}}
    end.

wanted(Asked, none) -> Asked;
wanted(_, {force, Forced}) -> Forced.

calls({calls, Calls}) -> Calls;
calls(_) -> [].

method(_, {calls, _}, _) -> calls;
method(port, auto, _) -> fork;
method(nif, auto, #{reset := Qualified}) -> Qualified;
method(nif, fork, _) -> not_in_nif;
method(nif, respawn, _) -> not_in_nif;
method(_, Method, _) -> Method.

%% The core's warnings are about what a restored or reloaded image does not cover.
warnings(snapshot, #{reset := reload, warnings := Why}) -> Why;
warnings(reload, #{warnings := Why}) -> [W || W <- Why, mentions(W, [<<"pinned">>, <<"thread">>])];
warnings(none, _) -> [<<"reset none: the state of one test is seen by the next">>];
warnings(_, _) -> [].

mentions(Text, Words) -> binary:match(Text, Words) =/= nomatch.

%% @doc The requests that make the state after start, once loaded or reset by its method.
-spec requests(choice()) -> [term()].
requests(#{method := calls, calls := Calls}) -> [{begin_test, Calls}];
requests(#{calls := []}) -> [];
requests(#{calls := Calls}) -> [{begin_test, Calls}].

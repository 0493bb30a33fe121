%% Commands that need each other: a session, a transaction in it, increments with the
%% session's token. The answer to commit is wrong from a total of 250 on.
-module(chain_model).

-include("faultcheck.hrl").

-export([reset/0]).

-record(st, {open = false, token = none, begun = false}).

reset() ->
    put(chain, {0, 0}),
    ok.

initial_state() -> #st{}.

open_pre(S) -> not S#st.open.
open_args(_) -> [].
open() -> ok.
open_next(S, _, []) -> S#st{open = true}.

login_pre(S) -> S#st.open andalso S#st.token =:= none.
login_args(_) -> [elements([ann, bob])].
login(_) ->
    {Token, Total} = get(chain),
    put(chain, {Token + 1, Total}),
    Token + 1.
login_next(S, Token, [_]) -> S#st{token = Token}.

start_pre(S) -> S#st.token =/= none andalso not S#st.begun.
start_args(_) -> [].
start() ->
    {Token, _} = get(chain),
    put(chain, {Token, 0}),
    ok.
start_next(S, _, []) -> S#st{begun = true}.

incr_pre(S) -> S#st.begun.
incr_args(S) -> [S#st.token, integer(1, 100)].
incr_pre(S, [Token, _]) -> Token =:= S#st.token.
incr(Token, N) ->
    {Token, Total} = get(chain),
    put(chain, {Token, Total + N}),
    ok.

commit_pre(S) -> S#st.begun.
commit_args(_) -> [].
commit() ->
    {_, Total} = get(chain),
    case Total >= 250 of
        true -> overflow;
        false -> ok
    end.
commit_next(S, _, []) -> S#st{begun = false}.
commit_post(_, [], Answer) -> Answer =:= ok.

logout_pre(S) -> S#st.token =/= none andalso not S#st.begun.
logout_args(_) -> [].
logout() -> ok.
logout_next(S, _, []) -> S#st{token = none}.

%% @doc Turns SIGTERM and SIGINT (Ctrl-C) into a message, so that a run can end
%% its child VM and keep what it has stored. A second signal ends the VM at once.
-module(faultcheck_interrupt).
-behaviour(gen_event).

-export([install/1, remove/0]).
-export([init/1, handle_event/2, handle_call/2]).

%% @doc From now on the process gets the message faultcheck_interrupt.
-spec install(pid()) -> ok.
install(Pid) ->
    _ = cb_nif:interrupt_as_term(),
    _ = gen_event:delete_handler(erl_signal_server, ?MODULE, gone),
    gen_event:swap_handler(erl_signal_server, {erl_signal_handler, []}, {?MODULE, Pid}).

-spec remove() -> ok.
remove() ->
    gen_event:swap_handler(erl_signal_server, {?MODULE, []}, {erl_signal_handler, []}).

-spec init({pid(), term()}) -> {ok, {pid(), non_neg_integer()}}.
init({Pid, _}) -> {ok, {Pid, 0}}.

-spec handle_event(atom(), {pid(), non_neg_integer()}) -> {ok, {pid(), non_neg_integer()}}.
handle_event(sigterm, {Pid, 0}) ->
    Pid ! faultcheck_interrupt,
    {ok, {Pid, 1}};
handle_event(sigterm, {_, _}) ->
    erlang:halt(130, [{flush, false}]);
handle_event(Signal, State) ->
    %% What the VM does with the others stays as it is.
    _ = erl_signal_handler:handle_event(Signal, []),
    {ok, State}.

-spec handle_call(term(), State) -> {ok, unknown, State}.
handle_call(_Request, State) -> {ok, unknown, State}.

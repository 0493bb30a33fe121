%% @doc Why a property failed, in lines for a reader.
-module(faultcheck_reason).

-export([lines/3, trimmed/1, unstarted/1, is_timeout/1, proper/1, ending/1]).

-define(STACK_LINES, 5).

%% @doc An exception and the innermost places of its stack that are not PropEr's or ours.
-spec lines(error | exit | throw, term(), list()) -> [string()].
lines(error, {cb, Reason}, _Stack) ->
    trimmed(cb_error:format(Reason));
lines(Class, Reason, Stack) ->
    [text("~s:~0tP", [Class, Reason, 40]) | places(Stack)].

%% @doc A text in lines without the blanks around them, and without addresses: those are others
%% in every process, and a reason is compared with the recorded one.
-spec trimmed(iodata()) -> [string()].
trimmed(Text) ->
    Lines = string:split(text("~ts", [without_addresses(Text)]), "\n", all),
    [string:trim(L) || L <- Lines, string:trim(L) =/= ""].

%% Small ones are null pointers and members behind them.
without_addresses(Text) ->
    Pattern = "( at address)? 0x[0-9a-f]{5,}",
    re:replace(Text, Pattern, "", [global, unicode, {return, binary}]).

places(Stack) ->
    Own = [E || E <- Stack, is_tuple(E), not machinery(atom_to_list(element(1, E)))],
    [place(E) || E <- lists:sublist(Own, ?STACK_LINES)].

machinery(Module) ->
    lists:prefix("proper", Module) orelse
        lists:member(Module, ["faultcheck_instrument", "faultcheck_property", "faultcheck_worker"]).

place({M, F, Args, Where}) when is_list(Args) ->
    place({M, F, length(Args), Where});
place({M, F, Arity, Where}) ->
    case {proplists:get_value(file, Where), proplists:get_value(line, Where)} of
        {undefined, _} -> text("in ~tp:~tp/~b", [M, F, Arity]);
        {File, Line} -> text("in ~tp:~tp/~b (~ts:~b)", [M, F, Arity, File, Line])
    end.

%% @doc Whether a reason means that the system under test could not be built or started.
-spec unstarted(term()) -> {true, string()} | false.
unstarted({cb, Reason}) -> unstarted(Reason);
unstarted({badmatch, {error, Reason}}) -> unstarted(Reason);
unstarted({{badmatch, {error, Reason}}, _}) -> unstarted(Reason);
unstarted(Reason) when is_tuple(Reason), tuple_size(Reason) > 1 ->
    Kinds = [load, compile, undefined, stub, cache, bad_option, missing_option, needs_port],
    case lists:member(element(1, Reason), Kinds) of
        true -> {true, text("~ts", [cb_error:format(Reason)])};
        false -> false
    end;
unstarted(_) ->
    false.

%% @doc Whether a reason is that C code took longer than its limit.
-spec is_timeout(term()) -> boolean().
is_timeout({cb, {timeout, _, _}}) -> true;
is_timeout(_) -> false.

%% @doc What PropEr answers instead of a result.
-spec proper(term()) -> string().
proper(cant_generate) ->
    "no instance satisfies a ?SUCHTHAT within the tries allowed; loosen it or raise"
    " --constraint_tries";
proper({cant_generate, MFAs}) ->
    text("~ts (~0tp)", [proper(cant_generate), MFAs]);
proper(cant_satisfy) ->
    "every test was rejected by an ?IMPLIES; loosen its condition";
proper(non_boolean_result) ->
    "the property returned something that is neither true nor false";
proper(type_mismatch) ->
    "the variables and the types of a ?FORALL do not match";
proper(rejected) ->
    "the counterexample does not pass an ?IMPLIES of the property";
proper(too_many_instances) ->
    "the counterexample has more values than the property has ?FORALLs";
proper({typeserver, Reason}) ->
    text("PropEr cannot use a type: ~0tP", [Reason, 30]);
proper({unrecognized_option, Option}) ->
    text("this version of PropEr does not know the option ~0tp", [Option]);
proper(Reason) ->
    text("PropEr stopped: ~0tP", [Reason, 30]).

%% @doc How an OS process ended.
-spec ending(cb_guard:ending()) -> string().
ending({exit, Status}) -> text("exited with status ~b", [Status]);
ending({signal, Signal}) -> text("died of signal ~b (~ts)", [Signal, signal(Signal)]).

signal(3) -> "SIGQUIT";
signal(4) -> "SIGILL";
signal(5) -> "SIGTRAP";
signal(6) -> "SIGABRT";
signal(7) -> "SIGBUS";
signal(8) -> "SIGFPE";
signal(9) -> "SIGKILL";
signal(11) -> "SIGSEGV";
signal(15) -> "SIGTERM";
signal(_) -> "see kill -l".

text(Format, Args) -> lists:flatten(io_lib:format(Format, Args)).

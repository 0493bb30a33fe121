%% @doc Names for places in code: module and offset to function, file and line.
-module(cb_symbols).

-export([frames/3]).
-export_type([known/0]).

-type known() :: #{[cb_crash:address()] => [cb_crash:frame()]}.

-define(TIMEOUT_MS, 60000).
-define(STOP_MS, 5000).

%% @doc Asks Program, or a fresh one if there is none. A place that cannot be named is given as
%% module and offset.
-spec frames([cb_crash:address()], known(), none | cb_program:program()) ->
    {[cb_crash:frame()], known()}.
frames([], Known, _Program) ->
    {[], Known};
frames(Addresses, Known, Program) ->
    case Known of
        #{Addresses := Frames} ->
            {Frames, Known};
        #{} ->
            Frames = ask(Addresses, Program),
            {Frames, Known#{Addresses => Frames}}
    end.

ask(Addresses, none) ->
    case cb_program:start("/dev/null", [], fun refuse/2) of
        {ok, Fresh} ->
            Frames = ask(Addresses, Fresh),
            ok = cb_program:stop(Fresh, ?STOP_MS),
            Frames;
        {error, _} ->
            unnamed(Addresses)
    end;
ask(Addresses, Program) ->
    case cb_program:request(Program, {symbolise, Addresses}, ?TIMEOUT_MS) of
        {ok, Frames} -> Frames;
        _ -> unnamed(Addresses)
    end.

refuse(Function, _Args) -> {error, {Function, unexpected}}.

unnamed(Addresses) -> [{place(Module, Offset), <<>>, 0} || {Module, Offset, _} <- Addresses].

place(Module, Offset) ->
    iolist_to_binary([filename:basename(Module), "+0x", integer_to_list(Offset, 16)]).

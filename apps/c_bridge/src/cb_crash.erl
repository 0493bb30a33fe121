%% @doc From the log of a dead system under test to a reason that names the place.
%%
%% The port program writes a `SIGNAL' block into its log before it dies (docs/architecture.md
%% has the lines); AddressSanitizer and UBSan write reports of their own. Frames are symbolised
%% afterwards, by a function given as argument, because the dead process could not be trusted
%% to do it.
-module(cb_crash).

-export([reason/4, timeout/5, sanitizer_lines/1, signal_name/1]).
-export_type([crash/0, frame/0, address/0, symboliser/0, sut/0]).

-type frame() :: {Function :: binary(), File :: binary(), Line :: non_neg_integer()}.
-type address() :: {Module :: binary(), Offset :: non_neg_integer(), First :: boolean()}.
-type symboliser() :: fun(([address()]) -> [frame()]).
%% What was asked of the system under test: `{Function, Args}' or a request such as `reload'.
-type sut() :: term().
-type crash() ::
    {crash, #{
        signal := atom(),
        addr := non_neg_integer() | unknown,
        in := sut(),
        frames := [frame()],
        log := binary(),
        coredump := none
    }}
    | {exited, 0..127 | unknown, #{in := sut(), log := binary()}}
    | {sanitizer, Kind :: atom(), #{summary := binary(), log := binary(), in := sut()}}
    | {timeout, pos_integer(), #{in := sut(), frames := [frame()], log := binary()}}.

-define(TAIL, 4096).

%% @doc What the end of a process means, given what it wrote since the test began.
-spec reason(cb_program:ending(), sut(), Log :: binary(), symboliser()) -> crash().
reason(Ending, In, Log, Symboliser) ->
    case sanitizer_report(Log) of
        {Kind, Summary, Report} ->
            {sanitizer, Kind, #{summary => Summary, log => Report, in => In}};
        none ->
            {Signal, Output} = split(Log),
            ended(Ending, Signal, In, tail(Output), Symboliser)
    end.

ended({exit, Status}, _, In, Output, _) ->
    {exited, Status, #{in => In, log => Output}};
ended(unknown, none, In, Output, _) ->
    {exited, unknown, #{in => In, log => Output}};
ended(unknown, #{number := Number} = Signal, In, Output, Symboliser) ->
    ended({signal, Number}, Signal, In, Output, Symboliser);
ended({signal, Number}, Signal, In, Output, Symboliser) ->
    {crash, #{
        signal => signal_name(Number),
        addr => address(Number, Signal),
        in => In,
        frames => frames(Signal, Symboliser),
        log => Output,
        coredump => none
    }}.

%% @doc The same for a process that did not answer in Ms milliseconds and was made to end.
-spec timeout(pos_integer(), cb_program:ending(), sut(), binary(), symboliser()) -> crash().
timeout(Ms, _Ending, In, Log, Symboliser) ->
    {Signal, Output} = split(Log),
    {timeout, Ms, #{in => In, frames => frames(Signal, Symboliser), log => tail(Output)}}.

%% SIGABRT and signals sent by kill have no address.
address(_, none) -> unknown;
address(Number, #{addr := Addr}) when Number =:= 4; Number =:= 7; Number =:= 8; Number =:= 11 -> Addr;
address(_, _) -> unknown.

frames(none, _) -> [];
frames(#{frames := Addresses}, Symboliser) -> Symboliser(of_the_sut(Addresses)).

%% The frames below the call are those of libffi and of the port program.
of_the_sut(Addresses) ->
    case lists:splitwith(fun({Module, _, _}) -> not carrier(Module) end, Addresses) of
        {[], All} -> All;
        {Sut, _} -> Sut
    end.

carrier(Module) ->
    case filename:basename(Module) of
        <<"libffi.so", _/binary>> -> true;
        <<"c_bridge_port">> -> true;
        _ -> false
    end.

%% ---- the SIGNAL block ------------------------------------------------------------------

%% The last block, and what the log says without any block.
split(Log) ->
    {Block, Output} = sort_lines(binary:split(Log, <<"\n">>, [global]), none, []),
    {Block, iolist_to_binary(lists:join($\n, Output))}.

sort_lines([<<"SIGNAL ", Line/binary>> | Lines], Found, Output) ->
    case signal_line(Line) of
        {ok, Signal} ->
            {Addresses, Rest} = frame_lines(Lines, []),
            sort_lines(Rest, Signal#{frames => Addresses}, Output);
        error ->
            sort_lines(Lines, Found, [<<"SIGNAL ", Line/binary>> | Output])
    end;
sort_lines([Line | Lines], Found, Output) ->
    sort_lines(Lines, Found, [Line | Output]);
sort_lines([], Found, Output) ->
    {Found, lists:reverse(Output)}.

signal_line(Line) ->
    case binary:split(Line, <<" ">>, [global]) of
        [Number, _Name, <<"code">>, _Code, <<"addr">>, Addr, <<"pc">>, _Pc] ->
            {ok, #{number => binary_to_integer(Number), addr => hex(Addr)}};
        _ ->
            error
    end.

frame_lines([<<"FRAME ", Frame/binary>> | Lines], Found) ->
    case re:run(Frame, "^([0-9]+) (.*) (0x[0-9a-f]+)$", [{capture, all_but_first, binary}]) of
        {match, [Index, Module, Offset]} ->
            frame_lines(Lines, [{Module, hex(Offset), Index =:= <<"0">>} | Found]);
        nomatch ->
            frame_lines(Lines, Found)
    end;
frame_lines([<<"OMITTED ", _/binary>> | Lines], Found) ->
    frame_lines(Lines, Found);
frame_lines([<<"END">> | Lines], Found) ->
    {lists:reverse(Found), Lines};
frame_lines(Lines, Found) ->
    {lists:reverse(Found), Lines}.

hex(<<"0x", Digits/binary>>) -> binary_to_integer(Digits, 16).

%% ---- sanitizers --------------------------------------------------------------------------

sanitizer_report(Log) ->
    Error = "ERROR: (?:Address|Thread|Memory|Leak)Sanitizer:? ([A-Za-z-]+)",
    case re:run(Log, Error, [{capture, [0, 1], index}]) of
        {match, [{From, _}, {KindFrom, KindLength}]} ->
            Kind = binary_to_atom(binary:part(Log, KindFrom, KindLength)),
            {Kind, summary(Log), report(Log, From)};
        nomatch ->
            undefined_behaviour(Log)
    end.

undefined_behaviour(Log) ->
    case sanitizer_lines(Log) of
        [First | _] -> {undefined, First, tail(Log)};
        [] -> none
    end.

%% @doc The messages of UBSan, which prints and goes on.
-spec sanitizer_lines(binary()) -> [binary()].
sanitizer_lines(Log) ->
    Line = "^.*:[0-9]+:[0-9]+: runtime error: .*$",
    case re:run(Log, Line, [multiline, global, {capture, first, binary}]) of
        {match, Found} -> lists:append(Found);
        nomatch -> []
    end.

summary(Log) ->
    case re:run(Log, "^SUMMARY: (.*)$", [multiline, {capture, all_but_first, binary}]) of
        {match, [Summary]} -> Summary;
        nomatch -> hd(binary:split(Log, <<"\n">>))
    end.

report(Log, From) ->
    Bytes = min(byte_size(Log) - From, 4 * ?TAIL),
    binary:part(Log, From, Bytes).

tail(Output) when byte_size(Output) =< ?TAIL -> Output;
tail(Output) -> binary:part(Output, byte_size(Output), -?TAIL).

%% @doc Linux x86-64 numbers.
-spec signal_name(pos_integer()) -> atom().
signal_name(1) -> sighup;
signal_name(2) -> sigint;
signal_name(3) -> sigquit;
signal_name(4) -> sigill;
signal_name(5) -> sigtrap;
signal_name(6) -> sigabrt;
signal_name(7) -> sigbus;
signal_name(8) -> sigfpe;
signal_name(9) -> sigkill;
signal_name(11) -> sigsegv;
signal_name(13) -> sigpipe;
signal_name(14) -> sigalrm;
signal_name(15) -> sigterm;
signal_name(24) -> sigxcpu;
signal_name(31) -> sigsys;
signal_name(Number) -> list_to_atom("signal" ++ integer_to_list(Number)).

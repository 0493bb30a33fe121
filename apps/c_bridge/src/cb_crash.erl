%% @doc From the log of a dead system under test to a reason that names the place.
%%
%% The port program writes `@c_bridge' lines into its log before it dies (docs/architecture.md
%% has their form); AddressSanitizer and UBSan write reports of their own. Frames are symbolised
%% afterwards, by a function given as argument, because the dead process could not be trusted
%% to do it.
-module(cb_crash).

-export([examine/2, addresses/1, reason/3, sanitizer_lines/1, signal_name/1]).
-export_type([crash/0, frame/0, address/0, finding/0, sut/0]).

-type frame() :: {Function :: binary(), File :: binary(), Line :: non_neg_integer()}.
-type address() :: {Module :: binary(), Offset :: non_neg_integer(), First :: boolean()}.
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
-opaque finding() ::
    {sanitizer, Kind :: atom(), Summary :: binary(), Report :: binary()}
    | {exited, 0..127 | unknown, Output :: binary()}
    | {crash, Number :: pos_integer(), none | signal(), Output :: binary()}
    | {timeout, pos_integer(), none | signal(), Output :: binary()}.
-type signal() :: #{
    number := pos_integer(), addr := non_neg_integer(), frames := [address()]
}.

-define(TAIL, 4096).

%% @doc What an end means, given what was written to the log since the test began.
-spec examine(cb_program:ending() | {timeout, pos_integer()}, Log :: binary()) -> finding().
examine({timeout, Ms}, Log) ->
    {Signal, Output} = split(Log),
    {timeout, Ms, Signal, tail(Output)};
examine(Ending, Log) ->
    case sanitizer_report(Log) of
        {Kind, Summary, Report} ->
            {sanitizer, Kind, Summary, Report};
        none ->
            {Signal, Output} = split(Log),
            ended(Ending, Signal, tail(Output))
    end.

ended({exit, Status}, _, Output) -> {exited, Status, Output};
ended({signal, Number}, Signal, Output) -> {crash, Number, Signal, Output};
ended(unknown, none, Output) -> {exited, unknown, Output};
ended(unknown, #{number := Number} = Signal, Output) -> {crash, Number, Signal, Output}.

%% @doc The places in the code to be named.
-spec addresses(finding()) -> [address()].
addresses({_, _, #{frames := Addresses}, _}) -> of_the_sut(Addresses);
addresses(_) -> [].

%% @doc The reason for callers. In is what was asked, Frames are the names of addresses/1.
-spec reason(finding(), sut(), [frame()]) -> crash().
reason({sanitizer, Kind, Summary, Report}, In, _) ->
    {sanitizer, Kind, #{summary => Summary, log => Report, in => In}};
reason({exited, Status, Output}, In, _) ->
    {exited, Status, #{in => In, log => Output}};
reason({timeout, Ms, _, Output}, In, Frames) ->
    {timeout, Ms, #{in => In, frames => Frames, log => Output}};
reason({crash, Number, Signal, Output}, In, Frames) ->
    {crash, #{
        signal => signal_name(Number),
        addr => address(Number, Signal),
        in => In,
        frames => Frames,
        log => Output,
        coredump => none
    }}.

%% Only SIGILL, SIGBUS, SIGFPE and SIGSEGV have an address.
address(Number, #{number := Number, addr := Addr}) when
    Number =:= 4; Number =:= 7; Number =:= 8; Number =:= 11
->
    Addr;
address(_, _) ->
    unknown.

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

%% ---- the lines of the port program ----------------------------------------------------

%% The last signal in it with its frames, and what the log says without such lines.
split(Log) ->
    {Signal, Output} = lists:foldl(fun line/2, {none, []}, binary:split(Log, <<"\n">>, [global])),
    {Signal, iolist_to_binary(lists:join($\n, lists:reverse(Output)))}.

line(<<"@c_bridge signal ", Line/binary>>, {_, Output}) ->
    [Number, _Name, <<"code">>, _Code, <<"addr">>, Addr | _] =
        binary:split(Line, <<" ">>, [global]),
    {#{number => binary_to_integer(Number), addr => hex(Addr), frames => []}, Output};
line(<<"@c_bridge frame ", Line/binary>>, {#{frames := Frames} = Signal, Output}) ->
    {match, [Module, Offset]} =
        re:run(Line, "^(.*) (0x[0-9a-fA-F]+)$", [{capture, all_but_first, binary}]),
    Frame = {Module, hex(Offset), Frames =:= []},
    {Signal#{frames := Frames ++ [Frame]}, Output};
line(<<"@c_bridge skipped ", _/binary>>, Found) ->
    Found;
line(Line, {Signal, Output}) ->
    {Signal, [Line | Output]}.

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

%% @doc One clear line for every reason of c_bridge: what is wrong, where, and what would be right.
-module(cb_error).

-export([format/1]).
-export_type([reason/0]).

-type name() :: cb:fname().
-type value_detail() ::
    {out_of_range, cb:ctype(), term()}
    | {bad_type, cb:ctype(), term()}
    | {bad_enumerator, cb:ctype(), term()}
    | {unsupported_type, cb:ctype()}
    | {stale_pointer, term()}
    | {bad_pointer, term()}
    | term().
-type arity_expected() :: non_neg_integer() | {at_least, non_neg_integer()}.
-type load_detail() ::
    no_debug_info
    | {dlerror, unicode:chardata()}
    | {debug_info, unicode:chardata()}
    | {protocol, term()}.
-type reason() ::
    %% a call
    {unknown_function, name(), [name()]}
    | {not_callable, name(), inlined | abi_changed | {unsupported_type, pos_integer(), cb:ctype()}}
    | {arity, name(), arity_expected(), non_neg_integer(), Prototype :: binary()}
    | {arg, name(), pos_integer(), atom() | binary(), value_detail()}
    | {batch, pos_integer(), [term()], reason()}
    | {cxx_exception, binary()}
    | {unknown_handle, non_neg_integer()}
    %% a variable or memory
    | {unknown_variable, name(), [name()]}
    | {unknown_member, cb:path(), term(), [name()]}
    | {bad_index, cb:path(), term(), non_neg_integer()}
    | {not_accessible, name(), optimised_out | thread_local}
    | {read_only, cb:path()}
    | {value, cb:path() | cb:ctype(), value_detail()}
    | {unknown_type, cb:ctype()}
    | {null_pointer, term()}
    | {stale_pointer, term()}
    | {bad_pointer, term()}
    | {out_of_bounds, term(), term()}
    %% the end of the system under test
    | cb_crash:crash()
    | {not_running, reason() | stopped}
    | {callback, term()}
    | {callback, name(), no_port}
    | {in_call, name()}
    | busy
    | {other_process, pid()}
    | {callback, name(), term()}
    %% start and restart
    | {load, file:filename_all(), load_detail()}
    | {reset, cb_reset:asked(), not_in_nif}
    | {not_started, atom()}
    | {which_library, [atom()]}
    | cb_options:reason()
    | cb_compile:reason()
    | cb_module:reason()
    %% what only a defect of the bridge can cause
    | {bad_request, term()}
    | {keeper, term()}
    | no_child
    | no_snapshot
    | no_memory
    | not_loaded
    | already_loaded.

%% @doc The line, without its end. Reasons that are not of c_bridge are printed as terms.
-spec format(reason() | {cb, reason()} | term()) -> unicode:chardata().
format({cb, Reason}) -> format(Reason);
format(Reason) -> unicode:characters_to_binary(string:replace(line(Reason), "\n", "; ", all)).

%% ---- calls -----------------------------------------------------------------------------------

line({unknown_function, F, Similar}) ->
    text("no function ~ts in the library~ts", [name(F), suggest(Similar)]);
line({not_callable, F, inlined}) ->
    text("~ts cannot be called: the compiler has inlined it; build with -O0", [name(F)]);
line({not_callable, F, abi_changed}) ->
    text(
        "~ts cannot be called: the optimiser has changed its parameters; build with -O0, or "
        "with -fno-ipa-sra -fno-ipa-cp",
        [name(F)]
    );
line({not_callable, F, {unsupported_type, 0, Type}}) ->
    text(
        "~ts cannot be called: it returns ~ts, which cannot be passed by value; return a "
        "pointer to it",
        [name(F), name(Type)]
    );
line({not_callable, F, {unsupported_type, Position, Type}}) ->
    text(
        "~ts cannot be called: its argument ~b is ~ts, which cannot be passed by value; pass a "
        "pointer to it",
        [name(F), Position, name(Type)]
    );
line({arity, F, {at_least, Least}, Got, Prototype}) ->
    text(
        "~ts takes at least ~b argument~s, got ~b: ~ts",
        [name(F), Least, s(Least), Got, Prototype]
    );
line({arity, F, Expected, Got, Prototype}) ->
    text("~ts takes ~b argument~s, got ~b: ~ts", [name(F), Expected, s(Expected), Got, Prototype]);
line({arg, F, Position, Parameter, Detail}) ->
    text("~ts, argument ~b~ts: ~ts", [name(F), Position, parameter(Parameter), detail(Detail)]);
line({batch, Position, Done, Reason}) ->
    text(
        "call ~b of the batch, after ~b that returned: ~ts",
        [Position, length(Done), line(Reason)]
    );
line({cxx_exception, What}) ->
    text("the C++ code threw an exception that it did not catch: ~ts", [What]);
line({unknown_handle, Handle}) ->
    text("no function has handle ~b: resolve it in the library that is called", [Handle]);
%% ---- variables and memory ----------------------------------------------------------------------
line({unknown_variable, V, Similar}) ->
    text("no variable ~ts in the library~ts", [name(V), suggest(Similar)]);
line({unknown_member, Path, Member, Similar}) ->
    text("~ts has no member ~ts~ts", [path(Path), name(Member), suggest(Similar)]);
line({bad_index, Path, Index, 0}) ->
    text("~ts has no elements, but index ~tp is asked for", [path(Path), Index]);
line({bad_index, Path, Index, Count}) ->
    text("~ts has no index ~tp: 0 to ~b would be right", [path(Path), Index, Count - 1]);
line({not_accessible, V, optimised_out}) ->
    text(
        "variable ~ts has no place in memory: the optimiser has removed it; build with -O0",
        [name(V)]
    );
line({not_accessible, V, thread_local}) ->
    text(
        "variable ~ts is thread-local and not exported: only exported ones can be reached",
        [name(V)]
    );
line({read_only, Path}) ->
    text("~ts is constant: it can be read, not set", [path(Path)]);
line({value, Where, Detail}) ->
    text("value for ~ts: ~ts", [path(Where), detail(Detail)]);
line({unknown_type, Type}) ->
    text(
        "no type ~ts in the debug information; spell it as in C, such as \"struct point *\"",
        [name(Type)]
    );
line({null_pointer, Where}) ->
    text("~ts is a null pointer: there is nothing to read or write", [path(Where)]);
line({stale_pointer, Pointer}) ->
    text("pointer ~tp is from before a reset: ask for it again", [Pointer]);
line({bad_pointer, Term}) ->
    text(
        "~tp is no pointer: null or {ptr, Type, Reference} as the bridge gave it would be right",
        [Term]
    );
line({out_of_bounds, Pointer, Bytes}) ->
    text("~tp has no ~tp bytes to be accessed", [Pointer, Bytes]);
%% ---- the end of the system under test ----------------------------------------------------------
line({crash, #{signal := Signal, in := In, frames := Frames} = Crash}) ->
    text("crash: ~ts~ts in ~ts~ts", [upper(Signal), address(Crash), call(In), place(Frames)]);
line({exited, unknown, #{in := In}}) ->
    text("the system under test is gone, it is not known how, in ~ts", [call(In)]);
line({exited, Status, #{in := In}}) ->
    text("the system under test has called exit(~b) in ~ts", [Status, call(In)]);
line({sanitizer, Kind, #{summary := Summary, in := In}}) ->
    text("sanitizer: ~ts in ~ts: ~ts", [Kind, call(In), Summary]);
line({timeout, Ms, #{in := In, frames := Frames}}) ->
    text("no answer within ~b ms from ~ts~ts", [Ms, call(In), place(Frames)]);
line({not_running, stopped}) ->
    "the library has been stopped: start it again";
line({not_running, Why}) ->
    text("the system under test is not running, restart it; it has ended by: ~ts", [line(Why)]);
line({callback, {Function, no_such_stub}}) ->
    text("the C code calls ~ts, which has no fun among the stubs", [name(Function)]);
line({callback, {Function, {Class, Reason, _Stack}}}) ->
    text("the stub ~ts failed with ~tp:~0tp", [name(Function), Class, Reason]);
line({callback, {Function, Why}}) ->
    text("the stub ~ts gave no value: ~0tp", [name(Function), Why]);
line({in_call, Function}) ->
    text("the stub ~ts cannot use the library that is calling it", [name(Function)]);
line({other_process, Owner}) ->
    text(
        "only process ~p, which started the library, can use it; start it with {owner, none} "
        "for all to use it",
        [Owner]
    );
line(busy) ->
    "another process is in a call of this library; start one library for each process";
line({callback, Function, no_port}) ->
    text("the stub ~ts asks Erlang, which needs transport port", [name(Function)]);
line({callback, Function, Detail}) ->
    text("the stub ~ts gave a wrong value: ~ts", [name(Function), detail(Detail)]);
%% ---- start -----------------------------------------------------------------------------------
line({load, File, no_debug_info}) ->
    text("~ts has no debug information: build it with -g, or give its headers", [File]);
line({load, File, {dlerror, Text}}) ->
    text("cannot load ~ts: ~ts", [File, without(File, Text)]);
line({load, File, {debug_info, Text}}) ->
    text("cannot read the debug information of ~ts: ~ts", [File, Text]);
line({load, File, {protocol, Got}}) ->
    text(
        "~ts does not speak this version of the protocol (~0tp): build the native side again",
        [File, Got]
    );
line({reset, Method, not_in_nif}) ->
    text(
        "reset ~tp needs transport port: with nif use snapshot, reload, {calls, _} or none",
        [Method]
    );
line({not_started, Name}) ->
    text(
        "no library ~tp in this process: cb:start(~tp, Options) or cb:attach(Lib) comes first",
        [Name, Name]
    );
line({which_library, []}) ->
    "no library in this process: cb:start/2 or cb:attach/1 comes first";
line({which_library, Names}) ->
    text(
        "several libraries in this process (~ts): give the library as first argument",
        [names(Names)]
    );
line({bad_option, Option, Expected}) ->
    text("bad option ~0tp: expected ~ts", [Option, Expected]);
line({missing_option, Options}) ->
    text("missing option: one of ~ts is needed", [names(Options)]);
line({needs_port, What}) ->
    text("~0tp needs transport port", [What]);
line({compile, File, no_such_file}) ->
    text("no such file: ~ts", [File]);
line({compile, File, {no_such_program, Program}}) ->
    text("~ts cannot be compiled: no program ~ts in the path", [File, Program]);
line({compile, File, {failed, Text}}) ->
    text("~ts does not compile: ~ts", [File, Text]);
line({undefined, Names}) ->
    text(
        "undefined in the sources given: ~ts; add the sources or {libs, _} that have them, or "
        "{stubs, [{~ts, 0}]}",
        [names(Names), hd(Names)]
    );
line({stub, F, not_declared}) ->
    text("stub ~ts: no source given declares this function; include its header", [F]);
line({stub, F, {bad_value, Value}}) ->
    text(
        "stub ~ts: ~0tp is no C constant; a number, an enumerator, null, a binary or a fun "
        "would be right",
        [F, Value]
    );
line({stub, F, {unsupported_declaration, Text}}) ->
    text("stub ~ts: give the returned type a name by a typedef: ~ts", [F, Text]);
line({cache, File, Posix}) ->
    text("cannot write ~ts: ~ts", [File, file:format_error(Posix)]);
line({module_clash, Name, Where}) ->
    text(
        "the name ~tp is that of a module already (~tp): give another name, or {module, false}",
        [Name, Where]
    );
%% ---- journals and defects ----------------------------------------------------------------------
line({journal, File, not_a_journal}) ->
    text("~ts is not a journal", [File]);
line({journal, File, truncated}) ->
    text("the journal ~ts is truncated", [File]);
line({journal, File, Why}) ->
    text("the journal ~ts: ~0tp", [File, Why]);
line({keeper, Why}) ->
    text("the process that holds the library ended: ~0tp", [Why]);
line({bad_request, Request}) ->
    text("the bridge does not understand the request ~0tp", [Request]);
line(no_child) ->
    "the request was meant for a forked child that has ended";
line(no_snapshot) ->
    "there is no snapshot to restore";
line(no_memory) ->
    "not enough memory for the values of the request";
line(not_loaded) ->
    "no library is loaded";
line(already_loaded) ->
    "a library is loaded already";
line(Other) ->
    text("~0tp", [Other]).

%% ---- details -----------------------------------------------------------------------------------

detail({out_of_range, Type, Value}) -> text("~0tp is out of range for ~ts", [Value, name(Type)]);
detail({bad_type, Type, Value}) ->
    text("~0tp is no value for ~ts~ts", [Value, name(Type), hint(Type)]);
detail({bad_enumerator, Type, Value}) -> text("~0tp is no enumerator of ~ts", [Value, name(Type)]);
detail({unsupported_type, Type}) -> text("~ts is not supported", [name(Type)]);
detail(Other) -> line(Other).

hint(Type) ->
    case lists:last(unicode:characters_to_list(name(Type))) of
        $* -> ": null, {ptr, Type, Reference}, a list, a binary or a map would be right";
        _ -> ""
    end.

parameter('') -> "";
parameter(<<>>) -> "";
parameter(undefined) -> "";
parameter(Name) -> [" (", name(Name), ")"].

suggest([]) -> "";
suggest(Similar) -> ["; similar: ", names(Similar)].

names(Names) -> lists:join(", ", [name(Name) || Name <- Names]).

name(Name) when is_atom(Name) -> atom_to_binary(Name);
name(Name) when is_binary(Name) -> Name;
name(Name) -> text("~ts", [printable(Name)]).

printable(Name) ->
    case io_lib:printable_unicode_list(Name) of
        true -> Name;
        false -> io_lib:format("~0tp", [Name])
    end.

%% [limits, max, 3] as limits.max[3]
path([First | Rest]) when not is_integer(First) -> [step(First) | [member(Step) || Step <- Rest]];
path(Path) -> step(Path).

step(Step) when is_atom(Step); is_binary(Step) -> name(Step);
step(Step) -> name(Step).

member(Index) when is_integer(Index) -> text("[~b]", [Index]);
member(Member) -> [".", step(Member)].

call({Function, Args}) when is_list(Args) ->
    case is_atom(Function) orelse is_binary(Function) of
        true -> [name(Function), "(", lists:join(", ", [text("~0tp", [A]) || A <- Args]), ")"];
        false -> text("~0tp", [{Function, Args}])
    end;
call(In) ->
    text("~0tp", [In]).

place([]) -> "";
place([{Function, <<>>, _} | _]) ->
    text(", at ~ts", [Function]);
place([{Function, File, Line} | _]) ->
    text(", at ~ts (~ts:~b)", [Function, filename:basename(File), Line]).

address(#{addr := Addr}) when is_integer(Addr) -> text(" at address 0x~.16b", [Addr]);
address(_) -> "".

upper(Signal) -> string:uppercase(atom_to_binary(Signal)).

%% dlerror begins with the file name.
without(File, Text) ->
    Start = unicode:characters_to_binary([File, ": "]),
    case string:prefix(unicode:characters_to_binary(Text), Start) of
        nomatch -> Text;
        Rest -> Rest
    end.

s(1) -> "";
s(_) -> "s".

text(Format, Args) -> io_lib:format(Format, Args).

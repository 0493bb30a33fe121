%% @doc What AddressSanitizer and UBSan need: flags, and the environment of the port program.
%%
%% A library built with AddressSanitizer can only be loaded into a process that has its runtime
%% already, hence LD_PRELOAD. Leaks are not looked for: the process belongs to the bridge.
-module(cb_sanitizer).

-export([flags/1, link_flags/1, environment/1]).

-spec flags(cb_options:options()) -> [string()].
flags(#{sanitize := []}) ->
    [];
flags(#{sanitize := Kinds}) ->
    %% A build of ours stops at the first finding, so that the call that made it is known.
    ["-fsanitize=" ++ names(Kinds), "-fno-omit-frame-pointer", "-fno-sanitize-recover=all"].

names(Kinds) -> lists:append(lists:join(",", [atom_to_list(Kind) || Kind <- Kinds])).

-spec link_flags(cb_options:options()) -> [string()].
link_flags(#{sanitize := []}) ->
    [];
link_flags(#{sanitize := Kinds, compiler := {C, _}}) ->
    ["-fsanitize=" ++ names(Kinds) | ["-shared-libsan" || cb_compiler:is_clang(C)]].

-spec environment(cb_options:options()) -> [{string(), string()}].
environment(#{sanitize := []}) ->
    [];
environment(#{sanitize := Kinds, compiler := {C, _}}) ->
    Preload = [{"LD_PRELOAD", runtime(C)} || lists:member(address, Kinds)],
    [
        {"ASAN_OPTIONS", "abort_on_error=1:detect_leaks=0"},
        {"UBSAN_OPTIONS", "abort_on_error=1:print_stacktrace=1"}
        | Preload
    ].

%% clang 14 has a name with the machine in it, later ones may have one without.
runtime(Compiler) ->
    Names =
        case cb_compiler:is_clang(Compiler) of
            true -> ["libclang_rt.asan-x86_64.so", "libclang_rt.asan.so"];
            false -> ["libasan.so"]
        end,
    Outputs = [Output || Name <- Names, {ok, 0, Output} <- [ask(Compiler, Name)]],
    Found = lists:flatmap(fun lines/1, Outputs),
    case lists:filter(fun filelib:is_regular/1, Found) of
        [Runtime | _] -> Runtime;
        [] -> hd(Names)
    end.

ask(Compiler, Name) -> cb_compiler:run(Compiler, ["-print-file-name=" ++ Name]).

lines(Output) -> string:lexemes(unicode:characters_to_list(Output), "\n").

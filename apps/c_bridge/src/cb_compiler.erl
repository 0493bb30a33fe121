%% @doc Runs a compiler (or another tool of it) without a shell.
-module(cb_compiler).

-export([run/2, must/3, is_cxx/1, is_clang/1, for/2, errors/1]).
-export_type([reason/0]).

-type reason() ::
    {compile, file:filename(), no_such_file | {no_such_program, string()} | {failed, binary()}}.

-define(MOST_ERRORS, 5).

%% @doc What it printed, on standard output and error, and its exit status.
-spec run(string(), [string()]) -> {ok, 0..255, binary()} | {error, {no_such_program, string()}}.
run(Program, Args) ->
    case os:find_executable(Program) of
        false ->
            {error, {no_such_program, Program}};
        Exe ->
            %% Messages are read by this module and by cb_signatures: no translation of them.
            Env = [{"LC_ALL", "C"}, {"GCC_COLORS", ""}],
            Options = [{args, Args}, {env, Env}, stderr_to_stdout, exit_status, binary, hide, eof],
            collect(open_port({spawn_executable, Exe}, Options), [], none)
    end.

collect(Port, Output, Status) ->
    receive
        {Port, {data, Data}} ->
            collect(Port, [Output, Data], Status);
        {Port, {exit_status, Ended}} ->
            collect(Port, Output, Ended);
        {Port, eof} when Status =/= none ->
            done(Port, Output, Status);
        {Port, eof} ->
            receive
                {Port, {exit_status, Ended}} -> done(Port, Output, Ended)
            end
    end.

done(Port, Output, Status) ->
    true = port_close(Port),
    receive
        {'EXIT', Port, _} -> ok
    after 0 -> ok
    end,
    {ok, Status, iolist_to_binary(Output)}.

%% @doc Runs a compiler on behalf of File; anything but success is File's error.
-spec must(file:filename(), string(), [string()]) -> {ok, binary()} | {error, reason()}.
must(File, Program, Args) ->
    case run(Program, Args) of
        {ok, 0, Output} -> {ok, Output};
        {ok, _, Output} -> {error, {compile, File, {failed, errors(Output)}}};
        {error, Why} -> {error, {compile, File, Why}}
    end.

%% @doc The lines of a compiler's output that tell what is wrong.
-spec errors(binary()) -> binary().
errors(Output) ->
    Lines = binary:split(Output, <<"\n">>, [global, trim_all]),
    case [Line || Line <- Lines, binary:match(Line, <<"error">>) =/= nomatch] of
        [] -> join(Lines);
        Errors -> join(Errors)
    end.

join(Lines) -> iolist_to_binary(lists:join($\n, lists:sublist(Lines, ?MOST_ERRORS))).

-spec is_cxx(file:filename()) -> boolean().
is_cxx(File) ->
    Extensions = [".cpp", ".cc", ".cxx", ".C", ".hpp", ".hh", ".hxx"],
    lists:member(filename:extension(File), Extensions).

-spec is_clang(string()) -> boolean().
is_clang(Compiler) -> string:find(filename:basename(Compiler), "clang") =/= nomatch.

%% @doc The compiler for a file.
-spec for(file:filename(), {string(), string()}) -> string().
for(File, {C, Cxx}) ->
    case is_cxx(File) of
        true -> Cxx;
        false -> C
    end.

-module(cb_compile_tests).

-include_lib("eunit/include/eunit.hrl").

compile(Sources, Options) ->
    Files = [cb_sut:source(S) || S <- Sources],
    {ok, Parsed} = cb_options:parse([{c_src, Files}, {cache_dir, cb_sut:cache()} | Options]),
    cb_compile:library(compiled, Parsed).

with_directory(Test) ->
    Dir = cb_files:fresh_name("cb_compile_tests", ""),
    ok = filelib:ensure_dir(filename:join(Dir, "x")),
    try
        Test(Dir)
    after
        ok = file:del_dir_r(Dir)
    end.

compile_text(Dir, Text, Options) ->
    File = filename:join(Dir, "text.c"),
    ok = file:write_file(File, Text),
    {ok, Parsed} = cb_options:parse([{c_src, File}, {cache_dir, Dir} | Options]),
    cb_compile:library(text, Parsed).

the_same_sources_and_flags_give_the_same_library_test() ->
    {ok, #{file := File}} = compile(["arithmetic.c"], []),
    {ok, #{file := Again}} = compile(["arithmetic.c"], []),
    {ok, #{file := Other}} = compile(["arithmetic.c"], [{cflags, ["-DOTHER"]}]),
    ?assert(filelib:is_regular(File)),
    ?assertEqual(File, Again),
    ?assertNotEqual(File, Other).

a_changed_header_gives_another_library_test() ->
    with_directory(fun(Dir) ->
        Header = filename:join(Dir, "text.h"),
        Source = "#include \"text.h\"\nint f(void) { return N; }\n",
        ok = file:write_file(Header, "#define N 1\n"),
        {ok, #{file := One}} = compile_text(Dir, Source, []),
        ok = file:write_file(Header, "#define N 2\n"),
        {ok, #{file := Two}} = compile_text(Dir, Source, []),
        ?assertNotEqual(One, Two)
    end).

a_missing_source_is_named_test() ->
    {ok, Options} = cb_options:parse([{c_src, "no/such.c"}]),
    ?assertEqual(
        {error, {compile, "no/such.c", no_such_file}}, cb_compile:library(x, Options)
    ).

a_source_that_does_not_compile_is_named_with_its_line_test() ->
    with_directory(fun(Dir) ->
        {error, {compile, File, {failed, Text}}} = compile_text(Dir, "int f(void) {\n", []),
        ?assertEqual("text.c", filename:basename(File)),
        ?assertNotEqual(nomatch, binary:match(Text, <<"text.c:1:">>))
    end).

a_missing_header_is_an_error_of_the_source_test() ->
    with_directory(fun(Dir) ->
        ?assertMatch(
            {error, {compile, _, {failed, _}}}, compile_text(Dir, "#include <no_such.h>\n", [])
        )
    end).

a_missing_compiler_is_named_test() ->
    ?assertMatch(
        {error, {compile, _, {no_such_program, "no-such-cc"}}},
        compile(["arithmetic.c"], [{compiler, {"no-such-cc", "no-such-c++"}}])
    ).

all_undefined_externals_are_listed_in_one_error_test() ->
    {error, {undefined, Names}} = compile(["device.c"], []),
    ?assertEqual(
        [
            <<"best_of">>,
            <<"fill_reading">>,
            <<"label_of">>,
            <<"mode_of">>,
            <<"read_raw">>,
            <<"report">>,
            <<"scale_of">>
        ],
        Names
    ).

stubs() ->
    Zero = fun(_) -> 0 end,
    [
        {best_of, Zero},
        {fill_reading, Zero},
        {label_of, <<"a\"b">>},
        {mode_of, 'ON'},
        {read_raw, 5},
        {report, ok},
        {scale_of, 0.5}
    ].

stubs_define_them_test() ->
    ?assertMatch({ok, #{file := _}}, compile(["device.c"], [{stubs, stubs()}])).

a_stub_that_nobody_declares_is_refused_test() ->
    ?assertEqual(
        {error, {stub, no_such_function, not_declared}},
        compile(["device.c"], [{stubs, [{no_such_function, 1} | stubs()]}])
    ).

a_stub_value_that_is_no_constant_is_refused_test() ->
    ?assertEqual(
        {error, {stub, read_raw, {bad_value, {1, 2}}}},
        compile(["device.c"], [{stubs, [{read_raw, {1, 2}}]}])
    ).

a_stub_value_out_of_range_is_refused_test() ->
    ?assertMatch(
        {error, {compile, _, {failed, _}}},
        compile(["device.c"], [{stubs, [{small, 300} | stubs()]}])
    ).

a_stub_with_an_unnamed_function_type_is_refused_test() ->
    ?assertMatch(
        {error, {stub, handler_of, {unsupported_declaration, _}}},
        compile(["device.c"], [{stubs, [{handler_of, null} | stubs()]}])
    ).

libraries_and_directories_reach_the_linker_test() ->
    with_directory(fun(Dir) ->
        Text = "extern int plain_add(int, int);\nint f(void) { return plain_add(1, 2); }\n",
        Plain = cb_sut:source("plain.c"),
        So = filename:join(Dir, "libplain.so"),
        {ok, 0, _} = cb_compiler:run("gcc", ["-shared", "-fPIC", "-o", So, Plain]),
        ?assertMatch({error, {undefined, [<<"plain_add">>]}}, compile_text(Dir, Text, [])),
        ?assertMatch(
            {ok, _}, compile_text(Dir, Text, [{lib_dirs, [Dir]}, {libs, ["plain"]}])
        )
    end).

file_names_are_not_read_by_a_shell_test() ->
    with_directory(fun(Dir) ->
        File = filename:join(Dir, "a b;$(touch x)'.c"),
        ok = file:write_file(File, "int f(void) { return 1; }\n"),
        {ok, Options} = cb_options:parse([{c_src, File}, {cache_dir, Dir}]),
        ?assertMatch({ok, _}, cb_compile:library(odd, Options))
    end).

headers_give_an_object_with_the_declared_symbols_test() ->
    with_directory(fun(Dir) ->
        So = filename:join(Dir, "libplain.so"),
        Plain = cb_sut:source("plain.c"),
        {ok, 0, _} = cb_compiler:run("gcc", ["-shared", "-fPIC", "-o", So, Plain]),
        {ok, Options} = cb_options:parse([
            {so, So}, {headers, [cb_sut:source("plain.h")]}, {cache_dir, Dir}
        ]),
        {ok, #{load_options := #{signatures := Object}}} = cb_compile:library(plain, Options),
        {ok, 0, Symbols} = cb_compiler:run("nm", [Object]),
        ?assertNotEqual(nomatch, binary:match(Symbols, <<"cb_sig_plain_add">>)),
        ?assertNotEqual(nomatch, binary:match(Symbols, <<"cb_sig_plain_counter">>)),
        ?assertEqual(nomatch, binary:match(Symbols, <<"not_in_header">>))
    end).

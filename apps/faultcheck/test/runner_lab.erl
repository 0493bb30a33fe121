%% Whole runs of the runner in this VM, with what they print, for its tests: properties of
%% faultcheck_unruly, a directory for each test.
-module(runner_lab).

-export([temporary/0, clean/1, fresh/1, run/2, capture/2, capture/3, contains/2]).

-define(M, "faultcheck_unruly").

temporary() ->
    Dir = cb_files:fresh_name("faultcheck-runner", ""),
    ok = filelib:ensure_dir(filename:join(Dir, "x")),
    true = os:putenv("FAULTCHECK_TEST_DIR", filename:dirname(source())),
    Dir.

clean(Dir) ->
    true = os:unsetenv("FAULTCHECK_CASES"),
    ok = file:del_dir_r(Dir).

%% Every test has a directory of its own.
fresh(Root) ->
    Dir = filename:join(Root, integer_to_list(erlang:unique_integer([positive]))),
    ok = filelib:ensure_dir(filename:join([Dir, "test", "x"])),
    ok = file:write_file(filename:join([Dir, "test", ?M ".erl"]), ""),
    true = os:putenv("FAULTCHECK_CASES", filename:join(Dir, "cases")),
    Dir.

source() -> proplists:get_value(source, faultcheck_unruly:module_info(compile)).

run(Words, Dir) ->
    capture(["-m", ?M | Words], Dir).

capture(Words, Dir) ->
    capture(fun faultcheck_runner:run/1, Words, Dir).

capture(Fun, Words, Dir) ->
    {ok, Options} = faultcheck_options:parse(["-d", filename:join(Dir, "test") | Words]),
    Self = self(),
    Status = Fun(#{
        options => Options,
        places => [{filename:join(Dir, "test"), filename:dirname(code:which(faultcheck_unruly))}],
        paths => code:get_path(),
        base_dir => filename:join(Dir, "base"),
        cover_dirs => [filename:join(Dir, "covered")],
        command => "faultcheck proper",
        replay => "faultcheck replay",
        terminal => false,
        print => fun(Text) ->
            Self ! {printed, Text},
            ok
        end
    }),
    {Status, printed([])}.

printed(Texts) ->
    receive
        {printed, Text} -> printed([Text | Texts])
    after 0 ->
        unicode:characters_to_list(lists:reverse(Texts))
    end.

contains(Part, Text) ->
    case string:find(Text, Part) of
        nomatch -> error({missing, Part, {in, Text}});
        _ -> ok
    end.

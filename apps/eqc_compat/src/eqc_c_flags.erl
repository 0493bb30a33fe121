%% @doc The options of eqc_c:start/2 as those of cb:start/2.
-module(eqc_c_flags).

-export([options/2]).

-type option() :: {atom(), term()}.

%% @doc `{cppflags, String}' holds whatever a compiler's command line may hold.
-spec options(module(), [option()]) -> {ok, [cb_options:option()]} | {error, term()}.
options(Mod, Options) ->
    try
        Sources = case proplists:get_value(c_src, Options) of
                      undefined -> [atom_to_list(Mod) ++ ".c"];
                      Given -> sources(Given)
                  end,
        Flags = lists:append([words(Value) || {Key, Value} <- Options,
                                              lists:member(Key, [cppflags, cflags, ldflags])]),
        Rest = [passed_on(Option) || {Key, _} = Option <- Options,
                                     not lists:member(Key, [c_src, cppflags, cflags, ldflags])],
        {ok, [{c_src, Sources} | flags(Flags)] ++ Rest}
    catch
        throw:{bad_option, _, _} = Reason -> {error, Reason}
    end.

%% cb:start/2 checks these.
passed_on({_, _} = Option) -> Option.

sources([File | _] = Files) when is_list(File); is_binary(File) -> Files;
sources(Text) -> words(Text).

%% At blanks outside quotes; a backslash takes the next character as it is.
words(Text) when is_binary(Text) ->
    words(unicode:characters_to_list(Text));
words(Text) when is_list(Text) ->
    case io_lib:printable_unicode_list(Text) of
        true -> words(Text, none, [], []);
        false -> throw({bad_option, Text, "a string"})
    end;
words(Other) ->
    throw({bad_option, Other, "a string"}).

words([], none, Word, Words) -> lists:reverse(ended(Word, Words));
words([], _Quote, _Word, Words) ->
    throw({bad_option, lists:reverse(Words), "a string with each quote closed"});
words([$\\, C | Text], Quote, Word, Words) -> words(Text, Quote, [C | Word], Words);
words([Quote | Text], Quote, Word, Words) -> words(Text, none, Word, Words);
words([C | Text], none, Word, Words) when C =:= $"; C =:= $' -> words(Text, C, Word, Words);
words([C | Text], none, Word, Words) when C =:= $\s; C =:= $\t; C =:= $\n ->
    words(Text, none, [], ended(Word, Words));
words([C | Text], Quote, Word, Words) -> words(Text, Quote, [C | Word], Words).

ended([], Words) -> Words;
ended(Word, Words) -> [lists:reverse(Word) | Words].

%% -I, -L and -l also with their value in the next word.
flags(Words) ->
    Sorted = sort(Words),
    [{Key, Values} || Key <- [include_dirs, lib_dirs, libs, ldflags, cflags],
                      Values <- [[V || {K, V} <- Sorted, K =:= Key]], Values =/= []]
        ++ [{coverage, filename:absname("coverage")} || lists:keymember(coverage, 1, Sorted)].

sort([[$-, Letter], Value | Words]) when Letter =:= $I; Letter =:= $L; Letter =:= $l ->
    sort([[$-, Letter | Value] | Words]);
sort(["-I" ++ Dir | Words]) -> [{include_dirs, Dir} | sort(Words)];
sort(["-L" ++ Dir | Words]) -> [{lib_dirs, Dir} | sort(Words)];
sort(["-lgcov" | Words]) -> [{coverage, "-lgcov"} | sort(Words)];
sort(["-l" ++ Name | Words]) -> [{libs, Name} | sort(Words)];
sort(["-Wl," ++ _ = Flag | Words]) -> [{ldflags, Flag} | sort(Words)];
sort([Flag | Words]) when Flag =:= "--coverage"; Flag =:= "-coverage"; Flag =:= "-fprofile-arcs";
                          Flag =:= "-ftest-coverage" ->
    [{coverage, Flag} | sort(Words)];
sort([Flag | Words]) -> [{cflags, Flag} | sort(Words)];
sort([]) -> [].

%% @doc Every option of `rebar3 proper' and `faultcheck proper': one table of names, types,
%% defaults and help, and the one parser for both.
%%
%% ```
%% {ok, #{numtests := 500, prop := [prop_a, prop_b]}} =
%%     faultcheck_options:parse(["-n", "500", "--prop", "prop_a,prop_b"]).
%% '''
-module(faultcheck_options).

-export([parse/1, check/1, proper/1, arguments/1, getopt/0, help/0]).
-export_type([options/0]).

-type options() :: #{atom() => term()}.
-type type() ::
    boolean
    | pos_integer
    | non_neg_integer
    | probability
    | string
    | {list, string | atom}
    | seed
    | {one_of, [atom()]}.
-type option() :: {
    Key :: atom(),
    Short :: char() | undefined,
    type(),
    Default :: term(),
    %% how PropEr calls it: {Key, Value}, a bare atom when true, or not at all
    pair | flag | ours,
    Help :: string()
}.

-define(SEED_LIMIT, 16#FFFFFFFF).

-spec table() -> [option()].
table() ->
    [
        {dir, $d, {list, string}, ["test"], ours,
            "directory of the properties in each application and in the root"},
        {module, $m, {list, atom}, undefined, ours, "modules to test, separated by commas"},
        {prop, $p, {list, atom}, undefined, ours, "properties to test, separated by commas"},
        {numtests, $n, pos_integer, undefined, pair, "tests per property (PropEr: 100)"},
        {search_steps, $s, pos_integer, undefined, pair,
            "steps of a search in a targeted property"},
        {cover, $c, boolean, false, ours, "write cover data for `rebar3 cover'"},
        {verbose, $v, boolean, true, ours, "show what properties and PropEr print"},
        {retry, undefined, boolean, false, ours, "run the last counterexamples again"},
        {regressions, undefined, boolean, false, ours, "run the stored counterexamples"},
        {store, undefined, boolean, false, ours,
            "add the last counterexamples to the regression file"},
        {long_result, undefined, boolean, undefined, ours,
            "show counterexamples instead of `false' in the summary"},
        {start_size, undefined, non_neg_integer, undefined, pair, "size of the first test"},
        {max_size, undefined, non_neg_integer, undefined, pair, "largest size of a test"},
        {max_shrinks, undefined, non_neg_integer, undefined, pair,
            "successful shrinking steps, at most"},
        {noshrink, undefined, boolean, undefined, flag, "do not shrink"},
        {constraint_tries, undefined, pos_integer, undefined, pair,
            "tries to satisfy a ?SUCHTHAT"},
        {spec_timeout, undefined, pos_integer, undefined, pair,
            "milliseconds after which a spec test fails"},
        {any_to_integer, undefined, boolean, undefined, flag, "any() generates integers"},
        {sys_config, undefined, string, undefined, ours,
            "configuration file to set before the tests"},
        {seed, undefined, seed, undefined, ours, "seed of the run, as a failure prints it"},
        {transport, undefined, {one_of, [nif, port]}, undefined, ours,
            "how C code is called, whatever the model asks for"},
        {time, undefined, pos_integer, undefined, ours, "seconds to go on testing each property"},
        {timeout, undefined, pos_integer, undefined, ours,
            "milliseconds without progress that count as a hang (10000)"},
        {workers, undefined, pos_integer, undefined, ours,
            "VMs that run tests side by side, with the same results (1)"},
        {boundary_bias, undefined, probability, undefined, ours,
            "probability of a limit in place of a value in a range (0)"},
        {max_runs, undefined, pos_integer, undefined, ours,
            "runs in each guided search (2000)"},
        {watch, undefined, boolean, false, ours,
            "show each test in the visualizer while it runs, if its model can"},
        {stats, undefined, boolean, false, ours, "statistics of commands, faults and lengths"},
        {junit, undefined, string, undefined, ours, "file for a JUnit XML report"},
        {json, undefined, string, undefined, ours, "file for a JSON report"}
    ].

%% @doc Reads a command line. The error is one line for the user.
-spec parse([string()]) -> {ok, options()} | {error, string()}.
parse(Args) ->
    Defaults = maps:from_list([
        {Key, Default}
     || {Key, _, _, Default, _, _} <- table(), Default =/= undefined
    ]),
    parse(Args, Defaults).

parse([], Options) ->
    {ok, Options};
parse(["--" ++ Long | Args], Options) when Long =/= [] ->
    case string:split(Long, "=") of
        [Name] -> long(Name, Args, Options);
        [Name, Value] -> long(Name, [{given, Value} | Args], Options)
    end;
parse([[$-, Short | Rest] | Args], Options) when Short =/= $- ->
    case lists:keyfind(Short, 2, table()) of
        false -> unknown([$-, Short]);
        Option when Rest =:= [] -> value(Option, Args, Options);
        Option -> value(Option, [{given, Rest} | Args], Options)
    end;
parse([Word | _], _Options) ->
    {error, "unexpected argument " ++ Word ++ "; options begin with - (see --help)"}.

long(Name, Args, Options) ->
    case [O || O <- table(), lists:member(Name, [atom_to_list(element(1, O)), word(O)])] of
        [Option] -> value(Option, Args, Options);
        [] -> unknown("--" ++ Name)
    end.

unknown(Name) ->
    Known = ["--" ++ word(O) || O <- table()],
    {error, "unknown option " ++ Name ++ faultcheck_suggest:phrase(Name, Known)}.

value({Key, _, boolean, _, _, _}, Args, Options) ->
    case Args of
        [{given, Text} | Rest] -> bool(Key, Text, Rest, Options);
        ["true" | Rest] -> parse(Rest, Options#{Key => true});
        ["false" | Rest] -> parse(Rest, Options#{Key => false});
        _ -> parse(Args, Options#{Key => true})
    end;
value({Key, _, Type, _, _, _}, [], _Options) ->
    {error, lists:concat(["option --", word(Key), " needs a value: ", describe(Type)])};
value({Key, _, Type, _, _, _}, [Arg | Rest], Options) ->
    case convert(Type, text(Arg)) of
        {ok, Value} -> checked(Key, Value, Rest, Options);
        error -> bad(Key, Type, text(Arg))
    end.

text({given, Text}) -> Text;
text(Text) -> Text.

bool(Key, "true", Rest, Options) -> parse(Rest, Options#{Key => true});
bool(Key, "false", Rest, Options) -> parse(Rest, Options#{Key => false});
bool(Key, Text, _Rest, _Options) -> bad(Key, boolean, Text).

%% The versions in which the seed was printed go beside it.
checked(seed, {Seed, none}, Rest, Options) ->
    parse(Rest, Options#{seed => Seed});
checked(seed, {Seed, Versions}, Rest, Options) ->
    parse(Rest, Options#{seed => Seed, seed_versions => Versions});
checked(Key, Value, Rest, Options) ->
    parse(Rest, Options#{Key => Value}).

bad(Key, Type, Text) ->
    {error, lists:concat(["option --", word(Key), " must be ", describe(Type), ", not ", Text])}.

describe(boolean) -> "true or false";
describe(pos_integer) -> "a whole number from 1";
describe(non_neg_integer) -> "a whole number from 0";
describe(probability) -> "a number from 0 to 1";
describe(seed) -> lists:concat(["a whole number from 0 to ", ?SEED_LIMIT, " as it was printed"]);
describe(string) -> "a text";
describe({list, _}) -> "names separated by commas";
describe({one_of, Atoms}) -> lists:concat(lists:join(" or ", Atoms)).

convert(pos_integer, Text) -> number(Text, 1);
convert(non_neg_integer, Text) -> number(Text, 0);
convert(probability, Text) -> probability(Text);
convert(seed, Text) -> seed(string:split(Text, "@"));
convert(string, "") -> error;
convert(string, Text) -> {ok, Text};
convert({one_of, Atoms}, Text) -> one_of([A || A <- Atoms, atom_to_list(A) =:= Text]);
convert({list, Item}, Text) -> items(Item, string:lexemes(Text, ", ")).

number(Text, Least) ->
    case string:to_integer(Text) of
        {N, ""} when is_integer(N), N >= Least -> {ok, N};
        _ -> error
    end.

probability(Text) ->
    case {string:to_float(Text), string:to_integer(Text)} of
        {{P, ""}, _} when is_float(P), P >= 0, P =< 1 -> {ok, P};
        {_, {P, ""}} when P =:= 0; P =:= 1 -> {ok, P};
        _ -> error
    end.

%% `Seed' or `Seed@FaultCheck,PropEr,OTP'.
seed([Text | Versions]) ->
    case {number(Text, 0), [string:lexemes(V, ",") || V <- Versions]} of
        {{ok, Seed}, []} when Seed =< ?SEED_LIMIT ->
            {ok, {Seed, none}};
        {{ok, Seed}, [[F, P, O]]} when Seed =< ?SEED_LIMIT ->
            {ok, {Seed, #{faultcheck => F, proper => P, otp => O}}};
        _ ->
            error
    end.

one_of([Atom]) -> {ok, Atom};
one_of([]) -> error.

items(_Item, []) -> error;
items(string, Items) -> {ok, Items};
items(atom, Items) -> {ok, [list_to_atom(I) || I <- Items]}.

%% @doc Options that came from a `proper_opts' list of rebar.config, as this table understands
%% them. Unknown entries are an error like those of the command line.
-spec check([term()]) -> {ok, options()} | {error, string()}.
check(Entries) ->
    check(Entries, #{}).

check([], Options) ->
    {ok, Options};
check([Key | Rest], Options) when is_atom(Key) ->
    check([{Key, true} | Rest], Options);
check([{Key, Value} | Rest], Options) when is_atom(Key) ->
    case lists:keyfind(Key, 1, table()) of
        false ->
            unknown(atom_to_list(Key));
        {_, _, Type, _, _, _} ->
            case valid(Type, Value) of
                true -> check(Rest, Options#{Key => Value});
                false -> bad(Key, Type, lists:flatten(io_lib:format("~0tp", [Value])))
            end
    end;
check([Other | _], _Options) ->
    {error, lists:flatten(io_lib:format("not an option: ~0tp", [Other]))}.

valid(boolean, V) -> is_boolean(V);
valid(pos_integer, V) -> is_integer(V) andalso V >= 1;
valid(non_neg_integer, V) -> is_integer(V) andalso V >= 0;
valid(probability, V) -> is_number(V) andalso V >= 0 andalso V =< 1;
valid(seed, V) -> is_integer(V) andalso V >= 0 andalso V =< ?SEED_LIMIT;
valid(string, V) -> io_lib:printable_unicode_list(V);
valid({one_of, Atoms}, V) -> lists:member(V, Atoms);
valid({list, atom}, V) -> is_list(V) andalso lists:all(fun is_atom/1, V);
valid({list, string}, V) -> is_list(V) andalso lists:all(fun io_lib:printable_unicode_list/1, V).

%% @doc The options that PropEr is told, in its own terms.
-spec proper(options()) -> [term()].
proper(Options) ->
    lists:append([
        proper(Key, Kind, maps:get(Key, Options, undefined))
     || {Key, _, _, _, Kind, _} <- table()
    ]).

proper(_Key, _Kind, undefined) -> [];
proper(Key, pair, Value) -> [{Key, Value}];
proper(Key, flag, true) -> [Key];
proper(_Key, flag, false) -> [];
proper(_Key, ours, _) -> [].

%% @doc The command line words for what a run depends on: tests, sizes, shrinking, transport.
-spec arguments(options()) -> [string()].
arguments(Options) ->
    Keys = [Key || {Key, _, _, _, Kind, _} <- table(), Kind =/= ours] ++
        [dir, transport, time, timeout, sys_config, boundary_bias, max_runs],
    lists:append([arguments(Key, maps:get(Key, Options)) || Key <- Keys, set(Key, Options)]).

set(Key, Options) ->
    {_, _, _, Default, _, _} = lists:keyfind(Key, 1, table()),
    maps:get(Key, Options, undefined) =/= Default.

arguments(Key, true) -> [lists:concat(["--", Key])];
arguments(Key, [[_ | _] | _] = Names) -> arguments(Key, lists:append(lists:join(",", Names)));
arguments(Key, Value) -> ["--" ++ word(Key), written(Value)].

written(Value) when is_float(Value) -> float_to_list(Value, [short]);
written(Value) -> lists:concat([Value]).

%% The word of an option; those of PropEr's plugin have underscores.
word(boundary_bias) -> "boundary-bias";
word(Key) when is_atom(Key) -> atom_to_list(Key);
word(Option) -> word(element(1, Option)).

%% @doc The table as rebar3 wants it for `rebar3 help proper'.
-spec getopt() -> [{atom(), char() | undefined, string(), atom(), string()}].
getopt() ->
    [{Key, S, word(Key), getopt_type(Type), Help} || {Key, S, Type, _, _, Help} <- table()].

getopt_type(boolean) -> boolean;
getopt_type(pos_integer) -> integer;
getopt_type(non_neg_integer) -> integer;
getopt_type(_) -> string.

-spec help() -> string().
help() ->
    lists:flatten([help_line(O) || O <- table()]).

help_line({Key, Short, Type, Default, _, Help}) ->
    Name = [[[$-, Short, $,, $\s] || Short =/= undefined], "--", word(Key), arg(Type)],
    Shown = [[" [", shown(Default), "]"] || Default =/= undefined],
    io_lib:format("  ~-28ts~ts~ts~n", [Name, Help, Shown]).

arg(boolean) -> "";
arg({one_of, Atoms}) -> [" ", lists:join("|", [atom_to_list(A) || A <- Atoms])];
arg({list, _}) -> " A,B";
arg(string) -> " TEXT";
arg(seed) -> " SEED";
arg(probability) -> " P";
arg(_) -> " N".

shown(Default) when is_atom(Default) -> atom_to_list(Default);
shown([Text]) -> Text.

%% @doc The LCM message types: what priv/lcm/*.lcm (lcm/*.lcm of the clone) says, as terms.
%%
%% A type has fields in order, a fingerprint as LCM's hash rules give it, and the number of bytes
%% that any value of it takes at least, by which a decoder knows that a count cannot be true.
%% schema/0 reads the files once in a VM's life; parse/1 is the pure part.
-module(replay_lcm_type).

-export([schema/0, struct/1, named/1, min_size/1, parse/1]).
-export_type([name/0, base/0, dimension/0, field/0, struct/0, schema/0]).

-type name() :: atom().
-type base() :: int8_t | int16_t | int32_t | int64_t | byte | boolean | float | double | string
              | {struct, name()}.
%% A fixed size, or the member before it that says how many; only a first dimension may be a member.
-type dimension() :: pos_integer() | name().
-type field() :: {name(), base(), [dimension()]}.
-type struct() :: #{
    name := name(),
    fields := [field()],
    %% member => array whose length it is
    counts := #{name() => name()},
    fingerprint := non_neg_integer(),
    %% bytes without the fingerprint
    min_size := non_neg_integer()
}.
-type schema() :: #{name() => struct()}.

-define(KEY, {?MODULE, schema}).

%% @doc Every type of this project.
-spec schema() -> schema().
schema() ->
    case persistent_term:get(?KEY, undefined) of
        undefined ->
            {Schema, _} = load(),
            Schema;
        {Schema, _} ->
            Schema
    end.

%% @doc One type; an unknown name is the caller's mistake.
-spec struct(name()) -> struct().
struct(Name) ->
    maps:get(Name, schema()).

%% @doc The type with a fingerprint.
-spec named(Fingerprint :: non_neg_integer()) -> {ok, name()} | error.
named(Fingerprint) ->
    _ = schema(),
    {_, Names} = persistent_term:get(?KEY),
    maps:find(Fingerprint, Names).

%% @doc How many bytes any value of a type takes at least.
-spec min_size(base()) -> non_neg_integer().
min_size({struct, Name}) -> maps:get(min_size, struct(Name));
min_size(Base) -> min_base(Base, #{}, []).

load() ->
    Dir = filename:join(priv_dir(), "lcm"),
    Files = filelib:wildcard(filename:join(Dir, "*.lcm")),
    case parse([{filename:basename(File), contents(File)} || File <- Files]) of
        {ok, Schema} when map_size(Schema) > 0 ->
            Names = maps:from_list([{F, N} || {N, #{fingerprint := F}} <- maps:to_list(Schema)]),
            persistent_term:put(?KEY, {Schema, Names}),
            {Schema, Names};
        {ok, _} ->
            error({replay, ["no LCM types in ", Dir]});
        {error, Line} ->
            error({replay, Line})
    end.

contents(File) ->
    {ok, Bytes} = file:read_file(File),
    Bytes.

priv_dir() ->
    case code:priv_dir(replay) of
        {error, bad_name} ->
            filename:join(filename:dirname(filename:dirname(code:which(?MODULE))), "priv");
        Dir ->
            Dir
    end.

%% @doc The types of some files of one package, each {name for messages, text}. Structures only, no
%% constants and enumerations.
-spec parse([{string(), binary()}]) -> {ok, schema()} | {error, Line :: string()}.
parse(Files) ->
    try
        Parsed = maps:from_list([S || {File, Text} <- Files, S <- file(File, tokens(File, Text))]),
        {ok, maps:map(fun(Name, Fields) -> finish(Name, Fields, Parsed) end, Parsed)}
    catch
        throw:{bad_type, Line} -> {error, lists:flatten(Line)}
    end.

%% ---- Tokens ----

tokens(File, Text) ->
    Bare = re:replace(Text, "//[^\n]*|/\\*.*?\\*/", " ", [global, dotall, {return, binary}]),
    Word = "\\s*([A-Za-z_][A-Za-z_0-9.]*|[0-9]+|[^\\sA-Za-z_0-9])",
    case re:run(Bare, Word, [global, {capture, [1], list}]) of
        {match, Words} -> lists:append(Words);
        nomatch -> bad(File, "nothing in it", [])
    end.

file(File, ["package", _Package, ";" | Rest]) -> structs(File, Rest);
file(File, _) -> bad(File, "expected `package NAME;' first", []).

structs(_File, []) ->
    [];
structs(File, ["struct", Name, "{" | Rest]) ->
    {Fields, More} = fields(File, Rest, []),
    [{list_to_atom(Name), Fields} | structs(File, More)];
structs(File, [Word | _]) ->
    bad(File, "expected `struct NAME {', found `~ts'", [Word]).

fields(_File, ["}" | Rest], Fields) ->
    {lists:reverse(Fields), Rest};
fields(File, [Type, Name | Rest], Fields) ->
    {Dimensions, More} = dimensions(File, Rest, []),
    fields(File, More, [{list_to_atom(Name), base(Type), Dimensions} | Fields]);
fields(File, _, _) ->
    bad(File, "expected `TYPE NAME;' or `}'", []).

dimensions(_File, [";" | Rest], Dimensions) ->
    {lists:reverse(Dimensions), Rest};
dimensions(File, ["[", Size, "]" | Rest], Dimensions) ->
    dimensions(File, Rest, [dimension(File, Size, Dimensions) | Dimensions]);
dimensions(File, Rest, _) ->
    bad(File, "expected `;' or `[SIZE]', found `~ts'", [lists:join(" ", lists:sublist(Rest, 3))]).

dimension(File, Size, Before) ->
    case string:to_integer(Size) of
        {N, ""} when N > 0 -> N;
        {error, _} when Before =:= [] -> list_to_atom(Size);
        _ -> bad(File, "`[~ts]' is no size that is supported here", [Size])
    end.

base("int8_t") -> int8_t;
base("int16_t") -> int16_t;
base("int32_t") -> int32_t;
base("int64_t") -> int64_t;
base("byte") -> byte;
base("boolean") -> boolean;
base("float") -> float;
base("double") -> double;
base("string") -> string;
base(Name) -> {struct, list_to_atom(lists:last(string:split(Name, ".", all)))}.

-spec bad(string(), string(), [term()]) -> no_return().
bad(File, Format, Args) ->
    throw({bad_type, [File, ": " | io_lib:format(Format, Args)]}).

%% ---- What follows from the fields ----

finish(Name, Fields, All) ->
    #{
        name => Name,
        fields => Fields,
        counts => counts(Name, Fields),
        fingerprint => fingerprint(Name, All, []),
        min_size => min_struct(Name, All, [])
    }.

counts(Name, Fields) ->
    Pairs = [{Count, Array} || {Array, _, [Count | _]} <- Fields, is_atom(Count)],
    lists:foreach(fun(Pair) -> check_count(Name, Pair, Fields) end, Pairs),
    Counts = maps:from_list(Pairs),
    map_size(Counts) =:= length(Pairs) orelse
        bad(atom_to_list(Name), "two arrays share a count", []),
    Counts.

%% A count is an integer that comes before the array.
check_count(Name, {Count, Array}, Fields) ->
    Before = lists:takewhile(fun({Field, _, _}) -> Field =/= Array end, Fields),
    case lists:keyfind(Count, 1, Before) of
        {Count, Base, []} when Base =:= int8_t; Base =:= int16_t; Base =:= int32_t;
                               Base =:= int64_t ->
            ok;
        _ ->
            bad(atom_to_list(Name), "`~ts' of `~ts' is no integer before it", [Count, Array])
    end.

%% The hash of a type: of its own members, plus those of the types inside, rotated left by one. A
%% type that contains itself counts as 0 there.
fingerprint(Name, All, Parents) ->
    case lists:member(Name, Parents) of
        true ->
            0;
        false ->
            Fields = fields_of(Name, All),
            Inner = [fingerprint(Inside, All, [Name | Parents])
                     || {_, {struct, Inside}, _} <- Fields],
            rotate(wrap(lists:sum([base_hash(Fields) | Inner])))
    end.

fields_of(Name, All) ->
    case All of
        #{Name := Fields} -> Fields;
        #{} -> bad(atom_to_list(Name), "no such type", [])
    end.

wrap(V) -> V band 16#ffffffffffffffff.

rotate(V) -> wrap(V bsl 1) bor (V bsr 63).

base_hash(Fields) ->
    lists:foldl(fun hash_field/2, 16#12345678, Fields).

hash_field({Name, Base, Dimensions}, V0) ->
    V1 = hash_text(atom_to_list(Name), V0),
    V2 = case Base of
        {struct, _} -> V1;
        _ -> hash_text(atom_to_list(Base), V1)
    end,
    lists:foldl(fun hash_dimension/2, hash(length(Dimensions), V2), Dimensions).

hash_dimension(N, V) when is_integer(N) -> hash_text(integer_to_list(N), hash(0, V));
hash_dimension(Count, V) -> hash_text(atom_to_list(Count), hash(1, V)).

hash_text(Text, V) ->
    lists:foldl(fun hash/2, hash(length(Text), V), Text).

%% One byte; the shift to the right keeps the sign.
hash(Byte, V) ->
    <<Signed:64/signed>> = <<V:64>>,
    wrap(((V bsl 8) bxor (Signed bsr 55)) + Byte).

min_struct(Name, All, Parents) ->
    lists:member(Name, Parents) andalso bad(atom_to_list(Name), "contains itself", []),
    lists:sum([min_field(F, All, [Name | Parents]) || F <- fields_of(Name, All)]).

min_field({_, Base, Dimensions}, All, Parents) ->
    Size = lists:foldl(fun times/2, 1, Dimensions),
    Size * min_base(Base, All, Parents).

times(N, Product) when is_integer(N) -> N * Product;
times(_Count, _Product) -> 0.

min_base({struct, Name}, All, Parents) -> min_struct(Name, All, Parents);
min_base(int16_t, _, _) -> 2;
min_base(Base, _, _) when Base =:= int32_t; Base =:= float -> 4;
min_base(Base, _, _) when Base =:= int64_t; Base =:= double -> 8;
%% a length and a NUL
min_base(string, _, _) -> 5;
min_base(Base, _, _) when Base =:= int8_t; Base =:= byte; Base =:= boolean -> 1.

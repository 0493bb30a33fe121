%% @doc JSON (RFC 8259) to and from Erlang terms.
%%
%% Objects are maps with binary keys, strings binaries; `null', `true' and `false' atoms. What is
%% encoded may also have atoms and strings as keys, `{text, Chardata}' as strings, and a list of
%% pairs `{object, [{Key, Value}]}' where the order of the keys matters.
-module(faultcheck_json).

-export([encode/1, pretty/1, decode/1]).
-export_type([json/0, decoded/0]).

-type json() ::
    null
    | boolean()
    | number()
    | binary()
    | atom()
    | {text, unicode:chardata()}
    | [json()]
    | #{atom() | binary() => json()}
    | {object, [{atom() | binary(), json()}]}.
-type decoded() :: null | boolean() | number() | binary() | [decoded()] | #{binary() => decoded()}.

-spec encode(json()) -> binary().
encode(Json) -> iolist_to_binary(value(Json, none)).

%% @doc The same, an entry a line and a line feed at the end, to be read by people.
-spec pretty(json()) -> binary().
pretty(Json) -> iolist_to_binary([value(Json, 0), $\n]).

value(null, _) -> <<"null">>;
value(true, _) -> <<"true">>;
value(false, _) -> <<"false">>;
value(Atom, _) when is_atom(Atom) -> string(atom_to_binary(Atom, utf8));
value(N, _) when is_integer(N) -> integer_to_binary(N);
value(F, _) when is_float(F) -> float_text(F);
value(Text, _) when is_binary(Text) -> string(Text);
value({text, Text}, _) -> string(unicode:characters_to_binary(Text));
value(List, Indent) when is_list(List) ->
    block($[, [value(V, deeper(Indent)) || V <- List], $], Indent);
value(Map, Indent) when is_map(Map) ->
    value({object, lists:sort([{key(K), V} || {K, V} <- maps:to_list(Map)])}, Indent);
value({object, Pairs}, Indent) ->
    block(${, [pair(K, V, Indent) || {K, V} <- Pairs], $}, Indent).

key(Key) when is_atom(Key) -> atom_to_binary(Key, utf8);
key(Key) when is_binary(Key) -> Key.

pair(Key, Value, none) -> [string(key(Key)), $:, value(Value, none)];
pair(Key, Value, Indent) -> [string(key(Key)), <<": ">>, value(Value, Indent + 1)].

deeper(none) -> none;
deeper(Indent) -> Indent + 1.

block(Open, [], Close, _) ->
    [Open, Close];
block(Open, Items, Close, none) ->
    [Open, lists:join($,, Items), Close];
block(Open, Items, Close, Indent) ->
    New = [$\n, lists:duplicate(Indent + 1, <<"  ">>)],
    [Open, New, lists:join([$,, New], Items), $\n, lists:duplicate(Indent, <<"  ">>), Close].

%% The shortest text that reads back as the same float.
float_text(F) -> float_to_binary(F, [short]).

%% Most texts need no escape.
string(Text) ->
    Valid = valid(Text),
    case is_plain(Valid) of
        true -> [$", Valid, $"];
        false -> [$", [escape(C) || <<C>> <= Valid], $"]
    end.

is_plain(<<C, Rest/binary>>) when C >= 32, C =/= $", C =/= $\\, C =/= 127 -> is_plain(Rest);
is_plain(Text) -> Text =:= <<>>.

%% Bytes that are not UTF-8 are taken for Latin-1.
valid(Text) ->
    case unicode:characters_to_binary(Text) of
        Valid when is_binary(Valid) -> Valid;
        _ -> unicode:characters_to_binary(Text, latin1)
    end.

escape($") -> <<"\\\"">>;
escape($\\) -> <<"\\\\">>;
escape($\n) -> <<"\\n">>;
escape($\t) -> <<"\\t">>;
escape(C) when C < 32; C =:= 127 -> io_lib:format("\\u~4.16.0b", [C]);
escape(C) -> C.

%% @doc Reads one JSON text. The error tells the offset of the byte that does not fit.
-spec decode(binary()) -> {ok, decoded()} | {error, {offset, non_neg_integer()}}.
decode(Text) ->
    Size = byte_size(Text),
    try
        {Value, Rest} = parse(skip(Text)),
        case skip(Rest) of
            <<>> -> {ok, Value};
            More -> throw({bad, More})
        end
    catch
        throw:{bad, Where} -> {error, {offset, Size - byte_size(Where)}}
    end.

parse(<<"null", Rest/binary>>) -> {null, Rest};
parse(<<"true", Rest/binary>>) -> {true, Rest};
parse(<<"false", Rest/binary>>) -> {false, Rest};
parse(<<$", Rest/binary>>) -> chars(Rest, <<>>);
parse(<<$[, Rest/binary>>) -> elements(skip(Rest), []);
parse(<<${, Rest/binary>>) -> members(skip(Rest), #{});
parse(<<C, _/binary>> = Text) when C =:= $-; C >= $0, C =< $9 -> number(Text);
parse(Text) -> throw({bad, Text}).

skip(<<C, Rest/binary>>) when C =:= $\s; C =:= $\n; C =:= $\t; C =:= $\r -> skip(Rest);
skip(Text) -> Text.

elements(<<$], Rest/binary>>, []) ->
    {[], Rest};
elements(Text, Done) ->
    {Value, Rest} = parse(Text),
    case skip(Rest) of
        <<$,, More/binary>> -> elements_next(skip(More), [Value | Done]);
        <<$], More/binary>> -> {lists:reverse(Done, [Value]), More};
        Other -> throw({bad, Other})
    end.

elements_next(<<$], _/binary>> = Text, _Done) -> throw({bad, Text});
elements_next(Text, Done) -> elements(Text, Done).

members(<<$}, Rest/binary>>, Done) when map_size(Done) =:= 0 -> {Done, Rest};
members(<<$", Text/binary>>, Done) ->
    {Key, Rest} = chars(Text, <<>>),
    case skip(Rest) of
        <<$:, More/binary>> -> member(Key, skip(More), Done);
        Other -> throw({bad, Other})
    end;
members(Text, _Done) ->
    throw({bad, Text}).

member(Key, Text, Done) ->
    {Value, Rest} = parse(Text),
    case skip(Rest) of
        <<$,, More/binary>> -> members_next(skip(More), Done#{Key => Value});
        <<$}, More/binary>> -> {Done#{Key => Value}, More};
        Other -> throw({bad, Other})
    end.

members_next(<<$}, _/binary>> = Text, _Done) -> throw({bad, Text});
members_next(Text, Done) -> members(Text, Done).

chars(<<$", Rest/binary>>, Done) -> {Done, Rest};
chars(<<$\\, $u, Rest/binary>>, Done) -> unicode_escape(Rest, Done);
chars(<<$\\, C, Rest/binary>>, Done) -> chars(Rest, <<Done/binary, (unescape(C, Rest))>>);
chars(<<C, _/binary>> = Text, _Done) when C < 32 -> throw({bad, Text});
chars(<<C/utf8, Rest/binary>>, Done) -> chars(Rest, <<Done/binary, C/utf8>>);
chars(Text, _Done) -> throw({bad, Text}).

unescape($n, _) -> $\n;
unescape($t, _) -> $\t;
unescape($r, _) -> $\r;
unescape($b, _) -> $\b;
unescape($f, _) -> $\f;
unescape(C, _) when C =:= $"; C =:= $\\; C =:= $/ -> C;
unescape(_, Rest) -> throw({bad, Rest}).

unicode_escape(<<Hex:4/binary, Rest/binary>> = Text, Done) ->
    case {hex(Hex, Text), Rest} of
        {High, <<"\\u", Next:4/binary, More/binary>>} when High >= 16#D800, High < 16#DC00 ->
            case hex(Next, Text) of
                Low when Low >= 16#DC00, Low < 16#E000 ->
                    C = 16#10000 + ((High band 16#3FF) bsl 10) + (Low band 16#3FF),
                    chars(More, <<Done/binary, C/utf8>>);
                _ ->
                    throw({bad, Text})
            end;
        {C, _} when C >= 16#D800, C < 16#E000 ->
            throw({bad, Text});
        {C, _} ->
            chars(Rest, <<Done/binary, C/utf8>>)
    end;
unicode_escape(Text, _Done) ->
    throw({bad, Text}).

hex(Digits, Text) ->
    try binary_to_integer(Digits, 16) of
        N when N >= 0 -> N;
        _ -> throw({bad, Text})
    catch
        error:badarg -> throw({bad, Text})
    end.

number(Text) ->
    Pattern = "^-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][-+]?[0-9]+)?",
    case re:run(Text, Pattern, [{capture, all, binary}]) of
        {match, [All, _]} ->
            {binary_to_integer(All), after_number(Text, All)};
        {match, [All, _, _]} ->
            {binary_to_float(All), after_number(Text, All)};
        {match, [All, Whole, Fraction, Exponent]} ->
            Point =
                case Fraction of
                    <<>> -> <<".0">>;
                    _ -> Fraction
                end,
            Digits = byte_size(Whole) + byte_size(Fraction) + byte_size(Exponent),
            Sign = binary:part(All, 0, byte_size(All) - Digits),
            Float = binary_to_float(<<Sign/binary, Whole/binary, Point/binary, Exponent/binary>>),
            {Float, after_number(Text, All)};
        nomatch ->
            throw({bad, Text})
    end.

after_number(Text, Number) ->
    binary:part(Text, byte_size(Number), byte_size(Text) - byte_size(Number)).

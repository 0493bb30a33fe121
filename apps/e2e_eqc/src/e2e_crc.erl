%% @doc The checksums of e2e.md section 2, by division of polynomials.
%%
%% The register always has the highest power on the left; what AUTOSAR calls reflected is done by
%% turning the bits of each byte, and of the result, around. The C code does it the other way.
-module(e2e_crc).

-export([algorithms/0, width/1, polynomial/1, calculate/2, continue/3, remainder/2]).
-export_type([algorithm/0]).

-type algorithm() :: crc8 | crc8h2f | crc16 | crc16arc | crc32 | crc32p4 | crc64.

%% Width, polynomial, start, final XOR, reflected.
parameters(crc8) -> {8, 16#1D, 16#FF, 16#FF, false};
parameters(crc8h2f) -> {8, 16#2F, 16#FF, 16#FF, false};
parameters(crc16) -> {16, 16#1021, 16#FFFF, 0, false};
parameters(crc16arc) -> {16, 16#8005, 0, 0, true};
parameters(crc32) -> {32, 16#04C11DB7, 16#FFFFFFFF, 16#FFFFFFFF, true};
parameters(crc32p4) -> {32, 16#F4ACFB13, 16#FFFFFFFF, 16#FFFFFFFF, true};
parameters(crc64) ->
    Ones = 16#FFFFFFFFFFFFFFFF,
    {64, 16#42F0E1EBA9EA3693, Ones, Ones, true}.

-spec algorithms() -> [algorithm()].
algorithms() -> [crc8, crc8h2f, crc16, crc16arc, crc32, crc32p4, crc64].

%% @doc Bits of the checksum.
-spec width(algorithm()) -> pos_integer().
width(Algorithm) -> element(1, parameters(Algorithm)).

%% @doc The polynomial with its highest power.
-spec polynomial(algorithm()) -> pos_integer().
polynomial(Algorithm) ->
    {Width, Polynomial, _, _, _} = parameters(Algorithm),
    (1 bsl Width) bor Polynomial.

%% @doc The checksum of all the data.
-spec calculate(algorithm(), binary()) -> non_neg_integer().
calculate(Algorithm, Data) ->
    {_, _, Start, _, _} = parameters(Algorithm),
    finish(Algorithm, divide(Algorithm, Start, Data)).

%% @doc The checksum of what gave Earlier, followed by the data.
-spec continue(algorithm(), Earlier :: non_neg_integer(), binary()) -> non_neg_integer().
continue(Algorithm, Earlier, Data) ->
    {Width, _, _, Final, Reflected} = parameters(Algorithm),
    Register = turned(Reflected, Width, Earlier bxor Final),
    finish(Algorithm, divide(Algorithm, Register, Data)).

%% @doc The bare remainder: start and final XOR 0, as profiles 1 and 11 use CRC8.
-spec remainder(algorithm(), binary()) -> non_neg_integer().
remainder(Algorithm, Data) ->
    {Width, _, _, _, Reflected} = parameters(Algorithm),
    turned(Reflected, Width, divide(Algorithm, 0, Data)).

finish(Algorithm, Register) ->
    {Width, _, _, Final, Reflected} = parameters(Algorithm),
    turned(Reflected, Width, Register) bxor Final.

divide(Algorithm, Start, Data) ->
    {Width, _, _, _, Reflected} = parameters(Algorithm),
    Table = table(Algorithm),
    Mask = (1 bsl Width) - 1,
    Step = fun(Byte, Register) ->
        Index = (Register bsr (Width - 8)) bxor turned(Reflected, 8, Byte),
        ((Register bsl 8) band Mask) bxor element(Index + 1, Table)
    end,
    lists:foldl(Step, Start, binary_to_list(Data)).

%% What each value of the byte that leaves the register leaves behind.
table(Algorithm) ->
    case persistent_term:get({?MODULE, Algorithm}, none) of
        none ->
            Width = width(Algorithm),
            Polynomial = polynomial(Algorithm),
            Rows = [long_division(B bsl Width, Width + 7, Width, Polynomial)
                    || B <- lists:seq(0, 255)],
            Table = list_to_tuple(Rows),
            persistent_term:put({?MODULE, Algorithm}, Table),
            Table;
        Table ->
            Table
    end.

long_division(Rest, Power, Width, _) when Power < Width ->
    Rest;
long_division(Rest, Power, Width, Polynomial) ->
    Next =
        case Rest band (1 bsl Power) of
            0 -> Rest;
            _ -> Rest bxor (Polynomial bsl (Power - Width))
        end,
    long_division(Next, Power - 1, Width, Polynomial).

turned(false, _, Value) -> Value;
turned(true, Width, Value) -> turn(Width, Value, 0).

turn(0, _, Turned) -> Turned;
turn(N, Value, Turned) -> turn(N - 1, Value bsr 1, (Turned bsl 1) bor (Value band 1)).

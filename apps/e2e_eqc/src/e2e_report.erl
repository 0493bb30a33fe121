%% @doc What each E2E profile can be relied on for: `make e2e-report'.
%%
%% Writes e2e.md: the Hamming distances of each profile's packets, found by exhaustive search, and a
%% table of communication faults and profiles with what libe2e says of each, measured.
-module(e2e_report).

-export([main/1, run/2, settings/0]).
-export_type([settings/0]).

-type settings() :: #{
    trials := pos_integer(), seed := non_neg_integer(), flips := pos_integer(), long := boolean()
}.

%% @doc Writes the report into a directory and ends the VM.
-spec main([file:filename()]) -> no_return().
main([Dir]) -> faultcheck_written:halt("e2e-report", fun() -> run(Dir, settings()) end).

%% @doc What `make e2e-report' runs.
-spec settings() -> settings().
settings() -> #{trials => 10000, seed => 1, flips => 6, long => true}.

%% @doc Measures everything and writes the report.
-spec run(file:filename(), settings()) -> ok.
run(Dir, Settings) ->
    {ok, _} = application:ensure_all_started(c_bridge),
    Results = results(Settings),
    ok = e2e_sut:stop(),
    Text = [
        "# What the E2E profiles detect\n\n",
        "Made by `make e2e-report` from libe2e and the reference of apps/e2e_eqc.\n\n",
        distances(Settings),
        table(Results, Settings),
        counts(Results)
    ],
    File = filename:join(Dir, "e2e.md"),
    ok = filelib:ensure_dir(File),
    file:write_file(File, Text).

%% ---- distances --------------------------------------------------------------------------------

distances(#{flips := Flips, long := Long}) ->
    [
        "## Hamming distances\n\n",
        "The least number of flipped bits that the checksum does not see, and how many of all\n",
        "patterns of so many bits these are. Every pattern was tried, by adding up what each bit\n",
        "does to the checksum. Other fields that the receiver compares (Length, Data ID in the\n",
        "header, counter 15) find some of these patterns all the same.\n\n",
        "| profile | configuration | bytes | distance | undetected | of |\n",
        "|---|---|---:|---:|---:|---:|\n",
        [distance(P, Label, Config, Bytes, Flips)
         || {P, Label, Config, Bytes} <- packets(), Long orelse Bytes =< 16],
        "\nIn profiles 2 and 22 and in mode ALT of profile 1 the counter chooses the Data ID:\n",
        "then the distance depends on the Data IDs; the number is that of the worst counter.\n\n"
    ].

packets() ->
    Of = fun e2e_configuration:example/1,
    Sized = fun(P, Bytes) -> (Of(P))#{'DataLength' := 8 * Bytes} end,
    Same = fun(P, Bytes) -> (Sized(P, Bytes))#{'DataIDList' := lists:duplicate(16, 1)} end,
    Alt = fun(Bytes) -> (Sized(p01, Bytes))#{'DataIDMode' := 1} end,
    [{p01, "BOTH, ID 0x0123", Sized(p01, N), N} || N <- [4, 8, 16, 30]] ++
        [{p01, "ALT, ID 0x0123", Alt(N), N} || N <- [4, 8]] ++
        [{p11, "NIBBLE, ID 0x0123", Sized(p11, N), N} || N <- [4, 8, 16, 30]] ++
        [{P, "one ID", Same(P, N), N} || P <- [p02, p22], N <- [4, 8, 16, 32]] ++
        [{P, "IDs 1 to 16", Sized(P, N), N} || P <- [p02, p22], N <- [4, 8, 16, 32]] ++
        [{p05, "", Sized(p05, N), N} || N <- [4, 8, 16, 32]] ++
        [{P, "", Of(P), N} || P <- [p06, p04, p44, p08, p07], N <- [shortest(P), 32]].

shortest(P) -> e2e_packet:header_bytes(P).

distance(P, Label, Config, Bytes, Most) ->
    %% six flips of more than 200 bits are too many to try
    Flips = if Bytes > 25 -> min(Most, 5); true -> Most end,
    Cells =
        case e2e_distance:least(P, Config, Bytes, Flips) of
            {above, N} ->
                io_lib:format("above ~b | 0 | ~b", [N, upto(8 * Bytes, N)]);
            {N, Undetected} ->
                io_lib:format("~b | ~b | ~b", [N, Undetected, e2e_distance:patterns(8 * Bytes, N)])
        end,
    io_lib:format("| ~s | ~s | ~b | ~s |\n", [name(P), Label, Bytes, Cells]).

upto(Bits, Most) -> lists:sum([e2e_distance:patterns(Bits, N) || N <- lists:seq(1, Most)]).

name(P) -> string:uppercase(atom_to_list(P)).

%% ---- faults -------------------------------------------------------------------------------------

results(#{trials := Trials, seed := Seed}) ->
    [
        {Fault, [{P, measured(Name, P, Trials, Seed)} || P <- e2e_packet:profiles()]}
     || {Name, _} = Fault <- e2e_fault_trial:faults()
    ].

measured(Fault, P, Trials, Seed) ->
    Config = e2e_configuration:example(P),
    {_, Bytes} = e2e_packet:lengths(P, Config),
    e2e_fault_trial:run(Fault, {P, Config, Bytes}, Trials, Seed).

table(Results, #{trials := Trials, seed := Seed}) ->
    [
        "## Communication faults and profiles\n\n",
        io_lib:format(
            "What Check says of the packet that meets the fault, in ~b trials each with seed ~b. "
            "**OK** is an\nundetected fault; every other status tells the receiver. "
            "MaxDelta(Init) is 3, data is random.\n\n",
            [Trials, Seed]
        ),
        packets_used(),
        row(["fault" | [name(P) || P <- e2e_packet:profiles()]]),
        row(["---" | ["---" || _ <- e2e_packet:profiles()]]),
        [row([Text | [cell(R) || {_, R} <- Columns]]) || {{_, Text}, Columns} <- Results],
        row([
            "fault-free packets until OK, at most"
            | [integer_to_list(recovery(P, Results)) || P <- e2e_packet:profiles()]
        ]),
        "\n1. With the counter as before, nothing can tell. Who must know checks in time: see the\n"
        "   row \"delay\", and the counters of NONEWDATA in profiles 1 and 2.\n"
        "2. Profiles 1 and 2 have no length argument: their buffer has a fixed size. Missing\n"
        "   bytes are 0 in it. Bytes beyond it are not seen: an extended packet is unaltered.\n\n"
        "To a receiver, reception by a subset only and blocked access are a loss, asymmetric\n"
        "information is a corruption for those who get the altered copy.\n\n"
    ].

packets_used() ->
    Used = [
        begin
            {_, Bytes} = e2e_packet:lengths(P, e2e_configuration:example(P)),
            io_lib:format("~s ~b", [name(P), Bytes])
        end
     || P <- e2e_packet:profiles()
    ],
    ["Bytes in a packet: ", lists:join(", ", Used), ".\n\n"].

row(Cells) -> ["| ", lists:join(" | ", Cells), " |\n"].

cell(#{statuses := Statuses}) ->
    case by_count(Statuses) of
        [{Status, _}] -> shown(Status);
        Several ->
            Sum = lists:sum([N || {_, N} <- Several]),
            lists:join("<br>", [[shown(S), " ", percent(N, Sum)] || {S, N} <- Several])
    end.

shown('OK') -> "**OK**";
shown(input_wrong) -> "INPUTERR_WRONG";
shown(Status) -> atom_to_list(Status).

percent(N, Sum) -> io_lib:format("~.2f %", [100 * N / Sum]).

by_count(Statuses) ->
    [{S, N} || {Minus, S} <- lists:sort([{-C, S} || {S, C} <- maps:to_list(Statuses)]),
        N <- [-Minus]].

recovery(P, Results) ->
    lists:max([maps:get(recovery, proplists:get_value(P, Columns)) || {_, Columns} <- Results]).

%% ---- counts -------------------------------------------------------------------------------------

counts(Results) ->
    [
        "## Counts\n\n",
        "Where the answer was not always the same.\n\n",
        "| fault | profile | counts |\n|---|---|---|\n",
        [
            io_lib:format("| ~s | ~s | ~s |\n", [Text, name(P), count_list(Statuses)])
         || {{_, Text}, Columns} <- Results,
            {P, #{statuses := Statuses}} <- Columns,
            map_size(Statuses) > 1
        ]
    ].

count_list(Statuses) ->
    lists:join(", ", [io_lib:format("~s ~b", [shown(S), N]) || {S, N} <- by_count(Statuses)]).

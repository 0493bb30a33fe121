%% @doc The realistic faults of a vehicle that locates itself by ranging (Paper III, section 2.2)
%% as terms: a section of docs/faults.md, made by markdown/0.
%%
%% The terms stand at one point of their range; c_src/faultcheck/test/realistic_fault_test.c shows
%% what each of them does in simulated time.
-module(faultcheck_fault_realistic).

-export([rows/0, markdown/0]).
-export_type([row/0]).

%% Name, where, the faults armed together, and the range of the numbers in them.
-type row() :: {string(), Place :: string(), [faultcheck_fault:fault()], Range :: string()}.

-spec rows() -> [row()].
rows() ->
    [
        {"accelerometer misalignment", "`RollId`, `PitchId`", [{offset, 3.0}], "+-5 degrees"},
        {"air movement", "`RollId`, `PitchId`",
         [{{held_offset, -4.0, 4.0, 200000000}, [{time, 0, 5000000000}]}],
         "+-4 degrees, drawn every 0.1-0.5 s, for 1-10 s"},
        {"air movement, as noise", "`RollId`, `PitchId`",
         [{{noise_gauss, 1.0}, [{time, 0, 5000000000}]}], "1 degree, for 1-10 s"},
        {"gyroscope drift", "`RollId`, `PitchId`", [{drift_timed, 0.1, 5.0}],
         "0.01-0.2 degrees/s"},
        {"gyroscope drift", "`YawId`", [{drift_timed, 0.1, 20.0}], "0.01-0.2 degrees/s"},
        {"gyroscope gain", "`RollId`, `PitchId`", [{amplification, 0.95}], "0.9-1.1"},
        {"ranging reflection, scattered", "`RangeId`",
         [{{random_offset, 0.5, 8.0}, [{random, 0.1}]}],
         "0.5 to 0.5-8 m: never shorter than the true range; 0.05-0.3 of the samples"},
        {"ranging reflection, lasting", "`RangeId`",
         [{{random_offset, 0.5, 8.0}, [{time, 0, 3000000000}]}], "for 1-8 s"},
        {"anchor misplacement", "`AnchXId`, `AnchYId`, `AnchZId` of all copters",
         [{offset, 0.2}], "+-0.5 m"},
        {"message: corruption", "`ITS_DATA`", [{corruption, 18, 3}], "any of the 736 bits"},
        {"message: loss", "`ITS_DATA`", [{drop, 20}], "1-50 packets"},
        {"message: loss for a time", "`ITS_DATA`", [{lose, [{time, 0, 2000000000}]}],
         "for 0.1-8 s"},
        {"message: delay", "`ITS_DATA`", [{delay, {ns, 250000000}}], "50-500 ms"},
        {"message: repetition with delay", "`ITS_DATA`",
         [{delay, {ns, 250000000}}, {repeat, 3}], "armed together"},
        {"position jump", "`PxId`, `PyId`", [{{offset, 1.5}, [{for, 1}]}],
         "+-1.5 m; the probe is applied in place, so it is one step long"}
    ].

%% @doc The section of the page.
-spec markdown() -> iodata().
markdown() ->
    [
        "\n## Realistic faults of a vehicle\n\n"
        "Those of the quadcopters (Paper III, 2.2), in simulated time: degrees, metres and\n"
        "nanoseconds. The names of probes end in the numbers of copter and anchor. Times count\n"
        "from the arming; a drift and a held offset begin with the first affected call.\n\n"
        "| fault | where | term | range |\n|---|---|---|---|\n",
        [
            ["| ", Name, " | ", Place, " | ", lists:join(" and ", [term(F) || F <- Faults]),
             " | ", Range, " |\n"]
         || {Name, Place, Faults, Range} <- rows()
        ]
    ].

term(Fault) -> io_lib:format("`~0p`", [Fault]).

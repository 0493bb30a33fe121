%% @doc For tests: a sequence flown by coptersim_run, and other programs of the simulator.
-module(copter_test_scenario).

-export([fly/2, run/2, compared/1, program/1, output_of/2]).

%% @doc The trace of the sequence's scenario, decoded; states are recorded at its beginning and end.
-spec fly(copter_options:options(), [faultcheck_generator:command()]) -> faultcheck_json:decoded().
fly(Options, Commands) ->
    File = cb_files:fresh_name("scenario", ".json"),
    {object, Members} = Scenario = copter_scenario:from_commands(Commands, Options, [{name, test}]),
    ok = file:write_file(File, faultcheck_json:pretty(Scenario)),
    try
        run(File, proplists:get_value(duration_us, Members))
    after
        file:delete(File)
    end.

%% @doc The trace of a scenario, decoded; states are recorded at its beginning and after so long.
-spec run(file:filename(), Duration_us :: pos_integer()) -> faultcheck_json:decoded().
run(File, Duration) ->
    Setting = "record_every_us=" ++ integer_to_list(Duration),
    Text = output_of(program("coptersim_run"), ["--set", Setting, File]),
    {ok, Trace} = faultcheck_json:decode(Text),
    Trace.

%% @doc Where a program of the simulator is.
-spec program(string()) -> file:filename().
program(Name) -> filename:join([filename:dirname(copter_sut:library()), "..", "bin", Name]).

%% @doc What a program prints that does its work.
-spec output_of(file:filename(), [string()]) -> binary().
output_of(Program, Args) ->
    Port = open_port({spawn_executable, Program}, [{args, Args}, exit_status, binary, use_stdio]),
    {0, Text} = output(Port, []),
    Text.

output(Port, Read) ->
    receive
        {Port, {data, Data}} -> output(Port, [Read, Data]);
        {Port, {exit_status, Status}} -> {Status, iolist_to_binary(Read)}
    end.

%% @doc Of a trace, or of this process's simulator with the result of a run: the collision, or the
%% states at the end.
-spec compared({trace, faultcheck_json:decoded()} | {run, copter_trial:result()}) -> term().
compared({trace, #{<<"collision">> := null, <<"copters">> := Copters}}) ->
    [
        {Id, [last(maps:get(View, Copter), Name) || View <- views(), Name <- names()]}
     || {Id, Copter} <- by_number(Copters)
    ];
compared({trace, #{<<"collision">> := Collision}}) ->
    #{<<"t_us">> := Time, <<"kind">> := Kind, <<"ids">> := Ids, <<"point">> := [X, Y]} = Collision,
    {Time, Kind, Ids, real(X), real(Y)};
compared({run, safe}) ->
    [
        {Id, [maps:get(binary_to_atom(Name), copter_sut:state(Id, View))
              || View <- [true, perceived], Name <- names()]}
     || Id <- copter_sut:copters()
    ];
compared({run, {collision, #{kind := Kind, ids := Ids, t_us := Time, point := {X, Y}}}}) ->
    Involved = case Kind of copter -> Ids; terrain -> [hd(Ids)] end,
    {Time, atom_to_binary(Kind), Involved, X, Y}.

by_number(Copters) ->
    lists:keysort(1, [{binary_to_integer(Id), Copter} || {Id, Copter} <- maps:to_list(Copters)]).

views() -> [<<"true">>, <<"perceived">>].

names() ->
    [<<"px">>, <<"py">>, <<"vx">>, <<"vy">>, <<"roll">>, <<"pitch">>, <<"yaw">>].

last(View, Name) -> real(lists:last(maps:get(Name, View))).

%% -0 and 0 are written alike.
real(Number) -> float(Number).

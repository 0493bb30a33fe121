%% @doc What holds, and where it ends: `make copter-campaign'.
%%
%% Four experiments: tests and searches without faults; each realistic fault alone, under each
%% counter-measure; how survival depends on copters, faults and their intensity; the stored
%% counterexamples under each configuration. Interrupted, it goes on where it ended: finished
%% chunks are kept in state files that name the code they belong to.
-module(copter_campaign).

-export([main/1, run/2, settings/0, short/0, fingerprint/0]).
-export_type([settings/0, results/0]).

-type settings() :: #{
    seed := non_neg_integer(),
    %% without faults: tests, searches, and runs of a search at most
    free_tests := pos_integer(),
    searches := pos_integer(),
    search_runs := pos_integer(),
    %% tests of each fault in each configuration, and of each place of the survival table
    fault_tests := pos_integer(),
    survival_tests := pos_integer(),
    %% of the box with 200 copters
    crowd_tests := pos_integer(),
    configurations := [copter_configuration:name()],
    %% simulated time of a test
    horizon_ms := pos_integer(),
    workers := pos_integer(),
    progress := fun((faultcheck_enumerate:progress()) -> term())
}.
-type results() :: #{
    settings := settings(),
    free := copter_experiment:rate(),
    searches := [copter_experiment:search()],
    %% by {Fault, Configuration}
    faults := #{term() => copter_experiment:rate()},
    %% by {Configuration, Place, Copters, Faults, Ranges}
    survival := #{term() => copter_experiment:rate()},
    stored := [{Name :: string(), [{copter_configuration:name(), copter_trial:result()}]}]
}.

%% @doc Writes the report into a directory and ends the VM.
-spec main([file:filename()]) -> no_return().
main([Dir]) -> faultcheck_written:halt("copter-campaign", fun() -> run(Dir, settings()) end).

%% @doc What `make copter-campaign' runs.
-spec settings() -> settings().
settings() ->
    #{
        seed => 20250401,
        free_tests => 20000,
        searches => 100,
        search_runs => 500,
        fault_tests => 500,
        survival_tests => 200,
        crowd_tests => 30,
        configurations => copter_configuration:names(),
        horizon_ms => 20000,
        workers => min(2, erlang:system_info(schedulers_online)),
        progress => fun faultcheck_enumerate:print_progress/1
    }.

%% @doc A short form, which `make test' runs.
-spec short() -> settings().
short() ->
    (settings())#{
        free_tests => 40,
        searches => 1,
        search_runs => 30,
        fault_tests => 2,
        survival_tests => 1,
        crowd_tests => 1,
        configurations => [default, hardened],
        horizon_ms => 3000,
        workers => 1,
        progress => fun(_) -> ok end
    }.

%% @doc Runs all experiments and writes copter_campaign.md, .json and charts.
-spec run(file:filename(), settings()) -> ok.
run(Dir, Settings) ->
    {ok, _} = application:ensure_all_started(c_bridge),
    State = filename:join([Dir, "copter_campaign", "state"]),
    ok = filelib:ensure_dir(filename:join(State, "x")),
    Context = Settings#{state => State, code => fingerprint()},
    Results = #{
        settings => Settings,
        free => free(Context),
        searches => searches(Context),
        faults => faults(Context),
        survival => survival(Context),
        stored => stored(Settings)
    },
    ok = copter_campaign_report:write(Dir, Results),
    _ = [ok = file:delete(F) || F <- filelib:wildcard(filename:join(State, "*"))],
    ok = file:del_dir(State).

%% @doc Names the code that results come from: they are kept for no other.
-spec fingerprint() -> string().
fingerprint() ->
    {ok, Library} = file:read_file(copter_sut:library()),
    Modules = [
        M:module_info(md5)
     || M <- [copter_eqc, copter_fault, copter_world, copter_options, copter_configuration,
              copter_trial, copter_pilot, faultcheck_generator, faultcheck_range]
    ],
    integer_to_list(erlang:phash2({Library, Modules}, 1 bsl 32), 16).

enumeration(Name, #{state := State, code := Code, progress := Progress, workers := Workers}) ->
    #{
        name => Code,
        state_file => filename:join(State, Code ++ "-" ++ Name),
        progress => fun(P) -> Progress(P#{name => list_to_atom(Name)}) end,
        progress_ms => 5000,
        workers => Workers
    }.

rates(Name, Cells, #{seed := Seed} = Context) ->
    copter_experiment:rates(Name, Cells, Seed, enumeration(Name, Context)).

%% ---- without faults -------------------------------------------------------------------------

free_options(#{horizon_ms := Horizon}) ->
    copter_options:new(#{
        world => reference,
        min_copters => 4,
        max_copters => 4,
        max_faults => 0,
        configuration => hardened,
        horizon_ms => Horizon
    }).

free(#{free_tests := Tests} = Context) ->
    #{free := Rate} = rates("free", [{free, free_options(Context), Tests}], Context),
    Rate.

searches(#{searches := Searches, search_runs := Runs} = Context) ->
    copter_experiment:searches(
        free_options(Context),
        Searches,
        #{bias => 0.9, plain_share => 0.1, max_runs => Runs},
        enumeration("searches", Context)
    ).

%% ---- each fault alone -----------------------------------------------------------------------

faults(#{fault_tests := Tests, configurations := Configurations} = Context) ->
    Cells = [
        {{Kind, Configuration}, fault_options(Kind, Configuration, Context), Tests}
     || Kind <- copter_fault:kinds(), Configuration <- Configurations
    ],
    rates("faults", Cells, Context).

fault_options(Kind, Configuration, #{horizon_ms := Horizon}) ->
    copter_options:new(#{
        world => reference,
        min_copters => 4,
        max_copters => 4,
        max_faults => 3,
        faults => [Kind],
        configuration => Configuration,
        horizon_ms => Horizon
    }).

%% ---- the envelope ---------------------------------------------------------------------------

survival(#{survival_tests := Tests, crowd_tests := CrowdTests} = Context) ->
    Cells = [
        {
            {Configuration, Place, Copters, Faults, Ranges},
            survival_options(Configuration, World, Copters, Faults, Ranges, Context),
            case Copters of 200 -> CrowdTests; _ -> Tests end
        }
     || Configuration <- [default, hardened],
        {Place, World, Copters} <- [
            {reference, reference, 2}, {reference, reference, 4}, {box, {box, 4}, 4},
            {box, {box, 10}, 10}, {box, {box, 200}, 200}
        ],
        {Faults, Ranges} <- [
            {0, default}, {1, mild}, {1, default}, {3, mild}, {3, default}, {6, mild}, {6, default}
        ]
    ],
    rates("survival", Cells, Context).

survival_options(Configuration, World, Copters, Faults, Ranges, #{horizon_ms := Horizon}) ->
    copter_options:new(#{
        world => World,
        min_copters => Copters,
        max_copters => Copters,
        max_faults => Faults,
        ranges => Ranges,
        configuration => Configuration,
        horizon_ms => Horizon
    }).

%% ---- stored counterexamples -----------------------------------------------------------------

stored(#{configurations := Configurations}) ->
    Results = [
        {Name, [{C, copter_trial:rerun(Options#{configuration := C,
                                                its_ms := copter_configuration:its_ms(C)},
                                       Commands)}
                || C <- Configurations]}
     || {Name, Options, Commands} <- copter_stored:all()
    ],
    ok = copter_sut:stop(),
    Results.

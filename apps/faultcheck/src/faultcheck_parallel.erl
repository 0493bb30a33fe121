%% @doc Commands of a grouped model at once: parallel test cases, and whether what they gave can be
%% explained by some order of the commands, one at a time (linearisability).
%%
%% ```
%% prop_threads() ->
%%     ?FORALL(Case, faultcheck_parallel:commands(?MODULE),
%%             begin
%%                 Result = faultcheck_parallel:run_commands(?MODULE, Case,
%%                                                           #{setup => fun reset/0}),
%%                 ?WHENFAIL(io:put_chars(faultcheck_parallel:pretty(Result)),
%%                           aggregate(faultcheck_parallel:command_names(Case),
%%                                     faultcheck_parallel:is_ok(Result)))
%%             end).
%% '''
%% The model is the same as for sequences (faultcheck_model): X_post says what a command must give
%% when it runs at once between two others, so no more than that has to be written.
%%
%% A case is executed by Erlang processes unless `execute' is given. That function runs the case as
%% often as it is asked to and gives what each command gave each time, and where it can when each
%% began and ended: for threads in C see faultcheck_threads_sut in apps/faultcheck_eqc.
%%
%% The seed determines the case, not what threads do. A case is run `repetitions' times and fails if
%% one of them does; one that was not just generated, because it is confirmed, shrunk or replayed,
%% ten times as often. A runner runs a failure again 10 times; one that does not come back each time
%% is reported as flaky and left as it is, with what it gave when it failed.
-module(faultcheck_parallel).

-export([commands/1, commands/2, run_commands/2, run_commands/3]).
-export([is_ok/1, outcomes/1, pretty/1, why/1, command_names/1, lines/1]).
-export_type([options/0, run_options/0, result/0]).

%% What failed should fail again, and a smaller case has fewer ways to.
-define(AGAIN, 10).

-type test_case() :: faultcheck_parallel_case:test_case().
-type options() :: #{
    %% threads, 2
    branches => pos_integer(),
    %% most commands of each, 4
    length => pos_integer(),
    shrink => faultcheck_shrinker:options()
}.
-type run_options() :: #{
    repetitions => pos_integer(),
    %% called before each repetition, where processes execute the case
    setup => fun(() -> term()),
    execute => fun((test_case(), pos_integer()) -> [faultcheck_linear:outcome()])
}.
-opaque result() ::
    #{ok := true, outcomes := non_neg_integer()}
    | #{
        ok := false,
        'case' := test_case(),
        outcome := faultcheck_linear:outcome(),
        longest := [faultcheck_linear:call()],
        repetition := pos_integer()
    }.

%% @doc Parallel cases of a model, as a PropEr type.
-spec commands(module()) -> proper_types:type().
commands(Mod) -> commands(Mod, #{}).

-spec commands(module(), options()) -> proper_types:type().
commands(Mod, Given) ->
    Limits = #{branches => maps:get(branches, Given, 2), length => maps:get(length, Given, 4)},
    Shrink = faultcheck_shrinker:options(maps:merge(#{confirm => 0}, maps:get(shrink, Given, #{}))),
    Fresh = fun(Size) -> generate(Mod, Size, Limits) end,
    faultcheck_proper:new_type(
        Fresh,
        fun(Imm) -> is_case(faultcheck_proper:clean(Imm)) end,
        fun(Imm, _Type, State) -> shrink(Mod, Shrink, Imm, State) end,
        fun(_Base) -> Fresh(faultcheck_proper:size()) end
    ).

is_case({parallel, First, Branches, Last}) ->
    is_list(First) andalso is_list(Branches) andalso is_list(Last);
is_case(_) ->
    false.

generate(Mod, Size, Limits) ->
    faultcheck_stats:generated(),
    _ = erase({?MODULE, finished}),
    {Case, Side} = faultcheck_parallel_case:generate(Mod, Size, Limits),
    _ = put({?MODULE, fresh}, Case),
    faultcheck_proper:with_side(Case, Side).

%% @doc Module, name and arity of each command, for aggregate/2.
-spec command_names(test_case()) -> [mfa()].
command_names(Case) ->
    faultcheck_statem:command_names(faultcheck_parallel_case:commands(Case)).

%%% Running

-spec run_commands(module(), test_case()) -> result().
run_commands(Mod, Case) -> run_commands(Mod, Case, #{}).

%% @doc Runs a case a number of times (20), up to the first outcome that no order explains.
-spec run_commands(module(), test_case(), run_options()) -> result().
run_commands(Mod, Case, Options) ->
    Setup = maps:get(setup, Options, fun() -> ok end),
    Execute = maps:get(execute, Options, faultcheck_parallel_run:by_processes(Setup)),
    ok = faultcheck_journal:command(Case),
    Outcomes = Execute(Case, repetitions(Case, Options)),
    count(Mod, Case),
    noted(explain(Mod, Case, Outcomes, 1, #{})).

repetitions(Case, Options) ->
    Given = maps:get(repetitions, Options, 20),
    case erase({?MODULE, fresh}) of
        Case -> Given;
        _ -> Given * ?AGAIN
    end.

noted(#{ok := true} = Result) ->
    Result;
noted(#{ok := false, 'case' := Case} = Result) ->
    _ = put({?MODULE, failure}, {Case, Result}),
    Result.

%% Outcomes that were explained before are not searched again.
explain(_Mod, _Case, [], _Repetition, Explained) ->
    #{ok => true, outcomes => map_size(Explained)};
explain(Mod, Case, [Outcome | Outcomes], Repetition, Explained) ->
    Key = what_matters(Outcome),
    case is_map_key(Key, Explained) orelse faultcheck_linear:explain(Mod, Case, Outcome) of
        {unexplained, Longest} ->
            #{ok => false, 'case' => Case, outcome => Outcome, longest => Longest,
              repetition => Repetition};
        _ ->
            explain(Mod, Case, Outcomes, Repetition + 1, Explained#{Key => true})
    end.

%% Of the times only what was over before what began.
what_matters({Results, Times}) ->
    List = maps:to_list(Times),
    {Results, [{A, B} || {A, {_, End}} <- List, {B, {Begin, _}} <- List, End < Begin]}.

count(Mod, Case) ->
    _ = faultcheck_stats:active() andalso
        begin
            Names = [Name || {_, Name, _} <- command_names(Case)],
            Faults = faultcheck_model:faults(faultcheck_model:info(Mod)),
            faultcheck_stats:sequence(
                Names, [N || N <- Names, lists:member(N, Faults)], length(Names), [])
        end,
    ok.

-spec is_ok(result()) -> boolean().
is_ok(#{ok := Ok}) -> Ok.

%% @doc How many different outcomes the repetitions of a good result had; what was over when
%% something else began counts as a difference.
-spec outcomes(result()) -> non_neg_integer().
outcomes(#{ok := true, outcomes := N}) -> N;
outcomes(#{ok := false}) -> 0.

%%% Words

%% @doc A case: what runs first, each branch, what runs last; a line for each command.
-spec lines(test_case()) -> [iolist()].
lines({parallel, First, Branches, Last}) ->
    Titled = fun(_Title, []) -> [];
                (Title, Commands) -> [Title | [["  ", L] || L <- words(Commands)]]
             end,
    Numbered = lists:zip(lists:seq(1, length(Branches)), Branches),
    Titled("first:", First) ++
        lists:append([Titled(io_lib:format("thread ~b:", [I]), B) || {I, B} <- Numbered]) ++
        Titled("last:", Last).

words(Commands) -> faultcheck_pretty:commands(Commands).

%% @doc A result in words: nothing when it is good; otherwise what each command gave, and how far
%% an order can be found.
-spec pretty(result()) -> iolist().
pretty(#{ok := true}) ->
    [];
pretty(#{ok := false, 'case' := Case, outcome := {Results, _} = Outcome} = Failure) ->
    #{longest := Longest, repetition := Repetition} = Failure,
    {parallel, First, Branches, Last} = Case,
    Shown = fun(Title, Commands) -> [Title, $\n | [shown(C, Results) || C <- Commands]] end,
    Numbered = lists:zip(lists:seq(1, length(Branches)), Branches),
    [
        io_lib:format("no order of the commands gives what repetition ~b gave:~n", [Repetition]),
        Shown("first:", First),
        [Shown(io_lib:format("thread ~b:", [I]), B) || {I, B} <- Numbered],
        Shown("last:", Last),
        deepest(Case, Longest, Outcome)
    ].

%% @doc How the last case that failed in this process did, if it is in this counterexample: also
%% when it passes by now.
-spec why(proper:counterexample()) -> {ok, iolist()} | none.
why(CounterExample) ->
    case get({?MODULE, failure}) of
        {Case, Result} ->
            case lists:member(Case, CounterExample) of
                true -> {ok, pretty(Result)};
                false -> none
            end;
        undefined ->
            none
    end.

shown({set, {var, N}, _} = Command, Results) ->
    [Words] = words([Command]),
    io_lib:format("  V~b: ~ts -> ~0lp~n", [N, Words, maps:get(N, Results)]).

%% What runs first runs in its order, so only a failure there would tell something by it.
deepest({parallel, First, _, _} = Case, Longest, {_, Times}) ->
    Names = fun(Vars) -> lists:join(", ", [["V", integer_to_list(N)] || N <- Vars]) end,
    Done = [N || {N, _, _, _} <- Longest],
    Left = variables(faultcheck_parallel_case:commands(Case)) -- Done,
    Timed = case map_size(Times) of
                0 -> "";
                _ -> " (none before one that had ended when it began)"
            end,
    ["the longest order that does", Timed, ": ", Names(Done -- variables(First)), "; not: ",
     Names(Left), $\n].

variables(Commands) -> [N || {set, {var, N}, _} <- Commands].

%%% Shrinking, driven by PropEr as in faultcheck_statem: first the sequence of all commands by
%%% faultcheck_shrinker, then commands move out of the branches.

shrink(Mod, Options, Imm, init) ->
    Case = faultcheck_proper:clean(Imm),
    case erase({?MODULE, finished}) of
        Case ->
            {[], done};
        _ ->
            faultcheck_stats:shrinking(),
            Side = case faultcheck_proper:side(Imm) of {ok, S} -> S; none -> #{} end,
            Flat = faultcheck_parallel_case:flatten(Case),
            Start = {Options, #{kind => unknown, at => unknown}},
            remove(Mod, faultcheck_shrinker:first(Mod, Flat, Side, Start))
    end;
shrink(_Mod, _Options, _Imm, {shrunk, _Position, Continue}) ->
    Continue(fails);
shrink(_Mod, _Options, _Imm, Continue) ->
    Continue(passes).

%% What is legal as a sequence need not be so in every order: such a candidate is not tried.
remove(Mod, {try_, Imm, Continue, _}) ->
    Case = faultcheck_parallel_case:unflatten(Mod, faultcheck_proper:clean(Imm)),
    case faultcheck_parallel_case:legal(Mod, Case) of
        true ->
            {[offered(Case, Imm)], fun(Verdict) -> remove(Mod, Continue(verdict(Verdict))) end};
        false -> remove(Mod, Continue(passes))
    end;
remove(Mod, {done, #{shrunk := Flat}}) ->
    Case = faultcheck_parallel_case:unflatten(Mod, Flat),
    move(Mod, Case, faultcheck_parallel_case:candidates(Case)).

verdict(fails) -> {fails, unknown};
verdict(passes) -> passes.

offered(Case, Imm) ->
    {ok, Side} = faultcheck_proper:side(Imm),
    faultcheck_proper:with_side(Case, Side).

move(_Mod, Case, []) ->
    _ = put({?MODULE, finished}, Case),
    {[], done};
move(Mod, Case, [Candidate | Candidates]) ->
    case faultcheck_parallel_case:legal(Mod, Candidate) of
        true ->
            {[faultcheck_proper:with_side(Candidate, #{})],
             fun(fails) -> move(Mod, Candidate, faultcheck_parallel_case:candidates(Candidate));
                (passes) -> move(Mod, Case, Candidates)
             end};
        false ->
            move(Mod, Case, Candidates)
    end.

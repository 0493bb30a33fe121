%% @doc Adds to a PropEr property what a run needs to know: each test gets its own random seed,
%% the journal hears of each test and each candidate, and an exception is kept with its stack.
%%
%% A property is left as it is apart from that: the counterexample has the shape that
%% `proper:check/2' wants, so a stored one fits the property with and without these additions.
%% All knowledge of how PropEr 1.2 to 1.5 represents a property as a term is in this module.
-module(faultcheck_instrument).

-export([peel/1, independent/1, test/2, seed/2, size/0, exception/1, running/0]).
-export([take_samples/1, with_samples/2]).
-export_type([outer/0, plan/0, running/0]).

-type outer() :: #{
    numtests => pos_integer(),
    fails => true,
    on_output => fun((string(), [term()]) -> ok),
    setup => [fun()]
}.
-type plan() :: #{
    property := {module(), atom()},
    seed := non_neg_integer(),
    %% says which test begins: the same number again while it is shrunk; `skip' for one that is
    %% not run here, `stop' when there are no more, and then the remaining tests are empty; or what
    %% takes the place of the test
    next := fun(() -> pos_integer() | skip | stop | {instead, proper:test()}),
    exceptions := ets:tid(),
    %% keep the samples of aggregate/2 and its like in that table, too
    samples => true,
    %% told the value of each outermost ?FORALL, whose body is then not run
    instead => fun((term()) -> ok)
}.
%% A test, and the how many-th time its property runs: 1, and more for candidates of its shrinking.
-type running() :: #{
    property := {module(), atom()},
    seed := non_neg_integer(),
    test := pos_integer(),
    attempt := non_neg_integer()
}.

%% @doc Takes off the wrappers that PropEr accepts only at the outermost place.
-spec peel(proper:outer_test()) -> {proper:test(), outer()}.
peel(Test) -> peel(Test, #{}).

peel({numtests, N, Test}, Outer) -> peel(Test, Outer#{numtests => N});
peel({fails, Test}, Outer) -> peel(Test, Outer#{fails => true});
peel({on_output, Print, Test}, Outer) -> peel(Test, Outer#{on_output => Print});
peel({setup, Fun, Test}, Outer) -> peel(Test, Outer#{setup => [Fun | maps:get(setup, Outer, [])]});
peel(Test, Outer) -> {Test, Outer}.

%% @doc Whether test i needs nothing of the tests before it. Searches of PropEr do: an ?EXISTS,
%% and a targeted property, which PropEr gives a set-up function of its own.
-spec independent({proper:test(), outer()}) -> boolean().
independent({Test, Outer}) ->
    Own = [F || F <- maps:get(setup, Outer, []), erlang:fun_info(F, module) =:= {module, proper}],
    Own =:= [] andalso not (is_tuple(Test) andalso element(1, Test) =:= exists).

%% @doc The property with everything added, and its set-up functions back in place.
%%
%% PropEr forces the outer delayed property once per test, before the generators draw. A set-up
%% function draws too, where the property is targeted: as test 0, and not from PropEr's clock.
-spec test({proper:test(), outer()}, plan()) -> proper:outer_test().
test({Test, Outer}, #{seed := Seed} = Plan) ->
    Begin = fun() -> begin_test(Test, Plan) end,
    lists:foldl(
        fun(Setup, Inner) -> proper:setup(seeded(Setup, Seed), Inner) end,
        proper:whenfail(fun() -> ok end, Begin),
        maps:get(setup, Outer, [])
    ).

seeded(Setup, Seed) when is_function(Setup, 0) ->
    fun() ->
        _ = seed(Seed, 0),
        Setup()
    end;
seeded(Setup, Seed) ->
    fun(Options) ->
        _ = seed(Seed, 0),
        Setup(Options)
    end.

begin_test(Test, #{property := Property, seed := Seed, next := Next} = Plan) ->
    case Next() of
        Empty when Empty =:= stop; Empty =:= skip ->
            true;
        {instead, Instead} ->
            Instead;
        Number ->
            _ = seed(Seed, Number),
            Running = #{property => Property, seed => Seed, test => Number, attempt => 0},
            _ = put({?MODULE, running}, Running),
            ok = faultcheck_journal:test(#{
                property => Property, seed => Seed, test => Number, size => size()
            }),
            inside(Test, outermost, Plan)
    end.

%% @doc Seeds this process for test Number of the run (0: its set-up): 32 bits of each.
-spec seed(non_neg_integer(), non_neg_integer()) -> rand:state().
seed(Seed, Number) ->
    rand:seed(exsss, ((Seed band 16#FFFFFFFF) bsl 32) bor (Number band 16#FFFFFFFF)).

%% @doc The size PropEr has reached.
-spec size() -> non_neg_integer().
size() -> get('$size').

%% @doc The last exception in a property's body.
-spec exception(ets:tid()) -> {error | exit | throw, term(), list()} | none.
exception(Table) ->
    case ets:lookup(Table, last) of
        [{last, Class, Reason, Stack}] -> {Class, Reason, Stack};
        [] -> none
    end.

sampled(Sample, Printer, #{samples := true, exceptions := Table}) ->
    true = ets:insert(Table, {{sample, erlang:unique_integer([monotonic])}, Sample, Printer}),
    ok;
sampled(_Sample, _Printer, _Plan) ->
    ok.

%% @doc The samples of the last test, which are forgotten.
-spec take_samples(ets:tid()) -> [{Sample :: term(), Printer :: term()}].
take_samples(Table) ->
    Samples = [{S, P} || {{sample, _}, S, P} <- lists:sort(ets:tab2list(Table))],
    true = ets:match_delete(Table, {{sample, '_'}, '_', '_'}),
    Samples.

%% @doc A test with samples.
-spec with_samples([{Sample :: term(), Printer :: term()}], proper:test()) -> proper:test().
with_samples(Samples, Test) ->
    Add = fun({Sample, Printer}, Inner) -> {sample, Sample, Printer, Inner} end,
    lists:foldr(Add, Test, Samples).

%% Walks into the property as far as it is known already, and wraps the parts that come later.
inside({forall, Type, Body}, Place, Plan) when is_function(Body, 1) ->
    {forall, Type, fun(Instance) -> body(Instance, Body, Place, Plan) end};
inside({conjunction, Parts}, Place, Plan) ->
    {conjunction, [{Tag, inside(Part, Place, Plan)} || {Tag, Part} <- Parts]};
inside({implies, Pre, Later}, Place, Plan) ->
    {implies, Pre, later(Later, Place, Plan)};
inside({sample, Sample, Printer, Test}, Place, Plan) ->
    ok = sampled(Sample, Printer, Plan),
    {sample, Sample, Printer, inside(Test, Place, Plan)};
inside({whenfail, Action, Later}, Place, Plan) ->
    {whenfail, fun() -> action(Action) end, later(Later, Place, Plan)};
inside({trapexit, Later}, Place, Plan) ->
    {trapexit, later(Later, Place, Plan)};
inside({timeout, Limit, Later}, Place, Plan) ->
    {timeout, Limit, later(Later, Place, Plan)};
inside(Other, _Place, _Plan) ->
    Other.

body(Instance, _Body, _Place, #{instead := Instead}) ->
    ok = Instead(Instance),
    true;
body(Instance, Body, Place, Plan) ->
    _ = Place =:= outermost andalso attempt(),
    guarded(fun() -> Body(Instance) end, nested, Plan).

attempt() ->
    #{attempt := Attempt} = Running = get({?MODULE, running}),
    _ = put({?MODULE, running}, Running#{attempt := Attempt + 1}),
    faultcheck_journal:attempt().

%% @doc The test that this process runs. none: no such test is running.
-spec running() -> running() | none.
running() ->
    case get({?MODULE, running}) of
        undefined -> none;
        Running -> Running
    end.

later(Later, Place, Plan) when is_function(Later, 0) ->
    fun() -> guarded(Later, Place, Plan) end;
later(Other, _Place, _Plan) ->
    Other.

%% PropEr throws these three to itself.
guarded(Body, Place, #{exceptions := Table} = Plan) ->
    try Body() of
        Test -> inside(Test, Place, Plan)
    catch
        throw:'$arity_limit' ->
            throw('$arity_limit');
        throw:'$cant_generate' ->
            throw('$cant_generate');
        throw:{'$typeserver', Reason} ->
            throw({'$typeserver', Reason});
        Class:Reason:Stack ->
            true = ets:insert(Table, {last, Class, Reason, Stack}),
            failed(Class, Reason, Stack)
    end.

%% PropEr before 1.3 asks for the stack in a way that OTP 24 no longer has, and would end the
%% whole run with `undef'.
failed(Class, Reason, Stack) ->
    case faultcheck_versions:proper() >= [1, 3] of
        true -> erlang:raise(Class, Reason, Stack);
        false -> false
    end.

action(Action) ->
    try
        _ = Action(),
        ok
    catch
        Class:Reason ->
            io:format("the action of a ?WHENFAIL failed: ~0tp:~0tp~n", [Class, Reason])
    end.

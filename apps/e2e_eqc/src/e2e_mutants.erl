%% @doc Properties against one library with a seeded defect: scripts/mutants.sh starts a VM for
%% each, with the defective library where the properties look for it (FAULTCHECK_LIB_DIR).
%%
%% Knows nothing of the library: any property module can be tried on any. Properties take turns, few
%% tests each at first, so that a defect in the last one's reach is found soon, too.
-module(e2e_mutants).

-export([main/1, hunt/2]).
-export_type([verdict/0]).

-type verdict() ::
    {killed, Property :: atom(), Tests :: pos_integer(), Seconds :: float()}
    | {survived, Tests :: non_neg_integer(), Seconds :: float()}.

%% Tests of each property in each round.
-define(ROUNDS, [20, 200, 2000]).

%% @doc Prints the verdict as one line, fields separated by |, and ends the VM: 0 killed,
%% 1 survived.
-spec main([string()]) -> no_return().
main(Modules) ->
    {ok, _} = application:ensure_all_started(c_bridge),
    case hunt([list_to_atom(M) || M <- Modules], ?ROUNDS) of
        {killed, Property, Tests, Seconds} ->
            io:format("killed|~s|~b|~.2f~n", [Property, Tests, Seconds]),
            halt(0);
        {survived, Tests, Seconds} ->
            io:format("survived||~b|~.2f~n", [Tests, Seconds]),
            halt(1)
    end.

%% @doc Runs every property of the modules in each round, until one fails. Tests are those of the
%% property that failed, seconds those of all.
-spec hunt([module()], Rounds :: [pos_integer()]) -> verdict().
hunt(Modules, Rounds) ->
    Started = erlang:monotonic_time(),
    Properties = [{M, P} || M <- Modules, P <- properties(M)],
    Turns = [{Round, Property} || Round <- Rounds, Property <- Properties],
    Found = first_failure(Turns, #{}),
    Ticks = erlang:monotonic_time() - Started,
    Seconds = erlang:convert_time_unit(Ticks, native, microsecond) / 1.0e6,
    case Found of
        {killed, Property, Tests} -> {killed, Property, Tests, Seconds};
        {survived, Tests} -> {survived, Tests, Seconds}
    end.

properties(Module) ->
    [F || {F, 0} <- Module:module_info(exports), lists:prefix("prop_", atom_to_list(F))].

first_failure([], Done) ->
    {survived, lists:sum(maps:values(Done))};
first_failure([{Tests, {Module, Name} = Property} | Turns], Done) ->
    Before = maps:get(Property, Done, 0),
    case failed_after(Module, Name, Tests) of
        none -> first_failure(Turns, Done#{Property => Before + Tests});
        N -> {killed, Name, Before + N}
    end.

%% The seed is the round's, so that the same defect dies the same death each time. PropEr tells the
%% number of tests in what it prints only.
failed_after(Module, Name, Tests) ->
    Seeded = proper:setup(
        fun() ->
            _ = rand:seed(exsss, Tests),
            fun() -> ok end
        end,
        Module:Name()
    ),
    Caller = self(),
    Reference = make_ref(),
    Listen = fun(Format, Arguments) ->
        Tells = string:find(Format, "After ~b test") =/= nomatch,
        _ = [Caller ! {Reference, N} || [N] <- [Arguments], Tells],
        ok
    end,
    Options = [{numtests, Tests}, {on_output, Listen}, noshrink | sizes(Module, Name)],
    case proper:quickcheck(Seeded, Options) of
        true ->
            none;
        _ ->
            receive
                {Reference, N} -> N
            after 0 -> error({no_number_of_tests, Module, Name})
            end
    end.

%% Sizes that the property asks for itself.
sizes(Module, Name) ->
    case erlang:function_exported(Module, Name, 1) of
        true -> [{K, V} || {K, V} <- Module:Name(opts), lists:member(K, [start_size, max_size])];
        false -> []
    end.

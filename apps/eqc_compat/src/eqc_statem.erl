%% @doc Quviq's grouped eqc_statem, by faultcheck_statem.
%%
%% The callbacks of a command f (f/N, f_args/1, f_pre/1,2, f_next/3, f_post/3), weight/2 and
%% initial_state/0 are those of faultcheck_model; all but f and f_args are optional, as there.
-module(eqc_statem).

-export([commands/1, run_commands/2, pretty_commands/4, command_names/1, eq/2]).
-export_type([symbolic_state/0, dynamic_state/0, call/0, var/0]).

-type symbolic_state() :: term().
-type dynamic_state() :: term().
-type var() :: {var, pos_integer()}.
-type call() :: {call, module(), atom(), [term()]}.

-spec commands(module()) -> proper_types:type().
commands(Mod) -> faultcheck_statem:commands(Mod).

%% @doc History (the state in front of each command and its result), last state, and ok or why
%% the run failed.
-spec run_commands(module(), [faultcheck_statem:command()]) -> faultcheck_statem:run().
run_commands(Mod, Commands) -> faultcheck_statem:run_commands(Mod, Commands).

%% @doc Adds to a property that a failing run is printed, a line for each command.
-spec pretty_commands(module(), [faultcheck_statem:command()], faultcheck_statem:run(),
                      proper:test()) -> proper:test().
pretty_commands(Mod, Commands, Run, Property) ->
    proper:whenfail(fun() -> io:put_chars(faultcheck_statem:pretty(Mod, Commands, Run)) end,
                    fun() -> Property end).

-spec command_names([faultcheck_statem:command()]) -> [mfa()].
command_names(Commands) -> faultcheck_statem:command_names(Commands).

%% @doc For postconditions: true, or what differs.
-spec eq(term(), term()) -> true | {term(), '/=', term()}.
eq(A, A) -> true;
eq(A, B) -> {A, '/=', B}.

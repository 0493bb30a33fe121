%% @doc Command sequences of a grouped model under an ordinary PropEr property.
%%
%% ```
%% prop_safety() ->
%%     ?FORALL(Cmds, faultcheck_statem:commands(?MODULE),
%%             begin
%%                 {_, _, Result} = Run = faultcheck_statem:run_commands(?MODULE, Cmds),
%%                 ?WHENFAIL(io:put_chars(faultcheck_statem:pretty(?MODULE, Cmds, Run)),
%%                           aggregate(faultcheck_statem:command_names(Cmds), Result =:= ok))
%%             end).
%% '''
%% faultcheck_model says what a model is. A failing sequence is shrunk by
%% faultcheck_shrinker, driven by PropEr's own loop; last_shrink/0 tells how that went.
%%
%% Before it shrinks, a failure is run 10 more times. One that does not repeat each time is
%% flaky and left as it is. To `proper:quickcheck/2' the ten count as steps for the option
%% max_shrinks; `rebar3 proper' and `faultcheck proper' add them to it.
-module(faultcheck_statem).

-export([commands/1, commands/2, more_commands/2, uniform/2]).
-export([run_commands/2, run_commands/3, command_names/1, pretty/3]).
-export([last_shrink/0, reset_shrink/0]).
-export([type/3]).
-export_type([command/0, history/0, result/0, run/0]).

-type command() :: faultcheck_generator:command().
-type history() :: faultcheck_run:history().
-type result() :: faultcheck_run:result().
-type run() :: faultcheck_run:run().

%% @doc Sequences of a model's commands, as a PropEr type.
-spec commands(module()) -> proper_types:type().
commands(Mod) ->
    commands(Mod, #{}).

%% @doc The same with other limits for shrinking.
-spec commands(module(), faultcheck_shrinker:options()) -> proper_types:type().
commands(Mod, Given) ->
    type(Mod, Given, fun(Size) -> faultcheck_generator:generate(Mod, Size) end).

%% @doc The same from another source of sequences.
-spec type(module(), faultcheck_shrinker:options(),
           fun((Size :: non_neg_integer()) ->
                   {[command()], faultcheck_generator:side()})) -> proper_types:type().
type(Mod, Given, Generate) ->
    Options = faultcheck_shrinker:options(Given),
    faultcheck_proper:new_type(
      fun(Size) -> generate(Generate, Size) end,
      fun(Imm) -> is_list(faultcheck_proper:clean(Imm)) end,
      fun(Imm, _Type, State) -> shrink(Mod, Options, Imm, State) end,
      fun(Base) -> neighbour(Mod, Base) end).

neighbour(Mod, Base) ->
    {Commands, Side} = faultcheck_generator:mutate(Mod, Base),
    faultcheck_proper:with_side(Commands, Side).

generate(Generate, Size) ->
    faultcheck_stats:generated(),
    _ = erase({?MODULE, finished}),
    {Commands, Side} = Generate(Size),
    faultcheck_proper:with_side(Commands, Side).

%% @doc The same type with sequences N times as long.
-spec more_commands(pos_integer(), proper_types:type()) -> proper_types:type().
more_commands(N, Type) ->
    faultcheck_proper:resized(N, Type).

%% @doc Integers Lo..Hi, each equally likely whatever the size of the test: for addresses,
%% masks and times. (PropEr bounds wide ranges by the size.) Shrinks like integer(Lo, Hi).
-spec uniform(integer(), integer()) -> proper_types:type().
uniform(Lo, Hi) when is_integer(Lo), is_integer(Hi), Lo =< Hi ->
    faultcheck_proper:integer_type(Lo, Hi, fun() -> Lo + rand:uniform(Hi - Lo + 1) - 1 end).

%% @doc Module, name and arity of each command, for aggregate/2.
-spec command_names([command()]) -> [mfa()].
command_names(Commands) ->
    [{Mod, Name, length(Args)} || {set, _, {call, Mod, Name, Args}} <- Commands].

%% @doc Runs a sequence up to its end or the first command that fails. An exception of a
%% command is a result like any other failure; it never escapes.
-spec run_commands(module(), [command()]) -> run().
run_commands(Mod, Commands) ->
    faultcheck_run:commands(Mod, Commands, []).

%% @doc The same, with values for variables {var, Name} that the sequence does not set.
-spec run_commands(module(), [command()], [{atom(), term()}]) -> run().
run_commands(Mod, Commands, Environment) ->
    faultcheck_run:commands(Mod, Commands, Environment).

%% @doc A run in words: a line for each command, `mod:command(args) -> result', the one that
%% failed marked with the reason.
-spec pretty(module(), [command()], run()) -> iolist().
pretty(_Mod, Commands, Run) ->
    faultcheck_pretty:format(Commands, Run).

%% @doc How the last failure in this process was shrunk; undefined when none was.
-spec last_shrink() -> undefined | faultcheck_shrinker:summary().
last_shrink() ->
    get({?MODULE, summary}).

%% @doc Forgets it.
-spec reset_shrink() -> ok.
reset_shrink() ->
    _ = erase({?MODULE, summary}),
    ok.

%%% Shrinking, driven by PropEr
%%
%% PropEr asks with `init' first, then with the state it was given: as it was when no candidate
%% failed, or {shrunk, Position, State}. After any success it starts again with `init'; the
%% finished sequence is remembered, so that its candidates do not run a second time.

shrink(Mod, Options, Imm, init) ->
    Commands = faultcheck_proper:clean(Imm),
    case erase({?MODULE, finished}) of
        Commands ->
            {[], done};
        _ ->
            faultcheck_stats:shrinking(),
            Side = case faultcheck_proper:side(Imm) of {ok, S} -> S; none -> #{} end,
            Failure = faultcheck_run:failure(Commands),
            step(faultcheck_shrinker:first(Mod, Commands, Side, {Options, Failure}))
    end;
shrink(_Mod, _Options, Imm, {shrunk, _Position, Continue}) ->
    #{kind := Kind} = faultcheck_run:failure(faultcheck_proper:clean(Imm)),
    step(Continue({fails, Kind}));
shrink(_Mod, _Options, _Imm, Continue) ->
    step(Continue(passes)).

step({try_, Imm, Continue, Summary}) ->
    %% Only if PropEr asks no more, its max_shrinks being reached, does this one stay.
    _ = put({?MODULE, summary}, Summary),
    {[Imm], Continue};
step({done, #{shrunk := Shrunk} = Summary}) ->
    _ = put({?MODULE, summary}, Summary),
    _ = put({?MODULE, finished}, Shrunk),
    {[], done}.

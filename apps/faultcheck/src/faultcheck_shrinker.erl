%% @doc Minimises a failing command sequence.
%%
%% A state machine: it hands out one candidate at a time, {try_, Candidate, Continue}, and is
%% told by Continue(Verdict) whether the failure is still there. faultcheck_statem lets
%% PropEr's shrink loop drive it; minimise/5 drives it with a function.
%%
%% ```
%% 0  confirm: the original is run again `confirm' times. If it passes once, it is flaky
%%    and not shrunk
%% 1  cut behind the command that failed
%% 2  remove chunks of n/2, n/4, ..., 1 commands, from the end to the front; single
%%    commands until a whole pass removes nothing
%% 3  shrink arguments (faultcheck_argument_shrinker), command by command until nothing
%%    changes; after any change single commands are tried again
%% 4  the same with every value near the simplest one of each number, `linear' of them
%% 5  remove a command while a value moves by one bit (faultcheck_joint_shrinker); after a
%%    success single commands are tried again
%% 6  renumber the variables
%% '''
%%
%% Every candidate is made legal by faultcheck_repair first, and none is tried twice. The
%% result is minimal: no single command can be removed and no argument shrunk by one step.
-module(faultcheck_shrinker).

-export([first/4, minimise/5, options/1, summary/1]).
-export([attempt/4, best/1]).
-export_type([options/0, verdict/0, kind/0, step/0, summary/0, state/0, failure/0]).

-type options() :: #{confirm => non_neg_integer(),  % re-runs of the original, 10
                     max_tries => pos_integer(),    % candidates, 20000
                     max_ms => pos_integer(),       % time for candidates, 60000
                     linear => pos_integer()}.      % values of a number tried one by one, 256
%% What went wrong, as far as it is known: a candidate that fails in another way is no
%% smaller version of the same failure.
-type kind() :: term() | unknown.
-type verdict() :: passes | {fails, kind()}.
-type failure() :: #{kind := kind(),
                     at := pos_integer() | unknown}. % number of the command that failed
%% A candidate comes with the summary that holds if it is the last one asked for.
-type step() :: {try_, faultcheck_proper:imm(), fun((verdict()) -> step()), summary()}
              | {done, summary()}.
-type summary() :: #{original := [faultcheck_generator:command()],
                     shrunk := [faultcheck_generator:command()],
                     tries := non_neg_integer(),
                     accepted := non_neg_integer(),
                     ms := non_neg_integer(),
                     minimal := boolean(),
                     stopped := none | max_tries | max_ms | max_shrinks,
                     flaky := false | {Failed :: non_neg_integer(), Runs :: pos_integer()}}.

-record(state, {mod :: module(),
                options :: options(),
                kind :: kind(),
                at :: pos_integer() | unknown,
                names :: faultcheck_repair:names(),
                original :: [faultcheck_generator:command()],
                commands :: [faultcheck_generator:command()], % the best so far
                side :: faultcheck_generator:side(),
                seen = #{} :: #{[faultcheck_generator:command()] => true},
                strayed = false :: boolean(), % the last to fail did so in another way
                tries = 0 :: non_neg_integer(),
                accepted = 0 :: non_neg_integer(),
                began :: integer(),
                deadline :: integer(),
                flaky = false :: false | {non_neg_integer(), pos_integer()},
                stopped = none :: none | max_tries | max_ms}).
-opaque state() :: #state{}.
-type continue() :: fun((boolean(), state()) -> step()).

%% @doc Fills in defaults; an unknown option or a wrong value is the caller's error.
-spec options(map()) -> options().
options(Given) ->
    Default = #{confirm => 10, max_tries => 20000, max_ms => 60000, linear => 256},
    Known = lists:sort(maps:keys(Default)),
    maps:foreach(fun(confirm, V) when is_integer(V), V >= 0 -> ok;
                    (Key, V) when is_integer(V), V > 0, is_map_key(Key, Default) -> ok;
                    (Key, V) -> error({shrink_option, Key, V, {known, Known}})
                 end, Given),
    maps:merge(Default, Given).

%% @doc The first step for a failing sequence.
-spec first(module(), [faultcheck_generator:command()], faultcheck_generator:side(),
            {options(), failure()}) -> step().
first(Mod, Commands, Side, {Options, #{kind := Kind, at := At}}) ->
    Now = now_ms(),
    State = #state{mod = Mod, options = Options, kind = Kind, at = At,
                   names = faultcheck_repair:names(Commands),
                   original = Commands, commands = Commands, side = Side,
                   began = Now, deadline = Now},
    confirm(maps:get(confirm, Options), 0, State).

%% @doc Minimises with a function that runs a sequence, instead of a property: for a failure
%% that was rebuilt from the journal of a dead VM. Outside a property it needs
%% faultcheck_proper:with_state/3 around it, since arguments may be generated anew.
-spec minimise(module(), [faultcheck_generator:command()], faultcheck_generator:side(),
               fun(([faultcheck_generator:command()]) -> verdict()), {options(), failure()}) ->
          summary().
minimise(Mod, Commands, Side, Run, {Options, Failure}) ->
    drive(first(Mod, Commands, Side, {Options, Failure}), Run).

drive({done, Summary}, _Run) -> Summary;
drive({try_, Imm, Continue, _}, Run) -> drive(Continue(Run(faultcheck_proper:clean(Imm))), Run).

%% @doc The best sequence so far.
-spec best(state()) -> {module(), [faultcheck_generator:command()], faultcheck_generator:side()}.
best(#state{mod = Mod, commands = Commands, side = Side}) ->
    {Mod, Commands, Side}.

%%% 0 Confirm

confirm(0, _Failed, State) ->
    cut(start_clock(State));
%% A pass does not end this early: the rate is that of all runs.
confirm(Left, Failed, #state{commands = Commands, side = Side, options = Options} = State) ->
    Runs = maps:get(confirm, Options),
    offer(Commands, Side, State, State,
          fun(passes, Next) -> confirmed(Left - 1, Failed, Runs, Next);
             ({fails, Kind}, Next) ->
                  confirmed(Left - 1, Failed + 1, Runs, Next#state{kind = common(Kind, Next)})
          end).

confirmed(0, Failed, Runs, State) when Failed < Runs ->
    finish(State#state{flaky = {Failed, Runs}});
confirmed(Left, Failed, _Runs, State) ->
    confirm(Left, Failed, State).

%% Memory errors show in different ways from run to run. Then any failure counts.
common(Kind, #state{kind = Kind}) -> Kind;
common(_, _) -> unknown.

start_clock(#state{options = #{max_ms := Limit}} = State) ->
    State#state{deadline = now_ms() + Limit}.

%%% 1 Cut behind the failure

cut(#state{at = At, commands = Commands} = State) when is_integer(At), At < length(Commands) ->
    attempt(lists:sublist(Commands, At), State#state.side, State,
            fun(_, Next) -> chunks(Next) end);
cut(State) ->
    chunks(State).

%%% 2 Remove chunks

chunks(#state{commands = Commands} = State) ->
    chunks(max(1, length(Commands) div 2), State).

chunks(1, State) ->
    singles(State);
chunks(Size, #state{commands = Commands} = State) ->
    windows(Size, length(Commands), State, fun(Next) -> chunks(Size div 2, Next) end).

%% Single commands until a whole pass removes nothing; then arguments.
singles(State) ->
    singles(State, fun arguments/1).

singles(#state{commands = Commands} = State, Then) ->
    windows(1, length(Commands), State,
            fun(#state{commands = Now} = Next) when length(Now) < length(Commands) ->
                    singles(Next, Then);
               (Next) ->
                    Then(Next)
            end).

windows(_Size, End, State, Then) when End < 1 ->
    Then(State);
windows(Size, End, #state{commands = Commands} = State, Then) when End > length(Commands) ->
    windows(Size, length(Commands), State, Then);
windows(Size, End, #state{commands = Commands, side = Side} = State, Then) ->
    From = max(1, End - Size + 1),
    {Front, Rest} = lists:split(From - 1, Commands),
    Back = lists:nthtail(End - From + 1, Rest),
    attempt(Front ++ Back, Side, State, fun(_, Next) -> windows(Size, From - 1, Next, Then) end).

%%% 3, 4 Arguments

%% A few values of a number one by one before bisecting: most minima are near the simplest.
-define(FIRST_VALUES, 3).

arguments(State) ->
    round(?FIRST_VALUES, State, fun thorough/1).

thorough(#state{options = #{linear := Linear}} = State) ->
    round(Linear, State, fun joint/1).

round(Linear, #state{commands = Commands} = State, Then) ->
    Vars = [N || {set, {var, N}, _} <- Commands],
    each(Vars, Linear, State,
         fun(#state{commands = Now} = Next) when Now =:= Commands -> Then(Next);
            (Next) -> singles(Next)
         end).

each([], _Linear, State, Then) ->
    Then(State);
each([Var | Vars], Linear, State, Then) ->
    faultcheck_argument_shrinker:command(Var, Linear, State,
                                         fun(Next) -> each(Vars, Linear, Next, Then) end).

%%% 5 Remove a command and move a value

joint(#state{mod = Mod, commands = Commands} = State) ->
    joint(faultcheck_joint_shrinker:candidates(Mod, Commands), State).

joint([], State) ->
    renumber(State);
joint([Candidate | Rest], #state{side = Side} = State) ->
    attempt(Candidate, moved_side(Candidate, State#state.commands, Side), State,
            fun(true, Next) -> singles(Next);
               (false, Next) -> joint(Rest, Next)
            end).

%% Values that moved have no intermediate form any more.
moved_side(Candidate, Commands, Side) ->
    maps:with([N || {set, {var, N}, _} = Command <- Candidate, lists:member(Command, Commands)],
              Side).

%%% 6 Renumber

renumber(#state{commands = Commands, side = Side} = State) ->
    {Numbered, NumberedSide} = faultcheck_repair:renumber(Commands, Side),
    case Numbered =:= Commands of
        true -> finish(State);
        false -> attempt(Numbered, NumberedSide, State, fun(_, Next) -> finish(Next) end)
    end.

%%% Candidates

%% @doc Tries a sequence, once it is legal, unless it was tried before. Continues with
%% whether it was accepted as the new best.
-spec attempt([faultcheck_generator:command()], faultcheck_generator:side(), state(), continue()) ->
          step().
attempt(Commands, Side, #state{mod = Mod, names = Names, seen = Seen} = State, Continue) ->
    {Legal, LegalSide} = faultcheck_repair:repair(Mod, Commands, Side, Names),
    case Legal =:= State#state.commands orelse is_map_key(Legal, Seen) of
        true ->
            Continue(false, State);
        false ->
            case budget(State) of
                none ->
                    If = State#state{commands = Legal, accepted = State#state.accepted + 1},
                    offer(Legal, LegalSide, State#state{seen = Seen#{Legal => true}}, If,
                          judge(Legal, LegalSide, Continue));
                Limit ->
                    finish(State#state{stopped = Limit})
            end
    end.

judge(Commands, Side, Continue) ->
    fun(passes, State) ->
            Continue(false, State);
       ({fails, Kind}, #state{kind = Wanted} = State)
          when Kind =:= Wanted; Kind =:= unknown; Wanted =:= unknown ->
            Continue(true, State#state{commands = Commands, side = Side, strayed = false,
                                       accepted = State#state.accepted + 1});
       ({fails, _}, State) ->
            Continue(false, State#state{strayed = true})
    end.

%% Last is how far it has come if PropEr asks no more, which it does after a failure only.
offer(Commands, Side, State, Last, Then) ->
    Next = State#state{tries = State#state.tries + 1},
    faultcheck_progress:report(
      shrinking, fun() ->
              #{tries => Next#state.tries, accepted => Next#state.accepted,
                original => length(Next#state.original), length => length(Next#state.commands)}
      end),
    {try_, faultcheck_proper:with_side(Commands, Side), fun(Verdict) -> Then(Verdict, Next) end,
     (summary(Last))#{tries := Next#state.tries, minimal := false, stopped := max_shrinks}}.

budget(#state{tries = Tries, options = #{max_tries := Max}}) when Tries >= Max ->
    max_tries;
budget(#state{deadline = Deadline}) ->
    case now_ms() >= Deadline of
        true -> max_ms;
        false -> none
    end.

%% The driver keeps the last sequence that failed, in whatever way: offer the best again.
finish(#state{strayed = true, commands = Commands, side = Side} = State) ->
    offer(Commands, Side, State, State, fun(_, Next) -> {done, summary(Next)} end);
finish(State) ->
    {done, summary(State)}.

%% @doc How far it has come.
-spec summary(state()) -> summary().
summary(#state{stopped = Stopped, flaky = Flaky} = State) ->
    #{original => State#state.original,
      shrunk => State#state.commands,
      tries => State#state.tries,
      accepted => State#state.accepted,
      ms => now_ms() - State#state.began,
      minimal => Stopped =:= none andalso Flaky =:= false,
      stopped => Stopped,
      flaky => Flaky}.

now_ms() ->
    erlang:monotonic_time(millisecond).

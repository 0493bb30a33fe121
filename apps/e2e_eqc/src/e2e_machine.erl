%% @doc The E2E state machine as e2e.md section 8 describes it. The window is a list, newest verdict
%% first, always as long as WindowSizeValid.
-module(e2e_machine).

-export([initial/1, check/3, names/0]).
-export_type([config/0, machine/0, name/0]).

-type config() :: #{atom() => non_neg_integer()}.
-type name() :: 'VALID' | 'DEINIT' | 'NODATA' | 'INIT' | 'INVALID'.
-type machine() :: #{
    state := name(),
    window := [e2e_receiver:verdict()],
    top := non_neg_integer(),
    ok := non_neg_integer(),
    errors := non_neg_integer()
}.

-spec names() -> [name()].
names() -> ['NODATA', 'INIT', 'VALID', 'INVALID'].

%% @doc After SMCheckInit.
-spec initial(config()) -> machine().
initial(Config) -> clear(Config, #{state => 'NODATA'}).

%% @doc Takes one verdict into account.
-spec check(config(), machine(), e2e_receiver:verdict()) ->
    {e2e_receiver:answer(), machine()}.
check(_, #{state := 'DEINIT'} = Machine, _) ->
    {wrong_state, Machine};
check(Config, #{state := 'NODATA'} = Machine, Verdict) ->
    case Verdict of
        'ERROR' -> {ok, Machine};
        'NONEWDATA' -> {ok, Machine};
        _ -> {ok, (clear(Config, Machine))#{state := 'INIT'}}
    end;
check(Config, #{state := State} = Machine, Verdict) ->
    Added = add(Config, Verdict, Machine),
    {ok, move(State, good(State, Config, Added), Config, Added)}.

move('VALID', true, _, Machine) ->
    Machine;
move('VALID', false, Config, Machine) ->
    case maps:get('ClearToInvalid', Config) of
        0 -> Machine#{state := 'INVALID'};
        _ -> to_invalid(Config, Machine)
    end;
move(_, true, Config, Machine) ->
    (forget('VALID', Config, Machine))#{state := 'VALID'};
move('INIT', false, #{'MaxErrorStateInit' := Most} = Config, #{errors := Errors} = Machine) when
    Errors > Most
->
    to_invalid(Config, Machine);
move(_, false, _, Machine) ->
    Machine.

to_invalid(#{'ClearToInvalid' := 0} = Config, Machine) ->
    (forget('INVALID', Config, Machine))#{state := 'INVALID'};
to_invalid(Config, Machine) ->
    (clear(Config, Machine))#{state := 'INVALID'}.

good(State, Config, #{ok := Ok, errors := Errors}) ->
    {Least, Most} = limits(State, Config),
    Errors =< Most andalso Ok >= Least.

limits('INIT', #{'MinOkStateInit' := Ok, 'MaxErrorStateInit' := Errors}) -> {Ok, Errors};
limits('VALID', #{'MinOkStateValid' := Ok, 'MaxErrorStateValid' := Errors}) -> {Ok, Errors};
limits('INVALID', #{'MinOkStateInvalid' := Ok, 'MaxErrorStateInvalid' := Errors}) -> {Ok, Errors}.

size('INIT', #{'WindowSizeInit' := N}) -> N;
size('INVALID', #{'WindowSizeInvalid' := N}) -> N;
size(_, #{'WindowSizeValid' := N}) -> N.

add(Config, Verdict, #{state := State, window := Window, top := Top} = Machine) ->
    Valid = size('VALID', Config),
    Newest = lists:sublist([Verdict | Window], size(State, Config)),
    Machine#{
        window := lists:sublist([Verdict | Window], Valid),
        top := (Top + 1) rem Valid,
        ok := length([ok || 'OK' <- Newest]),
        errors := length([error || 'ERROR' <- Newest])
    }.

clear(Config, Machine) ->
    Machine#{window => empty(size('VALID', Config)), top => 0, ok => 0, errors => 0}.

%% "Clear remaining": only before a state with a larger window.
forget(Next, Config, #{state := State, window := Window} = Machine) ->
    case {size(State, Config), size(Next, Config)} of
        {Here, There} when Here < There ->
            Kept = lists:sublist(Window, Here),
            Machine#{window := Kept ++ empty(length(Window) - Here)};
        _ ->
            Machine
    end.

empty(N) -> lists:duplicate(N, 'NOTAVAILABLE').

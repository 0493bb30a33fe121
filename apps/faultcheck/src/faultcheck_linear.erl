%% @doc Is there an order of calls that a model explains?
%%
%% Calls that ran at once are linearisable when some order of them, which keeps the order inside
%% each thread and puts no call before one that had returned when it began, gives in the model
%% the results that were seen. The search goes depth first and remembers from where it has failed
%% before: calls left and state of the model.
-module(faultcheck_linear).

-export([explain/3]).
-export_type([outcome/0, call/0]).

%% What each command gave, by variable, and where it is known when it began and ended: numbers that
%% grow, all different.
-type outcome() :: {
    Results :: #{pos_integer() => term()},
    Times :: #{pos_integer() => {Begin :: integer(), End :: integer()}}
}.
-type call() :: {Var :: pos_integer(), Name :: atom(), Args :: [term()], Result :: term()}.

-record(search, {
    model :: {module(), faultcheck_model:info()},
    times :: #{pos_integer() => {integer(), integer()}},
    failed = #{} :: #{term() => true},
    longest = [] :: [call()]
}).

%% @doc An order that explains the outcome; or the longest beginning of one, behind which the model
%% allows none of the next calls.
-spec explain(module(), faultcheck_parallel_case:test_case(), outcome()) ->
    {explained, [call()]} | {unexplained, [call()]}.
explain(Mod, {parallel, First, Branches, Last}, {Results, Times}) ->
    Calls = fun(Commands) -> [call(Command, Results) || Command <- Commands] end,
    Phases = [[Calls(First)], [Calls(B) || B <- Branches], [Calls(Last)]],
    Search = #search{model = {Mod, faultcheck_model:info(Mod)}, times = Times},
    case phases(Phases, Mod:initial_state(), [], Search) of
        {found, Order} -> {explained, lists:reverse(Order)};
        #search{longest = Longest} -> {unexplained, lists:reverse(Longest)}
    end.

call({set, {var, N}, {call, _, Name, Args}}, Results) ->
    {N, Name, faultcheck_run:evaluate(Args, Results), maps:get(N, Results)}.

phases([], _State, Done, _Search) ->
    {found, Done};
phases([Lanes | Phases], State, Done, Search) ->
    case lists:append(Lanes) of
        [] -> phases(Phases, State, Done, Search);
        _ -> once([Lanes | Phases], State, Done, Search)
    end.

once(Phases, State, Done, #search{failed = Failed} = Search) ->
    Here = {[length(Lane) || Lane <- lists:append(Phases)], State},
    case Failed of
        #{Here := true} ->
            Search;
        #{} ->
            case heads(Phases, [], State, Done, longer(Done, Search)) of
                {found, _} = Found -> Found;
                #search{failed = Now} = Next -> Next#search{failed = Now#{Here => true}}
            end
    end.

longer(Done, #search{longest = Longest} = Search) when length(Done) > length(Longest) ->
    Search#search{longest = Done};
longer(_, Search) ->
    Search.

%% Passed are the lanes of this phase whose next call was tried.
heads([[] | _], _Passed, _State, _Done, Search) ->
    Search;
heads([[[] | Lanes] | Phases], Passed, State, Done, Search) ->
    heads([Lanes | Phases], Passed ++ [[]], State, Done, Search);
heads([[[Call | Rest] = Lane | Lanes] | Phases], Passed, State, Done, Search) ->
    Others = Passed ++ Lanes,
    case may_be_next(Call, Others, Search) andalso step(Call, State, Search) of
        {ok, Next} ->
            case phases([Passed ++ [Rest | Lanes] | Phases], Next, [Call | Done], Search) of
                {found, _} = Found ->
                    Found;
                Tried ->
                    heads([Lanes | Phases], Passed ++ [Lane], State, Done, Tried)
            end;
        false ->
            heads([Lanes | Phases], Passed ++ [Lane], State, Done, Search)
    end.

%% A lane's first call ends first.
may_be_next({N, _, _, _}, Others, #search{times = Times}) ->
    case Times of
        #{N := {Begin, _}} ->
            Ends = [element(2, maps:get(M, Times)) || [{M, _, _, _} | _] <- Others],
            not lists:any(fun(End) -> End < Begin end, Ends);
        #{} ->
            true
    end.

%% A model that raises does not explain the call.
step({_, _, _, {exception, _, _, _}}, _State, _Search) ->
    false;
step({_, Name, Args, Result}, State, #search{model = Model}) ->
    try
        faultcheck_model:allowed(Model, State, Name, Args) andalso
            faultcheck_model:post(Model, State, Name, Args, Result) =:= true andalso
            {ok, faultcheck_model:next(Model, State, Name, Args, Result)}
    catch
        error:_ -> false
    end.

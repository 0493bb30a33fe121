%% @doc What a run exercised: commands, faults, lengths, rejected preconditions and
%% requirement tags. Gathered between start/0 and stop/0 only; otherwise a call costs one
%% look at a persistent term.
%%
%% The counters are in a table that every process may write to, since PropEr runs the
%% body of ?TIMEOUT and ?TRAPEXIT in a process of its own. Runs made while a failure is
%% being shrunk are not counted.
-module(faultcheck_stats).

-export([start/0, stop/0, format/1]).
-export([take/0, add/1]).
-export([active/0, generated/0, shrinking/0, rejected/1, sequence/4]).
-export_type([stats/0, rows/0]).

-type rows() :: [{Key :: term(), pos_integer()}].
-type counts() :: #{term() => pos_integer()}.
-type stats() :: #{tests := non_neg_integer(),
                   commands := counts(),
                   faults := counts(),
                   lengths := counts(),
                   rejected := counts(),
                   requirements := counts()}.

%% @doc Starts counting from zero.
-spec start() -> ok.
start() ->
    _ = stop(),
    %% The heir keeps nothing: the table ends with its owner, the process that started it.
    Table = ets:new(?MODULE, [public, set, {write_concurrency, true}]),
    persistent_term:put(?MODULE, Table).

%% @doc Ends counting and gives the counts; all are zero when it was not started.
-spec stop() -> stats().
stop() ->
    case table() of
        none ->
            stats([]);
        Table ->
            _ = persistent_term:erase(?MODULE),
            Rows = ets:tab2list(Table),
            true = ets:delete(Table),
            stats(Rows)
    end.

%% @doc The counts so far, as add/1 takes them; counting goes on from zero.
-spec take() -> rows().
take() ->
    case table() of
        none ->
            [];
        Table ->
            Rows = [Row || {Key, N} = Row <- ets:tab2list(Table), is_integer(N), Key =/= shrinking],
            _ = [ets:delete(Table, Key) || {Key, _} <- Rows],
            Rows
    end.

%% @doc Adds counts that were taken elsewhere.
-spec add(rows()) -> ok.
add(Rows) ->
    with_table(fun(Table) ->
                       [ets:update_counter(Table, Key, N, {Key, 0}) || {Key, N} <- Rows]
               end).

%% @doc Is anything being counted?
-spec active() -> boolean().
active() ->
    case table() of
        none -> false;
        Table -> not ets:member(Table, shrinking)
    end.

%% @doc A new sequence was generated: shrinking, if any, is over.
-spec generated() -> ok.
generated() ->
    with_table(fun(Table) -> ets:delete(Table, shrinking) end).

%% @doc From here on runs are candidates of the shrinker.
-spec shrinking() -> ok.
shrinking() ->
    with_table(fun(Table) -> ets:insert(Table, {shrinking, true}) end).

%% @doc The precondition of a command rejected generated arguments.
-spec rejected(atom()) -> ok.
rejected(Name) ->
    with_table(fun(Table) -> count(Table, {rejected, Name}) end).

%% @doc A sequence was run: names of the commands executed, those of them that are
%% faults, its length, and requirement tags. Only called when active().
-spec sequence([atom()], [atom()], non_neg_integer(), [term()]) -> ok.
sequence(Names, FaultNames, Length, Tags) ->
    with_table(fun(Table) ->
                       _ = count(Table, tests),
                       _ = count(Table, {lengths, Length}),
                       _ = [count(Table, {commands, Name}) || Name <- Names],
                       _ = [count(Table, {faults, Name}) || Name <- FaultNames],
                       [count(Table, {requirements, Tag}) || Tag <- Tags]
               end).

%% @doc A readable table of the counts.
-spec format(stats()) -> iolist().
format(#{tests := Tests} = Stats) ->
    Sections = [{commands, "commands"}, {faults, "faults"},
                {rejected, "rejected by preconditions"}, {requirements, "requirements"}],
    [io_lib:format("~b sequences~n", [Tests]),
     lengths(maps:get(lengths, Stats)),
     [section(Title, maps:get(Key, Stats)) || {Key, Title} <- Sections]].

lengths(Lengths) when map_size(Lengths) =:= 0 ->
    [];
lengths(Lengths) ->
    Rows = lists:sort(maps:to_list(Lengths)),
    Runs = lists:sum([N || {_, N} <- Rows]),
    Total = lists:sum([L * N || {L, N} <- Rows]),
    {Shortest, _} = hd(Rows),
    {Longest, _} = lists:last(Rows),
    io_lib:format("lengths: ~b to ~b, mean ~.1f~n", [Shortest, Longest, Total / Runs]).

section(_Title, Counts) when map_size(Counts) =:= 0 ->
    [];
section(Title, Counts) ->
    Total = lists:sum(maps:values(Counts)),
    %% Most frequent first; names decide between equals, so that the order is fixed.
    Rows = lists:sort([{-N, Key} || {Key, N} <- maps:to_list(Counts)]),
    [io_lib:format("~ts:~n", [Title]),
     [io_lib:format("  ~10b  ~5.1f%  ~tp~n", [-N, -100 * N / Total, Key]) || {N, Key} <- Rows]].

with_table(Fun) ->
    case table() of
        none -> ok;
        Table -> _ = Fun(Table), ok
    end.

%% none also when the process that started counting has ended.
table() ->
    case persistent_term:get(?MODULE, none) of
        none ->
            none;
        Table ->
            case ets:info(Table, id) of
                undefined -> none;
                _ -> Table
            end
    end.

count(Table, Key) ->
    ets:update_counter(Table, Key, 1, {Key, 0}).

stats(Rows) ->
    Kinds = [commands, faults, lengths, rejected, requirements],
    Counts = [{Kind, maps:from_list([{Key, N} || {{K, Key}, N} <- Rows, K =:= Kind])}
              || Kind <- Kinds],
    maps:from_list([{tests, proplists:get_value(tests, Rows, 0)} | Counts]).

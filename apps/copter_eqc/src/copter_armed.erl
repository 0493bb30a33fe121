%% @doc The faults of a flight so far: what was armed where, when it acts, how often it has acted.
%%
%% libfaultcheck numbers faults in the order of arming, so those that a call has armed are the new
%% ones of its listing.
-module(copter_armed).

-export([new/0, armed/4, cleared/3, items/2, key/2, copters/2, named/2]).
-export([object_of/1]).
-export_type([armed/0, named/0]).

-record(item, {
    id :: faultcheck_inject:id(),
    object :: replay_source:id() | -1,
    place :: binary(),
    model :: binary(),
    %% JSON
    params :: binary(),
    from_us :: non_neg_integer(),
    to_us :: non_neg_integer() | -1,
    hits = 0 :: non_neg_integer()
}).
%% Newest first.
-opaque armed() :: [#item{}].

-define(NS_PER_US, 1000).

%% @doc None yet.
-spec new() -> armed().
new() -> [].

%% @doc What a call has armed, given as it was asked for; and the new faults' numbers are looked up.
-spec armed([named()], Now_us :: non_neg_integer(), Dt_us :: pos_integer(), armed()) -> armed().
armed(Faults, Now, Dt, Armed) ->
    Known = [I#item.id || I <- Armed],
    New = lists:usort([Id || #{id := Id} <- listed(), not lists:member(Id, Known)]),
    lists:foldl(
        fun({Id, Fault}, Items) -> [item(Id, Fault, Now, Dt) | Items] end,
        Armed,
        lists:zip(New, Faults)
    ).

-type named() :: {
    faultcheck_inject:where(), Model :: binary(), Params :: faultcheck_json:json(),
    faultcheck_fault:trigger()
}.

%% @doc An arming of the model by its names.
-spec named(copter_fault:arming(), Dt_us :: pos_integer()) -> named().
named({Where, Fault, Seed}, Dt) ->
    {_, Trigger} = faultcheck_fault:normal(Fault),
    [{model, Model} | Members] = copter_scenario:fault(Where, Fault, Dt),
    Own = [{seed, Seed} || Seed =/= none],
    {Where, atom_to_binary(Model), {object, Members ++ Own}, Trigger}.

item(Id, {Where, Model, Params, Trigger}, Now, Dt) ->
    Place = element(2, Where),
    From = Now + begins(Trigger),
    #item{
        id = Id,
        object = object_of(Place),
        place = Place,
        model = Model,
        params = faultcheck_json:encode(Params),
        from_us = From,
        to_us = ends(From, Trigger, Place, Dt)
    }.

begins(Trigger) ->
    case lists:keyfind(time, 1, Trigger) of
        {time, Delay, _} -> Delay div ?NS_PER_US;
        false -> 0
    end.

%% A number of calls lasts so many steps only at a probe that is called once a step; one that
%% begins after so many calls has no known end.
ends(From, Trigger, Place, Dt) ->
    case [lists:keyfind(Key, 1, Trigger) || Key <- [time, for, from]] of
        [{time, _, forever}, _, _] -> -1;
        [{time, _, Lasting}, _, _] -> From + Lasting div ?NS_PER_US;
        [false, {for, Calls}, false] -> calls_end(From + Calls * Dt, Place);
        _ -> -1
    end.

calls_end(T, Place) ->
    case copter_view_params:is_position(Place) of
        true -> T;
        false -> -1
    end.

%% @doc The copter that a probe or channel belongs to: PxId3, RangeId3Anch0, ITS_DATA3; or -1.
-spec object_of(binary()) -> replay_source:id().
object_of(Place) ->
    case re:run(Place, "(?:Id|ITS_DATA)([0-9]+)", [{capture, all_but_first, binary}]) of
        {match, [Digits]} -> binary_to_integer(Digits);
        nomatch -> -1
    end.

%% @doc Those of a place, or all of them, end now. To be called before they are disarmed.
-spec cleared(binary() | all, Now_us :: non_neg_integer(), armed()) -> armed().
cleared(Where, Now, Armed) ->
    [
        case Where =:= all orelse Where =:= Place of
            true -> I#item{to_us = earlier(Now, To), hits = Hits};
            false -> I
        end
     || {#item{to_us = To, place = Place} = I, Hits} <- with_hits(Armed)
    ].

earlier(Now, -1) -> Now;
earlier(Now, To) -> min(Now, To).

with_hits([]) ->
    [];
with_hits(Armed) ->
    Applied = lists:foldl(
        fun(#{id := Id, applied := N}, Sums) ->
            maps:update_with(Id, fun(Sum) -> Sum + N end, N, Sums)
        end,
        #{},
        listed()
    ),
    [{I, maps:get(I#item.id, Applied, I#item.hits)} || I <- Armed].

listed() ->
    #{lib := Lib, faults := Context} = copter_sut:instance(),
    {ok, Entries} = faultcheck_context:list(Lib, Context),
    [Fault || #{faults := Faults} <- Entries, Fault <- Faults].

%% @doc What VIZ_FAULTS says of them at a time, oldest first.
-spec items(Now_us :: non_neg_integer(), armed()) -> [replay_source:fault()].
items(Now, Armed) ->
    [
        #{
            object => I#item.object,
            probe => I#item.place,
            type => I#item.model,
            params => I#item.params,
            from_us => I#item.from_us,
            to_us => I#item.to_us,
            active => flag(active(Now, I)),
            hits => Hits
        }
     || {I, Hits} <- lists:reverse(with_hits(Armed))
    ].

flag(true) -> 1;
flag(false) -> 0.

%% @doc Another term whenever a fault comes, goes, begins or ends.
-spec key(Now_us :: non_neg_integer(), armed()) -> term().
key(Now, Armed) -> [{I#item.to_us, active(Now, I)} || I <- Armed].

%% @doc Copters that a fault acts on at a time, ascending.
-spec copters(Now_us :: non_neg_integer(), armed()) -> [replay_source:id()].
copters(Now, Armed) ->
    lists:usort([I#item.object || I <- Armed, I#item.object >= 0, active(Now, I)]).

active(Now, #item{from_us = From, to_us = To}) -> From =< Now andalso (To =:= -1 orelse Now < To).

%% @doc A packet channel with its receivers (faultcheck.md, 4 and 7.7). What channels do to each
%% other, and the faults' walk, is in faultcheck_ref_get and faultcheck_ref_put.
-module(faultcheck_ref_channel).

-export([new/0, exists/1, receiver/2, subscribe/2, store/2, recipients/1, names/1]).
-export([append/4, visible/2, clear/1, depth/2]).
-export_type([channel/0, receiver/0, packet/0]).

-type packet() :: {Bytes :: binary() | any, FromGet :: non_neg_integer(), FromTime :: integer()}.
-type receiver() :: #{
    name := binary(),
    subscribed := boolean(),
    queue := [packet()],
    gets := non_neg_integer(),
    last := none | any | binary()
}.
-type channel() :: #{
    %% got a packet, a fault or a receiver
    exists := boolean(),
    receivers := #{binary() => receiver()},
    faults := [faultcheck_ref_fault:fault()],
    ordinal := non_neg_integer(),
    refused := boolean()
}.

-spec new() -> channel().
new() ->
    #{
        exists => false,
        receivers => #{<<>> => new_receiver(<<>>)},
        faults => [],
        ordinal => 0,
        refused => false
    }.

new_receiver(Name) ->
    #{name => Name, subscribed => false, queue => [], gets => 0, last => none}.

-spec exists(channel()) -> boolean().
exists(#{exists := Exists}) -> Exists.

%% @doc The receiver of that name.
-spec receiver(binary(), channel()) -> {ok, receiver()} | error.
receiver(Name, #{receivers := Receivers}) -> maps:find(Name, Receivers).

%% @doc Each subscribed receiver has a queue of its own.
-spec subscribe(binary(), channel()) -> channel().
subscribe(Name, #{receivers := Receivers} = Channel) ->
    Receiver = maps:get(Name, Receivers, new_receiver(Name)),
    store(Receiver#{subscribed := true}, Channel#{exists := true}).

%% @doc With a receiver as it is now.
-spec store(receiver(), channel()) -> channel().
store(#{name := Name} = Receiver, #{receivers := Receivers} = Channel) ->
    Channel#{receivers := Receivers#{Name => Receiver}}.

-spec names(channel()) -> [binary()].
names(#{receivers := Receivers}) -> maps:keys(Receivers).

%% @doc Who gets what is put: those who subscribed; the receiver "" when nobody did.
-spec recipients(channel()) -> [receiver()].
recipients(#{receivers := Receivers}) ->
    case [R || #{subscribed := true} = R <- maps:values(Receivers)] of
        [] -> [maps:get(<<>>, Receivers)];
        Subscribed -> Subscribed
    end.

%% @doc Queues a packet, hidden for that many gets of this receiver and until that time.
-spec append(binary() | any, non_neg_integer(), integer(), receiver()) -> receiver().
append(Bytes, HiddenGets, FromTime, #{queue := Queue, gets := Gets} = Receiver) ->
    Receiver#{queue := Queue ++ [{Bytes, Gets + HiddenGets, FromTime}]}.

%% @doc The packets that the receiver can see now: a hidden one blocks those behind it.
-spec visible(integer(), receiver()) -> {[packet()], [packet()]}.
visible(Now, #{queue := Queue, gets := Gets}) ->
    lists:splitwith(fun({_, FromGet, FromTime}) -> FromGet =< Gets andalso FromTime =< Now end,
                    Queue).

-spec clear(channel()) -> channel().
clear(#{receivers := Receivers} = Channel) ->
    Channel#{receivers := maps:map(fun(_, R) -> R#{queue := []} end, Receivers)}.

-spec depth(binary(), channel()) -> non_neg_integer() | 'FC_E_RECEIVER'.
depth(_, #{exists := false}) -> 0;
depth(Name, Channel) ->
    case receiver(Name, Channel) of
        {ok, #{queue := Queue}} -> length(Queue);
        error -> 'FC_E_RECEIVER'
    end.

%% @doc What the faults of a channel do to one get of a receiver (faultcheck.md, 4 and 7.7).
-module(faultcheck_ref_get).

-export([get/4]).
-export_type([channels/0]).

-type channels() :: #{binary() => faultcheck_ref_channel:channel()}.

%% A packet on its way: taken from the own queue, from a receiver of another channel, or made.
-record(transit, {
    channels :: channels(),
    own :: {binary(), binary()},
    now :: integer(),
    packet = none :: none | {Current :: term(), Clean :: term()},
    source = none :: none | {binary(), binary()},
    blocked = false :: boolean(),
    errors = 0 :: non_neg_integer() | unsure
}).

%% @doc The packet delivered or `nothing', the number of faults that were skipped, and all
%% channels afterwards. The caller has seen to it that channel and receiver are there.
-spec get(binary(), binary(), Now :: integer(), channels()) ->
    {nothing | {packet, binary() | any}, non_neg_integer() | unsure, channels()}.
get(Name, Receiver, Now, Channels) ->
    Start = take_head(#transit{channels = Channels, own = {Name, Receiver}, now = Now}),
    #{Name := #{faults := Faults}} = Channels,
    {Passed, Transit} = lists:mapfoldl(fun(F, T) -> pass(F, T) end, Start, Faults),
    finish(Passed, Transit).

finish(Faults, #transit{own = {Name, R}, packet = Packet, errors = Errors} = Transit) ->
    #{Name := Channel} = All = Transit#transit.channels,
    {ok, #{gets := Gets} = Receiver} = faultcheck_ref_channel:receiver(R, Channel),
    {Result, Last} =
        case Packet of
            none -> {nothing, maps:get(last, Receiver)};
            {Current, _} -> {{packet, Current}, Current}
        end,
    Stored = faultcheck_ref_channel:store(Receiver#{gets := Gets + 1, last := Last}, Channel),
    {Result, Errors, All#{Name := Stored#{faults := Faults}}}.

pass(#{model := Model, receiver := For} = Fault, #transit{own = {_, Receiver}} = Transit) ->
    Here = faultcheck_fault:stage(Model) =:= get andalso (For =:= all orelse For =:= Receiver),
    case Here andalso faultcheck_ref_fault:pass(Receiver, Transit#transit.now, Fault) of
        false -> {Fault, Transit};
        {false, Advanced} -> {Advanced, Transit};
        {true, Advanced} -> act(Model, Advanced, Transit)
    end.

act(_, Fault, #transit{blocked = true} = T) -> {Fault, T};
act(block_get, Fault, #transit{packet = Packet} = T) when Packet =/= none ->
    {Fault, (give_back(T))#transit{blocked = true}};
act({insert, Data, _}, Fault, T) ->
    case budget(Fault, T) of
        0 -> {Fault, T};
        N -> {set_budget(N - 1, Fault, T), made(Data, T)}
    end;
act(repeat_last, Fault, #transit{own = {Name, R}, channels = Channels} = T) ->
    {ok, #{last := Last}} = faultcheck_ref_channel:receiver(R, maps:get(Name, Channels)),
    case Last of
        none -> {Fault, T};
        _ -> {Fault, made(Last, T)}
    end;
act({masquerade, From}, Fault, T) ->
    {Fault, masquerade(From, T)};
act(_, Fault, #transit{packet = none} = T) ->
    {Fault, T};
act({drop, _}, Fault, T) ->
    drop(budget(Fault, T), Fault, T);
act(lose, Fault, T) ->
    {Fault, take_head(T)};
act({repeat, _}, Fault, #transit{packet = {_, Clean}, own = Own} = T) ->
    Copies = lists:duplicate(budget(Fault, T), Clean),
    {set_budget(0, Fault, T), put_front(Own, Copies, T)};
act({resequence, K}, Fault, T) ->
    {Fault, resequence(K, give_back(T))};
act(Model, Fault, #transit{packet = {Current, Clean}, own = {_, R}, now = Now} = T) ->
    {Code, Altered, After} = alter(Model, Current, R, Now, Fault),
    {After, count(Code, T#transit{packet = {Altered, Clean}})}.

count('FC_OK', T) -> T;
count(_, #transit{errors = unsure} = T) -> T;
count(unsure, T) -> T#transit{errors = unsure};
count(_, #transit{errors = N} = T) -> T#transit{errors = N + 1}.

budget(#{runs := Runs}, #transit{own = {_, R}}) -> maps:get(budget, maps:get(R, Runs)).

set_budget(N, #{runs := Runs} = Fault, #transit{own = {_, R}}) ->
    Fault#{runs := Runs#{R := (maps:get(R, Runs))#{budget := N}}}.

drop(0, Fault, T) -> {set_budget(0, Fault, T), T};
drop(N, Fault, #transit{packet = none} = T) -> {set_budget(N, Fault, T), T};
drop(N, Fault, T) -> drop(N - 1, Fault, take_head(T)).

%% ---- altering the packet ----------------------------------------------------------------------

alter(_, any, _, _, Fault) ->
    {unsure, any, Fault};
alter({corruption, Byte, Bit}, Packet, _, _, Fault) when Byte < byte_size(Packet) ->
    {'FC_OK', faultcheck_ref_value:flip(bytes, 8 * Byte + Bit, Packet), Fault};
alter({corruption, _, _}, Packet, _, _, Fault) ->
    {'FC_E_INDEX', Packet, Fault};
alter({truncate, N}, Packet, _, _, Fault) ->
    {'FC_OK', binary:part(Packet, 0, min(N, byte_size(Packet))), Fault};
alter({extend, N, Byte}, Packet, _, _, Fault) ->
    {'FC_OK', <<Packet/binary, (binary:copy(<<Byte>>, N))/binary>>, Fault};
alter({field, Field, Model}, Packet, Receiver, Now, Fault) ->
    faultcheck_ref_field:apply(Field, Model, Packet, Receiver, Now, Fault).

%% ---- taking packets ---------------------------------------------------------------------------

%% What was on its way before is gone.
take_head(#transit{own = Own} = T) ->
    case take(Own, T) of
        {ok, Bytes, Taken} -> Taken#transit{packet = {Bytes, Bytes}, source = Own};
        none -> T#transit{packet = none, source = none}
    end.

take({Name, R}, #transit{channels = Channels, now = Now} = T) ->
    #{Name := Channel} = Channels,
    {ok, Receiver} = faultcheck_ref_channel:receiver(R, Channel),
    case faultcheck_ref_channel:visible(Now, Receiver) of
        {[{Bytes, _, _} | _], _} ->
            Queue = tl(maps:get(queue, Receiver)),
            Stored = faultcheck_ref_channel:store(Receiver#{queue := Queue}, Channel),
            {ok, Bytes, T#transit{channels = Channels#{Name := Stored}}};
        {[], _} ->
            none
    end.

put_front({Name, R}, Packets, #transit{channels = Channels} = T) ->
    #{Name := Channel} = Channels,
    {ok, #{queue := Queue} = Receiver} = faultcheck_ref_channel:receiver(R, Channel),
    Front = [{Bytes, 0, -1} || Bytes <- Packets],
    Stored = faultcheck_ref_channel:store(Receiver#{queue := Front ++ Queue}, Channel),
    T#transit{channels = Channels#{Name := Stored}}.

%% What was taken goes back to the head it came from, as it was.
give_back(#transit{source = none} = T) ->
    T#transit{packet = none};
give_back(#transit{source = Source, packet = {_, Clean}} = T) ->
    (put_front(Source, [Clean], T))#transit{packet = none, source = none}.

made(Bytes, T) ->
    (give_back(T))#transit{packet = {Bytes, Bytes}, source = none}.

masquerade(From, #transit{channels = Channels, own = {_, R}} = T) ->
    case maps:find(From, Channels) of
        {ok, #{exists := true} = Other} ->
            Source =
                case faultcheck_ref_channel:receiver(R, Other) of
                    {ok, _} -> {From, R};
                    error -> {From, <<>>}
                end,
            case take(Source, T) of
                {ok, Bytes, Taken} -> (made(Bytes, Taken))#transit{source = Source};
                none -> T
            end;
        _ ->
            T
    end.

%% The packet at position K, or the last one that can be seen.
resequence(K, #transit{own = {Name, R} = Own, channels = Channels, now = Now} = T) ->
    #{Name := Channel} = Channels,
    {ok, #{queue := Queue} = Receiver} = faultcheck_ref_channel:receiver(R, Channel),
    case faultcheck_ref_channel:visible(Now, Receiver) of
        {[], _} ->
            T;
        {Visible, _} ->
            {Before, [{Bytes, _, _} | After]} = lists:split(min(K, length(Visible) - 1), Queue),
            Left = Receiver#{queue := Before ++ After},
            Stored = faultcheck_ref_channel:store(Left, Channel),
            T#transit{
                channels = Channels#{Name := Stored},
                packet = {Bytes, Bytes},
                source = Own
            }
    end.

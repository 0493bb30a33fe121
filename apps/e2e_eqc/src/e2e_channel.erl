%% @doc A channel with the communication faults of ISO 26262 and AUTOSAR: packets queue in it, and
%% faults alter the queue. Pure: the model and the system each have one, and the same fault
%% does the same to both.
%%
%% A packet knows which of its bits were flipped since a sender of this configuration made it; for
%% packets that no such sender made this is `foreign'.
-module(e2e_channel).

-export([new/0, put/2, take/1, head/1, depth/1, sent/1, clear/1, possible/2, apply/4]).
-export_type([channel/0, packet/0, fault/0, change/0]).

-type packet() :: {binary(), Flipped :: [non_neg_integer()] | foreign}.
-type fault() ::
    {lose, pos_integer()}
    | {repeat, pos_integer()}
    %% the packet behind so many others is delivered first
    | {resequence, pos_integer()}
    %% a packet sent so many packets ago is delivered first
    | {insert, Age :: non_neg_integer()}
    | {corrupt, [non_neg_integer()]}
    | {forge, change()}
    | {truncate, Bytes :: pos_integer()}
    | {extend, binary()}
    %% nothing is delivered for so many receptions
    | {delay, pos_integer()}.
%% What a sender of another configuration or in another state would have sent; the checksum fits.
-type change() ::
    {counter, non_neg_integer()} | {id, non_neg_integer()} | {length, non_neg_integer()}.
-type channel() :: #{queue := [packet()], log := [binary()], delay := non_neg_integer()}.

%% How many sent packets can be inserted again.
-define(REMEMBERED, 40).

-spec new() -> channel().
new() -> #{queue => [], log => [], delay => 0}.

%% @doc A packet is sent.
-spec put(binary(), channel()) -> channel().
put(Bytes, #{queue := Queue, log := Log} = Channel) ->
    Channel#{
        queue := Queue ++ [{Bytes, []}],
        log := lists:sublist([Bytes | Log], ?REMEMBERED)
    }.

%% @doc What is delivered next.
-spec take(channel()) -> {packet() | none, channel()}.
take(#{delay := Delay} = Channel) when Delay > 0 -> {none, Channel#{delay := Delay - 1}};
take(#{queue := []} = Channel) -> {none, Channel};
take(#{queue := [Packet | Queue]} = Channel) -> {Packet, Channel#{queue := Queue}}.

-spec head(channel()) -> packet() | none.
head(#{queue := []}) -> none;
head(#{queue := [Packet | _]}) -> Packet.

-spec depth(channel()) -> non_neg_integer().
depth(#{queue := Queue}) -> length(Queue).

%% @doc How many sent packets can be inserted again.
-spec sent(channel()) -> non_neg_integer().
sent(#{log := Log}) -> length(Log).

%% @doc Empty and without delay; what was sent stays known.
-spec clear(channel()) -> channel().
clear(Channel) -> Channel#{queue := [], delay := 0}.

%% @doc Can this fault happen now?
-spec possible(fault(), channel()) -> boolean().
possible({lose, N}, Channel) -> N =< depth(Channel);
possible({resequence, Behind}, Channel) -> Behind < depth(Channel);
possible({insert, Age}, Channel) -> Age < sent(Channel);
possible({delay, _}, #{delay := Delay}) -> Delay =:= 0;
possible(Fault, Channel) -> of_head(Fault, head(Channel)).

of_head(_, none) -> false;
of_head({corrupt, Bits}, {Bytes, _}) -> lists:all(fun(B) -> B < bit_size(Bytes) end, Bits);
of_head({forge, _}, {_, Flipped}) -> Flipped =/= foreign;
of_head({truncate, N}, {Bytes, _}) -> N < byte_size(Bytes);
of_head({extend, _}, {_, _}) -> true;
of_head({repeat, _}, {_, _}) -> true.

%% @doc The channel after a fault.
-spec apply(fault(), e2e_packet:profile(), e2e_packet:config(), channel()) -> channel().
apply({lose, N}, _, _, #{queue := Queue} = Channel) ->
    Channel#{queue := lists:nthtail(N, Queue)};
apply({repeat, N}, _, _, #{queue := [Head | _] = Queue} = Channel) ->
    Channel#{queue := lists:duplicate(N, Head) ++ Queue};
apply({resequence, Behind}, _, _, #{queue := Queue} = Channel) ->
    {Passed, [Next | Rest]} = lists:split(Behind, Queue),
    Channel#{queue := [Next | Passed ++ Rest]};
apply({insert, Age}, _, _, #{queue := Queue, log := Log} = Channel) ->
    Channel#{queue := [{lists:nth(Age + 1, Log), []} | Queue]};
apply({delay, N}, _, _, Channel) ->
    Channel#{delay := N};
apply(Fault, Profile, Config, #{queue := [Head | Queue]} = Channel) ->
    Channel#{queue := [alter(Fault, Profile, Config, Head) | Queue]}.

alter({corrupt, Bits}, _, _, {Bytes, Flipped}) ->
    {lists:foldl(fun flip/2, Bytes, Bits), flipped(Bits, Flipped)};
alter({truncate, N}, _, _, {Bytes, _}) ->
    {binary:part(Bytes, 0, byte_size(Bytes) - N), foreign};
alter({extend, More}, _, _, {Bytes, _}) ->
    {<<Bytes/binary, More/binary>>, foreign};
alter({forge, Change}, Profile, Config, {Bytes, _}) ->
    forge(Change, Profile, Config, Bytes).

flip(Bit, Bytes) ->
    <<Before:Bit/bits, Value:1, After/bits>> = Bytes,
    <<Before/bits, (1 - Value):1, After/bits>>.

flipped(_, foreign) -> foreign;
flipped(Bits, Flipped) -> (Bits -- Flipped) ++ (Flipped -- Bits).

forge({counter, Counter}, Profile, Config, Bytes) ->
    {e2e_packet:protect(Profile, Config, Counter, Bytes), []};
forge({id, Other}, Profile, Config, Bytes) ->
    {Counter, _} = e2e_packet:inspect(Profile, Config, Bytes),
    {e2e_packet:protect(Profile, with_id(Other, Config), Counter, Bytes), foreign};
forge({length, Length}, Profile, Config, Bytes) ->
    case e2e_packet:fields(Profile, Config) of
        #{length := Field} ->
            {Counter, _} = e2e_packet:inspect(Profile, Config, Bytes),
            Written = e2e_packet:write(Field, Length, Bytes),
            {e2e_packet:sign(Profile, Config, Counter, Written), foreign};
        #{} ->
            {Bytes, foreign}
    end.

with_id(Other, #{'DataIDList' := Ids} = Config) ->
    Config#{'DataIDList' := [(Id + Other) rem 256 || Id <- Ids]};
with_id(Other, Config) ->
    Config#{'DataID' := Other}.

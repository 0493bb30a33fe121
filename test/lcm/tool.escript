#!/usr/bin/env escript
%%! -noinput
%% The Erlang side in test/lcm_test.sh; needs ERL_LIBS. What is heard or stored is told as the number
%% of messages and a digest of channels and payloads in order.
%%
%%   tool.escript digest FILE
%%   tool.escript listen URL COUNT     says "listening", then waits for so many
%%   tool.escript play FILE URL
%%   tool.escript poke URL             one message that is not counted
-mode(compile).

-define(TIMEOUT_MS, 30000).
-define(POKE, <<"POKE">>).

main(["digest", File]) ->
    {ok, Events} = replay_lcm_log:read(File),
    tell([{C, D} || #{channel := C, data := D} <- Events, C =/= ?POKE]);
main(["listen", Url, Count]) ->
    {ok, Lcm} = replay_lcm_udp:open(Url, #{}),
    io:format("listening~n"),
    tell(heard(list_to_integer(Count), Lcm, [], deadline()));
main(["play", File, Url]) ->
    {ok, Events} = replay_lcm_log:read(File),
    {ok, Lcm} = replay_lcm_udp:open(Url, #{listen => false}),
    play(Events, erlang:monotonic_time(microsecond), Lcm);
main(["poke", Url]) ->
    {ok, Lcm} = replay_lcm_udp:open(Url, #{listen => false}),
    ok = replay_lcm_udp:publish(Lcm, ?POKE, <<>>).

tell(Messages) ->
    Hash = crypto:hash(sha256, [[C, 0, <<(byte_size(D)):32>>, D] || {C, D} <- Messages]),
    io:format("~b ~s~n", [length(Messages), binary:encode_hex(Hash)]).

deadline() -> erlang:monotonic_time(millisecond) + ?TIMEOUT_MS.

heard(0, _, Messages, _) ->
    lists:reverse(Messages);
heard(N, Lcm, Messages, Deadline) ->
    receive
        Info ->
            case replay_lcm_udp:incoming(Info, Lcm) of
                {message, Channel, Payload, _, Next} ->
                    heard(N - 1, Next, [{Channel, Payload} | Messages], Deadline);
                {none, Next} ->
                    heard(N, Next, Messages, Deadline)
            end
    after max(0, Deadline - erlang:monotonic_time(millisecond)) ->
        io:format("~b messages did not come~n", [N]),
        halt(1)
    end.

%% In the time of the log.
play([], _, _) ->
    ok;
play([#{t_us := T, channel := Channel, data := Data} | Rest], Began, Lcm) ->
    Wait = (Began + T - erlang:monotonic_time(microsecond)) div 1000,
    receive after max(0, Wait) -> ok end,
    ok = replay_lcm_udp:publish(Lcm, Channel, Data),
    play(Rest, Began, Lcm).

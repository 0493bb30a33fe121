%% @doc The group leader's half of Erlang's I/O protocol, for a process whose prints are carried
%% elsewhere and that has no input.
-module(faultcheck_output).

-export([request/1]).

%% @doc What an io_request asks for: the text to show and the reply to give.
-spec request(term()) -> {binary(), Reply :: term()}.
request({put_chars, Encoding, Chars}) ->
    text(Encoding, Chars);
request({put_chars, Encoding, M, F, A}) ->
    try apply(M, F, A) of
        Chars -> text(Encoding, Chars)
    catch
        _:_ -> {<<>>, {error, F}}
    end;
request({put_chars, Chars}) ->
    text(latin1, Chars);
request({put_chars, M, F, A}) ->
    request({put_chars, latin1, M, F, A});
request({requests, Requests}) ->
    many(Requests, <<>>, ok);
request({setopts, _}) ->
    {<<>>, ok};
request(getopts) ->
    {<<>>, [{encoding, unicode}]};
request({get_geometry, _}) ->
    {<<>>, {error, enotsup}};
request(Input) when is_tuple(Input) ->
    case lists:prefix("get_", atom_to_list(element(1, Input))) of
        true -> {<<>>, eof};
        false -> {<<>>, {error, request}}
    end;
request(_) ->
    {<<>>, {error, request}}.

text(Encoding, Chars) ->
    case unicode:characters_to_binary(Chars, Encoding, unicode) of
        Text when is_binary(Text) -> {Text, ok};
        _ -> {<<>>, {error, put_chars}}
    end.

many([], Text, Reply) ->
    {Text, Reply};
many([Request | Rest], Text, ok) ->
    {More, Reply} = request(Request),
    many(Rest, <<Text/binary, More/binary>>, Reply);
many(_, Text, Error) ->
    {Text, Error}.

-module(faultcheck_output_tests).
-include_lib("eunit/include/eunit.hrl").

requests_test_() ->
    [
        ?_assertEqual({Text, Reply}, faultcheck_output:request(Request))
     || {Request, Text, Reply} <- [
            {{put_chars, unicode, ["a", 228]}, <<"aä"/utf8>>, ok},
            {{put_chars, latin1, <<228>>}, <<"ä"/utf8>>, ok},
            {{put_chars, unicode, io_lib, format, ["~s!", ["x"]]}, <<"x!">>, ok},
            {{put_chars, unicode, io_lib, format, ["~s", [1]]}, <<>>, {error, format}},
            {{put_chars, unicode, <<255>>}, <<>>, {error, put_chars}},
            {{requests, [{put_chars, latin1, "a"}, {put_chars, latin1, "b"}]}, <<"ab">>, ok},
            {{get_line, unicode, "> "}, <<>>, eof},
            {{get_chars, unicode, "> ", 3}, <<>>, eof},
            {{get_until, unicode, "> ", m, f, []}, <<>>, eof},
            {{get_geometry, columns}, <<>>, {error, enotsup}},
            {{setopts, [binary]}, <<>>, ok},
            {getopts, <<>>, [{encoding, unicode}]},
            {something_else, <<>>, {error, request}}
        ]
    ].

-module(faultcheck_html_tests).
-include_lib("eunit/include/eunit.hrl").

what_ends_an_element_or_an_attribute_is_escaped_test() ->
    ?assertEqual(
        <<"&lt;/script&gt;&amp;&quot;&#39;">>, faultcheck_html:escape("</script>&\"'")
    ).

text_beyond_latin1_stays_test() ->
    Text = [16#1F4A5, $a, 16#E4],
    ?assertEqual(unicode:characters_to_binary(Text), faultcheck_html:escape(Text)).

bytes_that_are_no_text_are_shown_as_latin1_test() ->
    ?assertEqual(<<"a", 16#E4/utf8, "&lt;">>, faultcheck_html:escape(<<"a", 16#E4, "<">>)).

control_characters_are_shown_as_one_that_stands_for_them_test() ->
    ?assertEqual(<<"a", 16#FFFD/utf8, "\n\tb">>, faultcheck_html:escape([$a, 0, $\n, $\t, $b])).

a_document_forbids_everything_but_its_style_test() ->
    Page = iolist_to_binary(faultcheck_html:document("a < b", "p{}", "<p>x</p>")),
    [
        ?assertNotEqual({Part, nomatch}, {Part, binary:match(Page, Part)})
     || Part <- [
            <<"<title>a &lt; b</title>">>, <<"<style>p{}</style>">>, <<"<p>x</p>">>,
            <<"default-src 'none'; style-src 'unsafe-inline'">>
        ]
    ].

%% @doc HTML pages of one file that load nothing and run nothing: their policy forbids it.
%%
%% ```
%% Page = faultcheck_html:document("A case", "body{margin:2rem}", ["<h1>A case</h1>"]),
%% <<"a &lt; b">> = faultcheck_html:escape("a < b").
%% '''
-module(faultcheck_html).

-export([document/3, escape/1]).

%% @doc A page. The title is text; style and body are what they are to be in the file.
-spec document(Title :: unicode:chardata(), Style :: iodata(), Body :: iodata()) -> iodata().
document(Title, Style, Body) ->
    [
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n",
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
        "style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n",
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n",
        "<meta name=\"color-scheme\" content=\"light dark\">\n",
        ["<title>", escape(Title), "</title>\n<style>", Style, "</style>\n</head>\n<body>\n"],
        [Body, "</body>\n</html>\n"]
    ].

%% @doc Text as it is written in an element or an attribute. Characters that HTML and XML do not
%% have are shown as U+FFFD; bytes that are not UTF-8 are taken for Latin-1.
-spec escape(unicode:chardata()) -> binary().
escape(Text) ->
    unicode:characters_to_binary([escaped(C) || C <- characters(Text)]).

characters(Text) ->
    case unicode:characters_to_list(Text) of
        Characters when is_list(Characters) -> Characters;
        _ -> unicode:characters_to_list(Text, latin1)
    end.

escaped($<) -> "&lt;";
escaped($>) -> "&gt;";
escaped($&) -> "&amp;";
escaped($") -> "&quot;";
escaped($') -> "&#39;";
escaped(C) when C < 32, C =/= $\n, C =/= $\t; C =:= 127 -> 16#FFFD;
escaped(C) -> C.

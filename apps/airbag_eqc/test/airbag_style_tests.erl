-module(airbag_style_tests).
-include_lib("eunit/include/eunit.hrl").

%% Contrast as WCAG 2.1 defines it, of each colour of text on each ground it stands on.
text_can_be_read_on_its_ground_test_() ->
    Css = iolist_to_binary(airbag_style:css()),
    [Light, Dark] = [maps:from_list(Colours) || Colours <- themes(Css)],
    [
        {lists:concat([Theme, ": ", Text, " on ", Ground]), fun() ->
            Contrast = contrast(maps:get(Text, Colours), maps:get(Ground, Colours)),
            ?assert(Contrast >= 4.5)
        end}
     || {Theme, Colours} <- [{light, Light}, {dark, Dark}],
        {Text, Ground} <- [
            {"ink", "ground"}, {"ink", "card"}, {"ink", "bad-ground"}, {"ink", "blue-ground"},
            {"quiet", "ground"}, {"quiet", "card"}, {"quiet", "bad-ground"},
            {"quiet", "blue-ground"}, {"fault", "card"}, {"fault", "fault-ground"},
            {"fault", "bad-ground"}, {"bad", "card"}, {"bad", "bad-ground"},
            {"good", "good-ground"}
        ]
    ].

%% The colours of the light sheet, and of the dark one.
themes(Css) ->
    {match, Blocks} = re:run(Css, ":root\\{([^}]*)\\}", [global, {capture, [1], binary}]),
    [
        begin
            {match, Found} = re:run(
                Block, "--([a-z-]+):#([0-9a-f]{6})", [global, {capture, all_but_first, list}]
            ),
            [{Name, list_to_integer(Hex, 16)} || [Name, Hex] <- Found]
        end
     || [Block] <- Blocks
    ].

contrast(A, B) ->
    [Dark, Light] = lists:sort([luminance(A), luminance(B)]),
    (Light + 0.05) / (Dark + 0.05).

luminance(Rgb) ->
    [R, G, B] = [linear((Rgb bsr Shift) band 255 / 255) || Shift <- [16, 8, 0]],
    0.2126 * R + 0.7152 * G + 0.0722 * B.

linear(C) when C =< 0.04045 -> C / 12.92;
linear(C) -> math:pow((C + 0.055) / 1.055, 2.4).

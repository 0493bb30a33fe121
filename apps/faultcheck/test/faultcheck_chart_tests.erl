-module(faultcheck_chart_tests).
-include_lib("eunit/include/eunit.hrl").
-include_lib("xmerl/include/xmerl.hrl").

bars() ->
    faultcheck_chart:bars(#{
        title => "Commands <generated> & run",
        x_label => "share (%)",
        bars => [{"sensor", 75}, {"bit_flip", 25.0}, {"none", 0}]
    }).

histogram() ->
    faultcheck_chart:histogram(#{
        title => "Lengths",
        x_label => "commands",
        y_label => "tests",
        counts => [{0, 10}, {1, 40}, {2, 0}, {3, 20}]
    }).

%% Places by hand: 64 to 608 across for 0 to 2 s, 288 down to 64 for 0 to 1 m.
lines_are_where_their_values_are_test() ->
    Svg = iolist_to_binary(
        faultcheck_chart:lines(#{
            title => "Error", x_label => "s", y_label => "m",
            series => [{"object 1", [{0, 0}, {1, 0.5}, {2, 1}]}, {"object 2", [{0, 1.0}, {2, 0}]}]
        })
    ),
    {match, Found} = re:run(
        Svg, "<polyline points=\"([^\"]*)\"[^>]*stroke-dasharray=\"([^\"]*)\"",
        [global, {capture, all_but_first, list}]
    ),
    ?assertEqual(
        [["64.0,288.0 336.0,176.0 608.0,64.0", "none"], ["64.0,64.0 608.0,288.0", "7 3"]], Found
    ).

steps(Scale) ->
    faultcheck_chart:steps(#{
        title => "First failure",
        x_label => "tests",
        y_label => "share of seeds (%)",
        x_scale => Scale,
        series => [{"byte", [{5, 50}, {2000, 100}]}, {"focused", [{1, 50}, {10, 100}]}]
    }).

parsed(Svg) ->
    {Root, []} = xmerl_scan:string(binary_to_list(iolist_to_binary(Svg)), [{quiet, true}]),
    Root.

texts(Svg) ->
    [T || #xmlText{value = T} <- xmerl_xpath:string("//text/text()", parsed(Svg))].

%% x, y, width, height of each bar; the first rectangle is the background
rectangles(Svg) ->
    Number = fun(Name, Element) ->
        [#xmlAttribute{value = V}] = xmerl_xpath:string("@" ++ Name, Element),
        case string:to_float(V) of
            {error, no_float} -> list_to_integer(V);
            {F, []} -> F
        end
    end,
    [
        {Number("x", E), Number("y", E), Number("width", E), Number("height", E)}
     || E <- xmerl_xpath:string("//rect[@x]", parsed(Svg))
    ].

all_charts_are_well_formed_and_carry_their_labels_test() ->
    Has = fun(Svg, Labels) -> ?assertEqual([], Labels -- texts(Svg)) end,
    Has(bars(), ["Commands <generated> & run", "share (%)", "sensor", "bit_flip", "75", "25.0"]),
    Has(histogram(), ["Lengths", "commands", "tests", "0", "40"]),
    Has(steps(log), ["First failure", "tests", "share of seeds (%)", "1", "10", "1 000", "byte"]),
    Has(steps(linear), ["0", "2 000", "focused"]).

the_same_input_gives_the_same_bytes_test() ->
    ?assertEqual(iolist_to_binary(steps(log)), iolist_to_binary(steps(log))).

bars_are_as_long_as_their_values_test() ->
    [{_, _, W1, _}, {_, _, W2, _}, {_, _, W3, _}] = rectangles(bars()),
    ?assert(abs(W1 - 3 * W2) < 0.5),
    ?assertEqual(0, round(W3)).

histogram_bars_stand_on_the_axis_and_empty_ones_are_left_out_test() ->
    [{X1, Y1, _, H1}, {X2, Y2, _, H2}, {X3, Y3, _, H3}] = rectangles(histogram()),
    ?assert(abs(H2 - 4 * H1) < 0.5),
    ?assert(abs(H3 - 2 * H1) < 0.5),
    ?assert(abs((Y1 + H1) - (Y2 + H2)) < 0.3 andalso abs((Y1 + H1) - (Y3 + H3)) < 0.3),
    ?assert(abs((X3 - X1) - 2 * (X2 - X1)) < 10 * (X2 - X1)),
    ?assert(X1 < X2 andalso X2 < X3).

a_logarithmic_axis_puts_equal_factors_at_equal_distances_test() ->
    Path = fun(Svg) ->
        [#xmlAttribute{value = D} | _] = xmerl_xpath:string("//path/@d", parsed(Svg)),
        D
    end,
    Chart = #{
        title => "t",
        x_label => "x",
        y_label => "y",
        x_scale => log,
        series => [{"a", [{1, 1}, {10, 2}, {100, 3}]}]
    },
    {match, Xs} = re:run(
        Path(faultcheck_chart:steps(Chart)), "[MH]([0-9.]+)", [global, {capture, [1], list}]
    ),
    [A, B, C] = [round(element(1, string:to_float(X ++ ".0"))) || [X] <- Xs],
    ?assert(abs((B - A) - (C - B)) =< 1).

text_of_all_kinds_is_escaped_test() ->
    Svg = faultcheck_chart:bars(#{
        title => <<"a \"b\" <c>">>, x_label => ["µs", $&], bars => [{"ü", 1}]
    }),
    ?assert(lists:member("a \"b\" <c>", texts(Svg))).

an_empty_chart_is_the_callers_mistake_test() ->
    ?assertError(
        function_clause, faultcheck_chart:bars(#{title => "", x_label => "", bars => []})
    ).

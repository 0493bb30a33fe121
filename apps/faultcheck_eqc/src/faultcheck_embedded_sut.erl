%% @doc The embedded profile and libfaultcheck side by side, driven by the same commands.
%%
%% A command goes to the embedded profile as its text line; if it is accepted, libfaultcheck gets
%% the same in its own terms. Here is all in which the two differ by intention, and how the
%% difference is taken out:
%%
%% <ul>
%%   <li>Duration 0 is for ever here and never there: there it becomes -1.</li>
%%   <li>`fi_set_enabled' is one switch for all, also for what is added later: there each fault
%%       has its own.</li>
%%   <li>`fi_reset_cnt' has no counterpart: there each trigger is set again, with the number of its
%%       first call counted from the reset.</li>
%%   <li>A bit is truncated and clamped to 0..31 here; there it is an integer, refused below 0
%%       and skipped above 31: there it is given clamped.</li>
%%   <li>A parameter is a float here and a double there: there it is the double of the same
%%       value.</li>
%%   <li>NONE only counts here and does not exist there: it is not armed there.</li>
%%   <li>Number and length of identifiers, number of faults, and words that are refused: only here.
%%       What is refused here is not done there.</li>
%% </ul>
-module(faultcheck_embedded_sut).

-export([prepare/0, add/5, set_enabled/1, clear/0, reset/0, listing/0, probe/3]).
-export([bits/1]).
-export_type([type/0]).

%% An int and a float, as libfaultcheck names them.
-type type() :: i32 | f32.

%% What libfaultcheck is to be told again, in a fault's own terms.
-record(armed, {fault :: pos_integer(), start :: integer(), duration :: integer()}).
-record(main, {enabled = false :: boolean(), calls = #{} :: #{binary() => non_neg_integer()},
               armed = [] :: [#armed{}]}).

%% @doc Both libraries as new.
-spec prepare() -> ok.
prepare() ->
    ok = faultcheck_eqc_sut:prepare(),
    ok = cb:call(lib(), fi_init, []),
    main(#main{}).

%% The embedded one is an instance of the calling process and ends with it, as libfaultcheck does.
lib() ->
    case get(?MODULE) of
        undefined ->
            Options = [
                {so, cb_library:find("libfi_model.so", ?MODULE)},
                {transport, nif},
                {reset, {calls, [{fi_init, []}]}},
                {module, false}
            ],
            case cb:start(fi_model, Options) of
                {ok, Lib} ->
                    _ = put(?MODULE, Lib),
                    Lib;
                {error, Reason} ->
                    error({cb, Reason})
            end;
        Lib ->
            Lib
    end.

main(Main) ->
    _ = put({?MODULE, main}, Main),
    ok.

main() -> get({?MODULE, main}).

%% The reply lines to a command of the embedded profile alone.
command(Line) ->
    Text = cb:cstring(lib(), cb:call(lib(), fi_run, [iolist_to_binary(Line)])),
    [<<>> | Lines] = lists:reverse(binary:split(Text, <<"\n">>, [global])),
    lists:reverse(Lines).

%% Both, if the embedded one says ok.
both(Words, There) ->
    case command(lists:join(<<" ">>, Words)) of
        [<<"ok">>] ->
            ok = main(There(main())),
            ok;
        [<<"error: ", _/binary>> = Error] ->
            {error, Error}
    end.

%% @doc Adds a fault, all words as text.
-spec add(binary(), binary(), binary(), binary(), binary()) -> ok | {error, binary()}.
add(Id, Type, Param, Start, Duration) ->
    both([<<"fi_add_fault">>, Id, Type, Param, Start, Duration], fun(Main) ->
        case model(Type, bits(Param)) of
            none -> count(Id, Main);
            Model -> arm(Id, Model, binary_to_integer(Start), binary_to_integer(Duration), Main)
        end
    end).

arm(Id, Model, Start, Duration, #main{armed = Armed, enabled = Enabled} = Main0) ->
    #main{calls = #{Id := Calls}} = Main = count(Id, Main0),
    Fault = faultcheck_eqc_sut:add(a, {probe, Id}, Model),
    ok = trigger(Fault, Start, Duration),
    'FC_OK' = faultcheck_eqc_sut:enable(a, Fault, Enabled),
    Main#main{armed = [#armed{fault = Fault, start = Calls + Start, duration = Duration} |
                       Armed]}.

%% The identifier's calls are counted from its first fault on.
count(Id, #main{calls = Calls} = Main) -> Main#main{calls = maps:merge(#{Id => 0}, Calls)}.

trigger(Fault, Start, Duration) ->
    'FC_OK' = faultcheck_eqc_sut:trigger(a, Fault, {from, Start}),
    Calls = case Duration of 0 -> -1; _ -> Duration end,
    'FC_OK' = faultcheck_eqc_sut:trigger(a, Fault, {for, Calls}),
    ok.

model(<<"BITFLIP">>, Bits) ->
    <<Param:32/float>> = <<Bits:32>>,
    {bitflip, min(31, max(0, trunc(Param)))};
model(Type, Bits) ->
    <<Param:32/float>> = <<Bits:32>>,
    case Type of
        <<"OFFSET">> -> {offset, Param};
        <<"AMPLIFICATION">> -> {amplification, Param};
        <<"SET_TO">> -> {set_to, Param};
        _ -> none
    end.

%% @doc The bits of the nearest float.
-spec bits(binary()) -> non_neg_integer().
bits(Param) ->
    Value = try binary_to_float(Param) catch error:badarg -> binary_to_integer(Param) end,
    <<Bits:32>> = <<Value:32/float>>,
    Bits.

%% @doc Enables or disables injection; any other word is refused.
-spec set_enabled(binary()) -> ok | {error, binary()}.
set_enabled(Word) ->
    both([<<"fi_set_enabled">>, Word], fun(#main{armed = Armed} = Main) ->
        On = Word =:= <<"1">>,
        _ = ['FC_OK' = faultcheck_eqc_sut:enable(a, F, On) || #armed{fault = F} <- Armed],
        Main#main{enabled = On}
    end).

-spec clear() -> ok | {error, binary()}.
clear() ->
    both([<<"fi_clear_faults">>], fun(Main) ->
        ok = faultcheck_eqc_sut:remove_all(a, probes),
        Main#main{armed = [], calls = #{}}
    end).

-spec reset() -> ok | {error, binary()}.
reset() ->
    both([<<"fi_reset_cnt">>], fun(#main{armed = Armed, calls = Calls} = Main) ->
        _ = [ok = trigger(F, S, D) || #armed{fault = F, start = S, duration = D} <- Armed],
        Main#main{calls = maps:map(fun(_, _) -> 0 end, Calls)}
    end).

%% @doc The lines of fi_print_faults, the last one being ok.
-spec listing() -> [binary()].
listing() -> command(<<"fi_print_faults">>).

%% @doc What the value, a float as its bits, becomes in either library.
-spec probe(binary(), type(), integer()) -> {Embedded :: integer(), Main :: integer()}.
probe(Id, Type, Value) ->
    #main{enabled = Enabled, calls = Calls} = Main = main(),
    case Calls of
        #{Id := N} when Enabled -> main(Main#main{calls = Calls#{Id := N + 1}});
        _ -> ok
    end,
    {'FC_OK', There} = faultcheck_eqc_sut:probe(a, Id, Type, Value),
    {embedded(Id, Type, Value), There}.

embedded(Id, Type, Value) ->
    {Function, CType} = maps:get(Type, #{i32 => {fi_inject_fault_int, int},
                                         f32 => {fi_inject_fault_float, float}}),
    {ptr, _, At} = Buffer =
        cb:create_array(lib(), 'unsigned char', faultcheck_eqc_sut:encode(Type, Value)),
    ok = cb:call(lib(), Function, [Id, {ptr, CType, At}]),
    After = cb:read_bytes(lib(), Buffer, 4),
    ok = cb:free(lib(), Buffer),
    faultcheck_eqc_sut:decode(Type, After).

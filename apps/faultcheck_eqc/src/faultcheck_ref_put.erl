%% @doc What the faults of a channel do to one put (faultcheck.md, 7.7).
-module(faultcheck_ref_put).

-export([put/4]).

-record(plan, {
    now :: integer(),
    blocked = false :: boolean(),
    hidden = 0 :: non_neg_integer(),
    from_time = -1 :: integer(),
    target :: binary(),
    %% receivers that a subset leaves out; their copies are altered all the same, as the streams
    %% of affected calls advance
    excluded = [] :: [binary()],
    %% what goes to whom
    copies :: #{binary() => binary() | any},
    errors = 0 :: non_neg_integer() | unsure
}).

%% @doc The result, the number of errors, and all channels afterwards.
-spec put(binary(), binary(), Now :: integer(), faultcheck_ref_get:channels()) ->
    {'FC_OK' | 'FC_E_BLOCKED', non_neg_integer() | unsure, faultcheck_ref_get:channels()}.
put(Name, Data, Now, Channels) ->
    Channel = maps:get(Name, Channels, faultcheck_ref_channel:new()),
    Copies = maps:from_list([{R, Data} || R <- faultcheck_ref_channel:names(Channel)]),
    Start = #plan{now = Now, target = Name, copies = Copies},
    {Faults, Plan} = lists:mapfoldl(fun pass/2, Start, maps:get(faults, Channel)),
    Advanced = Channels#{Name => Channel#{faults := Faults, exists := true}},
    case Plan of
        #plan{blocked = true, errors = Errors} ->
            {'FC_E_BLOCKED', Errors, Advanced};
        #plan{target = Name, errors = Errors} ->
            {'FC_OK', Errors, deliver(Name, Plan, Advanced)};
        #plan{target = Target, errors = Errors} ->
            Everybody = maps:from_list(
                [{R, Data} || R <- faultcheck_ref_channel:names(channel(Target, Advanced))]),
            Copied = Plan#plan{copies = Everybody, excluded = []},
            {'FC_OK', Errors, deliver(Target, Copied, Advanced)}
    end.

channel(Name, Channels) -> maps:get(Name, Channels, faultcheck_ref_channel:new()).

deliver(Name, #plan{hidden = Hidden, from_time = FromTime} = Plan, Channels) ->
    Channel = channel(Name, Channels),
    Copies = maps:without(Plan#plan.excluded, Plan#plan.copies),
    Channels#{Name => lists:foldl(
        fun(#{name := R} = Receiver, C) ->
            case Copies of
                #{R := Data} ->
                    Filled = faultcheck_ref_channel:append(Data, Hidden, FromTime, Receiver),
                    faultcheck_ref_channel:store(Filled, C);
                _ ->
                    C
            end
        end,
        Channel#{exists := true},
        faultcheck_ref_channel:recipients(Channel))}.

pass(#{model := Model} = Fault, Plan) ->
    case faultcheck_fault:stage(Model) =:= put andalso
             faultcheck_ref_fault:pass(all, Plan#plan.now, Fault) of
        false -> {Fault, Plan};
        {false, Advanced} -> {Advanced, Plan};
        {true, Advanced} -> act(Model, Advanced, Plan)
    end.

act(block_put, Fault, Plan) ->
    {Fault, count('FC_E_BLOCKED', Plan#plan{blocked = true})};
act({delay, {gets, N}}, Fault, #plan{hidden = Hidden} = Plan) ->
    {Fault, Plan#plan{hidden = Hidden + N}};
act({delay, {ns, Ns}}, Fault, #plan{from_time = FromTime, now = Now} = Plan) ->
    {Fault, Plan#plan{from_time = max(FromTime, Now + Ns)}};
act({misroute, To}, Fault, Plan) ->
    {Fault, Plan#plan{target = To}};
act({subset, Receivers}, Fault, #plan{copies = Copies} = Plan) ->
    Others = maps:keys(maps:without(Receivers, Copies)),
    {Fault, Plan#plan{excluded = Others ++ Plan#plan.excluded}};
act({asymmetric, Receivers, Part, Model}, Fault, #plan{copies = Copies, now = Now} = Plan) ->
    case maps:with(Receivers, Copies) of
        Listed when map_size(Listed) =:= 0 ->
            {Fault, Plan};
        Listed ->
            [Data | _] = maps:values(Listed),
            {Code, Altered, After} =
                faultcheck_ref_field:apply(Part, Model, Data, all, Now, Fault),
            Others = maps:map(fun(_, _) -> Altered end, Listed),
            {After, count(Code, Plan#plan{copies = maps:merge(Copies, Others)})}
    end.

count('FC_OK', Plan) -> Plan;
count(_, #plan{errors = unsure} = Plan) -> Plan;
count(unsure, Plan) -> Plan#plan{errors = unsure};
count(_, #plan{errors = N} = Plan) -> Plan#plan{errors = N + 1}.

%% @doc A fault as a term: what happens to a value or packet, and when.
%%
%% ```
%% {offset, 2.5}                                 at each call, for ever
%% {{offset, 2.5}, [{from, 100}, {for, 20}]}     calls 101 to 120
%% {{drop, 1}, [{random, 0.1}]}
%% '''
%% docs/faults.md lists the models and the conditions. faultcheck_inject arms a fault.
-module(faultcheck_fault).

-export([normal/1, model/1, trigger/1, validate/1, validate_trigger/1]).
-export([class/1, stage/1, describe/1]).
-export_type([fault/0, model/0, value_model/0, probe_model/0, sensor_model/0]).
-export_type([communication_model/0, trigger/0, condition/0, real/0, value_type/0, field/0]).

-type fault() :: model() | {model(), trigger()}.
-type model() :: value_model() | communication_model().
-type value_model() :: probe_model() | sensor_model().
-type real() :: number() | inf | neg_inf | nan.
-type value_type() :: f32 | f64 | i8 | i16 | i32 | i64 | u8 | u16 | u32 | u64 | bool | bytes.
-type probe_model() ::
    {bitflip, Bit :: non_neg_integer()}
    | bitflip_random
    | stuck
    | {stuck_bit, Bit :: non_neg_integer(), 0..1}
    | {amplification, real()}
    | {offset, real()}
    | {set_to, real()}.
-type sensor_model() ::
    {noise_uniform, real()}
    | {noise_gauss, real()}
    | {random_offset, Low :: real(), High :: real()}
    | {held_offset, Low :: real(), High :: real(), Ns :: pos_integer()}
    | {drift | drift_timed, Rate :: real(), Limit :: real() | none}
    | {ramp, real(), Calls :: pos_integer()}
    | {delay, {calls, non_neg_integer()}}
    | {quantise, Step :: real()}
    | {dead_zone, Centre :: real(), Width :: real()}
    | {saturate, Low :: real(), High :: real()}
    | {oscillate, Amplitude :: real(), Calls :: pos_integer()}
    | {dropout, Probability :: number(), hold | zero | nan}
    | {spike, Probability :: number(), Height :: real()}.
-type field() ::
    {Offset :: non_neg_integer(), value_type(), little | big}
    | {Offset :: non_neg_integer(), bytes, Length :: non_neg_integer()}.
-type communication_model() ::
    {corruption, Byte :: non_neg_integer(), Bit :: 0..7}
    | {field, field(), value_model()}
    | {truncate, non_neg_integer()}
    | {extend, Count :: non_neg_integer(), byte()}
    | {drop | repeat | resequence, non_neg_integer()}
    | lose | repeat_last | block_get | block_put
    | {insert, binary(), Times :: non_neg_integer()}
    | {masquerade | misroute, Channel :: binary()}
    | {delay, {gets | ns, non_neg_integer()}}
    | {asymmetric, Receivers :: [binary()], whole | field(), value_model()}
    | {subset, Receivers :: [binary()]}.
%% All must hold.
-type trigger() :: [condition()].
-type condition() ::
    {from, non_neg_integer()}
    | {for, non_neg_integer()}
    | {time, DelayNs :: non_neg_integer(), DurationNs :: non_neg_integer() | forever}
    | {random, Probability :: number()}
    | {periodic, Period :: pos_integer(), Active :: non_neg_integer()}
    | {predicate, Function :: atom() | binary()}.

-define(UINT64_MAX, 16#FFFFFFFFFFFFFFFF).
-define(INT64_MAX, 16#7FFFFFFFFFFFFFFF).

%% @doc With its trigger spelt out.
-spec normal(fault()) -> {model(), trigger()}.
normal({Model, Trigger}) when is_list(Trigger), not is_atom(Model) -> {Model, Trigger};
%% A model without parameters is an atom; lists are no parameter of a model but this one's.
normal({Model, Trigger}) when is_list(Trigger), Model =/= subset -> {Model, Trigger};
normal(Model) -> {Model, []}.

-spec model(fault()) -> model().
model(Fault) -> element(1, normal(Fault)).

-spec trigger(fault()) -> trigger().
trigger(Fault) -> element(2, normal(Fault)).

%% ---- validation -----------------------------------------------------------------------------

%% @doc `ok', or one line that says what is wrong and what would be right.
-spec validate(term()) -> ok | {error, unicode:chardata()}.
validate(Fault) ->
    {Model, Trigger} = normal(Fault),
    case validate_model(Model) of
        ok -> validate_trigger(Trigger);
        Error -> Error
    end.

validate_model(Model) ->
    case {entries(Model), name(Model)} of
        {_, none} ->
            invalid("fault ~tp: expected a model of docs/faults.md", [Model]);
        {[], Name} ->
            invalid("fault ~tp: there is no model ~tp~ts", [Model, Name, like(Name)]);
        {[Entry | _] = Entries, _} ->
            case [E || E <- Entries, fits(Model, E)] of
                [Fitting | _] -> cross_check(Model, Fitting);
                [] -> why_not(Model, Entry)
            end
    end.

like(Name) ->
    Known = [atom_to_list(N) || #{name := N} <- faultcheck_fault_catalogue:models()],
    case faultcheck_suggest:phrase(atom_to_list(Name), lists:usort(Known)) of
        "" -> "; docs/faults.md lists them";
        Phrase -> Phrase
    end.

fits(Model, #{parameters := Kinds}) ->
    Given = parameters(Model),
    length(Given) =:= length(Kinds) andalso
        lists:all(fun({V, {_, Kind}}) -> good(Kind, V) end, lists:zip(Given, Kinds)).

good(model, V) -> is_value_model(V) andalso validate_model(V) =:= ok;
good(Kind, V) -> faultcheck_fault_parameter:check(Kind, V).

is_value_model(Model) -> lists:any(fun(#{class := C}) -> C =/= communication end, entries(Model)).

why_not(Model, #{parameters := Kinds} = Entry) ->
    Given = parameters(Model),
    case length(Given) =:= length(Kinds) of
        false ->
            invalid("fault ~tp: expected ~ts", [Model, faultcheck_fault_catalogue:term(Entry)]);
        true ->
            [{Value, {Name, Kind}} | _] =
                [P || {V, {_, Kind}} = P <- lists:zip(Given, Kinds), not good(Kind, V)],
            invalid("fault ~tp: ~ts is ~tp, expected ~ts",
                    [Model, Name, Value, expected(Model, Kind)])
    end.

%% There are two models of that name.
expected({delay, _}, _) -> "{calls, N}, {gets, N} or {ns, N} with N from 0 up";
expected(_, Kind) -> faultcheck_fault_parameter:expected(Kind).

cross_check({Name, Low, High} = Model, _) when Name =:= saturate; Name =:= random_offset ->
    check_limits(Low, High, Model);
cross_check({held_offset, Low, High, _} = Model, _) ->
    check_limits(Low, High, Model);
cross_check(_, _) ->
    ok.

check_limits(Low, High, Model) ->
    case at_most(Low, High) of
        true -> ok;
        false -> invalid("fault ~tp: Low is ~tp, expected at most High, ~tp", [Model, Low, High])
    end.

at_most(neg_inf, _) -> true;
at_most(_, inf) -> true;
at_most(inf, _) -> false;
at_most(_, neg_inf) -> false;
at_most(Low, High) -> Low =< High.

%% @doc The same for a trigger alone.
-spec validate_trigger(term()) -> ok | {error, unicode:chardata()}.
validate_trigger(Trigger) when is_list(Trigger) ->
    Kinds = [element(1, C) || C <- Trigger, is_tuple(C), tuple_size(C) > 0],
    case {[C || C <- Trigger, not is_condition(C)], Kinds -- lists:usort(Kinds)} of
        {[], []} -> ok;
        {[], [Twice | _]} -> invalid("trigger ~tp: ~tp stands there twice", [Trigger, Twice]);
        {[Bad | _], _} -> invalid("trigger ~tp: expected ~ts", [Bad, condition_like(Bad)])
    end;
validate_trigger(Trigger) ->
    invalid("trigger ~tp: expected a list of conditions", [Trigger]).

is_condition({from, N}) -> within(N, ?UINT64_MAX);
is_condition({for, N}) -> within(N, ?INT64_MAX);
is_condition({time, Delay, forever}) -> within(Delay, ?INT64_MAX);
is_condition({time, Delay, Duration}) ->
    within(Delay, ?INT64_MAX) andalso within(Duration, ?INT64_MAX);
is_condition({random, P}) -> faultcheck_fault_parameter:check(probability, P);
is_condition({periodic, Period, Active}) ->
    within(Period, ?UINT64_MAX) andalso Period > 0 andalso within(Active, ?UINT64_MAX);
is_condition({predicate, Function}) ->
    (is_atom(Function) orelse is_binary(Function)) andalso Function =/= <<>>;
is_condition(_) -> false.

condition_like(Bad) when is_tuple(Bad), tuple_size(Bad) > 0 ->
    case element(1, Bad) of
        from -> "{from, N} with N from 0 up";
        for -> "{for, N} with N from 0 up";
        time -> "{time, DelayNs, DurationNs | forever}, both from 0 up";
        random -> "{random, P} with P in 0..1";
        periodic -> "{periodic, Period, Active} with Period from 1 and Active from 0 up";
        predicate -> "{predicate, Function}, the name of a C function";
        _ -> condition_like(none)
    end;
condition_like(_) ->
    "one of from, for, time, random, periodic, predicate".

within(N, Most) -> is_integer(N) andalso N >= 0 andalso N =< Most.

invalid(Format, Values) ->
    {error, lists:flatten(io_lib:format("~ts", [single_line(io_lib:format(Format, Values))]))}.

single_line(Text) -> re:replace(Text, "\\s*\\n\\s*", " ", [global, unicode, {return, list}]).

%% ---- what it is -----------------------------------------------------------------------------

%% @doc The class of a valid fault.
-spec class(fault()) -> faultcheck_fault_catalogue:class().
class(Fault) -> maps:get(class, entry(Fault)).

%% @doc Where a valid fault acts.
-spec stage(fault()) -> faultcheck_fault_catalogue:stage().
stage(Fault) -> maps:get(stage, entry(Fault)).

entry(Fault) ->
    Model = model(Fault),
    [Entry | _] = [E || E <- entries(Model), fits(Model, E)],
    Entry.

entries(Model) ->
    case name(Model) of
        none -> [];
        Name -> faultcheck_fault_catalogue:find(Name)
    end.

name(Model) when is_atom(Model) -> Model;
name(Model) when is_tuple(Model), tuple_size(Model) > 1, is_atom(element(1, Model)) ->
    element(1, Model);
name(_) -> none.

parameters(Model) when is_tuple(Model) -> tl(tuple_to_list(Model));
parameters(_) -> [].

%% ---- in words -------------------------------------------------------------------------------

%% @doc One line for people.
-spec describe(fault()) -> unicode:chardata().
describe(Fault) ->
    {Model, Trigger} = normal(Fault),
    unicode:characters_to_list([faultcheck_fault_words:model(Model), ", ",
                                faultcheck_fault_words:trigger(Trigger)]).

%% @doc One armed fault: its model, its stream, and what advances call by call. A fault met at gets
%% has that for each receiver, any other one for `all'.
-module(faultcheck_ref_fault).

-export([new/5, seed/3, change/3, pass/3, apply_value/5, refusal/1]).
-export_type([fault/0, run/0, id/0]).

-type id() :: term().
-type run() :: #{
    trigger := faultcheck_ref_trigger:trigger(),
    window := faultcheck_ref_model:window(),
    active := boolean(),
    budget := non_neg_integer()
}.
-type fault() :: #{
    id := id(),
    model := faultcheck_fault:model(),
    ordinal := non_neg_integer(),
    stream := faultcheck_ref_stream:stream(),
    enabled := boolean(),
    %% receivers it is for
    receiver := all | binary(),
    fresh := run(),
    runs := #{all | binary() => run()}
}.

-spec new(id(), faultcheck_fault:model(), Seed :: non_neg_integer(), binary(),
          Ordinal :: non_neg_integer()) -> fault().
new(Id, Model, Seed, Name, Ordinal) ->
    Run = #{
        trigger => faultcheck_ref_trigger:new(),
        window => faultcheck_ref_model:new_window(),
        active => false,
        budget => budget(Model)
    },
    #{id => Id, model => Model, ordinal => Ordinal,
      stream => faultcheck_ref_stream:new(Seed, Name, Ordinal),
      enabled => true, receiver => all, fresh => Run, runs => #{}}.

budget({drop, N}) -> N;
budget({repeat, N}) -> N;
budget({insert, _, N}) -> N;
budget(_) -> 0.

%% @doc Its stream from the start.
-spec seed(non_neg_integer(), binary(), fault()) -> fault().
seed(Seed, Name, #{ordinal := Ordinal} = Fault) ->
    Fault#{stream := faultcheck_ref_stream:new(Seed, Name, Ordinal)}.

%% @doc A change of the trigger ends the window, for every receiver.
-spec change(faultcheck_ref_trigger:change(), Now :: integer(), fault()) -> fault().
change(Change, Now, #{fresh := Fresh, runs := Runs} = Fault) ->
    On = fun(#{trigger := T} = Run) ->
        Run#{
            trigger := faultcheck_ref_trigger:change(Change, Now, T),
            window := faultcheck_ref_model:new_window()
        }
    end,
    Fault#{fresh := On(Fresh), runs := maps:map(fun(_, Run) -> On(Run) end, Runs)}.

%% @doc One call passes: is it affected?
-spec pass(all | binary(), Now :: integer(), fault()) -> {boolean(), fault()}.
pass(Receiver, Now, #{fresh := Fresh, runs := Runs, stream := Stream} = Fault) ->
    Run = maps:get(Receiver, Runs, Fresh),
    case maps:get(enabled, Fault) of
        false ->
            {false, Fault#{runs := Runs#{Receiver => unaffected(Run)}}};
        true ->
            #{trigger := Trigger} = Run,
            {Fires, T, S} = faultcheck_ref_trigger:fires(Trigger, Now, Stream),
            Advanced = Run#{trigger := T},
            After =
                case Fires of
                    true -> Advanced#{active := true};
                    false -> unaffected(Advanced)
                end,
            {Fires, Fault#{stream := S, runs := Runs#{Receiver => After}}}
    end.

unaffected(Run) -> Run#{active := false, window := faultcheck_ref_model:new_window()}.

%% @doc Applies a value model of a triggered fault.
-spec apply_value(faultcheck_fault:value_model(), {atom(), faultcheck_ref_value:value()},
                  all | binary(), Now :: integer(), fault()) ->
    {faultcheck_ref_model:code(), faultcheck_ref_value:value(), fault()}.
apply_value(Model, Value, Receiver, Now, #{runs := Runs, stream := Stream} = Fault) ->
    #{Receiver := #{window := Window} = Run} = Runs,
    {Code, Result, W, S} = faultcheck_ref_model:apply(Model, Value, Now, Window, Stream),
    {Code, Result, Fault#{stream := S, runs := Runs#{Receiver := Run#{window := W}}}}.

%% @doc Why a model is refused when it is added; FC_OK when it is not.
-spec refusal(faultcheck_fault:model()) -> atom().
refusal({Name, Bit}) when Name =:= bitflip, Bit < 0 -> 'FC_E_BIT';
refusal({stuck_bit, Bit, _}) when Bit < 0 -> 'FC_E_BIT';
refusal({corruption, Byte, _}) when Byte < 0 -> 'FC_E_INDEX';
refusal({corruption, _, Bit}) when Bit < 0; Bit > 7 -> 'FC_E_BIT';
refusal(Model) ->
    case faultcheck_fault:validate(Model) of
        ok -> 'FC_OK';
        {error, _} -> 'FC_E_ARG'
    end.

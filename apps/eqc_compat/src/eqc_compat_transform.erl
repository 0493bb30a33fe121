%% @doc Parse transform of eqc_compat.hrl: what faultcheck_model_transform does (checks, exports,
%% imports that the model defines itself are dropped), and types that the model defines itself
%% replace those of the header.
-module(eqc_compat_transform).

-export([parse_transform/2, format_error/1]).

-spec parse_transform([erl_parse:abstract_form()], [compile:option()]) ->
          [erl_parse:abstract_form()] | {error, list(), list()}.
parse_transform(Forms, Options) ->
    faultcheck_model_transform:parse_transform(without_replaced_types(Forms), Options).

-spec format_error(term()) -> iolist().
format_error(Reason) ->
    faultcheck_model_transform:format_error(Reason).

without_replaced_types(Forms) ->
    {Marked, _} = lists:mapfoldl(fun mark/2, "", Forms),
    Own = [type_name(F) || {own, F} <- Marked, is_type(F)],
    [F || {Where, F} <- Marked,
          not (Where =:= header andalso is_type(F) andalso lists:member(type_name(F), Own))].

%% Whether a form comes from our header.
mark({attribute, _, file, {File, _}} = Form, _) ->
    {{own, Form}, File};
mark(Form, File) ->
    case filename:basename(File) of
        "eqc_compat.hrl" -> {{header, Form}, File};
        _ -> {{own, Form}, File}
    end.

is_type({attribute, _, type, {_, _, _}}) -> true;
is_type({attribute, _, opaque, {_, _, _}}) -> true;
is_type(_) -> false.

type_name({attribute, _, _, {Name, _, Parameters}}) -> {Name, length(Parameters)}.

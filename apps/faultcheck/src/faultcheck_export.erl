%% @doc A stored case for other programs: what is asked for on the command line, and which module
%% of the case can do it.
%%
%% A model exports `export(Case, Dir, What)', which writes files and answers `{ok, Files}', or
%% `{error, Line}' for the user. The formats are those of the model; `at' and `out' are the
%% user's.
-module(faultcheck_export).

-export([parse/1, help/0, exporter/3, run/4]).
-export_type([what/0, format/0]).

-type format() :: mcap | csv | svg.
-type what() :: #{
    format := format(),
    %% seconds of simulated time, for a picture
    at => number(),
    %% where to write, in place of a name that the model chooses in the folder of the case
    out => file:filename()
}.

%% @doc Reads the words behind `faultcheck export'. The error is a line for the user.
-spec parse([string()]) -> {ok, file:filename(), what()} | {error, string()}.
parse(Words) -> parse(Words, none, #{}).

parse(["--" ++ Name | Rest], Path, What) when Name =:= "mcap"; Name =:= "csv"; Name =:= "svg" ->
    Format = list_to_atom(Name),
    case What of
        #{format := Other} when Other =/= Format ->
            {error, lists:concat(["export: --", Other, " and --", Name, ": one at a time"])};
        _ ->
            parse(Rest, Path, What#{format => Format})
    end;
parse(["--at", Text | Rest], Path, What) ->
    case seconds(Text) of
        {ok, At} -> parse(Rest, Path, What#{at => At});
        error -> {error, "export: --at must be seconds >= 0, as 7.42, not " ++ Text}
    end;
parse(["--out", File | Rest], Path, What) when File =/= "" ->
    parse(Rest, Path, What#{out => File});
parse([Option], _, _) when Option =:= "--at"; Option =:= "--out" ->
    {error, lists:concat(["export: ", Option, " needs a value"])};
parse([[$- | _] = Option | _], _, _) ->
    Known = ["--mcap", "--csv", "--svg", "--at", "--out"],
    {error, "export: unknown option " ++ Option ++ faultcheck_suggest:phrase(Option, Known)};
parse([Path | Rest], none, What) ->
    parse(Rest, Path, What);
parse([Word | _], _, _) ->
    {error, "export: unexpected argument " ++ Word ++ "; one case at a time"};
parse([], none, _) ->
    {error, "export: say which case: faultcheck export CASE --mcap|--csv|--svg"};
parse([], _, What) when not is_map_key(format, What) ->
    {error, "export: say what to make: --mcap, --csv or --svg"};
parse([], _, #{at := _, format := Format}) when Format =/= svg ->
    {error, lists:concat(["export: --at is for --svg; --", Format, " has all moments"])};
parse([], Path, What) ->
    {ok, Path, What}.

seconds(Text) ->
    case {string:to_float(Text), string:to_integer(Text)} of
        {{At, ""}, _} when At >= 0 -> {ok, At};
        {_, {At, ""}} when At >= 0 -> {ok, At};
        _ -> error
    end.

%% @doc The options, for people.
-spec help() -> string().
help() ->
    "  --mcap          for Foxglove, Lichtblick, Rerun and others that read MCAP\n"
    "  --csv           a line for each moment and object, for spreadsheets and scripts\n"
    "  --svg           pictures: the map at one moment, and the curves\n"
    "  --at SECONDS    the moment of the map; without it, the end\n"
    "  --out FILE      where to write; without it, into the folder of the case; of --svg\n"
    "                  NAME.svg, NAME-position-error.svg and NAME-nearest.svg for NAME\n".

%% @doc The property's module or a model of the commands, whichever exports the function.
-spec exporter(module(), faultcheck_case:'case'(), {atom(), arity()}) -> {ok, module()} | none.
exporter(Module, #{shrunk := Shrunk}, {Function, Arity}) ->
    Models = [
        Model
     || {ok, Commands} <- [faultcheck_case:commands(Shrunk)],
        {set, _, {call, Model, _, _}} <- Commands
    ],
    Exports = fun(M) ->
        _ = code:ensure_loaded(M),
        erlang:function_exported(M, Function, Arity)
    end,
    case lists:filter(Exports, [Module | lists:usort(Models)]) of
        [First | _] -> {ok, First};
        [] -> none
    end.

%% @doc Lets the model of a case export it.
-spec run(module(), faultcheck_case:'case'(), file:filename(), what()) ->
    {ok, [file:filename()]} | {error, string()}.
run(Module, Case, Dir, What) ->
    case exporter(Module, Case, {export, 3}) of
        {ok, Model} ->
            Model:export(Case, Dir, What);
        none ->
            Line = io_lib:format(
                "nothing can export this case: neither ~ts nor the model of its commands exports "
                "export/3", [Module]
            ),
            {error, lists:flatten(Line)}
    end.

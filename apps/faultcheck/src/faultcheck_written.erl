%% @doc The end of a VM that was started to write one report: its exit status, and one line that
%% says what prevented the report.
-module(faultcheck_written).

-export([halt/2]).

%% @doc Runs Write and ends the VM: status 0 for `ok' and `true', 1 for `false' (the report is
%% written, and what it checks does not hold), 3 when it could not be made. Name is the make target.
-spec halt(Name :: string(), Write :: fun(() -> ok | boolean() | {error, term()})) -> no_return().
halt(Name, Write) ->
    try Write() of
        ok -> erlang:halt(0);
        true -> erlang:halt(0);
        false -> erlang:halt(1);
        {error, Reason} -> fail(Name, faultcheck_enumerate:format_error(Reason))
    catch
        error:{cb, Reason} -> fail(Name, cb_error:format(Reason));
        throw:{enumeration, Reason} -> fail(Name, faultcheck_enumerate:format_error(Reason))
    end.

-spec fail(string(), unicode:chardata()) -> no_return().
fail(Name, Line) ->
    io:format(standard_error, "~ts: ~ts~n", [Name, Line]),
    erlang:halt(3).

%% @doc What each client has asked for so far, and the answers: UDP may lose, repeat and reorder.
%%
%% A request that comes again gets its old answer and has no effect; one that a newer one of the
%% same client has overtaken is too late. So much is remembered and no more.
-module(replay_asked).

-export([new/0, before/3, answered/4]).
-export_type([asked/0, answer/0]).

-type client() :: term().
-type seq() :: integer().
-type answer() :: ok | {error, string()}.
%% The latest answers, newest first; newest clients first.
-opaque asked() :: [{client(), [{seq(), answer()}, ...]}].

-define(CLIENTS, 100).
-define(ANSWERS, 64).

%% @doc Nobody asked.
-spec new() -> asked().
new() -> [].

%% @doc Whether a request was there before.
-spec before(client(), seq(), asked()) -> new | {answered, answer()} | overtaken.
before(Client, Seq, Asked) ->
    case lists:keyfind(Client, 1, Asked) of
        false -> new;
        {_, [{Newest, _} | _]} when Seq > Newest -> new;
        {_, Answers} ->
            case lists:keyfind(Seq, 1, Answers) of
                {_, Answer} -> {answered, Answer};
                false -> overtaken
            end
    end.

%% @doc Remembers the answer to a new request.
-spec answered(client(), seq(), answer(), asked()) -> asked().
answered(Client, Seq, Answer, Asked) ->
    {Answers, Others} =
        case lists:keytake(Client, 1, Asked) of
            {value, {_, Before}, Rest} -> {Before, Rest};
            false -> {[], Asked}
        end,
    Newest = {Client, lists:sublist([{Seq, Answer} | Answers], ?ANSWERS)},
    lists:sublist([Newest | Others], ?CLIENTS).

%% @doc Which airbag is tested, and by which variant of the model.
%%
%% One process tests one airbag at a time, so the choice belongs to the process: a property calls
%% use/1, the model reads current/0.
-module(airbag_options).

-export([new/1, use/1, current/0, label/1]).
-export_type([options/0]).

-type options() :: #{
    %% bare packets, or packets protected with E2E profile 1
    protection := plain | e2e,
    %% how profile 1 is configured: see c_src/airbag/include/airbag.h
    configuration := thesis | recommended,
    %% the first data byte: any byte, or one of five that are one or two flips away from 85
    generator := byte | focused,
    %% messages [85,170] in succession that fire the airbag
    needed := pos_integer(),
    %% after explosion the faults are gone; the paper's model goes on as if they were armed
    fault_list := cleared | paper,
    %% which commands that inject faults are generated, and how many in all
    faults := [bit_flip | repetition],
    max_faults := non_neg_integer(),
    max_flips := non_neg_integer(),
    %% of the sequences in an experiment: sizes go through 1..max_size
    max_size := pos_integer()
}.

%% @doc The options of the paper's last experiment, changed by those given.
-spec new(map()) -> options().
new(Changes) ->
    Unknown = maps:keys(maps:without(maps:keys(defaults()), Changes)),
    Unknown =:= [] orelse error({unknown_airbag_options, Unknown}),
    Options = maps:merge(defaults(), Changes),
    Wrong = [{Key, V} || {Key, V} <- maps:to_list(Options), not valid(Key, V)],
    Wrong =:= [] orelse error({bad_airbag_options, Wrong}),
    Options.

defaults() ->
    #{
        protection => e2e,
        configuration => thesis,
        generator => byte,
        needed => 2,
        fault_list => cleared,
        faults => [bit_flip, repetition],
        max_faults => 4,
        max_flips => 4,
        max_size => 42
    }.

valid(protection, V) -> lists:member(V, [plain, e2e]);
valid(configuration, V) -> lists:member(V, [thesis, recommended]);
valid(generator, V) -> lists:member(V, [byte, focused]);
valid(needed, V) -> is_integer(V) andalso V > 0;
valid(fault_list, V) -> lists:member(V, [cleared, paper]);
valid(faults, V) -> is_list(V) andalso V -- [bit_flip, repetition] =:= [];
valid(max_faults, V) -> is_integer(V) andalso V >= 0;
valid(max_flips, V) -> is_integer(V) andalso V >= 0;
valid(max_size, V) -> is_integer(V) andalso V > 0.

%% @doc Makes the options those of the calling process.
-spec use(options()) -> ok.
use(Options) ->
    _ = put(?MODULE, Options),
    ok.

%% @doc The options of the calling process.
-spec current() -> options().
current() ->
    case get(?MODULE) of
        undefined -> new(#{});
        Options -> Options
    end.

%% @doc A few words for reports.
-spec label(options()) -> string().
label(#{protection := plain, generator := Generator, needed := Needed}) ->
    lists:flatten(io_lib:format("plain, ~s generator, ~b needed", [Generator, Needed]));
label(#{configuration := Configuration, generator := Generator} = Options) ->
    #{max_flips := Flips, max_faults := Faults} = Options,
    Limit = [io_lib:format(", at most ~b flips", [Flips]) || Flips < Faults],
    lists:flatten(io_lib:format("E2E ~s, ~s generator~s", [Configuration, Generator, Limit])).

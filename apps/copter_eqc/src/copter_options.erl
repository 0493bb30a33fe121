%% @doc What is tested: which world, how many copters and faults, which parameters.
%%
%% One process tests one simulation at a time, so the choice belongs to the process: a property
%% calls use/1, the model reads current/0. world/1 gives the worlds W1 to W9 of docs/search.md.
-module(copter_options).

-export([new/1, use/1, current/0, world/1, worlds/0, label/1, values/1]).
-export_type([options/0, ranges/0]).

%% Of the parameters of faults: as docs/copter.md lists them, or milder ones.
-type ranges() :: default | mild.
-type options() :: #{
    world := copter_world:world(),
    min_copters := pos_integer(),
    max_copters := pos_integer(),
    max_faults := non_neg_integer(),
    %% kinds of faults that are generated
    faults := [copter_fault:kind()],
    ranges := ranges(),
    dt_us := pos_integer(),
    its_ms := pos_integer(),
    anchor_ms := pos_integer(),
    %% decides its_ms as well, unless that is given
    configuration := copter_configuration:name(),
    %% parameters and gains by name, beside those of the configuration
    set := #{atom() => number()},
    %% simulated time of a test that is filled up, as the campaign's and the search's are
    horizon_ms := pos_integer(),
    objective := copter_sut:objective(),
    threads := pos_integer(),
    brute_force := boolean()
}.

%% @doc The options of section 12 of the reference, changed by those given.
-spec new(map()) -> options().
new(Changes) ->
    Unknown = maps:keys(maps:without(maps:keys(defaults()), Changes)),
    Unknown =:= [] orelse error({unknown_copter_options, Unknown}),
    Configuration = maps:get(configuration, Changes, default),
    valid(configuration, Configuration) orelse
        error({bad_copter_options, [{configuration, Configuration}]}),
    Defaults = (defaults())#{its_ms => copter_configuration:its_ms(Configuration)},
    Options = maps:merge(Defaults, Changes),
    Wrong = [{Key, V} || {Key, V} <- maps:to_list(Options), not valid(Key, V)],
    Wrong =:= [] orelse error({bad_copter_options, Wrong}),
    #{min_copters := Min, max_copters := Max} = Options,
    Min =< Max orelse error({bad_copter_options, [{min_copters, Min}, {max_copters, Max}]}),
    Options.

defaults() ->
    #{
        world => {box, 10},
        min_copters => 1,
        max_copters => 10,
        max_faults => 3,
        faults => copter_fault:kinds(),
        ranges => default,
        dt_us => 5000,
        its_ms => 100,
        anchor_ms => 100,
        configuration => default,
        set => #{},
        horizon_ms => 20000,
        objective => stop,
        threads => 1,
        brute_force => false
    }.

valid(world, V) -> is_world(V);
valid(min_copters, V) -> positive(V);
valid(max_copters, V) -> positive(V);
valid(max_faults, V) -> is_integer(V) andalso V >= 0;
valid(faults, V) -> is_list(V) andalso V -- copter_fault:kinds() =:= [];
valid(ranges, V) -> lists:member(V, [default, mild]);
valid(dt_us, V) -> positive(V);
valid(its_ms, V) -> positive(V);
valid(anchor_ms, V) -> positive(V);
valid(configuration, V) -> lists:member(V, copter_configuration:names());
valid(set, V) -> is_map(V) andalso lists:all(fun is_number/1, maps:values(V));
valid(horizon_ms, V) -> positive(V);
valid(objective, V) -> lists:member(V, [gap, stop, late]);
valid(threads, V) -> positive(V) andalso V =< 64;
valid(brute_force, V) -> is_boolean(V).

is_world(reference) -> true;
is_world(open) -> true;
is_world({box, N}) -> positive(N);
is_world({moved, World, {Dx, Dy, Turns}}) ->
    is_world(World) andalso is_float(Dx) andalso is_float(Dy) andalso
        lists:member(Turns, [0, 1, 2, 3]);
is_world(_) -> false.

positive(V) -> is_integer(V) andalso V > 0.

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

%% @doc One of the worlds of the search report.
-spec world(atom()) -> options().
world(Name) ->
    {Name, Changes} = lists:keyfind(Name, 1, worlds()),
    new(Changes#{min_copters => maps:get(max_copters, Changes)}).

%% @doc Their names and what they change.
-spec worlds() -> [{atom(), map()}].
worlds() ->
    Reference = #{world => reference, max_copters => 4},
    Box = #{world => {box, 10}, max_copters => 10},
    Wide = #{set => #{comfort_radius => 0.9, base_radius => 1.5}},
    Soft = #{set => #{comfort_radius => 0.9, base_radius => 1.5, pos_p => 0.3, vel_p => 0.2}},
    Merge = fun(Maps) ->
        lists:foldl(fun(M, All) -> maps:merge(All, M) end, #{max_faults => 3}, Maps)
    end,
    None = #{max_faults => 0},
    Mild = #{ranges => mild},
    [
        {'W1', Merge([Reference, None])},
        {'W2', Merge([Reference])},
        {'W3', Merge([Box, None])},
        {'W4', Merge([Box])},
        {'W5', Merge([Reference, Wide])},
        {'W6', Merge([Reference, Soft, Mild])},
        {'W7', Merge([Reference, Wide, None])},
        {'W8', Merge([Reference, Soft, Mild, #{max_faults => 1}])},
        {'W9', Merge([Reference, Soft])}
    ].

%% @doc Parameters and gains that differ from the simulator's own.
-spec values(options()) -> #{atom() => number()}.
values(#{configuration := Configuration, set := Set}) ->
    maps:merge(copter_configuration:values(Configuration), Set).

%% @doc A few words for reports.
-spec label(options()) -> string().
label(Options) ->
    #{world := World, min_copters := Min, max_copters := Max, max_faults := Faults} = Options,
    #{configuration := Configuration, ranges := Ranges} = Options,
    Copters =
        case Min of
            Max -> io_lib:format("~b copters", [Max]);
            _ -> io_lib:format("~b to ~b copters", [Min, Max])
        end,
    Armed =
        case {Faults, Ranges} of
            {0, _} -> "no faults";
            {1, default} -> "at most 1 fault";
            {1, mild} -> "at most 1 mild fault";
            {_, default} -> io_lib:format("at most ~b faults", [Faults]);
            {_, mild} -> io_lib:format("at most ~b mild faults", [Faults])
        end,
    Words = [place(World), Copters, Armed, atom_to_list(Configuration)],
    lists:flatten(lists:join(", ", Words)).

place(reference) -> "reference world";
place(open) -> "open sky";
place({box, N}) -> io_lib:format("box for ~b", [N]);
place({moved, World, _}) -> [place(World), ", moved"].

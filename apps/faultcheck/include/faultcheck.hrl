%% For modules that hold a grouped stateful model or properties over one.
%%
%% Include it after -module and before the first function. It brings PropEr's
%% header, and a parse transform that
%%   - checks names and arities of the grouped callbacks (X_args, X_pre, ...),
%%   - exports them, so a model needs no -export line for its callbacks,
%%   - makes commands/1,2, run_commands/2, more_commands/2 and command_names/1
%%     mean those of faultcheck_statem, and uniform/2 its generator,
%%   - lets the module define functions that PropEr's header imports (byte/0, ...).
%% See faultcheck_model for what a model consists of.
-ifndef(FAULTCHECK_HRL).
-define(FAULTCHECK_HRL, true).

-compile({parse_transform, faultcheck_model_transform}).
-include_lib("proper/include/proper.hrl").

-endif.

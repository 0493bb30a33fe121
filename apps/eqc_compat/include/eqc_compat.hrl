%% In place of the two include lines of a model written for grouped eqc_statem:
%%
%%   -include_lib("eqc/include/eqc.hrl").
%%   -include_lib("eqc/include/eqc_statem.hrl").
%%
%% Macros and generators are PropEr's, which have the same names; commands, their runs and
%% shrinking are FaultCheck's. Not for a code path that also has a real eqc.
-ifndef(EQC_COMPAT_HRL).
-define(EQC_COMPAT_HRL, true).

-compile({parse_transform, eqc_compat_transform}).
-include_lib("proper/include/proper.hrl").

-import(eqc, [quickcheck/1]).
-import(eqc_statem, [pretty_commands/4, eq/2]).

-type symbolic_state() :: eqc_statem:symbolic_state().
-type dynamic_state() :: eqc_statem:dynamic_state().
-type property() :: eqc:property().

-endif.

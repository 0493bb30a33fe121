#!/usr/bin/env bash
# Writes what is made from faultcheck_fault_catalogue: docs/faults.md and the list of fault models of the
# visualizer's form. Tests compare both with the catalogue.
set -euo pipefail
cd "$(dirname "$0")/.."
rebar3 compile >/dev/null
erl -noinput -boot start_clean -pa _build/default/lib/faultcheck/ebin -eval '
    Write = fun(Path, Text) ->
        ok = file:write_file(Path ++ ".new", unicode:characters_to_binary(Text)),
        ok = file:rename(Path ++ ".new", Path)
    end,
    Write("docs/faults.md", faultcheck_fault_catalogue:markdown()),
    Write("visualizer/page/src/panels/generated/fault_models.json", faultcheck_fault_catalogue:json()),
    halt(0).'

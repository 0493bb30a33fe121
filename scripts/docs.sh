#!/usr/bin/env bash
# Writes the documentation of the interfaces: _build/docs/index.html, from the C headers (doxygen) and the Erlang
# modules (edoc). A public function, type or member without a comment is an error, so is a broken one: exit status 1.
set -euo pipefail
cd "$(dirname "$0")/.."
docs=_build/docs
rm -rf "$docs"
mkdir -p "$docs"
status=0

# ---- C ----
FC_VERSION=$(cat VERSION)
FC_DOCS=$docs
FC_HEADERS=$(git ls-files 'c_src/faultcheck/*.h' 'c_src/e2e/*.h' 'c_src/coptersim/*.h' |
  grep -E '^c_src/[a-z0-9]+/(include|embedded)/[^/]*$' | tr '\n' ' ')
export FC_VERSION FC_DOCS FC_HEADERS
doxygen docs/api/Doxyfile || status=1

# ---- Erlang ----
erl -noinput -boot start_clean -eval '
    Apps = init:get_plain_arguments(),
    Make = fun(App) ->
        edoc:application(list_to_atom(App), "apps/" ++ App,
                         [{dir, filename:join("'$docs'", App)}, {overview, "docs/api/" ++ App ++ ".edoc"},
                          {source_path, ["apps/" ++ App ++ "/src"]}, {sort_functions, false}])
    end,
    halt(try lists:foreach(Make, Apps), 0 catch _:_ -> 1 end).' -extra c_bridge faultcheck eqc_compat || status=1

cp docs/api/index.html "$docs/index.html"
[ $status -ne 0 ] || echo "the documentation begins at $docs/index.html"
exit $status

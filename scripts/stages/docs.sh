#!/usr/bin/env bash
# Every public function, type and member is documented, and the documentation can be made of it.
source "$(dirname "$0")/lib.sh"
check "make docs" scripts/docs.sh
check "it has a page for fc_fault.h" test -s _build/docs/c/fc__fault_8h.html
check "and for the module cb" test -s _build/docs/c_bridge/cb.html
finish

# FaultCheck: the single entry. `make` lists what there is; the work itself is done by scripts/.
SHELL := /bin/bash
.DEFAULT_GOAL := help
MAKEFLAGS += --no-print-directory

FUZZ_SECONDS ?= 60
FUZZ_RUNS ?=
PREFIX ?= /usr/local
export SETUP CI

ifneq ($(shell uname -s)-$(shell uname -m),Linux-x86_64)
$(error FaultCheck needs Linux on x86-64 (ELF, DWARF and libffi of that machine); this is $(shell uname -s) on $(shell uname -m))
endif

.PHONY: help setup native compile test demo visualizer bench coverage airbag-report e2e-report copter-campaign copter-figures \
        search-report mutants fuzz replay install docs format lint clean chroot-check

help:  ## this list
	@awk -F ':.*## ' '/^[a-z0-9-]+:.*## / {printf "  make %-15s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

setup:  ## install what is missing for everything below (shows the list and asks; SETUP=no only tells)
	@scripts/setup.sh all

native:  ## build the C and C++ side (-O2 -g) into _build/native/lib and _build/native/bin
	@scripts/setup.sh --quiet native
	@scripts/build_native.sh

compile: native  ## build everything: native, then the Erlang applications
	@scripts/setup.sh --quiet demo
	@rebar3 compile

# Also SEED=N: other tests
demo:  ## find, shrink, store and explain the airbag's unintended explosion
	@scripts/setup.sh --quiet demo
	@SEED="$(SEED)" scripts/demo.sh

# Of a case with a flight also: SPEED=1 (0: without waiting), SET="pos_p=1.0 gate=median", BISECT=base_radius=1:3
replay:  ## run a stored case again: make replay CASE=cases/<id>
	@scripts/setup.sh --quiet demo
	@SPEED="$(SPEED)" SET="$(SET)" BISECT="$(BISECT)" scripts/replay.sh "$(CASE)"

# Also LIVE=1, SCENARIO=FILE, ORIGINAL=1, PORT=8765, TILES=DIR (a folder of map tiles)
visualizer:  ## watch and steer flights in a browser: make visualizer [CASE=cases/<id>]
	@scripts/setup.sh --quiet visualizer
	@scripts/visualizer.sh "$(CASE)"

test:  ## install what is missing, build, and run every test and check
	@scripts/setup.sh --quiet test
	@scripts/test.sh

bench:  ## measure speed and memory; CHECK=1 fails when a bound is missed
	@scripts/setup.sh --quiet bench
	@CHECK="$(CHECK)" scripts/bench.sh

coverage:  ## C line coverage of the airbag under three fault classes (lcov HTML)
	@scripts/setup.sh --quiet coverage
	@scripts/coverage.sh

airbag-report:  ## repeat the experiments of the paper: _build/reports/airbag.md
	@scripts/setup.sh --quiet demo
	@scripts/report.sh airbag_report airbag log

e2e-report:  ## Hamming distances; which E2E profile detects which fault, how often: _build/reports/e2e.md
	@scripts/setup.sh --quiet demo
	@scripts/report.sh e2e_report e2e

copter-campaign:  ## which faults make quadcopters collide, and what helps: _build/reports/copter_campaign.md
	@scripts/setup.sh --quiet demo
	@scripts/report.sh copter_campaign copter_campaign

copter-figures:  ## the figures of Papers II and III flown again, checked: _build/reports/copter_figures.md
	@scripts/setup.sh --quiet demo
	@scripts/report.sh copter_figures copter_figures

search-report:  ## what guided search brings over chance: _build/reports/search.md
	@scripts/setup.sh --quiet demo
	@scripts/report.sh copter_search_report search

mutants:  ## how many seeded defects of the C libraries the models and the C tests find: _build/reports/mutants.md
	@scripts/setup.sh --quiet demo
	@scripts/mutants.sh
	@scripts/mutants.sh c-tests

fuzz:  ## run each fuzz target for FUZZ_SECONDS=60 seconds, or FUZZ_RUNS=10000000 times however long that takes
	@scripts/setup.sh --quiet test
	@scripts/fuzz.sh "$(FUZZ_SECONDS)" "$(FUZZ_RUNS)"

install:  ## install libraries, applications and bin/faultcheck: make install PREFIX=/usr/local
	@scripts/setup.sh --quiet demo
	@scripts/install.sh "$(PREFIX)"

docs:  ## documentation of the C headers and the Erlang modules: _build/docs/index.html
	@scripts/setup.sh --quiet docs
	@scripts/docs.sh

format:  ## format C and C++ sources
	@scripts/setup.sh --quiet test
	@scripts/format.sh

lint:  ## formatting, shellcheck, public headers as C99 and C++17, xref
	@scripts/setup.sh --quiet test
	@FC_RESULT=/dev/null scripts/stages/format.sh
	@FC_RESULT=/dev/null scripts/stages/lint.sh

chroot-check:  ## make demo and make test in fresh Debian 12 and 13 (needs root and debootstrap)
	@scripts/chroot_check.sh bookworm
	@scripts/chroot_check.sh trixie

.DEFAULT:
	@echo "make: there is no target '$@'; make help lists what there is" >&2; exit 2

clean:  ## remove everything built; stored cases stay
	@rm -rf _build apps/c_bridge/priv

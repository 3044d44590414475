# The commands of the house. `make demo` and `make test` do everything from a bare Debian 12;
# the others expect that its packages are there (`make deps`).

PRESET  ?= release
JOBS    ?= $(shell nproc)
FILTER  ?=
RUNS    ?= 3
PYTHON  ?= python3
BUILD   := build/$(PRESET)
SOURCES  = $(shell git ls-files '*.h' '*.cpp')

.DEFAULT_GOAL := build
.NOTPARALLEL:
.PHONY: build deps oracle demo test conformance conformance-baseline stdlib golden reference bench differential random format tidy clean help

build: ## the optimised program, at build/durer
	@test -f $(BUILD)/build.ninja || cmake --preset $(PRESET)
	@cmake --build $(BUILD) --target durer -j $(JOBS)
	@ln -sfn $(PRESET)/cli/durer build/durer

deps: ## install what building and testing need (Debian packages; with sudo unless root)
	@tools/deps build test

oracle: ## install POV-Ray, its includes and its example scenes
	@tools/deps oracle

demo: deps build ## build, render the demo scene to build/first-light.png and show it
	build/durer +Iexamples/first-light.scene +Obuild/first-light.png +W800 +H600 +A0.3 --show

test: deps build ## build and pass all tests
	@cmake --build $(BUILD) -j $(JOBS)
	ctest --test-dir $(BUILD) --output-on-failure -j 2

conformance: build ## compare with POV-Ray on its example scenes: make conformance FILTER=csg
	$(PYTHON) tools/conformance.py --html build/conformance $(FILTER)

conformance-baseline: build ## the same, and take the verdicts as the new baseline
	$(PYTHON) tools/conformance.py --html build/conformance --update-baseline $(FILTER)

stdlib: ## make the includes anew that come from the tables of stdlib/data
	$(PYTHON) tools/stdlib.py generate

golden: ## make the golden pictures anew, from POV-Ray: make golden FILTER=torus
	$(PYTHON) tools/golden.py regenerate $(FILTER)

reference: build ## the pages of docs/reference, with swatches of all that the library declares
	$(PYTHON) tools/reference.py all

bench: build ## time both programs on the scenes of bench/: make bench FILTER=slab
	$(PYTHON) tools/bench.py --runs $(RUNS) $(FILTER)

differential: build ## print random programs with both programs and compare the text
	$(PYTHON) tools/differential.py run --count 2000

random: build ## render random scenes with both programs and compare the pictures
	$(PYTHON) tools/random_scenes.py --count 200

format: ## clang-format all sources in place
	clang-format -i $(SOURCES)

tidy: ## clang-tidy all sources
	@cmake --preset dev
	run-clang-tidy -quiet -p build/dev $(filter %.cpp,$(SOURCES))

clean: ## remove everything that was built
	rm -rf build

help: ## this list
	@sed -n 's/^\([a-z-]*\):[^#]*## /\1\t/p' $(MAKEFILE_LIST) | expand -t 22

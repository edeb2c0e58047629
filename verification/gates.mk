# SPDX-License-Identifier: Apache-2.0
# Gates of `make test`; included by the Makefile.

.PHONY: check format gate one generated boards apart pictures unit scenes coverage misra arm console-test objects programs proof proof-night trace demo velocity sweep charts-fuzz mutants worst-case \
    worst-case-approve

test: bootstrap-test ## Run everything that can fail; the last line is `N passed, N failed`
	@ruby tools/gates.rb

check: bootstrap-test ## A change in about two minutes: form, types, rooms, tests that reach it, trace; SINCE=commit, the last one unless said
	@ruby tools/check.rb $(or $(SINCE),HEAD)

format: bootstrap-test ## Brings the sources in C, C++, Ruby and TypeScript to their form
	@git ls-files -z '*.c' '*.h' '*.cpp' | xargs -0 clang-format -i
	@git ls-files -z '*.rb' | xargs -0 rubocop --autocorrect --format quiet
	@npm --silent --prefix app/console run format

gate: bootstrap-test ## Run one gate again, and what it needs: make gate NAME=unit
	@ruby tools/gates.rb $(NAME)

# An unknown gate is refused before anything is installed; there may be no ruby yet.
GATES := $(shell sed -n 's/^- name: //p' verification/gates.yml)
ifneq ($(filter gate,$(MAKECMDGOALS)),)
ifneq ($(if $(NAME),$(filter-out $(GATES),$(NAME)),none),)
$(error NAME is '$(NAME)', but the gates are: $(GATES))
endif
endif

# One file of tests, in C or Ruby.
ONE := $(firstword $(wildcard verification/unit/*/$(NAME).c verification/integration/*/$(NAME).c core/robot/*/test/$(NAME).c \
    tools/test/$(NAME).rb tools/test/*/$(NAME).rb $(foreach d,tools/chartc verification,$(d)/*/$(NAME).rb $(d)/*/*/$(NAME).rb)))
ifneq ($(filter one,$(MAKECMDGOALS)),)
ifeq ($(ONE),)
$(error NAME is '$(NAME)', but there is no such file of tests; one is test_encoder)
endif
endif

one: bootstrap-test ## One file of tests: make one NAME=test_encoder
	@$(MAKE) --no-print-directory -j2 $(if $(filter %.c,$(ONE)),generated build/gcc/libtest.a,programs)
	@$(if $(filter %.c,$(ONE)),$(CEEDLING) test:$(NAME),env -u MAKEFLAGS -u MAKELEVEL -u NAME ruby $(ONE) -v)

ALL_APP := $(wildcard app/*/*.c app/*/*/*.c bsp/*/*.c bsp/*/*/*.c)
OTHER_BOARDS := $(filter-out sim,$(BOARDS))
# A static program loads no library while it runs.
STATIC_BOARDS := $(filter-out $(patsubst bsp/%/board.yml,%,$(shell grep -lx 'loads_library: true' bsp/*/board.yml)),$(OTHER_BOARDS))
# The verified programs run on the simulated control box, whichever board the programs are for.
BOX_SOURCES := $(filter-out %_main.c bsp/sim/bsp_sim.c bsp/sim/bench_sim.c bsp/sim/wire.c,$(wildcard bsp/sim/*.c bsp/sim/model/*.c bsp/sim/orders/*.c)) \
    app/control/board_inputs.c
OBJECTS := $(call object,$(CORE_SOURCES) $(ALL_APP) bsp/no_bench.c $(NAMES) $(GEN)/interface/app/event_words.c \
    $(FIND_ROBOT) $(BOARD_TABLE) $(GEN)/interface/app/messages.c $(API) $(HANDLERS) $(IGTL_TABLES) $(GEN)/interface/app/columns.c \
    $(GEN)/interface/app/fields.c $(GEN)/assets/assets.c $(GEN)/assets/chart_names.c)

generated: $(GENERATED)

objects: $(OBJECTS)

# A box for the board sbrio where there is none, loaded before control's libraries.
PRETENDED_BOX := build/boards/pretended_box.so
$(PRETENDED_BOX): verification/system/pretended_box.c $(wildcard bsp/sim/model/sim_*.c) core/card/card_frame.c core/base/crc.c \
    $(GEN)/robot/robot_neuro.c $(wildcard bsp/sim/*.h bsp/sim/model/*.h core/card/*.h core/robot/*.h) | $(GENERATED)
	@mkdir -p $(@D)
	@$(CC) $(WARNINGS) -O2 -g -D_GNU_SOURCE $(BSP_INCLUDES) -shared -fPIC -fvisibility=hidden -Wl,-z,defs $(filter %.c,$^) -lm -o $@

boards: $(OTHER_BOARDS:%=board-%) $(PRETENDED_BOX) ## All programs of the boards that are not simulated: build/boards

board-%: $(OUT)/libcore.a
	@$(MAKE) --no-print-directory BOARD=$* APART=build/boards/$* apart

apart: $(PROGRAMS:%=$(LINKED)/%)

# A process that damages what it may write.
$(BIN)/neighbour: verification/system/neighbour.c $(call object,$(EXCHANGE)) $(OUT)/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(WARNINGS) -O2 -g -D_GNU_SOURCE $(APP_INCLUDES) $^ -o $@

programs: $(BINARIES) $(BIN)/boresight-client $(BIN)/codec-oracle $(BIN)/decode-differ $(BIN)/neighbour

demo: bootstrap-test ## The targets of the thesis with a real client; ROBOT=NAME chooses the robot
	@$(MAKE) --no-print-directory -j2 programs
	@ruby verification/demo/demo.rb $(or $(ROBOT),$(DEFAULT_ROBOT))

velocity: bootstrap-test ## Figures 29 to 31 of the thesis: 600 ticks at 833 ticks/s; PICTURE=file.svg
	@$(MAKE) --no-print-directory -j2 programs
	@ruby verification/demo/velocity.rb $(PICTURE)

sweep: bootstrap-test ## Frequency sweep of the ProstateRobot's rotation, six minutes; PICTURE=file.svg, FILE=sweep.csv only draws that
	@$(MAKE) --no-print-directory -j2 programs
	@ruby verification/demo/sweep.rb $(or $(PICTURE),$(CURDIR)/build/demo/sweep/sweep.svg) $(FILE)

pictures: bootstrap-pictures ## The pictures of the documents, by the tests that show them: docs/images; NAME=console makes a part
	@$(MAKE) --no-print-directory -j2 programs
	@ruby tools/pictures.rb --make $(NAME)

unit: bootstrap-test $(GENERATED) ## Unit and integration tests under sanitizers, with coverage: build/asan/coverage/lcov.info
	@$(MAKE) --no-print-directory -j2 CONFIG=asan build/asan/libtest.a build/asan/libcore.a
	status=0; ruby tools/c_tests.rb asan || status=$$?; ruby tools/uncovered.rb || status=$$?; exit $$status

coverage: bootstrap-test generated ## The same coverage of gcc's code, counted by lcov and gcovr: build/coverage
	@$(MAKE) --no-print-directory -j2 build/gcc/libaround.a
	@$(MAKE) --no-print-directory -j2 CONFIG=gcov build/gcov/libcore.a
	ruby tools/c_tests.rb gcov
	@ruby tools/coverage.rb

misra: bootstrap-test $(GENERATED) ## MISRA findings of the core
	ruby tools/misra.rb

proof: bootstrap-test $(GENERATED) ## Sentences proved for every input, and seeded faults refuted; NAME=word chooses
	ruby tools/proof/proof.rb $(NAME)

proof-night: bootstrap-test $(GENERATED) ## The same with the proofs that take too long for every day
	ruby tools/proof/proof.rb --night $(NAME)

charts-fuzz: bootstrap-test ## Random charts against the standard's algorithm: COUNT=1000 SEED=1; what differs is kept, made small
	@ruby tools/chartc/conformance/random/hunt.rb $(or $(COUNT),1000) $(or $(SEED),1)

mutants: bootstrap-test generated ## Mutants of the product charts, with every action that may be added to a place
	@WHOLE=1 ruby verification/mutants/test_mutants.rb

worst-case: bootstrap-test generated ## What each chart costs at most, in instructions and bytes
	@ruby -r ./verification/model/worst_case_table -e 'WorstCase::Table.run'

worst-case-approve: worst-case
	@cp build/conformance/worst_case.yml verification/model/worst_case.yml

# A test of another board brings its bsp_<name>.c along: there is one bsp_open() in a program.
TESTED := $(filter-out %_main.c app/supervisor/% $(foreach board,$(OTHER_BOARDS),bsp/$(board)/bsp_$(board).c),$(CORE_SOURCES) $(ALL_APP)) app/supervisor/status_parts.c \
    $(NAMES) $(GEN)/interface/app/event_words.c $(GEN)/interface/app/fields.c $(GEN)/interface/app/messages.c $(GEN)/assets/chart_names.c $(GEN)/interface/app/requests.c $(IGTL_TABLES) $(ANSWER_LIST) $(FIND_ROBOT)
$(OUT)/libtest.a: $(call object,$(TESTED))
	@rm -f $@; ar rcs $@ $^
# Without what the coverage counts.
$(OUT)/libaround.a: $(call object,$(filter-out $(CORE_SOURCES),$(TESTED)))
	@rm -f $@; ar rcs $@ $^

scenes: bootstrap-test ## The long scenes of the C tests, whole, on the product's code
	@$(MAKE) --no-print-directory -j2 build/gcc/libtest.a
	ruby tools/c_tests.rb gcc

ARM_TESTED := $(filter-out app/% $(OTHER_BOARDS:%=bsp/%/%),$(TESTED)) app/control/board_inputs.c
$(OUT)/libtest-core.a: $(call object,$(ARM_TESTED))
	@rm -f $@; ar rcs $@ $^

arm: bootstrap-test ## The core's tests as Cortex-A9 code
	@$(MAKE) --no-print-directory -j2 CONFIG=arm build/arm/libtest-core.a
	@cp build/arm/libtest-core.a build/arm/libtest.a
	ruby tools/c_tests.rb arm

console-test: app/console/node_modules/.installed $(GENERATED)
	cd app/console && npm run --silent typecheck && npm run --silent lint && npm run --silent format:check
	ruby tools/results.rb vitest build/console-tests.json npm --prefix app/console test --silent

trace: ## Every requirement with its parents, places, tests and verdict
	@ruby tools/trace.rb matrix

# SPDX-License-Identifier: Apache-2.0
# The controller with an operator, a world and faults by chance; included by the Makefile.

.PHONY: supervise
COUNT ?= 200
SEED ?= 1
PLAY ?= random

# Unity comes with Ceedling: the rig of the integration tests asserts with it.
UNITY := .tools/gems/gems/ceedling-1.2.1/vendor/unity/src
SUPERVISE_SOURCES := $(wildcard verification/supervise/*.c verification/supervise/*/*.c verification/oracle/*.c core/robot/*/test/*_truth.c) \
    verification/integration/support/rig.c verification/integration/support/refused_way.c \
    verification/unit/support/refused_pair.c $(BOX_SOURCES) $(FIND_ROBOT) $(NAMES) $(ANSWER_LIST)
build/gcc/bin/supervise: $(call object,$(SUPERVISE_SOURCES)) $(OUT)/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) -I$(UNITY) $^ $(UNITY)/unity.c -lm -o $@
	@echo "built $@"

$(OUT)/verification/supervise/%.o $(OUT)/verification/integration/%.o $(OUT)/verification/unit/%.o: FLAGS = -D_GNU_SOURCE $(TEST_INCLUDES) -I$(UNITY)

supervise: bootstrap-test ## The controller in COUNT scenes from SEED on, PLAY=random, jogs, corners, interrupted, spread, magnitude, taps, rivals, modes, programs, sweeps, flips, operator, late or hands, of ROBOT=neuro
	@$(MAKE) --no-print-directory -j2 build/gcc/bin/supervise
	@build/gcc/bin/supervise --robot $(or $(ROBOT),$(DEFAULT_ROBOT)) $(COUNT) $(SEED) $(PLAY)

# SPDX-License-Identifier: Apache-2.0
# Digests of random scenes, by which two builds are compared; included by the Makefile after supervise.mk.

.PHONY: digests
DIGESTS_SOURCES := $(wildcard verification/digests/*.c) $(filter-out verification/supervise/supervise.c,$(SUPERVISE_SOURCES))
build/gcc/bin/digests: $(call object,$(DIGESTS_SOURCES)) $(OUT)/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) -I$(UNITY) $^ $(UNITY)/unity.c -lm -o $@
	@echo "built $@"

$(OUT)/verification/digests/%.o: FLAGS = -D_GNU_SOURCE $(TEST_INCLUDES) -I$(UNITY)

digests: bootstrap-test ## Digests of 10,000 random scenes, or SCENES=n, into FILE; with BEFORE=file the scenes that differ from it
	@$(MAKE) --no-print-directory build/gcc/bin/digests
	@ruby tools/digests/digests.rb $(or $(FILE),$(error FILE is missing: the file for the digests)) $(SCENES)
	@$(if $(BEFORE),ruby tools/digests/digests.rb --compare $(BEFORE) $(FILE))

# SPDX-License-Identifier: Apache-2.0
# How soon a blind axis is found, measured; included by the Makefile after supervise.mk.

.PHONY: detection
DETECTION_SOURCES := verification/detection/detection.c verification/integration/support/rig.c $(BOX_SOURCES) $(ANSWER_LIST)
build/gcc/bin/detection: $(call object,$(DETECTION_SOURCES)) $(OUT)/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) -I$(UNITY) $^ $(UNITY)/unity.c -lm -o $@
	@echo "built $@"

$(OUT)/verification/detection/%.o: FLAGS = -D_GNU_SOURCE $(TEST_INCLUDES) -I$(UNITY)

detection: bootstrap-test ## Time and way until a fault of an encoder or a motor is found, into docs/detection.md
	@$(MAKE) --no-print-directory -j2 build/gcc/bin/detection
	@build/gcc/bin/detection > docs/detection.md

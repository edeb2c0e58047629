# SPDX-License-Identifier: Apache-2.0
# The robot for a page: the core and the simulated control box as WebAssembly; included by the Makefile.

.PHONY: wasm

# Words are formatted by this C library. Its usual vsnprintf() would import files, to complain of long doubles.
WASM_LIBC := $(addprefix /usr/lib/wasm32-wasi/,libc-printscan-long-double.a libc.a) \
    /usr/lib/llvm-19/lib/clang/19/lib/wasi/libclang_rt.builtins-wasm32.a
CLOSED_LOOP_SOURCES := $(wildcard site/*.c) $(BOX_SOURCES) app/control/lamps.c app/replay/replay.c app/replay/field_name.c \
    $(addprefix app/recording/,recording_block.c cycle_code.c cycle_words.c proof.c) $(GEN)/interface/app/fields.c $(NAMES) $(FIND_ROBOT)

SITE_INCLUDES := $(BSP_INCLUDES) -I.
$(OUT)/site/%.o: FLAGS = $(SITE_INCLUDES)
$(OUT)/verification/site/%.o: FLAGS = $(SITE_INCLUDES)

wasm: bootstrap-test ## The core and the simulated control box as WebAssembly: build/site/robot.wasm
	@$(MAKE) --no-print-directory -j2 CONFIG=wasm build/site/robot.wasm

ifeq ($(CONFIG),wasm)
build/site/robot.wasm: $(call object,$(CORE_SOURCES) $(CLOSED_LOOP_SOURCES)) site/site.mk
	@mkdir -p $(@D)
	@wasm-ld-19 --no-entry --strip-all --stack-first -z stack-size=262144 $(filter %.o,$^) $(WASM_LIBC) -o $@
	@echo "built $@"
endif

# The same in native code, to be compared with it.
build/gcc/bin/closed-loop-scene: $(call object,$(CLOSED_LOOP_SOURCES) verification/site/scene.c) build/gcc/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) $(LDFLAGS) $^ -o $@
	@echo "built $@"

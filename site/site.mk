# SPDX-License-Identifier: Apache-2.0
# The robot for a page: the core and the simulated control box as WebAssembly; included by the Makefile.

.PHONY: wasm site

# Words are formatted by this C library. Its usual vsnprintf() imports files, to complain of long doubles: where nothing
# refuses them (site/served/no_system.c), a larger one stands before it.
WASM_LIBC := /usr/lib/wasm32-wasi/libc.a /usr/lib/llvm-19/lib/clang/19/lib/wasi/libclang_rt.builtins-wasm32.a
WASM_LONG_DOUBLES := /usr/lib/wasm32-wasi/libc-printscan-long-double.a
# Difference between two runs, in words.
WATCHING := difference.c series.c source.c frame_fields.c
CLOSED_LOOP_SOURCES := $(wildcard site/*.c) $(BOX_SOURCES) app/control/lamps.c $(addprefix app/replay/verify/,replay.c field_name.c) $(addprefix app/replay/what_if/,difference.c) $(addprefix app/replay/data/,series.c source.c frame_fields.c) \
    $(addprefix app/recording/read/,recording_block.c) $(addprefix app/recording/format/,cycle_code.c cycle_words.c proof.c) $(GEN)/interface/app/fields.c $(AXIS_TERMS) $(DRIVE_TERMS) $(EVENT_TEXT) $(NAMES) $(FIND_ROBOT)

SITE_INCLUDES := $(BSP_INCLUDES) -I.
$(OUT)/site/%.o: FLAGS = $(SITE_INCLUDES)
$(OUT)/verification/site/%.o: FLAGS = $(SITE_INCLUDES)

wasm: bootstrap-site ## The core, its box, their server and the replay as WebAssembly: build/site/{robot,served,recorded}.wasm
	@$(MAKE) --no-print-directory -j2 CONFIG=wasm $(addprefix build/site/,robot.wasm served.wasm recorded.wasm)

# Parts of the console but its robot; as for the product.
PAGE := build/site/page/index.html
$(PAGE): build/site/served.wasm
$(PAGE): PAGE_BUILD := build-site
# The parts of it that show a recording, with the replay.
RECORDED_PAGE := build/site/page/replay.html
$(RECORDED_PAGE): build/site/recorded.wasm
$(RECORDED_PAGE): PAGE_BUILD := build-recorded
$(PAGE) $(RECORDED_PAGE): $(CONSOLE_SOURCES) $(GEN)/interface/.compiled $(DRAWINGS) $(GEN)/charts/charts.json \
    app/console/node_modules/.installed
	@tools/run_long build/log/page.log npm run --prefix app/console --silent $(PAGE_BUILD) || { cat build/log/page.log >&2; exit 1; }
	@echo "built $@, $$(gzip -9 -c $@ | wc -c) bytes compressed"

site: wasm ## Pages that need no server: the console with a robot in it, and one on which recordings are opened: build/site/page
	@$(MAKE) --no-print-directory CONFIG=wasm $(PAGE) $(RECORDED_PAGE)

# The same in native code, to be compared with it.
build/gcc/bin/closed-loop-scene: $(call object,$(CLOSED_LOOP_SOURCES) verification/site/scene.c) build/gcc/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) $(LDFLAGS) $^ -lm -o $@
	@echo "built $@"

# The server of the console before that robot. Code that waits, needs a clock, a file or chance finds it in site/served.
SERVED_ABSENT := $(addprefix app/http/handlers/,http_archive.c http_positions.c) $(addprefix app/http/call/,http_conversation.c http_download.c) $(addprefix app/http/server/,http_listen.c http_main.c asset.c) \
    $(addprefix app/http/stop/,gate.c stop_client.c stop_port.c) $(addprefix app/http/gate/,http_handover.c http_connections.c)
SERVED_SOURCES := $(wildcard site/served/*.c) site/closed_loop.c site/watch.c $(addprefix app/replay/what_if/,difference.c) $(addprefix app/replay/data/,series.c source.c frame_fields.c) $(EVENT_TEXT) $(GEN)/interface/app/fields.c $(BOX_SOURCES) app/control/lamps.c $(FIND_ROBOT) \
    $(filter-out $(SERVED_ABSENT),$(wildcard app/http/server/*.c app/http/handlers/*.c app/http/call/*.c app/http/pages/*.c app/http/view/*.c app/http/gate/*.c app/http/stop/*.c)) \
    $(wildcard app/request/*.c app/sweep/*.c app/trajectory/*.c) $(addprefix app/http/login/,account.c session_store.c session_table.c login_delay.c) \
    $(filter-out app/exchange/exchange_open.c,$(EXCHANGE)) $(API) $(HANDLERS) $(AXIS_TERMS) $(LIST_TERMS) $(DRIVE_TERMS) $(LOG_ENTRY) \
    $(GEN)/interface/app/messages.c $(NAMES) $(GEN)/assets/chart_names.c

# The same in native code, to be compared with it; there the C library has its own system.
$(OUT)/site/served/%.o $(OUT)/site/recorded/%.o: FLAGS = -D_GNU_SOURCE $(SITE_INCLUDES)
build/gcc/bin/served-ask: $(call object,$(filter-out %/no_system.c %/no_output.c,$(SERVED_SOURCES)) verification/site/ask.c) build/gcc/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) $(LDFLAGS) $^ -lcjson -lm -o $@
	@echo "built $@"

# The replay, without the files that it writes for others. Its file is in site/recorded; it decompresses by the product's own
# library and hashes by libmd, from Debian's sources.
RECORDED_SOURCES := $(wildcard site/recorded/*.c) site/served/no_system.c \
    $(addprefix app/replay/verify/,again.c build_fit.c coverage.c field_name.c replay.c walk.c) $(addprefix app/replay/data/,bytes.c frame_fields.c pace.c series.c tape.c) $(addprefix app/replay/export/,motion_json.c page_text.c) \
    $(filter-out %_writer.c,$(wildcard app/recording/format/*.c app/recording/read/*.c app/recording/write/recording_writer.c)) $(STATE_JSON) \
    $(addprefix $(GEN)/interface/app/,fields.c messages.c) $(GEN)/assets/chart_names.c $(AXIS_TERMS) $(DRIVE_TERMS) \
    app/common/utc_text.c $(EVENT_TEXT) $(NAMES) $(FIND_ROBOT)
ZSTD := $(DEBIAN_SOURCES)/libzstd/lib
ZSTD_SOURCES := $(addprefix $(ZSTD)/,$(addprefix common/,entropy_common.c error_private.c fse_decompress.c xxhash.c zstd_common.c) \
    $(addprefix decompress/,huf_decompress.c zstd_ddict.c zstd_decompress.c zstd_decompress_block.c))
LIBMD := $(DEBIAN_SOURCES)/libmd

ifeq ($(CONFIG),wasm)
define LINK_WASM
wasm-ld-19 --no-entry --strip-all --stack-first -z stack-size=262144 $(filter %.o,$^) $(1) $(WASM_LIBC) -o $@
	@wasm-opt -Oz --enable-sign-ext $@ -o $@
endef

build/site/robot.wasm: $(call object,$(CORE_SOURCES) $(CLOSED_LOOP_SOURCES)) site/site.mk
	@mkdir -p $(@D)
	@$(call LINK_WASM,$(WASM_LONG_DOUBLES))
	@echo "built $@"

# Headers of sockets, of which types are used, are of C11.
SERVED_FLAGS := -std=c11 -Isite/posix -isystem $(DEBIAN_SOURCES)/civetweb/include -isystem build/wasm/include -isystem $(ZSTD) -isystem $(LIBMD)/include
$(OUT)/app/%.o $(OUT)/$(GEN)/interface/%.o: CFLAGS += $(SERVED_FLAGS)
$(OUT)/site/served/%.o $(OUT)/site/recorded/%.o: CFLAGS += $(SERVED_FLAGS)
$(call object,$(SERVED_SOURCES)): site/site.mk | build/wasm/include/cjson/cJSON.h

build/wasm/include/cjson/cJSON.h: $(DEBIAN_SOURCES)/cjson/cJSON.h
	@mkdir -p $(@D); cp $< $@

$(OUT)/lib/cJSON.o: $(DEBIAN_SOURCES)/cjson/cJSON.c
	@mkdir -p $(@D)
	@$(COMPILER_CACHE) $(CC) $(EXTRA) $(ANYWHERE) -c $< -o $@

build/site/served.wasm: $(call object,$(CORE_SOURCES) $(SERVED_SOURCES)) $(OUT)/lib/cJSON.o site/site.mk
	@mkdir -p $(@D)
	@$(call LINK_WASM)
	@echo "built $@"

$(call object,$(RECORDED_SOURCES)): site/site.mk | build/wasm/include/cjson/cJSON.h

$(OUT)/lib/%.o: $(ZSTD)/%.c
	@mkdir -p $(@D)
	@$(COMPILER_CACHE) $(CC) $(EXTRA) $(ANYWHERE) -DZSTD_DISABLE_ASM -DZSTD_STRIP_ERROR_STRINGS -DHUF_FORCE_DECOMPRESS_X1 -c $< -o $@

# Its configuration as it is before a computer was asked for what it has: with nothing.
$(OUT)/lib/sha2.o: $(LIBMD)/src/sha2.c
	@mkdir -p $(@D) build/wasm/libmd; cp $(LIBMD)/config.h.in build/wasm/libmd/config.h
	@$(COMPILER_CACHE) $(CC) $(EXTRA) $(ANYWHERE) -Ibuild/wasm/libmd -I$(LIBMD)/include -c $< -o $@

build/site/recorded.wasm: $(call object,$(CORE_SOURCES) $(RECORDED_SOURCES)) $(ZSTD_SOURCES:$(ZSTD)/%.c=$(OUT)/lib/%.o) \
    $(addprefix $(OUT)/lib/,sha2.o cJSON.o) site/site.mk
	@mkdir -p $(@D)
	@$(LINK_WASM)
	@echo "built $@"
endif

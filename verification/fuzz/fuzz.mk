# SPDX-License-Identifier: Apache-2.0
# Any bytes and any scene against OpenIGTLink, any request against the HTTP server; included by the Makefile after supervise.mk.

.PHONY: fuzz fuzz-programs
FUZZ := build/fuzz
FUZZ_SEEDS := $(FUZZ)/seeds/.made
FUZZ_WORDS := $(GEN)/fuzz/words.h
FUZZ_CC := clang-19
# Fuzzed code counts its branches and is watched; the controller and the box only play along, and are quick.
FUZZ_FLAGS := $(WARNINGS) -ffp-contract=off -O2 -g -D_GNU_SOURCE $(TEST_INCLUDES) -I$(UNITY) -fno-sanitize-recover=all
FUZZ_WATCHED := -fsanitize=fuzzer-no-link,address,undefined
FUZZED := $(wildcard app/igtl/wire/*.c app/igtl/dialect/*.c app/igtl/workphase/*.c app/igtl/lists/*.c) $(AXIS_TERMS) $(LIST_TERMS) $(IGTL_TABLES)
FUZZ_TARGETS := codec dialect ports request
FUZZ_PROGRAMS := $(FUZZ_TARGETS:%=$(FUZZ)/bin/%)
FUZZ_DIALECT := $(filter-out %codec_fuzz.c %ports_fuzz.c %request_fuzz.c,$(wildcard verification/fuzz/*.c))
fuzz_object = $(patsubst %.c,$(FUZZ)/%.o,$(1))

$(FUZZ_WORDS): verification/fuzz/words.yml tools/fuzz/scenes.rb
	@ruby tools/fuzz/scenes.rb words $< $@

$(FUZZ_SEEDS): verification/fuzz/words.yml verification/fuzz/scenes.yml tools/fuzz/scenes.rb
	@rm -rf $(@D); ruby tools/fuzz/scenes.rb seeds verification/fuzz/words.yml verification/fuzz/scenes.yml $(@D)
	@touch $@

$(FUZZ)/%.o: %.c $(FUZZ_WORDS) | $(GENERATED)
	@mkdir -p $(@D)
	@$(COMPILER_CACHE) $(FUZZ_CC) $(FUZZ_FLAGS) $(FUZZ_WATCH) -MMD -MP -c $< -o $@

$(FUZZ)/app/%.o $(FUZZ)/verification/fuzz/codec_fuzz.o $(FUZZ)/verification/fuzz/ports_fuzz.o $(FUZZ)/verification/fuzz/request_fuzz.o: FUZZ_WATCH = $(FUZZ_WATCHED)
# The words of the scenes contain the values of comparisons; to trace it would take half of the time.
$(FUZZ)/app/igtl/dialect/%.o $(FUZZ)/app/igtl/workphase/%.o $(FUZZ)/app/igtl/lists/%.o: FUZZ_WATCH = $(FUZZ_WATCHED) -fno-sanitize-coverage=trace-cmp

$(FUZZ)/bin/codec: $(call fuzz_object,verification/fuzz/codec_fuzz.c $(wildcard app/igtl/wire/*.c))
	@mkdir -p $(@D)
	@$(FUZZ_CC) -fsanitize=fuzzer,address,undefined $^ -o $@
	@echo "built $@"

$(FUZZ)/bin/ports: $(call fuzz_object,verification/fuzz/ports_fuzz.c $(wildcard app/igtl/server/igtl_ports*.c))
	@mkdir -p $(@D)
	@$(FUZZ_CC) -fsanitize=fuzzer,address,undefined $^ -o $@
	@echo "built $@"

$(FUZZ)/bin/request: $(call fuzz_object,verification/fuzz/request_fuzz.c $(wildcard app/request/*.c) app/http/view/telemetry_units.c $(AXIS_TERMS) $(API))
	@mkdir -p $(@D)
	@$(FUZZ_CC) -fsanitize=fuzzer,address,undefined $^ -lm -o $@
	@echo "built $@"

$(FUZZ)/bin/dialect: $(call fuzz_object,$(FUZZ_DIALECT) $(FUZZED)) \
    $(call object,verification/integration/support/rig.c verification/supervise/watch/authority_oracle.c $(wildcard verification/oracle/*.c) $(BOX_SOURCES) $(NAMES) $(ANSWER_LIST)) build/gcc/libcore.a
	@mkdir -p $(@D)
	@$(FUZZ_CC) -fsanitize=fuzzer,address,undefined -I$(UNITY) $^ $(UNITY)/unity.c -lm -o $@
	@echo "built $@"

fuzz-programs: $(FUZZ_PROGRAMS) $(FUZZ_SEEDS)

fuzz: bootstrap-test ## Look for inputs that break OpenIGTLink or HTTP, MINUTES=5 long; what is found is kept in build/fuzz/found
	@$(MAKE) --no-print-directory -j2 fuzz-programs
	@ruby tools/fuzz.rb $(FUZZ) $(or $(MINUTES),5)

# Damaged messages that our codec accepts, against the standard's own library.
$(BIN)/decode-differ: verification/fuzz/decode_differ.cpp $(CODEC)
	@mkdir -p $(BIN)
	g++ -std=c++14 -Wall -O1 -Iapp -isystem /usr/include/openigtlink $^ -lOpenIGTLink -lpthread -o $@

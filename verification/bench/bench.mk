# SPDX-License-Identifier: Apache-2.0
# Cost of a cycle, and punctuality of its begin; included by the Makefile.

.PHONY: bench rt-report bench-clients bench-codec bench-crowds bench-instructions bench-latency bench-recordings bench-programs cost-programs cost cost-approve bound bound-approve

# The scene is played on the rig of the integration tests, which asserts with Unity.
BENCH_SCENE := $(call object,verification/bench/samples.c verification/bench/sample.c verification/integration/support/rig.c $(BOX_SOURCES) \
    $(NAMES) $(ANSWER_LIST) $(FIND_ROBOT))
build/gcc/bin/bench-samples: $(BENCH_SCENE) build/gcc/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) -I$(UNITY) $^ $(UNITY)/unity.c -lm -o $@
	@echo "built $@"

BENCH_RECORDINGS := $(call object,verification/bench/recordings.c verification/integration/support/rig.c \
    verification/integration/support/recorded.c $(BOX_SOURCES) $(wildcard app/recording/format/*.c app/recording/read/*.c app/recording/write/recording_writer.c) $(ANSWER_LIST) $(FIND_ROBOT))
build/gcc/bin/bench-recordings: $(BENCH_RECORDINGS) build/gcc/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) -I$(UNITY) $^ $(UNITY)/unity.c $(LIBS_boresight-recorder) -lm -o $@
	@echo "built $@"
$(OUT)/verification/bench/%.o: FLAGS = -D_GNU_SOURCE $(TEST_INCLUDES) -I$(UNITY)

# Our codec beside the standard's own library.
build/gcc/bin/bench-codec: verification/bench/codec.cpp $(CODEC)
	@mkdir -p $(@D)
	@g++ -std=c++14 -Wall -O2 -g -Iapp -isystem /usr/include/openigtlink $^ -lOpenIGTLink -lpthread -o $@
	@echo "built $@"

SOURCES_bench-step := verification/bench/step.c verification/bench/sample.c $(FIND_ROBOT)
$(eval $(call program,bench-step))

build/gcc/bin/bench-clients: $(call object,verification/bench/clients.c app/igtl/wire/igtl_inbox.c) $(CODEC)
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) $^ -o $@
	@echo "built $@"

build/gcc/bin/bench-crowd: $(call object,verification/bench/crowd.c)
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) $^ -o $@
	@echo "built $@"

bench-programs: bootstrap-test cost-programs
	@$(MAKE) --no-print-directory -j2 $(BINARIES) $(BIN)/boresight-client build/gcc/bin/bench-step \
	    build/gcc/bin/bench-recordings build/gcc/bin/bench-clients build/gcc/bin/bench-crowd

# Needs of the gate, without those of the latency.
cost-programs:
	@$(MAKE) --no-print-directory -j2 build/gcc/bin/bench-samples build/gcc/bin/bench-codec
	@$(MAKE) --no-print-directory -j2 CONFIG=arm build/arm/bin/bench-step

cost: bootstrap-test cost-programs ## What a cycle costs as Cortex-A9 code, in instructions
	@ruby verification/bench/cost.rb

cost-approve: cost
	@cp build/bench/cost.yml verification/bench/cost.yml

bound: bootstrap-test cost-programs ## What a cycle needs at most as Cortex-A9 code, in instructions, from its flow graph and the bounds of its loops
	@ruby verification/bound/bound.rb

bound-approve: bound
	@cp build/bound/bound.yml verification/bound/bound.yml

bench: bench-programs ## Instructions of a cycle, recordings, OpenIGTLink beside its library and under load, crowds at the HTTP server, wake-up latency beside cyclictest (BENCH_SECONDS=10)
	@ruby verification/bench/bench.rb

rt-report: bootstrap-test ## How punctual the loop is for an hour in real time: figures 20 to 23 of the thesis (HOURS=1 or MINUTES=2, PICTURE=file.svg)
	@$(MAKE) --no-print-directory -j2 $(BINARIES) $(BIN)/boresight-client build/gcc/bin/bench-crowd
	@HOURS=$(HOURS) MINUTES=$(MINUTES) PICTURE=$(PICTURE) ruby verification/bench/rt_report.rb

bench-instructions: bench-programs
	@ruby verification/bench/bench.rb instructions

bench-codec: build/gcc/bin/bench-codec
	@ruby verification/bench/bench.rb codec

bench-latency: bench-programs
	@ruby verification/bench/bench.rb latency

bench-recordings: build/gcc/bin/bench-recordings
	@ruby verification/bench/bench.rb recordings

bench-clients: bench-programs
	@ruby verification/bench/bench.rb clients

bench-crowds: bench-programs
	@ruby verification/bench/bench.rb crowds

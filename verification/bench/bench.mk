# SPDX-License-Identifier: Apache-2.0
# What a cycle costs, and how punctually it begins; included by the Makefile.

.PHONY: bench bench-instructions bench-latency bench-programs

SOURCES_bench-samples := verification/bench/samples.c app/replay/replay.c app/recorder/recording.c \
    app/recorder/recording_reader.c $(GEN)/names/names.c
LIBS_bench-samples := -lzstd -lcrypto
SOURCES_bench-step := verification/bench/step.c
$(foreach p,bench-samples bench-step,$(eval $(call program,$(p))))

bench-programs: bootstrap-test
	@$(MAKE) --no-print-directory -j2 $(BINARIES) $(BIN)/boresight-client \
	    build/gcc/bin/bench-samples build/gcc/bin/bench-step
	@$(MAKE) --no-print-directory -j2 CONFIG=arm build/arm/bin/bench-step

bench: bench-programs ## Instructions of a cycle; wake-up latency beside cyclictest (BENCH_SECONDS=10)
	@ruby verification/bench/bench.rb

bench-instructions: bench-programs
	@ruby verification/bench/bench.rb instructions

bench-latency: bench-programs
	@ruby verification/bench/bench.rb latency

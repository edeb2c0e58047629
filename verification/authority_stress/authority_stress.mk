# SPDX-License-Identifier: Apache-2.0
# Pages and connections of a running system that compete for authority; included by the Makefile.

.PHONY: authority-stress

build/gcc/bin/authority-stress-oracle: $(call object,$(wildcard verification/authority_stress/*.c verification/oracle/*.c app/recording/format/*.c app/recording/read/*.c app/recording/write/recording_writer.c) \
    app/replay/verify/replay.c app/replay/verify/field_name.c $(GEN)/interface/app/fields.c $(GEN)/interface/app/event_words.c $(NAMES) $(FIND_ROBOT)) build/gcc/libcore.a
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) $^ $(LIBS_boresight-replay) -lm -o $@
	@echo "built $@"

authority-stress: build build/gcc/bin/authority-stress-oracle ## Pages and connections fight for authority, MINUTES=5 long; the recording of a broken rule is kept
	@ruby verification/authority_stress/authority_stress.rb $(or $(MINUTES),5)

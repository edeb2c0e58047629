# SPDX-License-Identifier: Apache-2.0
# Boresight as Cortex-A9 code; included by the Makefile.

.PHONY: arm-programs arm-machine arm-system

arm-programs: bootstrap-test ## All programs for Cortex-A9, static: build/arm/bin; of other boards: build/boards/arm-NAME/bin
	@$(MAKE) --no-print-directory -j2 CONFIG=arm $(PROGRAMS:%=build/arm/bin/%)
	@for board in $(STATIC_BOARDS); do \
	    $(MAKE) --no-print-directory -j2 CONFIG=arm BOARD=$$board APART=build/boards/arm-$$board apart; done

arm-machine: arm-programs
	@$(MAKE) --no-print-directory CONFIG=arm build/arm/verification/arm/cards-on-spi

arm-system: bootstrap-test ## The whole system on an emulated Cortex-A9 with Debian's real-time kernel
	@ruby verification/arm/test_arm_system.rb -v

# Device of the emulated machine in place of a control box on SPI.
CARDS_ON_SPI := $(OUT)/verification/arm/cards-on-spi
$(CARDS_ON_SPI): $(call object,verification/arm/cards_on_spi.c bsp/sim/bsp_sim.c bsp/sim/wire.c $(NO_LOOKUP)) $(OUT)/libcore.a
	@$(CC) $(CFLAGS) $(LDFLAGS) $(filter %.o %.a,$^) -lfuse3 -lpthread -lrt -lm -o $@
	@echo "built $@"

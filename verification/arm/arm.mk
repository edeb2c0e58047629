# SPDX-License-Identifier: Apache-2.0
# Boresight as Cortex-A9 code; included by the Makefile.

.PHONY: arm-programs

arm-programs: bootstrap-test ## All programs for Cortex-A9, static: build/arm/bin
	@$(MAKE) --no-print-directory -j2 CONFIG=arm $(PROGRAMS:%=build/arm/bin/%)

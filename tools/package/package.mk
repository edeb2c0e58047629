# SPDX-License-Identifier: Apache-2.0
# Packages; included by the Makefile.

.PHONY: package static-programs

package: bootstrap-test ## Packages of Debian and NI Linux RT, for x86-64 and Cortex-A9: build/package
	@$(MAKE) --no-print-directory -j2 $(BINARIES)
	@$(MAKE) --no-print-directory -j2 boards
	@$(MAKE) --no-print-directory arm-programs static-programs
	@ruby tools/package.rb

static-programs: # As arm-programs, for x86-64.
	@$(MAKE) --no-print-directory -j2 CONFIG=static $(PROGRAMS:%=build/static/bin/%)
	@for board in $(STATIC_BOARDS); do \
	    $(MAKE) --no-print-directory -j2 CONFIG=static BOARD=$$board APART=build/boards/static-$$board apart; done

# Flags that programs for x86-64 are compiled with, for the test that no folder is revealed.
.PHONY: flags-of-programs
flags-of-programs:
	@echo '$(CFLAGS)'

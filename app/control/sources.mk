# SPDX-License-Identifier: Apache-2.0
# Sources that this program is linked from, beside libcore.a; included by the Makefile.

SOURCES_boresight-control := $(wildcard app/check/*.c app/control/*.c app/positions/*.c app/trajectory/*.c) $(CLOCK) \
    $(AXIS_TERMS) $(EXCHANGE) $(BOARD_SOURCES) $(FIND_ROBOT) $(NAMES)
LIBS_boresight-control := $(BOARD_LIBS)

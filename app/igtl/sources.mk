# SPDX-License-Identifier: Apache-2.0
# Sources that this program is linked from, beside libcore.a; included by the Makefile.

SOURCES_boresight-igtl := $(wildcard app/igtl/server/*.c app/igtl/dialect/*.c app/igtl/workphase/*.c \
    app/igtl/lists/*.c app/igtl/wire/*.c) $(CLOCK) $(AXIS_TERMS) $(LIST_TERMS) $(EXCHANGE) $(NAMES) $(IGTL_TABLES)

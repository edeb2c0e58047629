# SPDX-License-Identifier: Apache-2.0
# Sources that this program is linked from, beside libcore.a; included by the Makefile.

SOURCES_boresight-recorder := $(wildcard app/recording/write/*.c app/recording/format/*.c app/recording/read/*.c \
    app/positions/*.c) app/sweep/sweep_curve.c $(CLOCK) app/common/directory.c app/common/file_series.c $(LOG_ENTRY) \
    $(AXIS_TERMS) $(EXCHANGE) $(NAMES)
LIBS_boresight-recorder := -lzstd -lcrypto -lm

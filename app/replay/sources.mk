# SPDX-License-Identifier: Apache-2.0
# Sources that this program is linked from, beside libcore.a; included by the Makefile.

SOURCES_boresight-replay := $(wildcard app/replay/*.c app/replay/*/*.c app/recording/format/*.c \
    app/recording/read/*.c app/recording/write/recording_writer.c) $(STATE_JSON) $(CLOCK) $(addprefix \
    $(GEN)/interface/app/,columns.c fields.c messages.c) $(GEN)/assets/recording_page.c $(GEN)/assets/chart_names.c \
    $(AXIS_TERMS) $(DRIVE_TERMS) app/common/file_series.c app/common/utc_text.c $(EVENT_TEXT) $(NAMES) $(FIND_ROBOT)
LIBS_boresight-replay := -lzstd -lcrypto -lcjson

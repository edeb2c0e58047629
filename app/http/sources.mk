# SPDX-License-Identifier: Apache-2.0
# Sources that this program is linked from, beside libcore.a; included by the Makefile.

SOURCES_boresight-http := $(wildcard app/http/server/*.c app/http/handlers/*.c app/http/call/*.c app/http/pages/*.c \
    app/http/view/*.c app/http/gate/*.c app/http/stop/*.c app/recording/archive/*.c app/request/*.c app/saved/*.c \
    app/http/login/*.c app/sweep/*.c app/trajectory/*.c) app/positions/position_record.c \
    app/recording/format/recording.c app/common/file_series.c $(API) $(HANDLERS) $(CLOCK) \
    $(AXIS_TERMS) $(LIST_TERMS) $(DRIVE_TERMS) $(GEN)/interface/app/messages.c $(LOG_ENTRY) $(EXCHANGE) $(NAMES) \
    $(GEN)/assets/assets.c $(GEN)/assets/chart_names.c $(BENCH)
LIBS_boresight-http := -lcivetweb -lcjson -lcrypt -lcrypto -lpthread

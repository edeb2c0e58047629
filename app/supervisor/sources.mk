# SPDX-License-Identifier: Apache-2.0
# Sources that this program is linked from, beside libcore.a; included by the Makefile.

SOURCES_boresight := $(wildcard app/check/*.c app/supervisor/*.c app/igtl/server/igtl_ports*.c) $(CLOCK) \
    app/common/config_file.c app/common/directory.c $(EXCHANGE) $(NAMES) $(GEN)/robot/app/robot_names.c \
    $(BOARD_TABLE)

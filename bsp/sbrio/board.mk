# SPDX-License-Identifier: Apache-2.0
# A control box behind Linux' own SPI and GPIO; included by the Makefile.

# Sources and libraries of control.
BOARD_SOURCES := $(wildcard bsp/sbrio/*.c)
BOARD_LIBS := -lgpiod -lpthread
BOARD_PACKAGES := libgpiod-dev

# SPDX-License-Identifier: Apache-2.0
# A control box behind Linux' own SPI and GPIO; included by the Makefile.

# What control is linked with.
BOARD_SOURCES := $(wildcard bsp/sbrio/*.c)
BOARD_LIBS := -lgpiod -lpthread
BOARD_PACKAGES := libgpiod-dev

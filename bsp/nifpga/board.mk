# SPDX-License-Identifier: Apache-2.0
# The thesis' own control box, whose cards are behind NI's FPGA; included by the Makefile.

# Sources and libraries of control. NI's library is loaded when the box is opened.
BOARD_SOURCES := $(wildcard bsp/nifpga/*.c)
BOARD_LIBS := -ldl

# SPDX-License-Identifier: Apache-2.0
# A board of which there is no more than a lamp; test_added_board.rb adds it to a copy of the project.
BOARD_SOURCES := bsp/lamp/bsp_lamp.c
BOARD_PROGRAMS := boresight-lamp
SOURCES_boresight-lamp := bsp/lamp/lamp_main.c

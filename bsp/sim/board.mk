# SPDX-License-Identifier: Apache-2.0
# The simulated control box; included by the Makefile.

# Sources of control.
BOARD_SOURCES := bsp/sim/bsp_sim.c bsp/sim/wire.c

# Sources of http, for the orders that it may give.
BOARD_BENCH := bsp/sim/bench_sim.c bsp/sim/bench_levels.c bsp/sim/wire.c

# Control's box is another process, and simctl gives it orders.
BOARD_PROGRAMS := boresight-box boresight-simctl
BOARD_BOX := $(filter-out %_main.c bsp/sim/bsp_sim.c bsp/sim/bench_sim.c,$(wildcard bsp/sim/*.c bsp/sim/model/*.c bsp/sim/orders/*.c))
SOURCES_boresight-box := $(BOARD_BOX) bsp/sim/box_main.c $(FIND_ROBOT)
SOURCES_boresight-simctl := $(BOARD_BOX) bsp/sim/simctl_main.c

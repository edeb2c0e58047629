/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is seen at the box of its inputs and lamps. */
#ifndef BORESIGHT_SIM_BENCH_LEVELS_H
#define BORESIGHT_SIM_BENCH_LEVELS_H

#include "bsp_bench.h"

/** Writes what these BSP_IN_ and BSP_LAMP_ bits show to `seen`, and nothing else of it. */
void bench_levels_see(uint32_t inputs, uint32_t lamps, bsp_bench_t *seen);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file A board that takes no orders. */
#include "bsp_bench.h"

bool bsp_bench_is_offered(void)
{
    return false;
}

bool bsp_bench_look(const char *name, bsp_bench_t *seen)
{
    (void)name;
    (void)seen;
    return false;
}

bsp_bench_result_t bsp_bench_order(const char *name, const char *order)
{
    (void)name;
    (void)order;
    return BSP_BENCH_SILENT;
}

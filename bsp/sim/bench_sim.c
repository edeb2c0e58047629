/* SPDX-License-Identifier: Apache-2.0 */
/** @file Orders to the simulated control box: bsp_bench.h at its wire, taken for one order each. */
#include "bsp_bench.h"

#include "sim/bench_levels.h"
#include "sim/wire.h"

#define ANSWER_TIMEOUT_US 1000000U

bool bsp_bench_is_offered(void)
{
    return true;
}

bool bsp_bench_look(const char *name, bsp_bench_t *seen)
{
    wire_port_t port;
    char error[256];

    if (!wire_attach(&port, name, WIRE_END_NONE, error, sizeof error)) {
        return false;
    }
    const bool is_whole = wire_see_bench(port.wire, seen);
    bench_levels_see(wire_load(&port.wire->inputs), wire_load(&port.wire->lamps), seen);
    wire_close(&port, WIRE_END_NONE);
    return is_whole;
}

bsp_bench_result_t bsp_bench_order(const char *name, const char *order)
{
    wire_port_t port;
    char error[256];

    if (!wire_attach(&port, name, WIRE_END_ORDERS, error, sizeof error)) {
        return BSP_BENCH_SILENT;
    }
    const bool is_answered = wire_give_order(port.wire, order, ANSWER_TIMEOUT_US);
    const bool is_done = is_answered && (port.wire->order_done != 0U);
    wire_close(&port, WIRE_END_ORDERS);
    if (!is_answered) {
        return BSP_BENCH_SILENT;
    }
    return is_done ? BSP_BENCH_DONE : BSP_BENCH_REFUSED;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "site/served/served_robot.h"

#include "bsp_bench.h"
#include "common/clock.h"
#include "exchange/exchange_rows.h"
#include "limits/requirement_limits.h"
#include "sim/bench_levels.h"
#include "site/served/journal.h"
#include "site/watch.h"

#include <stddef.h>
#include <sys/random.h>

#define FIGURES_US UINT64_C(1000000)

static closed_loop_t loop;
static exchange_t *exchange;
static uint64_t began_utc_us;
static uint64_t chance; /* Never 0. */

/* Always punctual: time does not pass but by cycles. */
static void publish_figures(void)
{
    const loop_figures_t figures = {.slowness = 1U, .speedup = 1U, .speed_permille = 1000U};
    exchange_publish_loop(exchange, &figures);
}

exchange_t *served_robot_start(const robot_t *robot, uint32_t seed, uint64_t utc_us)
{
    char error[64];

    chance = ((uint64_t)seed << 1U) | 1U;
    began_utc_us = utc_us;
    exchange = exchange_create(SERVED_ROBOT_BOX, 0U, error, (uint32_t)sizeof error);
    exchange_publish_robot(exchange, robot);
    closed_loop_init(&loop, robot, seed);
    exchange_publish_rows(exchange, &loop.controller, &loop.outputs);
    publish_figures();
    journal_begin();
    return exchange;
}

bool served_robot_is_started(void)
{
    return loop.robot != NULL;
}

const closed_loop_t *watch_loop(void)
{
    return &loop;
}

bool served_robot_order(const char *order, char *reply, uint32_t size)
{
    return box_command(&loop.box, order, reply, size);
}

command_t *served_robot_command(void)
{
    return closed_loop_command(&loop);
}

static void publish(void)
{
    const controller_outputs_t *const outputs = &loop.outputs;

    exchange_publish_snapshot(exchange, &outputs->snapshot);
    exchange_publish_rows(exchange, &loop.controller, outputs);
    for (uint32_t i = 0U; i < outputs->event_count; i++) {
        exchange_push_event(exchange, &outputs->events[i], clock_utc_us());
    }
    for (uint32_t i = 0U; i < outputs->answer_count; i++) {
        (void)exchange_push_answer(exchange, &outputs->answers[i]);
    }
    if ((loop.time_us % FIGURES_US) == 0U) {
        publish_figures();
    }
    exchange_beat(exchange, EXCHANGE_CONTROL);
}

static uint32_t cycles(void)
{
    return (uint32_t)(loop.time_us / LIMIT_CYCLE_US);
}

void served_robot_step(void)
{
    const uint32_t first = loop.command_count;

    loop.command_count +=
        exchange_take_commands(exchange, &loop.commands[first], CONTROLLER_COMMANDS - first);
    for (uint32_t i = first; i < loop.command_count; i++) {
        journal_note_command(cycles(), &loop.commands[i]);
    }
    closed_loop_step(&loop);
    publish();
}

uint64_t served_robot_time_us(void)
{
    return loop.time_us;
}

uint64_t clock_monotonic_us(void)
{
    return loop.time_us;
}

uint64_t clock_utc_us(void)
{
    return began_utc_us + loop.time_us;
}

/* xorshift64 */
ssize_t getrandom(void *bytes, size_t size, unsigned flags)
{
    uint8_t *const all = bytes;

    (void)flags;
    for (size_t i = 0U; i < size; i++) {
        chance ^= chance << 13U;
        chance ^= chance >> 7U;
        chance ^= chance << 17U;
        all[i] = (uint8_t)(chance >> 32U);
    }
    return (ssize_t)size;
}

bool bsp_bench_is_offered(void)
{
    return true;
}

bool bsp_bench_look(const char *name, bsp_bench_t *seen)
{
    (void)name;
    box_show(&loop.box, seen);
    bench_levels_see(box_inputs(&loop.box), loop.box.lamps, seen);
    return true;
}

bsp_bench_result_t bsp_bench_order(const char *name, const char *order)
{
    char reply[BOX_REPLY_SIZE];

    (void)name;
    if (!box_command(&loop.box, order, reply, sizeof reply)) {
        return BSP_BENCH_REFUSED;
    }
    journal_note_order(cycles(), order);
    return BSP_BENCH_DONE;
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The clock of the simulated box: how far its world goes on each time the box looks around. In real
 * time it follows the world's clock. In elastic time it goes on when control asks for an exchange,
 * just as far as control has come; control keeps the pace, which may be fast. Left alone for
 * LIMIT_ELASTIC_ANSWER_CLOCK_US it goes on by itself, so that the cards notice that control is
 * stuck or gone; control that waits sends it a sign of that. No I/O; the world's time is handed in.
 */
#ifndef BORESIGHT_BOX_CLOCK_H
#define BORESIGHT_BOX_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

/** The box looks around at least this often. */
#define BOX_CLOCK_LOOK_US 1500U
/** And in real time so often, as a real one samples its inputs when it is asked for them; in its
 * own time. */
#define BOX_CLOCK_SAMPLE_US 250U
/** The furthest that its world goes on at once in elastic time: a pause of the machine pauses the
 * world, too. */
#define BOX_CLOCK_STRIDE_US 2000U

/** Pace of the box's time beside the world's. */
typedef struct {
    bool is_elastic;   /**< It waits for control. */
    uint32_t slowness; /**< It passes so many times slower, at best. */
    uint32_t speedup;  /**< It passes up to so many times faster; 1 unless it is elastic. */
} box_time_t;

/** State of the clock. */
typedef struct {
    box_time_t time;
    uint64_t now_us;       /**< The box's time. */
    uint64_t looked_us;    /**< World time of the last look. */
    uint32_t lonely_looks; /**< Looks in a row without a request. */
} box_clock_t;

/** Starts at `now_us`, except in real time, which is the world's divided by the slowness. */
void box_clock_init(box_clock_t *self, box_time_t time, uint64_t now_us, uint64_t world_us);

/**
 * The box looks around at `world_us`. `wanted_us`: the box's time of the exchange that control asks
 * for, NULL when it asks for none.
 *
 * @return how far the world goes on, 0..BOX_CLOCK_STRIDE_US, in real time 0..LIMIT_BOX_LEAP_US
 *
 * @satisfies SWR-BOX-005
 * @satisfies SWR-BOX-006
 * @satisfies SWR-BOX-007
 * @satisfies SWR-BOX-048
 */
uint32_t box_clock_look(box_clock_t *self, const uint64_t *wanted_us, uint64_t world_us);

/**
 * Control lives, and waits before it asks for anything.
 *
 * @satisfies SWR-BOX-007
 */
void box_clock_hear(box_clock_t *self);

#endif

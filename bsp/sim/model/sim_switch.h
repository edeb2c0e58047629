/* SPDX-License-Identifier: Apache-2.0 */
/** @file A limit switch: a contact that operates at one place, releases a little beside it, and
 * bounces. */
#ifndef BORESIGHT_SIM_SWITCH_H
#define BORESIGHT_SIM_SWITCH_H

#include "robot/robot.h"
#include "sim/model/sim_random.h"

#include <stdbool.h>
#include <stdint.h>

#define SIM_SWITCH_HYSTERESIS_NM 100000U   /**< Way back until it releases, linear axes. */
#define SIM_SWITCH_HYSTERESIS_BAM 5000000U /**< The same of turning axes: 0.42 degrees. */
#define SIM_SWITCH_BOUNCE_MINIMUM_US 1000U
#define SIM_SWITCH_BOUNCE_MAXIMUM_US 5000U

#define SIM_SWITCH_CHATTER_MINIMUM_US 5000U
#define SIM_SWITCH_CHATTER_MAXIMUM_US 30000U

typedef enum {
    SIM_SWITCH_NORMAL = 0,
    SIM_SWITCH_STUCK = 1,   /**< Active for good. */
    SIM_SWITCH_OPEN = 2,    /**< Its wire is cut: never active. */
    SIM_SWITCH_CHATTER = 3, /**< A loose wire: changes by itself, too slowly for the debouncing. */
    SIM_SWITCH_REVERSED = 4 /**< Active where it should be free, and free where it should not. */
} sim_switch_fault_t;

/** State of one switch. */
typedef struct {
    sim_random_t random;
    limit_switch_t end;   /**< End that it guards; LIMIT_SWITCH_NONE never operates. */
    double operate_ticks; /**< Active from here outwards. */
    double hysteresis_ticks;
    sim_switch_fault_t fault;
    bool is_operated;    /**< The mechanism, without bounce. */
    bool is_closed;      /**< The contact, with bounce. */
    bool is_active;      /**< Its state as the card sees it. */
    uint32_t bounce_us;  /**< Time that the contact will still bounce. */
    uint32_t chatter_us; /**< Time that a loose wire will stay as it is. */
} sim_switch_t;

/** A settled switch of an axis that stands at `position_ticks`; it operates at the axis' home
 * position. */
void sim_switch_init(sim_switch_t *self, const axis_config_t *axis, double position_ticks,
                     uint32_t seed);

/**
 * Advances by SIM_STEP_US with the axis at `position_ticks`.
 *
 * @satisfies SWR-BOX-004
 */
void sim_switch_step(sim_switch_t *self, double position_ticks);

/** True if no step changes it while the axis stands at `position_ticks`. */
bool sim_switch_is_settled(const sim_switch_t *self, double position_ticks);

#endif

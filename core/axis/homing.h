/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The way of homing by switch: where the present leg goes, and where the edges of the switch must
 * be. The legs are the states of homing in statecharts/axis.scxml: leave (the axis stands on its
 * switch), approach, back_off, latch. The axis owns one. "Away" is the direction from the switch
 * into the travel, for the needle forwards.
 */
#ifndef BORESIGHT_HOMING_H
#define BORESIGHT_HOMING_H

#include "charts/axis_chart.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Sight of the switch in a cycle of homing. */
typedef enum {
    HOMING_NOTHING = 0,
    HOMING_SWITCH = 1, /**< The switch is active. */
    HOMING_CLEAR = 2,  /**< The switch is free, and so far away that the axis may turn. */
    HOMING_WRONG = 3   /**< The switch is active where it must be free. */
} homing_sight_t;

typedef struct {
    int64_t setpoint_q8; /**< Ticks. */
    int32_t speed_ticks_per_s_q8;
    int32_t start_ticks; /**< Start of this homing, or of that of the axis it follows. */
    /** Nearest place to the switch in all homing since the last reference. */
    int32_t nearest_ticks;
    int32_t edge_ticks;   /**< Position at which the approach met the switch. */
    int32_t switch_ticks; /**< Last position with an active switch. */
    uint32_t leg;         /**< axis_reference_t of the last cycle. */
    uint32_t ramp;        /**< Leg that the speed belongs to; AXIS_REFERENCE_FRESH: none. */
    uint32_t leg_us;      /**< Driven time of this leg. */
    uint32_t has_nearest; /**< 0 or 1. */
} homing_t;

/** `leg` is one of homing. */
static inline bool homing_is_leg(axis_reference_t leg)
{
    return (leg == AXIS_REFERENCE_APPROACH) || (leg == AXIS_REFERENCE_LATCH) ||
           (leg == AXIS_REFERENCE_LEAVE) || (leg == AXIS_REFERENCE_BACK_OFF);
}

/** @return how far `to` is away from `from`, ticks; grows away from the switch */
static inline int64_t homing_way(const axis_config_t *config, int32_t from, int32_t to)
{
    const int64_t way = (int64_t)to - (int64_t)from;
    return (config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER) ? -way : way;
}

/** @return how far `position_ticks` is away from the switch of a homed axis, ticks; below 0 beyond
 * its edge */
static inline int64_t homing_way_from_switch(const axis_config_t *config, int32_t position_ticks)
{
    return homing_way(config, config->home_ticks, position_ticks);
}

/** Homing begins at `position_ticks`. The way that earlier attempts used is not given back. */
void homing_begin(homing_t *self, int32_t position_ticks);

/** The leg goes on in other company, at another speed: its time counts from here on. */
void homing_renew(homing_t *self);

/** The approach has met the switch since the report at which it stood at `free_ticks`: its edge is
 * there, if that is as near as the motor goes while a switch is debounced, however late it was
 * seen.
 *
 * @satisfies SWR-AXIS-048
 */
void homing_meet(homing_t *self, const axis_config_t *config, int32_t free_ticks);

/** The axis is homed, or its counts have broken: the next homing has its whole way. */
void homing_forget(homing_t *self);

/**
 * Takes this cycle's position and switch in leg `leg`.
 *
 * @return HOMING_WRONG when the switch is active in the latch leg elsewhere than the approach met
 * it, else HOMING_SWITCH when it is active, HOMING_CLEAR when it is free and surely left behind,
 * HOMING_NOTHING when it is free
 *
 * @satisfies SWR-AXIS-014
 */
homing_sight_t homing_see(homing_t *self, const axis_config_t *config, axis_reference_t leg,
                          int32_t position_ticks, bool is_switch_active);

/**
 * @return true when the leg has gone farther than the switch can be: away from it `home_way_ticks`,
 * counted over all attempts; towards it the travel, a thirty-second of it and as much; at last
 * beyond the place of the first edge. `leg` is one of homing
 *
 * @satisfies SWR-AXIS-013
 */
bool homing_is_too_far(const homing_t *self, const axis_config_t *config, axis_reference_t leg,
                       int32_t position_ticks);

/**
 * To be called once a cycle.
 *
 * @return true when the leg was driven for `home_time_us`
 *
 * @satisfies SWR-AXIS-003
 */
static inline bool homing_is_too_long(homing_t *self, const axis_config_t *config,
                                      axis_reference_t leg, bool is_driven, uint32_t elapsed_us)
{
    if (self->leg != (uint32_t)leg) {
        self->leg = (uint32_t)leg;
        self->leg_us = 0U;
    }
    if (!is_driven || !homing_is_leg(leg)) {
        return false;
    }
    self->leg_us += elapsed_us;
    return self->leg_us >= config->home_time_us;
}

/** Advances set-point and speed of `leg` by one cycle; a new leg begins at the position, at rest.
 */
void homing_step(homing_t *self, const axis_config_t *config, axis_reference_t leg,
                 int32_t position_ticks);

/** Nothing is driven: the next homing_step() begins at the position, at rest. */
void homing_rest(homing_t *self);

#endif

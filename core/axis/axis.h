/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * One robot axis: its encoder, its enabling and homing (statecharts/axis.scxml), its supervision
 * and its servo. Each cycle: axis_check(), axis_observe(), then one of axis_rest(), axis_follow(),
 * axis_home() for a drive request, then axis_supervise() with the permit's decision on it.
 */
#ifndef BORESIGHT_AXIS_H
#define BORESIGHT_AXIS_H

#include "axis/drift_audit.h"
#include "axis/encoder.h"
#include "axis/homing.h"
#include "axis/supervision.h"
#include "card/card_frame.h"
#include "charts/axis_chart.h"
#include "motion/motor_heat.h"
#include "motion/servo.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The counts have meant a place since the start. */
#define AXIS_PLACE_COUNTED UINT32_C(1)
/** A place was known, and the counts since then cannot be believed. */
#define AXIS_PLACE_BROKEN UINT32_C(2)

/** Under seal. */
typedef struct {
    encoder_t encoder;
    uint32_t limit_switches; /**< CARD_LIMIT_ bits of the last report. */
    motor_heat_t heat;
    servo_t servo;
    homing_t homing;
    drift_audit_t drift;
    int32_t home_correction_ticks; /**< Shift of the position at the last homing. */
    uint32_t place;              /**< Trust in the place that its counts give: AXIS_PLACE_ bits. */
    int32_t elsewhere_ticks;     /**< Shift against the place that its counts had, until that is
                                    resolved. */
    int32_t contradiction_ticks; /**< From home to where the counts were at a fault of the two, for
                                    the record. */
    int32_t setpoint_ticks;
    int32_t setpoint_speed_ticks_per_s_q8;
} axis_sealed_t;

typedef struct {
    axis_chart_t chart;
    axis_sealed_t sealed;
    supervision_t supervision;
} axis_t;

/** Report of an axis' card on the time since its last one. */
typedef struct {
    const card_drive_t *applied; /**< Its drive since the sample before. */
    uint32_t elapsed_us;         /**< Time since then; 0: there is no report in this cycle. */
    bool is_timed;               /**< By its own clock, since the cycle before. */
} axis_sample_t;

/** Starts disabled and fresh: nothing is known of where it is. */
void axis_init(axis_t *self);

/** Before each cycle: what was damaged of its charts leaves a fault. True when something was. */
bool axis_check(axis_t *self);

/**
 * Takes this cycle's report (NULL when none is valid): position, switches, homing; `elapsed_us`
 * since the one before.
 *
 * @return AXIS_NOTE_ bits
 *
 * @satisfies SWR-AXIS-002
 * @satisfies SWR-AXIS-025
 * @satisfies SWR-AXIS-026
 */
uint32_t axis_observe(axis_t *self, const axis_config_t *config, const card_report_t *report,
                      uint32_t elapsed_us);

/** Its motor is at `heat_dc`, 0.1 degree Celsius, as far as its card knows. */
void axis_warm(axis_t *self, const axis_config_t *config, int32_t heat_dc);

/**
 * Enables the axis unless `is_fault_present`; clears a stall.
 *
 * @satisfies SWR-AXIS-001
 */
void axis_enable(axis_t *self, bool is_fault_present);

/** Disables the axis; a homing in progress is given up. */
void axis_disable(axis_t *self);

/** The position can no longer be trusted: lost, if anything was known of it. */
void axis_lose_reference(axis_t *self);

/**
 * The position is in doubt: a homed axis becomes unverified, a homing one lost.
 *
 * @satisfies SWR-REF-004
 */
void axis_doubt(axis_t *self);

/**
 * A fresh axis stands at `position_ticks`, as was kept from before the start: unverified. Otherwise
 * nothing.
 *
 * @satisfies SWR-REF-003
 */
void axis_restore(axis_t *self, const axis_config_t *config, int32_t position_ticks);

/**
 * The axis stands at `position_ticks`, as was saved or as the operator states: unverified, whatever
 * it was.
 *
 * @satisfies SWR-STORE-020
 */
void axis_place(axis_t *self, const axis_config_t *config, int32_t position_ticks);

/**
 * Something was known of a fresh axis that cannot be believed: lost. Otherwise nothing.
 *
 * @satisfies SWR-REF-003
 */
void axis_forget(axis_t *self);

/** A lost axis would stand at `position_ticks` by its counts: homing compares it with that. */
void axis_remember(axis_t *self, int32_t position_ticks);

/**
 * The operator has compared the position with the robot: an unverified axis, and a lost one without
 * a switch or that is contradicted, is verified where it stands.
 *
 * @return true when it was confirmed by this
 *
 * @satisfies SWR-REF-005
 */
bool axis_confirm(axis_t *self, const axis_config_t *config);

/**
 * Its memory was damaged: all but its chart, which has its own complement, starts anew; the axis is
 * faulty and lost, also if it was fresh.
 */
void axis_distrust(axis_t *self);

/** Gives up a homing in progress. */
void axis_stop_homing(axis_t *self);

/**
 * Begins homing if the axis is enabled and not homed. An axis without a switch is taken where it
 * stands by this if it is fresh and at rest, and never again.
 *
 * @return AXIS_NOTE_ bits
 *
 * @satisfies SWR-REF-002
 * @satisfies SWR-REF-013
 */
uint32_t axis_begin_homing(axis_t *self, const axis_config_t *config);

/** The place that was known does not hold any more, whatever the axis counts from here on. */
void axis_break_place(axis_t *self);

/** It does not stand as it was parked. */
void axis_refuse_parking(axis_t *self);

/** Nothing has been known of where it is since the start: it stands as it was parked. */
static inline bool axis_is_as_parked(const axis_t *self)
{
    return self->sealed.place == 0U;
}

/** No motion is wanted: the set-point is the position. */
card_drive_t axis_rest(axis_t *self, uint32_t elapsed_us);

/** Request for following a profile. */
card_drive_t axis_follow(axis_t *self, const axis_config_t *config, int32_t setpoint_ticks,
                         int32_t setpoint_speed_ticks_per_s_q8, uint32_t elapsed_us);

/** Request for the present step of homing. */
card_drive_t axis_home(axis_t *self, const axis_config_t *config, uint32_t elapsed_us);

/**
 * The checks of supervision and homing. `is_driven`: the permit allowed the axis and a motion runs.
 *
 * @return AXIS_NOTE_ bits
 *
 * @satisfies SWR-AXIS-012
 * @satisfies SWR-AXIS-022
 */
uint32_t axis_supervise(axis_t *self, const axis_config_t *config, bool is_driven,
                        const axis_sample_t *sample);

/**
 * The readings of the encoder between which the axis may be: about its position, and between
 * position and set-point with their greatest distance while it is driven. After axis_supervise().
 *
 * @satisfies SWR-AXIS-017
 */
void axis_guard(const axis_t *self, const axis_config_t *config, bool is_driven,
                int32_t *minimum_reading, int32_t *maximum_reading);

static inline bool axis_is_enabled(const axis_t *self)
{
    return self->chart.power == AXIS_POWER_ENABLED;
}

static inline bool axis_is_faulty(const axis_t *self)
{
    return self->chart.power == AXIS_POWER_FAULT;
}

/**
 * Its position is trusted: taken where it stood, or verified.
 *
 * @satisfies SWR-REF-001
 */
static inline bool axis_is_homed(const axis_t *self)
{
    return axis_chart_in_homed(&self->chart);
}

/** Nothing has been known of its position since the start. */
static inline bool axis_is_fresh(const axis_t *self)
{
    return self->chart.reference == AXIS_REFERENCE_FRESH;
}

/**
 * Its counts say where it is, also if that is not trusted: homed, unverified, or lost by a command
 * and counted ever since. All others are known only by their travel and the limits that they share.
 *
 * @satisfies SWR-AXIS-053
 */
bool axis_is_placed(const axis_t *self);

/** axis_confirm() would verify it.
 *
 * @satisfies SWR-AXIS-040
 */
bool axis_is_confirmable(const axis_t *self, const axis_config_t *config);

/** Lost or unverified without a switch: only axis_confirm() makes it homed. */
bool axis_needs_confirmation(const axis_t *self, const axis_config_t *config);

/** Homing met its switch where the counts did not have it: it is shown there, and lost. The next
 * homing that meets the switch where they had it homes it, or the operator's confirmation. */
bool axis_is_contradicted(const axis_t *self);

/** Lost or unverified, and counting: its position cannot be compared. */
bool axis_is_moving_in_doubt(const axis_t *self);

static inline bool axis_is_homing(const axis_t *self)
{
    return axis_chart_in_homing(&self->chart);
}

/** Within the deadband of `target_ticks`. */
bool axis_is_at(const axis_t *self, const axis_config_t *config, int32_t target_ticks);

/**
 * `drive` would move towards an active limit switch.
 *
 * @satisfies SWR-AXIS-005
 */
bool axis_is_towards_switch(const axis_t *self, const axis_config_t *config,
                            const card_drive_t *drive);

/** By its counts the axis is at or beyond a soft limit, and `drive` would take it further. */
bool axis_is_driven_out(const axis_t *self, const axis_config_t *config, const card_drive_t *drive);

/** The axis is homed, and driven out. */
static inline bool axis_is_beyond_limit(const axis_t *self, const axis_config_t *config,
                                        const card_drive_t *drive)
{
    return axis_is_homed(self) && axis_is_driven_out(self, config, drive);
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Checks that the axis does what its drive should make it do: those of one axis in each cycle, one
 * after the other. The axis owns one.
 */
#ifndef BORESIGHT_SUPERVISION_H
#define BORESIGHT_SUPERVISION_H

#include "axis/count_balance.h"
#include "axis/edge_spacing.h"
#include "card/card_frame.h"
#include "charts/stall_watchdog_chart.h"
#include "motion/motor_model.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Notes of an axis: what happened in a cycle. All but AXIS_NOTE_HOMED say that it is not homed any
 * more, and all but that and AXIS_NOTE_DRIFTED are faults. */
#define AXIS_NOTE_HOMED 0x001U
#define AXIS_NOTE_ENCODER_FAULT 0x004U
#define AXIS_NOTE_STALLED 0x008U
#define AXIS_NOTE_FOLLOWING_ERROR 0x010U
#define AXIS_NOTE_HOME_TIMEOUT 0x020U
#define AXIS_NOTE_SWITCH_FAULT 0x040U
#define AXIS_NOTE_WRONG_WAY 0x080U
#define AXIS_NOTE_MOVED_OFF 0x100U
#define AXIS_NOTE_NO_COUNTS 0x200U
#define AXIS_NOTE_WRONG_SPEED 0x400U
#define AXIS_NOTE_DRIFTED 0x800U
#define AXIS_NOTE_SWITCH_ELSEWHERE 0x1000U
#define AXIS_NOTE_UNEVEN_COUNTS 0x2000U

/** Places that are remembered of an axis that is off: those of the last second. */
#define SUPERVISION_PLACES 11U

/** View of the axis in a cycle. */
typedef struct {
    int32_t position_ticks;
    int32_t setpoint_ticks;
    int32_t following_error_ticks; /**< Largest distance of the two while driven. */
    bool is_driven;                /**< The permit allowed the axis and a motion runs. */
    bool is_upwards;               /**< Direction of the last drive that was asked for. */
    bool is_relied_on;    /**< Enabled, homed or unverified: off, it is to stay where it is. */
    card_drive_t drive;   /**< Drive that the card applied up to this position. */
    uint32_t lost_q16;    /**< Share of its speed that the motor has lost, being warm. */
    uint32_t edge_age_us; /**< Age of its newest edge; unknown: evenness is not judged. */
    uint32_t elapsed_us;  /**< Since the report before; 0: there is none in this cycle. */
} supervision_view_t;

/** Under seal. */
typedef struct {
    int32_t rest_ticks;  /**< supervision_rest_ticks(), from the first cycle on. */
    int32_t mark_ticks;  /**< Position at the last progress in the direction of the drive. */
    uint16_t is_upwards; /**< Direction of the last drive that was asked for: 0 or 1. */
    uint16_t drives; /**< Drives that the card may have applied since the last report, as bits; 0:
                        none was missed. */
    int32_t backwards_ticks;                  /**< Way against its drive, for the record. */
    int32_t places_ticks[SUPERVISION_PLACES]; /**< While off, one each tenth of a second. */
    int32_t lowest_ticks;                     /**< Lowest of these places. */
    int32_t highest_ticks;
    uint32_t place;         /**< Index of the newest one. */
    uint32_t place_us;      /**< Its age. */
    uint32_t off_us;        /**< Off for so long, saturates. */
    int32_t off_ticks;      /**< Way while off, for the record. */
    int32_t position_ticks; /**< Position of the cycle before. */
    motor_model_t model;
    int64_t due_q16;       /**< Way of the model since the last count in its direction. */
    uint32_t silent_us;    /**< Since LIMIT_SILENT_TICKS were due without any. */
    int32_t missing_ticks; /**< Ticks that were due at a fault, for the record. */
    count_balance_t account;
    edge_spacing_t pace;
} supervision_sealed_t;

typedef struct {
    supervision_sealed_t sealed;
    stall_watchdog_chart_t stall;
} supervision_t;

void supervision_init(supervision_t *self);

/** Before each step: a damaged stall watchdog is stalled and watches nothing. True when it was
 * damaged. */
static inline bool supervision_check(supervision_t *self)
{
    return stall_watchdog_chart_check(&self->stall) != 0U;
}

/** The farthest that an axis may move while it is off. */
int32_t supervision_rest_ticks(const axis_config_t *config);

/** The drive has been off for so long that the motor has come to rest. */
bool supervision_is_at_rest(const supervision_t *self);

/** The axis was enabled anew: a stall is over. Unless its position is trusted all the same, what
 * was missing of counts before does not matter any more. */
void supervision_reset(supervision_t *self, bool is_trusted);

/** The position is sure: what was missing of counts before does not matter any more. */
void supervision_settle(supervision_t *self);

/** The position was set: places from before are `ticks` farther up now. */
void supervision_shift(supervision_t *self, int32_t ticks);

/**
 * One cycle. Where reports were missed and the drive changed meanwhile, the time of the change is
 * unknown, and so is the way of a drive that lasts less than LIMIT_BRIEF_DRIVE_US: the way of that
 * time is left out.
 *
 * @return AXIS_NOTE_ bits of the checks that failed
 *
 * @satisfies SWR-STALL-001
 * @satisfies SWR-STALL-002
 * @satisfies SWR-AXIS-009
 * @satisfies SWR-AXIS-015
 * @satisfies SWR-AXIS-016
 * @satisfies SWR-AXIS-018
 * @satisfies SWR-AXIS-021
 * @satisfies SWR-FLOW-002
 * @satisfies SWR-FLOW-003
 * @satisfies SWR-AXIS-047
 * @satisfies SWR-AXIS-160
 */
uint32_t supervision_step(supervision_t *self, const axis_config_t *config,
                          const supervision_view_t *view);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Frequency sweep: the speed of an axis by the words of its high-frequency card. First the slowest
 * word is sought at which it begins to turn, then point after point the words become faster, each
 * for a run upwards and one downwards. A step is a pause and a run; a step that the pedal has
 * interrupted begins anew. The measured ways go out as events (thesis 4.3.3; the published sweep of
 * the ProstateRobot's rotation).
 */
#ifndef BORESIGHT_SWEEP_MODE_H
#define BORESIGHT_SWEEP_MODE_H

#include "mode/leg/leg.h"
#include "mode/leg/mode_asked.h"
#include "mode/leg/mode_frame.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Request and progress; at first all zero but the request. */
typedef struct {
    uint32_t is_free;    /**< Asked for, 0 or 1: the operator has said that nothing hinders the axis
                            and no person is at it. */
    uint32_t stage;      /**< Stage of this file; 0: it has not begun. */
    uint32_t word;       /**< Word of the present step. */
    uint32_t point;      /**< 0..LIMIT_SWEEP_POINTS - 1, once its run is no search any more. */
    int32_t start_ticks; /**< Position at which the present run began. */
    int32_t up_ticks;    /**< Way upwards of the present point. */
    int32_t most_ticks;  /**< The longer way of the point before. */
} sweep_mode_t;

/**
 * May axis `index` be swept?
 *
 * @return status STATUS_OK; STATUS_UNKNOWN_COMMAND for no axis; STATUS_NO_SWEEP for one without
 * waves, that does not turn or shares a limit; STATUS_NOT_FREE; STATUS_NEEDLE_IN; STATUS_AXIS_LIMIT
 * where a run at the axis' speed would meet a soft limit
 *
 * @satisfies SWR-SWEEP-001
 * @satisfies SWR-SWEEP-002
 */
solution_t sweep_mode_judge(const sweep_mode_t *asked, uint32_t index, const robot_t *robot,
                            const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * One cycle; done after the last point, or the one after which the next would be too fast for the
 * axis. Fails with STATUS_SWEEP_NO_START, STATUS_TOO_FAST, STATUS_SWEEP_CURRENT, STATUS_NEEDLE_IN,
 * STATUS_AXIS_LIMIT, or STATUS_FAULT_PRESENT for an axis that turns against its drive.
 *
 * @satisfies SWR-SWEEP-003
 * @satisfies SWR-SWEEP-004
 * @satisfies SWR-SWEEP-005
 * @satisfies SWR-SWEEP-006
 * @satisfies SWR-SWEEP-007
 * @satisfies SWR-SWEEP-008
 */
void sweep_mode_step(sweep_mode_t *self, uint32_t index, leg_t *leg, const mode_frame_t *frame,
                     mode_result_t *result);

/**
 * It has begun, so that counts may have been lost that nothing has compared with a speed.
 *
 * @satisfies SWR-SWEEP-025
 */
static inline bool sweep_mode_has_begun(const sweep_mode_t *self)
{
    return self->stage != 0U;
}

/**
 * Request of a command SWEEP.
 *
 * @return bit n: axis n
 */
uint32_t sweep_mode_ask(const mode_asked_t *asked, mode_way_t *way, sweep_mode_t *self);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A treatment program runs: the axes along and about the needle go to each step in one leg, and
 * rest there for its dwell; all others rest. A dwell is ended by its time, and one with a gate by
 * the dose before that. Released, the pedal stops its time; pressed again, the rest of the dwell
 * follows, once the axes stand there. The stop of the gate ends the program, paused or
 * not.
 */
#ifndef BORESIGHT_PROGRAM_MODE_H
#define BORESIGHT_PROGRAM_MODE_H

#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/move/move_mode.h"
#include "mode/lists/program_list.h"
#include "robot/joints.h"

#include <stdbool.h>
#include <stdint.h>

typedef enum {
    PROGRAM_STAGE_NONE = 0,  /**< It is not armed. */
    PROGRAM_STAGE_GOES = 1,  /**< To the step. */
    PROGRAM_STAGE_DWELLS = 2 /**< At the step, or beside it again. */
} program_stage_t;

/** All zero it is not armed. */
typedef struct {
    uint32_t stage;       /**< program_stage_t. */
    uint32_t step;        /**< Steps that are done. */
    uint32_t dwelt_us;    /**< Dwell passed of the step after those. */
    uint32_t dwell_ms;    /**< Valid while it dwells. */
    uint32_t is_dose_due; /**< In this dwell the gate has said that the dose is not reached. */
} program_mode_t;

/**
 * May the list with checksum `crc` be run from where the axes stand, along the line to `target`?
 *
 * @return STATUS_OK; STATUS_PROGRAM_OTHER; STATUS_NOT_ALIGNED; STATUS_PROGRAM_STOPPED while
 * `is_stopped` by the gate; the refusal of a limit that the way to the first step would leave
 *
 * @satisfies SWR-PROG-004
 * @satisfies SWR-PROG-005
 * @satisfies SWR-PROG-008
 */
solution_t program_mode_judge(const program_list_t *list, uint32_t crc, const move_mode_t *target,
                              const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                              bool is_stopped);

/** It was armed: from the first step on. */
void program_mode_begin(program_mode_t *self);

/** Rest of its dwell; to be asked while it dwells. */
static inline uint32_t program_mode_left_ms(const program_mode_t *self)
{
    return self->dwell_ms - (self->dwelt_us / 1000U);
}

/**
 * The gate says stop while it is armed: fails with STATUS_PROGRAM_STOPPED.
 *
 * @satisfies SWR-PROG-008
 */
void program_mode_stop(const program_mode_t *self, const mode_frame_t *frame,
                       mode_result_t *result);

/**
 * One cycle; done once the dwell of the last step is over.
 *
 * Fails with EVENT_MEMORY_DAMAGED at a step that is not what was judged, and with
 * STATUS_NOT_ALIGNED where a leg would begin beside the line to `target`.
 *
 * @satisfies SWR-PROG-005
 * @satisfies SWR-PROG-006
 * @satisfies SWR-PROG-007
 * @satisfies SWR-PROG-009
 */
void program_mode_step(program_mode_t *self, const move_mode_t *target, leg_t *leg,
                       const mode_frame_t *frame, mode_result_t *result);

#endif

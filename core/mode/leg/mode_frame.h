/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The interface of a mode to the rest: the cycle as it sees it, and its result. No mode sees the
 * controller.
 */
#ifndef BORESIGHT_MODE_FRAME_H
#define BORESIGHT_MODE_FRAME_H

#include "axis/axis.h"
#include "card/card_frame.h"
#include "card/link.h"
#include "interface/event.h"
#include "interface/status.h"
#include "interface/workphase_list.h"
#include "mode/lists/program_list.h"
#include "mode/lists/trajectory_list.h"
#include "robot/robot.h"
#include "safety/hand_guard.h"

#include <stdbool.h>
#include <stdint.h>

/** One for each axis, and one for the fault that makes it fail. */
#define MODE_NOTES (ROBOT_AXIS_MAX + 1U)
#define MODE_NO_AXIS ROBOT_AXIS_MAX

/** One cycle. */
typedef struct {
    const robot_t *robot;
    axis_t *axes;        /**< In the order of the robot's table. */
    uint32_t axis_count; /**< Holds even when the table is damaged. */
    bool is_every_axis_homed;
    workphase_t workphase; /**< The present one. */
    bool is_moving;        /**< The pedal lets the armed order run. */
    uint32_t elapsed_us;
    const trajectory_row_t *rows;               /**< Rows of the trajectory that is held. */
    const program_list_t *program;              /**< The treatment program that is held. */
    bool is_dose_reached;                       /**< The gate of the treatment says so. */
    bool is_treatment_stopped;                  /**< The same. */
    const link_t *links;                        /**< To the cards, by slot. */
    hand_t hand;                                /**< On the needle's handle. */
    bool is_puncture;                           /**< A puncture was found in this cycle. */
    uint32_t speed_cap_percent[ROBOT_AXIS_MAX]; /**< Share of its speed that the permit lets each
                                                   axis have, 1..100. */
} mode_frame_t;

/** One axis, and where it shall stand. */
typedef struct {
    uint32_t axis;
    int32_t end_ticks;
} mode_way_t;

/** Progress of a mode. */
typedef enum {
    MODE_RUNNING = 0,
    MODE_DONE = 1,  /**< All that was asked for. */
    MODE_FAILED = 2 /**< It cannot be done: the order is discarded. */
} mode_progress_t;

/** Something that is worth an event. */
typedef struct {
    event_id_t id;
    uint32_t axis;
    int32_t value; /**< As the event says. */
} mode_note_t;

/** Result of a mode's cycle. */
typedef struct {
    card_drive_t requests[ROBOT_AXIS_MAX]; /**< Drive that the mode asks for each axis. */
    mode_progress_t progress;
    status_t status; /**< With MODE_FAILED: the final answer's status. */
    uint32_t axis;   /**< With MODE_FAILED: whose fault it is, or MODE_NO_AXIS. */
    uint32_t note_count;
    mode_note_t notes[MODE_NOTES];
} mode_result_t;

/** Nothing is known yet: running, without a note. No drive is asked for. */
void mode_clear(mode_result_t *self);

/** Adds a note; one too many is dropped. */
void mode_note(mode_result_t *self, event_id_t id, uint32_t axis, int32_t value);

/** Axis `axis` fails the mode: MODE_FAILED with STATUS_FAULT_PRESENT, and the note that says why.
 */
void mode_fail(mode_result_t *self, event_id_t id, uint32_t axis, int32_t value);

/** It cannot go on, for `status`, and no axis is to blame: MODE_FAILED, and every axis rests. */
void mode_give_up(const mode_frame_t *frame, mode_result_t *result, status_t status);

/** Asks for no drive of any axis. */
void mode_rest(const mode_frame_t *frame, mode_result_t *result);

#endif

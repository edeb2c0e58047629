/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Action of the armed order once the pedal is pressed: one of several modes, each a module of its
 * own with a row in core/interface/modes.yml. The controller owns one mode_state_t, steps it every
 * cycle and seals it.
 */
#ifndef BORESIGHT_MODE_H
#define BORESIGHT_MODE_H

#include "interface/mode_list.h"
#include "interface/workphase_list.h"
#include "mode/leg/mode_asked.h"
#include "mode/leg/mode_frame.h"
#include "mode/mode_state.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The mode that a command for `workphase` itself arms there, or MODE_NONE; the others have
 * commands of their own. */
mode_kind_t mode_of(workphase_t workphase);

/** The mode that a command of this kind arms, whatever the workphase, or MODE_NONE. */
mode_kind_t mode_of_command(uint32_t command_kind);

/**
 * `kind` may be armed in `workphase`, and runs there.
 *
 * @satisfies SWR-MODE-001
 */
bool mode_runs_in(mode_kind_t kind, workphase_t workphase);

/** The mode that was begun last, in a workphase where it runs; in all others MODE_NONE. */
mode_kind_t mode_in(const mode_state_t *self, workphase_t workphase);

/**
 * The axes that `kind` needs: bit n: axis n. `commanded`: those that it is commanded for.
 *
 * @satisfies SWR-MODE-002
 */
uint32_t mode_axes(mode_kind_t kind, uint32_t commanded, const robot_t *robot);

/**
 * The mode that was begun last needs axis `index`.
 *
 * @satisfies SWR-MODE-003
 */
bool mode_needs(const mode_state_t *self, uint32_t index);

/** Request to `kind`, by its command and as the robot stands: its axes, and the members that it
 * reads by its row. controller_aim() adds the move of a mode that goes to the target. */
mode_request_t mode_ask(mode_kind_t kind, const mode_asked_t *asked);

/**
 * May `kind` be armed with this request? What every mode needs is asked by the workphase chart.
 *
 * @return as NAME_mode_judge() of its folder; STATUS_OK of a mode that has none
 */
solution_t mode_judge(mode_kind_t kind, const mode_request_t *request, const robot_t *robot,
                      const axis_t axes[ROBOT_AXIS_MAX]);

/** `kind` was armed. */
void mode_begin(mode_state_t *self, mode_kind_t kind, const mode_request_t *request);

/**
 * One cycle. Unless `frame->is_moving` every axis rests, and the mode goes on from there. Done and
 * failed are reported in the cycle in which they are found.
 *
 * @satisfies SWR-DEMO-001
 * @satisfies SWR-DEMO-002
 * @satisfies SWR-THESIS-002
 * @satisfies SWR-PEDAL-005
 */
void mode_step(mode_state_t *self, const mode_frame_t *frame, mode_result_t *result);

/** Progress of the armed order. */
typedef struct {
    uint32_t done_per_mille; /**< 0..1000: of the cycles of the present leg; of homing, of the axes;
                                of a trajectory and of speeds, of their time; of a speed for a way,
                                of it; in a step of a program, of its dwell. */
    uint32_t left_ms; /**< Until the set-points are at its end, or the dwell is over; 0: unknown. */
} mode_share_t;

/**
 * Call only while `kind` moves: performs a division.
 *
 * @satisfies SWR-MODE-006
 * @satisfies SWR-PROG-011
 */
mode_share_t mode_share(const mode_state_t *self, mode_kind_t kind,
                        const axis_t axes[ROBOT_AXIS_MAX], uint32_t axis_count);

/**
 * The order has ended or was given up: whatever runs stops, and homing is given up. The position of
 * an axis that a sweep has turned is in doubt, as nothing has compared its counts meanwhile.
 *
 * @satisfies SWR-SWEEP-025
 */
void mode_stop(mode_state_t *self, axis_t axes[ROBOT_AXIS_MAX], uint32_t axis_count);

/** Where the mode ends at the target; MODE_AIM_NONE of what is no mode_kind_t. */
mode_aim_t mode_aim_of(uint32_t kind);

/** A hand moves the needle in `kind`. */
bool mode_is_by_hand(mode_kind_t kind);

/** The needle answers a puncture in `kind`, which was begun last: it comes to rest for it, or
 * vibrates. */
bool mode_is_vibrating(const mode_state_t *self, mode_kind_t kind);

/**
 * The needle must not go deeper in `kind`, which was begun last: it is steered, its rotation does
 * not follow its law, and what it does is no stroke of a vibration.
 *
 * @satisfies SWR-STEER-006
 */
bool mode_waits_for_rotation(const mode_state_t *self, mode_kind_t kind, const robot_t *robot,
                             const axis_t axes[ROBOT_AXIS_MAX]);

/** In `kind`, which was begun last, the hand is to be seen off before it moves the needle again. */
bool mode_wants_hand_off(const mode_state_t *self, mode_kind_t kind);

/**
 * `kind` may drive an axis that is not homed.
 *
 * @satisfies SWR-AXIS-006
 */
bool mode_may_be_unhomed(mode_kind_t kind);

/**
 * The axes (bits) that must heed needle_forbids_jog() in this mode; `driven`: those that ask for a
 * drive.
 *
 * @satisfies SWR-JOG-001
 * @satisfies SWR-JOG-003
 * @satisfies SWR-JOG-016
 */
uint32_t mode_heeding_needle(const mode_state_t *self, mode_kind_t kind, const robot_t *robot,
                             uint32_t driven);

#endif

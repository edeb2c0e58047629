/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The commands that a peer of the workphase protocol gives by a word, as the rows of core/interface
 * name them.
 * A STRING has the word as its name, and its values as its text, or both in the text.
 */
#ifndef BORESIGHT_WORKPHASE_COMMANDS_H
#define BORESIGHT_WORKPHASE_COMMANDS_H

#include "igtl/dialect/igtl_dialect.h"
#include "interface/command.h"
#include "interface/status.h"
#include "igtl/wire/igtl_codec.h"
#include "robot/robot.h"

#include <stddef.h>
#include <stdint.h>

/** A workphase of a later server, here a pose in MANUAL. */
#define WORKPHASE_COMMAND_DRAPING "DRAPING"

/**
 * Fills `command` from `text`, what follows a word; `text` may be changed.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for a text that is none, or a name that the robot does
 * not have; STATUS_OUT_OF_RANGE for a number that is none or too large
 */
typedef status_t (*workphase_reader_t)(const robot_t *robot, char *text, command_t *command);

/** A word, which names as well what it is answered by. */
typedef struct {
    const char *word; /**< Lives as long as the process. */
    command_kind_t kind;
    command_payload_t as;      /**< Its payload, but for the values that its reader adds. */
    workphase_reader_t reader; /**< NULL: nothing follows it. */
    const char *form;          /**< Form of a word whose numbers have units; otherwise NULL. */
} workphase_command_t;

/** The rows of core/interface that have words, by their commands' codes. */
extern const workphase_command_t workphase_commands[];
extern const size_t workphase_command_count;

/** The readers, by the payload of their commands. */
status_t workphase_read_jog(const robot_t *robot, char *text, command_t *command);
status_t workphase_read_jog_by(const robot_t *robot, char *text, command_t *command);
status_t workphase_read_membranes(const robot_t *robot, char *text, command_t *command);
status_t workphase_read_pose_name(const robot_t *robot, char *text, command_t *command);
status_t workphase_read_probe(const robot_t *robot, char *text, command_t *command);
status_t workphase_read_steering(const robot_t *robot, char *text, command_t *command);
status_t workphase_read_sweep(const robot_t *robot, char *text, command_t *command);
status_t workphase_read_velocity(const robot_t *robot, char *text, command_t *command);

/**
 * The word that `message` begins with, or is named; NULL for none.
 *
 * @satisfies SWR-IGTL-066
 */
const workphase_command_t *workphase_commands_find(const igtl_message_t *message);

/**
 * The command that `message` means, which workphase_commands_find() has found to be this `word`.
 * The controller judges whether the command is allowed.
 *
 * POSE has the name of a pose. JOG has an axis, its position and its unit, mm or deg, JOG_BY the
 * way from where it stands. VELOCITY has axes, each with a speed and mm/s or deg/s, then the time
 * and s. SWEEP has an axis, and FREE if the operator has confirmed that it is. PROBE has each
 * length of the robot's probe once, by its name and then mm within +-2000, in any order. MEMBRANES
 * has depths below the entry point in mm, or nothing. STEER has NONE, or another method, a
 * curvature with /m and a direction with deg.
 *
 * @return as its reader; STATUS_WRONG_UNIT for a number without the unit of its axis;
 * STATUS_OUT_OF_RANGE also beyond IGTL_TEXT_MAX characters
 *
 * @satisfies SWR-FLOW-005
 * @satisfies SWR-IGTL-074
 * @satisfies SWR-POSE-006
 * @satisfies SWR-PROBE-006
 * @satisfies SWR-IGTL-756
 * @satisfies SWR-PUNCT-619
 * @satisfies SWR-STEER-010
 * @satisfies SWR-SWEEP-013
 * @satisfies SWR-VEL-014
 */
status_t workphase_commands_read(const workphase_command_t *word, const robot_t *robot,
                                 const igtl_message_t *message, command_t *command);

/**
 * Why the text of PROBE was refused by `status`, and how it is written for this robot.
 *
 * @satisfies SWR-IGTL-073
 */
void workphase_commands_send_form(const robot_t *robot, status_t status,
                                  char text[IGTL_REASON_SIZE]);

#endif

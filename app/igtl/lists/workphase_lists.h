/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The words by which a client sends a list item by item and has it run, of trajectories:
 * `TRAJECTORY BEGIN <rows>`, `TRAJECTORY ROW <index> <what it is>` with the index from 0 on,
 * `TRAJECTORY END`, `TRAJECTORY RUN`; of treatment programs `PROGRAM`, and `STEP` for each. END and
 * RUN name the list by its checksum: the one behind the word, without one that of what this client
 * has sent. An NDARRAY of the same name has all items at once (workphase_array.h).
 */
#ifndef BORESIGHT_WORKPHASE_LISTS_H
#define BORESIGHT_WORKPHASE_LISTS_H

#include "igtl/lists/workphase_list_kind.h"
#include "interface/command.h"
#include "interface/status.h"
#include "igtl/wire/igtl_codec.h"
#include "robot/robot.h"

#include <stdint.h>

/** The kind whose word the text begins with, NULL for none. */
const workphase_list_t *workphase_lists_find(const igtl_message_t *message);

/** The kind of this name, NULL for none. */
const workphase_list_t *workphase_lists_named(const char *name);

/** The kind that a command begins, adds to or ends; NULL for another command. */
const workphase_list_t *workphase_lists_of(uint32_t kind);

/**
 * The command that the text means; what may be driven, the controller judges. `*sum`: checksum of
 * the items that this client has sent, and then what it is once the command is on its way.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for a text that is none; STATUS_OUT_OF_RANGE for a
 * number that is none or too large, or one too few or too many; STATUS_WRONG_UNIT for a number
 * without its unit; as list_terms_step()
 *
 * @satisfies SWR-IGTL-075
 * @satisfies SWR-TRAJ-019
 * @satisfies SWR-PROG-013
 * @satisfies SWR-PROG-015
 */
status_t workphase_lists_read(const workphase_list_t *self, const robot_t *robot,
                              const igtl_message_t *message, uint32_t *sum, command_t *command);

#endif

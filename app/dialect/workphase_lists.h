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

#include "interface/command.h"
#include "interface/status.h"
#include "message/igtl_codec.h"
#include "mode/program_step.h"
#include "mode/trajectory_row.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

#define WORKPHASE_LIST_COUNT 2U /**< Kinds of lists. */

/** What a list is made of, by its kind. */
typedef union {
    trajectory_row_t row;
    program_step_t step;
} workphase_item_t;

/** A kind of list. Of what its readers refuse the item is unspecified. */
typedef struct {
    uint32_t number;   /**< Below WORKPHASE_LIST_COUNT. */
    const char *word;  /**< Its name, which names as well what it is answered by. */
    const char *item;  /**< The word of an item. */
    const char *title; /**< The same for a sentence. */
    uint32_t most;     /**< Items of an array. */
    command_kind_t begin;
    command_kind_t add;
    command_kind_t end;
    command_kind_t run;
    /** How an item is written, with the units of its numbers. */
    const char *(*form)(const robot_t *robot);
    /** The item that the next words of `*text` are. */
    status_t (*read_words)(const robot_t *robot, char **text, workphase_item_t *item);
    /** Columns of an array. */
    uint32_t (*columns)(const robot_t *robot);
    /** The item that row `index` of an array is. */
    status_t (*read_row)(const robot_t *robot, const igtl_message_t *message, uint32_t index,
                         workphase_item_t *item);
    /** The command that hands it in, and from it the index that it has. */
    command_t (*command)(const robot_t *robot, uint32_t index, const workphase_item_t *item);
    uint32_t (*index)(const command_t *command);
    /** Checksum of a list that was `sum` with it. */
    uint32_t (*sum)(uint32_t sum, const workphase_item_t *item);
} workphase_list_t;

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

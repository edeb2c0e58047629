/* SPDX-License-Identifier: Apache-2.0 */
/** @file What a kind of list is, for workphase_lists.h, which finds it by its word. */
#ifndef BORESIGHT_WORKPHASE_LIST_KIND_H
#define BORESIGHT_WORKPHASE_LIST_KIND_H

#include "interface/command.h"
#include "interface/status.h"
#include "igtl/wire/igtl_codec.h"
#include "mode/lists/program_step.h"
#include "mode/lists/trajectory_row.h"
#include "robot/robot.h"

#include <stdint.h>

#define WORKPHASE_LIST_COUNT 2U /**< Kinds of lists. */

/** An item of a list, by its kind. */
typedef union {
    trajectory_row_t row;
    program_step_t step;
} workphase_item_t;

/** A kind of list. The item is unspecified when its reader refuses. */
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

#endif

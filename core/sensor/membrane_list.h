/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Membranes that the needle is expected to puncture, by their depths, and what became of each:
 * thesis listing 1 keeps such a list and the number of those that are left. The owner of a detector
 * owns one beside it. The design is ours.
 */
#ifndef BORESIGHT_MEMBRANE_LIST_H
#define BORESIGHT_MEMBRANE_LIST_H

#include "interface/membrane_state.h"
#include "interface/status.h"
#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <stdint.h>

/** No membrane of the list. */
#define MEMBRANE_NONE UINT32_MAX

typedef struct {
    int32_t depth_um; /**< 0..LIMIT_MEMBRANE_DEEPEST_UM. */
    int32_t found_um; /**< Depth of its puncture; of no meaning before. */
    uint32_t state;   /**< membrane_state_t. */
} membrane_t;

/** All zero: none is expected. */
typedef struct {
    uint32_t count;
    uint32_t unexpected; /**< Number of punctures that were no membrane of the list. */
    int32_t unseen_um; /**< Down to this depth the needle came while no puncture was looked for. */
    int32_t seen_um;   /**< Down to this depth insertions that looked for punctures have come. */
    membrane_t membranes[LIMIT_MEMBRANES_MOST];
} membrane_list_t;

/**
 * Expects `count` membranes at `depths_um`, from the least deep one on, all of them ahead.
 *
 * @return STATUS_OK, or STATUS_OUT_OF_RANGE when there are more than LIMIT_MEMBRANES_MOST, a depth
 * is not in 0..LIMIT_MEMBRANE_DEEPEST_UM, or one is not deeper than that before; then nothing has
 * changed
 *
 * @satisfies SWR-PUNCT-550
 */
status_t membrane_list_set(membrane_list_t *self, const int32_t depths_um[], uint32_t count);

/**
 * Takes a puncture at `depth_um` for the nearest membrane that is ahead within
 * LIMIT_MEMBRANE_WINDOW_UM, the less deep one of two as near.
 *
 * @return its place in the list; MEMBRANE_NONE: it was unexpected, and is counted
 *
 * @satisfies SWR-PUNCT-548
 */
uint32_t membrane_list_take(membrane_list_t *self, int32_t depth_um);

/** An insertion that looked for punctures has ended at `depth_um`. */
void membrane_list_look(membrane_list_t *self, int32_t depth_um);

/**
 * The needle is at `depth_um` without being looked at, deeper than membrane_list_look() has it: of
 * a membrane that is less deep, the puncture may have been there already. One that is not found is
 * passed, and not missed.
 *
 * @satisfies SWR-PUNCT-752
 */
void membrane_list_blind(membrane_list_t *self, int32_t depth_um);

/**
 * The needle is at `depth_um`: the first membrane that is ahead and more than
 * LIMIT_MEMBRANE_WINDOW_UM less deep is missed, or passed as membrane_list_blind() says.
 *
 * @return its place in the list, or MEMBRANE_NONE
 *
 * @satisfies SWR-PUNCT-549
 */
uint32_t membrane_list_pass(membrane_list_t *self, int32_t depth_um);

/** Number of membranes that are ahead: "punctures left" of thesis listing 1. */
uint32_t membrane_list_left(const membrane_list_t *self);

/** The needle goes in anew: all of them are ahead, and none was unexpected. */
void membrane_list_renew(membrane_list_t *self);

/**
 * The needle is as deep as it shall go: the first membrane that is ahead is missed, or passed.
 *
 * @return its place in the list, or MEMBRANE_NONE
 *
 * @satisfies SWR-PUNCT-612
 */
uint32_t membrane_list_end(membrane_list_t *self);

#endif

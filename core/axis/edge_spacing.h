/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Evenness of the counts of a driven axis. A motor makes the way from one count to the next much as
 * its model does; where counts are lost now and then, the next one seems to be twice as far. The
 * check needs neither the true speed of the motor nor its position, and works from the first counts
 * on. The supervision of an axis owns one.
 */
#ifndef BORESIGHT_EDGE_SPACING_H
#define BORESIGHT_EDGE_SPACING_H

#include <stdbool.h>
#include <stdint.h>

/** A cycle of an axis that is driven. */
typedef struct {
    uint32_t way_q16;   /**< Way of the model, in ticks. */
    uint32_t after_q16; /**< Part of it after the newest count; of no meaning without one. */
    uint32_t ticks;     /**< Counted in the direction of the drive. */
} edge_spacing_view_t;

typedef struct {
    uint32_t since_q16; /**< Way of the model since the last count; UINT32_MAX: unknown. */
    uint32_t ticks;     /**< Ticks of the last way between two counts; 0: none yet. */
    uint32_t due_q16;   /**< Way of the model meanwhile. */
    uint32_t ended_q16; /**< The same, in the cycle in which that way ended; 0 in others. */
    uint32_t uneven;    /**< Accumulated unevenness; even intervals reduce it. */
} edge_spacing_t;

void edge_spacing_init(edge_spacing_t *self);

/** The position is sure, or lost: what was uneven does not matter any more. */
void edge_spacing_settle(edge_spacing_t *self);

/** The axis turned, or was moved: the next way begins at its next count. */
void edge_spacing_begin(edge_spacing_t *self);

/**
 * One cycle of drive. Pauses of the drive are no way.
 *
 * @return true when the sum reaches LIMIT_UNEVEN_MOST
 *
 * @satisfies SWR-AXIS-027
 */
bool edge_spacing_step(edge_spacing_t *self, const edge_spacing_view_t *view);

#endif

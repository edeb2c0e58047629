/* SPDX-License-Identifier: Apache-2.0 */
/** @file Whether nothing is under way: what runs may be replaced then. */
#ifndef BORESIGHT_REST_H
#define BORESIGHT_REST_H

#include "card/card_frame.h"
#include "charts/arming_chart.h"
#include "interface/snapshot.h"
#include "interface/workphase_list.h"

#include <stdbool.h>
#include <stdint.h>

/** Control's exit code when it was asked to end at rest, and has. */
#define REST_EXIT 6

/** The count of axes when none is driven. */
static inline uint32_t rest_driven_axis(const snapshot_t *snapshot)
{
    uint32_t axis = 0U;

    while ((axis < snapshot->axis_count) &&
           (snapshot->axes[axis].drive_mode == (uint32_t)CARD_DRIVE_OFF)) {
        axis++;
    }
    return axis;
}

static inline bool rest_is_armed(const snapshot_t *snapshot)
{
    return snapshot->order != (uint32_t)ARMING_STATE_NONE;
}

/** Whether a client has left START_UP. */
static inline bool rest_has_procedure(const snapshot_t *snapshot)
{
    return (snapshot->workphase != (uint32_t)WORKPHASE_UNDEFINED) &&
           (snapshot->workphase != (uint32_t)WORKPHASE_START_UP);
}

/** Whether none of these holds. */
static inline bool rest_is_it(const snapshot_t *snapshot)
{
    return (rest_driven_axis(snapshot) == snapshot->axis_count) && !rest_is_armed(snapshot) &&
           !rest_has_procedure(snapshot);
}

#endif

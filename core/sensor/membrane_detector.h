/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Punctures of membranes, found in force and depth of a needle that is being inserted. The thesis
 * names the function (5.5, listing 1) and gives no rule: the design is ours.
 *
 * F is the force behind the filter of membrane_filter.h, d the depth, P the largest F of the last
 * LIMIT_MEMBRANE_WINDOW_MS and d_P its depth, s the noise of membrane_noise.h, v the speed now and
 * V the one before it slowed down. A puncture is where
 *
 *     P - F >= max(LIMIT_MEMBRANE_FLOOR_SIGMAS s, LIMIT_MEMBRANE_LEAST_MN)
 *     P - F >= LIMIT_MEMBRANE_SLOPE_MN_PER_MM (d - d_P),  d > d_P
 *     P - F >= P (V - v) / V
 *
 * A smaller drop is not found at all: with noise of 0.1 N a sample, none below 0.17 N. v is the
 * mean speed of the last LIMIT_MEMBRANE_RECENT_MS, V the largest mean of LIMIT_MEMBRANE_SPEED_MS in
 * the window, and falls with the time constant LIMIT_MEMBRANE_FORGET_MS at most. Force for travel
 * instead of time is from Gonenc 2017 (PMC5677255), that friction and relaxation depend on speed
 * from Mahvash and Dupont 2010 (IEEE TBME 57(4) 934).
 *
 * The owner has one for each needle, a list of expected membranes with it, and steps it once each
 * millisecond. It finds membranes of a simulated tissue; in real tissue, published detectors are
 * wrong in most of their reports.
 */
#ifndef BORESIGHT_MEMBRANE_DETECTOR_H
#define BORESIGHT_MEMBRANE_DETECTOR_H

#include "limits/requirement_limits.h"
#include "sensor/membrane_filter.h"
#include "sensor/membrane_list.h"

#include <stdbool.h>
#include <stdint.h>

/** A part of the window. */
#define MEMBRANE_PART_MS 4U
#define MEMBRANE_PARTS (LIMIT_MEMBRANE_WINDOW_MS / MEMBRANE_PART_MS)

typedef enum {
    MEMBRANE_EVENT_NONE = 0,
    MEMBRANE_EVENT_EXPECTED = 1,
    MEMBRANE_EVENT_UNEXPECTED = 2,
    MEMBRANE_EVENT_MISSED = 3 /**< Or passed, which its state says. */
} membrane_event_kind_t;

/** One millisecond of the needle. */
typedef struct {
    int32_t force_mn;  /**< Against the needle, any; zeroed. */
    int32_t depth_um;  /**< Any; deeper is larger. */
    bool is_inserting; /**< It is driven or pushed forward. */
    bool is_blind;     /**< It vibrates as feedback. */
} membrane_view_t;

typedef struct {
    uint32_t kind;    /**< membrane_event_kind_t. */
    uint32_t place;   /**< In the list; MEMBRANE_NONE of an unexpected one. */
    int32_t depth_um; /**< Of the needle where it was noticed; of a missed one its own. */
    int32_t fall_mn;  /**< Up to then; the puncture may be larger. 0 of a missed one. */
} membrane_event_t;

typedef struct {
    int32_t depth_um;       /**< Where it began. */
    int32_t peak_depth_um;  /**< Depth of its largest force. */
    int32_t peak_mn_q12;    /**< That force, filtered. */
    int32_t reserved;       /**< 0. */
    int64_t speed_nm_per_s; /**< Mean of the LIMIT_MEMBRANE_SPEED_MS before it. */
} membrane_part_t;

/** No padding. */
typedef struct {
    membrane_filter_t filter;
    int32_t floor_mn_q12;                  /**< Least fall. */
    membrane_part_t parts[MEMBRANE_PARTS]; /**< The window, a ring. */
    uint32_t at;                           /**< Part that is being filled. */
    uint32_t in_part;                      /**< Milliseconds of it. */
    uint32_t begun;          /**< Parts that have a beginning, saturates at MEMBRANE_PARTS. */
    uint32_t looked;         /**< Parts that have a peak, the one that is being filled included. */
    int64_t speed_nm_per_s;  /**< Mean of LIMIT_MEMBRANE_SPEED_MS. */
    int64_t recent_nm_per_s; /**< v. */
    int64_t before_nm_per_s; /**< V. */
    int32_t from_um;         /**< It looks from here on, after rest and blindness. */
    int32_t last_um;         /**< Depth of the last puncture. */
    uint32_t has_last;       /**< 0 or 1. */
    uint32_t is_blind;       /**< 0 or 1: it looks for nothing, as it is or was blinded. */
} membrane_detector_t;

/**
 * Nothing is known of the force.
 *
 * @param noise_un standard deviation of the filtered force as membrane_noise_un() measured it, uN;
 * above 10,000,000 it counts as that
 *
 * @satisfies SWR-PUNCT-541
 */
void membrane_detector_init(membrane_detector_t *self, uint32_t noise_un);

/**
 * One millisecond. Marks in `list` what it found.
 *
 * @return the event of this millisecond, at most one; a missed membrane waits for the next one
 *
 * @satisfies SWR-PUNCT-540
 * @satisfies SWR-PUNCT-544
 * @satisfies SWR-PUNCT-545
 * @satisfies SWR-PUNCT-546
 * @satisfies SWR-PUNCT-547
 * @satisfies SWR-PUNCT-551
 */
membrane_event_t membrane_detector_step(membrane_detector_t *self, membrane_list_t *list,
                                        const membrane_view_t *view);

/** Least fall that it can find, uN. */
uint32_t membrane_detector_floor_un(const membrane_detector_t *self);

/** After a step: a puncture in this millisecond would have been found. */
static inline bool membrane_detector_is_looking(const membrane_detector_t *self)
{
    return self->looked != 0U;
}

#endif

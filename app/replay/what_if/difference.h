/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Differences, in words, between the outputs of two controllers in the same cycle. Each kind of
 * difference of two runs that were one before is reported once.
 */
#ifndef BORESIGHT_DIFFERENCE_H
#define BORESIGHT_DIFFERENCE_H

#include "controller/controller.h"
#include "interface/event.h"
#include "replay/data/series.h"
#include "replay/data/source.h"

#define DIFFERENCE_SERIES 256U     /**< Most series of one source. */
#define DIFFERENCE_LINE_SIZE 1280U /**< Enough for every line. */

/** Takes a line, which has no line feed. */
typedef void difference_sink_t(void *to, const char *line);

typedef struct {
    series_t series[DIFFERENCE_SERIES];
    uint32_t count;
} difference_list_t;

typedef struct {
    const robot_t *robot;
    difference_sink_t *sink;
    void *to;
    source_t sources[SOURCES];
    uint32_t source_count;
    bool has_begun;                               /**< A cycle has differed. */
    uint32_t states[2];                           /**< Last values of series_states() for both. */
    difference_list_t was;                        /**< Series of the source that is compared. */
    difference_list_t now;                        /**< The same. */
    bool is_reported[SOURCES][DIFFERENCE_SERIES]; /**< Each is reported once. */
    bool is_drive_reported[CARD_SLOT_COUNT];      /**< The same. */
    bool is_event_reported[2][EVENT_ID_COUNT];    /**< The same: of the one, of the other. */
    uint32_t cycle;                               /**< That is compared. */
} difference_t;

/** Begins two runs of `robot`, which must outlive them, as `to`. */
void difference_init(difference_t *self, const robot_t *robot, difference_sink_t *sink, void *to);

/**
 * Reports which states, reasons, events and drives of a cycle that differs are `now` others than
 * they `was`, for the first time; in the first such cycle numbers, when nothing else does.
 *
 * @satisfies SWR-SITE-018
 */
void difference_report(difference_t *self, uint32_t cycle, const controller_outputs_t *was,
                       const controller_outputs_t *now);

#endif

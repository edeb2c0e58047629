/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Writes recorded motion as one page that needs nothing else: the page of the console's build for
 * that (app/console/replay.html), with the recording in it as JSON. It holds what the console would
 * have been sent, and the frames that left to the cards: each state, word and flag, and what a
 * card is asked to drive, in each cycle in which it changes; numbers each 25th, and in each
 * with an event.
 */
#ifndef BORESIGHT_MOTION_HTML_H
#define BORESIGHT_MOTION_HTML_H

#include "http/telemetry_json.h"
#include "replay/bytes.h"
#include "replay/pace.h"
#include "replay/tape.h"

#include <stdbool.h>
#include <stdio.h>

#define MOTION_HTML_BUILD_SIZE (4U * sizeof((recording_header_t *)0)->build)

typedef struct {
    FILE *file;
    const robot_t *robot;
    char build[MOTION_HTML_BUILD_SIZE]; /**< That recorded it. */
    telemetry_identity_t identity;
    telemetry_view_t view;
    pace_t pace;
    tape_t tape;
    uint32_t drives; /**< Another number with each other drive. */
    uint32_t rows;
    uint64_t started_us;
    bytes_t row;
    bytes_t events;
} motion_html_t;

/** How the replay went. */
typedef struct {
    uint64_t replayed;    /**< Cycles whose outputs were equal. */
    uint64_t unreplayed;  /**< Cycles without a checkpoint before them. */
    uint32_t cycles_lost; /**< Before the file. */
    bool is_cut_short;
    bool is_trusted;        /**< It held what it announced. */
    const char *difference; /**< A sentence; "": there is none. */
} motion_html_proof_t;

/** Begins the page. */
void motion_html_begin(motion_html_t *self, FILE *file, const robot_t *robot,
                       const recording_header_t *header);

/**
 * Takes a cycle; `shown`: what it said, NULL: nobody knows.
 *
 * @satisfies SWR-REPLAY-015
 * @satisfies SWR-REPLAY-016
 * @satisfies SWR-REPLAY-020
 */
void motion_html_take(motion_html_t *self, const recording_header_t *header,
                      const cycle_record_t *record, const controller_outputs_t *shown);

/**
 * Ends the page. False: not all of it could be written.
 *
 * @satisfies SWR-REPLAY-017
 */
bool motion_html_end(motion_html_t *self, const motion_html_proof_t *proof);

#endif

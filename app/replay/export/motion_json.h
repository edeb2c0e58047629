/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Recorded motion as the JSON that the page of a recording reads (app/console/src/replay). It holds
 * the messages that the console would have got, and the frames that left to the cards: each state,
 * word and flag, and the drive command of a card, in each cycle in which it changes; numbers each
 * so many cycles as it states itself, and in each with an event. From an unknown cycle until the
 * next known one it holds null.
 */
#ifndef BORESIGHT_MOTION_JSON_H
#define BORESIGHT_MOTION_JSON_H

#include "http/view/telemetry_json.h"
#include "replay/data/bytes.h"
#include "replay/data/pace.h"
#include "replay/data/tape.h"
#include "replay/verify/walk.h"

#include <stdbool.h>
#include <stdio.h>

#define MOTION_JSON_BUILD_SIZE (4U * sizeof((recording_header_t *)0)->build)

typedef struct {
    FILE *file;
    const robot_t *robot;
    char build[MOTION_JSON_BUILD_SIZE]; /**< That recorded it. */
    telemetry_identity_t identity;
    telemetry_view_t view;
    pace_t pace;
    tape_t tape;
    uint32_t drives; /**< Another number with each other drive. */
    uint32_t rows;
    bool is_known; /**< The last row is no null. */
    uint32_t next; /**< The cycle after the last one that is known. */
    uint64_t started_us;
    bytes_t row;
    bytes_t events;
} motion_json_t;

/** Begins the document of the recording that `walk` has open. */
void motion_json_begin(motion_json_t *self, FILE *file, const walk_t *walk);

/**
 * Takes a cycle into the motion_json_t at `to`, as walk_reporter_t says.
 *
 * @satisfies SWR-REPLAY-015
 * @satisfies SWR-REPLAY-016
 * @satisfies SWR-REPLAY-020
 * @satisfies SWR-REPLAY-021
 */
void motion_json_take(walk_t *walk, void *to, const controller_outputs_t *shown);

/**
 * Ends the document. `code` is what walk_report() said.
 *
 * @satisfies SWR-REPLAY-017
 */
void motion_json_end(motion_json_t *self, const walk_t *walk, int code);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Recorded motion as an MCAP file. Channels of JSON, each with its schema:
 *
 *     /state         what is of no axis and no card
 *     /axes/NAME     an axis
 *     /cards/SLOT    a card that the robot names
 *     /frames/SLOT   what leaves to it
 *     /events        events, as Foxglove's log wants them
 *
 * and a note, "recording", of where it is from.
 */
#ifndef BORESIGHT_MOTION_MCAP_H
#define BORESIGHT_MOTION_MCAP_H

#include "replay/export/mcap.h"
#include "replay/data/pace.h"
#include "replay/data/source.h"

typedef struct {
    mcap_t file;
    const robot_t *robot;
    source_t sources[SOURCES];
    uint32_t count;
    uint16_t channels[SOURCES];
    uint16_t frames[CARD_SLOT_COUNT];
    uint16_t events;
    pace_t pace;
    bytes_t message;
} motion_mcap_t;

/** Begins the file. False: there is no room for its index. */
bool motion_mcap_begin(motion_mcap_t *self, FILE *file, const robot_t *robot);

/**
 * Takes a cycle: writes its events, and its outputs if it is its turn; `shown`: those, NULL:
 * unknown.
 *
 * @satisfies SWR-REPLAY-010
 */
void motion_mcap_take(motion_mcap_t *self, const recording_header_t *header,
                      const cycle_record_t *record, const controller_outputs_t *shown);

/**
 * Ends the file, and says in it of which run it is, how the recording ended and how many cycles
 * before it were lost.
 * False: there was no room for its index.
 *
 * @satisfies SWR-REPLAY-012
 */
bool motion_mcap_end(motion_mcap_t *self, const recording_header_t *header, bool is_cut_short,
                     uint32_t cycles_lost);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file A recording, gone through from its first record to its last, and what is said of that. */
#ifndef BORESIGHT_WALK_H
#define BORESIGHT_WALK_H

#include "recording/recording_reader.h"
#include "replay/replay.h"

#include <stdio.h>

/** Exit codes of the program; replay_main.c says when. */
#define EXIT_EQUAL 0
#define EXIT_DIFFERENT 1
#define EXIT_REFUSED 2
#define EXIT_CUT_SHORT 3

#define WALK_SENTENCE 256U

typedef struct {
    const robot_t *robot;
    bool is_cut_short;
    recording_reader_t reader;
    replay_t replay;
    cycle_record_t record; /**< The last one that was taken. */
    cycle_known_t known;
    uint64_t taken;                 /**< Records. */
    char difference[WALK_SENTENCE]; /**< The first one; "" for none. */
} walk_t;

/** What is done with a cycle; `shown`: what it said, NULL where it was neither replayed nor kept
 * whole. */
typedef void walk_teller_t(walk_t *self, void *to, const controller_outputs_t *shown);

/** The next record; false at the end. */
bool walk_take(walk_t *self);

/** Executes the record, a cycle. False: its outputs differ. */
bool walk_replay(walk_t *self);

/** After the last record: says when the blocks do not hold what they announce. */
bool walk_check_end(const walk_t *self);

/** Says where the outputs differ. The exit code. */
int walk_tell_difference(walk_t *self, FILE *where);
void walk_tell_unreplayed(const walk_t *self, FILE *where);
void walk_tell_lost(const walk_t *self, FILE *where);

#define WALK_GOES_ON (-1) /**< There is no exit code yet. */

/** Replays the next record and tells it when it is a cycle. The exit code after the last one, else
 * WALK_GOES_ON. */
int walk_tell_next(walk_t *self, walk_teller_t *tell, void *to);

/** Tells each cycle as it is replayed. The exit code. */
int walk_tell(walk_t *self, walk_teller_t *tell, void *to);

#endif

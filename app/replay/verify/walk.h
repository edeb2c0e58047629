/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A recording, or those of a run one after the other, gone through from the first record to the
 * last, and what is said of that.
 */
#ifndef BORESIGHT_WALK_H
#define BORESIGHT_WALK_H

#include "recording/read/recording_reader.h"
#include "replay/verify/again.h"
#include "replay/verify/coverage.h"
#include "replay/verify/replay.h"

#include <stdio.h>

/** Exit codes of the program; replay_main.c says when. */
#define EXIT_EQUAL 0
#define EXIT_DIFFERENT 1
#define EXIT_REFUSED 2
#define EXIT_PART 3

#define WALK_SENTENCE 256U

typedef struct {
    const robot_t *robot; /**< NULL: nothing was opened. */
    bool is_of_run;       /**< All recordings of a run, not one alone. */
    FILE *notes;          /**< Where it says what is missing. */
    uint32_t recordings;  /**< That were opened. */
    bool is_cut_short;    /**< The present one is. */
    bool has_run_end;     /**< The run ends with one of them. */
    recording_reader_t reader;
    const char *path;
    replay_t replay;
    again_t again;
    bool is_again;      /**< The last record is of what was computed before. */
    bool had_end;       /**< The run ends with a recording before the present one, */
    bool is_behind_end; /**< and yet cycles follow. */
    coverage_t coverage;
    cycle_record_t record; /**< The last one that was taken. */
    cycle_known_t known;
    uint64_t taken;                 /**< Records of the present recording. */
    char difference[WALK_SENTENCE]; /**< The first one; "" for none. */
} walk_t;

/** The act on a cycle; `shown`: its outputs, NULL where it was neither replayed nor kept whole. */
typedef void walk_reporter_t(walk_t *self, void *to, const controller_outputs_t *shown);

/** Begins with nothing open; `notes` is where it says what is missing. */
void walk_begin(walk_t *self, bool is_of_run, FILE *notes);

/**
 * Opens the recording `path`, which lives as long, and goes on with the one before. False, after a
 * sentence on the standard error: it is refused.
 *
 * @satisfies SWR-REPLAY-039
 */
bool walk_open(walk_t *self, const char *path);
void walk_close(walk_t *self);

/** The next record of the present recording; false at its end. */
bool walk_take(walk_t *self);

/** Executes the record, a cycle, or compares it, a checkpoint. False: it differs. */
bool walk_replay(walk_t *self);

/** Whether the last record was executed, or, there again, compared. */
bool walk_is_done(const walk_t *self);

/** Counts the record, if it is a cycle, as one that is there. False: it was there before, or is no
 * cycle. */
bool walk_count(walk_t *self, bool is_done);

/** After the last record: says when the blocks do not hold what they announce. */
bool walk_check_end(const walk_t *self);

/** Whether each cycle from 0 to the end of the run was replayed. */
bool walk_is_whole_run(const walk_t *self);

/** After the last recording: says what is missing. EXIT_EQUAL, or EXIT_PART if something is of what
 * was to be gone through: of a run, or of the recording alone. */
int walk_end(walk_t *self);

/** Says where the outputs differ. The exit code. */
int walk_report_difference(walk_t *self, FILE *where);

/** For a recording alone: prints the number of cycles that its recorder has lost before it. */
void walk_report_lost(const walk_t *self);

#define WALK_GOES_ON (-1) /**< There is no exit code yet. */

/** The act on each recording in its turn: WALK_GOES_ON, or the exit code. */
typedef int walk_part_t(walk_t *self);

/** Replays the next record and calls `report` when it is a cycle that was not there before. The
 * exit code after the last one of a recording alone, else WALK_GOES_ON. */
int walk_report_next(walk_t *self, walk_reporter_t *report, void *to);

/** Calls `report` for each cycle of the recording, alone, as it is replayed. The exit code. */
int walk_report(walk_t *self, walk_reporter_t *report, void *to);

/** The same of the present one of several: WALK_GOES_ON at its end. */
int walk_report_part(walk_t *self, walk_reporter_t *report, void *to);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A rig whose cycles are recorded as the recorder does, in simulated time: the same file on every
 * run. Only the lateness of the cycles is left to a machine; here some microseconds, by chance.
 */
#ifndef BORESIGHT_RECORDED_H
#define BORESIGHT_RECORDED_H

#include "integration/support/rig.h"
#include "recording/write/recording_writer.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    rig_t *rig;
    recording_writer_t writer;
    cycle_record_t record;
    uint32_t noise;
    uint64_t begun_bytes; /**< Bytes of the file when recorded_count() began, */
    uint64_t begun_cycles;
    uint64_t cycles; /**< recorded so far. */
} recorded_t;

/** Begins the file `path` with a checkpoint of `rig`, whose next cycle is the first of it. */
bool recorded_begin(recorded_t *self, rig_t *rig, const char *path);

/** Runs and records. False when the disk is full. */
bool recorded_cycles(recorded_t *self, uint32_t count);

/** Runs and records until the pending command is answered for good, at most `most` cycles. */
bool recorded_finish(recorded_t *self, uint32_t most);

/** Queues a command for the next cycle. */
void recorded_workphase(recorded_t *self, workphase_t workphase);

/** From here on it is counted. */
bool recorded_count(recorded_t *self);

/** Bytes of the file for each cycle since then. */
double recorded_bytes_per_cycle(recorded_t *self);

/** The same in MB an hour. */
double recorded_mb_per_h(recorded_t *self);

bool recorded_end(recorded_t *self);

/** Calls `work` with the table of each robot of this build. @return how many there are */
uint32_t recorded_each_robot(void (*work)(const robot_t *robot));

/** Scenes, counted without what leads to them; the file is still open. Rest; a homing from its
 * first drive to its end; of the NeuroRobot the rest of a move to a target. */
void recorded_rest(recorded_t *self, rig_t *rig, const robot_t *robot, const char *path);
void recorded_homing(recorded_t *self, rig_t *rig, const robot_t *robot, const char *path);
void recorded_move(recorded_t *self, rig_t *rig, const char *path);

#endif

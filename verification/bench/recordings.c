/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * bench-recordings: how large recordings are, of each robot at rest and in motion, in simulated
 * time: the same figures on every run.
 *
 *     bench-recordings FILE
 *
 * Standard output has one line for each, tabulated: robot, scene, cycles, bytes of the file, bytes
 * of what was recorded, limit in MB an hour. FILE is written again and again.
 */
#include "base/contract.h"
#include "integration/support/recorded.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include "unity.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

static rig_t rig;
static recorded_t recorded;
static const char *path;

void setUp(void)
{
}

void tearDown(void)
{
}

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "Contract %s/%" PRIu32 " is broken.\n", module, id);
    _Exit(EXIT_FAILURE);
}

static void print(const robot_t *robot, const char *scene, uint32_t limit_mb_per_h)
{
    const uint64_t cycles = recorded.cycles - recorded.begun_cycles;
    const double bytes = recorded_bytes_per_cycle(&recorded) * (double)cycles;

    (void)printf(
        "%s\t%s\t%" PRIu64 "\t%.0f\t%" PRIu64 "\t%" PRIu32 "\n", robot->name, scene, cycles, bytes,
        cycles * (sizeof(controller_inputs_t) + sizeof(controller_outputs_t)), limit_mb_per_h);
    (void)recorded_end(&recorded);
}

static void play(const robot_t *robot)
{
    recorded_rest(&recorded, &rig, robot, path);
    print(robot, "rest", LIMIT_RECORDING_REST_MB_PER_H);
    recorded_homing(&recorded, &rig, robot, path);
    print(robot, "homing", LIMIT_RECORDING_MOTION_MB_PER_H);
}

int main(int count, char **arguments)
{
    if (count != 2) {
        (void)fputs("usage: bench-recordings FILE\n", stderr);
        return EXIT_FAILURE;
    }
    path = arguments[1];
    UnityBegin("recordings.c");
    (void)recorded_each_robot(play);
    recorded_move(&recorded, &rig, path);
    print(&robot_neuro, "move", LIMIT_RECORDING_MOTION_MB_PER_H);
    return EXIT_SUCCESS;
}

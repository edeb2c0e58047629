/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Plays random scenes and prints a line for each, by which two builds are compared.
 *
 *     digests ROBOT PLAY FIRST COUNT CYCLES
 *
 * PLAY is one of PLAY_NAMES; the scenes are those of the seeds FIRST to FIRST + COUNT - 1, each of
 * CYCLES cycles. A line is `ROBOT PLAY SEED CYCLES DIGEST`: its first four words are the scene, the
 * last one is chained over frames, answers and events of all its cycles, so that a difference in
 * any cycle stays. Ends with 2 for a wrong command line and with 3 when the robot cannot give the
 * play.
 */
#include "digests/digest.h"
#include "robot/app/robots.h"
#include "supervise/scenario/scenario.h"

#include "unity.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#define WRONG 2
#define REFUSED 3
#define ARGUMENTS 6

static struct {
    rig_t rig;
    scenario_t scenario;
    digest_t digest;
} scene;

void setUp(void)
{
}

void tearDown(void)
{
}

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "contract %s/%" PRIu32 " is broken in cycle %" PRIu32 "\n", module, id,
                  scene.scenario.cycle);
    exit(EXIT_FAILURE);
}

static void play_scene(const robot_t *robot, play_t play, uint32_t seed, uint32_t cycles)
{
    scenario_begin(&scene.scenario, &scene.rig, robot, play, seed);
    digest_begin(&scene.digest);
    for (uint32_t i = 0U; i < cycles; i++) {
        scenario_play(&scene.scenario, &scene.rig);
        rig_cycle(&scene.rig);
        digest_add(&scene.digest, &scene.rig.outputs);
    }
}

static uint32_t number(const char *text)
{
    return (uint32_t)strtoul(text, NULL, 10);
}

/* The rig asserts what it needs to set a scene. */
static int play_all(const robot_t *robot, play_t play, char **arguments)
{
    const uint32_t first = number(arguments[3]);
    const uint32_t count = number(arguments[4]);
    const uint32_t cycles = number(arguments[5]);
    UnityBegin("digests.c");
    if (!TEST_PROTECT()) {
        return EXIT_FAILURE;
    }
    for (uint32_t i = 0U; i < count; i++) {
        play_scene(robot, play, first + i, cycles);
        (void)printf("%s %s %" PRIu32 " %" PRIu32 " %016" PRIx64 "\n", robot->name, arguments[2],
                     first + i, cycles, scene.digest.hash);
    }
    return EXIT_SUCCESS;
}

int main(int count, char **arguments)
{
    const robot_t *const robot = (count == ARGUMENTS) ? robots_find(arguments[1]) : NULL;
    const int play = (count == ARGUMENTS) ? play_find(arguments[2]) : -1;
    if ((robot == NULL) || (play < 0)) {
        (void)fprintf(stderr,
                      "usage: digests ROBOT PLAY FIRST COUNT CYCLES, PLAY one of " PLAY_NAMES "\n");
        return WRONG;
    }
    const char *const refusal = play_refusal(robot, (play_t)play);
    if (refusal != NULL) {
        (void)fprintf(stderr, "The robot %s cannot give this play: %s.\n", robot->name, refusal);
        return REFUSED;
    }
    return play_all(robot, (play_t)play, arguments);
}

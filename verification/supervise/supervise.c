/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The real controller on the simulated control box, in simulated time, with an operator, a world
 * and faults by chance, and a witness who knows where the axes truly stand.
 *
 *     supervise COUNT [SEED [random|corners|interrupted|spread|jogs|taps|magnitude|flips]]
 *
 * Plays COUNT scenes from SEED on (1), or as many as COUNT moves need. Prints how often each
 * sentence was broken, where first, and the worst figure. Ends with 1 when one was broken. With
 * "taps" also tells the enemy's plan of each such scene. With "flips", COUNT times up to 3 bits of
 * a word of the controller's memory change in random scenes.
 */
#include "robot/robot_neuro.h"
#include "supervise/flips.h"
#include "supervise/scene.h"

#include "unity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SCENE_CYCLES 20000U
#define FLIPS 7 /* After the plays of a stage. */
#define TAPS_CYCLES 40000U
#define PLAN_SIZE 256U
#define MOVES_CYCLES 120000U /* Of a scene that is all moves. */

static scene_t scene;

void setUp(void)
{
}

void tearDown(void)
{
}

void contract_broken(const char *module, uint32_t id)
{
    printf("contract %s/%u is broken in scene %u, cycle %u\n", module, (unsigned)id,
           (unsigned)scene.witness.seed, (unsigned)scene.stage.cycle);
    exit(2);
}

/* COUNT is of scenes, not of moves. */
static bool is_of_scenes(play_t play)
{
    return (play == PLAY_RANDOM) || (play == PLAY_JOGS) || (play == PLAY_TAPS);
}

static uint32_t cycles_of(play_t play)
{
    const uint32_t cycles = is_of_scenes(play) ? SCENE_CYCLES : MOVES_CYCLES;
    return (play == PLAY_TAPS) ? TAPS_CYCLES : cycles;
}

static void play_scene(play_t play, uint32_t seed)
{
    scene_begin(&scene, play, seed);
    for (uint32_t i = 0U; i < cycles_of(play); i++) {
        scene_cycle(&scene);
    }
}

/* What the enemy of the scene `seed` does. */
static void tell_plan(uint32_t seed)
{
    char text[PLAN_SIZE];
    scene_begin(&scene, PLAY_TAPS, seed);
    foe_describe(&scene.stage.foe, text, sizeof text);
    printf("    scene %u: %s\n", (unsigned)seed, text);
}

static void report_endings(ending_t ending, const char *words)
{
    const witness_t *const witness = &scene.witness;
    const uint32_t latest = witness_late(witness, ending, 99U);
    printf("%u %s, done after their profiles: half of them by %u ms, 99 %% by %u ms, %s\n",
           (unsigned)witness->endings[ending].count, words,
           (unsigned)witness_late(witness, ending, 50U), (unsigned)latest,
           (latest <= (LIMIT_DONE_TIME_US / LIMIT_CYCLE_US)) ? "in time" : "late");
}

static bool report(play_t play, uint32_t count)
{
    bool is_good = true;
    printf("%u scenes\n", (unsigned)count);
    report_endings(ENDING_MOVE, "moves");
    report_endings(ENDING_NON_PWM, "legs with axes without pwm");
    for (uint32_t i = 0U; i < SENTENCE_COUNT; i++) {
        const verdict_t *const verdict = &scene.witness.verdicts[i];
        printf("%-70s ", witness_sentence((sentence_t)i));
        if (verdict->episodes == 0U) {
            printf("holds\n");
        } else {
            is_good = false;
            printf("broken in %u, first in scene %u, cycle %u, axis %s; worst %.3f\n",
                   (unsigned)verdict->episodes, (unsigned)verdict->seed, (unsigned)verdict->cycle,
                   robot_neuro.axes[verdict->axis].name, verdict->worst);
            if (play == PLAY_TAPS) {
                tell_plan(verdict->seed);
            }
        }
    }
    return is_good;
}

/* Number of the play `name`, or -1. */
static int play_of(const char *name)
{
    static const char *const names[] = {"random", "corners", "interrupted", "spread",
                                        "jogs",   "taps",    "magnitude",   "flips"};
    for (int i = 0; i < 8; i++) {
        if (strcmp(name, names[i]) == 0) {
            return i;
        }
    }
    return -1;
}

int main(int count, char **arguments)
{
    const uint32_t wanted = (count > 1) ? (uint32_t)strtoul(arguments[1], NULL, 10) : 0U;
    const uint32_t first = (count > 2) ? (uint32_t)strtoul(arguments[2], NULL, 10) : 1U;
    const int play = (count > 3) ? play_of(arguments[3]) : (int)PLAY_RANDOM;
    uint32_t scenes = 0U;
    if ((wanted == 0U) || (play < 0)) {
        (void)fprintf(stderr, "usage: supervise COUNT [SEED "
                              "[random|corners|interrupted|spread|jogs|taps|magnitude|flips]]\n");
        return 2;
    }
    UnityBegin("supervise.c");
    if (play == FLIPS) {
        return flips_play(&scene, wanted, first) ? 0 : 1;
    }
    while ((is_of_scenes((play_t)play) ? scenes : scene.witness.endings[ENDING_MOVE].count) <
           wanted) {
        play_scene((play_t)play, first + scenes);
        scenes++;
    }
    return report((play_t)play, scenes) ? 0 : 1;
}

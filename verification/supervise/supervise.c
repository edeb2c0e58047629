/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The real controller on the simulated control box, in simulated time, with an operator, a world
 * and faults by chance, and a witness who knows where the axes truly stand.
 *
 *     supervise COUNT [SEED]
 *
 * Plays COUNT scenes from SEED on (1). Prints how often each sentence was broken, where first, and
 * the worst figure. Ends with 1 when one was broken.
 */
#include "stage.h"
#include "witness.h"

#include "unity.h"

#include <stdio.h>
#include <stdlib.h>

#define SCENE_CYCLES 20000U

static rig_t rig;
static stage_t stage;
static witness_t witness;

void setUp(void)
{
}

void tearDown(void)
{
}

void contract_broken(const char *module, uint32_t id)
{
    printf("contract %s/%u is broken in scene %u, cycle %u\n", module, (unsigned)id,
           (unsigned)witness.seed, (unsigned)stage.cycle);
    exit(2);
}

static void play(uint32_t seed)
{
    double truth[ROBOT_AXIS_COUNT];
    witness_begin(&witness, seed);
    stage_begin(&stage, &rig, seed);
    for (uint32_t i = 0U; i < SCENE_CYCLES; i++) {
        stage_play(&stage, &rig);
        box_true_positions(&rig.box, truth);
        rig_cycle(&rig);
        witness_look(&witness, &rig, truth);
    }
}

static bool report(uint32_t count)
{
    bool is_good = true;
    printf("%u scenes of %u s\n", (unsigned)count, SCENE_CYCLES / 1000U);
    for (uint32_t i = 0U; i < SENTENCE_COUNT; i++) {
        const verdict_t *const verdict = &witness.verdicts[i];
        printf("%-70s ", witness_sentence((sentence_t)i));
        if (verdict->episodes == 0U) {
            printf("holds\n");
        } else {
            is_good = false;
            printf("broken in %u, first in scene %u, cycle %u, axis %s; worst %.3f\n",
                   (unsigned)verdict->episodes, (unsigned)verdict->seed, (unsigned)verdict->cycle,
                   robot_neuro.axes[verdict->axis].name, verdict->worst);
        }
    }
    return is_good;
}

int main(int count, char **arguments)
{
    const uint32_t scenes = (count > 1) ? (uint32_t)strtoul(arguments[1], NULL, 10) : 0U;
    const uint32_t first = (count > 2) ? (uint32_t)strtoul(arguments[2], NULL, 10) : 1U;
    if (scenes == 0U) {
        (void)fprintf(stderr, "usage: supervise COUNT [SEED]\n");
        return 2;
    }
    UnityBegin("supervise.c");
    for (uint32_t i = 0U; i < scenes; i++) {
        play(first + i);
    }
    return report(scenes) ? 0 : 1;
}

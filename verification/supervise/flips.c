/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/flips.h"

#include "supervise/scenario/prng.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#define FLIPS_PER_SCENE 20U
#define CYCLES_BETWEEN 390U
#define TIMEOUT_CYCLES 3000U /* Until something moves. */
#define CYCLES_AFTER 4000U
#define TABLE_SHARE 5U /* Every fifth flip hits the table. */
#define BITS_MOST 3U

/* How a flip ended; a broken sentence adds its number to FLIP_WRONG. */
typedef enum { FLIP_HARMLESS = 0, FLIP_NOTICED = 1, FLIP_CONTRACT = 2, FLIP_WRONG = 10 } flip_end_t;

typedef struct {
    uint32_t harmless;
    uint32_t noticed;
    uint32_t wrong;
    uint32_t crashed;
} flip_count_t;

typedef struct {
    bool is_table;
    bool is_moving;
    uint32_t byte; /* Byte of the word. */
    uint32_t mask;
} flip_t;

static flip_t some_flip(uint32_t *random, const scene_t *scene)
{
    flip_t flip = {.is_table = prng_below(random, TABLE_SHARE) == 0U,
                   .is_moving = rig_is_driving(&scene->rig)};
    const controller_t *const controller = &scene->rig.controller;
    const size_t held = CONTROLLER_CHECKPOINT_BYTES +
                        (controller->mode.sealed.list.count * sizeof controller->rows[0]);
    const size_t size = flip.is_table ? sizeof scene->rig.robot : held;
    flip.byte = 4U * prng_below(random, (uint32_t)(size / 4U));
    const uint32_t bits = 1U + prng_below(random, BITS_MOST);
    for (uint32_t i = 0U; i < bits; i++) {
        flip.mask |= (uint32_t)1U << prng_below(random, 32U);
    }
    return flip;
}

static void do_flip(rig_t *rig, const flip_t *flip)
{
    uint8_t *const bytes = flip->is_table ? (uint8_t *)&rig->robot : (uint8_t *)&rig->controller;
    uint32_t word = 0U;
    (void)memcpy(&word, &bytes[flip->byte], sizeof word);
    word ^= flip->mask;
    (void)memcpy(&bytes[flip->byte], &word, sizeof word);
}

static bool is_noticed(const rig_t *rig)
{
    return (rig_count(rig, EVENT_MEMORY_DAMAGED) + rig_count(rig, EVENT_ROBOT_TABLE_DAMAGED) +
            rig_count(rig, EVENT_CHART_REPAIRED)) != 0U;
}

/* The life of the process with the flip; ends it. */
static void go_on(scene_t *scene, const flip_t *flip)
{
    /* The others speak of how what was lost is found again. */
    static const sentence_t judged[] = {SENTENCE_PERMIT, SENTENCE_BELIEVED, SENTENCE_OFF,
                                        SENTENCE_REACHED};
    int end = (int)FLIP_HARMLESS;
    bool is_seen = false;
    motion_oracle_forgive(&scene->oracle);
    do_flip(&scene->rig, flip);
    for (uint32_t i = 0U; i < CYCLES_AFTER; i++) {
        rig_forget(&scene->rig);
        scene_cycle(scene);
        is_seen = is_seen || is_noticed(&scene->rig);
    }
    end = is_seen ? (int)FLIP_NOTICED : (int)FLIP_HARMLESS;
    for (uint32_t i = 0U; i < (sizeof judged / sizeof judged[0]); i++) {
        end = scene->oracle.is_broken[judged[i]] ? ((int)FLIP_WRONG + (int)judged[i]) : end;
    }
    _exit(end);
}

static void report_flip(const scene_t *scene, const flip_t *flip, const char *what)
{
    printf("scene %u, cycle %u, %s, byte %u of the %s, bits %08X: %s\n",
           (unsigned)scene->oracle.seed, (unsigned)scene->scenario.cycle,
           flip->is_moving ? "moving" : "at rest", (unsigned)flip->byte,
           flip->is_table ? "table" : "state", (unsigned)flip->mask, what);
}

static void judge(flip_count_t *count, const scene_t *scene, const flip_t *flip, int status)
{
    const int end = WIFEXITED(status) ? WEXITSTATUS(status) : (int)FLIP_CONTRACT;
    if (end == (int)FLIP_NOTICED) {
        count->noticed++;
    } else if (end == (int)FLIP_HARMLESS) {
        count->harmless++;
    } else if (end >= (int)FLIP_WRONG) {
        count->wrong++;
        report_flip(scene, flip, motion_oracle_sentence((sentence_t)(end - (int)FLIP_WRONG)));
    } else {
        count->crashed++;
        report_flip(scene, flip, WIFEXITED(status) ? "a contract is broken" : "crashed");
    }
}

static void branch(flip_count_t counts[2], scene_t *scene, uint32_t *random)
{
    const flip_t flip = some_flip(random, scene);
    int status = 0;
    (void)fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        go_on(scene, &flip);
    }
    if ((child < 0) || (waitpid(child, &status, 0) != child)) {
        perror("supervise flips");
        exit(2);
    }
    judge(&counts[flip.is_moving ? 1 : 0], scene, &flip, status);
}

/* Every other flip comes in motion, if the scene has any soon. */
static void approach(scene_t *scene, bool is_to_move)
{
    for (uint32_t i = 0U; i < CYCLES_BETWEEN; i++) {
        scene_cycle(scene);
    }
    for (uint32_t i = 0U; is_to_move && (i < TIMEOUT_CYCLES) && !rig_is_driving(&scene->rig); i++) {
        scene_cycle(scene);
    }
}

static bool report(const flip_count_t *count, const char *when)
{
    const uint32_t all = count->noticed + count->harmless + count->wrong + count->crashed;
    printf("%-10s %5u flips: %5u noticed, %5u harmless, %u wrong, %u crashed\n", when,
           (unsigned)all, (unsigned)count->noticed, (unsigned)count->harmless,
           (unsigned)count->wrong, (unsigned)count->crashed);
    return (count->wrong + count->crashed) == 0U;
}

bool flips_play(scene_t *scene, const robot_t *robot, uint32_t count, uint32_t seed)
{
    flip_count_t counts[2] = {0};
    uint32_t random = (seed * 2654435761U) | 1U;
    for (uint32_t done = 0U; done < count; done++) {
        if ((done % FLIPS_PER_SCENE) == 0U) {
            scene_begin(scene, robot, PLAY_RANDOM, seed + (done / FLIPS_PER_SCENE));
            scene->scenario.fault_cycle = UINT32_MAX; /* Nothing but the memory is at fault. */
        }
        approach(scene, (done % 2U) != 0U);
        branch(counts, scene, &random);
    }
    const bool is_rest_good = report(&counts[0], "at rest");
    return report(&counts[1], "moving") && is_rest_good;
}

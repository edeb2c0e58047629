/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The real controller on the simulated control box, in simulated time, with an operator, a world
 * and faults by chance, and an oracle that knows where the axes truly stand.
 *
 *     supervise [--robot NAME] COUNT [SEED [PLAY]], PLAY one of PLAY_NAMES
 *
 * Plays COUNT scenes from SEED on (1), or as many as COUNT moves need. Prints how often each
 * sentence was broken, where first, and the worst figure. Ends with 1 when one was broken, with 3
 * when the robot cannot give the play. With "taps" also prints the enemy's plan of each such scene.
 * With "flips", COUNT times up to 3 bits of a word of the controller's memory change in random
 * scenes.
 */
#include "interface/app/names.h"
#include "robot/app/robot_names.h"
#include "robot/app/robots.h"
#include "supervise/flips.h"
#include "supervise/recovery.h"
#include "supervise/scene.h"

#include "unity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SCENE_CYCLES 20000U
#define TAPS_CYCLES 40000U
#define PLAN_SIZE 256U
#define MOVES_CYCLES 120000U /* Length of a scene that is all moves. */
#define LONG_WAY_MS 15000    /* A robot with a longer one at full speed has longer scenes. */
#define BROKEN 1
#define UNPLAYED 2
#define REFUSED 3

static const robot_t *robot;
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
           (unsigned)scene.oracle.seed, (unsigned)scene.scenario.cycle);
    exit(2);
}

/* How many times as long as those of the quickest robots. */
static uint32_t slowness(void)
{
    int64_t longest_ms = 1;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const axis = &robot->axes[i];
        const int64_t way_ticks = (int64_t)axis->maximum_ticks - axis->minimum_ticks;
        const int64_t way_ms = way_ticks * 1000 / axis->speed_ticks_per_s;
        longest_ms = (way_ms > longest_ms) ? way_ms : longest_ms;
    }
    return (uint32_t)((longest_ms + LONG_WAY_MS - 1) / LONG_WAY_MS);
}

static uint32_t cycles_of(play_t play)
{
    const bool is_short = play_is_of_scenes(play) && !play_is_of_orders(play);
    const uint32_t cycles = (is_short || (play == PLAY_LATE)) ? SCENE_CYCLES : MOVES_CYCLES;
    return slowness() * ((play == PLAY_TAPS) ? TAPS_CYCLES : cycles);
}

static void play_scene(play_t play, uint32_t seed)
{
    scene_begin(&scene, robot, play, seed);
    for (uint32_t i = 0U; i < cycles_of(play); i++) {
        scene_cycle(&scene);
    }
}

/* Prints the acts of the enemy of the scene `seed`. */
static void report_plan(uint32_t seed)
{
    char text[PLAN_SIZE];
    scene_begin(&scene, robot, PLAY_TAPS, seed);
    adversary_describe(&scene.scenario.adversary, text, sizeof text);
    printf("    scene %u: %s\n", (unsigned)seed, text);
}

static void report_endings(ending_t ending, const char *words)
{
    const motion_oracle_t *const oracle = &scene.oracle;
    const uint32_t latest = motion_oracle_late(oracle, ending, 99U);
    printf("%u %s, done after their profiles: half of them by %u ms, 99 %% by %u ms, %s\n",
           (unsigned)oracle->endings[ending].count, words,
           (unsigned)motion_oracle_late(oracle, ending, 50U), (unsigned)latest,
           (latest <= (LIMIT_DONE_TIME_US / LIMIT_CYCLE_US)) ? "in time" : "late");
}

static void report_losses(void)
{
    uint32_t losses[AUTHORITY_LOSSES];
    for (uint32_t i = 0U; i < AUTHORITY_LOSSES; i++) {
        losses[i] = scene.oracle.losses[i] + scene.oracle.authority_oracle.losses[i];
    }
    printf(
        "authority was lost: %u times released, %u not renewed, %u in silence, %u taken; %u in "
        "motion\n",
        (unsigned)losses[AUTHORITY_LOSS_RELEASED], (unsigned)losses[AUTHORITY_LOSS_UNRENEWED],
        (unsigned)losses[AUTHORITY_LOSS_SILENT], (unsigned)losses[AUTHORITY_LOSS_TAKEN],
        (unsigned)(scene.oracle.losses_in_motion + scene.oracle.authority_oracle.losses_in_motion));
}

static void report_orders(void)
{
    const char *separator = "orders that were done:";
    for (uint32_t i = 0U; i < COMMAND_KIND_COUNT; i++) {
        const uint32_t armed = scene.oracle.armed[i] + scene.oracle.order_watch.armed[i];
        if (armed != 0U) {
            printf("%s %u of %u %s", separator,
                   (unsigned)(scene.oracle.done[i] + scene.oracle.order_watch.done[i]),
                   (unsigned)armed, command_kind_name((int32_t)i));
            separator = ",";
        }
    }
    printf("\n");
}

/* Effects of time and faults, beside the sentences. */
static const event_id_t late_events[] = {
    EVENT_LOOP_STOPPED,   EVENT_CARD_LOST,      EVENT_CARD_UNWELL,      EVENT_AXIS_REFERENCE_LOST,
    EVENT_AXIS_NO_COUNTS, EVENT_AXIS_WRONG_WAY, EVENT_AXIS_WRONG_SPEED, EVENT_AXIS_UNEVEN_COUNTS};

static const event_id_t hand_events[] = {EVENT_MEMBRANE_UNEXPECTED, EVENT_VIBRATION_BEGUN,
                                         EVENT_FORCE_DOUBTED, EVENT_MEMBRANES_UNSEEN};

static void report_found(const event_id_t ids[], uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        printf("%s %u %s", (i == 0U) ? "events:" : ",", (unsigned)scene.oracle.found[ids[i]],
               event_id_name((int32_t)ids[i]));
    }
    printf("\n");
}

static bool has_run_and_stop(void)
{
    bool has_it = false;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        has_it = has_it || (robot->axes[i].card_type == (uint8_t)CARD_TYPE_NON_PWM);
    }
    return has_it;
}

/* The subject of the broken sentence: an axis or a coupled limit. */
static void report_broken(sentence_t sentence, const verdict_t *verdict)
{
    const bool is_limit = sentence == SENTENCE_COUPLED;
    printf("broken in %u, first in scene %u, cycle %u, %s %s; worst %.3f\n",
           (unsigned)verdict->episodes, (unsigned)verdict->seed, (unsigned)verdict->cycle,
           is_limit ? "limit" : "axis",
           is_limit ? robot->coupled_limits[verdict->axis].name : robot->axes[verdict->axis].name,
           verdict->worst);
}

static bool report(play_t play, uint32_t count)
{
    bool is_good = true;
    printf("%u scenes\n", (unsigned)count);
    report_losses();
    report_orders();
    if (play == PLAY_LATE) {
        report_found(late_events, (uint32_t)(sizeof late_events / sizeof late_events[0]));
    } else if (play == PLAY_HANDS) {
        report_found(hand_events, (uint32_t)(sizeof hand_events / sizeof hand_events[0]));
    } else {
        /* Its sentences say all of it. */
    }
    report_endings(ENDING_MOVE, "moves");
    if (has_run_and_stop()) {
        report_endings(ENDING_NON_PWM, "legs with axes without pwm");
    }
    for (uint32_t i = 0U; i < SENTENCE_COUNT; i++) {
        const verdict_t *const verdict = &scene.oracle.verdicts[i];
        printf("%-70s ", motion_oracle_sentence((sentence_t)i));
        if (verdict->episodes == 0U) {
            printf("holds\n");
        } else {
            is_good = false;
            report_broken((sentence_t)i, verdict);
            if (play == PLAY_TAPS) {
                report_plan(verdict->seed);
            }
        }
    }
    return is_good;
}

static int play_all(int play, uint32_t wanted, uint32_t first)
{
    const char *const refusal = play_refusal(robot, (play_t)play);
    uint32_t scenes = 0U;
    if (refusal != NULL) {
        printf("The robot %s cannot give this play: %s.\n", robot->name, refusal);
        return REFUSED;
    }
    if (play == (int)PLAY_FLIPS) {
        return flips_play(&scene, robot, wanted, first) ? 0 : BROKEN;
    }
    if (play == (int)PLAY_OPERATOR) {
        const bool is_good = recovery_play(&scene, robot, wanted, first);
        return (report((play_t)play, wanted) && is_good) ? 0 : BROKEN;
    }
    /* A scene of moves has more than one. */
    while ((scenes < wanted) && (play_is_of_scenes((play_t)play) ||
                                 (scene.oracle.endings[ENDING_MOVE].count < wanted))) {
        play_scene((play_t)play, first + scenes);
        scenes++;
    }
    return report((play_t)play, scenes) ? 0 : BROKEN;
}

/* The rig asserts what it needs to set a scene. */
static int play_asserted(int play, uint32_t wanted, uint32_t first)
{
    int result = UNPLAYED;
    UnityBegin("supervise.c");
    if (TEST_PROTECT()) {
        result = play_all(play, wanted, first);
    } else {
        printf("scene %u of the robot %s cannot be set\n", (unsigned)scene.oracle.seed,
               robot->name);
    }
    return result;
}

int main(int count, char **arguments)
{
    const bool is_named = (count > 2) && (strcmp(arguments[1], "--robot") == 0);
    char **const rest = is_named ? &arguments[2] : arguments;
    const int left = is_named ? (count - 2) : count;
    const uint32_t wanted = (left > 1) ? (uint32_t)strtoul(rest[1], NULL, 10) : 0U;
    const uint32_t first = (left > 2) ? (uint32_t)strtoul(rest[2], NULL, 10) : 1U;
    const int play = (left > 3) ? play_find(rest[3]) : (int)PLAY_RANDOM;
    robot = robots_find(is_named ? arguments[2] : ROBOT_NAMES_DEFAULT);
    if ((wanted == 0U) || (play < 0) || (robot == NULL)) {
        (void)fprintf(stderr,
                      "usage: supervise [--robot NAME] COUNT [SEED [" PLAY_NAMES "]]\n"
                      "robots: %s\n",
                      robot_names_list());
        return UNPLAYED;
    }
    return play_asserted(play, wanted, first);
}

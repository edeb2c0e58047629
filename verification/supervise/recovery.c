/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/recovery.h"

#include "charts/loop_guard_chart.h"
#include "integration/support/refused_way.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "supervise/operator/operator.h"
#include "supervise/operator/operator_history.h"

#include <stdio.h>

#define BREAKS_LATER 3U /* Parts of the history: it breaks after a third. */
#define LATE_PARTS 4U   /* In one of so many scenes nothing breaks, and the loop is late. */
#define SETTLE_CYCLES 3U
#define ASTRAY 4U /* One of so many scenes begins where the way to the target is refused... */
#define BROKEN 8U /* ...and of them every other one breaks. */
#define NEXT_STEPS_MOST 64U
#define TRIES 100000U /* One of a thousand pairs is refused. */

/* A cycle without the players; the oracle looks on. */
static void pass(scene_t *scene)
{
    double truth[ROBOT_AXIS_MAX];
    box_true_positions(&scene->rig.box, truth);
    rig_cycle(&scene->rig);
    motion_oracle_look(&scene->oracle, &scene->rig, truth, true);
}

static uint32_t homed_axes(const rig_t *rig)
{
    uint32_t homed = 0U;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        homed |= axis_is_homed(&rig->controller.axes[i]) ? ((uint32_t)1U << i) : 0U;
    }
    return homed;
}

/* Late too often, so late that the cards switch off, or much later still. @return nothing was lost
 * by that */
static bool be_late(scene_t *scene, uint32_t seed)
{
    static const uint32_t late_us[] = {2000U, LIMIT_CARD_WATCHDOG_US, 300000U};
    static const uint32_t times[] = {LIMIT_OVERRUNS_IN_A_ROW, 1U, 1U};
    const uint32_t kind = (seed / LATE_PARTS) % (uint32_t)(sizeof times / sizeof times[0]);
    const uint32_t homed = homed_axes(&scene->rig);
    const uint32_t has_target = scene->rig.outputs.snapshot.has_target;
    for (uint32_t i = 0U; i < (times[kind] + SETTLE_CYCLES); i++) {
        scene->rig.late_us = (i < times[kind]) ? late_us[kind] : 0U;
        pass(scene);
    }
    return ((homed & ~homed_axes(&scene->rig)) == 0U) &&
           (scene->rig.outputs.snapshot.has_target == has_target) &&
           (scene->rig.outputs.snapshot.loop == (uint32_t)LOOP_GUARD_STATE_STOPPED);
}

/* The other players have left; the oracle stays. */
static void let_operator_act(scene_t *scene, operator_t *player)
{
    pass(scene);
    (void)operator_play(player, &scene->rig);
    if (player->has_started_anew) {
        player->has_started_anew = false;
        motion_oracle_begin(&scene->oracle, scene->oracle.seed);
    }
}

/* After jogs with a target set. @return false: of this robot, or in this scene, no way is refused
 */
static bool stand_astray(scene_t *scene, const robot_t *robot, uint32_t seed)
{
    static robot_t standing;
    refused_pair_t pair;
    uint32_t random = (seed * 2246822519U) | 1U;
    if (((seed % ASTRAY) != (ASTRAY / 2U)) || !refused_pair_draw(&pair, robot, &random, TRIES)) {
        return false;
    }
    refused_way_start(&pair, robot, &standing, &scene->rig);
    motion_oracle_begin(&scene->oracle, seed);
    if ((seed % BROKEN) >= ASTRAY) {
        operator_break(&scene->rig, seed);
    }
    return true;
}

/* @return nothing was lost by a loop that was late */
static bool play_history(scene_t *scene, const robot_t *robot, uint32_t seed)
{
    /* The enemy has its own fault: two that hide each other are none. */
    const bool is_adversarys = operator_history(seed, robot) == PLAY_TAPS;
    const bool is_late = !is_adversarys && ((seed % LATE_PARTS) == 0U);
    bool is_kept = true;
    const uint32_t cycles = operator_history_cycles(seed);
    scene_begin(scene, robot, operator_history(seed, robot), seed);
    for (uint32_t i = 0U; i < cycles; i++) {
        if ((i == (cycles / BREAKS_LATER)) && !is_adversarys && !is_late) {
            operator_break(&scene->rig, seed);
            scene->scenario.has_fault = 1U;
        }
        scene_cycle(scene);
    }
    if (is_late) {
        is_kept = be_late(scene, seed) || scenario_is_disturbed(&scene->scenario);
    }
    return is_kept;
}

static bool play_scene(scene_t *scene, const robot_t *robot, operator_t *player, uint32_t seed)
{
    const bool is_kept = stand_astray(scene, robot, seed) || play_history(scene, robot, seed);
    operator_begin(player, &scene->rig, seed);
    while (player->end == OPERATOR_ACTS) {
        let_operator_act(scene, player);
    }
    return is_kept;
}

static void report(const scene_t *scene, const operator_t *player, uint32_t seed)
{
    const snapshot_t *const shown = &scene->rig.outputs.snapshot;
    printf("scene %u, after %u acts and %u s: %s", (unsigned)seed, (unsigned)player->acts,
           (unsigned)(player->time_cycles / 1000U), next_step_name((int32_t)player->last_step));
    if (player->end == OPERATOR_REFUSED) {
        printf(" is refused, %s\n", status_name((int32_t)player->refusal));
    } else {
        printf(", axis %u, card %u, last %s\n", (unsigned)shown->step_axis,
               (unsigned)shown->step_card,
               event_id_name((int32_t)scene->rig.controller.sealed.vain_event));
    }
}

/* In how many scenes he was shown each step. */
static void report_steps(const uint32_t scenes[NEXT_STEPS_MOST])
{
    const char *separator = "scenes that showed";
    for (uint32_t i = 0U; i < NEXT_STEPS_MOST; i++) {
        if (scenes[i] != 0U) {
            printf("%s %s %u", separator, next_step_name((int32_t)i), (unsigned)scenes[i]);
            separator = ",";
        }
    }
    printf("\n");
}

bool recovery_play(scene_t *scene, const robot_t *robot, uint32_t count, uint32_t seed)
{
    static operator_t player;
    uint32_t ends[OPERATOR_ENDS] = {0U};
    uint32_t most_acts = 0U;
    uint32_t lost = 0U;
    uint32_t scenes[NEXT_STEPS_MOST] = {0U};
    for (uint32_t i = 0U; i < count; i++) {
        if (!play_scene(scene, robot, &player, seed + i)) {
            lost++;
            printf("scene %u: a late loop has lost something\n", (unsigned)(seed + i));
        }
        ends[player.end]++;
        for (uint32_t step = 0U; step < NEXT_STEPS_MOST; step++) {
            scenes[step] += (uint32_t)((player.shown >> step) & 1U);
        }
        most_acts = (player.acts > most_acts) ? player.acts : most_acts;
        if ((player.end == OPERATOR_DEAD_END) || (player.end == OPERATOR_REFUSED)) {
            report(scene, &player, seed + i);
        }
    }
    printf("an operator who follows the next step: %u homed, %u of them at the target, %u reported "
           "what to "
           "mend, %u dead ends, %u refusals, at most %u acts\n",
           (unsigned)(ends[OPERATOR_COMMANDS] + ends[OPERATOR_ARRIVES]),
           (unsigned)ends[OPERATOR_ARRIVES], (unsigned)ends[OPERATOR_SERVICE],
           (unsigned)ends[OPERATOR_DEAD_END], (unsigned)ends[OPERATOR_REFUSED],
           (unsigned)most_acts);
    report_steps(scenes);
    return (ends[OPERATOR_DEAD_END] + ends[OPERATOR_REFUSED] + lost) == 0U;
}

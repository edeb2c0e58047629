/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/operator/operator_history.h"

#include "bsp.h"
#include "supervise/scenario/prng.h"

#include <stdio.h>

#define HISTORY_CYCLES 9000U
#define ORDER_SIZE 64U

static const char *const faults[] = {
    "card %s silent",    "card %s corrupt",   "card %s foreign",  "card %s deaf",
    "card %s noisy",     "card %s hot",       "encoder %s stuck", "encoder %s reversed",
    "encoder %s half",   "motor %s stuck",    "motor %s half",    "motor %s twice",
    "motor %s runs",     "motor %s hot",      "switch %s stuck",  "switch %s open",
    "switch %s chatter", "switch %s reversed"};
#define LEFT_PARTS 12U /* In a quarter of the scenes nothing is left. */
#define NEXT_FAULT 5U  /* From one axis to the next, so that few scenes have many of them. */
#define FAULTS (sizeof faults / sizeof faults[0])

play_t operator_history(uint32_t seed, const robot_t *robot)
{
    static const play_t plays[] = {PLAY_RANDOM,   PLAY_TAPS,  PLAY_JOGS,   PLAY_TAPS,
                                   PLAY_PROGRAMS, PLAY_MODES, PLAY_RIVALS, PLAY_SWEEPS};
    const play_t play = plays[seed % (sizeof plays / sizeof plays[0])];
    const bool is_by_hand = (play == PLAY_JOGS) && (play_refusal(robot, PLAY_HANDS) == NULL);
    const play_t possible = (play_refusal(robot, play) == NULL) ? play : PLAY_RANDOM;
    return is_by_hand ? PLAY_HANDS : possible;
}

uint32_t operator_history_cycles(uint32_t seed)
{
    uint32_t random = (seed * 3266489917U) | 1U;
    for (uint32_t i = 0U; i < 4U; i++) {
        (void)prng_below(&random, 2U);
    }
    return 1U + prng_below(&random, HISTORY_CYCLES);
}

void operator_break(rig_t *rig, uint32_t seed)
{
    const uint32_t count = rig->box.robot->axis_count;
    char order[ORDER_SIZE];
    const uint32_t axis = seed % count;
    (void)snprintf(order, sizeof order, faults[((seed / count) + (NEXT_FAULT * axis)) % FAULTS],
                   rig->box.robot->axes[axis].name);
    rig_box(rig, order);
}

static void drift(rig_t *rig, uint32_t chance)
{
    const uint32_t axis = chance % rig->box.robot->axis_count;
    const int32_t bound = (int32_t)rig->box.robot->axes[axis].drift_ticks;
    rig->controller.axes[axis].sealed.drift.idle_ticks =
        ((chance & 0x10U) != 0U) ? bound : (bound + 1);
    controller_seal(&rig->controller);
    rig_box(rig, "scanner on");
}

static void unplug(rig_t *rig)
{
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        rig->box.axes[i].card_fault = BOX_CARD_SILENT;
    }
}

void operator_leave(rig_t *rig, uint32_t *chance)
{
    static const char *const left[] = {"estop pull", "scanner on", "pedal press", "pedal release",
                                       "pedal a close"};
    static const uint32_t count = (uint32_t)(sizeof left / sizeof left[0]);
    const uint32_t choice = prng_below(chance, LEFT_PARTS);
    if (choice < count) {
        rig_box(rig, left[choice]);
    } else if (choice == count) {
        rig->unread = 1U + prng_below(chance, BSP_IN_ALL);
    } else if (choice == (count + 1U)) {
        rig->is_recorder_failing = 1U;
    } else if (choice == (count + 2U)) {
        unplug(rig);
    } else if (choice == (count + 3U)) {
        drift(rig, *chance);
    } else {
        /* Nothing else. */
    }
}

bool operator_is_unplugged(const rig_t *rig)
{
    bool is_all = true;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        is_all = is_all && (rig->box.axes[i].card_fault == BOX_CARD_SILENT);
    }
    return is_all;
}

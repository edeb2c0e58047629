/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/operator/operator_history.h"

#include "supervise/stage/chance.h"

#include <stdio.h>

#define HISTORY_CYCLES 9000U
#define ORDER_SIZE 64U

static const char *const faults[] = {
    "card %s silent",    "card %s corrupt",   "card %s foreign",  "card %s deaf",
    "card %s noisy",     "card %s hot",       "encoder %s stuck", "encoder %s reversed",
    "encoder %s half",   "motor %s stuck",    "motor %s half",    "motor %s twice",
    "motor %s runs",     "motor %s hot",      "switch %s stuck",  "switch %s open",
    "switch %s chatter", "switch %s reversed"};
#define NEXT_FAULT 5U /* From one axis to the next, so that few scenes have many of them. */
#define FAULTS (sizeof faults / sizeof faults[0])

play_t operator_history(uint32_t seed, const robot_t *robot)
{
    static const play_t plays[] = {PLAY_RANDOM,   PLAY_TAPS,  PLAY_JOGS,   PLAY_TAPS,
                                   PLAY_PROGRAMS, PLAY_MODES, PLAY_RIVALS, PLAY_SWEEPS};
    const play_t play = plays[seed % (sizeof plays / sizeof plays[0])];
    return (play_refusal(robot, play) == NULL) ? play : PLAY_RANDOM;
}

uint32_t operator_history_cycles(uint32_t seed)
{
    uint32_t random = (seed * 3266489917U) | 1U;
    for (uint32_t i = 0U; i < 4U; i++) {
        (void)chance_below(&random, 2U);
    }
    return 1U + chance_below(&random, HISTORY_CYCLES);
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

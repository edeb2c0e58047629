/* SPDX-License-Identifier: Apache-2.0 */
#include "unit/support/refused_pair.h"

#include "robot/coupled_limit.h"
#include "robot/coupled_path.h"

#include <string.h>

static uint32_t below(uint32_t *random, uint32_t count)
{
    *random ^= *random << 13U;
    *random ^= *random >> 17U;
    *random ^= *random << 5U;
    return *random % count;
}

static void draw(const robot_t *robot, uint32_t *random, int32_t ticks[ROBOT_AXIS_MAX])
{
    joints_t joints;
    (void)memset(ticks, 0, ROBOT_AXIS_MAX * sizeof ticks[0]);
    do {
        for (uint32_t i = 0U; i < robot->axis_count; i++) {
            const axis_config_t *const axis = &robot->axes[i];
            const int32_t span = axis->target_maximum_ticks - axis->target_minimum_ticks;
            ticks[i] = axis->target_minimum_ticks + (int32_t)below(random, (uint32_t)span + 1U);
        }
        joints_from_ticks(robot, ticks, &joints);
    } while (coupled_limit_judge(robot, &joints).status != STATUS_OK);
}

bool refused_pair_draw(refused_pair_t *self, const robot_t *robot, uint32_t *random, uint32_t tries)
{
    bool is_refused = false;
    for (uint32_t i = 0U; !is_refused && (i < tries); i++) {
        draw(robot, random, self->from_ticks);
        draw(robot, random, self->to_ticks);
        is_refused =
            coupled_path_judge(robot, self->from_ticks, self->to_ticks).status != STATUS_OK;
    }
    return is_refused;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/steering_guard.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "motion/curv.h"
#include "robot/joints.h"

static bool is_near(const axis_config_t *config, const axis_t *axis)
{
    const int64_t lag_ticks =
        (int64_t)axis->sealed.setpoint_ticks - (int64_t)axis->sealed.encoder.position_ticks;
    return !joints_is_beyond(config, fixed_magnitude(lag_ticks), 0U, LIMIT_STEERING_LAG_BAM);
}

static bool is_as_fast(const axis_config_t *config, const axis_t *axis, const steering_t *steering)
{
    const int64_t speed_q8 = fixed_magnitude((int64_t)axis->sealed.setpoint_speed_ticks_per_s_q8);
    const int64_t law_q8 = curv_speed_q8(config, steering, axis->sealed.encoder.position_ticks);
    return (speed_q8 * 100) >= (law_q8 * (int64_t)LIMIT_STEERING_PACE_PERCENT);
}

bool steering_guard_follows(const steering_t *steering, const robot_t *robot,
                            const axis_t axes[ROBOT_AXIS_MAX])
{
    bool is_following = true;
    if (steering_is_on(steering)) {
        const uint32_t index = robot->steering.axis % ROBOT_AXIS_MAX; /* Of a damaged table. */
        const axis_config_t *const config = &robot->axes[index];
        is_following = is_near(config, &axes[index]) && is_as_fast(config, &axes[index], steering);
    }
    return is_following;
}

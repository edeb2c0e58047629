/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/coupled_limit.h"

#include "limits/requirement_limits.h"

int64_t coupled_limit_nm(const robot_t *robot, const coupled_limit_t *limit, int32_t first_ticks,
                         int32_t second_ticks)
{
    return joints_value(&robot->axes[limit->first], first_ticks) -
           joints_value(&robot->axes[limit->second], second_ticks);
}

coupled_side_t coupled_limit_side(const coupled_limit_t *limit, int64_t above_nm)
{
    const int64_t margin_nm = (int64_t)LIMIT_COUPLED_MARGIN_NM;
    coupled_side_t side = COUPLED_LIMIT_INSIDE;
    if (above_nm < ((int64_t)limit->minimum_nm + margin_nm)) {
        side = COUPLED_LIMIT_BELOW;
    } else if (above_nm > ((int64_t)limit->maximum_nm - margin_nm)) {
        side = COUPLED_LIMIT_ABOVE;
    } else {
        side = COUPLED_LIMIT_INSIDE;
    }
    return side;
}

solution_t coupled_limit_refusal(const coupled_limit_t *limit, coupled_side_t side)
{
    return (solution_t){.status =
                            (side == COUPLED_LIMIT_INSIDE) ? STATUS_OK : (status_t)limit->refusal,
                        .axis = 0U,
                        .is_maximum = (side == COUPLED_LIMIT_ABOVE) ? 1U : 0U};
}

solution_t coupled_limit_judge(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX])
{
    solution_t result = {STATUS_OK, 0U, 0U};
    for (uint32_t i = 0U; (i < robot->coupled_limit_count) && (result.status == STATUS_OK); i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        const int64_t above_nm =
            coupled_limit_nm(robot, limit, ticks[limit->first], ticks[limit->second]);
        result = coupled_limit_refusal(limit, coupled_limit_side(limit, above_nm));
    }
    return result;
}

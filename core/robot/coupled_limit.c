/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/coupled_limit.h"

#include "limits/requirement_limits.h"
#include "robot/kinematics.h"

int64_t coupled_limit_margin(const coupled_limit_t *limit)
{
    return (limit->unit == (uint8_t)AXIS_UNIT_MM) ? (int64_t)LIMIT_COUPLED_MARGIN_NM
                                                  : (int64_t)LIMIT_COUPLED_MARGIN_BAM;
}

coupled_side_t coupled_limit_side(const coupled_limit_t *limit, int64_t value)
{
    const int64_t margin = coupled_limit_margin(limit);
    coupled_side_t side = COUPLED_LIMIT_INSIDE;
    if (value < ((int64_t)limit->minimum + margin)) {
        side = COUPLED_LIMIT_BELOW;
    } else if (value > ((int64_t)limit->maximum - margin)) {
        side = COUPLED_LIMIT_ABOVE;
    } else {
        side = COUPLED_LIMIT_INSIDE;
    }
    return side;
}

solution_t coupled_limit_refusal(const coupled_limit_t *limit, int64_t value)
{
    const coupled_side_t side = coupled_limit_side(limit, value);
    return (solution_t){.status =
                            (side == COUPLED_LIMIT_INSIDE) ? STATUS_OK : (status_t)limit->refusal,
                        .axis = 0U,
                        .is_maximum = (side == COUPLED_LIMIT_ABOVE) ? 1U : 0U};
}

solution_t coupled_limit_judge(const robot_t *robot, const joints_t *joints)
{
    solution_t result = {.status = STATUS_OK};
    for (uint32_t i = 0U; (i < robot->coupled_limit_count) && (result.status == STATUS_OK); i++) {
        result =
            coupled_limit_refusal(&robot->coupled_limits[i], kinematics_coupled(robot, i, joints));
    }
    return result;
}

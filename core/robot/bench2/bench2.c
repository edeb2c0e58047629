/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/bench2/bench2.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "robot/margin.h"
#include "robot/robot_bench2.h"

#include <stdbool.h>

#define ONE_Q30 1073741824

/* Columns (-1, 0, 0), (0, 0, -1) and (0, -1, 0), as those of every robot at home. */
static void set_orientation(rigid_t *pose)
{
    rigid_set_identity(pose);
    pose->rotation_q30[0][0] = -ONE_Q30;
    pose->rotation_q30[1][1] = 0;
    pose->rotation_q30[1][2] = -ONE_Q30;
    pose->rotation_q30[2][1] = -ONE_Q30;
    pose->rotation_q30[2][2] = 0;
}

static bool is_near(int64_t value, uint32_t limit)
{
    return (value <= (int64_t)limit) && (value >= -(int64_t)limit);
}

/* Judged where the axes will stand: at the nearest ticks. */
static solution_t reach(const robot_t *robot, const point_t *target, joints_t *joints)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    joint_limits_t limits;
    margin_t margin;
    joints->value[BENCH2_AXIS_SLIDE] =
        fixed_saturate((int64_t)target->x_nm - robot->geometry_nm[BENCH2_HOME_X]);
    joints->value[BENCH2_AXIS_NEEDLE] =
        fixed_saturate((int64_t)robot->geometry_nm[BENCH2_HOME_Y] - target->y_nm);
    joints_to_ticks(robot, joints, ticks);
    margin_set_axes(&limits, robot);
    margin_init(&margin);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        margin_add(&margin, &limits, i, joints_value(&robot->axes[i], ticks[i]));
    }
    return (margin.margin_q56 < 0) ? margin_limit(&margin, &limits)
                                   : (solution_t){.status = STATUS_OK};
}

void bench2_forward(const robot_t *robot, const probe_t *probe, const joints_t *joints,
                    rigid_t *zframe_treatment)
{
    (void)probe;
    set_orientation(zframe_treatment);
    zframe_treatment->translation =
        (point_t){fixed_saturate((int64_t)robot->geometry_nm[BENCH2_HOME_X] +
                                 joints->value[BENCH2_AXIS_SLIDE]),
                  fixed_saturate((int64_t)robot->geometry_nm[BENCH2_HOME_Y] -
                                 joints->value[BENCH2_AXIS_NEEDLE]),
                  robot->geometry_nm[BENCH2_HOME_Z]};
}

solution_t bench2_inverse(const robot_t *robot, const probe_t *probe, const needle_line_t *line,
                          joints_t *joints)
{
    const int64_t x_nm = (int64_t)line->target.x_nm - line->entry.x_nm;
    const int64_t y_nm = (int64_t)line->target.y_nm - line->entry.y_nm;
    const int64_t z_nm = (int64_t)line->target.z_nm - line->entry.z_nm;
    const int64_t off_nm = (int64_t)line->target.z_nm - robot->geometry_nm[BENCH2_HOME_Z];
    (void)probe;
    if ((x_nm == 0) && (y_nm == 0) && (z_nm == 0)) {
        return (solution_t){.status = STATUS_DEGENERATE_LINE};
    }
    const bool is_needle = (y_nm < 0) && is_near(x_nm, LIMIT_CLOSURE_NM) &&
                           is_near(z_nm, LIMIT_CLOSURE_NM) && is_near(off_nm, LIMIT_CLOSURE_NM) &&
                           is_near(line->roll_bam, LIMIT_CLOSURE_BAM);
    return is_needle ? reach(robot, &line->target, joints) : (solution_t){.status = STATUS_CLOSURE};
}

solution_t bench2_solve(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                        const point_t *entry, joints_t *joints)
{
    (void)probe;
    (void)entry;
    return reach(robot, &pose->translation, joints);
}

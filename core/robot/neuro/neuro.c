/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/neuro/neuro.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "robot/margin.h"
#include "robot/robot_neuro.h"

#include <stdbool.h>
#include <stddef.h>

#define DEPTH_STEP_NM INT64_C(1000000)

/* A needle nearer to the lateral axis than this has no yaw. */
#define SINGULAR_Q30 1074U

/* A needle whose place and direction are fixed and whose depth may still be chosen. */
typedef struct {
    const robot_t *robot;
    const probe_t *probe;
    int64_t home_height_nm;
    point_t target;
    int32_t direction_q30[3];
    int32_t rotation_bam;
    int32_t pitch_bam;
    int32_t yaw_bam;
} needle_t;

static solution_t result_of(status_t status)
{
    return (solution_t){.status = status};
}

/* The other short side of the right triangle on a side link, both short sides taken twice. */
static int64_t other_side_twice(const robot_t *robot, int64_t side_twice_nm)
{
    const int64_t link_twice_nm = (int64_t)robot->geometry_nm[NEURO_SIDE_LINK] * 2;
    const int64_t side_nm = fixed_within(side_twice_nm, -link_twice_nm, link_twice_nm);
    const int64_t square = (link_twice_nm * link_twice_nm) - (side_nm * side_nm);
    return (int64_t)fixed_square_root((uint64_t)square);
}

static int64_t height_of(const robot_t *robot, int64_t separation_nm)
{
    return fixed_shift_rounded(
        other_side_twice(robot, separation_nm - robot->geometry_nm[NEURO_TOP_WIDTH]), 1U);
}

/* From the remote centre of motion to the treatment point, along the needle. */
static int32_t lever_at(const robot_t *robot, const probe_t *probe, int64_t depth_nm)
{
    return fixed_saturate(depth_nm + probe->length_nm[NEURO_PROBE_ROBOT_TO_TREATMENT] -
                          robot->geometry_nm[NEURO_ROBOT_TO_RCM]);
}

/* Columns of R0 Rx(yaw) Ry(pitch); the third is the needle's direction. */
static void frame_of_angles(int32_t pitch_bam, int32_t yaw_bam, int32_t column_q30[3][3])
{
    const fixed_direction_t pitch = fixed_direction(pitch_bam);
    const fixed_direction_t yaw = fixed_direction(yaw_bam);
    column_q30[0][0] = -pitch.cosine_q30;
    column_q30[0][1] = fixed_multiply_q30(yaw.cosine_q30, pitch.sine_q30);
    column_q30[0][2] = -fixed_multiply_q30(yaw.sine_q30, pitch.sine_q30);
    column_q30[1][0] = 0;
    column_q30[1][1] = -yaw.sine_q30;
    column_q30[1][2] = -yaw.cosine_q30;
    column_q30[2][0] = -pitch.sine_q30;
    column_q30[2][1] = -fixed_multiply_q30(yaw.cosine_q30, pitch.cosine_q30);
    column_q30[2][2] = fixed_multiply_q30(yaw.sine_q30, pitch.cosine_q30);
}

/* Pitch and yaw from the direction; false without a yaw. */
static bool aim(needle_t *self)
{
    const int64_t y = self->direction_q30[1];
    const int64_t z = self->direction_q30[2];
    const int64_t square_y = y * y;
    const int64_t square_z = z * z;
    const uint32_t across_q30 = fixed_square_root((uint64_t)square_y + (uint64_t)square_z);
    self->pitch_bam = fixed_atan2_bam(-(int64_t)self->direction_q30[0], (int64_t)across_q30);
    self->yaw_bam = fixed_atan2_bam(z, -y);
    self->home_height_nm = height_of(self->robot, self->robot->geometry_nm[NEURO_HOME_SEPARATION]);
    return across_q30 > SINGULAR_Q30;
}

static bool aim_at_pose(needle_t *self, const robot_t *robot, const probe_t *probe,
                        const rigid_t *pose)
{
    int32_t x_q30[3];
    int32_t frame_q30[3][3];
    self->robot = robot;
    self->probe = probe;
    self->target = pose->translation;
    for (uint32_t row = 0U; row < 3U; row++) {
        x_q30[row] = pose->rotation_q30[row][0];
        self->direction_q30[row] = pose->rotation_q30[row][2];
    }
    const bool has_yaw = aim(self);
    frame_of_angles(self->pitch_bam, self->yaw_bam, frame_q30);
    self->rotation_bam =
        fixed_atan2_bam(fixed_dot_q30(frame_q30[1], x_q30), fixed_dot_q30(frame_q30[0], x_q30));
    return has_yaw;
}

/* Insertion, lateral axis and height at a depth; returns twice the way of the carriages along. */
static int64_t reach(const needle_t *self, int64_t depth_nm, int64_t value[JOINT_LIMIT_COUNT])
{
    const robot_t *const robot = self->robot;
    const int32_t lever_nm = lever_at(robot, self->probe, depth_nm);
    const int64_t x_nm =
        (int64_t)self->target.x_nm - fixed_multiply_q30(lever_nm, self->direction_q30[0]);
    const int64_t y_nm =
        (int64_t)self->target.y_nm - fixed_multiply_q30(lever_nm, self->direction_q30[1]);
    const int64_t z_nm =
        (int64_t)self->target.z_nm - fixed_multiply_q30(lever_nm, self->direction_q30[2]);
    value[NEURO_AXIS_LATERAL] = x_nm - robot->geometry_nm[NEURO_RCM_HOME_X];
    value[NEURO_AXIS_INSERTION] = depth_nm;
    value[NEURO_LIMIT_HEIGHT] = self->home_height_nm + y_nm - robot->geometry_nm[NEURO_RCM_HOME_Y];
    return (z_nm - robot->geometry_nm[NEURO_RCM_HOME_Z]) * 2;
}

/* The separation at the height; beyond the linkage's reach it is taken at its end. */
static void separate(const needle_t *self, int64_t value[JOINT_LIMIT_COUNT])
{
    const robot_t *const robot = self->robot;
    const int64_t reached_nm =
        fixed_within(value[NEURO_LIMIT_HEIGHT], 0, robot->geometry_nm[NEURO_SIDE_LINK]);
    value[NEURO_LIMIT_SEPARATION] =
        other_side_twice(robot, reached_nm * 2) + robot->geometry_nm[NEURO_TOP_WIDTH];
}

/* Joint values of the carriages at the separation. */
static void spread(const needle_t *self, int64_t axial_nm, int64_t value[JOINT_LIMIT_COUNT])
{
    const int64_t opened_nm =
        value[NEURO_LIMIT_SEPARATION] - self->robot->geometry_nm[NEURO_HOME_SEPARATION];
    value[NEURO_AXIS_HEAD] = fixed_shift_rounded(axial_nm + opened_nm, 1U);
    value[NEURO_AXIS_FEET] = fixed_shift_rounded(axial_nm - opened_nm, 1U);
}

/* Joints at the depth, refused if one would stand outside its limits at the nearest ticks. */
static solution_t finish(const needle_t *self, const joint_limits_t *limits, int64_t depth_nm,
                         joints_t *joints)
{
    int64_t value[JOINT_LIMIT_COUNT];
    int32_t ticks[ROBOT_AXIS_MAX];
    const int64_t axial_nm = reach(self, depth_nm, value);
    separate(self, value);
    spread(self, axial_nm, value);
    value[NEURO_AXIS_ROTATION] = self->rotation_bam;
    value[NEURO_AXIS_PITCH] = self->pitch_bam;
    value[NEURO_AXIS_YAW] = self->yaw_bam;
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        joints->value[i] = fixed_saturate(value[i]);
    }
    margin_t margin;
    margin_init(&margin);
    margin_add(&margin, limits, NEURO_LIMIT_HEIGHT, value[NEURO_LIMIT_HEIGHT]);
    if (margin.margin_q56 < 0) {
        return margin_limit(&margin, limits);
    }
    joints_to_ticks(self->robot, joints, ticks);
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        value[i] = joints_value(&self->robot->axes[i], ticks[i]);
        margin_add(&margin, limits, i, value[i]);
    }
    margin_add(&margin, limits, NEURO_LIMIT_SEPARATION,
               (value[NEURO_AXIS_HEAD] - value[NEURO_AXIS_FEET]) +
                   self->robot->geometry_nm[NEURO_HOME_SEPARATION]);
    return (margin.margin_q56 < 0) ? margin_limit(&margin, limits) : result_of(STATUS_OK);
}

/* Depth that puts the entry point where it belongs; false when it is off the needle's axis. */
static bool find_entry_depth(const needle_t *self, const point_t *entry, int64_t *depth_nm)
{
    const int32_t *const length_nm = self->probe->length_nm;
    const int32_t way_nm[3] = {fixed_saturate((int64_t)self->target.x_nm - entry->x_nm),
                               fixed_saturate((int64_t)self->target.y_nm - entry->y_nm),
                               fixed_saturate((int64_t)self->target.z_nm - entry->z_nm)};
    const int32_t along_nm = fixed_saturate(fixed_dot_q30(way_nm, self->direction_q30));
    int64_t off_nm[3];
    for (uint32_t i = 0U; i < 3U; i++) {
        off_nm[i] = (int64_t)way_nm[i] - fixed_multiply_q30(along_nm, self->direction_q30[i]);
    }
    *depth_nm = (int64_t)along_nm - length_nm[NEURO_PROBE_ROBOT_TO_TREATMENT] +
                length_nm[NEURO_PROBE_ROBOT_TO_ENTRY];
    return fixed_length(off_nm) <= (int64_t)LIMIT_ENTRY_ON_AXIS_NM;
}

/* The smallest margin of the joints that the depth moves, as soon as it is not above `least_q56`.
 */
static margin_t margin_at_depth(const needle_t *self, const joint_limits_t *limits,
                                int64_t depth_nm, int64_t least_q56)
{
    int64_t value[JOINT_LIMIT_COUNT];
    margin_t margin;
    margin_init(&margin);
    margin_add(&margin, limits, NEURO_AXIS_INSERTION, depth_nm);
    if (margin.margin_q56 <= least_q56) {
        return margin;
    }
    const int64_t axial_nm = reach(self, depth_nm, value);
    margin_add(&margin, limits, NEURO_AXIS_LATERAL, value[NEURO_AXIS_LATERAL]);
    /* The height is no joint: room to its ends is worth nothing. */
    margin_add_missed(&margin, limits, NEURO_LIMIT_HEIGHT, value[NEURO_LIMIT_HEIGHT]);
    if (margin.margin_q56 <= least_q56) {
        return margin;
    }
    separate(self, value);
    margin_add(&margin, limits, NEURO_LIMIT_SEPARATION, value[NEURO_LIMIT_SEPARATION]);
    if (margin.margin_q56 <= least_q56) {
        return margin;
    }
    spread(self, axial_nm, value);
    margin_add(&margin, limits, NEURO_AXIS_HEAD, value[NEURO_AXIS_HEAD]);
    margin_add(&margin, limits, NEURO_AXIS_FEET, value[NEURO_AXIS_FEET]);
    return margin;
}

/* The largest depth with room, or the one with most; `best` receives its margin. With a target out
 * of reach, one end of the depths is mostly the best one: with both known first, few others need a
 * close look. */
static int64_t find_depth(const needle_t *self, const joint_limits_t *limits, margin_t *best)
{
    const int64_t enough_q56 = (MARGIN_ONE_Q56 / 100) * (int64_t)LIMIT_DEPTH_MARGIN_PERCENT;
    const int64_t whole = limits->limit[NEURO_AXIS_INSERTION].maximum / DEPTH_STEP_NM;
    int64_t best_depth_nm = 0;
    *best = margin_at_depth(self, limits, 0, -INT64_MAX);
    for (int64_t i = whole; (i > 0) && (best->margin_q56 < enough_q56); i--) {
        const int64_t depth_nm = i * DEPTH_STEP_NM;
        const margin_t margin = margin_at_depth(self, limits, depth_nm, best->margin_q56);
        if (margin.margin_q56 > best->margin_q56) {
            *best = margin;
            best_depth_nm = depth_nm;
        }
    }
    return best_depth_nm;
}

void neuro_limits(const robot_t *robot, joint_limits_t *limits)
{
    margin_set_axes(limits, robot);
    margin_set_limit(limits, NEURO_LIMIT_SEPARATION, STATUS_SEPARATION_LIMIT,
                     robot->geometry_nm[NEURO_MINIMUM_SEPARATION],
                     robot->geometry_nm[NEURO_MAXIMUM_SEPARATION]);
    margin_set_limit(limits, NEURO_LIMIT_HEIGHT, STATUS_UNREACHABLE_HEIGHT, 1,
                     (int64_t)robot->geometry_nm[NEURO_SIDE_LINK] - 1);
}

void neuro_forward(const robot_t *robot, const probe_t *probe, const joints_t *joints,
                   rigid_t *zframe_treatment)
{
    const int64_t head_nm = joints->value[NEURO_AXIS_HEAD];
    const int64_t feet_nm = joints->value[NEURO_AXIS_FEET];
    const int64_t height_nm =
        height_of(robot, (head_nm - feet_nm) + robot->geometry_nm[NEURO_HOME_SEPARATION]);
    const int64_t home_height_nm = height_of(robot, robot->geometry_nm[NEURO_HOME_SEPARATION]);
    const int32_t lever_nm = lever_at(robot, probe, joints->value[NEURO_AXIS_INSERTION]);
    const fixed_direction_t roll = fixed_direction(joints->value[NEURO_AXIS_ROTATION]);
    const int32_t x_q30[3] = {roll.cosine_q30, roll.sine_q30, 0};
    const int32_t y_q30[3] = {-roll.sine_q30, roll.cosine_q30, 0};
    const int64_t rcm_nm[3] = {
        (int64_t)robot->geometry_nm[NEURO_RCM_HOME_X] + joints->value[NEURO_AXIS_LATERAL],
        robot->geometry_nm[NEURO_RCM_HOME_Y] + height_nm - home_height_nm,
        robot->geometry_nm[NEURO_RCM_HOME_Z] + fixed_shift_rounded(head_nm + feet_nm, 1U)};
    int32_t frame_q30[3][3];
    int32_t origin_nm[3];
    frame_of_angles(joints->value[NEURO_AXIS_PITCH], joints->value[NEURO_AXIS_YAW], frame_q30);
    for (uint32_t i = 0U; i < 3U; i++) {
        const int32_t row_q30[3] = {frame_q30[0][i], frame_q30[1][i], 0};
        zframe_treatment->rotation_q30[i][0] = fixed_saturate(fixed_dot_q30(row_q30, x_q30));
        zframe_treatment->rotation_q30[i][1] = fixed_saturate(fixed_dot_q30(row_q30, y_q30));
        zframe_treatment->rotation_q30[i][2] = frame_q30[2][i];
        origin_nm[i] = fixed_saturate(rcm_nm[i] + fixed_multiply_q30(lever_nm, frame_q30[2][i]));
    }
    zframe_treatment->translation = (point_t){origin_nm[0], origin_nm[1], origin_nm[2]};
}

solution_t neuro_inverse(const robot_t *robot, const probe_t *probe, const needle_line_t *line,
                         joints_t *joints)
{
    const int64_t way_nm[3] = {(int64_t)line->target.x_nm - line->entry.x_nm,
                               (int64_t)line->target.y_nm - line->entry.y_nm,
                               (int64_t)line->target.z_nm - line->entry.z_nm};
    needle_t needle = {robot, probe, 0, line->target, {0, 0, 0}, line->roll_bam, 0, 0};
    joint_limits_t limits;
    const int64_t length_nm = fixed_normalise(way_nm, needle.direction_q30);
    if (length_nm == 0) {
        return result_of(STATUS_DEGENERATE_LINE);
    }
    if (!aim(&needle)) {
        return result_of(STATUS_SINGULAR_PITCH);
    }
    neuro_limits(robot, &limits);
    return finish(&needle, &limits,
                  length_nm - probe->length_nm[NEURO_PROBE_ROBOT_TO_TREATMENT] +
                      probe->length_nm[NEURO_PROBE_ROBOT_TO_ENTRY],
                  joints);
}

solution_t neuro_inverse_at_depth(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                                  int32_t depth_nm, joints_t *joints)
{
    needle_t needle;
    joint_limits_t limits;
    if (!aim_at_pose(&needle, robot, probe, pose)) {
        return result_of(STATUS_SINGULAR_PITCH);
    }
    neuro_limits(robot, &limits);
    return finish(&needle, &limits, depth_nm, joints);
}

solution_t neuro_solve(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                       const point_t *entry, joints_t *joints)
{
    needle_t needle;
    joint_limits_t limits;
    margin_t best;
    int64_t depth_nm;
    if (!aim_at_pose(&needle, robot, probe, pose)) {
        return result_of(STATUS_SINGULAR_PITCH);
    }
    neuro_limits(robot, &limits);
    if ((entry != NULL) && find_entry_depth(&needle, entry, &depth_nm)) {
        solution_t by_entry = finish(&needle, &limits, depth_nm, joints);
        /* No depth helps an angle. */
        by_entry.is_by_entry = (by_entry.axis <= (uint8_t)NEURO_AXIS_INSERTION) ? 1U : 0U;
        return by_entry;
    }
    depth_nm = find_depth(&needle, &limits, &best);
    margin_add(&best, &limits, NEURO_AXIS_ROTATION, needle.rotation_bam);
    margin_add(&best, &limits, NEURO_AXIS_PITCH, needle.pitch_bam);
    margin_add(&best, &limits, NEURO_AXIS_YAW, needle.yaw_bam);
    const solution_t result = finish(&needle, &limits, depth_nm, joints);
    /* A height that is missed is the cause of whatever else is. */
    const bool is_reported =
        (result.status == STATUS_OK) || (result.status == STATUS_UNREACHABLE_HEIGHT);
    return is_reported ? result : margin_limit(&best, &limits);
}

int64_t neuro_coupled(const robot_t *robot, uint32_t index, const joints_t *joints)
{
    (void)index;
    return ((int64_t)joints->value[NEURO_AXIS_HEAD] - joints->value[NEURO_AXIS_FEET]) +
           robot->geometry_nm[NEURO_HOME_SEPARATION];
}

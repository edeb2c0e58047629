/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/prostate/prostate.h"

#include "base/fixed.h"
#include "robot/robot_prostate.h"

#include <stdbool.h>

/* A needle that goes along the bore by less than this part of its way does not point at the
 * patient. */
#define LEAST_ALONG_Q30 (FIXED_ONE_Q30 / 4)

/* The pivot of a stage, in the base. */
typedef struct {
    int64_t x_nm;
    int64_t y_nm;
} pivot_t;

/* Angles of the line of the pivots. */
typedef struct {
    int32_t alpha_bam;
    int32_t beta_bam;
} angles_t;

/* A needle whose tip and direction are fixed. */
typedef struct {
    const robot_t *robot;
    const probe_t *probe;
    int64_t tip_nm[3]; /* In the base. */
    angles_t angles;
    int32_t rotation_bam;
    int32_t frame_q30[3][3]; /* By columns. */
} aimed_t;

/* Places of the needle's carriers. */
typedef struct {
    pivot_t front;
    pivot_t rear;
    int64_t insertion_nm;
} carriers_t;

/* The other short side of the right triangle on a side link, both short sides taken twice. */
static int64_t other_side_twice(const robot_t *robot, int64_t side_twice_nm)
{
    const int64_t link_twice_nm = (int64_t)robot->geometry_nm[PROSTATE_SIDE_LINK] * 2;
    const int64_t side_nm = fixed_within(side_twice_nm, 0, link_twice_nm);
    const int64_t square = (link_twice_nm * link_twice_nm) - (side_nm * side_nm);
    return (int64_t)fixed_square_root((uint64_t)square);
}

/* Height of a pivot whose trapezoid is flat. */
static int64_t lowest_nm(const robot_t *robot)
{
    return (int64_t)robot->geometry_nm[PROSTATE_LOWER_HEIGHT] +
           robot->geometry_nm[PROSTATE_UPPER_HEIGHT];
}

/* Place of a pivot between its carriages. */
static int64_t middle_nm(int64_t left_nm, int64_t right_nm)
{
    return fixed_shift_rounded(left_nm + right_nm, 1U);
}

static pivot_t pivot_of(const robot_t *robot, int64_t left_nm, int64_t right_nm)
{
    const int64_t opened_nm = left_nm - right_nm - robot->geometry_nm[PROSTATE_TOP_WIDTH];
    return (pivot_t){middle_nm(left_nm, right_nm),
                     lowest_nm(robot) +
                         fixed_shift_rounded(other_side_twice(robot, opened_nm), 1U)};
}

static pivot_t front_of(const robot_t *robot, const joints_t *joints)
{
    return pivot_of(robot, joints->value[PROSTATE_AXIS_FRONT_LEFT],
                    joints->value[PROSTATE_AXIS_FRONT_RIGHT]);
}

/* Angles of a direction; beta is positive downwards. */
static angles_t angles_of(const int64_t direction[3])
{
    const int64_t level[3] = {direction[0], 0, direction[2]};
    return (angles_t){fixed_atan2_bam(direction[0], direction[2]),
                      fixed_atan2_bam(-direction[1], fixed_length(level))};
}

/* Distance of the front pivot to the left of the rear one, nm. */
static int64_t aside_nm(const joints_t *joints)
{
    return middle_nm(joints->value[PROSTATE_AXIS_FRONT_LEFT],
                     joints->value[PROSTATE_AXIS_FRONT_RIGHT]) -
           middle_nm(joints->value[PROSTATE_AXIS_REAR_LEFT],
                     joints->value[PROSTATE_AXIS_REAR_RIGHT]);
}

static angles_t angles_at(const robot_t *robot, const joints_t *joints)
{
    const pivot_t front = front_of(robot, joints);
    const pivot_t rear = pivot_of(robot, joints->value[PROSTATE_AXIS_REAR_LEFT],
                                  joints->value[PROSTATE_AXIS_REAR_RIGHT]);
    const int64_t way_nm[3] = {front.x_nm - rear.x_nm, front.y_nm - rear.y_nm,
                               robot->geometry_nm[PROSTATE_STAGE_DISTANCE]};
    return angles_of(way_nm);
}

/* Columns of Ry(alpha) Rx(beta); the third is the needle's direction. */
static void frame_of(angles_t angles, int32_t column_q30[3][3])
{
    const fixed_direction_t alpha = fixed_direction(angles.alpha_bam);
    const fixed_direction_t beta = fixed_direction(angles.beta_bam);
    column_q30[0][0] = alpha.cosine_q30;
    column_q30[0][1] = 0;
    column_q30[0][2] = -alpha.sine_q30;
    column_q30[1][0] = fixed_multiply_q30(alpha.sine_q30, beta.sine_q30);
    column_q30[1][1] = beta.cosine_q30;
    column_q30[1][2] = fixed_multiply_q30(alpha.cosine_q30, beta.sine_q30);
    column_q30[2][0] = fixed_multiply_q30(alpha.sine_q30, beta.cosine_q30);
    column_q30[2][1] = -beta.sine_q30;
    column_q30[2][2] = fixed_multiply_q30(alpha.cosine_q30, beta.cosine_q30);
}

/* Takes tip and direction; false if the needle does not point at the patient. */
static bool aim(aimed_t *self, const robot_t *robot, const probe_t *probe, const point_t *target,
                const int32_t direction_q30[3])
{
    const int64_t direction[3] = {direction_q30[0], direction_q30[1], direction_q30[2]};
    self->robot = robot;
    self->probe = probe;
    self->tip_nm[0] = (int64_t)target->x_nm + robot->geometry_nm[PROSTATE_ZFRAME_X];
    self->tip_nm[1] = (int64_t)target->y_nm + robot->geometry_nm[PROSTATE_ZFRAME_Y];
    self->tip_nm[2] = (int64_t)target->z_nm + robot->geometry_nm[PROSTATE_ZFRAME_Z];
    self->angles = angles_of(direction);
    frame_of(self->angles, self->frame_q30);
    return self->frame_q30[2][2] >= LEAST_ALONG_Q30;
}

/* Its z coordinate is known of each pivot, so each is one point of the needle's line. */
static carriers_t carriers_of(const aimed_t *self)
{
    const int32_t *const length_nm = self->robot->geometry_nm;
    const int32_t *const probe_nm = self->probe->length_nm;
    const int32_t *const up_q30 = self->frame_q30[1];
    const int32_t *const along_q30 = self->frame_q30[2];
    const int64_t deep_nm = self->tip_nm[2] + length_nm[PROSTATE_PIVOT_DEPTH];
    const int64_t raised_q30 = (int64_t)probe_nm[PROSTATE_PROBE_NEEDLE_HEIGHT] * up_q30[2];
    const int64_t lever_nm =
        fixed_divide_rounded((deep_nm * FIXED_ONE_Q30) - raised_q30, along_q30[2]);
    int64_t front_nm[2];
    int64_t rear_nm[2];
    for (uint32_t i = 0U; i < 2U; i++) {
        front_nm[i] = self->tip_nm[i] -
                      fixed_multiply_q30(probe_nm[PROSTATE_PROBE_NEEDLE_HEIGHT], up_q30[i]) -
                      fixed_multiply_q30(fixed_saturate(lever_nm), along_q30[i]);
        rear_nm[i] = front_nm[i] -
                     fixed_divide_rounded(
                         (int64_t)length_nm[PROSTATE_STAGE_DISTANCE] * along_q30[i], along_q30[2]);
    }
    return (carriers_t){{front_nm[0], front_nm[1]},
                        {rear_nm[0], rear_nm[1]},
                        lever_nm - probe_nm[PROSTATE_PROBE_NEEDLE_TIP]};
}

/* Half of what lies between the carriages of a stage at this height. */
static int64_t half_opened_nm(const robot_t *robot, const pivot_t *pivot)
{
    const int64_t side_twice_nm = other_side_twice(robot, (pivot->y_nm - lowest_nm(robot)) * 2);
    return fixed_shift_rounded(side_twice_nm + robot->geometry_nm[PROSTATE_TOP_WIDTH], 1U);
}

static void set_joints(const aimed_t *self, const carriers_t *carriers, joints_t *joints)
{
    const int64_t front_nm = half_opened_nm(self->robot, &carriers->front);
    const int64_t rear_nm = half_opened_nm(self->robot, &carriers->rear);
    joints->value[PROSTATE_AXIS_FRONT_LEFT] = fixed_saturate(carriers->front.x_nm + front_nm);
    joints->value[PROSTATE_AXIS_FRONT_RIGHT] = fixed_saturate(carriers->front.x_nm - front_nm);
    joints->value[PROSTATE_AXIS_REAR_LEFT] = fixed_saturate(carriers->rear.x_nm + rear_nm);
    joints->value[PROSTATE_AXIS_REAR_RIGHT] = fixed_saturate(carriers->rear.x_nm - rear_nm);
    joints->value[PROSTATE_AXIS_INSERTION] = fixed_saturate(carriers->insertion_nm);
    joints->value[PROSTATE_AXIS_ROTATION] = self->rotation_bam;
}

static void set_limits(const robot_t *robot, joint_limits_t *limits)
{
    const int64_t link_nm = robot->geometry_nm[PROSTATE_SIDE_LINK];
    margin_set_axes(limits, robot);
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        margin_set_limit(limits, PROSTATE_LIMIT_COUPLED + i, (status_t)limit->refusal,
                         limit->minimum, limit->maximum);
    }
    margin_set_limit(limits, PROSTATE_LIMIT_FRONT_HEIGHT, STATUS_FRONT_HEIGHT, 1, link_nm - 1);
    margin_set_limit(limits, PROSTATE_LIMIT_REAR_HEIGHT, STATUS_REAR_HEIGHT, 1, link_nm - 1);
}

/* Margin of axes and separations, at the nearest ticks. */
static void judge_ticks(const robot_t *robot, const joints_t *joints, const joint_limits_t *limits,
                        margin_t *margin)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    joints_t reached;
    joints_to_ticks(robot, joints, ticks);
    joints_from_ticks(robot, ticks, &reached);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        margin_add(margin, limits, i, joints_value(&robot->axes[i], ticks[i]));
    }
    for (uint32_t i = 0U; i < PROSTATE_ALPHA; i++) {
        margin_add(margin, limits, PROSTATE_LIMIT_COUPLED + i,
                   prostate_coupled(robot, i, &reached));
    }
}

static solution_t finish(const aimed_t *self, joints_t *joints)
{
    const robot_t *const robot = self->robot;
    joint_limits_t limits;
    margin_t margin;
    set_limits(robot, &limits);
    margin_init(&margin);
    margin_add(&margin, &limits, PROSTATE_LIMIT_COUPLED + PROSTATE_ALPHA, self->angles.alpha_bam);
    margin_add(&margin, &limits, PROSTATE_LIMIT_COUPLED + PROSTATE_BETA, self->angles.beta_bam);
    if (margin.margin_q56 < 0) {
        return margin_limit(&margin, &limits);
    }
    const carriers_t carriers = carriers_of(self);
    margin_add(&margin, &limits, PROSTATE_LIMIT_FRONT_HEIGHT,
               carriers.front.y_nm - lowest_nm(robot));
    margin_add(&margin, &limits, PROSTATE_LIMIT_REAR_HEIGHT, carriers.rear.y_nm - lowest_nm(robot));
    if (margin.margin_q56 < 0) {
        return margin_limit(&margin, &limits);
    }
    set_joints(self, &carriers, joints);
    judge_ticks(robot, joints, &limits, &margin);
    return (margin.margin_q56 < 0) ? margin_limit(&margin, &limits)
                                   : (solution_t){.status = STATUS_OK};
}

int64_t prostate_coupled(const robot_t *robot, uint32_t index, const joints_t *joints)
{
    int64_t value = 0;
    switch (index) {
    case PROSTATE_FRONT_GAP:
        value = (int64_t)joints->value[PROSTATE_AXIS_FRONT_LEFT] -
                joints->value[PROSTATE_AXIS_FRONT_RIGHT];
        break;
    case PROSTATE_REAR_GAP:
        value = (int64_t)joints->value[PROSTATE_AXIS_REAR_LEFT] -
                joints->value[PROSTATE_AXIS_REAR_RIGHT];
        break;
    case PROSTATE_ALPHA:
        value = fixed_atan2_bam(aside_nm(joints), robot->geometry_nm[PROSTATE_STAGE_DISTANCE]);
        break;
    default:
        value = angles_at(robot, joints).beta_bam;
        break;
    }
    return value;
}

void prostate_forward(const robot_t *robot, const probe_t *probe, const joints_t *joints,
                      rigid_t *zframe_treatment)
{
    const int32_t *const length_nm = robot->geometry_nm;
    const int32_t *const probe_nm = probe->length_nm;
    const pivot_t front = front_of(robot, joints);
    const int32_t lever_nm = fixed_saturate((int64_t)probe_nm[PROSTATE_PROBE_NEEDLE_TIP] +
                                            joints->value[PROSTATE_AXIS_INSERTION]);
    const fixed_direction_t roll = fixed_direction(joints->value[PROSTATE_AXIS_ROTATION]);
    const int32_t x_q30[3] = {roll.cosine_q30, roll.sine_q30, 0};
    const int32_t y_q30[3] = {-roll.sine_q30, roll.cosine_q30, 0};
    const int64_t front_nm[3] = {
        front.x_nm - length_nm[PROSTATE_ZFRAME_X], front.y_nm - length_nm[PROSTATE_ZFRAME_Y],
        -(int64_t)length_nm[PROSTATE_PIVOT_DEPTH] - length_nm[PROSTATE_ZFRAME_Z]};
    int32_t frame_q30[3][3];
    int32_t tip_nm[3];
    frame_of(angles_at(robot, joints), frame_q30);
    for (uint32_t i = 0U; i < 3U; i++) {
        const int32_t row_q30[3] = {frame_q30[0][i], frame_q30[1][i], 0};
        zframe_treatment->rotation_q30[i][0] = fixed_saturate(fixed_dot_q30(row_q30, x_q30));
        zframe_treatment->rotation_q30[i][1] = fixed_saturate(fixed_dot_q30(row_q30, y_q30));
        zframe_treatment->rotation_q30[i][2] = frame_q30[2][i];
        tip_nm[i] = fixed_saturate(
            front_nm[i] +
            fixed_multiply_q30(probe_nm[PROSTATE_PROBE_NEEDLE_HEIGHT], frame_q30[1][i]) +
            fixed_multiply_q30(lever_nm, frame_q30[2][i]));
    }
    zframe_treatment->translation = (point_t){tip_nm[0], tip_nm[1], tip_nm[2]};
}

solution_t prostate_inverse(const robot_t *robot, const probe_t *probe, const needle_line_t *line,
                            joints_t *joints)
{
    const int64_t way_nm[3] = {(int64_t)line->target.x_nm - line->entry.x_nm,
                               (int64_t)line->target.y_nm - line->entry.y_nm,
                               (int64_t)line->target.z_nm - line->entry.z_nm};
    int32_t direction_q30[3];
    aimed_t needle;
    if (fixed_normalise(way_nm, direction_q30) == 0) {
        return (solution_t){.status = STATUS_DEGENERATE_LINE};
    }
    needle.rotation_bam = line->roll_bam;
    return aim(&needle, robot, probe, &line->target, direction_q30)
               ? finish(&needle, joints)
               : (solution_t){.status = STATUS_NEEDLE_BACKWARDS};
}

solution_t prostate_solve(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                          const point_t *entry, joints_t *joints)
{
    int32_t x_q30[3];
    int32_t direction_q30[3];
    aimed_t needle;
    (void)entry;
    for (uint32_t row = 0U; row < 3U; row++) {
        x_q30[row] = pose->rotation_q30[row][0];
        direction_q30[row] = pose->rotation_q30[row][2];
    }
    const bool is_forwards = aim(&needle, robot, probe, &pose->translation, direction_q30);
    needle.rotation_bam = fixed_atan2_bam(fixed_dot_q30(needle.frame_q30[1], x_q30),
                                          fixed_dot_q30(needle.frame_q30[0], x_q30));
    return is_forwards ? finish(&needle, joints) : (solution_t){.status = STATUS_NEEDLE_BACKWARDS};
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/preview.h"

#include "robot/bare_direction.h"

#include <string.h>

int32_t preview_room_ticks(const axis_config_t *axis, int32_t ticks)
{
    const int32_t below = ticks - axis->minimum_ticks;
    const int32_t above = axis->maximum_ticks - ticks;
    return (below < above) ? below : above;
}

/* Compared as shares of the ranges. */
static bool is_tighter(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX], uint32_t axis,
                       uint32_t other)
{
    const axis_config_t *one = &robot->axes[axis];
    const axis_config_t *two = &robot->axes[other];
    const int64_t range = (int64_t)one->maximum_ticks - one->minimum_ticks;
    const int64_t other_range = (int64_t)two->maximum_ticks - two->minimum_ticks;
    return (preview_room_ticks(one, ticks[axis]) * other_range) <
           (preview_room_ticks(two, ticks[other]) * range);
}

static uint32_t find_tightest(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX])
{
    uint32_t found = 0U;
    for (uint32_t i = 1U; i < robot->axis_count; i++) {
        found = is_tighter(robot, ticks, i, found) ? i : found;
    }
    return found;
}

static probe_t probe_of(const snapshot_t *snapshot)
{
    probe_t probe;
    (void)memcpy(probe.length_nm, snapshot->probe_nm, sizeof probe.length_nm);
    return probe;
}

preview_t preview_target(const robot_t *robot, const snapshot_t *snapshot,
                         const rigid_t *scanner_treatment)
{
    const plan_origin_t origin = {.ignores_rotation = false};
    const probe_t probe = probe_of(snapshot);
    plan_t plan;
    preview_t preview;
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    (void)memset(&preview, 0, sizeof preview);
    plan_init(&plan, robot);
    plan_set_probe(&plan, &probe);
    plan.has_probe = snapshot->has_probe;
    if (snapshot->is_registered != 0U) {
        (void)plan_register(&plan, robot, &snapshot->scanner_zframe, &origin);
    }
    plan.entry = snapshot->entry;
    plan.has_entry = snapshot->has_entry;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        ticks[i] = snapshot->axes[i].position_ticks;
    }
    preview.solution = plan_set_target(&plan, robot, ticks, scanner_treatment);
    if (preview.solution.status == STATUS_OK) {
        preview.reached = plan.scanner_target;
        (void)memcpy(preview.ticks, plan.target_ticks, sizeof preview.ticks);
        preview.tightest = find_tightest(robot, preview.ticks);
    }
    return preview;
}

solution_t preview_aim(const robot_t *robot, const snapshot_t *snapshot, const point_t *target,
                       rigid_t *scanner_treatment)
{
    solution_t solution = {.status = STATUS_NOT_REGISTERED};
    rigid_t zframe_scanner;
    rigid_t zframe_treatment;
    joints_t joints;
    const probe_t probe = probe_of(snapshot);
    if (snapshot->has_probe == 0U) {
        solution.status = STATUS_NO_PROBE;
        return solution;
    }
    if (snapshot->is_registered == 0U) {
        return solution;
    }
    if ((snapshot->has_entry == 0U) && !bare_direction_is_there(robot)) {
        solution.status = STATUS_NOT_PROPOSED;
        return solution;
    }
    rigid_invert(&snapshot->scanner_zframe, &zframe_scanner);
    needle_line_t line = {.target = rigid_apply(&zframe_scanner, target), .roll_bam = 0};
    line.entry = (snapshot->has_entry != 0U) ? rigid_apply(&zframe_scanner, &snapshot->entry)
                                             : bare_direction_before(robot, &line.target);
    solution = kinematics_inverse(robot, &probe, &line, &joints);
    if (solution.status == STATUS_OK) {
        kinematics_forward(robot, &probe, &joints, &zframe_treatment);
        rigid_multiply(&snapshot->scanner_zframe, &zframe_treatment, scanner_treatment);
    }
    return solution;
}

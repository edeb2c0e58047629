/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/dialect/transform_view.h"

#include "interface/status.h"

#include <stdbool.h>
#include <string.h>

static void take_measured(transform_measured_t *measured, const snapshot_t *snapshot)
{
    const bool are_joints_known = (snapshot->pose_status == (uint32_t)STATUS_NOT_REGISTERED) ||
                                  (snapshot->pose_status == (uint32_t)STATUS_NO_PROBE);

    measured->pose_status = snapshot->pose_status;
    measured->joint_status = are_joints_known ? (uint32_t)STATUS_OK : snapshot->pose_status;
    if (measured->pose_status == (uint32_t)STATUS_OK) {
        measured->pose = snapshot->scanner_treatment;
    }
    for (uint32_t i = 0U;
         (i < snapshot->axis_count) && (measured->joint_status == (uint32_t)STATUS_OK); i++) {
        measured->ticks[i] = snapshot->axes[i].position_ticks;
        measured->speeds_q8[i] = snapshot->axes[i].speed_ticks_per_s_q8;
    }
}

static void take_desired(transform_desired_t *desired, const snapshot_t *snapshot)
{
    desired->is_valid = snapshot->is_proposal_reachable;
    if (desired->is_valid == 0U) {
        return;
    }
    desired->pose_status = snapshot->pose_status;
    if (desired->pose_status == (uint32_t)STATUS_OK) {
        desired->pose = snapshot->scanner_desired;
        (void)memcpy(desired->ticks, snapshot->desired_ticks, sizeof desired->ticks);
    }
}

void transform_view_take(transform_view_t *view, const snapshot_t *snapshot)
{
    (void)memset(view, 0, sizeof *view);
    view->probe.is_valid = snapshot->has_probe;
    (void)memcpy(view->probe.length_nm, snapshot->probe_nm, sizeof view->probe.length_nm);
    take_measured(&view->measured, snapshot);
    take_desired(&view->desired, snapshot);
    if (snapshot->is_registered != 0U) {
        view->registration =
            (transform_registration_t){1U, snapshot->scanner_zframe, snapshot->is_rotation_ignored};
    } else if (snapshot->has_proposed_registration != 0U) {
        view->registration = (transform_registration_t){1U, snapshot->proposed_registration, 0U};
    } else {
        view->registration.is_valid = 0U;
    }
    if (snapshot->has_proposed_entry != 0U) {
        view->entry = (transform_point_t){1U, snapshot->proposed_entry};
    } else if (snapshot->has_entry != 0U) {
        view->entry = (transform_point_t){1U, snapshot->entry};
    } else {
        view->entry.is_valid = 0U;
    }
    if (snapshot->has_proposed_target != 0U) {
        view->target = (transform_point_t){1U, snapshot->proposed_target};
    }
}

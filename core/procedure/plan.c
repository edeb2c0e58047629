/* SPDX-License-Identifier: Apache-2.0 */
#include "procedure/plan.h"

#include "base/fixed.h"
#include "base/seal.h"
#include "limits/requirement_limits.h"
#include "robot/bare_direction.h"
#include "robot/coupled_limit.h"
#include "robot/coupled_path.h"
#include "robot/probe.h"

#include <stddef.h>
#include <string.h>

static uint32_t seal_of_plan(const plan_t *self)
{
    return seal_of(SEAL_START, (const uint8_t *)self, WHOLE_WORDS(offsetof(plan_t, seal)));
}

void plan_seal(plan_t *self)
{
    self->seal = seal_of_plan(self);
}

bool plan_is_damaged(const plan_t *self)
{
    return self->seal != seal_of_plan(self);
}

static void forget_steering(plan_t *self)
{
    (void)memset(&self->steering, 0, sizeof self->steering);
}

void plan_forget_target(plan_t *self)
{
    forget_steering(self);
    self->has_target = 0U;
    self->has_entry = 0U;
    self->is_entry_of_target = 0U;
    self->has_seen_needle = 0U;
    self->has_proposed_entry = 0U;
    self->has_proposed_target = 0U;
    self->is_proposal_reachable = 0U;
    plan_seal(self);
}

/* Pose of the treatment frame in the scanner at the joints. */
static rigid_t find_pose(const plan_t *self, const robot_t *robot, const rigid_t *scanner_zframe,
                         const joints_t *joints)
{
    rigid_t zframe_treatment;
    rigid_t scanner_treatment;
    kinematics_forward(robot, &self->probe, joints, &zframe_treatment);
    rigid_multiply(scanner_zframe, &zframe_treatment, &scanner_treatment);
    return scanner_treatment;
}

/* Rounds legal joints to ticks. */
static void settle(const robot_t *robot, joints_t *joints, int32_t ticks[ROBOT_AXIS_MAX])
{
    joints_to_ticks(robot, joints, ticks);
    joints_from_ticks(robot, ticks, joints);
}

/* Pose for the entry and target point together; shown only, in the frame of the measured pose. */
static bool find_desired(plan_t *self, const robot_t *robot)
{
    const bool is_proposed = (self->has_proposed_registration != 0U) && (self->is_registered == 0U);
    const rigid_t *const scanner_zframe =
        is_proposed ? &self->proposed_registration : &self->scanner_zframe;
    rigid_t zframe_scanner;
    joints_t joints;
    rigid_invert(scanner_zframe, &zframe_scanner);
    needle_line_t line = {.target = rigid_apply(&zframe_scanner, &self->proposed_target),
                          .roll_bam = 0};
    line.entry = (self->has_proposed_entry != 0U)
                     ? rigid_apply(&zframe_scanner, &self->proposed_entry)
                     : bare_direction_before(robot, &line.target);
    const solution_t result = kinematics_inverse(robot, &self->probe, &line, &joints);
    if (result.status == STATUS_OK) {
        settle(robot, &joints, self->desired_ticks);
        self->scanner_desired = find_pose(self, robot, scanner_zframe, &joints);
    }
    return result.status == STATUS_OK;
}

/* After whatever changed of the proposals. */
static void weigh_proposals(plan_t *self, const robot_t *robot)
{
    const bool is_line = (self->has_proposed_entry != 0U) || bare_direction_is_there(robot);
    const bool is_known = is_line && (self->has_probe != 0U) && (self->has_proposed_target != 0U);
    self->is_proposal_reachable = 0U;
    if (is_known && find_desired(self, robot)) {
        self->is_proposal_reachable = 1U;
    }
    plan_seal(self);
}

/* Without a probe. */
static void clear(plan_t *self)
{
    (void)memset(self, 0, sizeof *self);
    rigid_set_identity(&self->scanner_zframe);
    rigid_set_identity(&self->scanner_target);
    rigid_set_identity(&self->scanner_seen_needle);
    rigid_set_identity(&self->proposed_registration);
    rigid_set_identity(&self->scanner_desired);
}

static void take_probe(plan_t *self, const probe_t *probe)
{
    self->probe = *probe;
    self->probe_crc = probe_checksum(probe);
    self->has_probe = 1U;
}

void plan_init(plan_t *self, const robot_t *robot)
{
    clear(self);
    take_probe(self, &robot->probe);
    plan_seal(self);
}

bool plan_forget(plan_t *self)
{
    probe_t probe;
    probe = self->probe;
    const bool is_probe_proved = self->probe_crc == probe_checksum(&probe);
    clear(self);
    if (is_probe_proved) {
        take_probe(self, &probe);
    }
    plan_seal(self);
    return is_probe_proved;
}

void plan_set_probe(plan_t *self, const probe_t *probe)
{
    take_probe(self, probe);
    plan_forget_target(self);
}

status_t plan_register(plan_t *self, const robot_t *robot, const rigid_t *scanner_zframe,
                       const plan_origin_t *origin)
{
    const status_t status = rigid_check(scanner_zframe);
    if (status != STATUS_OK) {
        return status;
    }
    self->scanner_zframe = *scanner_zframe;
    rigid_orthonormalise(&self->scanner_zframe);
    if (origin->ignores_rotation) {
        rigid_set_identity(&self->scanner_zframe);
        self->scanner_zframe.translation = scanner_zframe->translation;
    }
    self->is_rotation_ignored = origin->ignores_rotation ? 1U : 0U;
    self->registered_source = origin->source;
    self->registered_peer = origin->peer;
    self->registered_cycle = origin->cycle;
    self->is_registered = 1U;
    self->has_proposed_registration = 0U;
    plan_forget_target(self);
    weigh_proposals(self, robot);
    return STATUS_OK;
}

/* Kinematics knows limits only; a switch that is still active, or the permit at a coupled limit,
 * would block the last of the way. */
static void check_ends(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX],
                       const joints_t *joints, solution_t *result)
{
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const config = &robot->axes[i];
        if ((result->status == STATUS_OK) && ((ticks[i] < config->target_minimum_ticks) ||
                                              (ticks[i] > config->target_maximum_ticks))) {
            result->status = STATUS_SWITCH_ZONE;
            result->axis = (uint8_t)i;
        }
    }
    if (result->status == STATUS_OK) {
        *result = coupled_limit_judge(robot, joints);
    }
}

/* On the line of the needle, which is the third column, and before the target. */
static bool is_on_line(const rigid_t *treatment, const point_t *entry)
{
    const point_t *const target = &treatment->translation;
    const int32_t way_nm[3] = {fixed_saturate((int64_t)target->x_nm - entry->x_nm),
                               fixed_saturate((int64_t)target->y_nm - entry->y_nm),
                               fixed_saturate((int64_t)target->z_nm - entry->z_nm)};
    int32_t direction_q30[3];
    int64_t off_nm[3];
    for (uint32_t i = 0U; i < 3U; i++) {
        direction_q30[i] = treatment->rotation_q30[i][2];
    }
    const int32_t along_nm = fixed_saturate(fixed_dot_q30(way_nm, direction_q30));
    for (uint32_t i = 0U; i < 3U; i++) {
        off_nm[i] = (int64_t)way_nm[i] - fixed_multiply_q30(along_nm, direction_q30[i]);
    }
    return (along_nm > 0) && (fixed_length(off_nm) <= (int64_t)LIMIT_ENTRY_ON_AXIS_NM);
}

/* Target for a pose in the z-frame that is exactly orthonormal. */
static solution_t find_target(plan_t *self, const robot_t *robot,
                              const int32_t ticks[ROBOT_AXIS_MAX], const rigid_t *zframe_treatment,
                              const point_t *entry)
{
    joints_t joints;
    solution_t result = kinematics_solve(robot, &self->probe, zframe_treatment, entry, &joints);
    const uint8_t is_by_entry = result.is_by_entry;
    if (result.status == STATUS_OK) {
        result.status = plan_confirm(self, robot, &joints, zframe_treatment);
    }
    if (result.status == STATUS_OK) {
        settle(robot, &joints, self->target_ticks);
        self->scanner_target = find_pose(self, robot, &self->scanner_zframe, &joints);
        check_ends(robot, self->target_ticks, &joints, &result);
    }
    if (result.status == STATUS_OK) {
        result = coupled_path_judge(robot, ticks, self->target_ticks);
    }
    if ((result.status != STATUS_OK) && (is_by_entry != 0U)) {
        result.status = STATUS_ENTRY_POINT;
    }
    return result;
}

/* Target for a pose in scanner coordinates that is rigid. */
static solution_t find_scanner_target(plan_t *self, const robot_t *robot,
                                      const int32_t ticks[ROBOT_AXIS_MAX],
                                      const rigid_t *scanner_treatment)
{
    rigid_t exact;
    rigid_t zframe_scanner;
    rigid_t zframe_treatment;
    point_t place;
    const point_t *entry = NULL;
    exact = *scanner_treatment;
    rigid_orthonormalise(&exact);
    rigid_invert(&self->scanner_zframe, &zframe_scanner);
    rigid_multiply(&zframe_scanner, &exact, &zframe_treatment);
    if (self->has_entry != 0U) {
        place = rigid_apply(&zframe_scanner, &self->entry);
        entry = &place;
    }
    self->is_entry_of_target = 0U;
    if ((entry != NULL) && is_on_line(&zframe_treatment, entry)) {
        self->is_entry_of_target = 1U;
    }
    return find_target(self, robot, ticks, &zframe_treatment, entry);
}

solution_t plan_set_target(plan_t *self, const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX],
                           const rigid_t *scanner_treatment)
{
    solution_t result = {.status = rigid_check(scanner_treatment)};
    if ((result.status == STATUS_OK) && (self->has_probe == 0U)) {
        result.status = STATUS_NO_PROBE;
    }
    if ((result.status == STATUS_OK) && (self->is_registered == 0U)) {
        result.status = STATUS_NOT_REGISTERED;
    }
    if (result.status == STATUS_OK) {
        result = find_scanner_target(self, robot, ticks, scanner_treatment);
    }
    self->has_target = 0U;
    self->has_seen_needle = 0U;
    forget_steering(self);
    if (result.status == STATUS_OK) {
        self->has_target = 1U;
    }
    plan_seal(self);
    return result;
}

status_t plan_steer(plan_t *self, const robot_t *robot, uint32_t method, uint32_t curvature_per_km,
                    int32_t direction_deg)
{
    steering_t steering;
    status_t status =
        steering_set(&steering, &robot->steering, method, curvature_per_km, direction_deg);
    if ((status == STATUS_OK) && (self->has_target == 0U)) {
        status = STATUS_NO_TARGET;
    }
    if (status == STATUS_OK) {
        self->steering = steering;
        plan_seal(self);
    }
    return status;
}

solution_t plan_judge_way(const plan_t *self, const robot_t *robot,
                          const int32_t ticks[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_OK};
    if (self->has_probe == 0U) {
        result.status = STATUS_NO_PROBE;
    } else if (self->has_target != 0U) {
        result = coupled_path_judge(robot, ticks, self->target_ticks);
    } else {
        /* There is no way. */
    }
    return result;
}

status_t plan_judge_entry(const plan_t *self)
{
    status_t status = STATUS_OK;
    if (self->has_target == 0U) {
        status = STATUS_NO_TARGET;
    } else if (self->is_entry_of_target == 0U) {
        status = STATUS_NO_ENTRY_POINT;
    } else {
        status = STATUS_OK;
    }
    return status;
}

status_t plan_confirm(const plan_t *self, const robot_t *robot, const joints_t *joints,
                      const rigid_t *zframe_treatment)
{
    rigid_t reached;
    int32_t distance_nm = 0;
    int32_t angle_bam = 0;
    kinematics_forward(robot, &self->probe, joints, &reached);
    rigid_difference(&reached, zframe_treatment, &distance_nm, &angle_bam);
    const bool is_closed =
        (distance_nm <= (int32_t)LIMIT_CLOSURE_NM) && (angle_bam <= (int32_t)LIMIT_CLOSURE_BAM);
    return is_closed ? STATUS_OK : STATUS_CLOSURE;
}

bool plan_is_proved(const plan_t *self, const robot_t *robot)
{
    rigid_t reached;
    joints_t joints;
    int32_t distance_nm = 0;
    int32_t angle_bam = 0;
    if (self->has_target == 0U) {
        return true;
    }
    joints_from_ticks(robot, self->target_ticks, &joints);
    reached = find_pose(self, robot, &self->scanner_zframe, &joints);
    rigid_difference(&reached, &self->scanner_target, &distance_nm, &angle_bam);
    return (distance_nm == 0) && (angle_bam == 0);
}

status_t plan_propose_registration(plan_t *self, const robot_t *robot,
                                   const rigid_t *scanner_zframe, const plan_proposer_t *proposer)
{
    const status_t status = rigid_check(scanner_zframe);
    if (status == STATUS_OK) {
        self->proposed_registration = *scanner_zframe;
        rigid_orthonormalise(&self->proposed_registration);
        self->registration_proposer = *proposer;
        self->has_proposed_registration = 1U;
        weigh_proposals(self, robot);
    }
    return status;
}

status_t plan_propose_entry(plan_t *self, const robot_t *robot, const rigid_t *pose,
                            const plan_proposer_t *proposer)
{
    const status_t status = rigid_check(pose);
    if (status == STATUS_OK) {
        self->proposed_entry = pose->translation;
        self->entry_proposer = *proposer;
        self->has_proposed_entry = 1U;
        weigh_proposals(self, robot);
    }
    return status;
}

status_t plan_propose_target(plan_t *self, const robot_t *robot, const rigid_t *pose,
                             const plan_proposer_t *proposer)
{
    const status_t status = rigid_check(pose);
    if (status == STATUS_OK) {
        self->proposed_target = pose->translation;
        self->target_proposer = *proposer;
        self->has_proposed_target = 1U;
        weigh_proposals(self, robot);
    }
    return status;
}

/* The same one again stays that of the target. */
static void take_entry(plan_t *self, const point_t *entry)
{
    if ((self->has_entry == 0U) || !rigid_is_same_point(&self->entry, entry)) {
        self->is_entry_of_target = 0U;
    }
    self->entry = *entry;
    self->has_entry = 1U;
    plan_seal(self);
}

status_t plan_set_entry(plan_t *self, const rigid_t *pose)
{
    const status_t status = rigid_check(pose);
    if (status == STATUS_OK) {
        take_entry(self, &pose->translation);
    }
    return status;
}

status_t plan_accept_entry(plan_t *self)
{
    if (self->has_proposed_entry == 0U) {
        return STATUS_NOT_PROPOSED;
    }
    take_entry(self, &self->proposed_entry);
    return STATUS_OK;
}

status_t plan_see_needle(plan_t *self, const rigid_t *pose)
{
    const status_t status = rigid_check(pose);
    if (status == STATUS_OK) {
        self->scanner_seen_needle = *pose;
        rigid_orthonormalise(&self->scanner_seen_needle);
        self->has_seen_needle = 1U;
        plan_seal(self);
    }
    return status;
}

status_t plan_withdraw(plan_t *self, const robot_t *robot, plan_part_t part)
{
    uint32_t *const has_part[] = {&self->has_entry, &self->has_proposed_registration,
                                  &self->has_proposed_entry, &self->has_proposed_target};
    status_t status = STATUS_NOT_PROPOSED;
    if (*has_part[part] != 0U) {
        *has_part[part] = 0U;
        self->is_entry_of_target &= self->has_entry;
        weigh_proposals(self, robot);
        status = STATUS_OK;
    }
    return status;
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The plan: what the robot carries (probe), where it stands in the scanner (registration), where
 * its needle shall enter and where it shall go (entry point, target), and the proposals of others.
 * Proposals are shown and decide nothing.
 */
#ifndef BORESIGHT_PLAN_H
#define BORESIGHT_PLAN_H

#include "base/rigid.h"
#include "interface/status.h"
#include "robot/kinematics.h"
#include "robot/robot.h"
#include "robot/steering.h"

#include <stdbool.h>
#include <stdint.h>

/** Connection that proposed something last, and the cycle of that. */
typedef struct {
    uint32_t peer;
    uint32_t cycle;
} plan_proposer_t;

typedef struct {
    rigid_t scanner_zframe; /**< The registration; identity before one is accepted. */
    rigid_t scanner_target; /**< Accepted target as it will be reached: rounded to ticks. */
    int32_t target_ticks[ROBOT_AXIS_MAX];
    point_t entry; /**< Scanner coordinates; decides the depth of the targets to come. */
    rigid_t scanner_seen_needle; /**< As an image shows it on the way to the target; shown only. */
    rigid_t proposed_registration;
    point_t proposed_entry; /**< Scanner coordinates, like everything proposed. */
    point_t proposed_target;
    rigid_t scanner_desired;               /**< The pose the proposals ask for. */
    plan_proposer_t registration_proposer; /**< As the next two valid with its proposal. */
    plan_proposer_t entry_proposer;
    plan_proposer_t target_proposer;
    int32_t desired_ticks[ROBOT_AXIS_MAX];
    steering_t steering;          /**< Of the insertion to the accepted target. */
    probe_t probe;                /**< Valid with has_probe. */
    uint32_t probe_crc;           /**< CRC of the probe alone: it outlives damage of the rest. */
    uint32_t registered_source;   /**< command_source_t of the registration. */
    uint32_t registered_peer;     /**< Its connection or page. */
    uint32_t registered_cycle;    /**< Cycle in which it was accepted. */
    uint32_t is_rotation_ignored; /**< Each 0 or 1. Only the registration's translation counts. */
    uint32_t has_probe;
    uint32_t is_registered;
    uint32_t has_target;
    uint32_t has_entry;
    uint32_t has_seen_needle;
    uint32_t has_proposed_registration;
    uint32_t has_proposed_entry;
    uint32_t has_proposed_target;
    uint32_t is_proposal_reachable;
    uint32_t is_entry_of_target; /**< `entry` lies on the needle's line to the accepted target,
                                    before it, and stood when that was accepted. */
    uint32_t seal; /**< Seal of all before it. It changes seldom: each change seals it. */
} plan_t;

/** Seals it; what is declared here does so itself. */
void plan_seal(plan_t *self);

/**
 * It is not as it was sealed.
 *
 * @satisfies SWR-MEMORY-001
 */
bool plan_is_damaged(const plan_t *self);

/** Starts empty, with the probe of the robot's table. */
void plan_init(plan_t *self, const robot_t *robot);

/**
 * It is damaged: all is forgotten but a probe that its own CRC still proves.
 *
 * @return false when the probe is forgotten too: none is known until another one is sent
 *
 * @satisfies SWR-PROBE-005
 */
bool plan_forget(plan_t *self);

/**
 * Takes a probe that probe_judge() has passed: target, entry point and the proposals on the way are
 * forgotten; the registration stands.
 *
 * @satisfies SWR-PROBE-003
 */
void plan_set_probe(plan_t *self, const probe_t *probe);

/** Origin of a registration, and how it is to be taken. */
typedef struct {
    uint32_t source;
    uint32_t peer;
    uint32_t cycle;
    bool ignores_rotation; /**< Only its translation counts: the axes of the z-frame are those of
                              the scanner. */
} plan_origin_t;

/**
 * Takes a registration, made exactly orthonormal; target and entry point are forgotten.
 *
 * @return STATUS_OK, or what rigid_check() finds: the old registration stands
 *
 * @satisfies SWR-REG-001
 * @satisfies SWR-REG-002
 * @satisfies SWR-PLAN-022
 * @satisfies SWR-PLAN-023
 */
status_t plan_register(plan_t *self, const robot_t *robot, const rigid_t *scanner_zframe,
                       const plan_origin_t *origin);

/**
 * Takes a treatment pose in scanner coordinates as the target, to be gone to from `ticks`. The
 * depth is decided by kinematics_solve(), with the entry point. The needle that was seen is
 * forgotten.
 *
 * @return status as rigid_check() and kinematics_solve(), STATUS_NO_PROBE, STATUS_NOT_REGISTERED,
 * STATUS_CLOSURE
 * when forward kinematics does not return the pose, STATUS_SWITCH_ZONE when an axis would end where
 * its limit switch may be active, or the refusal of a coupled limit that the target or the way
 * there would miss; instead of these STATUS_ENTRY_POINT, with the axis and the end that is missed,
 * where the entry point has decided the depth. There is then no target, not even the one before:
 * who asked for another target must not be taken to the old one.
 *
 * @satisfies SWR-PLAN-004
 * @satisfies SWR-PLAN-015
 * @satisfies SWR-PLAN-017
 * @satisfies SWR-PLAN-020
 * @satisfies SWR-AXIS-020
 */
solution_t plan_set_target(plan_t *self, const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX],
                           const rigid_t *scanner_treatment);

/**
 * Takes how the needle is steered on its way to the accepted target; another target, or none,
 * forgets it.
 *
 * @return as steering_set(), or STATUS_NO_TARGET: what was taken before stands
 *
 * @satisfies SWR-STEER-002
 */
status_t plan_steer(plan_t *self, const robot_t *robot, uint32_t method, uint32_t curvature_per_km,
                    int32_t direction_deg);

/**
 * May the axes go in step from `ticks` to the accepted target? The needle waits meanwhile, and has
 * no part in what axes share.
 *
 * @return STATUS_OK, also without a target; STATUS_NO_PROBE; or the refusal of the coupled limit
 * that the way would leave
 *
 * @satisfies SWR-PLAN-016
 */
solution_t plan_judge_way(const plan_t *self, const robot_t *robot,
                          const int32_t ticks[ROBOT_AXIS_MAX]);

/**
 * Is there a target to line up with, by a confirmed entry point?
 *
 * @return STATUS_OK; STATUS_NO_TARGET; STATUS_NO_ENTRY_POINT unless the entry point was taken
 * before the target, still stands, and lies on the needle's line to it
 *
 * @satisfies SWR-ALIGN-003
 */
status_t plan_judge_entry(const plan_t *self);

/**
 * The positions can no longer be trusted: the target, the entry point, the needle that was seen and
 * what was proposed on the way are forgotten.
 *
 * @satisfies SWR-LINK-003
 */
void plan_forget_target(plan_t *self);

/**
 * Computes the way back: whether forward kinematics of `joints` returns `zframe_treatment`.
 *
 * @return STATUS_OK, or STATUS_CLOSURE beyond LIMIT_CLOSURE_NM or LIMIT_CLOSURE_BAM
 *
 * @satisfies SWR-PLAN-004
 */
status_t plan_confirm(const plan_t *self, const robot_t *robot, const joints_t *joints,
                      const rigid_t *zframe_treatment);

/**
 * Before a move is armed: forward kinematics of the target's ticks returns its pose
 * exactly. The ticks came from inverse kinematics and rounding, which share no code with this way
 * back; that the pose is the one that was asked for was confirmed when it was accepted. True
 * without a target.
 *
 * @satisfies SWR-MEMORY-005
 */
bool plan_is_proved(const plan_t *self, const robot_t *robot);

/**
 * Takes a proposed registration.
 *
 * @return as rigid_check(); what is refused leaves the one before with its proposer
 *
 * @satisfies SWR-IGTL-070
 */
status_t plan_propose_registration(plan_t *self, const robot_t *robot,
                                   const rigid_t *scanner_zframe, const plan_proposer_t *proposer);

/**
 * Takes the place of `pose` (scanner coordinates) as the entry point of the targets to come. A
 * target that was accepted stays as it is: its depth was decided with it; the same entry point
 * again stays that of it.
 *
 * @return as rigid_check()
 *
 * @satisfies SWR-PLAN-017
 * @satisfies SWR-PLAN-019
 */
status_t plan_set_entry(plan_t *self, const rigid_t *pose);

/**
 * The proposed entry point becomes the entry point; it stays proposed. Same meaning.
 *
 * @return STATUS_OK, or STATUS_NOT_PROPOSED
 *
 * @satisfies SWR-PLAN-017
 * @satisfies SWR-PLAN-019
 */
status_t plan_accept_entry(plan_t *self);

/**
 * Takes `pose`, made exactly orthonormal, as the needle that an image shows; used for nothing else
 * than to be shown.
 *
 * @return as rigid_check()
 *
 * @satisfies SWR-MOTION-024
 */
status_t plan_see_needle(plan_t *self, const rigid_t *pose);

/** Part of the plan that plan_withdraw() forgets. */
typedef enum {
    PLAN_ENTRY = 0, /**< The entry point; of the others the proposed one. */
    PLAN_PROPOSED_REGISTRATION = 1,
    PLAN_PROPOSED_ENTRY = 2,
    PLAN_PROPOSED_TARGET = 3
} plan_part_t;

/**
 * Forgets a part of the plan. A target that was accepted stays as it is.
 *
 * @return STATUS_OK, or STATUS_NOT_PROPOSED when there is none
 *
 * @satisfies SWR-PLAN-018
 * @satisfies SWR-PLAN-019
 * @satisfies SWR-PLAN-021
 */
status_t plan_withdraw(plan_t *self, const robot_t *robot, plan_part_t part);

/**
 * Takes the place of `pose` as proposed entry point (scanner coordinates). Same returns.
 *
 * @satisfies SWR-PLAN-018
 */
status_t plan_propose_entry(plan_t *self, const robot_t *robot, const rigid_t *pose,
                            const plan_proposer_t *proposer);

/**
 * Takes a proposed target point. Without a proposed entry point the needle goes to it as the robot
 * has it for a bare point. Same returns.
 *
 * @satisfies SWR-IGTL-111
 */
status_t plan_propose_target(plan_t *self, const robot_t *robot, const rigid_t *pose,
                             const plan_proposer_t *proposer);

#endif

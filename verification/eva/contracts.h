/* SPDX-License-Identifier: Apache-2.0 */
/* Contracts at the borders of modules that Eva checks where they are called, and relies on within.
 * They hold by relations of values that Eva does not keep; a call at which Eva cannot see one is an
 * alarm, which stands in alarms.yml with its reason. */
#ifndef BORESIGHT_EVA_CONTRACTS_H
#define BORESIGHT_EVA_CONTRACTS_H

#include "axis/follower.h"
#include "controller/controller_cards.h"
#include "controller/memory/controller_restore.h"
#include "controller/orders/controller_axis.h"
#include "mode/homing/homing_mode.h"
#include "mode/leg/escort.h"
#include "mode/lists/trajectory_list.h"
#include "mode/mode.h"
#include "mode/velocity/velocity_bound.h"
#include "motion/profile.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"
#include "controller/controller_order.h"

/*@ requires axis: index < ROBOT_AXIS_MAX && leader < ROBOT_AXIS_MAX; */
bool follower_is_of(const robot_t *robot, uint32_t index, uint32_t leader);

/*@ requires axis: leader < ROBOT_AXIS_MAX; */
bool follower_has_one(const robot_t *robot, uint32_t leader);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool follower_is_in_block(const robot_t *robot, uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
uint32_t follower_leader(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index);

/*@ requires axis: leader < ROBOT_AXIS_MAX; */
void follower_tie(const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX], uint32_t leader);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
void controller_lose_card(controller_t *self, const cycle_t *cycle, uint32_t index,
                          card_loss_t loss);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
void controller_observe_card(controller_t *self, const cycle_t *cycle, uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
void controller_compare(controller_t *self, const cycle_t *cycle, uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
void controller_forget_reference(controller_t *self, const cycle_t *cycle, uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
void homing_mode_begin_axis(const mode_frame_t *frame, uint32_t index, mode_result_t *result);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool escort_is_for(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
void escort_begin(escort_t *self, const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX],
                  uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
uint32_t escort_pace(const escort_t *self, uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool escort_was_missing(const escort_t *self, uint32_t index);

/*@ requires axis: axis < ROBOT_AXIS_MAX; */
void trajectory_list_way(const trajectory_row_t *from, const trajectory_row_t *to, uint32_t axis,
                         cubic_t *way);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool mode_needs(const mode_state_t *self, uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
velocity_bound_t velocity_bound_of(const velocity_mode_t *self, const mode_frame_t *frame,
                                   uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool velocity_bound_is_switch(const velocity_mode_t *self, const mode_frame_t *frame,
                              uint32_t index);

/*@ requires axis: axis < ROBOT_AXIS_MAX; */
int32_t profile_position_ticks(const profile_t *self, uint32_t axis);

/*@ requires axis: axis < ROBOT_AXIS_MAX; */
int32_t profile_speed_ticks_per_s_q8(const profile_t *self, uint32_t axis);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool coupled_guard_bars_homing(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool coupled_guard_is_missed(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                             uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool coupled_guard_is_last(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool coupled_guard_is_known(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                            uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
solution_t coupled_guard_judge(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index, int32_t ticks);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
solution_t coupled_guard_judge_homing(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                                      uint32_t index);

/*@ requires axis: index < ROBOT_AXIS_MAX; */
bool needle_forbids_jog(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index,
                        bool is_upwards);

/*@ requires axis: request->sealed.way.axis < ROBOT_AXIS_MAX; */
void controller_arm(controller_t *self, const cycle_t *cycle, const command_t *command,
                    mode_kind_t kind, const mode_request_t *request);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/* Contracts at the borders of modules that Eva checks where they are called, and relies on within.
 * They hold by relations of values that Eva does not keep; a call at which Eva cannot see one, and
 * a function of which it cannot see what it ensures, is an alarm, which stands in alarms.yml. */
#ifndef BORESIGHT_EVA_CONTRACTS_H
#define BORESIGHT_EVA_CONTRACTS_H

#include "axis/count_balance.h"
#include "axis/follower.h"
#include "axis/homing.h"
#include "axis/supervision.h"
#include "base/fixed.h"
#include "controller/controller_order.h"
#include "controller/controller_cards.h"
#include "controller/memory/controller_restore.h"
#include "controller/orders/controller_axis.h"
#include "mode/homing/homing_mode.h"
#include "mode/leg/escort.h"
#include "mode/lists/program_list.h"
#include "mode/lists/trajectory_list.h"
#include "mode/mode.h"
#include "mode/velocity/velocity_bound.h"
#include "limits/requirement_limits.h"
#include "motion/cubic.h"
#include "motion/motor_model.h"
#include "motion/profile.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"
#include "safety/speed_cap.h"

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

/*@ requires axis: axis < ROBOT_AXIS_MAX;
    requires cycles: self->ramp_cycles <= (1 << 18) && self->cruise_cycles <= (1 << 24);
    requires cycle: self->cycle <= 2 * self->ramp_cycles + self->cruise_cycles;
    requires way: -(1 << 24) <= self->start_ticks[axis] <= (1 << 24) &&
             -(1 << 24) <= self->end_ticks[axis] <= (1 << 24); */
int32_t profile_position_ticks(const profile_t *self, uint32_t axis);

/*@ requires axis: axis < ROBOT_AXIS_MAX;
    requires cycles: self->ramp_cycles <= (1 << 18) && self->cruise_cycles <= (1 << 24);
    requires cycle: self->cycle <= 2 * self->ramp_cycles + self->cruise_cycles;
    requires way: -(1 << 24) <= self->start_ticks[axis] <= (1 << 24) &&
             -(1 << 24) <= self->end_ticks[axis] <= (1 << 24); */
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

/* Speed of any motor that the robot compiler accepts. */
#define EVA_SPEED_Q8 (256 * (int64_t)LIMIT_AXIS_SPEED_MOST_TICKS_PER_S)
/* Control points within any travel that it accepts, and as much beyond. */
#define EVA_POINT_Q8 (INT64_C(1) << 30)

/*@ ensures room: self->count <= LIMIT_TRAJECTORY_ROWS; */
solution_t trajectory_list_add(trajectory_list_t *self,
                               trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS], const robot_t *robot,
                               uint32_t index, const trajectory_row_t *row);

/*@ ensures room: self->count <= LIMIT_PROGRAM_STEPS; */
solution_t program_list_add(program_list_t *self, const robot_t *robot,
                            const int32_t target_ticks[ROBOT_AXIS_MAX], uint32_t index,
                            const program_step_t *step);

/* More than any axis may move within LIMIT_SPEED_CAP_US, as speed_cap_t counts it. */
#define EVA_ACCOUNT (INT64_C(1) << 50)

/*@ ensures account: 0 <= self->left <= EVA_ACCOUNT; */
bool speed_cap_step(speed_cap_t *self, const axis_config_t *config, uint32_t percent,
                    int32_t position_ticks, uint32_t elapsed_us);

/*@ requires divisor: divisor > 0;
    ensures quotient: \result == numerator / divisor; */
uint64_t fixed_divide(uint64_t numerator, uint64_t divisor);

/*@ requires divisor: divisor > 0;
    ensures quotient: \result == value / divisor; */
int64_t fixed_divide_signed(int64_t value, int64_t divisor);

/*@ requires divisor: denominator > 0;
    ensures quotient: numerator / denominator - 1 <= \result <= numerator / denominator + 1; */
int64_t fixed_divide_rounded(int64_t numerator, int64_t denominator);

/*@ requires coordinates: -(1LL << 60) <= vector[0] <= (1LL << 60) &&
             -(1LL << 60) <= vector[1] <= (1LL << 60) &&
             -(1LL << 60) <= vector[2] <= (1LL << 60);
    ensures length: 0 <= \result <= (1LL << 61); */
int64_t fixed_normalise(const int64_t vector[3], int32_t unit_q30[3]);

/*@ requires speed: -EVA_SPEED_Q8 <= self->speed_ticks_per_s_q8 <= EVA_SPEED_Q8;
    ensures speed: -EVA_SPEED_Q8 <= self->speed_ticks_per_s_q8 <= EVA_SPEED_Q8; */
int64_t motor_model_run_q16(motor_model_t *self, const axis_config_t *config,
                            const card_drive_t *drive, uint32_t elapsed_us);

/*@ ensures speed: 0 <= \result <= EVA_SPEED_Q8; */
int64_t motor_model_steady_q8(const axis_config_t *config, const card_drive_t *drive);

/*@ requires speed: -EVA_SPEED_Q8 <= self->speed_ticks_per_s_q8 <= EVA_SPEED_Q8;
    requires place: -(1LL << 50) <= self->setpoint_q8 <= (1LL << 50); */
void homing_step(homing_t *self, const axis_config_t *config, axis_reference_t leg,
                 int32_t position_ticks);

/* Ways of the model and their sums of hundredths; shares of a way, of which the largest is that of
 * the table of regimes. */
#define EVA_WAY_Q16 (INT64_C(1) << 40)
#define EVA_WAY_E2_Q16 (INT64_C(1) << 48)
#define EVA_SUM_E2_Q16 (INT64_C(1) << 60)
#define EVA_SHOWN_Q16 (INT64_C(1) << 50)
#define EVA_IS_CALIBRATION(shown)                                                                  \
    (0 <= (shown).model_q16 <= EVA_SHOWN_Q16 && (shown).least_percent <= 200 &&                    \
     (shown).most_percent <= 200)

/*@ requires due: -EVA_WAY_Q16 <= self->sealed.due_q16 <= EVA_WAY_Q16;
    ensures due: -EVA_WAY_Q16 <= self->sealed.due_q16 <= EVA_WAY_Q16; */
uint32_t supervision_step(supervision_t *self, const axis_config_t *config,
                          const supervision_view_t *view);

/*@ requires window: 0 <= self->model_q16 <= EVA_WAY_Q16 &&
             0 <= self->least_e2_q16 <= EVA_WAY_E2_Q16 && 0 <= self->most_e2_q16 <= EVA_WAY_E2_Q16;
    requires sums: 0 <= self->short_e2_q16 <= EVA_SUM_E2_Q16 &&
             0 <= self->over_e2_q16 <= EVA_SUM_E2_Q16;
    requires calibrations: EVA_IS_CALIBRATION(self->calibrations[0]) &&
             EVA_IS_CALIBRATION(self->calibrations[1]);
    ensures window: 0 <= self->model_q16 <= EVA_WAY_Q16 &&
            0 <= self->least_e2_q16 <= EVA_WAY_E2_Q16 && 0 <= self->most_e2_q16 <= EVA_WAY_E2_Q16;
    ensures sums: 0 <= self->short_e2_q16 <= EVA_SUM_E2_Q16 &&
            0 <= self->over_e2_q16 <= EVA_SUM_E2_Q16;
    ensures calibrations: EVA_IS_CALIBRATION(self->calibrations[0]) &&
            EVA_IS_CALIBRATION(self->calibrations[1]); */
bool count_balance_step(count_balance_t *self, const axis_config_t *config,
                        const count_cycle_t *cycle);

/*@ requires span: span_ms <= LIMIT_TRAJECTORY_STEP_MOST_MS;
    requires speeds: -(int)LIMIT_AXIS_SPEED_MOST_TICKS_PER_S <= from->speed_ticks_per_s <=
             (int)LIMIT_AXIS_SPEED_MOST_TICKS_PER_S &&
             -(int)LIMIT_AXIS_SPEED_MOST_TICKS_PER_S <= to->speed_ticks_per_s <=
             (int)LIMIT_AXIS_SPEED_MOST_TICKS_PER_S; */
void cubic_set(cubic_t *self, const cubic_end_t *from, const cubic_end_t *to, uint32_t span_ms);

/*@ requires share: share_q20 <= CUBIC_ONE_Q20; */
int32_t cubic_position_ticks(const cubic_t *self, uint32_t share_q20);

/*@ requires share: share_q20 <= CUBIC_ONE_Q20; */
int32_t cubic_speed_ticks_per_s_q8(const cubic_t *self, uint32_t share_q20);

/*@ requires points: -EVA_POINT_Q8 <= self->at_q8[0] <= EVA_POINT_Q8 &&
             -EVA_POINT_Q8 <= self->at_q8[1] <= EVA_POINT_Q8 &&
             -EVA_POINT_Q8 <= self->at_q8[2] <= EVA_POINT_Q8 &&
             -EVA_POINT_Q8 <= self->at_q8[3] <= EVA_POINT_Q8; */
bool cubic_keeps_speed(const cubic_t *self, int32_t speed_ticks_per_s);

/*@ requires points: -EVA_POINT_Q8 <= self->at_q8[0] <= EVA_POINT_Q8 &&
             -EVA_POINT_Q8 <= self->at_q8[1] <= EVA_POINT_Q8 &&
             -EVA_POINT_Q8 <= self->at_q8[2] <= EVA_POINT_Q8 &&
             -EVA_POINT_Q8 <= self->at_q8[3] <= EVA_POINT_Q8; */
bool cubic_keeps_acceleration(const cubic_t *self, int32_t ticks_per_s2);

/*@ requires axis: request->sealed.way.axis < ROBOT_AXIS_MAX; */
void controller_arm(controller_t *self, const cycle_t *cycle, const command_t *command,
                    mode_kind_t kind, const mode_request_t *request);

/*@ requires room: cycle->outputs->answer_count < CONTROLLER_ANSWERS; */
answer_t *controller_add_answer(const controller_t *self, const cycle_t *cycle);

#endif

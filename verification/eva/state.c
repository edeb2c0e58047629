/* SPDX-License-Identifier: Apache-2.0 */
/* The state after any number of cycles, so that Eva needs few rounds of the endless loop. Nothing
 * is assumed: more states than the start are followed, and a value that a cycle adds is followed as
 * well. Members that the robot's table gives keep their value. */
#include "state.h"

#include "contracts.h"

#include <__fc_builtin.h>

#define ANY(member) Frama_C_make_unknown((char *)&(member), sizeof(member))
#define UP_TO(member, most) ((member) = Frama_C_unsigned_int_interval(0U, (most)))
#define WITHIN(member, most) ((member) = Frama_C_int_interval(-(most), (most)))
#define WITHIN_LONG(member, most) ((member) = Frama_C_long_long_interval(-(most), (most)))
#define FROM_0_LONG(member, most) ((member) = Frama_C_long_long_interval(0, (most)))
#define IS_BOOL(member) UP_TO(member, 1U)
/* A region of a chart, and its copy. */
#define LEAVES(chart, region, last)                                                                \
    UP_TO((chart).region, (last));                                                                 \
    (chart).region##_inverse = Frama_C_unsigned_int_interval(~(uint32_t)(last), ~UINT32_C(0))
#define CLOCK(chart)                                                                               \
    ANY((chart).now_us);                                                                           \
    ANY((chart).trace)

static void age_drive(card_drive_t *drive)
{
    UP_TO(drive->mode, (uint32_t)CARD_DRIVE_ANALOG);
    IS_BOOL(drive->direction);
    ANY(drive->duty);
    UP_TO(drive->amplitude, 255U);
}

static void age_link(link_t *link, uint32_t slot)
{
    LEAVES(link->chart, state, (uint32_t)CARD_LINK_STATE_LOST);
    CLOCK(link->chart);
    ANY(link->report);
    link->report.slot = Frama_C_nondet(0, (int)slot);
    UP_TO(link->report.card_type, 255U);
    UP_TO(link->report.firmware, 0xFFFFFFU);
    UP_TO(link->report.limits_raw, 255U);
    UP_TO(link->report.limits, 255U);
    UP_TO(link->report.illegal_edges, 65535U);
    UP_TO(link->report.supply_mv, 65535U);
    UP_TO(link->report.current_ma, 65535U);
    UP_TO(link->report.applied.mode, 15U);
    UP_TO(link->report.applied.direction, 15U);
    UP_TO(link->report.applied.amplitude, 65535U);
    UP_TO(link->last_error, 6U);
    link->sealed.card_type = Frama_C_nondet(0, (int)link->sealed.card_type);
    ANY(link->sampled_us);
    ANY(link->reported_us);
    IS_BOOL(link->is_timed);
    ANY(link->lost_heartbeat);
    ANY(link->frames_out_of_order);
    ANY(link->frames_missed);
    IS_BOOL(link->is_fresh);
    age_drive(&link->sealed.sent);
    age_drive(&link->sealed.sent_before);
    ANY(link->sealed.sent_sequence);
    ANY(link->sealed.sent_sequence_before);
    ANY(link->sealed.age_cycles);
    ANY(link->sealed.frame_errors);
    ANY(link->sealed.echo_mismatches);
    IS_BOOL(link->sealed.has_report);
    UP_TO(link->sealed.cause, (uint32_t)LINK_CAUSE_LOOP_LATE);
}

static void age_encoder(encoder_t *encoder)
{
    ANY(*encoder);
    IS_BOOL(encoder->has_reading);
    IS_BOOL(encoder->is_at_rest);
}

static void age_servo(servo_t *servo)
{
    WITHIN_LONG(servo->model.speed_ticks_per_s_q8, EVA_SPEED_Q8);
    IS_BOOL(servo->direction);
    ANY(servo->rest_us);
    IS_BOOL(servo->is_driving);
    ANY(servo->duty);
    WITHIN_LONG(servo->unseen_q16, INT64_C(1) << 32);
}

static void age_homing(homing_t *homing)
{
    ANY(*homing);
    WITHIN(homing->speed_ticks_per_s_q8, (int32_t)EVA_SPEED_Q8);
    UP_TO(homing->leg, (uint32_t)AXIS_REFERENCE_VERIFIED);
    UP_TO(homing->ramp, (uint32_t)AXIS_REFERENCE_VERIFIED);
    IS_BOOL(homing->has_nearest);
}

static void age_account(count_balance_t *account)
{
    FROM_0_LONG(account->model_q16, EVA_WAY_Q16);
    FROM_0_LONG(account->least_e2_q16, EVA_WAY_E2_Q16);
    FROM_0_LONG(account->most_e2_q16, EVA_WAY_E2_Q16);
    FROM_0_LONG(account->short_e2_q16, EVA_SUM_E2_Q16);
    FROM_0_LONG(account->over_e2_q16, EVA_SUM_E2_Q16);
    ANY(account->window_us);
    ANY(account->counted_ticks);
    account->direction = Frama_C_int_interval(-1, 1);
    ANY(account->run_us);
    ANY(account->rest_us);
    UP_TO(account->regime, COUNT_REGIMES - 1U);
    IS_BOOL(account->has_count);
    ANY(account->unsure_us);
    ANY(account->percent);
    for (uint32_t i = 0U; i < COUNT_REGIMES; i++) {
        FROM_0_LONG(account->calibrations[i].model_q16, EVA_SHOWN_Q16);
        ANY(account->calibrations[i].counted_ticks);
        ANY(account->calibrations[i].time_us);
        UP_TO(account->calibrations[i].least_percent, 200U);
        UP_TO(account->calibrations[i].most_percent, 200U);
    }
}

static void age_supervision(supervision_t *supervision)
{
    supervision_sealed_t *const sealed = &supervision->sealed;
    ANY(sealed->mark_ticks);
    IS_BOOL(sealed->is_upwards);
    ANY(sealed->backwards_ticks);
    ANY(sealed->places_ticks);
    ANY(sealed->lowest_ticks);
    ANY(sealed->highest_ticks);
    UP_TO(sealed->place_us, 99999U);
    UP_TO(sealed->place, SUPERVISION_PLACES - 1U);
    ANY(sealed->off_us);
    ANY(sealed->off_ticks);
    ANY(sealed->position_ticks);
    WITHIN_LONG(sealed->model.speed_ticks_per_s_q8, EVA_SPEED_Q8);
    WITHIN_LONG(sealed->due_q16, EVA_WAY_Q16);
    ANY(sealed->silent_us);
    ANY(sealed->missing_ticks);
    ANY(sealed->drives);
    age_account(&sealed->account);
    ANY(sealed->pace);
    LEAVES(supervision->stall, state, (uint32_t)STALL_WATCHDOG_STATE_STALLED);
    ANY(supervision->stall.no_progress_us);
    IS_BOOL(supervision->stall.no_progress_is_armed);
    CLOCK(supervision->stall);
}

static void age_axis_chart(axis_chart_t *chart)
{
    LEAVES(*chart, power, (uint32_t)AXIS_POWER_FAULT);
    LEAVES(*chart, reference, (uint32_t)AXIS_REFERENCE_VERIFIED);
    CLOCK(*chart);
}

static void age_axis(axis_t *axis)
{
    age_encoder(&axis->sealed.encoder);
    UP_TO(axis->sealed.limit_switches, 255U);
    age_servo(&axis->sealed.servo);
    age_homing(&axis->sealed.homing);
    ANY(axis->sealed.drift);
    ANY(axis->sealed.home_correction_ticks);
    UP_TO(axis->sealed.place, AXIS_PLACE_COUNTED | AXIS_PLACE_BROKEN);
    ANY(axis->sealed.elsewhere_ticks);
    ANY(axis->sealed.contradiction_ticks);
    ANY(axis->sealed.setpoint_ticks);
    ANY(axis->sealed.setpoint_speed_ticks_per_s_q8);
    age_supervision(&axis->supervision);
}

static void age_record(axis_record_t *record)
{
    FROM_0_LONG(record->sealed.speed_cap.left, EVA_ACCOUNT);
    ANY(record->sealed.speed_cap.position_ticks);
    ANY(record->sealed.reason_hold.flickering);
    ANY(record->sealed.reason_hold.shown);
    UP_TO(record->sealed.reason_hold.left_us[0], LIMIT_REASON_HOLD_US);
    UP_TO(record->sealed.reason_hold.left_us[1], LIMIT_REASON_HOLD_US);
    UP_TO(record->sealed.reason_hold.left_us[2], LIMIT_REASON_HOLD_US);
    UP_TO(record->sealed.reason_hold.left_us[3], LIMIT_REASON_HOLD_US);
    UP_TO(record->sealed.speed_cap_percent, 100U);
    ANY(record->sealed.permit_since_cycle);
    UP_TO(record->sealed.grade, (uint32_t)AXIS_REFERENCE_VERIFIED);
}

static void age_mode(mode_state_t *mode, uint32_t axis_count)
{
    leg_t *const leg = &mode->sealed.leg;
    UP_TO(mode->sealed.kind, MODE_KIND_COUNT - 1U);
    ANY(leg->profile.ramp_cycles);
    ANY(leg->profile.cruise_cycles);
    ANY(leg->profile.cycle);
    ANY(leg->axes);
    IS_BOOL(leg->is_running);
    ANY(leg->settled_cycles);
    ANY(leg->overtime_cycles);
    UP_TO(mode->sealed.escort.search, (uint32_t)ESCORT_SEARCH_IN_VAIN);
    ANY(mode->sealed.escort.wait_cycles);
    ANY(mode->sealed.trajectory.row);
    ANY(mode->sealed.trajectory.time_us);
    IS_BOOL(mode->sealed.trajectory.is_on_way);
    UP_TO(mode->sealed.trajectory.pace, LIMIT_TRAJECTORY_RAMP_US / LIMIT_CYCLE_US);
    ANY(mode->sealed.trajectory.behind_us);
    UP_TO(mode->sealed.list.total, LIMIT_TRAJECTORY_ROWS);
    UP_TO(mode->sealed.list.count, LIMIT_TRAJECTORY_ROWS);
    ANY(mode->sealed.list.crc);
    IS_BOOL(mode->sealed.list.is_whole);
    UP_TO(mode->sealed.list.source, 2U);
    ANY(mode->sealed.list.peer);
    UP_TO(mode->sealed.program.stage, (uint32_t)PROGRAM_STAGE_DWELLS);
    ANY(mode->sealed.program.step);
    ANY(mode->sealed.program.dwelt_us);
    ANY(mode->sealed.program.dwell_ms);
    IS_BOOL(mode->sealed.program.is_dose_due);
    ANY(mode->request.sealed.move);
    ANY(mode->request.sealed.span);
    ANY(mode->request.sealed.axes);
    UP_TO(mode->request.sealed.way.axis, ROBOT_AXIS_MAX - 1U);
    ANY(mode->request.sealed.way.end_ticks);
    ANY(mode->request.own.velocity.axes);
    ANY(mode->request.own.velocity.time_ms);
    ANY(mode->request.own.velocity.way_ticks);
    ANY(mode->request.own.velocity.speeds_ticks_per_s);
    UP_TO(mode->request.own.velocity.stage, 2U);
    ANY(mode->request.own.velocity.left_cycles);
    ANY(mode->request.own.velocity.rest);
    ANY(mode->request.own.velocity.barred);
    UP_TO(mode->request.own.velocity.refusal, 24U);
    UP_TO(mode->request.own.velocity.refused_axis, axis_count - 1U);
    ANY(mode->request.own.sweep.is_free);
    ANY(mode->request.own.sweep.stage);
    ANY(mode->request.own.sweep.word);
    ANY(mode->request.own.sweep.start_ticks);
    ANY(mode->request.own.sweep.up_ticks);
    ANY(mode->request.own.sweep.most_ticks);
}

static void age_plan(plan_t *plan)
{
    ANY(plan->scanner_zframe);
    ANY(plan->scanner_target);
    ANY(plan->entry);
    ANY(plan->scanner_seen_needle);
    ANY(plan->proposed_registration);
    ANY(plan->proposed_entry);
    ANY(plan->proposed_target);
    ANY(plan->scanner_desired);
    ANY(plan->registration_proposer);
    ANY(plan->entry_proposer);
    ANY(plan->target_proposer);
    ANY(plan->probe);
    ANY(plan->registered_source);
    ANY(plan->registered_peer);
    ANY(plan->registered_cycle);
    IS_BOOL(plan->is_rotation_ignored);
    IS_BOOL(plan->has_probe);
    IS_BOOL(plan->is_registered);
    IS_BOOL(plan->has_target);
    IS_BOOL(plan->has_entry);
    IS_BOOL(plan->has_seen_needle);
    IS_BOOL(plan->has_proposed_registration);
    IS_BOOL(plan->has_proposed_entry);
    IS_BOOL(plan->has_proposed_target);
    IS_BOOL(plan->is_proposal_reachable);
    IS_BOOL(plan->is_entry_of_target);
}

/* What there is once. */
static void age_rest(controller_t *state)
{
    IS_BOOL(state->pedal.sealed.is_released);
    LEAVES(state->pedal.chart, state, (uint32_t)PEDAL_GATE_STATE_FAULT);
    CLOCK(state->pedal.chart);
    ANY(state->pedal.chart.disagreement_us);
    IS_BOOL(state->pedal.chart.disagreement_is_armed);
    LEAVES(state->loop.chart, state, (uint32_t)LOOP_GUARD_STATE_STOPPED);
    CLOCK(state->loop.chart);
    ANY(state->loop.sealed);
    ANY(state->confirm.sealed.held_cycles);
    IS_BOOL(state->confirm.sealed.is_proven);
    ANY(state->authority.sealed);
    UP_TO(state->authority.sealed.request, 4U);
    UP_TO(state->authority.sealed.request_axis, state->sealed.axis_count - 1U);
    LEAVES(state->authority.chart, state, (uint32_t)AUTHORITY_STATE_ENDING);
    CLOCK(state->authority.chart);
    LEAVES(state->estop, state, (uint32_t)ESTOP_LATCH_STATE_LATCHED);
    CLOCK(state->estop);
    LEAVES(state->procedure.workphase, state, WORKPHASE_COUNT - 1U);
    CLOCK(state->procedure.workphase);
    LEAVES(state->procedure.arming, state, (uint32_t)ARMING_STATE_MOVING);
    CLOCK(state->procedure.arming);
    ANY(state->procedure.arming.pedal_missing_us);
    IS_BOOL(state->procedure.arming.pedal_missing_is_armed);
    age_plan(&state->plan);
    ANY(state->sealed.pending.id);
    ANY(state->sealed.pending.source);
    UP_TO(state->sealed.pending.kind, COMMAND_KIND_COUNT - 1U);
    UP_TO(state->sealed.pending.asked, WORKPHASE_COUNT - 1U);
    IS_BOOL(state->sealed.pending.is_waiting);
    IS_BOOL(state->sealed.has_arrived);
    UP_TO(state->sealed.unexpected_cards, (1U << CARD_SLOT_COUNT) - 1U);
    UP_TO(state->sealed.table_damage, 1024U);
    UP_TO(state->sealed.vain_axis, ROBOT_AXIS_MAX);
    UP_TO(state->sealed.vain_card, CARD_SLOT_COUNT);
    ANY(state->sealed.vain_start_ups);
    ANY(state->sealed.vain_moves);
    ANY(state->sealed.vain_event);
    UP_TO(state->sealed.account_state, 2U);
    IS_BOOL(state->sealed.is_box_settled);
    IS_BOOL(state->sealed.was_gate_open);
    ANY(state->sealed.was_scanner_active);
    UP_TO(state->sealed.has_started, 1U);
}

/* What only counts, or has a seal or a checksum of its own. */
static void age_counters(controller_t *state)
{
    ANY(state->sealed.cycle);
    ANY(state->sealed.time_us);
    ANY(state->sealed.sequence);
    ANY(state->sealed.events);
    ANY(state->sealed.events_lost);
    ANY(state->health);
    ANY(state->cycles_lost);
    ANY(state->unrecorded);
    ANY(state->recording_left_min);
    ANY(state->unread);
    ANY(state->last_event);
    ANY(state->refused_cycle);
    UP_TO(state->program.total, LIMIT_PROGRAM_STEPS);
    UP_TO(state->program.count, LIMIT_PROGRAM_STEPS);
    ANY(state->program.crc);
    IS_BOOL(state->program.is_whole);
    ANY(state->program.source);
    ANY(state->program.target_crc);
    ANY(state->program.seal);
    ANY(state->program.steps);
    ANY(state->rows);
    ANY(state->way.seal);
    ANY(state->seals);
    ANY(state->account.seal);
    UP_TO(state->account.homed, (1U << state->sealed.axis_count) - 1U);
    IS_BOOL(state->is_end_reported);
    IS_BOOL(state->is_estop_reported);
}

void age_state(controller_t *state)
{
    /*@ loop unroll CARD_SLOT_COUNT; */
    for (uint32_t i = 0U; i < CARD_SLOT_COUNT; i++) {
        age_link(&state->links[i], i);
    }
    /*@ loop unroll ROBOT_AXIS_MAX; */
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        age_axis_chart(&state->axes[i].chart);
    }
    /*@ loop unroll ROBOT_AXIS_MAX; */
    for (uint32_t i = 0U; i < state->sealed.axis_count; i++) {
        age_axis(&state->axes[i]);
        age_record(&state->records[i]);
        ANY(state->mode.sealed.leg.profile.start_ticks[i]);
        ANY(state->mode.sealed.leg.profile.end_ticks[i]);
        ANY(state->mode.request.own.velocity.start_ticks[i]);
        ANY(state->account.from_readings[i]);
        ANY(state->way.from_ticks[i]);
        UP_TO(state->account.ways_ticks[i], INT32_MAX);
        ANY(state->plan.target_ticks[i]);
        ANY(state->plan.desired_ticks[i]);
        ANY(state->way.to_ticks[i]);
    }
    age_mode(&state->mode, state->sealed.axis_count);
    age_rest(state);
    age_counters(state);
}

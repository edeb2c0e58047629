/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/motion_places.h"

#include "supervise/watch/homing_part.h"
#include "supervise/watch/truth.h"

#include <math.h>
#include <string.h>

#define BELIEVED_MM 1.0
#define BELIEVED_DEG 9.0
#define OFF_CYCLES 10U
#define SWEPT_S 5.0   /* A run of a sweep. */
#define NEEDLE_MM 0.3 /* 0.2 mm, and what the motor runs on in the cycles of the detection. */
#define REACHED_MM 0.1
#define REACHED_DEG 1.0
#define NEEDLE_OUT_MM 0.625
#define HOME_MM 0.05 /* Tolerance of the place where homing sees a switch. */
#define HOME_DEG 0.2

static const axis_config_t *config_of(const rig_t *rig, uint32_t axis)
{
    return &rig->box.robot->axes[axis];
}

static bool is_length(const rig_t *rig, uint32_t axis)
{
    return config_of(rig, axis)->unit == (uint8_t)AXIS_UNIT_MM;
}

static double measure(const rig_t *rig, uint32_t axis, double ticks)
{
    return truth_measure(config_of(rig, axis), ticks);
}

/* The system says that this axis is not to be trusted. */
static bool is_doubted(const rig_t *rig, uint32_t axis)
{
    return !homing_part_is_homed(rig, axis) ||
           (rig->outputs.snapshot.axes[axis].power == (uint32_t)AXIS_POWER_FAULT);
}

static bool is_driven(const rig_t *rig, uint32_t axis)
{
    return rig->box.axes[axis].card.applied.mode != (uint32_t)CARD_DRIVE_OFF;
}

/* Counts in a sweep are compared with no expected speed: until it ends, an encoder that is or was
 * broken may have lost those of a run, or made too much. */
static void note_sweep(motion_oracle_t *self, const rig_t *rig, uint32_t axis, double truth)
{
    const double off = truth - (double)rig->outputs.snapshot.axes[axis].position_ticks;
    const double run = config_of(rig, axis)->full_speed_ticks_per_s * SWEPT_S;
    const bool is_swept = (self->order_watch.kind == (uint32_t)COMMAND_SWEEP) &&
                          (self->order_watch.swept_axis == axis);
    if (!is_swept || is_doubted(rig, axis)) {
        self->swept_off[axis] = 0.0;
    } else if ((fabs(off) <= run) && (rig->box.axes[axis].encoder.fault != SIM_ENCODER_NORMAL)) {
        self->swept_off[axis] = off;
    } else {
        /* It stays. */
    }
}

/* An axis without a switch may be taken where it stands once: the operator has put it there. */
static void judge_belief(motion_oracle_t *self, const rig_t *rig, uint32_t axis, double truth)
{
    const double believed = rig->outputs.snapshot.axes[axis].position_ticks;
    const double away = fabs(measure(rig, axis, truth - believed - self->swept_off[axis]));
    const bool is_astray =
        !is_doubted(rig, axis) && (away > (is_length(rig, axis) ? BELIEVED_MM : BELIEVED_DEG));
    self->astray_cycles[axis] = is_astray ? (self->astray_cycles[axis] + 1U) : 0U;
    if (self->astray_cycles[axis] > OFF_CYCLES) {
        motion_oracle_complain(self, rig, SENTENCE_BELIEVED, axis, away);
    }
}

/* The allowed way, and the way of the motor until it is noticed. An encoder that shows half of a
 * way is found out after twice as much. */
static double most_off(motion_oracle_t *self, const rig_t *rig, uint32_t axis)
{
    const double allowed = truth_in_words(
        config_of(rig, axis)->unit, is_length(rig, axis) ? LIMIT_REST_WAY_NM : LIMIT_REST_WAY_BAM);
    const double running = config_of(rig, axis)->full_speed_ticks_per_s;
    const bool is_half = rig->box.axes[axis].encoder.fault == SIM_ENCODER_HALF;
    const uint32_t left = self->half_cycles[axis];
    self->half_cycles[axis] = is_half ? MOTION_ORACLE_SECOND : ((left > 0U) ? (left - 1U) : 0U);
    return (allowed * ((self->half_cycles[axis] > 0U) ? 2.0 : 1.0)) +
           measure(rig, axis, running * LIMIT_REST_NOTICE_US / 1e6);
}

static void judge_rest(motion_oracle_t *self, const rig_t *rig, uint32_t axis, double truth)
{
    const uint32_t place = self->off_cycles[axis] % MOTION_ORACLE_SECOND;
    const double most = most_off(self, rig, axis);
    if (is_driven(rig, axis)) {
        self->off_cycles[axis] = 0U;
        return;
    }
    const bool is_full = self->off_cycles[axis] >= MOTION_ORACLE_SECOND;
    const double before = is_full ? self->rest[axis][place] : self->rest[axis][0];
    const double way = fabs(measure(rig, axis, truth - before));
    self->rest[axis][place] = truth;
    self->off_cycles[axis]++;
    if ((self->off_cycles[axis] > OFF_CYCLES) && !is_doubted(rig, axis) && (way > most)) {
        motion_oracle_complain(self, rig, SENTENCE_OFF, axis, way);
    }
}

static void judge_needle(motion_oracle_t *self, const rig_t *rig, double truth)
{
    const uint32_t needle = rig->box.robot->needle_axis;
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const bool is_started = shown->workphase == (uint32_t)WORKPHASE_START_UP;
    const bool is_homing =
        (shown->order == (uint32_t)ARMING_STATE_MOVING) &&
        (is_started ? !homing_part_is_homed(rig, needle) : homing_part_is_homing(rig, needle));
    if (!is_homing || !self->was_homing || (truth < self->needle_from)) {
        self->needle_from = truth;
    }
    self->was_homing = is_homing;
    const double forwards = measure(rig, needle, truth - self->needle_from);
    if (forwards > NEEDLE_MM) {
        motion_oracle_complain(self, rig, SENTENCE_NEEDLE, needle, forwards);
    }
}

/* The shown position is at the target, and the true one no farther from it than a broken part
 * hides.
 */
static double beyond_target(const motion_oracle_t *self, const rig_t *rig, uint32_t axis,
                            double truth, bool is_disturbed)
{
    const double hidden = is_length(rig, axis) ? BELIEVED_MM : BELIEVED_DEG;
    const double shown = rig->outputs.snapshot.axes[axis].position_ticks;
    const double target = self->target_ticks[axis];
    const double away = fabs(measure(rig, axis, truth - target));
    const bool is_there = fabs(measure(rig, axis, shown - target)) <=
                          (is_length(rig, axis) ? REACHED_MM : REACHED_DEG);
    const double most =
        (is_length(rig, axis) ? REACHED_MM : REACHED_DEG) + (is_disturbed ? hidden : 0.0);
    return (is_there && homing_part_is_homed(rig, axis) && (away <= most)) ? 0.0 : away;
}

static void judge_reached(motion_oracle_t *self, const rig_t *rig,
                          const double truth[ROBOT_AXIS_MAX], bool is_disturbed)
{
    const bool is_said = rig->outputs.snapshot.next_step == (uint32_t)NEXT_STEP_NOTHING;
    uint32_t axis = 0U;
    double away = 0.0;
    for (uint32_t i = 0U; is_said && (i < rig->box.robot->axis_count); i++) {
        const double beyond = order_watch_is_steering(rig, i)
                                  ? 0.0
                                  : beyond_target(self, rig, i, truth[i], is_disturbed);
        axis = (beyond > away) ? i : axis;
        away = fmax(away, beyond);
    }
    self->untrue_cycles = (away > 0.0) ? (self->untrue_cycles + 1U) : 0U;
    if (self->untrue_cycles > OFF_CYCLES) {
        motion_oracle_complain(self, rig, SENTENCE_REACHED, axis, away);
    }
}

/* Another sentence judges the way that a broken part may hide until it is found. */
static double slack(const rig_t *rig, uint32_t axis, bool is_disturbed)
{
    const double hidden = is_length(rig, axis) ? BELIEVED_MM : BELIEVED_DEG;
    const double seen = is_length(rig, axis) ? HOME_MM : HOME_DEG;
    return is_disturbed ? hidden : seen;
}

static bool is_of(const rig_t *rig, uint32_t limit, uint32_t axis)
{
    return ((truth_coupled_axes(rig->box.robot, limit) >> axis) & 1U) != 0U;
}

/* Effect on a limit of the slack of that axis which acts most. */
static double coupled_slack(const rig_t *rig, uint32_t limit, const double truth[ROBOT_AXIS_MAX],
                            bool is_disturbed)
{
    const robot_t *const robot = rig->box.robot;
    double places[ROBOT_AXIS_MAX];
    double most = 0.0;
    (void)memcpy(places, truth, sizeof places);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (is_of(rig, limit, i)) {
            const double way = slack(rig, i, is_disturbed) / measure(rig, i, 1.0);
            places[i] = truth[i] + way;
            const double above = truth_coupled(robot, limit, places);
            places[i] = truth[i] - way;
            most = fmax(most, fabs(above - truth_coupled(robot, limit, places)) / 2.0);
            places[i] = truth[i];
        }
    }
    return most;
}

/* A jog of an axis that is not known may bring it beyond, and so may a motor that runs by itself;
 * then it comes back. No other order takes it farther out, not even homing. */
static void judge_coupled(motion_oracle_t *self, const rig_t *rig, uint32_t limit,
                          const double truth[ROBOT_AXIS_MAX], bool is_disturbed)
{
    double *const forgiven = &self->coupled_beyond[limit];
    const double beyond = fmax(0.0, truth_coupled_beyond(rig->box.robot, limit, truth));
    bool is_known = true;
    bool is_excused = rig->outputs.snapshot.workphase == (uint32_t)WORKPHASE_MANUAL;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        if (is_of(rig, limit, i)) {
            is_known = is_known && !is_doubted(rig, i);
            is_excused = is_excused || (rig->box.axes[i].motor.fault == SIM_MOTOR_RUNS);
        }
    }
    if (!is_known && is_excused) {
        *forgiven = beyond;
    }
    *forgiven = fmin(*forgiven, beyond);
    if ((beyond > *forgiven) &&
        (beyond > (*forgiven + coupled_slack(rig, limit, truth, is_disturbed)))) {
        motion_oracle_complain(self, rig, SENTENCE_COUPLED, limit, beyond - *forgiven);
    }
}

static void judge_jog(motion_oracle_t *self, const rig_t *rig, double depth_ticks,
                      bool is_disturbed)
{
    const uint32_t along = rig->box.robot->needle_axis;
    const double in = measure(rig, along, depth_ticks) - NEEDLE_OUT_MM;
    const card_drive_t needle = rig_sent(rig, along).drive;
    const uint32_t phase = rig->outputs.snapshot.workphase;
    if ((phase != (uint32_t)WORKPHASE_MANUAL) && (phase != (uint32_t)WORKPHASE_START_UP)) {
        return;
    }
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        if ((config_of(rig, i)->needle_motion == (uint32_t)NEEDLE_ACROSS) &&
            (rig_sent(rig, i).drive.mode != (uint32_t)CARD_DRIVE_OFF) &&
            (in > slack(rig, along, is_disturbed))) {
            motion_oracle_complain(self, rig, SENTENCE_ACROSS, i, in);
        }
    }
    if ((phase == (uint32_t)WORKPHASE_MANUAL) && (needle.mode != (uint32_t)CARD_DRIVE_OFF) &&
        !homing_part_is_homed(rig, along) && !homing_part_is_homing(rig, along) &&
        motor_model_is_upwards(config_of(rig, along), &needle)) {
        motion_oracle_complain(self, rig, SENTENCE_INWARDS, along, 1.0);
    }
}

static void judge_speed(motion_oracle_t *self, const rig_t *rig, uint32_t axis, double truth)
{
    const uint32_t place = self->looks % MOTION_ORACLE_MEAN;
    const double way = fabs(truth - self->places[axis][place]);
    const double most = config_of(rig, axis)->speed_ticks_per_s * (LIMIT_MEAN_SPEED_TIME_US / 1e6);
    if ((self->looks >= MOTION_ORACLE_MEAN) && (way > most)) {
        motion_oracle_complain(self, rig, SENTENCE_SPEED, axis, 100.0 * way / most);
    }
    self->places[axis][place] = truth;
}

void motion_places_look(motion_oracle_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX],
                        bool is_disturbed)
{
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        note_sweep(self, rig, i, truth[i]);
        judge_belief(self, rig, i, truth[i]);
        judge_rest(self, rig, i, truth[i]);
        if (!is_disturbed) {
            judge_speed(self, rig, i, truth[i]);
        }
    }
    self->looks++;
    judge_needle(self, rig, truth[rig->box.robot->needle_axis]);
    judge_reached(self, rig, truth, is_disturbed);
    for (uint32_t i = 0U; i < rig->box.robot->coupled_limit_count; i++) {
        judge_coupled(self, rig, i, truth, is_disturbed);
    }
    judge_jog(self, rig, truth[rig->box.robot->needle_axis], is_disturbed);
}

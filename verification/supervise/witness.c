/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/witness.h"

#include "charts/arming_chart.h"
#include "charts/axis_chart.h"
#include "robot/robot_neuro.h"

#include <math.h>
#include <string.h>

#define BELIEVED_MM 1.0
#define BELIEVED_DEG 9.0
#define OFF_CYCLES 10U
#define NEEDLE_MM 0.3 /* 0.2 mm, and what the motor runs on in the cycles of the detection. */
#define REACHED_MM 0.1
#define REACHED_DEG 1.0
#define APART_LEAST_MM 75.0
#define APART_MOST_MM 146.0
#define APART_HOME_MM 143.0
#define NEEDLE_OUT_MM 0.625
#define HOME_MM 0.05 /* Of the place where homing sees a switch. */
#define ENDS_CYCLES 60000U

const char *witness_sentence(sentence_t sentence)
{
    static const char *const words[SENTENCE_COUNT] = {
        "A drive leaves only with pedal, e-stop, scanner, cards and order",
        "A homed axis without a fault stands where it is believed to (mm, deg)",
        "An axis that moves while off does not stay homed (mm, deg)",
        "A move under the pedal ends (s)",
        "Homing drives the needle forwards by little only (mm)",
        "\"The target is reached\": it is (mm, deg)",
        "The axial carriages keep their distance (mm)",
        "As long as nothing is broken, no fault is found (event)",
        "No axis goes beyond its end by more than its deadband (ticks)",
        "In a short mean no axis is faster than its speed (percent)",
        "Neither jog nor homing drives across a needle that is in (mm)",
        "A needle that is not homed is not jogged inwards"};
    return words[sentence];
}

void witness_begin(witness_t *self, uint32_t seed)
{
    static witness_t kept;
    kept = *self;
    (void)memset(self, 0, sizeof *self);
    (void)memcpy(self->verdicts, kept.verdicts, sizeof kept.verdicts);
    (void)memcpy(self->endings, kept.endings, sizeof kept.endings);
    self->seed = seed;
}

void witness_forgive(witness_t *self)
{
    (void)memset(self->is_broken, 0, sizeof self->is_broken);
}

static void complain(witness_t *self, const rig_t *rig, sentence_t sentence, uint32_t axis,
                     double figure)
{
    verdict_t *const verdict = &self->verdicts[sentence];
    verdict->worst = (figure > verdict->worst) ? figure : verdict->worst;
    if (self->is_broken[sentence]) {
        return;
    }
    self->is_broken[sentence] = true;
    if (verdict->episodes == 0U) {
        verdict->seed = self->seed;
        verdict->cycle = rig->outputs.snapshot.cycle;
        verdict->axis = axis;
    }
    verdict->episodes++;
}

static bool is_length(uint32_t axis)
{
    return robot_neuro.axes[axis].unit == (uint8_t)AXIS_UNIT_MM;
}

/* nm in mm, or bam in degrees. */
static double in_words(uint32_t axis, double units)
{
    return is_length(axis) ? (units / 1e6) : (units * 360.0 / 4294967296.0);
}

/* Ticks in mm or degrees. */
static double measure(uint32_t axis, double ticks)
{
    return in_words(axis, ticks * (double)robot_neuro.axes[axis].unit_per_tick_q16 / 65536.0);
}

static bool is_homed(const rig_t *rig, uint32_t axis)
{
    const uint32_t grade = rig->outputs.snapshot.axes[axis].reference;
    return (grade == (uint32_t)AXIS_REFERENCE_TAKEN) ||
           (grade == (uint32_t)AXIS_REFERENCE_VERIFIED);
}

/* The system says that this axis is not to be trusted. */
static bool is_doubted(const rig_t *rig, uint32_t axis)
{
    return !is_homed(rig, axis) ||
           (rig->outputs.snapshot.axes[axis].power == (uint32_t)AXIS_POWER_FAULT);
}

static bool is_driven(const rig_t *rig, uint32_t axis)
{
    return rig->box.axes[axis].card.applied.mode != (uint32_t)CARD_DRIVE_OFF;
}

static void judge_permit(witness_t *self, const rig_t *rig)
{
    const controller_inputs_t *const inputs = &rig->inputs;
    if (rig_is_driving(rig) && ((inputs->pedal_a == 0U) || (inputs->pedal_b == 0U) ||
                                (inputs->estop_open != 0U) || (inputs->scanner_active != 0U) ||
                                (rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE))) {
        complain(self, rig, SENTENCE_PERMIT, 0U, 1.0);
    }
}

/* An axis without a switch may be taken where it stands once: the operator has put it there. */
static void judge_belief(witness_t *self, const rig_t *rig, uint32_t axis, double truth)
{
    const double believed = rig->outputs.snapshot.axes[axis].position_ticks;
    const double away = fabs(measure(axis, truth - believed));
    const bool is_astray =
        !is_doubted(rig, axis) && (away > (is_length(axis) ? BELIEVED_MM : BELIEVED_DEG));
    self->astray_cycles[axis] = is_astray ? (self->astray_cycles[axis] + 1U) : 0U;
    if (self->astray_cycles[axis] > OFF_CYCLES) {
        complain(self, rig, SENTENCE_BELIEVED, axis, away);
    }
}

/* What is allowed, and what the motor runs until it is noticed. Who shows half of a way is found
 * out after twice as much. */
static double most_off(witness_t *self, const rig_t *rig, uint32_t axis)
{
    const double allowed = in_words(axis, is_length(axis) ? LIMIT_REST_WAY_NM : LIMIT_REST_WAY_BAM);
    const double running = robot_neuro.axes[axis].full_speed_ticks_per_s;
    const bool is_half = rig->box.axes[axis].encoder.fault == SIM_ENCODER_HALF;
    const uint32_t left = self->half_cycles[axis];
    self->half_cycles[axis] = is_half ? WITNESS_SECOND : ((left > 0U) ? (left - 1U) : 0U);
    return (allowed * ((self->half_cycles[axis] > 0U) ? 2.0 : 1.0)) +
           measure(axis, running * LIMIT_REST_NOTICE_US / 1e6);
}

static void judge_rest(witness_t *self, const rig_t *rig, uint32_t axis, double truth)
{
    const uint32_t place = self->off_cycles[axis] % WITNESS_SECOND;
    const double most = most_off(self, rig, axis);
    if (is_driven(rig, axis)) {
        self->off_cycles[axis] = 0U;
        return;
    }
    const bool is_full = self->off_cycles[axis] >= WITNESS_SECOND;
    const double before = is_full ? self->rest[axis][place] : self->rest[axis][0];
    const double way = fabs(measure(axis, truth - before));
    self->rest[axis][place] = truth;
    self->off_cycles[axis]++;
    if ((self->off_cycles[axis] > OFF_CYCLES) && !is_doubted(rig, axis) && (way > most)) {
        complain(self, rig, SENTENCE_OFF, axis, way);
    }
}

static void judge_end(witness_t *self, const rig_t *rig)
{
    const bool is_moving = rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_MOVING;
    self->moving_cycles = is_moving ? (self->moving_cycles + 1U) : 0U;
    if (self->moving_cycles > ENDS_CYCLES) {
        complain(self, rig, SENTENCE_ENDS, 0U, self->moving_cycles / 1000.0);
    }
}

static void judge_needle(witness_t *self, const rig_t *rig, double truth)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const bool is_homing = (shown->workphase == (uint32_t)WORKPHASE_START_UP) &&
                           (shown->order == (uint32_t)ARMING_STATE_MOVING) &&
                           !is_homed(rig, AXIS_INSERTION);
    if (!is_homing || !self->was_homing || (truth < self->needle_from)) {
        self->needle_from = truth;
    }
    self->was_homing = is_homing;
    const double forwards = measure(AXIS_INSERTION, truth - self->needle_from);
    if (forwards > NEEDLE_MM) {
        complain(self, rig, SENTENCE_NEEDLE, AXIS_INSERTION, forwards);
    }
}

/* What the controller remembers later may have been damaged. */
static void remember_target(witness_t *self, const rig_t *rig)
{
    bool is_new = !self->has_looked;
    for (uint32_t i = 0U; i < rig->outputs.event_count; i++) {
        is_new = is_new || (rig->outputs.events[i].id == (uint32_t)EVENT_TARGET_ACCEPTED);
    }
    if (is_new) {
        (void)memcpy(self->target_ticks, rig->controller.plan.target_ticks,
                     sizeof self->target_ticks);
    }
    self->has_looked = true;
}

/* What is shown is at the target, and what is true no farther from it than a broken part may hide.
 */
static double beyond_target(const witness_t *self, const rig_t *rig, uint32_t axis, double truth,
                            bool is_disturbed)
{
    const double hidden = is_length(axis) ? BELIEVED_MM : BELIEVED_DEG;
    const double shown = rig->outputs.snapshot.axes[axis].position_ticks;
    const double target = self->target_ticks[axis];
    const double away = fabs(measure(axis, truth - target));
    const bool is_there =
        fabs(measure(axis, shown - target)) <= (is_length(axis) ? REACHED_MM : REACHED_DEG);
    const double most =
        (is_length(axis) ? REACHED_MM : REACHED_DEG) + (is_disturbed ? hidden : 0.0);
    return (is_there && is_homed(rig, axis) && (away <= most)) ? 0.0 : away;
}

static void judge_reached(witness_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX],
                          bool is_disturbed)
{
    const bool is_said = rig->outputs.snapshot.next_step == (uint32_t)NEXT_STEP_NOTHING;
    uint32_t axis = 0U;
    double away = 0.0;
    for (uint32_t i = 0U; is_said && (i < robot_neuro.axis_count); i++) {
        const double beyond = beyond_target(self, rig, i, truth[i], is_disturbed);
        axis = (beyond > away) ? i : axis;
        away = fmax(away, beyond);
    }
    self->untrue_cycles = (away > 0.0) ? (self->untrue_cycles + 1U) : 0U;
    if (self->untrue_cycles > OFF_CYCLES) {
        complain(self, rig, SENTENCE_REACHED, axis, away);
    }
}

/* What a broken part may hide until it is found is the matter of another sentence. */
static double slack_mm(bool is_disturbed)
{
    return is_disturbed ? BELIEVED_MM : HOME_MM;
}

static bool is_carriage_running(const rig_t *rig)
{
    return (rig->box.axes[AXIS_HEAD].motor.fault == SIM_MOTOR_RUNS) ||
           (rig->box.axes[AXIS_FEET].motor.fault == SIM_MOTOR_RUNS);
}

/* Who jogs a carriage that is not known may bring it beyond, and so may a motor that runs by
 * itself; then they come back. No other order takes them farther out, not even homing. */
static void judge_distance(witness_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX],
                           bool is_disturbed)
{
    const double apart =
        APART_HOME_MM + measure(AXIS_HEAD, truth[AXIS_HEAD]) - measure(AXIS_FEET, truth[AXIS_FEET]);
    const double beyond = fmax(0.0, fmax(APART_LEAST_MM - apart, apart - APART_MOST_MM));
    const bool is_known = !is_doubted(rig, AXIS_HEAD) && !is_doubted(rig, AXIS_FEET);
    const bool is_jogged = rig->outputs.snapshot.workphase == (uint32_t)WORKPHASE_MANUAL;
    if (!is_known && (is_jogged || is_carriage_running(rig))) {
        self->apart_beyond = beyond;
    }
    self->apart_beyond = fmin(self->apart_beyond, beyond);
    if (beyond > (self->apart_beyond + slack_mm(is_disturbed))) {
        complain(self, rig, SENTENCE_APART, AXIS_HEAD, beyond - self->apart_beyond);
    }
}

static void judge_jog(witness_t *self, const rig_t *rig, double depth_ticks, bool is_disturbed)
{
    const double in = measure(AXIS_INSERTION, depth_ticks) - NEEDLE_OUT_MM;
    const card_drive_t needle = rig_sent(rig, AXIS_INSERTION).drive;
    const uint32_t phase = rig->outputs.snapshot.workphase;
    if ((phase != (uint32_t)WORKPHASE_MANUAL) && (phase != (uint32_t)WORKPHASE_START_UP)) {
        return;
    }
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if ((robot_neuro.axes[i].needle_motion == (uint32_t)NEEDLE_ACROSS) &&
            (rig_sent(rig, i).drive.mode != (uint32_t)CARD_DRIVE_OFF) &&
            (in > slack_mm(is_disturbed))) {
            complain(self, rig, SENTENCE_ACROSS, i, in);
        }
    }
    if ((phase == (uint32_t)WORKPHASE_MANUAL) && (needle.mode != (uint32_t)CARD_DRIVE_OFF) &&
        !is_homed(rig, AXIS_INSERTION) &&
        servo_is_upwards(&robot_neuro.axes[AXIS_INSERTION], &needle)) {
        complain(self, rig, SENTENCE_INWARDS, AXIS_INSERTION, 1.0);
    }
}

static bool is_moving_to_target(const rig_t *rig)
{
    return (rig->outputs.snapshot.workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET) &&
           (rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_MOVING);
}

static void judge_beyond(witness_t *self, const rig_t *rig)
{
    const profile_t *const profile = &rig->controller.mode.leg.profile;
    for (uint32_t i = 0U; (i < robot_neuro.axis_count) && is_moving_to_target(rig); i++) {
        const int32_t way = profile->end_ticks[i] - profile->start_ticks[i];
        const int32_t beyond = rig->outputs.snapshot.axes[i].position_ticks - profile->end_ticks[i];
        const int32_t over = (way > 0) ? beyond : -beyond;
        if ((way != 0) && (over > robot_neuro.axes[i].deadband_ticks)) {
            complain(self, rig, SENTENCE_BEYOND, i, over);
        }
    }
}

static void judge_speed(witness_t *self, const rig_t *rig, uint32_t axis, double truth)
{
    const uint32_t place = self->looks % WITNESS_MEAN;
    const double way = fabs(truth - self->places[axis][place]);
    const double most = robot_neuro.axes[axis].speed_ticks_per_s * (LIMIT_MEAN_SPEED_TIME_US / 1e6);
    if ((self->looks >= WITNESS_MEAN) && (way > most)) {
        complain(self, rig, SENTENCE_SPEED, axis, 100.0 * way / most);
    }
    self->places[axis][place] = truth;
}

static void count_ending(witness_t *self, ending_t ending)
{
    endings_t *const endings = &self->endings[ending];
    const uint32_t late =
        (self->over_cycles < WITNESS_LATE) ? self->over_cycles : WITNESS_LATE - 1U;
    endings->count++;
    endings->late[late]++;
}

static bool has_non_pwm_way(const profile_t *profile)
{
    bool has_way = false;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        has_way = has_way || ((robot_neuro.axes[i].card_type == (uint8_t)CARD_TYPE_NON_PWM) &&
                              (profile->start_ticks[i] != profile->end_ticks[i]));
    }
    return has_way;
}

/* A leg ends when the next one begins or the move is done, not when the pedal is released. */
static void judge_endings(witness_t *self, const rig_t *rig, bool is_done)
{
    const profile_t *const profile = &rig->controller.mode.leg.profile;
    const bool is_over = is_moving_to_target(rig) && profile_is_finished(profile);
    const bool is_next = is_moving_to_target(rig) && (self->over_cycles > 0U) && !is_over;
    if (is_done) {
        count_ending(self, ENDING_MOVE);
    }
    if ((is_done || is_next) && self->is_non_pwm_over) {
        count_ending(self, ENDING_NON_PWM);
    }
    self->over_cycles = is_over ? (self->over_cycles + 1U) : 0U;
    self->is_non_pwm_over = is_over && has_non_pwm_way(profile);
}

static void judge_events(witness_t *self, const rig_t *rig, bool is_disturbed)
{
    bool is_done = false;
    for (uint32_t i = 0U; i < rig->outputs.event_count; i++) {
        const event_t *const event = &rig->outputs.events[i];
        is_done = is_done || (event->id == (uint32_t)EVENT_ORDER_DONE);
        /* What is not homed may be jogged against its switch. */
        const bool is_jog_blocked =
            (event->id == (uint32_t)EVENT_ORDER_OVERDUE) && !is_homed(rig, event->subject);
        if (!is_disturbed && !is_jog_blocked &&
            (event->severity == (uint32_t)EVENT_SEVERITY_CRITICAL)) {
            complain(self, rig, SENTENCE_CALM, event->subject % robot_neuro.axis_count, event->id);
        }
    }
    const uint32_t workphase = rig->outputs.snapshot.workphase;
    judge_endings(self, rig, is_done && (workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET));
}

uint32_t witness_late(const witness_t *self, ending_t ending, uint32_t percent)
{
    const endings_t *const endings = &self->endings[ending];
    uint32_t cycles = 0U;
    uint32_t count = endings->late[0];
    while ((cycles < (WITNESS_LATE - 1U)) && ((count * 100U) < (endings->count * percent))) {
        cycles++;
        count += endings->late[cycles];
    }
    return cycles;
}

void witness_look(witness_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX],
                  bool is_disturbed)
{
    remember_target(self, rig);
    judge_permit(self, rig);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        judge_belief(self, rig, i, truth[i]);
        judge_rest(self, rig, i, truth[i]);
        if (!is_disturbed) {
            judge_speed(self, rig, i, truth[i]);
        }
    }
    self->looks++;
    if (!is_disturbed) {
        judge_beyond(self, rig);
    }
    judge_end(self, rig);
    judge_needle(self, rig, truth[AXIS_INSERTION]);
    judge_reached(self, rig, truth, is_disturbed);
    judge_distance(self, rig, truth, is_disturbed);
    judge_jog(self, rig, truth[AXIS_INSERTION], is_disturbed);
    judge_events(self, rig, is_disturbed);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/motion_oracle.h"

#include "charts/arming_chart.h"
#include "charts/axis_chart.h"
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
/* On the slowest robot: the carriages and then the needle go over their strokes. */
#define ENDS_CYCLES 120000U
#define SWEEP_ENDS_CYCLES 600000U
/* On the slowest robot: all axes home; carriages that were lost do so one after the other. */
#define HOMING_ENDS_CYCLES 180000U
#define CARRIAGE_ENDS_CYCLES 60000U
/* The drive of an axis that has homed is off in the next frame. */
#define IDLE_CYCLES 1U

const char *motion_oracle_sentence(sentence_t sentence)
{
    static const char *const words[SENTENCE_COUNT] = {
        "A drive leaves only with pedal, e-stop, scanner, cards and order",
        "A homed axis without a fault stands where it is believed to (mm, deg)",
        "An axis that moves while off does not stay homed (mm, deg)",
        "A move under the pedal ends (s)",
        "Homing drives the needle forwards by little only (mm)",
        "\"The target is reached\": it is (mm, deg)",
        "Coupled limits are kept, or come back to (mm, deg)",
        "As long as nothing is broken, no fault is found (event)",
        "No axis goes beyond its end by more than its deadband (ticks)",
        "In a short mean no axis is faster than its speed (percent)",
        "Neither jog nor homing drives across a needle that is in (mm)",
        "A needle that is not homed is not jogged inwards",
        "Homing drives who homes in its scenario and goes with it, no other",
        "What is proposed changes no target that was accepted",
        "A retraction drives the needle outwards only",
        "Lengths of the probe are those that were reported last, or none",
        "An axis of which nothing is broken is not called faulty (event)",
        "To a pose the needle is not driven",
        "To line up the needle is not driven in",
        "An insertion moves no other axis",
        "Jogs, speeds, sweeps and programs drive the axes that they name",
        "An axis that was disabled is not driven",
        "A trajectory keeps each axis between its rows",
        "The end of an order is reported",
        "Waves are of 45 to 55 kHz",
        "A sweep drives in MANUAL, with the needle truly out",
        "What a sweep reports is the true way of a whole run",
        "A sweep is done with points both ways, and its end reported",
        "While the gate says stop, no treatment program drives",
        "A step ends at its place, after its dwell or by the dose it waits for",
        "A treatment program is done once each of its steps is",
        "An insertion by hand drives the needle alone, inwards, and out by 0.1 mm at most",
        "No hand takes the true needle past its target by 0.1 mm",
        "Without a hand that truly pushes no insertion by hand goes on",
        "A needle that is steered gains no 0.5 mm while its true rotation stands",
        "One commands: between two it is lost, and the axes rest",
        "Authority is lost by its holder, silence, or button without pedal",
        "A page that commands has renewed it",
        "After a loss nothing is driven before another order and press",
        "Only who has authority arms, and nothing is armed without"};
    return words[sentence];
}

void motion_oracle_begin(motion_oracle_t *self, uint32_t seed)
{
    static motion_oracle_t kept;
    kept = *self;
    (void)memset(self, 0, sizeof *self);
    (void)memcpy(self->verdicts, kept.verdicts, sizeof kept.verdicts);
    (void)memcpy(self->endings, kept.endings, sizeof kept.endings);
    for (uint32_t i = 0U; i < COMMAND_KIND_COUNT; i++) {
        self->armed[i] = kept.armed[i] + kept.order_watch.armed[i];
        self->done[i] = kept.done[i] + kept.order_watch.done[i];
    }
    (void)memcpy(self->found, kept.found, sizeof kept.found);
    self->losses_in_motion = kept.losses_in_motion + kept.authority_oracle.losses_in_motion;
    for (uint32_t i = 0U; i < REIGN_LOSSES; i++) {
        self->losses[i] = kept.losses[i] + kept.authority_oracle.losses[i];
    }
    self->seed = seed;
}

void motion_oracle_forgive(motion_oracle_t *self)
{
    (void)memset(self->is_broken, 0, sizeof self->is_broken);
}

static void complain(motion_oracle_t *self, const rig_t *rig, sentence_t sentence, uint32_t axis,
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

static void judge_permit(motion_oracle_t *self, const rig_t *rig)
{
    const controller_inputs_t *const inputs = &rig->inputs;
    if (rig_is_driving(rig) && ((inputs->pedal_a == 0U) || (inputs->pedal_b == 0U) ||
                                (inputs->estop_open != 0U) || (inputs->scanner_active != 0U) ||
                                (rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE))) {
        complain(self, rig, SENTENCE_PERMIT, 0U, 1.0);
    }
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
        complain(self, rig, SENTENCE_BELIEVED, axis, away);
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
        complain(self, rig, SENTENCE_OFF, axis, way);
    }
}

static uint32_t homing_ends(const motion_oracle_t *self)
{
    const uint32_t others = (self->lost_carriages > 0U) ? (self->lost_carriages - 1U) : 0U;
    return HOMING_ENDS_CYCLES + (others * CARRIAGE_ENDS_CYCLES);
}

static void judge_end(motion_oracle_t *self, const rig_t *rig)
{
    /* A hand takes its time. */
    const bool is_moving = (rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_MOVING) &&
                           (self->order_watch.kind != (uint32_t)COMMAND_COOPERATE);
    const bool is_sweep = self->order_watch.kind == (uint32_t)COMMAND_SWEEP;
    const bool is_homing = rig->outputs.snapshot.mode == (uint32_t)MODE_HOMING;
    const uint32_t most = is_homing ? homing_ends(self) : ENDS_CYCLES;
    self->moving_cycles = is_moving ? (self->moving_cycles + 1U) : 0U;
    if (self->moving_cycles == 1U) {
        self->lost_carriages = homing_part_lost_carriages(rig);
    }
    if (self->moving_cycles > (is_sweep ? SWEEP_ENDS_CYCLES : most)) {
        complain(self, rig, SENTENCE_ENDS, 0U, self->moving_cycles / 1000.0);
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
        complain(self, rig, SENTENCE_NEEDLE, needle, forwards);
    }
}

/* In START_UP, or while one axis homes alone, this one has no part in it. */
static bool is_idle_in_homing(const rig_t *rig, uint32_t axis)
{
    bool is_any_homing = false;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        is_any_homing = is_any_homing || homing_part_is_homing(rig, i);
    }
    return (rig->outputs.snapshot.workphase == (uint32_t)WORKPHASE_START_UP)
               ? !homing_part_has(rig, axis)
               : (is_any_homing && !homing_part_is_homing(rig, axis));
}

static void judge_homing(motion_oracle_t *self, const rig_t *rig)
{
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        const bool is_sent = rig_sent(rig, i).drive.mode != (uint32_t)CARD_DRIVE_OFF;
        const bool is_drawn_out = self->is_retracting && (i == rig->box.robot->needle_axis);
        const bool is_idle = is_sent && !is_drawn_out && is_idle_in_homing(rig, i);
        self->idle_cycles[i] = is_idle ? (self->idle_cycles[i] + 1U) : 0U;
        if (self->idle_cycles[i] > IDLE_CYCLES) {
            complain(self, rig, SENTENCE_HOMING, i, self->idle_cycles[i]);
        }
    }
}

/* A target that the controller remembers later may have been damaged. */
static void remember_target(motion_oracle_t *self, const rig_t *rig)
{
    bool is_new = !self->has_looked;
    if (is_new) {
        self->probe = rig->box.robot->probe;
    }
    for (uint32_t i = 0U; i < rig->outputs.event_count; i++) {
        is_new = is_new || (rig->outputs.events[i].id == (uint32_t)EVENT_TARGET_ACCEPTED);
    }
    if (is_new) {
        (void)memcpy(self->target_ticks, rig->controller.plan.target_ticks,
                     sizeof self->target_ticks);
    }
    self->has_looked = true;
}

/* Another probe, as the answer to a command says; its target is another one too. */
static bool takes_probe(motion_oracle_t *self, const rig_t *rig)
{
    bool is_taken = false;
    for (uint32_t i = 0U; i < rig->outputs.answer_count; i++) {
        const answer_t *const answer = &rig->outputs.answers[i];
        if ((answer->command == (uint32_t)COMMAND_PROBE) &&
            (answer->kind == (uint32_t)ANSWER_ACCEPTED)) {
            for (uint32_t j = 0U; j < rig->inputs.command_count; j++) {
                const command_t *const command = &rig->inputs.commands[j];
                if ((command->id == answer->id) && (command->kind == (uint32_t)COMMAND_PROBE)) {
                    (void)memcpy(self->probe.length_nm, command->as.probe.lengths_nm,
                                 sizeof self->probe);
                    is_taken = true;
                }
            }
        }
    }
    return is_taken;
}

static void judge_probe(motion_oracle_t *self, const rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    if (takes_probe(self, rig) && (rig->inputs.command_count == 1U) && (shown->has_target != 0U)) {
        complain(self, rig, SENTENCE_PROBE, 0U, 1.0);
    }
    for (uint32_t i = 0U; (i < ROBOT_PROBE_LENGTHS) && (shown->has_probe != 0U); i++) {
        if (shown->probe_nm[i] != self->probe.length_nm[i]) {
            complain(self, rig, SENTENCE_PROBE, 0U, (double)shown->probe_nm[i]);
        }
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
        complain(self, rig, SENTENCE_REACHED, axis, away);
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
        complain(self, rig, SENTENCE_COUPLED, limit, beyond - *forgiven);
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
            complain(self, rig, SENTENCE_ACROSS, i, in);
        }
    }
    if ((phase == (uint32_t)WORKPHASE_MANUAL) && (needle.mode != (uint32_t)CARD_DRIVE_OFF) &&
        !homing_part_is_homed(rig, along) && !homing_part_is_homing(rig, along) &&
        motor_model_is_upwards(config_of(rig, along), &needle)) {
        complain(self, rig, SENTENCE_INWARDS, along, 1.0);
    }
}

/* Nothing came but what must leave the target alone, and nothing happened that takes it away. */
static bool is_only_reported(const rig_t *rig)
{
    bool is_only = rig->inputs.command_count > 0U;
    for (uint32_t i = 0U; i < rig->inputs.command_count; i++) {
        const uint32_t kind = rig->inputs.commands[i].kind;
        is_only = is_only && (kind >= (uint32_t)COMMAND_PROPOSE_REGISTRATION) &&
                  (kind != (uint32_t)COMMAND_JOG) && (kind != (uint32_t)COMMAND_RETRACT) &&
                  (kind < (uint32_t)COMMAND_HOME_AXIS);
    }
    for (uint32_t i = 0U; i < rig->outputs.event_count; i++) {
        const event_t *const event = &rig->outputs.events[i];
        is_only = is_only && ((event->severity == (uint32_t)EVENT_SEVERITY_INFORMATION) ||
                              (event->id == (uint32_t)EVENT_COMMAND_REFUSED));
    }
    return is_only;
}

static void judge_reported(motion_oracle_t *self, const rig_t *rig)
{
    const plan_t *const plan = &rig->controller.plan;
    const plan_t *const before = &self->plan;
    const bool is_same =
        (plan->has_target != 0U) &&
        (memcmp(plan->target_ticks, before->target_ticks, sizeof plan->target_ticks) == 0) &&
        (memcmp(&plan->scanner_target, &before->scanner_target, sizeof plan->scanner_target) == 0);
    if ((before->has_target != 0U) && !is_same && is_only_reported(rig)) {
        complain(self, rig, SENTENCE_TARGET, 0U, 1.0);
    }
    self->plan = *plan;
}

static void judge_retraction(motion_oracle_t *self, const rig_t *rig)
{
    const uint32_t along = rig->box.robot->needle_axis;
    const card_drive_t needle = rig_sent(rig, along).drive;
    for (uint32_t i = 0U; i < rig->outputs.answer_count; i++) {
        const answer_t *const answer = &rig->outputs.answers[i];
        const bool is_of_it = answer->command == (uint32_t)COMMAND_RETRACT;
        if (is_of_it && (answer->kind != (uint32_t)ANSWER_REFUSED)) {
            self->is_retracting = answer->is_final == 0U;
        }
    }
    if (self->is_retracting && (needle.mode != (uint32_t)CARD_DRIVE_OFF) &&
        motor_model_is_upwards(config_of(rig, along), &needle)) {
        complain(self, rig, SENTENCE_OUT, along, 1.0);
    }
}

static bool is_moving_to_target(const rig_t *rig)
{
    return (rig->outputs.snapshot.workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET) &&
           (rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_MOVING);
}

/* The end is that of a profile; a hand moves the needle without one, and hand_watch.h judges that.
 */
static void judge_beyond(motion_oracle_t *self, const rig_t *rig)
{
    const profile_t *const profile = &rig->controller.mode.sealed.leg.profile;
    const bool is_by_profile =
        is_moving_to_target(rig) && (rig->controller.mode.sealed.kind != (uint32_t)MODE_COOPERATE);
    for (uint32_t i = 0U; (i < rig->box.robot->axis_count) && is_by_profile; i++) {
        const int32_t way = profile->end_ticks[i] - profile->start_ticks[i];
        const int32_t beyond = rig->outputs.snapshot.axes[i].position_ticks - profile->end_ticks[i];
        const int32_t over = (way > 0) ? beyond : -beyond;
        if ((way != 0) && (over > config_of(rig, i)->deadband_ticks)) {
            complain(self, rig, SENTENCE_BEYOND, i, over);
        }
    }
}

static void judge_speed(motion_oracle_t *self, const rig_t *rig, uint32_t axis, double truth)
{
    const uint32_t place = self->looks % MOTION_ORACLE_MEAN;
    const double way = fabs(truth - self->places[axis][place]);
    const double most = config_of(rig, axis)->speed_ticks_per_s * (LIMIT_MEAN_SPEED_TIME_US / 1e6);
    if ((self->looks >= MOTION_ORACLE_MEAN) && (way > most)) {
        complain(self, rig, SENTENCE_SPEED, axis, 100.0 * way / most);
    }
    self->places[axis][place] = truth;
}

static void count_ending(motion_oracle_t *self, ending_t ending)
{
    endings_t *const endings = &self->endings[ending];
    const uint32_t late =
        (self->over_cycles < MOTION_ORACLE_LATE) ? self->over_cycles : MOTION_ORACLE_LATE - 1U;
    endings->count++;
    endings->late[late]++;
}

static bool has_non_pwm_way(const rig_t *rig, const profile_t *profile)
{
    bool has_way = false;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        has_way = has_way || ((config_of(rig, i)->card_type == (uint8_t)CARD_TYPE_NON_PWM) &&
                              (profile->start_ticks[i] != profile->end_ticks[i]));
    }
    return has_way;
}

/* A leg ends when the next one begins or the move is done, not when the pedal is released. */
static void judge_endings(motion_oracle_t *self, const rig_t *rig, bool is_done)
{
    const profile_t *const profile = &rig->controller.mode.sealed.leg.profile;
    const bool is_over = is_moving_to_target(rig) && profile_is_finished(profile);
    const bool is_next = is_moving_to_target(rig) && (self->over_cycles > 0U) && !is_over;
    if (is_done) {
        count_ending(self, ENDING_MOVE);
    }
    if ((is_done || is_next) && self->is_non_pwm_over) {
        count_ending(self, ENDING_NON_PWM);
    }
    self->over_cycles = is_over ? (self->over_cycles + 1U) : 0U;
    self->is_non_pwm_over = is_over && has_non_pwm_way(rig, profile);
}

/* Each says of an axis that something of it is broken. */
static bool is_accusation(uint32_t id)
{
    static const event_id_t accusations[] = {
        EVENT_AXIS_ENCODER_FAULT,    EVENT_AXIS_STALLED,      EVENT_AXIS_FOLLOWING_ERROR,
        EVENT_AXIS_HOME_TIMEOUT,     EVENT_AXIS_SWITCH_FAULT, EVENT_AXIS_WRONG_WAY,
        EVENT_AXIS_MOVED_OFF,        EVENT_AXIS_NO_COUNTS,    EVENT_AXIS_WRONG_SPEED,
        EVENT_AXIS_SWITCH_ELSEWHERE, EVENT_AXIS_UNEVEN_COUNTS};
    bool is_one = false;
    for (uint32_t i = 0U; i < (sizeof accusations / sizeof accusations[0]); i++) {
        is_one = is_one || (id == (uint32_t)accusations[i]);
    }
    return is_one;
}

static void judge_accusation(motion_oracle_t *self, const rig_t *rig, const event_t *event)
{
    self->found[event->id % EVENT_ID_COUNT]++;
    if (self->is_sound && is_accusation(event->id)) {
        complain(self, rig, SENTENCE_ACCUSED, event->subject, event->id);
    }
}

static void judge_events(motion_oracle_t *self, const rig_t *rig, bool is_disturbed)
{
    bool is_done = false;
    for (uint32_t i = 0U; i < rig->outputs.event_count; i++) {
        const event_t *const event = &rig->outputs.events[i];
        is_done = is_done || (event->id == (uint32_t)EVENT_ORDER_DONE);
        judge_accusation(self, rig, event);
        /* An axis that is not homed may be jogged against its switch. */
        const bool is_jog_blocked = (event->id == (uint32_t)EVENT_ORDER_OVERDUE) &&
                                    !homing_part_is_homed(rig, event->subject);
        if (!is_disturbed && !is_jog_blocked &&
            (event->severity == (uint32_t)EVENT_SEVERITY_CRITICAL)) {
            complain(self, rig, SENTENCE_CALM, event->subject % rig->box.robot->axis_count,
                     event->id);
        }
    }
    judge_endings(self, rig, is_done && (rig->controller.mode.sealed.kind == (uint32_t)MODE_MOVE));
}

uint32_t motion_oracle_late(const motion_oracle_t *self, ending_t ending, uint32_t percent)
{
    const endings_t *const endings = &self->endings[ending];
    uint32_t cycles = 0U;
    uint32_t count = endings->late[0];
    while ((cycles < (MOTION_ORACLE_LATE - 1U)) && ((count * 100U) < (endings->count * percent))) {
        cycles++;
        count += endings->late[cycles];
    }
    return cycles;
}

/* A bit of `broken` for each of `count` sentences from `first` on. */
static void complain_of(motion_oracle_t *self, const rig_t *rig, sentence_t first, uint32_t count,
                        uint32_t broken)
{
    for (uint32_t i = 0U; i < count; i++) {
        if (((broken >> i) & 1U) != 0U) {
            complain(self, rig, (sentence_t)((uint32_t)first + i), 0U, 1.0);
        }
    }
}

/* Those of single modes see an order as it was before this cycle. */
static void judge_orders(motion_oracle_t *self, const rig_t *rig,
                         const double truth[ROBOT_AXIS_MAX], bool is_disturbed)
{
    const order_watch_t *const order = &self->order_watch;
    complain_of(self, rig, SENTENCE_SWEEP, SWEEP_RULES,
                sweep_watch_look(&self->sweep_watch, order, rig, truth, is_disturbed));
    complain_of(self, rig, SENTENCE_PROGRAM, PROGRAM_RULES,
                program_watch_look(&self->program_watch, order, rig, truth, is_disturbed));
    complain_of(self, rig, SENTENCE_ORDER, ORDER_RULES,
                order_watch_look(&self->order_watch, rig, truth, is_disturbed));
    complain_of(self, rig, SENTENCE_HAND, HAND_RULES,
                hand_watch_look(&self->hand_watch, order, rig, truth));
}

void motion_oracle_look(motion_oracle_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX],
                        bool is_disturbed)
{
    remember_target(self, rig);
    judge_permit(self, rig);
    complain_of(self, rig, SENTENCE_REIGN, REIGN_RULES,
                authority_oracle_look(&self->authority_oracle, rig));
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        note_sweep(self, rig, i, truth[i]);
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
    judge_needle(self, rig, truth[rig->box.robot->needle_axis]);
    judge_homing(self, rig);
    judge_reached(self, rig, truth, is_disturbed);
    for (uint32_t i = 0U; i < rig->box.robot->coupled_limit_count; i++) {
        judge_coupled(self, rig, i, truth, is_disturbed);
    }
    judge_jog(self, rig, truth[rig->box.robot->needle_axis], is_disturbed);
    judge_reported(self, rig);
    judge_retraction(self, rig);
    judge_orders(self, rig, truth, is_disturbed);
    judge_probe(self, rig);
    judge_events(self, rig, is_disturbed);
}

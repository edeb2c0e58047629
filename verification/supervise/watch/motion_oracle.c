/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/motion_oracle.h"

#include "charts/arming_chart.h"
#include "supervise/watch/homing_part.h"
#include "supervise/watch/motion_places.h"

#include <string.h>

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
        "A needle that vibrates goes no deeper than its stop",
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
    for (uint32_t i = 0U; i < AUTHORITY_LOSSES; i++) {
        self->losses[i] = kept.losses[i] + kept.authority_oracle.losses[i];
    }
    self->seed = seed;
}

void motion_oracle_forgive(motion_oracle_t *self)
{
    (void)memset(self->is_broken, 0, sizeof self->is_broken);
}

void motion_oracle_complain(motion_oracle_t *self, const rig_t *rig, sentence_t sentence,
                            uint32_t axis, double figure)
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

static void judge_permit(motion_oracle_t *self, const rig_t *rig)
{
    const controller_inputs_t *const inputs = &rig->inputs;
    if (rig_is_driving(rig) && ((inputs->pedal_a == 0U) || (inputs->pedal_b == 0U) ||
                                (inputs->estop_open != 0U) || (inputs->scanner_active != 0U) ||
                                (rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE))) {
        motion_oracle_complain(self, rig, SENTENCE_PERMIT, 0U, 1.0);
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
        motion_oracle_complain(self, rig, SENTENCE_ENDS, 0U, self->moving_cycles / 1000.0);
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
            motion_oracle_complain(self, rig, SENTENCE_HOMING, i, self->idle_cycles[i]);
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
        motion_oracle_complain(self, rig, SENTENCE_PROBE, 0U, 1.0);
    }
    for (uint32_t i = 0U; (i < ROBOT_PROBE_LENGTHS) && (shown->has_probe != 0U); i++) {
        if (shown->probe_nm[i] != self->probe.length_nm[i]) {
            motion_oracle_complain(self, rig, SENTENCE_PROBE, 0U, (double)shown->probe_nm[i]);
        }
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
        motion_oracle_complain(self, rig, SENTENCE_TARGET, 0U, 1.0);
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
        motor_model_is_upwards(&rig->box.robot->axes[along], &needle)) {
        motion_oracle_complain(self, rig, SENTENCE_OUT, along, 1.0);
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
        const bool is_led = order_watch_is_steering(rig, i); /* Its law has no end. */
        if ((way != 0) && !is_led && (over > rig->box.robot->axes[i].deadband_ticks)) {
            motion_oracle_complain(self, rig, SENTENCE_BEYOND, i, over);
        }
    }
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
        has_way = has_way || ((rig->box.robot->axes[i].card_type == (uint8_t)CARD_TYPE_NON_PWM) &&
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
        motion_oracle_complain(self, rig, SENTENCE_ACCUSED, event->subject, event->id);
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
            motion_oracle_complain(self, rig, SENTENCE_CALM,
                                   event->subject % rig->box.robot->axis_count, event->id);
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
            motion_oracle_complain(self, rig, (sentence_t)((uint32_t)first + i), 0U, 1.0);
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
    complain_of(self, rig, SENTENCE_AUTHORITY, AUTHORITY_RULES,
                authority_oracle_look(&self->authority_oracle, rig));
    motion_places_look(self, rig, truth, is_disturbed);
    if (!is_disturbed) {
        judge_beyond(self, rig);
    }
    judge_end(self, rig);
    judge_homing(self, rig);
    judge_reported(self, rig);
    judge_retraction(self, rig);
    judge_orders(self, rig, truth, is_disturbed);
    judge_probe(self, rig);
    judge_events(self, rig, is_disturbed);
}

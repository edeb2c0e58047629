/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_membranes.h"

#include "controller/controller_facts.h"

#include "base/fixed.h"
#include "base/seal.h"
#include "safety/needle.h"

#include <string.h>

#define NM_PER_UM 1000
#define COUNT_Q16 65536
#define NOISE_Q24 INT64_C(16777216) /* Noise has 8 fraction bits, mN for a count 16. */

static void seal_list(membrane_watch_t *watch)
{
    watch->list_seal =
        seal_of(SEAL_START, (const uint8_t *)&watch->plan, WHOLE_WORDS(sizeof watch->plan));
}

static uint32_t seal_of_run(const membrane_watch_t *watch)
{
    return seal_of(SEAL_START, (const uint8_t *)&watch->run, WHOLE_WORDS(sizeof watch->run));
}

static void seal_run(membrane_watch_t *watch)
{
    watch->run_seal = seal_of_run(watch);
}

void controller_clear_membranes(controller_t *self)
{
    (void)memset(&self->membranes, 0, sizeof self->membranes);
    seal_list(&self->membranes);
    seal_run(&self->membranes);
}

static bool is_damaged(const membrane_watch_t *watch)
{
    const uint32_t seal =
        seal_of(SEAL_START, (const uint8_t *)&watch->plan, WHOLE_WORDS(sizeof watch->plan));
    return (seal != watch->list_seal) || (seal_of_run(watch) != watch->run_seal);
}

/* At rest they have their turn as the slots have. */
static void check(controller_t *self, const cycle_t *cycle, bool is_by_hand)
{
    const bool is_running = self->membranes.run.is_running != 0U;
    const bool is_turn = (self->sealed.cycle % CARD_SLOT_COUNT) == 0U;
    if ((is_running || is_by_hand || is_turn) && is_damaged(&self->membranes)) {
        controller_note(self, cycle, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_MEMBRANES, 0);
        controller_clear_membranes(self);
    }
}

/* Expected membranes belong to the entry point and the target that they were sent for. */
static void forget_others(controller_t *self, const cycle_t *cycle)
{
    const membrane_plan_t *const plan = &self->membranes.plan;
    const bool is_same = (plan_judge_entry(&self->plan) == STATUS_OK) &&
                         rigid_is_same_point(&plan->entry, &self->plan.entry) &&
                         rigid_is_same_point(&plan->target, &self->plan.scanner_target.translation);
    if (!is_same) {
        controller_clear_membranes(self);
        controller_note(self, cycle, EVENT_MEMBRANES_FORGOTTEN, 0U, 0);
    }
}

/* Of the target below the entry point. */
static int32_t target_um(const plan_t *plan)
{
    const point_t *const target = &plan->scanner_target.translation;
    const int64_t x_um = ((int64_t)target->x_nm - (int64_t)plan->entry.x_nm) / NM_PER_UM;
    const int64_t y_um = ((int64_t)target->y_nm - (int64_t)plan->entry.y_nm) / NM_PER_UM;
    const int64_t z_um = ((int64_t)target->z_nm - (int64_t)plan->entry.z_nm) / NM_PER_UM;
    const int64_t square = (x_um * x_um) + (y_um * y_um) + (z_um * z_um);
    return (int32_t)fixed_square_root((uint64_t)square);
}

static uint32_t needle_of(const cycle_t *cycle)
{
    return cycle->robot->needle_axis % ROBOT_AXIS_MAX; /* Of a damaged table. */
}

/* Way of the needle to its depth at the target; negative beyond it. */
static int64_t left_ticks(const controller_t *self, const cycle_t *cycle)
{
    const uint32_t needle = needle_of(cycle);
    return (int64_t)self->plan.target_ticks[needle] -
           (int64_t)self->axes[needle].sealed.encoder.position_ticks;
}

static int32_t depth_um(const controller_t *self, const cycle_t *cycle)
{
    const int64_t left_nm =
        (left_ticks(self, cycle) * cycle->robot->axes[needle_of(cycle)].unit_per_tick_q16) /
        COUNT_Q16;
    return fixed_saturate((int64_t)self->membranes.run.target_um -
                          fixed_divide_by(left_nm, NM_PER_UM));
}

/* Standard deviation behind the filter of the detector, if the noise is white. */
static uint32_t noise_un(const force_channel_t *channel, const force_channel_config_t *config)
{
    const int64_t mn_q24 =
        (int64_t)channel->noise_q8 * fixed_magnitude((int64_t)config->mn_per_count_q16);
    const int64_t un = (mn_q24 * (int64_t)LIMIT_MEMBRANE_WHITE_PERMILLE) / NOISE_Q24;
    return (uint32_t)un;
}

/* The last reading, before the filter of the channel. */
static int32_t reading_mn(const force_channel_t *channel, const force_channel_config_t *config)
{
    const int64_t counts_q16 =
        ((int64_t)channel->counts[0] * COUNT_Q16) - (int64_t)channel->zero_q16;
    return (int32_t)((counts_q16 * (int64_t)config->mn_per_count_q16) / INT64_C(4294967296));
}

static void begin(controller_t *self, const cycle_t *cycle)
{
    membrane_watch_t *const watch = &self->membranes;
    membrane_detector_init(&watch->run.detector,
                           noise_un(&self->force.sealed.channels[FORCE_CHANNEL_NEEDLE],
                                    &cycle->robot->force.channels[FORCE_CHANNEL_NEEDLE]));
    watch->run.target_um = target_um(&self->plan);
    watch->run.is_running = 1U;
    watch->least_fall_mn = membrane_detector_floor_un(&watch->run.detector) / (uint32_t)NM_PER_UM;
    if (needle_is_out(cycle->robot, self->axes)) {
        membrane_list_renew(&watch->plan.list);
    } else {
        membrane_list_blind(&watch->plan.list, depth_um(self, cycle));
    }
    seal_list(watch);
}

static void note_depth(controller_t *self, const cycle_t *cycle, event_id_t id, uint32_t subject,
                       int32_t depth_um)
{
    controller_note(self, cycle, id, subject, fixed_saturate((int64_t)depth_um * NM_PER_UM));
}

static void note_missed(controller_t *self, const cycle_t *cycle, uint32_t place)
{
    const membrane_t *const membrane = &self->membranes.plan.list.membranes[place];
    note_depth(self, cycle,
               (membrane->state == (uint32_t)MEMBRANE_PASSED) ? EVENT_MEMBRANE_PASSED
                                                              : EVENT_MEMBRANE_MISSED,
               place + 1U, membrane->depth_um);
}

/* Each vibration that has begun is whole in the log, or has its end there. */
static void note_vibration(controller_t *self, const cycle_t *cycle, membrane_answer_t now)
{
    membrane_watch_t *const watch = &self->membranes;
    const uint32_t before = watch->vibration;
    watch->vibration = (uint32_t)now;
    if ((now == MEMBRANE_ANSWER_RUNS) && (before == (uint32_t)MEMBRANE_ANSWER_NONE)) {
        note_depth(self, cycle, EVENT_VIBRATION_BEGUN, 0U, watch->depth_um);
    } else if ((now == MEMBRANE_ANSWER_NONE) && (before == (uint32_t)MEMBRANE_ANSWER_RUNS)) {
        note_depth(self, cycle, EVENT_VIBRATION_CUT, 0U, watch->depth_um);
    } else {
        /* As before, or whole. */
    }
}

static membrane_answer_t answer_of(const mode_state_t *mode, mode_kind_t kind)
{
    membrane_answer_t answer = MEMBRANE_ANSWER_NONE;
    if (mode_wants_hand_off(mode, kind)) {
        answer = MEMBRANE_ANSWER_WHOLE;
    } else if (mode_is_vibrating(mode, kind)) {
        answer = MEMBRANE_ANSWER_RUNS;
    } else {
        /* It follows the hand. */
    }
    return answer;
}

/* All of them lie before the target. An insertion that has ended too deep has reached it as well.
 */
static void end(controller_t *self, const cycle_t *cycle)
{
    membrane_watch_t *const watch = &self->membranes;
    if (left_ticks(self, cycle) <= (int64_t)cycle->robot->axes[needle_of(cycle)].deadband_ticks) {
        for (uint32_t i = 0U; i < LIMIT_MEMBRANES_MOST; i++) {
            const uint32_t place = membrane_list_end(&watch->plan.list);
            if (place != MEMBRANE_NONE) {
                note_missed(self, cycle, place);
            }
        }
    }
    membrane_list_look(&watch->plan.list, watch->depth_um);
    seal_list(watch);
    note_vibration(self, cycle, MEMBRANE_ANSWER_NONE);
    watch->run.is_running = 0U;
    watch->sight = (uint32_t)MEMBRANE_SIGHT_OFF;
    watch->depth_um = 0;
    watch->least_fall_mn = 0U;
    seal_run(watch);
}

static void note_event(controller_t *self, const cycle_t *cycle, const membrane_event_t *event)
{
    if (event->kind == (uint32_t)MEMBRANE_EVENT_MISSED) {
        note_missed(self, cycle, event->place);
    } else {
        note_depth(self, cycle,
                   (event->kind == (uint32_t)MEMBRANE_EVENT_EXPECTED) ? EVENT_MEMBRANE_FOUND
                                                                      : EVENT_MEMBRANE_UNEXPECTED,
                   (uint32_t)event->fall_mn, event->depth_um);
    }
}

/* A reading that stands still in a motion may be that of a dead sensor, with or without noise. */
static bool is_felt(const force_channel_t *needle)
{
    return force_channel_is_believed(needle) && !force_channel_is_still(needle);
}

static membrane_sight_t sight_of(const membrane_run_t *run, bool is_felt_now, bool is_vibrating)
{
    membrane_sight_t sight = MEMBRANE_SIGHT_DOUBTFUL;
    if (is_felt_now && is_vibrating) {
        sight = MEMBRANE_SIGHT_VIBRATING;
    } else if (is_felt_now) {
        sight = membrane_detector_is_looking(&run->detector) ? MEMBRANE_SIGHT_LOOKING
                                                             : MEMBRANE_SIGHT_PAUSED;
    } else {
        /* Doubtful, whatever it does. */
    }
    return sight;
}

/* Nothing can be said of a membrane that was passed meanwhile. */
static void pass_blindly(membrane_watch_t *watch)
{
    if (watch->depth_um > watch->plan.list.unseen_um) {
        membrane_list_blind(&watch->plan.list, watch->depth_um);
        seal_list(watch);
    }
}

static bool feel(controller_t *self, const cycle_t *cycle, bool is_vibrating)
{
    membrane_watch_t *const watch = &self->membranes;
    const force_channel_t *const channel = &self->force.sealed.channels[FORCE_CHANNEL_NEEDLE];
    const bool is_felt_now = is_felt(channel);
    const uint32_t before = watch->sight;
    watch->depth_um = depth_um(self, cycle);
    const membrane_view_t view = {
        .force_mn = reading_mn(channel, &cycle->robot->force.channels[FORCE_CHANNEL_NEEDLE]),
        .depth_um = watch->depth_um,
        .is_inserting = self->axes[needle_of(cycle)].sealed.setpoint_speed_ticks_per_s_q8 > 0,
        .is_blind = !is_felt_now || is_vibrating};
    if (!is_felt_now) {
        pass_blindly(watch);
    }
    const membrane_event_t event =
        membrane_detector_step(&watch->run.detector, &watch->plan.list, &view);
    if (event.kind != (uint32_t)MEMBRANE_EVENT_NONE) {
        note_event(self, cycle, &event);
        seal_list(watch);
    }
    watch->sight = (uint32_t)sight_of(&watch->run, is_felt_now, is_vibrating);
    if (!is_felt_now && (before != watch->sight)) {
        controller_note(self, cycle, EVENT_MEMBRANES_UNSEEN, 0U, 0);
    }
    seal_run(watch);
    return (event.kind == (uint32_t)MEMBRANE_EVENT_EXPECTED) ||
           (event.kind == (uint32_t)MEMBRANE_EVENT_UNEXPECTED);
}

bool controller_feel_membranes(controller_t *self, const cycle_t *cycle)
{
    const mode_kind_t kind = mode_in(&self->mode, procedure_workphase(&self->procedure));
    const bool is_by_hand = procedure_is_armed(&self->procedure) && mode_is_by_hand(kind);
    check(self, cycle, is_by_hand);
    if (self->membranes.plan.list.count != 0U) {
        forget_others(self, cycle);
    }
    const bool is_running = self->membranes.run.is_running != 0U;
    if (is_by_hand && !is_running) {
        begin(self, cycle);
    } else if (!is_by_hand && is_running) {
        end(self, cycle);
    } else {
        /* As before. */
    }
    bool is_puncture = false;
    if (is_by_hand) {
        is_puncture = feel(self, cycle, mode_is_vibrating(&self->mode, kind));
        note_vibration(self, cycle, answer_of(&self->mode, kind));
    }
    return is_puncture;
}

/* All of them lie between entry point and target. */
static status_t judge_depths(const command_membranes_t *sent, int32_t most_um)
{
    int32_t last_um = 0;
    if (sent->count > LIMIT_MEMBRANES_MOST) {
        return STATUS_OUT_OF_RANGE;
    }
    for (uint32_t i = 0U; i < sent->count; i++) {
        if ((sent->depths_um[i] <= 0) || (sent->depths_um[i] > most_um)) {
            return STATUS_MEMBRANE_DEPTH;
        }
        if (sent->depths_um[i] <= last_um) {
            return STATUS_MEMBRANE_ORDER;
        }
        last_um = sent->depths_um[i];
    }
    return STATUS_OK;
}

static status_t judge(const controller_t *self, const cycle_t *cycle, const command_t *command)
{
    status_t status = STATUS_OK;
    if (!controller_is_of_workphase(self, command)) {
        status = STATUS_WRONG_WORKPHASE;
    } else if (cycle->robot->force.is_there == 0U) {
        status = STATUS_NO_FORCE_SENSOR;
    } else if (procedure_is_armed(&self->procedure)) {
        status = STATUS_MOTION_ARMED;
    } else {
        status = plan_judge_entry(&self->plan);
    }
    return (status == STATUS_OK)
               ? judge_depths(command_as_membranes(command), target_um(&self->plan))
               : status;
}

status_t controller_obey_membranes(controller_t *self, const cycle_t *cycle,
                                   const command_t *command, answer_t *answer)
{
    (void)answer;
    const command_membranes_t *const sent = command_as_membranes(command);
    membrane_watch_t *const watch = &self->membranes;
    status_t status = judge(self, cycle, command);
    if (status == STATUS_OK) {
        status = membrane_list_set(&watch->plan.list, sent->depths_um, sent->count);
    }
    if (status == STATUS_OK) {
        watch->plan.entry = self->plan.entry;
        watch->plan.target = self->plan.scanner_target.translation;
        seal_list(watch);
        controller_note(self, cycle, EVENT_MEMBRANES_TAKEN, 0U, (int32_t)sent->count);
        for (uint32_t i = 0U; i < sent->count; i++) {
            note_depth(self, cycle, EVENT_MEMBRANE_EXPECTED, i + 1U, sent->depths_um[i]);
        }
    }
    return status;
}

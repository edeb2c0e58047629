/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/operator/operator.h"

#include "charts/arming_chart.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "supervise/scenario/acts.h"
#include "supervise/scenario/prng.h"
#include "supervise/operator/operator_command.h"
#include "supervise/operator/operator_history.h"
#include "supervise/operator/operator_promise.h"
#include "supervise/scenario/targets.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define ORDER_SIZE 64U
#define HOLD_CYCLES ((LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 100U)
#define LOOK_CYCLES 300U
#define COOL_CYCLES 4000U    /* A scan and a hot motor last so long here. */
#define RUNAWAY_CYCLES 9000U /* A motion that has not ended by then does not. */
#define FOUND_CYCLES 600000U /* The longest order that he finds, as a sweep, ends by then. */
#define CHECK_PARTS 211U     /* In one of so many cycles the promise of the step is tried. */
#define MOST_TRIES 1U        /* Then he starts anew. */

static const char *const parts[] = {"card", "encoder", "motor", "switch"};
static const char *axis_name(const rig_t *rig, uint32_t axis)
{
    return rig->box.robot->axes[axis].name;
}

static void mend_axis(rig_t *rig, uint32_t axis)
{
    for (uint32_t i = 0U; i < (sizeof parts / sizeof parts[0]); i++) {
        char order[ORDER_SIZE];
        (void)snprintf(order, sizeof order, "%s %s normal", parts[i], axis_name(rig, axis));
        rig_box(rig, order);
    }
    rig->box.axes[axis].motor.load = 0.0;
}

static void cool(rig_t *rig)
{
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        box_axis_t *const axis = &rig->box.axes[i];
        const bool is_motor = axis->motor.fault == SIM_MOTOR_HOT;
        axis->motor.fault = is_motor ? SIM_MOTOR_NORMAL : axis->motor.fault;
        axis->card_fault = (axis->card_fault == BOX_CARD_HOT) ? BOX_CARD_NORMAL : axis->card_fault;
        axis->card.motor_temperature_c = SIM_MOTOR_AIR_C;
    }
}

static bool is_broken(const rig_t *rig, uint32_t axis)
{
    const box_axis_t *const part = &rig->box.axes[axis];
    return (part->card_fault != BOX_CARD_NORMAL) || (part->encoder.fault != SIM_ENCODER_NORMAL) ||
           (part->motor.fault != SIM_MOTOR_NORMAL) || (part->motor.load > 0.0) ||
           (part->limit_switch.fault != SIM_SWITCH_NORMAL);
}

/* The named part is truly broken. */
static bool is_named_broken(const rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    bool is_any = false;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        const bool is_named =
            (shown->step_axis == i) || (shown->step_card == rig->box.robot->axes[i].slot);
        is_any = is_any || (is_named && is_broken(rig, i));
    }
    return is_any;
}

static void check_promise(operator_t *self, const rig_t *rig)
{
    const uint32_t step = rig->outputs.snapshot.next_step;
    const bool is_due =
        (step != self->checked_step) || (prng_below(&self->random, CHECK_PARTS) == 0U);
    if (is_due && operator_promise_try(rig, &self->refusal)) {
        self->checked_step = step;
    }
    if (self->refusal != STATUS_OK) {
        self->end = OPERATOR_REFUSED;
        self->last_step = step;
    }
}

/* The box is switched off and on, with the axes that have no switch at their marks, and with all of
 * them where the robot is parked if some share a limit; the programs are started anew; what is
 * broken stays so. */
static void start_anew(operator_t *self, rig_t *rig)
{
    static rig_t old;
    double truth[ROBOT_AXIS_MAX];
    box_true_positions(&rig->box, truth);
    old = *rig;
    self->robot = *rig->box.robot;
    for (uint32_t i = 0U; i < self->robot.axis_count; i++) {
        const axis_config_t *const axis = &self->robot.axes[i];
        if (axis->home_method != (uint8_t)HOME_BY_SWITCH) {
            self->robot.start_ticks[i] = axis->home_ticks;
        } else if (self->robot.coupled_limit_count == 0U) {
            self->robot.start_ticks[i] = (int32_t)lround(truth[i]);
        } else {
            /* As it is parked. */
        }
    }
    rig_start_robot(rig, &self->robot);
    rig->lacks_black_box = old.lacks_black_box;
    rig->is_recorder_failing = old.is_recorder_failing;
    rig->unread = old.unread;
    self->has_started_anew = true;
    for (uint32_t i = 0U; i < self->robot.axis_count; i++) {
        rig->box.axes[i].card_fault = old.box.axes[i].card_fault;
        rig->box.axes[i].encoder.fault = old.box.axes[i].encoder.fault;
        rig->box.axes[i].motor.fault = old.box.axes[i].motor.fault;
        rig->box.axes[i].motor.load = old.box.axes[i].motor.load;
        rig->box.axes[i].limit_switch.fault = old.box.axes[i].limit_switch.fault;
    }
}

static void hold_button(operator_t *self, rig_t *rig)
{
    rig_box(rig, "button press");
    self->press_cycles = HOLD_CYCLES;
    self->wait_cycles += HOLD_CYCLES;
}

static void act_by_command(operator_t *self, rig_t *rig, uint32_t step)
{
    command_t command;
    if (!operator_command_of(rig, step, &command)) {
        self->end = OPERATOR_DEAD_END;
        return;
    }
    if (step == (uint32_t)NEXT_STEP_AUTHORITY) {
        rig->is_page_away = false; /* The page keeps it by itself from now on. */
    }
    rig->commands[rig->command_count] = command;
    rig->command_count++;
}

/* The named part is broken, or was mended meanwhile: the button for SERVICE, START_UP for COMPARE,
 * and if that does not help, anew. */
static void call_service(operator_t *self, rig_t *rig, uint32_t step)
{
    const bool is_free = !authority_is_held(&rig->controller.authority);
    if (is_named_broken(rig)) {
        self->end = OPERATOR_SERVICE;
    } else if (self->tries >= MOST_TRIES) {
        self->tries = 0U;
        start_anew(self, rig);
    } else if (step == (uint32_t)NEXT_STEP_SERVICE) {
        self->tries++;
        hold_button(self, rig);
    } else {
        self->tries += is_free ? 0U : 1U;
        act_by_command(self, rig, is_free ? (uint32_t)NEXT_STEP_AUTHORITY : step);
    }
}

static void compare(operator_t *self, rig_t *rig, uint32_t step)
{
    if (acts_is_shown_true(rig)) {
        hold_button(self, rig);
    } else if (step == (uint32_t)NEXT_STEP_COMPARE) {
        call_service(self, rig, step);
    } else {
        start_anew(self, rig);
    }
}

static bool is_beyond(const rig_t *rig, uint32_t axis)
{
    double truth[ROBOT_AXIS_MAX];
    const axis_config_t *const config = &rig->box.robot->axes[axis];
    box_true_positions(&rig->box, truth);
    return (truth[axis] < config->minimum_ticks) || (truth[axis] > config->maximum_ticks);
}

/* By hand, to the nearer end of its range. */
static void bring_back(operator_t *self, rig_t *rig, uint32_t axis)
{
    const axis_config_t *const config = &rig->box.robot->axes[axis];
    double *const place = &rig->box.axes[axis].motor.position_ticks;
    *place = fmin(fmax(*place, config->minimum_ticks), config->maximum_ticks);
    self->brought |= (uint32_t)1U << axis;
}

/* The page asks for it, as RESTORE is a matter of the page; GRANT follows. */
static void ask_for_authority(rig_t *rig)
{
    rig->commands[rig->command_count] =
        (command_t){.id = OPERATOR_COMMAND_ID,
                    .kind = (uint32_t)COMMAND_REQUEST,
                    .source = (uint32_t)COMMAND_SOURCE_HTTP,
                    .peer = RIG_PAGE,
                    .as.request = {.request = (uint32_t)AUTHORITY_REQUEST_TAKE}};
    rig->command_count++;
}

static void restore(rig_t *rig, uint32_t axis)
{
    const authority_party_t party = operator_commander(rig);
    command_t command = {.kind = (uint32_t)COMMAND_RESTORE,
                         .id = OPERATOR_COMMAND_ID,
                         .source = party.source,
                         .peer = party.peer,
                         .as.positions = {.axes = 1U << axis}};
    double truth[ROBOT_AXIS_MAX];
    box_true_positions(&rig->box, truth);
    command.as.positions.ticks[axis] = (int32_t)lround(truth[axis]);
    rig->commands[rig->command_count] = command;
    rig->command_count++;
}

/* The operator measures where the axis stands and restores that position. An axis beyond its ends
 * is brought back by hand; one that leaves them again is for service, as the step says. */
static void place(operator_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const uint32_t heeding = ((uint32_t)1U << WORKPHASE_UNDEFINED) | (1U << WORKPHASE_MANUAL) |
                             (1U << WORKPHASE_STOP) | (1U << WORKPHASE_EMERGENCY);
    const uint32_t axis = shown->step_axis;
    if (is_beyond(rig, axis) && (((self->brought >> axis) & 1U) != 0U)) {
        self->end = is_named_broken(rig) ? OPERATOR_SERVICE : OPERATOR_DEAD_END;
    } else if (is_beyond(rig, axis)) {
        bring_back(self, rig, axis);
    } else if (!authority_is_held(&rig->controller.authority)) {
        act_by_command(self, rig, (uint32_t)NEXT_STEP_AUTHORITY);
    } else if (((heeding >> shown->workphase) & 1U) == 0U) {
        act_by_command(self, rig, (uint32_t)NEXT_STEP_STOP);
    } else if (operator_commander(rig).source != (uint32_t)COMMAND_SOURCE_HTTP) {
        ask_for_authority(rig);
    } else {
        restore(rig, axis);
    }
}

/* An engineer accepts it, where the page commands; over another network he frees the disk. */
static void settle_black_box(operator_t *self, rig_t *rig)
{
    const authority_party_t party = operator_commander(rig);
    const command_t accept = {.kind = (uint32_t)COMMAND_ACCEPT_NO_BLACK_BOX,
                              .id = OPERATOR_COMMAND_ID,
                              .source = party.source,
                              .peer = party.peer};
    if (!authority_is_held(&rig->controller.authority)) {
        act_by_command(self, rig, (uint32_t)NEXT_STEP_AUTHORITY);
    } else if (party.source != (uint32_t)COMMAND_SOURCE_HTTP) {
        rig->lacks_black_box = 0U;
    } else {
        rig->commands[rig->command_count] = accept;
        rig->command_count++;
    }
}

/* He looks again, if what is named is not broken any more. */
static void check_card(operator_t *self, const rig_t *rig)
{
    self->end = is_named_broken(rig) ? OPERATOR_SERVICE : self->end;
}

/* He finds the plug of all cards pulled. */
static void check_box(rig_t *rig)
{
    const bool is_pulled = operator_is_unplugged(rig);
    rig->unread = 0U;
    for (uint32_t i = 0U; is_pulled && (i < rig->box.robot->axis_count); i++) {
        rig->box.axes[i].card_fault = BOX_CARD_NORMAL;
    }
}

static void follow(operator_t *self, rig_t *rig, uint32_t step)
{
    self->acts++;
    self->last_step = step;
    switch (step) {
    case NEXT_STEP_RELEASE_ESTOP:
        rig_box(rig, "estop reset");
        break;
    case NEXT_STEP_RELEASE_PEDAL:
    case NEXT_STEP_PEDAL_FAULT:
        rig_box(rig, "pedal release");
        break;
    case NEXT_STEP_PRESS_PEDAL:
        rig_box(rig, "pedal press");
        break;
    case NEXT_STEP_PUSH:
        rig_box(rig, "grip 800");
        rig_box(rig, "hand press");
        break;
    case NEXT_STEP_LET_GO:
        rig_box(rig, "hand release");
        break;
    case NEXT_STEP_GRANT:
        rig_box(rig, "pedal release");
        hold_button(self, rig);
        break;
    case NEXT_STEP_PLACE:
        place(self, rig);
        break;
    case NEXT_STEP_CONFIRM:
    case NEXT_STEP_COMPARE:
        compare(self, rig, step);
        break;
    case NEXT_STEP_MAKE_ROOM:
    case NEXT_STEP_BY_HAND:
        start_anew(self, rig);
        break;
    case NEXT_STEP_CHECK_CARDS:
        check_card(self, rig);
        break;
    case NEXT_STEP_CHECK_BOX:
        check_box(rig);
        break;
    case NEXT_STEP_RECORDER:
        rig->is_recorder_failing = 0U;
        break;
    case NEXT_STEP_NO_BLACK_BOX:
        settle_black_box(self, rig);
        break;
    case NEXT_STEP_SERVICE:
        call_service(self, rig, step);
        break;
    default:
        act_by_command(self, rig, step);
        break;
    }
}

/* A scan and heat end in their time; what does not come to rest is for service. */
static void wait_on(operator_t *self, rig_t *rig)
{
    self->waited_cycles++;
    if (self->waited_cycles == COOL_CYCLES) {
        cool(rig);
        rig_box(rig, "scanner off");
    } else if (self->waited_cycles >= RUNAWAY_CYCLES) {
        self->last_step = rig->outputs.snapshot.next_step;
        self->end = is_named_broken(rig) ? OPERATOR_SERVICE : OPERATOR_DEAD_END;
    } else {
        /* He waits. */
    }
}

/* With a target he goes on to it; without one he would have to know more than is shown. */
static bool may_command(const snapshot_t *shown)
{
    const uint32_t step = shown->next_step;
    const bool is_on_the_way = (step == (uint32_t)NEXT_STEP_PLANNING) ||
                               (step == (uint32_t)NEXT_STEP_CALIBRATION) ||
                               (step == (uint32_t)NEXT_STEP_TARGETING);
    const bool is_asked =
        (is_on_the_way && (shown->has_target == 0U)) || (step == (uint32_t)NEXT_STEP_PROBE) ||
        (step == (uint32_t)NEXT_STEP_REGISTER) || (step == (uint32_t)NEXT_STEP_TARGET) ||
        (step == (uint32_t)NEXT_STEP_PROGRAM_DONE) || (step == (uint32_t)NEXT_STEP_NOTHING);
    return is_asked && (shown->is_homed != 0U) && (shown->order == (uint32_t)ARMING_STATE_NONE);
}

void operator_begin(operator_t *self, rig_t *rig, uint32_t seed)
{
    (void)memset(self, 0, sizeof *self);
    self->random = (seed * 668265263U) | 1U;
    self->checked_step = UINT32_MAX;
    for (uint32_t i = 0U; i < 4U; i++) {
        (void)prng_below(&self->random, 2U);
    }
    for (uint32_t i = 0U; ((seed / 2U) % 2U == 0U) && (i < rig->box.robot->axis_count); i++) {
        mend_axis(rig, i);
    }
    operator_leave(rig, &self->random);
    rig_box(rig, "button release");
    rig->silent_sources = 0U;
    rig->lacks_black_box = ((seed / 4U) % 2U == 0U) ? 1U : 0U;
    rig->is_page_away = prng_below(&self->random, 2U) == 0U;
    self->wait_cycles = prng_below(&self->random, LOOK_CYCLES);
    self->is_of_others = true;
}

operator_end_t operator_play(operator_t *self, rig_t *rig)
{
    const uint32_t step = rig->outputs.snapshot.next_step;
    const bool is_asked_to_wait =
        (step == (uint32_t)NEXT_STEP_WAIT) || (step == (uint32_t)NEXT_STEP_SCANNER);
    self->shown |= (uint64_t)1U << step;
    self->is_of_others = self->is_of_others &&
                         (rig->outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE) &&
                         (self->found_cycles < FOUND_CYCLES);
    self->found_cycles += self->is_of_others ? 1U : 0U;
    self->time_cycles += (is_asked_to_wait || self->is_of_others) ? 0U : 1U;
    if (is_asked_to_wait) {
        wait_on(self, rig);
    } else {
        self->waited_cycles = 0U;
        check_promise(self, rig);
    }
    if (self->press_cycles > 0U) {
        self->press_cycles--;
        if (self->press_cycles == 0U) {
            rig_box(rig, "button release");
        }
    }
    if (self->wait_cycles > 0U) {
        self->wait_cycles--;
    } else if ((self->end != OPERATOR_ACTS) || is_asked_to_wait ||
               (step == (uint32_t)NEXT_STEP_HOLD_PEDAL)) {
        /* It goes on by itself. */
    } else if (may_command(&rig->outputs.snapshot)) {
        self->end = (step == (uint32_t)NEXT_STEP_NOTHING) ? OPERATOR_ARRIVES : OPERATOR_COMMANDS;
    } else {
        self->wait_cycles = LOOK_CYCLES + prng_below(&self->random, LOOK_CYCLES);
        follow(self, rig, step);
    }
    if ((self->end == OPERATOR_ACTS) &&
        ((self->acts > LIMIT_OPERATOR_ACTS) ||
         ((self->time_cycles * LIMIT_CYCLE_US) > LIMIT_OPERATOR_TIME_US))) {
        self->end = OPERATOR_DEAD_END;
    }
    return self->end;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/show/controller_ready.h"

#include "controller/controller_facts.h"

#include "mode/homing/homing_mode.h"
#include "safety/coupled_guard.h"

/* The card of an axis that is not used, and would not be after START_UP either. */
static bool is_card_missing(const controller_t *self, uint32_t index)
{
    const link_t *const link = controller_link(self, index);
    return !link_is_usable(link) && !link_is_healthy_now(link);
}

static bool is_motor_hot(const controller_t *self, const robot_t *robot, uint32_t index)
{
    const int32_t heat_dc = controller_link(self, index)->report.motor_temperature_dc;
    return !axis_is_enabled(&self->axes[index]) && (heat_dc > robot->axes[index].hottest_dc);
}

static bool is_driver_hot(const controller_t *self, uint32_t index)
{
    const uint32_t troubles = self->health[self->cards.slots[index]].troubles;
    return (troubles & card_health_bit(CARD_TROUBLE_DRIVER_HOT)) != 0U;
}

static named_step_t of_axis(next_step_t step, uint32_t axis, event_id_t event)
{
    return (named_step_t){step, axis, CARD_SLOT_COUNT, (uint32_t)event};
}

static named_step_t of_card(const controller_t *self, next_step_t step, uint32_t axis,
                            event_id_t event)
{
    return (named_step_t){step, axis, self->cards.slots[axis], (uint32_t)event};
}

static bool is_start_up(const named_step_t *found)
{
    return found->step == NEXT_STEP_START_UP;
}

/* The first card that does not answer well; if none does, it is the box.
 *
 * @satisfies SWR-NEXT-180
 */
static named_step_t find_card(const controller_t *self)
{
    named_step_t found = controller_step_only(NEXT_STEP_START_UP);
    bool is_any_there = false;
    for (uint32_t i = self->sealed.axis_count; i > 0U; i--) {
        if (is_card_missing(self, i - 1U)) {
            found = of_card(self, NEXT_STEP_CHECK_CARDS, i - 1U, EVENT_CARD_LOST);
        } else {
            is_any_there = true;
        }
    }
    return is_any_there ? found : controller_step_only(NEXT_STEP_CHECK_BOX);
}

static named_step_t find_pedal(const controller_t *self, const controller_inputs_t *inputs)
{
    const bool is_faulty = self->pedal.chart.state == PEDAL_GATE_STATE_FAULT;
    next_step_t step = NEXT_STEP_START_UP;
    if (is_faulty && (inputs->pedal_a != inputs->pedal_b)) {
        step = NEXT_STEP_PEDAL_FAULT;
    } else if (self->pedal.sealed.is_released == 0U) {
        step = NEXT_STEP_RELEASE_PEDAL;
    } else {
        /* It is not pressed. */
    }
    return controller_step_only(step);
}

/* A hot axis that START_UP enables would be disabled again. */
static named_step_t find_heat(const controller_t *self, const robot_t *robot)
{
    named_step_t found = controller_step_only(NEXT_STEP_START_UP);
    for (uint32_t i = 0U; is_start_up(&found) && (i < self->sealed.axis_count); i++) {
        if (is_motor_hot(self, robot, i)) {
            found = of_axis(NEXT_STEP_WAIT, i, EVENT_AXIS_HOT);
        } else if (is_driver_hot(self, i)) {
            found = of_card(self, NEXT_STEP_WAIT, i, EVENT_CARD_HOT);
        } else {
            /* It is cool. */
        }
    }
    return found;
}

/* Axes that START_UP alone does not help: an axis whose switch and counts contradict each other,
 * and one that must not be homed. One in doubt that has left the target need not be homed. */
static named_step_t find_vain_homing(const controller_t *self, const robot_t *robot, uint32_t index)
{
    const axis_t *const axis = &self->axes[index];
    const bool is_in_doubt = axis->chart.reference == AXIS_REFERENCE_UNVERIFIED;
    named_step_t found = controller_step_only(NEXT_STEP_START_UP);
    if (axis_is_contradicted(axis)) {
        found = of_axis(NEXT_STEP_COMPARE, index, EVENT_AXIS_SWITCH_ELSEWHERE);
    } else if (escort_was_missing(&self->mode.sealed.escort, index) && !axis_is_homed(axis)) {
        found = of_axis(is_in_doubt ? NEXT_STEP_CONFIRM : NEXT_STEP_BY_HAND, index,
                        EVENT_HOMING_NO_WAY);
    } else if (coupled_guard_bars_homing(robot, self->axes, index)) {
        found = of_axis(is_in_doubt ? NEXT_STEP_CONFIRM : NEXT_STEP_MAKE_ROOM, index,
                        EVENT_HOMING_BARRED);
    } else if (is_in_doubt && (self->plan.has_target != 0U)) {
        found = of_axis(NEXT_STEP_CONFIRM, index, EVENT_AXIS_DRIFTED);
    } else {
        /* START_UP homes it. */
    }
    return found;
}

/* One that has no switch: what is shown of it is known to be old, or in doubt.
 *
 * @satisfies SWR-NEXT-181
 */
static named_step_t in_place(const axis_t *axis, uint32_t index)
{
    return (axis->chart.reference == AXIS_REFERENCE_LOST)
               ? of_axis(NEXT_STEP_PLACE, index, EVENT_AXIS_REFERENCE_LOST)
               : of_axis(NEXT_STEP_CONFIRM, index, EVENT_AXIS_UNVERIFIED);
}

/* Without the button START_UP would be refused, or not be enough; the former first. */
static named_step_t find_doubt(const controller_t *self, const robot_t *robot)
{
    named_step_t found = controller_step_only(NEXT_STEP_START_UP);
    for (uint32_t i = 0U; is_start_up(&found) && (i < self->sealed.axis_count); i++) {
        if (axis_needs_confirmation(&self->axes[i], &robot->axes[i])) {
            found = in_place(&self->axes[i], i);
        }
    }
    for (uint32_t i = 0U; is_start_up(&found) && (i < self->sealed.axis_count); i++) {
        found = find_vain_homing(self, robot, i);
    }
    const uint32_t unplaced =
        is_start_up(&found) ? homing_mode_unplaced(robot, self->axes) : self->sealed.axis_count;
    if (unplaced < self->sealed.axis_count) {
        found = of_axis(NEXT_STEP_PLACE, unplaced, EVENT_HOMING_UNPLACED);
    }
    return found;
}

/* The button says nothing while anything is armed, nor while a position in doubt moves; a scan has
 * counts come and go. */
static named_step_t free_button(const controller_t *self, const cycle_t *cycle,
                                const named_step_t *asked)
{
    named_step_t found = *asked;
    if ((asked->step == NEXT_STEP_MAKE_ROOM) || (asked->step == NEXT_STEP_BY_HAND)) {
        return found;
    }
    if (procedure_is_armed(&self->procedure)) {
        return controller_step_only(NEXT_STEP_STOP);
    }
    if (cycle->inputs->scanner_active != 0U) {
        return controller_step_only(NEXT_STEP_SCANNER);
    }
    for (uint32_t i = 0U; (found.step == asked->step) && (i < self->sealed.axis_count); i++) {
        if (axis_is_moving_in_doubt(&self->axes[i])) {
            found = of_axis(NEXT_STEP_WAIT, i, EVENT_AXIS_MOVED_OFF);
        }
    }
    return found;
}

static named_step_t of_vain(const controller_t *self)
{
    return (named_step_t){NEXT_STEP_SERVICE, self->sealed.vain_axis, self->sealed.vain_card,
                          self->sealed.vain_event};
}

static bool are_moves_vain(const controller_t *self)
{
    return self->sealed.vain_moves >= LIMIT_SERVICE_MOVES;
}

static bool is_in_vain(const controller_t *self)
{
    return (self->sealed.vain_start_ups >= LIMIT_SERVICE_START_UPS) || are_moves_vain(self);
}

/* An axis that is placed again and again would end START_UP once more. */
static bool is_vain_axis(const controller_t *self, const named_step_t *found)
{
    const bool is_placing = (found->step == NEXT_STEP_PLACE) || (found->step == NEXT_STEP_CONFIRM);
    return is_placing && (found->axis == self->sealed.vain_axis);
}

/* A confirmation before service would only allow more of the orders that have failed. */
static named_step_t find_position(const controller_t *self, const cycle_t *cycle)
{
    named_step_t found = find_doubt(self, cycle->robot);
    if (controller_is_spent(self) ||
        (is_in_vain(self) && (is_start_up(&found) || is_vain_axis(self, &found)))) {
        found = of_vain(self);
    }
    return is_start_up(&found) ? found : free_button(self, cycle, &found);
}

named_step_t controller_ready(const controller_t *self, const cycle_t *cycle)
{
    if (cycle->inputs->unfit != 0U) {
        return controller_step_only(NEXT_STEP_COMPUTER);
    }
    if (controller_lacks_box(self, cycle)) {
        return controller_step_only(NEXT_STEP_NO_BLACK_BOX);
    }
    named_step_t found = find_card(self);
    if (is_start_up(&found)) {
        found = find_pedal(self, cycle->inputs);
    }
    if (is_start_up(&found)) {
        found = find_heat(self, cycle->robot);
    }
    if (is_start_up(&found)) {
        found = find_position(self, cycle);
    }
    return found;
}

named_step_t controller_ready_to_move(const controller_t *self)
{
    return are_moves_vain(self) ? of_vain(self) : controller_step_only(NEXT_STEP_MOVE);
}

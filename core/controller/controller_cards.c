/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_cards.h"

#include "controller/controller_facts.h"
#include "controller/controller_force.h"
#include "controller/controller_order.h"

#include "card/card_dialect.h"
#include "card/link_aim32.h"

#include <stddef.h>

/* An axis that was off when its card fell silent stands where it was, or shows it when the card is
 * back. */
static bool is_only_out_of_sight(const controller_t *self, uint32_t index)
{
    const link_t *const link = controller_link(self, index);
    return supervision_is_at_rest(&self->axes[index].supervision) &&
           (link->sealed.sent.mode == (uint32_t)CARD_DRIVE_OFF) &&
           (link->sealed.sent_before.mode == (uint32_t)CARD_DRIVE_OFF);
}

/* Cards of another dialect do not report whether they have begun to count anew. */
static bool reports_new_beginning(const cycle_t *cycle)
{
    return cycle->inputs->dialect == (uint32_t)CARD_DIALECT_OWN;
}

/* The next report shows the way of its counter while it was not heard, unless its program stood. */
static card_loss_t judge_loss(const controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const link_t *const link = controller_link(self, index);
    card_loss_t loss = CARD_LOSS_LOSES;
    if (!link_was_only_silent(link)) {
        /* The worth of its counts is not known. */
    } else if (reports_new_beginning(cycle) && !link_is_standing(link)) {
        loss = CARD_LOSS_KEEPS;
    } else if (is_only_out_of_sight(self, index)) {
        loss = CARD_LOSS_DOUBTS;
    } else {
        /* Its last motion was not seen. */
    }
    return loss;
}

static bool is_loop_late(const link_t *link)
{
    return (link->sealed.cause == (uint16_t)LINK_CAUSE_FAULT) && link_was_only_silent(link) &&
           (link->reported_us > LIMIT_LOOP_SILENT_US);
}

/* Notes the cause of the loss; for a card that was not heard also the fate of its frame in this
 * cycle. */
static void note_loss(controller_t *self, const cycle_t *cycle, uint32_t slot)
{
    const link_t *const link = &self->links[slot];
    const uint32_t bit = (uint32_t)1U << slot;
    uint32_t cause = link->sealed.cause;
    if (is_loop_late(link)) {
        cause = (uint32_t)LINK_CAUSE_LOOP_LATE;
    } else if (cause != (uint32_t)LINK_CAUSE_AGE) {
        /* It says it all. */
    } else if (link->last_error != (uint16_t)CARD_FRAME_OK) {
        cause = (uint32_t)LINK_CAUSE_REFUSED;
    } else if ((cycle->inputs->frames_late & bit) != 0U) {
        cause = (uint32_t)LINK_CAUSE_LATE;
    } else if ((cycle->inputs->frames_failed & bit) != 0U) {
        cause = (uint32_t)LINK_CAUSE_BUS_ERROR;
    } else {
        /* There was none. */
    }
    controller_note(self, cycle, EVENT_CARD_LOST, slot, (int32_t)cause);
}

static void lose_position(axis_t *axis)
{
    axis_lose_reference(axis);
    axis_break_place(axis);
}

static void apply_loss(axis_t *axis, card_loss_t loss)
{
    if (loss == CARD_LOSS_DOUBTS) {
        axis_doubt(axis);
    }
    if (loss == CARD_LOSS_LOSES) {
        lose_position(axis);
    }
}

void controller_lose_card(controller_t *self, const cycle_t *cycle, uint32_t index,
                          card_loss_t loss)
{
    const uint32_t slot = self->cards.slots[index];
    axis_t *const axis = &self->axes[index];
    note_loss(self, cycle, slot);
    apply_loss(axis, loss);
    axis_disable(axis);
    if (loss != CARD_LOSS_KEEPS) {
        plan_forget_target(&self->plan);
    }
    controller_fail_order(self, cycle, EVENT_CAUSE_CARD, slot);
}

/* Reads the frame from `slot` in this cycle, in the dialect of the cards. */
static inline void hear(link_t *link, const cycle_t *cycle, uint32_t slot)
{
    const controller_inputs_t *const inputs = cycle->inputs;
    const bool is_received = (inputs->frames_received & ((uint32_t)1U << slot)) != 0U;
    const uint8_t *const bytes = is_received ? inputs->frames[slot] : NULL;
    if (inputs->dialect == (uint32_t)CARD_DIALECT_OWN) {
        link_step(link, slot, bytes, &inputs->samples, inputs->elapsed_us);
    } else {
        link_aim32_step(link, slot, bytes, &inputs->samples, inputs->elapsed_us);
    }
}

/* Result of a link's step in a cycle. */
typedef struct {
    bool is_lost;
    bool is_damaged; /* Its chart was. */
} link_step_t;

static inline link_step_t step_link(controller_t *self, const cycle_t *cycle, uint32_t slot)
{
    link_t *const link = &self->links[slot];
    const bool was_usable = link_is_usable(link);
    const bool was_lost = link->chart.state == CARD_LINK_STATE_LOST;
    const bool is_damaged = link_check(link);
    if (is_damaged) {
        controller_note(self, cycle, EVENT_CHART_REPAIRED, (uint32_t)EVENT_CHART_CARD,
                        (int32_t)slot);
    }
    hear(link, cycle, slot);
    if (link->last_error != (uint32_t)CARD_FRAME_OK) {
        controller_note(self, cycle, EVENT_FRAME_REFUSED, slot, (int32_t)link->last_error);
    }
    if (link_is_usable(link) && !was_usable) {
        controller_note(self, cycle, EVENT_CARD_LIVE, slot, 0);
    }
    /* The state before of a damaged chart is not known; the card is lost now. */
    const bool is_lost = (!was_lost || is_damaged) && (link->chart.state == CARD_LINK_STATE_LOST);
    return (link_step_t){.is_lost = is_lost, .is_damaged = is_damaged};
}

/* A card that was lost before: what its counts are worth. */
static void watch_lost(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    link_t *const link = &self->links[self->cards.slots[index]];
    axis_t *const axis = &self->axes[index];
    const uint32_t missed_cycles = axis->sealed.encoder.missed_cycles;
    if (reports_new_beginning(cycle) && link_has_broken(link, missed_cycles)) {
        lose_position(axis);
    }
    if (link_is_standing(link)) {
        apply_loss(axis, judge_loss(self, cycle, index));
    }
    const uint32_t most =
        reports_new_beginning(cycle) ? LIMIT_SILENT_KEPT_CYCLES : LIMIT_LINK_AGE_CYCLES;
    if ((link->is_fresh == 0U) && ((missed_cycles + 1U) >= most)) {
        axis_doubt(axis);
    }
}

void controller_observe_card(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const uint32_t slot = self->cards.slots[index];
    const link_step_t step = step_link(self, cycle, slot);
    if (step.is_lost) {
        controller_lose_card(self, cycle, index,
                             step.is_damaged ? CARD_LOSS_LOSES : judge_loss(self, cycle, index));
    } else if (self->links[slot].chart.state == CARD_LINK_STATE_LOST) {
        watch_lost(self, cycle, index);
    } else {
        /* It is used, or was never heard. */
    }
}

/* Cards without an axis: the loss of one is reported, and nothing else. */
static void observe_sensors(controller_t *self, const cycle_t *cycle)
{
    const uint32_t slots = self->cards.sensor_slots;
    for (uint32_t i = 0U; (slots >> i) != 0U; i++) {
        if (((slots >> i) & 1U) == 0U) {
            continue;
        }
        if (step_link(self, cycle, i).is_lost) {
            note_loss(self, cycle, i);
        }
        controller_observe_force(self, cycle, i);
    }
}

/* A card that the robot does not name: the bytes from there may be noise, so that only its first
 * valid frame is reported. Once it is silent its slot is empty again. */
static void observe_unexpected(controller_t *self, const cycle_t *cycle, uint32_t slot)
{
    const uint32_t bit = (uint32_t)1U << slot;
    link_t *const link = &self->links[slot];
    (void)link_check(link);
    hear(link, cycle, slot);
    if ((link->is_fresh != 0U) && ((self->sealed.unexpected_cards & bit) == 0U)) {
        self->sealed.unexpected_cards |= bit;
        controller_note(self, cycle, EVENT_UNEXPECTED_CARD, slot, (int32_t)link->report.card_type);
    }
    if (((self->sealed.unexpected_cards & bit) != 0U) &&
        (link->sealed.age_cycles >= LIMIT_LINK_AGE_CYCLES)) {
        self->sealed.unexpected_cards &= ~bit;
        controller_note(self, cycle, EVENT_CARD_LOST, slot, (int32_t)LINK_CAUSE_AGE);
        link_init(link, (uint32_t)CARD_TYPE_NONE, cycle->robot->card_firmware);
    }
}

/* In the slots that the robot does not name. */
static void observe_unexpected_cards(controller_t *self, const cycle_t *cycle)
{
    const uint32_t answered = cycle->inputs->frames_received | self->sealed.unexpected_cards;
    const uint32_t slots = answered & ~self->cards.named_slots & CARD_EVERY_SLOT;
    for (uint32_t i = 0U; (slots >> i) != 0U; i++) {
        if (((slots >> i) & 1U) != 0U) {
            observe_unexpected(self, cycle, i);
        }
    }
}

void controller_observe_other_cards(controller_t *self, const cycle_t *cycle)
{
    observe_sensors(self, cycle);
    observe_unexpected_cards(self, cycle);
}

static void note_troubles(controller_t *self, const cycle_t *cycle, uint32_t slot, uint32_t changed)
{
    for (uint32_t i = 0U; i < (uint32_t)CARD_TROUBLE_COUNT; i++) {
        const uint32_t bit = (uint32_t)1U << i;
        if ((changed & bit) != 0U) {
            const bool is_new = (self->health[slot].troubles & bit) != 0U;
            controller_note(self, cycle, is_new ? EVENT_CARD_UNWELL : EVENT_CARD_WELL, slot,
                            (int32_t)i);
        }
    }
}

/* The position of the axis does not depend on its driver. */
static void spare_driver(controller_t *self, const cycle_t *cycle, uint32_t slot)
{
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        if ((self->cards.slots[i] == slot) && axis_is_enabled(&self->axes[i])) {
            axis_disable(&self->axes[i]);
            controller_note(self, cycle, EVENT_CARD_HOT, slot,
                            self->links[slot].report.driver_temperature_dc);
            controller_fail_order(self, cycle, EVENT_CAUSE_CARD, slot);
        }
    }
}

void controller_watch_card(controller_t *self, const cycle_t *cycle)
{
    const uint32_t slot = self->sealed.cycle % CARD_SLOT_COUNT;
    const link_t *const link = &self->links[slot];
    card_health_t *const health = &self->health[slot];
    /* Cards of another dialect do not report their health. */
    if ((link->is_fresh == 0U) || (cycle->inputs->dialect != (uint32_t)CARD_DIALECT_OWN)) {
        return;
    }
    const uint32_t changed =
        card_health_look(health, &link->report, cycle->inputs->estop_open == 0U);
    if (changed != 0U) {
        note_troubles(self, cycle, slot, changed);
    }
    if ((health->troubles & card_health_bit(CARD_TROUBLE_DRIVER_HOT)) != 0U) {
        spare_driver(self, cycle, slot);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/memory/controller_memory.h"

#include "controller/controller_cards.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"

#include "base/seal.h"
#include "robot/robot_damage.h"

#include <string.h>

#define CARDS ROBOT_AXIS_MAX /* Cards of the axes, in their order. */
#define SENSORS (CARDS + ROBOT_AXIS_MAX)
#define MODE (SENSORS + 1U)
#define INTERLOCKS (MODE + 1U)
#define REST (INTERLOCKS + 1U)

static inline uint32_t seal_of_link(uint32_t seal, const link_t *link)
{
    return seal_of(seal, (const uint8_t *)&link->sealed, WHOLE_WORDS(sizeof link->sealed));
}

/* Readings count while a zeroing runs. */
static uint32_t seal_of_force(const force_sensor_t *force)
{
    const uint32_t seal =
        seal_of(SEAL_START, (const uint8_t *)&force->sealed, WHOLE_WORDS(sizeof force->sealed));
    return force_sensor_is_zeroing(force) ? seal_of(seal, (const uint8_t *)force->readings,
                                                    WHOLE_WORDS(sizeof force->readings))
                                          : seal;
}

static uint32_t seal_of_sensors(const controller_t *self)
{
    const uint32_t slots = self->cards.sensor_slots;
    uint32_t seal = (slots != 0U) ? seal_of_force(&self->force) : SEAL_START;
    for (uint32_t i = 0U; (slots >> i) != 0U; i++) {
        if (((slots >> i) & 1U) != 0U) {
            seal = seal_of_link(seal, &self->links[i]);
        }
    }
    return seal;
}

/* Members that one mode alone reads, and writes when it is begun, are under seal while it was begun
 * last. */
static uint32_t seal_of_mode(const mode_state_t *mode)
{
    const mode_request_t *const request = &mode->request;
    const uint32_t common =
        seal_of(SEAL_START, (const uint8_t *)&mode->sealed, WHOLE_WORDS(sizeof mode->sealed));
    const uint32_t seal =
        seal_of(common, (const uint8_t *)&request->sealed, WHOLE_WORDS(sizeof request->sealed));
    if (mode->sealed.kind >= MODE_KIND_COUNT) {
        return seal;
    }
    const uint8_t *const own = (const uint8_t *)&request->own;
    const mode_own_range_t *const range = &mode_own_ranges[mode->sealed.kind];
    return (range->bytes == 0U) ? seal : seal_of(seal, &own[range->from], range->bytes);
}

static uint32_t seal_of_pedal(uint32_t seal, const pedal_gate_t *pedal)
{
    return seal_of(
        seal_of(seal, (const uint8_t *)&pedal->sealed, WHOLE_WORDS(sizeof pedal->sealed)),
        (const uint8_t *)&pedal->chart, WHOLE_WORDS(PEDAL_GATE_CHART_BYTES));
}

static uint32_t seal_of_interlocks(const controller_t *self)
{
    uint32_t seal = seal_of_pedal(SEAL_START, &self->pedal);
    seal =
        seal_of(seal, (const uint8_t *)&self->loop.sealed, WHOLE_WORDS(sizeof self->loop.sealed));
    seal = seal_of(seal, (const uint8_t *)&self->confirm.sealed,
                   WHOLE_WORDS(sizeof self->confirm.sealed));
    seal = seal_of(seal, (const uint8_t *)&self->authority.sealed,
                   WHOLE_WORDS(sizeof self->authority.sealed));
    return seal_of(seal, (const uint8_t *)&self->procedure.arming, WHOLE_WORDS(ARMING_CHART_BYTES));
}

static uint32_t seal_of_rest(const controller_t *self)
{
    uint32_t seal =
        seal_of(SEAL_START, (const uint8_t *)&self->sealed, WHOLE_WORDS(sizeof self->sealed));
    if (self->sealed.awaited != 0U) {
        seal = seal_of(seal, (const uint8_t *)self->kept.sealed,
                       WHOLE_WORDS(sizeof self->kept.sealed));
    }
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        const axis_record_t *const record = &self->records[i];
        seal = seal_of(seal, (const uint8_t *)&record->sealed, WHOLE_WORDS(sizeof record->sealed));
    }
    return seal;
}

/* Charts without timers hold all of their state twice, and are not under seal. */
static inline uint32_t seal_of_axis(const axis_t *axis)
{
    const supervision_t *const supervision = &axis->supervision;
    uint32_t seal =
        seal_of(SEAL_START, (const uint8_t *)&axis->sealed, WHOLE_WORDS(sizeof axis->sealed));
    seal = seal_of(seal, (const uint8_t *)&supervision->sealed,
                   WHOLE_WORDS(sizeof supervision->sealed));
    return seal_of(seal, (const uint8_t *)&supervision->stall,
                   WHOLE_WORDS(STALL_WATCHDOG_CHART_BYTES));
}

static void compute(const controller_t *self, uint32_t seals[CONTROLLER_SECTIONS])
{
    seals[MODE] = seal_of_mode(&self->mode);
    seals[INTERLOCKS] = seal_of_interlocks(self);
    seals[REST] = seal_of_rest(self);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        seals[i] = seal_of_axis(&self->axes[i]);
        seals[CARDS + i] = seal_of_link(SEAL_START, controller_link(self, i));
    }
    seals[SENSORS] = seal_of_sensors(self);
}

void controller_seal(controller_t *self)
{
    compute(self, self->seals);
}

static void disable_all(controller_t *self)
{
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        axis_disable(&self->axes[i]);
    }
}

/* Positions kept from before the start may be among it: an axis that waits for its own is lost.
 * Counts go on, and so do the axes, which a table that is whole has named. */
static void forget_rest(controller_t *self)
{
    const controller_sealed_t damaged = self->sealed;
    (void)memset(&self->sealed, 0, sizeof self->sealed);
    (void)memset(&self->kept, 0, sizeof self->kept);
    (void)memset(self->records, 0, sizeof self->records);
    self->sealed.has_started = 1U;
    self->sealed.is_box_settled = 1U; /* It may have been: START_UP is not refused later. */
    self->sealed.axis_count = damaged.axis_count;
    self->sealed.cycle = damaged.cycle;
    self->sealed.time_us = damaged.time_us;
    self->sealed.sequence = damaged.sequence;
    self->sealed.events = damaged.events;
    self->sealed.events_lost = damaged.events_lost;
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        axis_forget(&self->axes[i]);
    }
    disable_all(self);
}

static void forget_interlocks(controller_t *self)
{
    self->pedal.sealed.is_released = 0U;
    pedal_gate_renew(&self->pedal);
    confirm_button_renew(&self->confirm);
    authority_init(&self->authority);
    disable_all(self);
}

static void forget_axis(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    controller_note(self, cycle, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_AXIS, (int32_t)index);
    axis_distrust(&self->axes[index]);
    plan_forget_target(&self->plan);
    controller_fail_order(self, cycle, EVENT_CAUSE_AXIS, index);
    controller_notify_order(self, cycle, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
}

/* The card of axis `index`. */
static void forget_card(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    controller_note(self, cycle, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_CARD, (int32_t)index);
    link_distrust(&self->links[self->cards.slots[index]],
                  (uint32_t)cycle->robot->axes[index].card_type, cycle->robot->card_firmware);
    controller_lose_card(self, cycle, index, CARD_LOSS_LOSES);
    controller_notify_order(self, cycle, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
}

/* The cards without an axis, and what they measure. An insertion by hand ends by the doubt in the
 * same cycle; nothing else that moves rests on them. */
static void forget_sensors(controller_t *self, const cycle_t *cycle)
{
    const uint32_t slots = self->cards.sensor_slots;
    const bool has_force = cycle->robot->force.is_there != 0U;
    force_sensor_init(&self->force, &cycle->robot->force);
    for (uint32_t i = 0U; has_force && (i < ROBOT_FORCE_CHANNELS); i++) {
        controller_note(self, cycle, EVENT_FORCE_DOUBTED, i, (int32_t)FORCE_DOUBT_NOT_ZEROED);
    }
    for (uint32_t i = 0U; (slots >> i) != 0U; i++) {
        if (((slots >> i) & 1U) != 0U) {
            link_distrust(&self->links[i], (uint32_t)CARD_TYPE_SENSOR, cycle->robot->card_firmware);
            controller_note(self, cycle, EVENT_CARD_LOST, i, (int32_t)LINK_CAUSE_MEMORY);
        }
    }
}

/* One of the sections of which there is one. */
static void forget_single(controller_t *self, uint32_t section)
{
    switch (section) {
    case MODE:
        (void)memset(&self->mode, 0, sizeof self->mode);
        break;
    case INTERLOCKS:
        forget_interlocks(self);
        break;
    case REST:
    default:
        forget_rest(self);
        break;
    }
}

static void forget(controller_t *self, const cycle_t *cycle, uint32_t section)
{
    static const event_memory_t names[] = {EVENT_MEMORY_PROFILE, EVENT_MEMORY_INTERLOCKS,
                                           EVENT_MEMORY_REST};
    controller_note(self, cycle, EVENT_MEMORY_DAMAGED, (uint32_t)names[section - MODE], 0);
    forget_single(self, section);
    controller_notify_order(self, cycle, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
}

/* It seals itself: another part that is forgotten would seal its damage. */
static void check_plan(controller_t *self, const cycle_t *cycle)
{
    if (plan_is_damaged(&self->plan)) {
        controller_note(self, cycle, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_PLAN, 0);
        if (!plan_forget(&self->plan)) {
            controller_note(self, cycle, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_PROBE, 0);
        }
        controller_notify_order(self, cycle, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
    }
}

/* The number of axes and the slots of the cards come from a table that is whole; a damaged one is
 * not read. */
static void take_axes(controller_t *self, const robot_t *robot, uint32_t damage)
{
    if (damage == 0U) {
        self->sealed.axis_count = robot->axis_count;
        robot_cards_find(&self->cards, robot, robot->axis_count);
        return;
    }
    if (self->sealed.axis_count > ROBOT_AXIS_MAX) {
        self->sealed.axis_count = ROBOT_AXIS_MAX;
    }
    robot_cards_bound(&self->cards);
}

static void check_table(controller_t *self, const cycle_t *cycle, uint32_t damage)
{
    if ((damage == 0U) || controller_is_table_invalid(self)) {
        return;
    }
    self->sealed.table_damage = damage;
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        axis_distrust(&self->axes[i]);
    }
    for (uint32_t i = 0U; i <= ROBOT_PART_GEOMETRY; i++) {
        if ((damage & ((uint32_t)1U << i)) != 0U) {
            controller_note(self, cycle, EVENT_ROBOT_TABLE_DAMAGED, i, 0);
        }
    }
    plan_forget_target(&self->plan);
    controller_notify_order(self, cycle, ARMING_EVENT_FAULT, STATUS_MEMORY_DAMAGED);
}

/* The rest first: it counts the events. */
static void check_state(controller_t *self, const cycle_t *cycle,
                        const uint32_t seals[CONTROLLER_SECTIONS])
{
    for (uint32_t i = CONTROLLER_SECTIONS; i > MODE; i--) {
        if (seals[i - 1U] != self->seals[i - 1U]) {
            forget(self, cycle, i - 1U);
        }
    }
    check_plan(self, cycle);
    if (seals[SENSORS] != self->seals[SENSORS]) {
        forget_sensors(self, cycle);
    }
    for (uint32_t i = self->sealed.axis_count; i > 0U; i--) {
        if (seals[CARDS + i - 1U] != self->seals[CARDS + i - 1U]) {
            forget_card(self, cycle, i - 1U);
        }
    }
    for (uint32_t i = self->sealed.axis_count; i > 0U; i--) {
        if (seals[i - 1U] != self->seals[i - 1U]) {
            forget_axis(self, cycle, i - 1U);
        }
    }
}

void controller_check_memory(controller_t *self, const cycle_t *cycle)
{
    uint32_t seals[CONTROLLER_SECTIONS];
    const uint32_t damage = robot_damage(cycle->robot);
    take_axes(self, cycle->robot, damage);
    compute(self, seals);
    check_state(self, cycle, seals);
    check_table(self, cycle, damage);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_memory.h"

#include "controller/controller_cards.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"

#include "base/seal.h"
#include "robot/robot_damage.h"

#include <stddef.h>
#include <string.h>

#define CARDS ROBOT_AXIS_MAX /* Of the axes, in their order. */
#define SENSORS (CARDS + ROBOT_AXIS_MAX)
#define MODE (SENSORS + 1U)
#define INTERLOCKS (MODE + 1U)
#define REST (INTERLOCKS + 1U)

typedef struct {
    size_t from;
    size_t to;
} range_t;

/* Charts without timers carry all of themselves twice; when and how one came to its state decides
 * nothing. */
static const range_t axis_range = {offsetof(axis_t, encoder),
                                   offsetof(axis_t, supervision.stall.now_us)};
/* A report, and that one came, decides only in its cycle. */
static const range_t link_range = {offsetof(link_t, sent), sizeof(link_t)};

static const range_t mode_range = {offsetof(controller_t, mode), offsetof(controller_t, axes)};
/* What one mode alone reads, and writes when it is begun: under seal while it was begun last. */
static const range_t own_ranges[MODE_KIND_COUNT] = {
    [MODE_VELOCITY] = {offsetof(controller_t, mode.request.velocity),
                       offsetof(controller_t, mode.request.sweep)},
    [MODE_SWEEP] = {offsetof(controller_t, mode.request.sweep), offsetof(controller_t, axes)},
};
/* Of the rest, what counts while positions wait to be compared. */
static const range_t awaited_range = {offsetof(controller_t, kept.axes),
                                      offsetof(controller_t, cause)};
/* What there is once. A section of several pieces is sealed in one go. */
typedef struct {
    uint32_t section;
    range_t range;
} piece_t;

static const piece_t pieces[] = {
    {MODE, {offsetof(controller_t, mode), offsetof(controller_t, mode.request.velocity)}},
    {INTERLOCKS, {offsetof(controller_t, pedal), offsetof(controller_t, pedal.chart.now_us)}},
    {INTERLOCKS, {offsetof(controller_t, loop.overruns), offsetof(controller_t, authority.chart)}},
    {INTERLOCKS,
     {offsetof(controller_t, procedure.arming), offsetof(controller_t, procedure.arming.now_us)}},
    {REST, {offsetof(controller_t, pending), offsetof(controller_t, kept.axes)}},
    {REST, {offsetof(controller_t, cause), offsetof(controller_t, seals)}},
};
/* Of the rest, what is more than a count, beside the records. */
static const range_t forgotten_range = {offsetof(controller_t, pending),
                                        offsetof(controller_t, has_started)};

/* What of a link decides in a cycle to come. */
static uint32_t seal_of_link(uint32_t seal, const link_t *link)
{
    const uint8_t *const bytes = (const uint8_t *)link;
    const uint32_t sum = seal_of_sixteen(seal, &bytes[link_range.from]);
    return seal_of(sum, &bytes[link_range.from + 64U], link_range.to - link_range.from - 64U);
}

static uint32_t seal_of_sensors(const controller_t *self)
{
    const uint32_t slots = self->cards.sensor_slots;
    uint32_t seal = SEAL_START;
    for (uint32_t i = 0U; (slots >> i) != 0U; i++) {
        if (((slots >> i) & 1U) != 0U) {
            seal = seal_of_link(seal, &self->links[i]);
        }
    }
    return seal;
}

static uint32_t seal_of_range(const controller_t *self, uint32_t seal, const range_t *range)
{
    const uint8_t *const bytes = (const uint8_t *)self;
    return seal_of(seal, &bytes[range->from], range->to - range->from);
}

/* What is sealed at times only. */
static void seal_more(const controller_t *self, uint32_t seals[CONTROLLER_SECTIONS])
{
    if (self->mode.kind < MODE_KIND_COUNT) {
        seals[MODE] = seal_of_range(self, seals[MODE], &own_ranges[self->mode.kind]);
    }
    if (self->awaited != 0U) {
        seals[REST] = seal_of_range(self, seals[REST], &awaited_range);
    }
}

static void compute(const controller_t *self, uint32_t seals[CONTROLLER_SECTIONS])
{
    for (uint32_t i = MODE; i < CONTROLLER_SECTIONS; i++) {
        seals[i] = SEAL_START;
    }
    for (uint32_t i = 0U; i < (sizeof(pieces) / sizeof(pieces[0])); i++) {
        uint32_t *const seal = &seals[pieces[i].section];
        *seal = seal_of_range(self, *seal, &pieces[i].range);
    }
    seal_more(self, seals);
    seals[REST] = seal_of(seals[REST], (const uint8_t *)self->records,
                          self->axis_count * sizeof self->records[0]);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        const uint8_t *const axis = (const uint8_t *)&self->axes[i];
        seals[i] = seal_of(SEAL_START, &axis[axis_range.from], axis_range.to - axis_range.from);
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
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        axis_disable(&self->axes[i]);
    }
}

static void clear(controller_t *self, const range_t *range)
{
    uint8_t *const bytes = (uint8_t *)self;
    (void)memset(&bytes[range->from], 0, range->to - range->from);
}

/* What was kept from before the start may be among it: an axis that waits for that is lost. */
static void forget_rest(controller_t *self)
{
    clear(self, &forgotten_range);
    (void)memset(self->records, 0, sizeof self->records);
    self->has_started = 1U;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        axis_forget(&self->axes[i]);
    }
    disable_all(self);
}

static void forget_interlocks(controller_t *self)
{
    self->pedal.is_released = 0U;
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
    controller_tell_order(self, cycle, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
}

/* The card of axis `index`. */
static void forget_card(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    controller_note(self, cycle, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_CARD, (int32_t)index);
    link_distrust(&self->links[self->cards.slots[index]],
                  (uint32_t)cycle->robot->axes[index].card_type, cycle->robot->card_firmware);
    controller_lose_card(self, cycle, index, false);
    controller_tell_order(self, cycle, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
}

/* The cards without an axis: nothing rests on them. */
static void forget_sensors(controller_t *self, const cycle_t *cycle)
{
    const uint32_t slots = self->cards.sensor_slots;
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
        clear(self, &mode_range);
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
    controller_tell_order(self, cycle, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
}

/* It seals itself: what else is forgotten would seal its damage. */
static void check_plan(controller_t *self, const cycle_t *cycle)
{
    if (plan_is_damaged(&self->plan)) {
        controller_note(self, cycle, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_PLAN, 0);
        if (!plan_forget(&self->plan)) {
            controller_note(self, cycle, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_PROBE, 0);
        }
        controller_tell_order(self, cycle, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
    }
}

/* How many axes there are, and where the cards, says a table that is whole; one that is not is not
 * asked. */
static void take_axes(controller_t *self, const robot_t *robot, uint32_t damage)
{
    if (damage == 0U) {
        self->axis_count = robot->axis_count;
        robot_cards_find(&self->cards, robot);
        return;
    }
    if (self->axis_count > ROBOT_AXIS_MAX) {
        self->axis_count = ROBOT_AXIS_MAX;
    }
    robot_cards_bound(&self->cards);
}

static void check_table(controller_t *self, const cycle_t *cycle, uint32_t damage)
{
    if ((damage == 0U) || controller_is_blind(self)) {
        return;
    }
    self->table_damage = damage;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        axis_distrust(&self->axes[i]);
    }
    for (uint32_t i = 0U; i <= ROBOT_PART_GEOMETRY; i++) {
        if ((damage & ((uint32_t)1U << i)) != 0U) {
            controller_note(self, cycle, EVENT_ROBOT_TABLE_DAMAGED, i, 0);
        }
    }
    plan_forget_target(&self->plan);
    controller_tell_order(self, cycle, ARMING_EVENT_FAULT, STATUS_MEMORY_DAMAGED);
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
    for (uint32_t i = self->axis_count; i > 0U; i--) {
        if (seals[CARDS + i - 1U] != self->seals[CARDS + i - 1U]) {
            forget_card(self, cycle, i - 1U);
        }
    }
    for (uint32_t i = self->axis_count; i > 0U; i--) {
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
    controller_because(self, EVENT_CAUSE_NONE, 0U);
    check_state(self, cycle, seals);
    check_table(self, cycle, damage);
}

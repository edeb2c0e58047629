/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/memory/controller_memory.h"

#include "controller/controller_cards.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"

#include "base/seal.h"
#include "robot/robot_damage.h"

#include <stddef.h>
#include <string.h>

#define CARDS ROBOT_AXIS_MAX /* Cards of the axes, in their order. */
#define SENSORS (CARDS + ROBOT_AXIS_MAX)
#define MODE (SENSORS + 1U)
#define INTERLOCKS (MODE + 1U)
#define REST (INTERLOCKS + 1U)

typedef struct {
    size_t from;
    size_t to;
} range_t;

static const range_t mode_range = {offsetof(controller_t, mode), offsetof(controller_t, axes)};
/* Part of the rest that is more than a count, beside the records. */
static const range_t forgotten_range = {offsetof(controller_t, pending),
                                        offsetof(controller_t, has_started)};

#define AXIS_BYTES (offsetof(axis_t, supervision.stall.now_us) - offsetof(axis_t, encoder))

#define LINK_BYTES (offsetof(controller_t, links[1]) - offsetof(controller_t, links[0].sent))

/* Sixteen words of a link and seven times as many of an axis are sealed straight on: no array where
 * they are more or less. */
typedef uint8_t axis_bytes_t[((AXIS_BYTES == 448U) && (LINK_BYTES == 64U)) ? 448 : -1];

/* Part of a link that decides in a cycle to come: a report, and that one came, decides only in its
 * cycle. */
static inline uint32_t seal_of_link(uint32_t seal, const link_t *link)
{
    const uint8_t *const bytes = (const uint8_t *)link;
    return seal_of_sixteen(seal, &bytes[offsetof(link_t, sent)]);
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

static inline uint32_t seal_between(const controller_t *self, uint32_t seal, size_t from, size_t to)
{
    const uint8_t *const bytes = (const uint8_t *)self;
    return seal_of(seal, &bytes[from], to - from);
}

/* Members that one mode alone reads, and writes when it is begun, are under seal while it was begun
 * last. */
static uint32_t seal_of_mode(const controller_t *self)
{
    const mode_own_t *const own = &self->mode.request.own;
    const uint32_t seal = seal_between(self, SEAL_START, offsetof(controller_t, mode),
                                       offsetof(controller_t, mode.request.own));
    if (self->mode.kind >= MODE_KIND_COUNT) {
        return seal;
    }
    const mode_own_range_t *const range = &mode_own_ranges[self->mode.kind];
    return (range->bytes == 0U) ? seal
                                : seal_of(seal, &((const uint8_t *)own)[range->from], range->bytes);
}

static uint32_t seal_of_interlocks(const controller_t *self)
{
    const uint32_t pedal = seal_between(self, SEAL_START, offsetof(controller_t, pedal),
                                        offsetof(controller_t, pedal.chart.now_us));
    const uint32_t authority = seal_between(self, pedal, offsetof(controller_t, loop.overruns),
                                            offsetof(controller_t, authority.chart));
    return seal_between(self, authority, offsetof(controller_t, procedure.arming),
                        offsetof(controller_t, procedure.arming.now_us));
}

static uint32_t seal_of_rest(const controller_t *self)
{
    const uint32_t pending = seal_between(self, SEAL_START, offsetof(controller_t, pending),
                                          offsetof(controller_t, kept.axes));
    uint32_t seal =
        seal_between(self, pending, offsetof(controller_t, awaited), offsetof(controller_t, seals));
    if (self->awaited != 0U) {
        seal = seal_between(self, seal, offsetof(controller_t, kept.axes),
                            offsetof(controller_t, awaited));
    }
    return seal_of(seal, (const uint8_t *)self->records,
                   self->axis_count * sizeof self->records[0]);
}

static inline uint32_t seal_of_bytes(const axis_bytes_t bytes)
{
    uint32_t seal = seal_of_sixteen(seal_of_sixteen(SEAL_START, bytes), &bytes[64]);
    seal = seal_of_sixteen(seal_of_sixteen(seal, &bytes[128]), &bytes[192]);
    seal = seal_of_sixteen(seal_of_sixteen(seal, &bytes[256]), &bytes[320]);
    return seal_of_sixteen(seal, &bytes[384]);
}

/* Charts without timers hold their state twice. The time and the path of an entry do not affect
 * later behaviour and are not sealed. */
static inline uint32_t seal_of_axis(const axis_t *axis)
{
    const uint8_t *const bytes = (const uint8_t *)axis;
    return seal_of_bytes(&bytes[offsetof(axis_t, encoder)]);
}

static void compute(const controller_t *self, uint32_t seals[CONTROLLER_SECTIONS])
{
    seals[MODE] = seal_of_mode(self);
    seals[INTERLOCKS] = seal_of_interlocks(self);
    seals[REST] = seal_of_rest(self);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
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
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        axis_disable(&self->axes[i]);
    }
}

static void clear(controller_t *self, const range_t *range)
{
    uint8_t *const bytes = (uint8_t *)self;
    (void)memset(&bytes[range->from], 0, range->to - range->from);
}

/* Positions kept from before the start may be among it: an axis that waits for its own is lost. */
static void forget_rest(controller_t *self)
{
    clear(self, &forgotten_range);
    (void)memset(self->records, 0, sizeof self->records);
    self->has_started = 1U;
    self->is_box_settled = 1U; /* It may have been: START_UP is not refused later. */
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
    controller_lose_card(self, cycle, index, CARD_LOSS_LOSES);
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

/* It seals itself: another part that is forgotten would seal its damage. */
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

/* The number of axes and the slots of the cards come from a table that is whole; a damaged one is
 * not read. */
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
    if ((damage == 0U) || controller_is_table_invalid(self)) {
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
    check_state(self, cycle, seals);
    check_table(self, cycle, damage);
}

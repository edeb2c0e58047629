/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/box.h"
#include "sim/orders/box_force_orders.h"
#include "sim/orders/box_needle_orders.h"
#include "sim/orders/box_number.h"
#include "sim/orders/box_reply.h"
#include "sim/orders/box_words.h"

#include <string.h>

/* Words of which any may be taken; `plug` takes any slot that no axis has, `force` any reading,
 * `push` any way in mm, `hand` and `grip` any speed, way, stiffness and force of a hand, `needle`
 * and `images` any number of their range. */
static const char orders[] =
    "pedal press|release|pulse\n"
    "pedal hold|drop WHO\n"
    "pedal a|b open|close\n"
    "estop pull|reset|pulse\n"
    "button press|release\n"
    "button hold|drop WHO\n"
    "keep WHO\n"
    "card SLOT silent|corrupt|foreign|deaf|noisy|warm|hot|low|high|normal\n"
    "plug 8|9 none|pwm|non_pwm|sensor|high_frequency|analog\n"
    "encoder SLOT stuck|reversed|half|normal\n"
    "motor SLOT stuck|half|twice|runs|hot|normal\n"
    "switch SLOT stuck|open|chatter|reversed|normal\n"
    "scanner on|off\n"
    "gate off|dose|stop\n"
    "force hand|needle 0|1780|1970|4095\n"
    "force hand|needle stuck|broken|full|step|drift|noisy|normal\n"
    "hand press|release\n"
    "hand hold|drop WHO\n"
    "hand speed 2000|-2000\n"
    "hand go 1000|-1000\n"
    "hand stiffness 200|1000|5000\n"
    "grip 3000|-3000\n"
    "tissue none|usual|whole|show\n"
    "needle curvature 0|4100\n"
    "needle torsion 0|45\n"
    "needle show\n"
    "images period 0|1000\n"
    "images delay 500\n"
    "images noise 0|500\n"
    "images tilt 0|500\n"
    "target none|usual\n"
    "probe coupled|free\n"
    "push 10|-10\n"
    "show\n";

const char *box_orders(void)
{
    return orders;
}

static bool is_slot(const char *word, uint32_t slot)
{
    const char number[2] = {(char)('0' + slot), '\0'};

    return strcmp(word, number) == 0;
}

static box_axis_t *find_axis(box_t *self, const char *word)
{
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const axis_config_t *config = self->axes[i].config;
        if ((strcmp(word, config->name) == 0) || is_slot(word, config->slot)) {
            return &self->axes[i];
        }
    }
    return NULL;
}

static box_sensor_t *find_sensor(box_t *self, const char *word)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (box_has_sensor(self, slot) && is_slot(word, slot)) {
            return &self->sensors[slot];
        }
    }
    return NULL;
}

/* Opens `contact` for a moment; then it is as it was. */
static void pulse(box_contact_t *contact)
{
    const bool was_closed = contact->is_closed;

    box_contact_set(contact, false, 0U);
    box_contact_set(contact, was_closed, BOX_PULSE_US);
}

static bool order_press(box_t *self, box_held_t what, const box_words_t *order)
{
    int64_t who = 0;
    const bool is_press = box_words_is(order, 1U, "press");

    if (order->count == 2U) {
        const bool is_known = is_press || box_words_is(order, 1U, "release");
        if (is_known) {
            box_press(self, what, is_press);
        }
        return is_known;
    }
    if (!box_words_take_number(order, &who)) {
        return false;
    }
    if (box_words_is(order, 1U, "drop")) {
        box_drop(self, what, (uint32_t)who);
        return true;
    }
    return box_hold(self, what, (uint32_t)who);
}

static bool order_keep(box_t *self, const box_words_t *order)
{
    int64_t who = 0;
    const bool is_good = box_words_take_number(order, &who);

    if (is_good) {
        box_keep(self, (uint32_t)who);
    }
    return is_good;
}

static bool order_pedal(box_t *self, const box_words_t *order)
{
    if ((order->count == 2U) && box_words_is(order, 1U, "pulse")) {
        pulse(&self->pedal_a);
        pulse(&self->pedal_b);
        return true;
    }
    if (order_press(self, BOX_HELD_PEDAL, order)) {
        return true;
    }
    const bool is_a = box_words_is(order, 1U, "a");
    const bool is_close = box_words_is(order, 2U, "close");
    if ((!is_a && !box_words_is(order, 1U, "b")) ||
        (!is_close && !box_words_is(order, 2U, "open"))) {
        return false;
    }
    box_contact_set(is_a ? &self->pedal_a : &self->pedal_b, is_close, 0U);
    return true;
}

static bool order_estop(box_t *self, const box_words_t *order)
{
    if (order->count != 2U) {
        return false;
    }
    if (box_words_is(order, 1U, "pulse")) {
        pulse(&self->estop);
        return true;
    }
    const bool is_pull = box_words_is(order, 1U, "pull");
    if (is_pull || box_words_is(order, 1U, "reset")) {
        box_contact_set(&self->estop, !is_pull, 0U);
        return true;
    }
    return false;
}

static bool order_level(bool *level, const box_words_t *order, const char *on, const char *off)
{
    const bool is_on = box_words_is(order, 1U, on);

    if ((order->count != 2U) || (!is_on && !box_words_is(order, 1U, off))) {
        return false;
    }
    *level = is_on;
    return true;
}

/* The words for the faults of the part of an axis that an order names. */
static const char *const *words_of(const box_words_t *order)
{
    const char *const *words = NULL;

    words = box_words_is(order, 0U, "card") ? box_card_words : words;
    words = box_words_is(order, 0U, "encoder") ? box_encoder_words : words;
    words = box_words_is(order, 0U, "motor") ? box_motor_words : words;
    return box_words_is(order, 0U, "switch") ? box_switch_words : words;
}

static bool order_axis(const box_words_t *order, box_axis_t *axis)
{
    const char *const *words = words_of(order);
    const int fault = box_words_find(words, order->words[2]);

    if (fault < 0) {
        return false;
    }
    if (words == box_card_words) {
        axis->card_fault = (box_card_fault_t)fault;
    } else if (words == box_encoder_words) {
        axis->encoder.fault = (sim_encoder_fault_t)fault;
    } else if (words == box_motor_words) {
        axis->motor.fault = (sim_motor_fault_t)fault;
    } else {
        axis->limit_switch.fault = (sim_switch_fault_t)fault;
    }
    return true;
}

/* It has nothing else that could fail. */
static bool order_sensor(const box_words_t *order, box_sensor_t *sensor)
{
    const int fault = box_words_find(box_card_words, order->words[2]);

    if (!box_words_is(order, 0U, "card") || (fault < 0)) {
        return false;
    }
    sensor->card_fault = (box_card_fault_t)fault;
    return true;
}

/* Coupled, it is where its axis is. */
static bool order_probe(box_t *self, const box_words_t *order)
{
    const bool is_done = order_level(&self->probe.is_free, order, "free", "coupled");

    if (is_done) {
        self->probe.free_ticks = 0.0;
        self->probe.to_go_ticks = 0.0;
    }
    return is_done;
}

static bool order_push(box_t *self, const box_words_t *order)
{
    int64_t mm = 0;

    if (!box_words_take_number(order, &mm)) {
        return false;
    }
    box_push(self, (double)mm);
    return true;
}

static bool order_gate(box_t *self, const box_words_t *order)
{
    const int level = box_words_find(box_gate_words, order->words[1]);

    if ((order->count != 2U) || (level < 0)) {
        return false;
    }
    self->gate = (box_gate_t)level;
    return true;
}

/* Only where no axis has its card. */
static bool order_plug(box_t *self, const box_words_t *order)
{
    const int type = box_words_find(box_type_words, order->words[2]);

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (is_slot(order->words[1], slot) && (type >= 0) &&
            (find_axis(self, order->words[1]) == NULL)) {
            box_plug(self, slot, (uint32_t)type);
            return true;
        }
    }
    return false;
}

/** @satisfies SWR-BOX-320 */
static void refuse(const box_words_t *order, const char *line, box_reply_t *reply)
{
    const box_number_t *number = box_words_number(order);
    int64_t read = 0;

    if ((number != NULL) && !box_number_read(number, order->words[order->count - 1U], &read)) {
        box_reply_say(reply, "The order \"%.60s\" takes a number from %lld to %lld%s", line,
                      (long long)number->least, (long long)number->most, number->unit);
    } else {
        box_reply_say(reply, "The order \"%.60s\" is unknown", line);
    }
    box_reply_say(reply, "; the orders are:\n%s", orders);
}

static bool carry_out(box_t *self, const box_words_t *order)
{
    if (box_words_is(order, 0U, "pedal")) {
        return order_pedal(self, order);
    }
    if (box_words_is(order, 0U, "estop")) {
        return order_estop(self, order);
    }
    if (box_words_is(order, 0U, "button")) {
        return order_press(self, BOX_HELD_BUTTON, order);
    }
    if (box_words_is(order, 0U, "keep")) {
        return order_keep(self, order);
    }
    if (box_words_is(order, 0U, "plug")) {
        return order_plug(self, order);
    }
    if (box_force_order_is(order)) {
        return box_force_order(self, order) ||
               (box_words_is(order, 0U, "hand") && order_press(self, BOX_HELD_HAND, order));
    }
    if (box_words_is(order, 0U, "probe")) {
        return order_probe(self, order);
    }
    if (box_words_is(order, 0U, "push")) {
        return order_push(self, order);
    }
    if (box_words_is(order, 0U, "gate")) {
        return order_gate(self, order);
    }
    if (box_words_is(order, 0U, "scanner")) {
        return order_level(&self->scanner_active, order, "on", "off");
    }
    return false;
}

/* Orders that only ask; false: it is none. */
static bool show(const box_t *self, const box_words_t *order, box_reply_t *reply)
{
    const bool is_about = (order->count == 2U) && box_words_is(order, 1U, "show");

    if ((order->count == 1U) && box_words_is(order, 0U, "show")) {
        box_reply_show(reply, self);
    } else if (is_about && box_words_is(order, 0U, "tissue")) {
        box_reply_tissue(reply, self);
    } else if (is_about && box_words_is(order, 0U, "needle")) {
        box_needle_reply(reply, self);
    } else {
        return false;
    }
    return true;
}

bool box_command(box_t *self, const char *order, char *reply, uint32_t reply_size)
{
    box_reply_t answer = {reply, reply_size, 0U};
    box_words_t words;

    if (!box_words_split(order, &words)) {
        words.count = 0U;
        refuse(&words, order, &answer);
        return false;
    }
    if (show(self, &words, &answer)) {
        return true;
    }
    bool is_done;
    if ((words_of(&words) != NULL) && (words.count == 3U)) {
        box_axis_t *axis = find_axis(self, words.words[1]);
        box_sensor_t *sensor = find_sensor(self, words.words[1]);
        if ((axis == NULL) && (sensor == NULL)) {
            box_reply_no_slot(&answer, self, words.words[1]);
            return false;
        }
        is_done = (axis != NULL) ? order_axis(&words, axis) : order_sensor(&words, sensor);
    } else {
        is_done = carry_out(self, &words);
    }
    if (!is_done) {
        refuse(&words, order, &answer);
        return false;
    }
    box_reply_say(&answer, "done: %s\n", order);
    return true;
}

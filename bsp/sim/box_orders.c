/* SPDX-License-Identifier: Apache-2.0 */
#include "box.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WORD_COUNT 3U
#define WORD_SIZE 16U
#define TURN_BAM 4294967296.0

typedef struct {
    char words[WORD_COUNT][WORD_SIZE];
    uint32_t count;
} order_t;

typedef struct {
    char *text;
    size_t size;
    size_t length;
} reply_t;

static const char orders[] = "pedal press|release\n"
                             "pedal a|b open|close\n"
                             "estop pull|reset\n"
                             "card SLOT silent|corrupt|normal\n"
                             "encoder SLOT stuck|reversed|normal\n"
                             "motor SLOT stuck|normal\n"
                             "scanner on|off\n"
                             "show\n";

const char *box_orders(void)
{
    return orders;
}

static void say(reply_t *reply, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void say(reply_t *reply, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    const int written =
        vsnprintf(reply->text + reply->length, reply->size - reply->length, format, arguments);
    va_end(arguments);
    if (written > 0) {
        reply->length += (size_t)written;
    }
    if (reply->length >= reply->size) {
        reply->length = reply->size - 1U;
    }
}

static bool is_space(char character)
{
    return (character == ' ') || (character == '\t') || (character == '\n') || (character == '\r');
}

/* False when there are more words than any order has, or a longer one. */
static bool split(const char *line, order_t *order)
{
    const char *at = line;

    (void)memset(order, 0, sizeof *order);
    for (;;) {
        while (is_space(*at)) {
            at++;
        }
        if (*at == '\0') {
            return true;
        }
        uint32_t length = 0U;
        while ((at[length] != '\0') && !is_space(at[length])) {
            length++;
        }
        if ((order->count == WORD_COUNT) || (length >= WORD_SIZE)) {
            return false;
        }
        (void)memcpy(order->words[order->count], at, length);
        order->count++;
        at += length;
    }
}

static bool is_word(const order_t *order, uint32_t index, const char *word)
{
    return strcmp(order->words[index], word) == 0;
}

static box_axis_t *find_axis(box_t *self, const char *word)
{
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const axis_config_t *config = self->axes[i].config;
        const char number[2] = {(char)('0' + config->slot), '\0'};
        if ((strcmp(word, config->name) == 0) || (strcmp(word, number) == 0)) {
            return &self->axes[i];
        }
    }
    return NULL;
}

static bool order_pedal(box_t *self, const order_t *order)
{
    if (order->count == 2U) {
        const bool is_press = is_word(order, 1U, "press");
        if (!is_press && !is_word(order, 1U, "release")) {
            return false;
        }
        box_contact_set(&self->pedal_a, is_press, is_press ? BOX_PEDAL_CLOSE_SPREAD_US : 0U);
        box_contact_set(&self->pedal_b, is_press, is_press ? 0U : BOX_PEDAL_OPEN_SPREAD_US);
        return true;
    }
    const bool is_a = is_word(order, 1U, "a");
    const bool is_close = is_word(order, 2U, "close");
    if ((!is_a && !is_word(order, 1U, "b")) || (!is_close && !is_word(order, 2U, "open"))) {
        return false;
    }
    box_contact_set(is_a ? &self->pedal_a : &self->pedal_b, is_close, 0U);
    return true;
}

static bool order_level(bool *level, const order_t *order, const char *on, const char *off)
{
    const bool is_on = is_word(order, 1U, on);

    if ((order->count != 2U) || (!is_on && !is_word(order, 1U, off))) {
        return false;
    }
    *level = is_on;
    return true;
}

static bool order_card(box_axis_t *axis, const char *word)
{
    if (strcmp(word, "silent") == 0) {
        axis->card_fault = BOX_CARD_SILENT;
    } else if (strcmp(word, "corrupt") == 0) {
        axis->card_fault = BOX_CARD_CORRUPT;
    } else if (strcmp(word, "normal") == 0) {
        axis->card_fault = BOX_CARD_NORMAL;
    } else {
        return false;
    }
    return true;
}

static bool order_encoder(box_axis_t *axis, const char *word)
{
    if (strcmp(word, "stuck") == 0) {
        axis->encoder.fault = SIM_ENCODER_STUCK;
    } else if (strcmp(word, "reversed") == 0) {
        axis->encoder.fault = SIM_ENCODER_REVERSED;
    } else if (strcmp(word, "normal") == 0) {
        axis->encoder.fault = SIM_ENCODER_NORMAL;
    } else {
        return false;
    }
    return true;
}

static bool order_motor(box_axis_t *axis, const char *word)
{
    const bool is_stuck = strcmp(word, "stuck") == 0;

    if (!is_stuck && (strcmp(word, "normal") != 0)) {
        return false;
    }
    axis->motor.is_blocked = is_stuck;
    return true;
}

static bool is_axis_order(const order_t *order)
{
    return is_word(order, 0U, "card") || is_word(order, 0U, "encoder") ||
           is_word(order, 0U, "motor");
}

static bool order_axis(const order_t *order, box_axis_t *axis)
{
    const char *word = order->words[2];

    if (is_word(order, 0U, "card")) {
        return order_card(axis, word);
    }
    return is_word(order, 0U, "encoder") ? order_encoder(axis, word) : order_motor(axis, word);
}

static const char *card_word(const box_axis_t *axis)
{
    static const char *const words[] = {"normal", "silent", "corrupt"};

    return words[axis->card_fault];
}

static const char *encoder_word(const box_axis_t *axis)
{
    static const char *const words[] = {"normal", "stuck", "reversed"};

    return words[axis->encoder.fault];
}

static void show_axis(const box_axis_t *axis, reply_t *reply)
{
    const bool is_mm = axis->config->unit == (uint8_t)AXIS_UNIT_MM;
    const double units =
        axis->motor.position_ticks * (double)axis->config->unit_per_tick_q16 / 65536.0;
    const double shown = is_mm ? units / 1e6 : units * 360.0 / TURN_BAM;
    const card_drive_t *drive = &axis->card.applied;
    char driven[24] = "off";

    if (drive->mode == (uint32_t)CARD_DRIVE_PWM) {
        (void)snprintf(driven, sizeof driven, "%c %u", (drive->direction != 0U) ? '+' : '-',
                       (unsigned)drive->duty);
    }
    if (drive->mode == (uint32_t)CARD_DRIVE_NON_PWM) {
        (void)snprintf(driven, sizeof driven, "%c run", (drive->direction != 0U) ? '+' : '-');
    }
    say(reply, "%4u  %-10s %11.4f %-3s %11.1f  %-9s %-7s %-8s %-9s %-7s %5u\n",
        (unsigned)axis->config->slot, axis->config->name, shown, is_mm ? "mm" : "deg",
        axis->motor.position_ticks, driven,
        (axis->config->limit_switch == (uint8_t)LIMIT_SWITCH_NONE) ? "none"
        : axis->limit_switch.is_active                             ? "active"
                                                                   : "free",
        card_word(axis), encoder_word(axis), axis->motor.is_blocked ? "stuck" : "normal",
        (unsigned)axis->card.watchdog_trips);
}

static void show(const box_t *self, reply_t *reply)
{
    say(reply, "%s, %.3f s: pedal a %s, pedal b %s, e-stop %s, scanner %s\n", self->robot->name,
        (double)self->time_us / 1e6, self->pedal_a.is_closed ? "closed" : "open",
        self->pedal_b.is_closed ? "closed" : "open", self->estop_open ? "pulled" : "closed",
        self->scanner_active ? "on" : "off");
    say(reply, "%4s  %-10s %11s %-3s %11s  %-9s %-7s %-8s %-9s %-7s %5s\n", "slot", "axis",
        "position", "", "ticks", "drive", "switch", "card", "encoder", "motor", "trips");
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        show_axis(&self->axes[i], reply);
    }
}

static void refuse(const char *line, reply_t *reply)
{
    say(reply, "The order \"%.60s\" is unknown; the orders are:\n%s", line, orders);
}

static void refuse_slot(const box_t *self, const char *word, reply_t *reply)
{
    say(reply, "There is no card in slot \"%s\"; there are", word);
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        say(reply, "%s %u %s", (i == 0U) ? "" : ",", (unsigned)self->axes[i].config->slot,
            self->axes[i].config->name);
    }
    say(reply, ".\n");
}

static bool carry_out(box_t *self, const order_t *order)
{
    if (is_word(order, 0U, "pedal")) {
        return order_pedal(self, order);
    }
    if (is_word(order, 0U, "estop")) {
        return order_level(&self->estop_open, order, "pull", "reset");
    }
    if (is_word(order, 0U, "scanner")) {
        return order_level(&self->scanner_active, order, "on", "off");
    }
    return false;
}

bool box_command(box_t *self, const char *order, char *reply, uint32_t reply_size)
{
    reply_t answer = {reply, reply_size, 0U};
    order_t words;

    if (!split(order, &words)) {
        refuse(order, &answer);
        return false;
    }
    if (is_word(&words, 0U, "show") && (words.count == 1U)) {
        show(self, &answer);
        return true;
    }
    bool is_done;
    if (is_axis_order(&words) && (words.count == 3U)) {
        box_axis_t *axis = find_axis(self, words.words[1]);
        if (axis == NULL) {
            refuse_slot(self, words.words[1], &answer);
            return false;
        }
        is_done = order_axis(&words, axis);
    } else {
        is_done = carry_out(self, &words);
    }
    if (!is_done) {
        refuse(order, &answer);
        return false;
    }
    say(&answer, "done: %s\n", order);
    return true;
}

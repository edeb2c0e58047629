/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/orders/box_reply.h"

#include <stdarg.h>
#include <stdio.h>

#define TURN_BAM 4294967296.0

/* In the order of the enumerations of these faults. */
const char *const box_card_words[] = {"normal", "silent", "corrupt", "foreign", "deaf", "noisy",
                                      "warm",   "hot",    "low",     "high",    NULL};
const char *const box_encoder_words[] = {"normal", "stuck", "reversed", "half", NULL};
const char *const box_motor_words[] = {"normal", "stuck", "half", "twice", "runs", "hot", NULL};
const char *const box_gate_words[] = {"off", "dose", "stop", NULL};
const char *const box_switch_words[] = {"normal", "stuck", "open", "chatter", "reversed", NULL};
const char *const box_load_cell_words[] = {"normal", "stuck", "broken", "full",
                                           "step",   "drift", "noisy",  NULL};

/* In the order of card_type_t. */
const char *const box_type_words[] = {"none",           "pwm",    "non_pwm", "sensor",
                                      "high_frequency", "analog", NULL};

void box_reply_say(box_reply_t *reply, const char *format, ...)
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

static void show_sensor(const box_sensor_t *sensor, box_reply_t *reply)
{
    box_reply_say(reply, "%4u  %-14s %7s %-3s %11s  %-9s %-7s %-8s %-9s %-7s %5u\n",
                  (unsigned)sensor->card.slot, box_type_words[sensor->card.card_type], "", "", "",
                  "", "", box_card_words[sensor->card_fault], "", "",
                  (unsigned)sensor->card.watchdog_trips);
}

static void show_axis(const box_axis_t *axis, box_reply_t *reply)
{
    const bool is_mm = axis->config->unit == (uint8_t)AXIS_UNIT_MM;
    const double units =
        axis->motor.position_ticks * (double)axis->config->unit_per_tick_q16 / 65536.0;
    const double shown = is_mm ? units / 1e6 : units * 360.0 / TURN_BAM;
    const card_drive_t *drive = &axis->card.applied;
    char driven[24] = "off";

    if ((drive->mode == (uint32_t)CARD_DRIVE_NON_PWM) && (drive->duty == 0U)) {
        (void)snprintf(driven, sizeof driven, "%c run", (drive->direction != 0U) ? '+' : '-');
    } else if (drive->mode != (uint32_t)CARD_DRIVE_OFF) {
        (void)snprintf(driven, sizeof driven, "%c %u", (drive->direction != 0U) ? '+' : '-',
                       (unsigned)drive->duty);
    } else {
        /* It is off. */
    }
    box_reply_say(reply, "%4u  %-10s %11.4f %-3s %11.1f  %-9s %-7s %-8s %-9s %-7s %5u\n",
                  (unsigned)axis->config->slot, axis->config->name, shown, is_mm ? "mm" : "deg",
                  axis->motor.position_ticks, driven,
                  (axis->config->limit_switch == (uint8_t)LIMIT_SWITCH_NONE) ? "none"
                  : axis->limit_switch.is_active                             ? "active"
                                                                             : "free",
                  box_card_words[axis->card_fault], box_encoder_words[axis->encoder.fault],
                  box_motor_words[axis->motor.fault], (unsigned)axis->card.watchdog_trips);
}

static void show_probe(const box_t *self, box_reply_t *reply)
{
    const axis_config_t *needle = &self->robot->axes[self->robot->needle_axis];
    const double nm = self->probe.free_ticks * (double)needle->unit_per_tick_q16 / 65536.0;

    box_reply_say(reply, "the probe is free of the %s, and %.4f mm in by hand\n", needle->name,
                  nm / 1e6);
}

void box_reply_tissue(box_reply_t *reply, const box_t *self)
{
    char text[SIM_PHANTOM_SIZE];

    sim_phantom_write(&self->force.phantom, text, sizeof text);
    box_reply_say(reply, "%s", text);
}

static void show_hand(const sim_hand_t *hand, box_reply_t *reply)
{
    switch (hand->act) {
    case SIM_HAND_PRESS:
        box_reply_say(reply, "hand presses with %.3f N", hand->press_n);
        break;
    case SIM_HAND_SPRING:
        box_reply_say(reply, "hand of %.3f N/mm wishes %.4f mm and %.3f mm/s, %.3f N",
                      hand->stiffness_n_per_mm, hand->wish_mm, hand->wish_mm_per_s, hand->force_n);
        break;
    case SIM_HAND_OFF:
    default:
        box_reply_say(reply, "hand off");
        break;
    }
}

static void show_force(const box_t *self, box_reply_t *reply)
{
    const box_force_t *const force = &self->force;

    show_hand(&force->hand, reply);
    box_reply_say(reply,
                  ", needle at %.4f mm: %.3f N, of it membrane %.3f, cutting %.3f, friction %.3f "
                  "N; %u of %u layers, %u ruptured\n",
                  force->tissue.depth_mm, force->tissue.force_n, force->tissue.membrane_n,
                  force->tissue.cutting_n, force->tissue.friction_n, (unsigned)force->tissue.next,
                  (unsigned)force->phantom.tissue.layer_count, (unsigned)force->tissue.popped);
    for (uint32_t i = 0U; i < SIM_CELLS; i++) {
        box_reply_say(reply, "load cell %s %s, reads %u\n", sim_cell_words[i],
                      box_load_cell_words[force->cells[i].fault],
                      (unsigned)force->cells[i].reading);
    }
}

/* Outputs that control has set. */
static void show_outputs(const box_t *self, box_reply_t *reply)
{
    static const char *const words[] = {"alive", "may-move", "moving", "fault"};

    box_reply_say(reply, "amplifier line %s, lamps", self->is_off ? "off" : "on");
    for (uint32_t i = 0U; i < sizeof words / sizeof words[0]; i++) {
        if ((self->lamps & (1U << i)) != 0U) {
            box_reply_say(reply, " %s", words[i]);
        }
    }
    box_reply_say(reply, "%s\n", (self->lamps == 0U) ? " dark" : "");
}

void box_reply_show(box_reply_t *reply, const box_t *self)
{
    box_reply_say(
        reply, "%s, %.3f s: pedal a %s, pedal b %s, e-stop %s, button %s, scanner %s, gate %s\n",
        self->robot->name, (double)self->time_us / 1e6, self->pedal_a.is_closed ? "closed" : "open",
        self->pedal_b.is_closed ? "closed" : "open", self->estop.is_closed ? "closed" : "pulled",
        self->button_pressed ? "pressed" : "released", self->scanner_active ? "on" : "off",
        box_gate_words[self->gate]);
    show_outputs(self, reply);
    box_reply_say(reply, "%4s  %-10s %11s %-3s %11s  %-9s %-7s %-8s %-9s %-7s %5s\n", "slot",
                  "axis", "position", "", "ticks", "drive", "switch", "card", "encoder", "motor",
                  "trips");
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        show_axis(&self->axes[i], reply);
    }
    if (self->probe.is_free) {
        show_probe(self, reply);
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (box_has_sensor(self, slot)) {
            show_sensor(&self->sensors[slot], reply);
        }
    }
    if (self->sensor_slots != 0U) {
        show_force(self, reply);
    }
}

void box_reply_no_slot(box_reply_t *reply, const box_t *self, const char *word)
{
    box_reply_say(reply, "There is no card in slot \"%s\"; there are", word);
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        box_reply_say(reply, "%s %u %s", (i == 0U) ? "" : ",", (unsigned)self->axes[i].config->slot,
                      self->axes[i].config->name);
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (box_has_sensor(self, slot)) {
            box_reply_say(reply, ", %u %s", (unsigned)slot,
                          box_type_words[self->sensors[slot].card.card_type]);
        }
    }
    box_reply_say(reply, ".\n");
}

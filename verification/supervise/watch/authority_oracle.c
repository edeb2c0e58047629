/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/authority_oracle.h"

#include "charts/arming_chart.h"
#include "charts/authority_chart.h"
#include "limits/requirement_limits.h"
#include "oracle/commanding.h"
#include "oracle/replies.h"

#include <stddef.h>

/* Authority in one cycle. */
typedef struct {
    const rig_t *rig;
    authority_party_t before;
    authority_party_t after;
    authority_party_t taken; /* The party that took it last; peer 0: none. */
    uint32_t losses;         /* Bits of authority_loss_t. */
    bool is_damaged;         /* Memory of it may have been forgotten. */
    bool is_armed;           /* An order was. */
    bool is_pressed;         /* The pedal was. */
} view_t;

static uint32_t rule(authority_oracle_rule_t which, bool is_broken)
{
    return is_broken ? ((uint32_t)1U << (uint32_t)which) : 0U;
}

static bool is_same(const authority_party_t *one, const authority_party_t *other)
{
    return (one->peer != 0U) && (one->source == other->source) && (one->peer == other->peer);
}

static authority_party_t sender_of(const command_t *command)
{
    const authority_party_t sender = {command->source, command->peer};
    return sender;
}

static void read_event(view_t *view, const event_t *event)
{
    switch (event->id) {
    case EVENT_AUTHORITY_TAKEN:
        view->taken = (authority_party_t){(uint32_t)event->value, event->subject};
        break;
    case EVENT_AUTHORITY_LOST:
        view->losses |= (uint32_t)1U << ((uint32_t)event->value % AUTHORITY_LOSSES);
        break;
    case EVENT_MEMORY_DAMAGED:
    case EVENT_CHART_REPAIRED:
        view->is_damaged = true;
        break;
    case EVENT_ORDER_ARMED:
        view->is_armed = true;
        break;
    case EVENT_PEDAL_PRESSED:
        view->is_pressed = true;
        break;
    default:
        break;
    }
}

static view_t view_of(const authority_oracle_t *self, const rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    view_t view = {.rig = rig, .before = self->holder};
    if (shown->authority == (uint32_t)AUTHORITY_STATE_HELD) {
        view.after = (authority_party_t){shown->holder, shown->holder_peer};
    }
    for (uint32_t i = 0U; i < rig->outputs.event_count; i++) {
        read_event(&view, &rig->outputs.events[i]);
    }
    return view;
}

static bool has_it(const view_t *view, const command_t *command)
{
    const authority_party_t sender = sender_of(command);
    return is_same(&sender, &view->before) || is_same(&sender, &view->after) ||
           is_same(&sender, &view->taken);
}

static bool is_usurped(const authority_oracle_t *self, const view_t *view)
{
    const bool is_handed_on = (view->before.peer != 0U) && (view->after.peer != 0U) &&
                              !is_same(&view->before, &view->after);
    const bool is_early =
        self->is_ending && !self->has_rested && (self->lost_us < LIMIT_AUTHORITY_END_US);
    bool is_by_another = false;
    for (uint32_t i = 0U; i < view->rig->inputs.command_count; i++) {
        const command_t *const command = &view->rig->inputs.commands[i];
        is_by_another =
            is_by_another || (commanding_needs_authority(command) &&
                              replies_accept(&view->rig->outputs, i) && !has_it(view, command));
    }
    return is_by_another || is_handed_on ||
           ((view->taken.peer != 0U) && ((view->before.peer != 0U) || is_early));
}

/* By who had it, or by its process for it. */
static bool is_given_up(const view_t *view)
{
    const authority_party_t *const holder =
        (view->before.peer != 0U) ? &view->before : &view->taken;
    bool is_any = false;
    for (uint32_t i = 0U; i < view->rig->inputs.command_count; i++) {
        const command_t *const command = &view->rig->inputs.commands[i];
        is_any = is_any || ((command->kind == (uint32_t)COMMAND_RELEASE) &&
                            (command->source == holder->source) &&
                            ((command->peer == 0U) || (command->peer == holder->peer)));
    }
    return is_any;
}

static bool is_lost_by(const view_t *view, authority_loss_t loss)
{
    return (view->losses & ((uint32_t)1U << (uint32_t)loss)) != 0U;
}

static bool is_lost_wrongly(const authority_oracle_t *self, const view_t *view)
{
    const uint32_t silent = view->rig->inputs.silent_sources >> (view->before.source % 32U);
    const bool is_gone = (view->before.peer != 0U) && (view->after.peer == 0U);
    return (is_gone && (view->losses == 0U) && !view->is_damaged) ||
           (is_lost_by(view, AUTHORITY_LOSS_RELEASED) && !is_given_up(view)) ||
           (is_lost_by(view, AUTHORITY_LOSS_UNRENEWED) && self->has_heard &&
            (self->silent_us < LIMIT_AUTHORITY_RENEW_US)) ||
           (is_lost_by(view, AUTHORITY_LOSS_SILENT) && ((silent & 1U) == 0U)) ||
           (is_lost_by(view, AUTHORITY_LOSS_TAKEN) &&
            ((self->pressed_us < LIMIT_CONFIRM_HOLD_US) || (self->asked.peer == 0U)));
}

static bool is_armed_wrongly(const view_t *view)
{
    const bool is_order = view->rig->outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE;
    bool is_by_holder = !view->is_armed;
    for (uint32_t i = 0U; i < view->rig->inputs.command_count; i++) {
        const answer_t *const answer = replies_to(&view->rig->outputs, i);
        is_by_holder = is_by_holder || ((answer != NULL) && (answer->is_final == 0U) &&
                                        has_it(view, &view->rig->inputs.commands[i]));
    }
    return !is_by_holder || (is_order && (view->after.peer == 0U));
}

/* Time for which the button was pressed, before the controller looks at it. */
static void watch_button(authority_oracle_t *self, const rig_t *rig)
{
    const controller_inputs_t *const inputs = &rig->inputs;
    const bool is_meant =
        (inputs->confirm_pressed != 0U) && (inputs->pedal_a == 0U) && (inputs->pedal_b == 0U);
    self->pressed_us = is_meant ? (self->pressed_us + inputs->elapsed_us) : 0U;
}

static void watch_requests(authority_oracle_t *self, const view_t *view)
{
    for (uint32_t i = 0U; i < view->rig->inputs.command_count; i++) {
        const command_t *const command = &view->rig->inputs.commands[i];
        const authority_party_t sender = sender_of(command);
        if (!replies_accept(&view->rig->outputs, i)) {
            continue;
        }
        if ((command->kind == (uint32_t)COMMAND_REQUEST) &&
            (command->as.request.request == (uint32_t)AUTHORITY_REQUEST_TAKE) &&
            !is_same(&sender, &view->before)) {
            self->asked = sender;
        }
        if (is_same(&sender, &view->after)) {
            self->silent_us = 0U;
            self->has_heard = true;
        }
    }
}

static bool is_unrenewed(const authority_oracle_t *self, const view_t *view)
{
    return is_same(&view->before, &view->after) &&
           (view->after.source == (uint32_t)COMMAND_SOURCE_HTTP) &&
           (self->silent_us > LIMIT_AUTHORITY_RENEW_US);
}

static bool are_at_rest(const rig_t *rig)
{
    bool is_every_one = true;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        is_every_one = is_every_one && (rig->outputs.snapshot.axes[i].speed_ticks_per_s_q8 == 0);
    }
    return is_every_one;
}

static void remember(authority_oracle_t *self, const view_t *view)
{
    const bool is_lost = (view->losses != 0U) || (view->is_damaged && (view->after.peer == 0U));
    self->is_ending = is_lost || (self->is_ending && (view->after.peer == 0U));
    self->lost_us = is_lost ? 0U : self->lost_us;
    self->losses_in_motion += (is_lost && self->was_moving) ? 1U : 0U;
    self->was_moving = view->rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_MOVING;
    self->is_armed_anew = (self->is_armed_anew || view->is_armed) && !is_lost;
    self->is_barred = is_lost || (self->is_barred && !(self->is_armed_anew && view->is_pressed));
    self->has_rested = self->has_rested && !is_lost;
    const bool is_new = !is_same(&view->before, &view->after);
    self->silent_us = is_new ? 0U : self->silent_us;
    self->has_heard = self->has_heard || (self->has_looked && is_new);
    self->holder = view->after;
    self->has_looked = true;
    for (uint32_t i = 0U; i < AUTHORITY_LOSSES; i++) {
        self->losses[i] += (view->losses >> i) & 1U;
    }
}

uint32_t authority_oracle_look(authority_oracle_t *self, const rig_t *rig)
{
    const view_t view = view_of(self, rig);
    uint32_t broken = 0U;
    self->lost_us += rig->inputs.elapsed_us;
    self->has_rested = self->has_rested || are_at_rest(rig);
    self->silent_us += rig->inputs.elapsed_us;
    watch_button(self, rig);
    watch_requests(self, &view);
    if (self->has_looked) {
        broken = rule(AUTHORITY_ONE, is_usurped(self, &view)) |
                 rule(AUTHORITY_LOST, is_lost_wrongly(self, &view)) |
                 rule(AUTHORITY_RENEWED, is_unrenewed(self, &view)) |
                 rule(AUTHORITY_ARMED, is_armed_wrongly(&view));
    }
    remember(self, &view);
    return broken | rule(AUTHORITY_AFTER, self->is_barred && rig_is_driving(rig));
}

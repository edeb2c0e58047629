/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/memory/controller_restore.h"

#include "controller/controller_facts.h"
#include "controller/controller_order.h"

#include "base/contract.h"
#include "base/fixed.h"

#include <string.h>

static const char contract_module[] = "controller";

/* Its counts are to be compared: a lost axis stays so whatever they say, and so does one with an
 * unknown grade. */
static bool is_awaited(const controller_t *self, uint32_t index)
{
    const uint32_t grade = self->kept.sealed[index].grade;
    return (self->sealed.kept_verdict == (uint32_t)KEPT_GOOD) &&
           ((grade == (uint32_t)KEPT_FRESH) || (grade == (uint32_t)KEPT_KNOWN));
}

void controller_restore(controller_t *self, const kept_positions_t *kept)
{
    REQUIRE(101U, self->sealed.has_started == 0U);
    self->sealed.power_on = kept->power_on;
    self->sealed.kept_verdict = kept->verdict;
    (void)memcpy(self->kept.sealed, kept->axes, sizeof self->kept.sealed);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        if (is_awaited(self, i)) {
            self->sealed.awaited++;
        } else if (kept->verdict != (uint32_t)KEPT_NOTHING) {
            axis_forget(&self->axes[i]);
        } else {
            /* No file was looked for. */
        }
    }
    controller_seal(self);
}

static void restore(controller_t *self, const cycle_t *cycle, uint32_t index,
                    int32_t position_ticks)
{
    if (self->kept.sealed[index].grade == (uint32_t)KEPT_KNOWN) {
        axis_restore(&self->axes[index], &cycle->robot->axes[index], position_ticks);
        controller_note(self, cycle, EVENT_AXIS_RESTORED, index, position_ticks);
    }
}

/* It was moved, or its counter was. */
static void contradict(controller_t *self, const cycle_t *cycle, uint32_t index,
                       int32_t position_ticks, int32_t way_ticks)
{
    axis_forget(&self->axes[index]);
    if (self->kept.sealed[index].grade == (uint32_t)KEPT_KNOWN) {
        axis_remember(&self->axes[index], position_ticks);
    }
    controller_note(self, cycle, EVENT_AXIS_CONTRADICTED, index, way_ticks);
}

static void compare(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const axis_t *const axis = &self->axes[index];
    const axis_config_t *const config = &cycle->robot->axes[index];
    const kept_axis_t *const kept = &self->kept.sealed[index];
    const int32_t way_ticks =
        encoder_way(config, kept->reading_ticks, axis->sealed.encoder.reading);
    const int64_t rest_ticks = (int64_t)supervision_rest_ticks(config);
    const int32_t position_ticks =
        fixed_saturate((int64_t)kept->position_ticks + (int64_t)way_ticks);
    if (((int64_t)way_ticks <= rest_ticks) && ((int64_t)way_ticks >= -rest_ticks)) {
        restore(self, cycle, index, position_ticks);
    } else {
        contradict(self, cycle, index, position_ticks, way_ticks);
    }
    self->kept.sealed[index].grade = (uint32_t)KEPT_LOST;
    self->sealed.awaited--;
}

void controller_compare(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    if (is_awaited(self, index) && (self->axes[index].sealed.encoder.has_reading != 0U)) {
        compare(self, cycle, index);
    }
}

/* An axis may have been left somewhat beyond its soft limits. */
static bool can_stand_at(const axis_config_t *config, int32_t ticks)
{
    const int64_t beyond = (int64_t)config->following_error_ticks + (int64_t)config->home_way_ticks;
    return ((int64_t)ticks >= ((int64_t)config->minimum_ticks - beyond)) &&
           ((int64_t)ticks <= ((int64_t)config->maximum_ticks + beyond));
}

static bool is_named(const command_positions_t *sent, uint32_t index)
{
    return ((sent->axes >> index) & 1U) != 0U;
}

static status_t judge_axes(const controller_t *self, const cycle_t *cycle,
                           const command_positions_t *sent, answer_t *answer)
{
    solution_t judged = {.status = STATUS_OK};
    for (uint32_t i = 0U; (i < self->sealed.axis_count) && (judged.status == STATUS_OK); i++) {
        judged.axis = (uint8_t)i;
        if (!is_named(sent, i)) {
            judged.status = STATUS_OK;
        } else if (!link_is_healthy_now(controller_link(self, i))) {
            judged.status = STATUS_HARDWARE_NOT_READY;
        } else if (!can_stand_at(&cycle->robot->axes[i], sent->ticks[i])) {
            judged.status = STATUS_OUT_OF_RANGE;
        } else {
            /* It can be. */
        }
    }
    controller_blame(answer, &judged);
    return judged.status;
}

static status_t judge_restore(const controller_t *self, const cycle_t *cycle,
                              const command_t *command, answer_t *answer)
{
    const command_positions_t *const sent = command_as_positions(command);
    status_t status = STATUS_UNKNOWN_COMMAND;
    if ((sent->axes == 0U) || ((sent->axes >> self->sealed.axis_count) != 0U)) {
        status = STATUS_UNKNOWN_COMMAND;
    } else if (!controller_is_of_workphase(self, command)) {
        status = STATUS_WRONG_WORKPHASE;
    } else if (!controller_is_at_rest(self)) {
        status = STATUS_NOT_AT_REST;
    } else {
        status = judge_axes(self, cycle, sent, answer);
    }
    return status;
}

status_t controller_obey_restore(controller_t *self, const cycle_t *cycle, const command_t *command,
                                 answer_t *answer)
{
    const status_t status = judge_restore(self, cycle, command, answer);
    if (status != STATUS_OK) {
        return status;
    }
    const command_positions_t *const sent = command_as_positions(command);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        if (is_named(sent, i)) {
            axis_place(&self->axes[i], &cycle->robot->axes[i], sent->ticks[i]);
            controller_note(self, cycle, EVENT_AXIS_PLACED, i, sent->ticks[i]);
        }
    }
    controller_renew_account(self);
    plan_forget_target(&self->plan);
    /* An operator who presses the button already has compared other positions. */
    confirm_button_renew(&self->confirm);
    return STATUS_OK;
}

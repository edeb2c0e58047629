/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/dialect/transform_proposals.h"

#include <stddef.h>
#include <string.h>

#define AHEAD_US ((LIMIT_IGTL_PROPOSAL_BURST - 1U) * LIMIT_IGTL_PROPOSAL_INTERVAL_US)

static const struct {
    char name[IGTL_NAME_SIZE];
    command_kind_t kind;
} subjects[TRANSFORM_SUBJECTS] = {{"REGISTRATION", COMMAND_PROPOSE_REGISTRATION},
                                  {"ENTRY_POINT", COMMAND_PROPOSE_ENTRY},
                                  {"TARGET_POINT", COMMAND_PROPOSE_TARGET}};

command_kind_t transform_proposals_kind(const char *name)
{
    for (uint32_t i = 0U; i < TRANSFORM_SUBJECTS; i++) {
        if (strcmp(subjects[i].name, name) == 0) {
            return subjects[i].kind;
        }
    }
    return COMMAND_NONE;
}

/* Place of what the command is of, TRANSFORM_SUBJECTS for another command. */
static uint32_t subject_of(const command_t *command)
{
    const bool is_withdrawal = command->kind == (uint32_t)COMMAND_WITHDRAW;
    const uint32_t proposal = is_withdrawal ? command->as.withdrawal.of : command->kind;
    uint32_t i = 0U;

    while ((i < TRANSFORM_SUBJECTS) && ((uint32_t)subjects[i].kind != proposal)) {
        i++;
    }
    return i;
}

const char *transform_proposals_name(const command_t *command)
{
    const uint32_t subject = subject_of(command);

    return (subject < TRANSFORM_SUBJECTS) ? subjects[subject].name : "";
}

void transform_proposals_put(transform_proposals_t *self, const command_t *command,
                             const igtl_moment_t *moment)
{
    const uint32_t subject = subject_of(command);
    transform_waiting_t *waiting;

    if (subject >= TRANSFORM_SUBJECTS) {
        return;
    }
    waiting = &self->waiting[subject];
    if (!waiting->is_waiting) {
        waiting->is_waiting = true;
        waiting->turn = self->next_turn;
        waiting->waits_since_us = moment->answer_clock_us;
        self->next_turn++;
    }
    waiting->command = *command;
}

/* The oldest, NULL for none. */
static transform_waiting_t *next_of(transform_proposals_t *self)
{
    transform_waiting_t *next = NULL;

    for (uint32_t i = 0U; i < TRANSFORM_SUBJECTS; i++) {
        transform_waiting_t *waiting = &self->waiting[i];

        if (waiting->is_waiting &&
            ((next == NULL) || ((int32_t)(waiting->turn - next->turn) < 0))) {
            next = waiting;
        }
    }
    return next;
}

static void mark_unlogged(command_t *command)
{
    if (command->kind == (uint32_t)COMMAND_WITHDRAW) {
        command->as.withdrawal.is_one_of_many = 1U;
    } else {
        command->as.seen_pose.is_one_of_many = 1U;
    }
}

static bool pass_one(transform_proposals_t *self, transform_waiting_t *waiting,
                     igtl_requests_t *requests, uint32_t peer, const igtl_moment_t *moment)
{
    const bool is_noted = moment->now_us >= self->next_note_us;
    command_t command = waiting->command;

    if (!is_noted) {
        mark_unlogged(&command);
    }
    if (igtl_requests_add(requests, peer, &command, moment->answer_clock_us) == NULL) {
        return false;
    }
    waiting->is_waiting = false;
    self->even_us = ((self->even_us > moment->now_us) ? self->even_us : moment->now_us) +
                    LIMIT_IGTL_PROPOSAL_INTERVAL_US;
    if (is_noted) {
        self->next_note_us = moment->now_us + LIMIT_IGTL_PROPOSAL_NOTE_US;
    }
    return true;
}

void transform_proposals_pass(transform_proposals_t *self, igtl_requests_t *requests, uint32_t peer,
                              const igtl_moment_t *moment)
{
    bool is_going_on = true;

    while (is_going_on && ((moment->now_us + AHEAD_US) >= self->even_us)) {
        transform_waiting_t *waiting = next_of(self);

        is_going_on = (waiting != NULL) && pass_one(self, waiting, requests, peer, moment);
    }
}

const char *transform_proposals_overdue(transform_proposals_t *self, const igtl_moment_t *moment)
{
    for (uint32_t i = 0U; i < TRANSFORM_SUBJECTS; i++) {
        transform_waiting_t *waiting = &self->waiting[i];

        if (waiting->is_waiting &&
            ((moment->answer_clock_us - waiting->waits_since_us) >= LIMIT_IGTL_PROPOSAL_WAIT_US)) {
            waiting->is_waiting = false;
            return subjects[i].name;
        }
    }
    return NULL;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "fuzz/world.h"

#include "fuzz/grammar.h"
#include "fuzz/sentence.h"
#include "fuzz/dialect_oracle.h"
#include "fuzz/words.h"
#include "robot/robot_neuro.h"
#include "procedure/command_kinds.h"

#include <string.h>

#define CYCLE_US 1000U
#define FIRST_ID 1000U /* The beginnings were made with ids below. */

/* Homing takes long: each beginning is made once and copied. */
static void make_beginning(rig_t *rig, uint32_t beginning)
{
    switch (beginning) {
    case FUZZ_BEGINNING_HOMED:
        rig_start_homed(rig);
        break;
    case FUZZ_BEGINNING_TARGETED:
        rig_start_targeted(rig);
        break;
    case FUZZ_BEGINNING_MOVING:
        rig_start_moving(rig);
        break;
    default:
        rig_start(rig);
        break;
    }
    rig_leave(rig); /* The connections command. */
}

/* Nothing may use it. */
static void clear_outbox(world_peer_t *peer)
{
    (void)memset(&peer->outbox, (int)(WORLD_NOTHING & 0xFFU), sizeof peer->outbox);
}

void world_begin(world_t *self, uint32_t beginning)
{
    static rig_t beginnings[FUZZ_BEGINNINGS];
    static bool is_made[FUZZ_BEGINNINGS];
    const uint32_t place = beginning % FUZZ_BEGINNINGS;

    if (!is_made[place]) {
        make_beginning(&beginnings[place], place);
        is_made[place] = true;
    }
    (void)memset(self, 0, sizeof *self);
    self->rig = beginnings[place];
    rig_forget(&self->rig);
    for (uint32_t i = 0U; i < WORLD_PEERS; i++) {
        clear_outbox(&self->peers[i]);
    }
    self->next_number = 1U;
    self->moment.now_us = 1000000U;
    self->moment.answer_clock_us = 1000000U;
    self->moment.timestamp = 1U;
    self->moment.snapshot = (place == FUZZ_BEGINNING_DARK) ? NULL : &self->rig.outputs.snapshot;
    workphase_dialect_init(&self->workphase, &robot_neuro, FIRST_ID);
    transform_dialect_init(&self->transform, &robot_neuro, FIRST_ID + 1U);
    dialect_oracle_begin(self);
}

static bool is_planner(const world_peer_t *peer)
{
    return peer->language == IGTL_LANGUAGE_CRTK;
}

void world_connect(world_t *self, uint32_t place, igtl_language_t language, uint32_t version)
{
    world_peer_t *peer = &self->peers[place];

    world_disconnect(self, place);
    *peer = (world_peer_t){.is_connected = true,
                           .number = self->next_number,
                           .version = version,
                           .language = language};
    self->next_number++;
    igtl_inbox_init(&peer->inbox);
    igtl_outbox_init(&peer->outbox);
    const igtl_introduction_t introduction = {peer->number, language, "ENTRY_", &peer->outbox};

    dialect_oracle_before(self);
    if (is_planner(peer)) {
        transform_dialect_connected(&self->transform, place, &introduction);
    } else {
        workphase_dialect_connected(&self->workphase, place, &introduction);
    }
    dialect_oracle_connected(self, place);
    dialect_oracle_after(self);
}

void world_disconnect(world_t *self, uint32_t place)
{
    world_peer_t *peer = &self->peers[place];

    if (!peer->is_connected) {
        return;
    }
    dialect_oracle_leaves(self, place);
    peer->is_connected = false;
    if (is_planner(peer)) {
        transform_dialect_disconnected(&self->transform, place);
    } else {
        workphase_dialect_disconnected(&self->workphase, place);
    }
    clear_outbox(peer);
}

static void hand_over(world_t *self, uint32_t place)
{
    world_peer_t *peer = &self->peers[place];
    const igtl_message_t *message = &peer->inbox.message;

    dialect_oracle_hears(self, place, message);
    if (is_planner(peer)) {
        transform_dialect_receive(&self->transform, place, message, &self->moment);
    } else {
        workphase_dialect_receive(&self->workphase, place, message, &self->moment);
    }
    dialect_oracle_after(self);
}

/* As igtl_connection.c does it: also of what is refused or skipped. */
static void hear_version(world_peer_t *peer)
{
    igtl_outbox_hear(&peer->outbox, peer->inbox.header.version);
    peer->has_spoken_2 = peer->has_spoken_2 || (peer->inbox.header.version == 2U);
}

void world_receive(world_t *self, uint32_t place, const uint8_t *bytes, uint32_t length)
{
    world_peer_t *peer = &self->peers[place];
    uint32_t at = 0U;

    while (peer->is_connected && (at < length)) {
        uint8_t *where;
        const uint32_t room = igtl_inbox_room(&peer->inbox, &where);
        const uint32_t count = (room < (length - at)) ? room : (length - at);

        (void)memcpy(where, &bytes[at], count);
        at += count;
        const igtl_inbox_event_t event =
            igtl_inbox_advance(&peer->inbox, count, self->moment.now_us);

        if (event != IGTL_INBOX_WAITING) {
            hear_version(peer);
        }
        switch (event) {
        case IGTL_INBOX_MESSAGE:
            hand_over(self, place);
            break;
        case IGTL_INBOX_BROKEN:
            world_disconnect(self, place);
            break;
        case IGTL_INBOX_WAITING:
        case IGTL_INBOX_SKIPPED:
        case IGTL_INBOX_REFUSED:
        default:
            break;
        }
    }
}

static void answer(world_t *self, const answer_t *said)
{
    dialect_oracle_before(self);
    if (!workphase_dialect_answer(&self->workphase, said, &self->moment)) {
        (void)transform_dialect_answer(&self->transform, said, &self->moment);
    }
    dialect_oracle_after(self);
}

static void refuse(world_t *self, const command_t *command)
{
    const answer_t refusal = {.id = command->id,
                              .source = command->source,
                              .command = command->kind,
                              .asked = (uint32_t)command_kinds_workphase(command),
                              .kind = (uint32_t)ANSWER_REFUSED,
                              .status = (uint32_t)STATUS_BUSY,
                              .is_final = 1U,
                              .workphase = self->rig.outputs.snapshot.workphase};

    answer(self, &refusal);
}

static bool is_taken(world_t *self, const command_t *command)
{
    const uint32_t places =
        command_kinds_is_stop(command) ? (WORLD_LANE + WORLD_STOPS) : WORLD_LANE;

    if ((self->moment.now_us < self->full_until_us) || (self->waiting >= places)) {
        return false;
    }
    self->lane[self->waiting] = *command;
    self->waiting++;
    dialect_oracle_passed(self, command);
    return true;
}

/* As igtl_main.c does it. */
static void pass(world_t *self, igtl_requests_t *requests)
{
    bool is_waiting = false;
    command_t command;

    for (uint32_t left = requests->queued; (left > 0U) && igtl_requests_take(requests, &command);
         left--) {
        if (!is_waiting && is_taken(self, &command)) {
            continue;
        }
        if (command_kinds_is_stop(&command)) {
            igtl_requests_keep(requests, &command);
            is_waiting = true;
        } else {
            refuse(self, &command);
        }
    }
}

static void advance(world_t *self)
{
    self->moment.now_us += CYCLE_US;
    self->moment.answer_clock_us += CYCLE_US;
    self->moment.timestamp += UINT64_C(4294967);
}

static void step(world_t *self)
{
    pass(self, &self->workphase.requests);
    pass(self, &self->transform.requests);
    dialect_oracle_before(self);
    workphase_dialect_step(&self->workphase, &self->moment);
    transform_dialect_step(&self->transform, &self->moment);
    dialect_oracle_after(self);
    dialect_oracle_stepped(self);
    for (uint32_t i = 0U; i < WORLD_PEERS; i++) {
        world_peer_t *peer = &self->peers[i];

        if (peer->is_connected && (peer->outbox.has_overflowed ||
                                   igtl_inbox_is_late(&peer->inbox, self->moment.now_us))) {
            world_disconnect(self, i);
        }
    }
}

/* A process without a task looks around now and then only. */
static bool is_turn(const world_t *self)
{
    return ((self->moment.now_us % WORLD_TURN_US) == 0U) ||
           (self->workphase.requests.queued > 0U) || (self->transform.requests.queued > 0U);
}

static void take_commands(world_t *self)
{
    uint32_t count = 0U;

    while ((count < CONTROLLER_COMMANDS) && (count < self->waiting)) {
        self->rig.commands[count] = self->lane[count];
        count++;
    }
    self->rig.command_count = count;
    self->waiting -= count;
    (void)memmove(&self->lane[0], &self->lane[count], self->waiting * sizeof self->lane[0]);
}

void world_wait(world_t *self, uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        take_commands(self);
        rig_cycle(&self->rig);
        SENTENCE(authority_oracle_look(&self->authority_oracle, &self->rig) == 0U,
                 "one commands, loses it rightly, and nothing moves after that");
        self->moment.snapshot = &self->rig.outputs.snapshot;
        self->silent_us = 0U;
        for (uint32_t k = 0U; k < self->rig.outputs.answer_count; k++) {
            answer(self, &self->rig.outputs.answers[k]);
        }
        advance(self);
        if (is_turn(self) || (self->rig.outputs.answer_count > 0U)) {
            step(self);
        }
    }
}

void world_wait_in_silence(world_t *self, uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        self->silent_us += CYCLE_US;
        if (self->silent_us >= WORLD_LOST_US) {
            self->silent_us = 0U;
            dialect_oracle_before(self);
            workphase_dialect_control_lost(&self->workphase, &self->moment);
            dialect_oracle_after(self);
        }
        advance(self);
        if (is_turn(self)) {
            step(self);
        }
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/competing_peers.h"

#include "charts/authority_chart.h"
#include "limits/requirement_limits.h"
#include "supervise/scenario/prng.h"

#define WAIT_CYCLES 1500U
#define RENEW_CYCLES 1000U
#define LONGEST_SLEEP_CYCLES (2U * (LIMIT_AUTHORITY_RENEW_US / LIMIT_CYCLE_US))
#define LONGEST_HANG_CYCLES 300U
#define PRESS_CYCLES ((LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 100U)

static const authority_party_t parties[] = {{(uint32_t)COMMAND_SOURCE_HTTP, RIG_PAGE},
                                            {(uint32_t)COMMAND_SOURCE_HTTP, 7U},
                                            {(uint32_t)COMMAND_SOURCE_IGTL, 21U},
                                            {(uint32_t)COMMAND_SOURCE_IGTL, 22U}};
#define PARTIES (sizeof parties / sizeof parties[0])

static void sign(const authority_party_t *party, command_t *command)
{
    command->source = party->source;
    command->peer = party->peer;
}

static const authority_party_t *anyone(competing_peers_t *self)
{
    return &parties[prng_below(&self->random, (uint32_t)PARTIES)];
}

static bool is_held(const rig_t *rig)
{
    return rig->outputs.snapshot.authority == (uint32_t)AUTHORITY_STATE_HELD;
}

static authority_party_t holder_of(const rig_t *rig)
{
    const authority_party_t holder = {rig->outputs.snapshot.holder,
                                      rig->outputs.snapshot.holder_peer};
    return holder;
}

void competing_peers_begin(competing_peers_t *self, rig_t *rig, uint32_t seed)
{
    *self = (competing_peers_t){.random = (seed * 2246822507U) | 1U};
    rig->is_page_away = true;
}

/* Commands that any peer may try. The process of a lost connection releases its authority. */
static command_t some_command(competing_peers_t *self)
{
    static const command_t tries[] = {
        {.kind = COMMAND_TAKE},
        {.kind = COMMAND_TAKE},
        {.kind = COMMAND_RENEW},
        {.kind = COMMAND_RELEASE},
        {.kind = COMMAND_REQUEST, .as.request = {.request = AUTHORITY_REQUEST_TAKE}},
        {.kind = COMMAND_REQUEST, .as.request = {.request = AUTHORITY_REQUEST_TAKE}},
        {.kind = COMMAND_REQUEST, .as.request = {.request = AUTHORITY_REQUEST_CONFIRM}},
        {.kind = COMMAND_WORKPHASE, .as.workphase = {.workphase = WORKPHASE_STOP}},
        {.kind = COMMAND_WORKPHASE, .as.workphase = {.workphase = WORKPHASE_TARGETING}},
        {.kind = COMMAND_WORKPHASE, .as.workphase = {.workphase = WORKPHASE_MOVE_TO_TARGET}},
        {.kind = COMMAND_RETRACT},
        {.kind = COMMAND_JOG}};
    command_t command =
        tries[prng_below(&self->random, (uint32_t)(sizeof tries / sizeof tries[0]))];
    sign(anyone(self), &command);
    if ((command.kind == (uint32_t)COMMAND_RELEASE) && (prng_below(&self->random, 4U) == 0U)) {
        command.peer = 0U;
    }
    return command;
}

/* A person who stands at the robot, and lets go of the pedal or not. */
static void press_button(competing_peers_t *self, rig_t *rig)
{
    if (prng_below(&self->random, 4U) != 0U) {
        rig_box(rig, "pedal release");
    }
    rig_box(rig, "button press");
    self->press_cycles = (PRESS_CYCLES / 2U) + prng_below(&self->random, PRESS_CYCLES);
}

static void count_down(competing_peers_t *self, rig_t *rig)
{
    self->asleep_cycles -= (self->asleep_cycles > 0U) ? 1U : 0U;
    if ((self->press_cycles > 0U) && (--self->press_cycles == 0U)) {
        rig_box(rig, "button release");
    }
    if ((self->hung_cycles > 0U) && (--self->hung_cycles == 0U)) {
        rig->silent_sources = 0U;
    }
}

bool competing_peers_play(competing_peers_t *self, rig_t *rig, command_t *command)
{
    count_down(self, rig);
    if (is_held(rig) && (rig->outputs.snapshot.holder == (uint32_t)COMMAND_SOURCE_HTTP) &&
        (self->asleep_cycles == 0U) && ((rig->controller.sealed.cycle % RENEW_CYCLES) == 0U)) {
        const authority_party_t holder = holder_of(rig);
        *command = (command_t){.kind = (uint32_t)COMMAND_RENEW};
        sign(&holder, command);
        return true;
    }
    if (self->wait_cycles > 0U) {
        self->wait_cycles--;
        return false;
    }
    self->wait_cycles = prng_below(&self->random, WAIT_CYCLES);
    switch (prng_below(&self->random, 24U)) {
    case 0:
    case 1:
    case 2:
        self->asleep_cycles = prng_below(&self->random, LONGEST_SLEEP_CYCLES);
        return false;
    case 3:
        rig->silent_sources = 1U + prng_below(&self->random, 3U);
        self->hung_cycles = 1U + prng_below(&self->random, LONGEST_HANG_CYCLES);
        return false;
    case 4:
    case 5:
    case 6:
        press_button(self, rig);
        return false;
    default:
        *command = some_command(self);
        return true;
    }
}

void competing_peers_sign(competing_peers_t *self, const rig_t *rig, command_t *command)
{
    const authority_party_t holder = holder_of(rig);
    const bool is_by_holder = is_held(rig) && (prng_below(&self->random, 8U) != 0U);
    sign(is_by_holder ? &holder : anyone(self), command);
}

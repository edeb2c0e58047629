/* SPDX-License-Identifier: Apache-2.0 */
/** @file Authority to command: the part of a cycle in which it is taken, lost and asked for. */
#ifndef BORESIGHT_CONTROLLER_AUTHORITY_H
#define BORESIGHT_CONTROLLER_AUTHORITY_H

#include "controller/controller_events.h"

#include <stdbool.h>

/**
 * Takes authority from a party that does not answer any more, and gives it to one that was granted
 * it.
 *
 * @satisfies SWR-AUTH-005
 * @satisfies SWR-AUTH-270
 * @satisfies SWR-AUTH-010
 */
void controller_observe_authority(controller_t *self, const cycle_t *cycle);

/**
 * The sender of `command` may send it now: it is everyone's, its sender has authority or may take
 * it by this command.
 *
 * @satisfies SWR-AUTH-003
 * @satisfies SWR-AUTH-004
 */
bool controller_has_authority(const controller_t *self, const command_t *command);

/**
 * `command` was accepted: its sender has given a sign of life, or takes what was free.
 *
 * @satisfies SWR-AUTH-002
 */
void controller_credit(controller_t *self, const cycle_t *cycle, const command_t *command);

/**
 * The sender takes free authority.
 *
 * @return STATUS_OK; STATUS_NO_AUTHORITY
 */
status_t controller_obey_take(controller_t *self, const cycle_t *cycle, const command_t *command,
                              answer_t *answer);

/** The sender keeps authority. @return STATUS_OK */
status_t controller_obey_renew(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer);

/** The sender gives up authority, and withdraws its request to the button. @return STATUS_OK */
status_t controller_obey_release(controller_t *self, const cycle_t *cycle, const command_t *command,
                                 answer_t *answer);

/**
 * The sender sets the meaning of the next press of the button.
 *
 * @return STATUS_OK; STATUS_NO_AUTHORITY; STATUS_BUSY while another one's request waits;
 * STATUS_UNKNOWN_COMMAND for a request of nothing; STATUS_NO_BUTTON for any where the box has none
 *
 * @satisfies SWR-AUTH-013
 */
status_t controller_obey_request(controller_t *self, const cycle_t *cycle, const command_t *command,
                                 answer_t *answer);

/**
 * The next press of the button means `request`, for the sender of `command`, which has a peer;
 * `axis` as authority_ask(). Asked again it waits no longer, and a press that has begun counts.
 *
 * @return STATUS_OK; STATUS_NO_BUTTON; STATUS_BUSY while another one's request waits
 */
status_t controller_ask_button(controller_t *self, const cycle_t *cycle, const command_t *command,
                               authority_request_t request, uint32_t axis);

/** A confirmation now is one of axis `index`: that of another axis alone is not asked for.
 *
 * @satisfies SWR-AXIS-039
 */
static inline bool controller_confirms_axis(const controller_t *self, uint32_t index)
{
    return (self->authority.sealed.request != (uint32_t)AUTHORITY_REQUEST_CONFIRM_AXIS) ||
           (self->authority.sealed.request_axis == index);
}

/** The press of the button that comes now is to give authority away. */
static inline bool controller_awaits_grant(const controller_t *self)
{
    return self->authority.sealed.request == (uint32_t)AUTHORITY_REQUEST_TAKE;
}

/**
 * The button was pressed for the party that asked for authority.
 *
 * @satisfies SWR-AUTH-008
 */
void controller_grant(controller_t *self, const cycle_t *cycle);

/**
 * The button means nothing by request any more.
 *
 * @satisfies SWR-AUTH-009
 */
void controller_end_request(controller_t *self);

#endif
